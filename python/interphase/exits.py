# SPDX-License-Identifier: GPL-3.0-or-later
"""How a command of tools/ ends the program: the words on what went wrong, and the exit code."""

import sys
import traceback

from interphase import launch
from interphase.input_error import InputError


def after(main, tool, folder):
    """Ends with what main() returns. `folder`: whose folder it is, for a file that cannot be written.

    2: command line or case are refused; 1, or the program's own code: a step on the way failed; 130: Ctrl-C.
    """
    try:
        sys.exit(main())
    except InputError as refused:
        print(f"{tool}: error: {refused}", file=sys.stderr)
        sys.exit(2)
    except launch.StepFailed as failed:
        print(f"{tool}: error: {failed}", file=sys.stderr)
        sys.exit(failed.code)
    except OSError as error:
        print(f"{tool}: error: {error.filename or 'a file'}: {error.strerror}; the {folder} must be yours to write "
              "and have room: --out DIR takes another one", file=sys.stderr)
        sys.exit(1)
    except KeyboardInterrupt:
        print(f"{tool}: stopped", file=sys.stderr)
        sys.exit(130)


def of_drawing(main, tool):
    """Ends with 0 where main() has drawn; 1 where a run cannot be read or a picture not be written; 130: Ctrl-C."""
    try:
        main()
    except (InputError, OSError, KeyError) as error:
        print(f"{tool}: error: {error}", file=sys.stderr)
        sys.exit(1)
    except KeyboardInterrupt:
        print(f"{tool}: stopped", file=sys.stderr)
        sys.exit(130)


def with_verdict(main, tool, cannot):
    """Ends with the code that main(words of the command line) returns; a mistake of ours with `cannot`: it must not read as "different"."""
    try:
        sys.exit(main(sys.argv[1:]))
    except KeyboardInterrupt:
        sys.exit(130)
    except Exception:
        traceback.print_exc()
        print(f"{tool}: a mistake in {tool}, not in your files; nothing was concluded", file=sys.stderr)
        sys.exit(cannot)
