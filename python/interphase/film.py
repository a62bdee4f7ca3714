# SPDX-License-Identifier: GPL-3.0-or-later
"""A film of pictures, handed to ffmpeg one by one: no file of a frame is left."""

import contextlib
import os
import shutil
import subprocess
import tempfile

import numpy

from interphase.input_error import InputError

# By the end of the file's name. yuv420p is what browsers play, and wants even sizes.
KINDS = {
    ".mp4": ["-c:v", "libx264", "-pix_fmt", "yuv420p", "-crf", "20", "-movflags", "+faststart"],
    ".webp": ["-c:v", "libwebp_anim", "-lossless", "0", "-quality", "75", "-compression_level", "6", "-loop", "0"],
    ".gif": ["-filter_complex", "split[a][b];[a]palettegen=stats_mode=diff[p];[b][p]paletteuse=dither=none", "-loop", "0"],
}


def kind_of(path):
    """The end of the name, one of KINDS; InputError otherwise."""
    end = os.path.splitext(path)[1].lower()
    if end not in KINDS:
        raise InputError(f"{path}: a film ends in {', '.join(KINDS)}")
    return end


def program():
    """The path of ffmpeg; InputError with the remedy where it is missing."""
    found = shutil.which("ffmpeg")
    if found is None:
        raise InputError("ffmpeg is missing, which films need: tools/setup --no-build --with ffmpeg (on Debian also apt-get install ffmpeg)")
    return found


def pixels(figure, dpi):
    """A figure of matplotlib as [rows, columns, 3] bytes, even in both, white where a row or column had to be added."""
    figure.set_dpi(dpi)
    figure.canvas.draw()
    image = numpy.asarray(figure.canvas.buffer_rgba())[..., :3]
    return even(image)


def even(image):
    more = [(0, size % 2) for size in image.shape[:2]]
    return numpy.pad(image, [*more, (0, 0)], constant_values=255)


def write(path, frames, rate):
    """The film at `path` of `frames`, an iterator of images [rows, columns, 3] of one size, at `rate` frames a second. It is there whole or not
    at all. InputError where ffmpeg fails, with its words."""
    end, ffmpeg = kind_of(path), program()
    first = next(frames)
    rows, columns = first.shape[:2]
    part = os.path.join(os.path.dirname(path) or ".", f".{os.path.basename(path)}.part{end}")
    # Three digits: ffmpeg's own clock of a webp counts in ms.
    command = [ffmpeg, "-hide_banner", "-loglevel", "error", "-y", "-f", "rawvideo", "-pix_fmt", "rgb24", "-s", f"{columns}x{rows}",
               "-r", f"{rate:.9g}", "-i", "-", *KINDS[end], part]  # fmt: skip
    with tempfile.TemporaryFile() as words:
        with subprocess.Popen(command, stdin=subprocess.PIPE, stderr=words, stdout=words) as encoder:
            try:
                for image in _with(first, frames):
                    if image.shape != first.shape:
                        raise InputError(f"{path}: a frame of {image.shape[1]} x {image.shape[0]} pixels among those of {columns} x {rows}")
                    encoder.stdin.write(numpy.ascontiguousarray(image).tobytes())
            except BrokenPipeError:
                pass  # ffmpeg has ended, and said why
            except BaseException:
                encoder.kill()
                _remove(part)
                raise
            finally:
                with contextlib.suppress(BrokenPipeError):  # what is left of a frame has nowhere to go then
                    encoder.stdin.close()
            code = encoder.wait()
        if code:
            words.seek(0)
            _remove(part)
            raise InputError(f"{path}: ffmpeg failed with code {code}: {words.read().decode('utf-8', 'replace').strip()[-500:]}")
    os.replace(part, path)


def _with(first, others):
    yield first
    yield from others


def _remove(path):
    if os.path.exists(path):
        os.remove(path)
