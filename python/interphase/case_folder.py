# SPDX-License-Identifier: GPL-3.0-or-later
"""A case folder: is it one, what do its dictionaries say, and a copy of it to run in."""

import fnmatch
import os
import re
import shutil
import stat

from interphase import foam_file, known_keys, methods
from interphase.foam_file import FoamFileError, nearest
from interphase.input_error import InputError

PARAMETERS = "parameters"
COUPLING = "system/couplingDict"
CONTROL = "system/controlDict"

# What a run leaves behind, and what runs of it have measured; not part of a case.
LEFT_BY_A_RUN = (
    "processor[0-9]*", "processors[0-9]*", "postProcessing", "dynamicCode", "log.*", "*.foam", "run.json", "__pycache__",
    "results.h5*", "particles.h5*", "particles.xdmf*", "snapshots", "bed.png", "report.png", "frames", "study",
)

def cases_in(folder):
    """Paths of the cases directly below `folder`, sorted."""
    try:
        names = sorted(os.listdir(folder))
    except OSError:
        return []
    paths = [os.path.join(folder, name) for name in names]
    return [p for p in paths if os.path.isfile(os.path.join(p, COUPLING))]


def listing(cases_folder):
    """A phrase that lists the cases below `cases_folder` as a user would type them."""
    cases = [os.path.relpath(p) for p in cases_in(cases_folder)]
    if not cases:
        return f"there are no cases in {os.path.relpath(cases_folder)}"
    return "cases here:\n  " + "\n  ".join(cases)


def checked_case(path, cases_folder):
    """The absolute path of the case at `path`; InputError that says what was looked for otherwise."""
    if not os.path.isdir(path):
        what = "is a file, not a case folder" if os.path.exists(path) else "no such folder"
        known = {os.path.basename(p): os.path.relpath(p) for p in cases_in(cases_folder)}
        name = os.path.basename(os.path.normpath(path))
        guess = nearest(name, known)
        hint = ""
        if guess.startswith("did you mean"):
            for short in sorted(known, key=len, reverse=True):
                guess = guess.replace(f"'{short}'", f"'{known[short]}'")
            hint = guess + " "
        raise InputError(f"{path}: {what}. {hint}{listing(cases_folder)}")
    for needed in (COUPLING, CONTROL):
        if not os.path.isfile(os.path.join(path, needed)):
            raise InputError(f"{path} is no case: there is no {needed} in it. {listing(cases_folder)}")
    return os.path.abspath(path)


