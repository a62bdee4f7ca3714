# SPDX-License-Identifier: GPL-3.0-or-later
"""results.h5 says which program made it from which inputs: /meta as `interphase -version` has it, and every text that the run
was started from, byte for byte, on any number of ranks."""

import hashlib
import os
import re
import subprocess

import h5py

import support

INPUTS = ("0/U", "0/p_rgh", "constant/g", "constant/transportProperties", "dem/in.liggghts", "dem/scene.liggghts", "dem/CGPM.liggghts",
          "parameters", "system/blockMeshDict", "system/controlDict", "system/couplingDict", "system/fvSchemes", "system/fvSolution")  # fmt: skip


def version():
    """What the program says of itself, without a case, a launcher, or an environment of OpenFOAM."""
    return subprocess.run([support.PROGRAM, "-version"], env={"PATH": os.environ["PATH"]}, capture_output=True, text=True, check=True,
                          timeout=60).stdout  # fmt: skip


class Provenance(support.ProgramTest):
    def test_of_the_program(self):
        self.assertRegex(version(), r"\Ainterphase \d+\.\d+\.\d+, commit ([0-9a-f]{40}( with uncommitted changes)?|unknown)\n"
                         r"built by \S+ [\d.]+, \w+: .*\nengines: LIGGGHTS \d\S*, OpenFOAM \d+\n\Z")  # fmt: skip

    def test_usage(self):
        """Names every option that the program takes beside OpenFOAM's."""
        for option in ("--help", "-h"):
            said = subprocess.run([support.PROGRAM, option], env={"PATH": os.environ["PATH"]}, capture_output=True, text=True, timeout=60)
            self.assertEqual((said.returncode, said.stderr), (0, ""))
            for name in ("-case", "-parallel", "-resume", "-overwrite", "-wallLimit", "-help keys", "-help counts", "-version"):
                self.assertIn(name, said.stdout)

    def test_of_results(self):
        for ranks in (1, 2):
            with self.subTest(ranks=ranks):
                folder = self.prepared("sscp1", f"on{ranks}", ranks, until=0.001, particleCount=8000, initialPacking=0.3)
                with self.run_case(folder, ranks).results() as file:
                    self.check_program(file["/meta"].attrs)
                    self.check_inputs(file["/meta/inputs"], folder)

    def check_program(self, meta):
        said = {name: meta[name] for name in ("version", "commit", "uncommitted_changes", "compiler", "compiler_flags",
                                                               "build_type", "versions")}  # fmt: skip
        changed = " with uncommitted changes" if said["uncommitted_changes"] == "yes" else ""
        expected = (f"interphase {said['version']}, commit {said['commit']}{changed}\n"
                    f"built by {said['compiler']}, {said['build_type']}: {said['compiler_flags']}\n")  # fmt: skip
        self.assertTrue(version().startswith(expected), f"{version()}\nis not\n{expected}")
        self.assertRegex(said["versions"], rf"^interphase {re.escape(said['version'])}, LIGGGHTS\S* \S+, OpenFOAM \d+$")

    def check_inputs(self, inputs, folder):
        found = {}
        inputs.visititems(lambda name, item: found.update({name: item} if isinstance(item, h5py.Dataset) else {}))
        for name in INPUTS:
            self.assertIn(name, found)
        self.assertIn("dem/bed.data", found)
        for name, item in found.items():
            with open(os.path.join(folder, name), "rb") as stream:
                content = stream.read()
            self.assertEqual(item.attrs["bytes"], len(content), name)
            self.assertEqual(item.attrs["sha256"], hashlib.sha256(content).hexdigest(), name)
            if item.attrs["kept"] == "yes":
                self.assertEqual(item[()], content, name)
            else:
                self.assertNotIn(name, INPUTS)
