# SPDX-License-Identifier: GPL-3.0-or-later
"""Files in OpenFOAM syntax: what is in them comes back whatever comments stand about it, and an entry that is replaced or added leaves every
other byte as it is."""

import glob
import os
import string
import tempfile
import unittest

from hypothesis import given, strategies as st

from interphase import foam_file, known_keys, parameters
from interphase.case import as_written
from interphase.input_error import InputError
from interphase.tree import CASES
import made_up  # noqa: F401  (how examples are drawn)


# Whole files are drawn: dictionaries in dictionaries of values, and anything that may stand between two words.
GAPS = st.one_of(st.sampled_from(("", " ", "\n", "\t", "\r\n", " // from a;b (c) {d}\n", "/* one */", "/**/", " /* two;\n lines { ( \" */ ", "//\n")),
                 st.text("{}()[];\"#$ab \n", max_size=8).map(lambda text: "/*" + text.replace("*/", "") + "*/"))  # fmt: skip
KEYS = st.one_of(st.from_regex(r"[A-Za-z_][A-Za-z0-9_.:]{0,5}(\([A-Za-z]{1,3}(,[A-Za-z]{1,3})?\))?", fullmatch=True),
                 st.text("Up_rgh|().*[]", min_size=1, max_size=8).map(lambda text: f'"{text}"'))  # fmt: skip
NUMBERS = st.one_of(st.integers().map(str), st.floats(allow_nan=False, allow_infinity=False).map(repr))
STRINGS = st.text(string.ascii_letters + string.digits + " ;{}()[]/*#$'.\n", max_size=12).map(lambda text: f'"{text}"')
WORDS = st.one_of(NUMBERS, STRINGS, st.sampled_from(("CGPM", "$method", "${mode}Inlet", "$:a.b", "uniform", "div(phi,U)", "#calc #{ 1; } #}")))
LISTS = st.recursive(WORDS.map(lambda word: [word]), lambda each: st.lists(each, max_size=4).map(
    lambda many: ["(", *(word for one in many for word in one), ")"]), max_leaves=6)  # fmt: skip
VALUES = st.lists(LISTS, min_size=1, max_size=2).map(lambda lists: [word for each in lists for word in each])
FILES = st.recursive(st.dictionaries(KEYS, VALUES, max_size=4), lambda below: st.dictionaries(KEYS, st.one_of(VALUES, below), max_size=4),
                     max_leaves=12)  # fmt: skip


def text_of(data, tree):
    """A file of the `tree` {key: words or another one}, with gaps as they are drawn."""
    def gap():
        return data.draw(GAPS)

    text = gap()
    for key, value in tree.items():
        if isinstance(value, dict):
            text += key + gap() + "{" + text_of(data, value) + "}" + gap()
        else:
            text += key + " " + gap() + "".join(word + " " + gap() for word in value) + ";" + gap()
    return text


def as_read(tree):
    """What `parameters.values_of` gives of the file of the tree: of keys that are the same but for quotes, the later one."""
    found = {}
    for key, value in tree.items():
        found[foam_file.unquoted(key)] = as_read(value) if isinstance(value, dict) else parameters.plain(" ".join(value))
    return found


def leaves(tree, above=""):
    """The paths of all values that count."""
    last = {foam_file.unquoted(key): key for key in tree}
    for key in last.values():
        yield from leaves(tree[key], f"{above}{key}/") if isinstance(tree[key], dict) else [above + key]


class WhateverStandsInThem(unittest.TestCase):
    @given(st.data(), FILES)
    def test_what_was_put_in_comes_out(self, data, tree):
        self.assertEqual(parameters.values_of(text_of(data, tree)), as_read(tree))

    @given(st.data(), FILES.filter(lambda tree: any(leaves(tree))), VALUES)
    def test_a_replacement_changes_its_value_only(self, data, tree, new):
        text, path, new = text_of(data, tree), data.draw(st.sampled_from(list(leaves(tree)))), " ".join(new)
        entry = foam_file.find(text, path)
        changed = foam_file.replaced(text, path, new)
        self.assertEqual(foam_file.value(changed, path), new)
        self.assertEqual(changed, text[: entry.start] + new + text[entry.end:])

    @given(st.data(), FILES, st.lists(st.from_regex(r"[a-z]{8}", fullmatch=True), min_size=1, max_size=3), VALUES)
    def test_what_is_added_is_read_back_and_the_rest_stays(self, data, tree, parts, new):
        text, new = text_of(data, tree), " ".join(new)
        folders = [path[: -len(key) - 1] for path in leaves(tree) for key in foam_file.split_path(path)[-1:]]
        path = "/".join(filter(None, [data.draw(st.sampled_from([*folders, ""])), *parts]))
        changed = foam_file.added(text, path, new)
        self.assertEqual(foam_file.value(changed, path), new)
        at = next(at for at in range(len(changed)) if changed[at : at + 1] != text[at : at + 1])
        self.assertEqual(changed[at + len(changed) - len(text):], text[at:])
        before = {each: foam_file.value(text, each) for each in foam_file.paths(text)}
        self.assertEqual({each: foam_file.value(changed, each) for each in before}, before)

    @given(st.recursive(st.floats(allow_nan=False), lambda each: st.lists(each, max_size=4).map(tuple), max_leaves=8))
    def test_numbers_and_lists_of_python_come_back_to_the_last_bit(self, value):
        self.assertEqual(parameters.numbers(parameters.values_of(f"a {as_written(value)};")["a"]), value)