class Dictionaries:
    """The dictionaries of a case as texts; changes are kept until they are written into a run's folder."""

    def __init__(self, folder):
        self.folder = folder
        self._texts = {}
        self._changed = set()

    def take(self, other):
        """The texts and changes of `other`, of the same case."""
        self._texts.update(other._texts)
        self._changed |= other._changed

    def has(self, file):
        """Whether the case has the file, by its path from the case folder on."""
        return file in self._texts or os.path.isfile(os.path.join(self.folder, file))

    def _files(self):
        found = []
        for base, folders, files in os.walk(self.folder):
            folders[:] = [f for f in folders if not any(fnmatch.fnmatch(f, p) for p in LEFT_BY_A_RUN)]
            found += [os.path.relpath(os.path.join(base, f), self.folder) for f in files]
        return sorted(found)

    def text(self, file):
        """The file as it is now, changes included; InputError with the nearest name where there is none."""
        if file not in self._texts:
            normal = os.path.normpath(file)
            if os.path.isabs(file) or normal.startswith(".."):
                raise InputError(f"'{file}' is not inside the case: name files from the case folder on")
            try:
                with open(os.path.join(self.folder, file), encoding="utf-8") as stream:
                    self._texts[file] = stream.read()
            except FileNotFoundError:
                raise InputError(f"the case has no file '{file}': {nearest(file, self._files())}") from None
            except (OSError, UnicodeDecodeError) as error:
                raise InputError(f"cannot read '{file}' of the case: {error}") from None
        return self._texts[file]

    def _source(self, file, path):
        """Where the value at (file, path) is written: macros are followed into `parameters`."""
        for _ in range(10):
            written = self._in_file(file, foam_file.value, path)
            macro = re.fullmatch(r"\$[:.]*(?:(\w+)|\{(\w+)\})", written or "")
            if not macro or not self.has(PARAMETERS):
                break
            name = macro[1] or macro[2]
            if self._in_file(PARAMETERS, foam_file.value, name) is None:
                break
            file, path = PARAMETERS, name
        return file, path

    def _in_file(self, file, function, *arguments):
        try:
            return function(self.text(file), *arguments)
        except FoamFileError as error:
            raise InputError(f"{os.path.join(os.path.relpath(self.folder), file)}: {error}") from None

    def value(self, file, path, default=None):
        """The value at `path`, `$name` looked up in `parameters`; `default` where there is none."""
        found = self._in_file(*self._with(foam_file.value, self._source(file, path)))
        return default if found is None else found

    def number(self, file, path, default=None):
        """The value at `path` as a number; `default` where there is none, or it is no number."""
        try:
            return float(self.value(file, path))
        except (TypeError, ValueError):
            return default

    @staticmethod
    def _with(function, source):
        return source[0], function, source[1]

    def set(self, file, path, value):
        """Replace the value written at `path` of `file`. What couplingDict does not mention and the program knows is added; InputError with
        the nearest names for everything else."""
        change = foam_file.replaced
        if file == COUPLING and not self._mentions(file, path):
            if path not in known_keys.of_coupling():
                self._refuse_unknown(file, path)
            change = foam_file.added
        self._texts[file] = self._in_file(file, change, path, value)
        self._changed.add(file)

    def _mentions(self, file, path):
        return self.has(file) and self._in_file(file, foam_file.holds, path)

    def _refuse_unknown(self, file, path):
        """Of couplingDict, where the names of the program are as good as those of the case."""
        guess = nearest(path, [*known_keys.of_coupling(), *self._in_file(file, foam_file.paths)])
        raise InputError(f"{os.path.join(os.path.relpath(self.folder), file)}: no entry '{path}', and none that the program knows: {guess}")

    def place_of(self, name):
        """(file, path) of `FILE:ENTRY`, or of `ENTRY`: one of `parameters`, or else one of couplingDict that the program knows."""
        file, colon, entry = name.partition(":")
        if colon:
            return os.path.normpath(file), entry
        if self._mentions(PARAMETERS, name):
            return PARAMETERS, name
        known = known_keys.of_coupling()
        if name in known or ("/" in name and self._mentions(COUPLING, name)):
            return COUPLING, name
        if "/" in name:
            self._refuse_unknown(COUPLING, name)
        return PARAMETERS, name

    def set_at_source(self, file, path, value):
        """Replace the value at `path`; where it is `$name`, the one in `parameters`, for all who use it."""
        self.set(*self._source(file, path), value)

    def append(self, file, text):
        """Add `text` at the end of `file`, which is made where there is none."""
        self._texts[file] = (self.text(file) if self.has(file) else "") + text
        self._changed.add(file)

    def write_into(self, folder):
        """Write the files that were changed into `folder`."""
        for file in sorted(self._changed):
            path = os.path.join(folder, file)
            os.makedirs(os.path.dirname(path), exist_ok=True)
            with open(path, "w", encoding="utf-8") as stream:
                stream.write(self._texts[file])


def plugins_of(case):
    """The plug-ins that the case names, as it writes them, a tuple."""
    return tuple(foam_file.unquoted(word) for word in re.findall(r'[^\s()"]+|"[^"]*"', case.value(COUPLING, "plugins", "()")))


def method_of(case, name=None):
    """The methods.Method `name`, as a user spells it (`dem`, `mp-pic`), or the case's own; InputError for one that there is not."""
    name = name or case.value(COUPLING, "method") or next(iter(methods.of_tree()))
    return methods.method(name, plugins_of(case), case.folder)


def checked_weight(text):
    """Real particles per tracked one, as a number >= 1; InputError otherwise."""
    try:
        weight = float(text)
    except ValueError:
        raise InputError(f"weight '{text}' is no number") from None
    if not 1 <= weight < float("inf"):
        raise InputError(f"weight {text}: a tracked sphere stands for at least 1 real particle, give W >= 1")
    return weight


def end_time(case):
    """endTime of controlDict [s]; None where it is no number."""
    return case.number(CONTROL, "endTime")


