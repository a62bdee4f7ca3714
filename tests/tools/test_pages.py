# SPDX-License-Identifier: GPL-3.0-or-later
"""What the pages (*.md) name exists: every file, every link, every command with its options, its case, its settings, and the tests of
`tools/test --filter`. tests/program/test_pages.py runs the commands of the pages for users."""

import functools
import glob
import os
import re
import shlex
import subprocess
import unittest

from interphase import methods
from interphase.case_folder import Dictionaries
from interphase.input_error import InputError

SOURCE = os.environ.get("INTERPHASE_SOURCE") or os.path.realpath(os.path.join(os.path.dirname(__file__), "..", ".."))
ROOMS = ("cases", "coupler", "plugins", "python", "tests", "tools", "cmake")
COMMAND = re.compile(r"(?:tools|cases/[\w-]+)/[a-z-]+(?= |$)")


@functools.lru_cache(None)
def pages():
    """{name: text} of the pages of the tree."""
    names = subprocess.run(["git", "ls-files", "--cached", "--others", "--exclude-standard", "*.md"], cwd=SOURCE, capture_output=True, text=True, check=False).stdout.split()
    if not names:  # no repository: an unpacked archive
        names = [os.path.relpath(os.path.join(folder, file), SOURCE) for room in (".", *ROOMS) for folder, _, files in os.walk(os.path.join(SOURCE, room))
                 for file in files if file.endswith(".md") and (room != "." or folder == os.path.join(SOURCE, "."))]  # fmt: skip
    texts = {}
    for name in names:
        if os.path.isfile(os.path.join(SOURCE, name)):  # one that is being removed is still known to git
            with open(os.path.join(SOURCE, name), encoding="utf-8") as file:
                texts[os.path.normpath(name)] = file.read()
    return texts


def commands(text):
    """The commands of the tree's own that a page shows: in blocks, and in the text where they have an argument."""
    whole = re.sub(r"\\\n\s*", " ", text)
    lines = re.findall(r"^(?:    )?((?:tools|cases/[\w-]+)/[a-z-]+(?: .*)?)$", whole, re.M)
    spans = re.findall(r"`((?:tools|cases/[\w-]+)/[a-z-]+ [^`]+)`", whole)
    return [re.sub(r"\s+#.*$", "", each) for each in lines + spans]


@functools.lru_cache(None)
def options(program):
    """The options that a program's --help names, its subcommands' too."""
    told = subprocess.run([os.path.join(SOURCE, program), "--help"], capture_output=True, text=True, timeout=120, check=True).stdout
    parts = re.search(r"\{([\w,-]+)\}\s+\.\.\.", told)
    for part in parts[1].split(",") if parts else ():
        told += subprocess.run([os.path.join(SOURCE, program), part, "--help"], capture_output=True, text=True, timeout=120, check=True).stdout
    return set(re.findall(r"(?<![\w-])--?[a-zA-Z][\w-]*", told))


@functools.lru_cache(None)
def tests():
    """The names of the tests, as cmake/InterphaseTest.cmake makes them of the files."""
    files = glob.glob(os.path.join(SOURCE, "tests/**/*"), recursive=True)
    return [os.path.relpath(os.path.splitext(file)[0], os.path.join(SOURCE, "tests")) for file in files if re.search(r"/(test_\w+\.py|\w+_test\.cpp)$", file)]


def faults(command):
    """What is wrong with a command of a page."""
    words = shlex.split(command)
    if not os.access(os.path.join(SOURCE, words[0]), os.X_OK):
        return [f"no program {words[0]}"]
    found = [f"{words[0]} has no option {word}" for word in words[1:] if re.match(r"--?[a-zA-Z]", word) and word.partition("=")[0] not in options(words[0])]
    found += [f"no case {word}" for word in words[1:] if re.match(r"cases/", word) and not os.path.exists(os.path.join(SOURCE, word))]
    after = {word: following for word, following in zip(words, words[1:])}
    for method in after.get("--method", "DEM").split(","):
        if method not in methods.of_tree() and not re.fullmatch(r"[A-Z]|NAME", method):
            found.append(f"no method {method}")
    if words[0] == "tools/test" and after.get("--filter", "NAME") != "NAME" and not any(re.search(after["--filter"], test) for test in tests()):
        found.append(f"no test {after['--filter']}")
    case = next((word for word in words if re.fullmatch(r"cases/[\w-]+", word)), None)
    for option, setting in zip(words, words[1:]):
        if option == "--set" and case and words[0] in ("tools/run", "tools/sweep"):
            name, _, value = setting.partition("=")
            try:
                settings = Dictionaries(os.path.join(SOURCE, case))
                settings.set(*settings.place_of(name), value)  # in memory
            except InputError as error:
                found.append(str(error))
    return found


class Pages(unittest.TestCase):
    def test_every_command_is_one(self):
        seen = 0
        for name, text in pages().items():
            for command in commands(text):
                seen += 1
                with self.subTest(page=name, command=command):
                    self.assertEqual(faults(command), [])
        self.assertGreater(seen, 100)

    def test_the_check_sees_what_is_wrong(self):
        for command, words in (("tools/runs cases/sscp1", "no program"), ("tools/run cases/sscp1 --methods DEM", "no option --methods"),
                               ("tools/run cases/sscp2", "no case"), ("tools/run cases/sscp1 --method DEN", "no method DEN"),
                               ("tools/test --filter no_such_test", "no test"), ("tools/run cases/sscp1 --set inletVelocty=1", "inletVelocty"),
                               ("tools/bench recrods --untill 1", "no option --untill")):  # fmt: skip
            with self.subTest(command):
                self.assertIn(words, " ".join(faults(command)))

    def test_every_file_and_link_is_there(self):
        for name, text in pages().items():
            here = os.path.join(SOURCE, os.path.dirname(name))
            for link in re.findall(r"\]\((?!https?:)([^)#]+)[^)]*\)", text):
                with self.subTest(page=name, link=link):
                    self.assertTrue(os.path.exists(os.path.join(here, link)))
            for path in re.findall(rf"`((?:{'|'.join(ROOMS)})/[\w./-]+)`", text):
                if "templates" in name:
                    continue  # of the project that is made of it
                with self.subTest(page=name, path=path):
                    self.assertTrue(any(os.path.exists(os.path.join(SOURCE, path + ending)) for ending in ("", ".py", ".hpp", ".cpp", "_test.cpp", "_mpi_test.cpp")))

    def test_the_first_page_is_short(self):
        self.assertLess(pages()["README.md"].count("\n"), 120)
