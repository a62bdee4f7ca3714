#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""An entry that is added to a file in OpenFOAM syntax: it can be read back, it counts, and every other byte stays."""

import unittest

from interphase import foam_file, known_keys

TEXTS = ("", "a 1;", "a 1;\nmapping\n{\n    type kernel;\n}\nb 2;\n", "mapping { type kernel; }", "mapping {type kernel;}", "mapping\n{\n}\n",
         "mapping { type kernel; // not here }\n}\n", "mapping { type a; }\nmapping { type b; }\n", "mapping { $defaults }\n")  # fmt: skip


class Added(unittest.TestCase):
    def test_is_read_back_and_the_rest_stays(self):
        for text in TEXTS:
            with self.subTest(text):
                new = foam_file.added(text, "mapping/width", "0.01")
                self.assertEqual(foam_file.value(new, "mapping/width"), "0.01")
                left = list(new)
                for char in text:  # what was there is there, in its order
                    del left[: left.index(char) + 1]
                before = {path: foam_file.value(text, path) for path in foam_file.paths(text)}
                self.assertEqual({path: foam_file.value(new, path) for path in before}, before)

    def test_beside_the_entries_of_its_dictionary(self):
        text = "mapping\n{\n    type kernel;\n}\nb 2;\n"
        self.assertEqual(foam_file.added(text, "mapping/width", "0.01"), text.replace("kernel;\n", "kernel;\n    width 0.01;\n"))

    def test_not_below_a_value_nor_twice_nor_more_than_one(self):
        for text, value, words in (("mapping 3;", "1", "'mapping' is a value"), ("mapping { width 1; }", "2", "is there already"),
                                   ("", "1; b 2", "no single value")):  # fmt: skip
            with self.subTest(text), self.assertRaisesRegex(foam_file.FoamFileError, words):
                foam_file.added(text, "mapping/width", value)

    def test_the_keys_of_the_program(self):
        known = known_keys.of_coupling()
        for path in ("method", "drag/law", "mapping/width", "records/pressureTaps"):
            self.assertIn(path, known)
        self.assertEqual(known_keys.paths("# Keys\n- `a`: x.\n  `b` is not one.\n## c.d { }\n- `e`: y\n"), ("a", "c/d/e"))


if __name__ == "__main__":
    unittest.main()
