# SPDX-License-Identifier: GPL-3.0-or-later
"""Read, replace and add single entries of a file in OpenFOAM syntax, leaving every other byte as it is.

OpenFOAM's own `foamDictionary` rewrites the whole file: comments and layout go, `$macros` and
`#include` are expanded. A run's copy of a case should still look like the case, so entries are
replaced here by their place in the text.

An entry is named by its path, nested by `/`: `drag/law`, `solvers/"(U|k)"/tolerance`. The quotes of a
pattern may be left out. Where a dictionary holds a key twice, the later one counts, as in OpenFOAM.
"""

import difflib

from interphase.foam_syntax import Dictionary, Entry, FoamFileError, line_of, parse, tokens, unquoted  # noqa: F401  (callers name them by this module)


def split_path(path):
    """`a/"b/c"/d` -> [`a`, `"b/c"`, `d`]."""
    parts, part, quoted = [], "", False
    for char in path:
        quoted ^= char == '"'
        if char == "/" and not quoted:
            parts.append(part)
            part = ""
        else:
            part += char
    parts.append(part)
    if quoted or not all(parts):
        raise FoamFileError(f"'{path}' is no name of an entry (names nested by '/')")
    return parts


def nearest(name, valid):
    """What a user may have meant by `name`: a phrase to append to a message, never empty.

    The near ones when there are any, else all (at most 40).
    """
    valid = list(dict.fromkeys(valid))
    by_lower = {v.lower(): v for v in reversed(valid)}
    close = [by_lower[n] for n in difflib.get_close_matches(name.lower(), by_lower, n=3, cutoff=0.55)]
    if close:
        return "did you mean " + " or ".join(f"'{c}'" for c in close) + "?"
    if not valid:
        return "there are no entries"
    more = f" ... ({len(valid) - 40} more)" if len(valid) > 40 else ""
    return "valid names: " + ", ".join(valid[:40]) + more


def _find_all(dictionary, parts):
    """Everything at this path, what counts first."""
    found = dictionary.all_named(parts[0])
    if len(parts) == 1:
        return found
    below = [e for e in found if isinstance(e, Dictionary)]
    return [hit for d in below for hit in _find_all(d, parts[1:])]


def _explain_missing(root, parts):
    """Why nothing is at this path, with the nearest names at the level where it breaks off."""
    level = [root]
    for depth, part in enumerate(parts):
        found = [e for d in level for e in d.all_named(part)]
        above = "/".join(parts[:depth])
        if not found:
            names = [unquoted(n) for d in level for n in d.names()]
            inside = f" in '{above}'" if above else ""
            return f"no entry '{part}'{inside}: {nearest(part, names)}"
        level = [e for e in found if isinstance(e, Dictionary)]
        if not level:
            return f"'{'/'.join(parts[: depth + 1])}' is a value, it holds no entry '{'/'.join(parts[depth + 1:])}'"
    raise AssertionError("nothing is missing")


def find(text, path):
    """The Entry or Dictionary at `path`; FoamFileError that names the nearest ones otherwise."""
    root = parse(text)
    parts = split_path(path)
    found = _find_all(root, parts)
    if not found:
        raise FoamFileError(_explain_missing(root, parts))
    return found[0]


def holds(text, path):
    """Whether there is an entry or a dictionary at `path`."""
    return bool(_find_all(parse(text), split_path(path)))


def paths(text):
    """The paths of all values, nested by `/`, in the order of the text; macros and included files apart."""
    def below(dictionary, above):
        for entry in dictionary.entries:
            if isinstance(entry, Dictionary):
                yield from below(entry, f"{above}{entry.key}/")
            elif not entry.key.startswith("$"):
                yield above + entry.key
    return list(dict.fromkeys(below(parse(text), "")))


def value(text, path, default=None):
    """The value at `path` as it is written, or `default` where there is none."""
    found = _find_all(parse(text), split_path(path))
    return found[0].value if found and isinstance(found[0], Entry) else default


def check_value(new_value):
    """FoamFileError unless `new_value` can stand as the one value of an entry."""
    try:
        written = parse(f"key {new_value};").entries
    except FoamFileError:
        raise FoamFileError(f"'{new_value}' is no single value") from None
    one = len(written) == 1 and isinstance(written[0], Entry) and written[0].key == "key"
    if not one or not written[0].value or written[0].value != new_value.strip():
        raise FoamFileError(f"'{new_value}' is no single value")


def replaced(text, path, new_value):
    """`text` with the value at `path` replaced; comments and layout stay."""
    entry = find(text, path)
    if isinstance(entry, Dictionary):
        names = ", ".join(entry.names())
        raise FoamFileError(f"'{path}' is a dictionary; set one of its entries: {names}")
    check_value(new_value)
    gap = " " if entry.start == entry.end else ""
    return text[: entry.start] + gap + new_value.strip() + text[entry.end :]


def added(text, path, new_value):
    """`text` with an entry at `path` that is not there yet, behind those that are, in the dictionaries that are there and new ones
    where there are none; comments and layout stay."""
    check_value(new_value)
    level, parts = parse(text), split_path(path)
    if _find_all(level, parts):
        raise FoamFileError(f"'{path}' is there already")
    depth = 0
    while depth < len(parts) - 1 and (found := level.all_named(parts[depth])):
        if not isinstance(found[0], Dictionary):
            raise FoamFileError(_explain_missing(level, parts[depth:]))
        level, depth = found[0], depth + 1
    new = f"{parts[-1]} {new_value.strip()};"
    for name in reversed(parts[depth:-1]):
        new = f"{name} {{ {new} }}"
    if level.close is None:
        return text + ("" if text.endswith("\n") or not text else "\n") + new + "\n"
    line = text.rfind("\n", 0, level.close) + 1
    if text[line : level.close].strip():  # the dictionary closes on the line of its last entry
        gap = "" if text[level.close - 1].isspace() else " "
        return text[: level.close] + gap + new + " " + text[level.close :]
    return text[:line] + text[line : level.close] + "    " + new + "\n" + text[line:]