class FoamFile(unittest.TestCase):
    TEXT = '''/* a comment with key 1; */
key   "a; string { with ( all";  // key 3;
#include "other; {"
div(phi,U)   Gauss linear;
value uniform (0 0 2.19);
nested { // { unbalanced in a comment
    key 1;
    deeper { key #calc #{ 1; } #}; key2 $key; }
    "(U|k).*" { tolerance 1e-6; }
    $macro;
    ${${mode}Ends}
}
list ( { key 5; } 3(1 2 3) );
dimensions [0 1 -1 0 0 0 0];
half #eval{ 0.5 * $key };
nested { key 2; }
'''

    def test_values(self):
        expected = {
            "key": '"a; string { with ( all"', "div(phi,U)": "Gauss linear", "value": "uniform (0 0 2.19)",
            "nested/key": "2", "nested/deeper/key": "#calc #{ 1; } #}", "nested/deeper/key2": "$key",
            'nested/"(U|k).*"/tolerance': "1e-6", "nested/(U|k).*/tolerance": "1e-6",
            "list": "( { key 5; } 3(1 2 3) )", "dimensions": "[0 1 -1 0 0 0 0]", "half": "#eval{ 0.5 * $key }",
        }
        for path, value in expected.items():
            with self.subTest(path):
                self.assertEqual(foam_file.value(self.TEXT, path), value)

    def test_a_replacement_changes_its_value_only(self):
        for path in ("key", "div(phi,U)", "nested/deeper/key", "nested/(U|k).*/tolerance", "half", "list"):
            with self.subTest(path):
                old = foam_file.value(self.TEXT, path)
                self.assertEqual(foam_file.replaced(self.TEXT, path, "7"), self.TEXT.replace(old, "7"))

    def test_the_later_of_two_counts_as_in_openfoam(self):
        self.assertTrue(foam_file.replaced(self.TEXT, "nested/key", "7").endswith("nested { key 7; }\n"))

    def test_values_that_are_none(self):
        for value in ("", "1; other 2", "{ a 1; }", "(1 2", '"open', "1 // hidden", "}", "#{ a"):
            with self.subTest(value), self.assertRaises(foam_file.FoamFileError):
                foam_file.replaced(self.TEXT, "value", value)

    def test_values_that_are(self):
        for value in ("1", "(0 0 1)", "uniform (0 0 3.28)", '"a; b"', "$velocity", "#eval{ 1 + 1 }", "table ((0 1) (1 2))"):
            with self.subTest(value):
                self.assertEqual(foam_file.value(foam_file.replaced(self.TEXT, "value", value), "value"), value)

    def test_missing_entries_name_the_level_and_the_nearest(self):
        with self.assertRaisesRegex(foam_file.FoamFileError, "no entry 'keey2' in 'nested/deeper': did you mean 'key2'"):
            foam_file.find(self.TEXT, "nested/deeper/keey2")
        with self.assertRaisesRegex(foam_file.FoamFileError, "'value' is a value"):
            foam_file.find(self.TEXT, "value/x")

    def test_broken_files_name_the_line(self):
        for text, message in (("a 1;\nb {\n", "line 2"), ("a 1;\n}\n", "line 2"), ("a 1\n", "line 1"), ("\n/* x", "line 2"),
                              ("a (1;\n", "line 1"), ("a (1];\n", "line 1")):
            with self.subTest(text), self.assertRaisesRegex(foam_file.FoamFileError, message):
                foam_file.parse(text)


class Added(unittest.TestCase):
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


class Values(unittest.TestCase):
    def test_lists_and_comments_over_lines(self):
        found = parameters.values_of("cells (15 1 45); /* was\n cells (30 2 90); */ a 1; // b 2;\nc ( 1\n 2 /* y */ 3 ) ; a 4;")
        self.assertEqual(found, {"cells": "(15 1 45)", "a": "4", "c": "(1 2 3)"})
        self.assertEqual(parameters.numbers(found["cells"]), (15.0, 1.0, 45.0))

    def test_dictionaries_within(self):
        self.assertEqual(parameters.values_of("drag { law BVK; } method DEM;"), {"drag": {"law": "BVK"}, "method": "DEM"})

    def test_numbers_lists_and_words(self):
        for text, value in (("8", 8.0), ("1e-3", 1e-3), ("((0 1) (2 3))", ((0.0, 1.0), (2.0, 3.0))), ("BVK", "BVK"), ("()", ()),
                            ("(U p)", ("U", "p")), ("uniform 3", "uniform 3"), ("(1 2", "(1 2")):  # fmt: skip
            with self.subTest(text):
                self.assertEqual(parameters.numbers(text), value)

    def test_those_of_all_cases(self):
        for path in glob.glob(os.path.join(CASES, "*", "parameters")):
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
