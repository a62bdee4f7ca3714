#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Values of `parameters` come back as they are written: numbers, words and lists, whatever comments stand about and within them."""

import glob
import os
import random
import tempfile
import unittest

from interphase import parameters
from interphase.input_error import InputError

REPOSITORY = os.path.dirname(os.path.dirname(os.path.dirname(os.path.realpath(__file__))))

COMMENTS = ("", " ", "\n", "\t", " // from a;b (c) {d}\n", "/* one */", " /* two;\n lines { ( */ ", "\n\n")
WORDS = ("CGPM", "$method", "1e-3", "-2.5", "0", "(15 1 45)", "((0 0 0.04) (0 0 0.35))", '"dem/in.liggghts"', "uniform (0 0 2.19)", "()")


class Values(unittest.TestCase):
    def test_lists_and_comments_over_lines(self):
        found = parameters.values_of("cells (15 1 45); /* was\n cells (30 2 90); */ a 1; // b 2;\nc ( 1\n 2 /* y */ 3 ) ; a 4;")
        self.assertEqual(found, {"cells": "(15 1 45)", "a": "4", "c": "(1 2 3)"})
        self.assertEqual(parameters.numbers(found["cells"]), (15.0, 1.0, 45.0))

    def test_whatever_stands_between_words(self):
        """Files put together at random, by a fixed seed: what was put in comes out."""
        draw = random.Random(14)
        for _ in range(500):
            put, text = {}, ""
            for name in draw.sample([f"key{i}" for i in range(20)], draw.randrange(6)):
                put[name] = draw.choice(WORDS)
                inside = put[name].replace(" ", " " + draw.choice(COMMENTS) + " ") if '"' not in put[name] else put[name]
                text += f"{draw.choice(COMMENTS)}{name} {draw.choice(COMMENTS)}{inside}{draw.choice(COMMENTS)};"
            with self.subTest(text):
                self.assertEqual(parameters.values_of(text + draw.choice(COMMENTS)), put)

    def test_dictionaries_within(self):
        self.assertEqual(parameters.values_of("drag { law BVK; } method DEM;"), {"drag": {"law": "BVK"}, "method": "DEM"})

    def test_numbers_lists_and_words(self):
        for text, value in (("8", 8.0), ("1e-3", 1e-3), ("((0 1) (2 3))", ((0.0, 1.0), (2.0, 3.0))), ("BVK", "BVK"), ("()", ()),
                            ("(U p)", ("U", "p")), ("uniform 3", "uniform 3"), ("(1 2", "(1 2")):  # fmt: skip
            with self.subTest(text):
                self.assertEqual(parameters.numbers(text), value)

    def test_those_of_all_cases(self):
        for path in glob.glob(os.path.join(REPOSITORY, "cases", "*", "parameters")):
            with self.subTest(path):
                found = parameters.read(path)
                self.assertGreater(parameters.numbers(found["particleDensity"]), 0)
                self.assertFalse([value for value in found.values() if "/*" in value or "//" in value or "\n" in value])

    def test_a_file_that_is_none_is_named_with_its_line(self):
        with tempfile.NamedTemporaryFile("w", suffix="parameters") as file:
            file.write("a 1;\nb 2\n")
            file.flush()
            with self.assertRaisesRegex(InputError, f"{file.name}: line 2: entry 'b' does not end with ';'"):
                parameters.read(file.name)
        with self.assertRaisesRegex(InputError, "nowhere/parameters: cannot be read: No such file"):
            parameters.read("nowhere/parameters")


if __name__ == "__main__":
    unittest.main()