def set_method_and_weight(case, method=None, weight=None):
    """Write what the user chose into the case; returns (method, weight as a number), which agree.

    Where every particle is tracked (DEM, TDHS), W is 1; `--method DEM` alone says so too. The weight of a run with parcels that
    names none is the case's.
    """
    chosen = method_of(case, method)
    w = weight
    if w is None:
        w = "1" if method and chosen.of_particles else case.value(COUPLING, "weight", "1")
    number = checked_weight(w)
    if chosen.of_particles and number != 1:
        where = f"--weight {w}" if weight is not None else f"weight {w} of the case"
        raise InputError(f"{where} does not go with method {chosen.name}, which tracks every particle (W = 1): "
                         + (f"take --method {chosen.with_parcels} for parcels, or --weight 1" if chosen.with_parcels else "take --weight 1"))  # fmt: skip
    if chosen.collisions_of_plugin and (not plugins_of(case) or chosen.plugin in methods.plugins_of_tree() - set(plugins_of(case))):
        there = "names none" if not plugins_of(case) else f"does not name {chosen.plugin}"
        raise InputError(f"method {chosen.name} takes its collisions from a plug-in, and the case {there}: "
                         f"add `plugins ({chosen.plugin or 'NAME'});` to its {COUPLING}")  # fmt: skip
    if method:
        case.set_at_source(COUPLING, "method", chosen.name)
    if weight is not None or (method and chosen.of_particles and case.value(COUPLING, "weight") is not None):
        case.set_at_source(COUPLING, "weight", w)
    return chosen.name, number


def anchor_plugins(case):
    """Plug-ins that the case names by a path out of its folder (`../build/libmine.so`) get it absolute: the run's folder,
    where the program looks from, is another one."""
    written = case.value(COUPLING, "plugins")
    if written is None:
        return
    anchored = re.sub(r'"(\.\./[^"]*)"', lambda path: '"' + os.path.normpath(os.path.join(case.folder, path[1])) + '"', written)
    if anchored != written:
        case.set_at_source(COUPLING, "plugins", anchored)


def set_number_of_subdomains(case, ranks):
    """Write `ranks` into system/decomposeParDict, which OpenFOAM reads in every parallel run.

    The method is the case's. For `simple` and `hierarchical` the ranks are laid along the axis that the
    case cut most (x where it cut none); a split that gives `ranks` already, or is
    written with a macro, stays.
    """
    file = "system/decomposeParDict"
    if not case.has(file):
        case.append(file, (
            "FoamFile\n{\n    version 2.0;\n    format ascii;\n    class dictionary;\n    object decomposeParDict;\n}\n\n"
            f"numberOfSubdomains {ranks};\nmethod simple;\nsimpleCoeffs {{ n ({ranks} 1 1); delta 0.001; }}\n"
        ))
        return
    case.set(file, "numberOfSubdomains", str(ranks))
    method = case.value(file, "method")
    if method not in ("simple", "hierarchical"):
        return
    for coefficients in (f"{method}Coeffs", "coeffs"):
        written = case.value(file, f"{coefficients}/n")
        if written is None:
            continue
        if "$" in written:
            return  # the case computes its split from the number
        cuts = [int(n) for n in re.findall(r"\d+", written)]
        if len(cuts) == 3 and cuts[0] * cuts[1] * cuts[2] == ranks:
            return
        axis = cuts.index(max(cuts)) if len(cuts) == 3 else 0
        split = ["1", "1", "1"]
        split[axis] = str(ranks)
        case.set(file, f"{coefficients}/n", f"({' '.join(split)})")
        return
    case.append(file, f"\n{method}Coeffs {{ n ({ranks} 1 1); delta 0.001; order xyz; }}\n")


def copy(case_folder, run_folder):
    """Copy what belongs to the case, links followed, so that the run's folder stands alone. A case may be read-only; its copy
    is the user's to write."""
    try:
        shutil.copytree(case_folder, run_folder, dirs_exist_ok=True, ignore=shutil.ignore_patterns(*LEFT_BY_A_RUN))
    except shutil.Error as several:
        source, _, why = several.args[0][0]
        raise InputError(f"cannot copy {source} of the case: {why}; give yourself the right to read it") from None
    for base, folders, files in os.walk(run_folder):
        for name in (*folders, *files):
            _own(os.path.join(base, name))
    _own(run_folder)


def _own(path):
    """Its owner may read and write it, and enter it where it is a folder."""
    mode = os.stat(path).st_mode
    wanted = mode | stat.S_IRUSR | stat.S_IWUSR | (stat.S_IXUSR if stat.S_ISDIR(mode) else 0)
    if wanted != mode:
        os.chmod(path, wanted)
