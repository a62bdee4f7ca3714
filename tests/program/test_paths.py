# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
"""Cases as people have them: where the mesh, the script and the parts lie, what folders are called and who owns them. Each works,
or the message says what to do."""

import os
import re
import shutil
import subprocess

import gas_box
import support

COLLATED = "OptimisationSwitches { fileHandler collated; }\n"


class Paths(support.ProgramTest):
    def setUp(self):
        super().setUp()
        self.case = os.path.join(self.root, "box")

    def run_tool(self, *given):
        return support.tool("run", self.case, "--out", os.path.join(self.root, "out"), "--no-picture", *given)

    def stopped(self, done, expected):
        self.assertIn(done.code, (1, 4, 5), done.text)  # refused, by LIGGGHTS, by OpenFOAM
        self.assertEqual(done.text.count("remedy:"), 1, done.text)
        self.assertRegex(done.text, f"(?s)interphase: error: .*{expected}")


class Mesh(Paths):
    def test_dictionary_in_its_old_place(self):
        gas_box.write(self.case, end=0.001, mesh=False)
        os.makedirs(os.path.join(self.case, "constant/polyMesh"))
        shutil.move(os.path.join(self.case, "system/blockMeshDict"), os.path.join(self.case, "constant/polyMesh/blockMeshDict"))
        done = self.run_tool()
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("mesh: of constant/polyMesh/blockMeshDict, by blockMesh", done.stdout)

    def test_a_refined_mesh_beside_its_dictionary(self):
        """It is run on, not on what blockMesh would make: 8 x 8 x 16 cells, not 4 x 4 x 8."""
        gas_box.write(self.case, end=0.001, cells="8 8 16")
        self.edit(self.case, "system/blockMeshDict", "8 8 16", "4 4 8")
        done = self.run_tool()
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, "mesh: constant/polyMesh of the case, as it is; system/blockMeshDict.* is not looked at")
        owner = support.read(self.root, "out/constant/polyMesh/owner")
        self.assertEqual(re.search(r"nCells: ?(\d+)", owner)[1], "1024")

    def test_none(self):
        gas_box.write(self.case, mesh=False)
        self.stopped(support.execute(self.case), "no mesh.*constant/polyMesh.*blockMesh")

    def test_none_of_the_parts(self):
        gas_box.write(self.case)
        support.must(self.case, "decomposePar")
        for part in ("processor0", "processor1"):
            shutil.rmtree(os.path.join(self.case, part, "constant"))
        self.stopped(support.execute(self.case, 2), "no mesh.*processor.*decomposePar")


class AsItIsInTheTree(Paths):
    """A case that nobody has made ready: what it lacks, and the way out, at each stage of doing it by hand."""

    def test_sscp1_without_mesh_without_particles_without_parts(self):
        shutil.copytree(os.path.join(support.SOURCE, "cases/sscp1"), self.case)
        ready = f"tools/run {re.escape(os.path.realpath(self.case))}.*prepare.*blockMesh.*decomposePar"
        self.stopped(support.execute(self.case), f"no mesh.*where: .*constant/polyMesh.*remedy: .*{ready}")
        support.must(self.case, "blockMesh")
        self.stopped(support.execute(self.case), f"the script reads `dem/bed.data`, which is not there.*remedy: .*{ready}")
        self.stopped(support.execute(self.case, 2), "not decomposed.*tools/run --ranks")

    def test_a_file_that_no_program_makes(self):
        gas_box.write(self.case)
        script = os.path.join(self.case, "dem/in.liggghts")
        support.write(script, support.read(script).replace("region box", "read_restart dem/nothing.restart\nregion box", 1))
        self.stopped(support.execute(self.case), "the script reads `dem/nothing.restart`, which is not there.*remedy: name the file")


class CollatedFiles(Paths):
    def test_by_tools_run(self):
        """The fields of the end are put together from the folder of all ranks."""
        gas_box.write(self.case, end=0.002, control=COLLATED)
        done = self.run_tool("--ranks", "2")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual([name for name in os.listdir(os.path.join(self.root, "out")) if name.startswith("processor")], ["processors2"])
        self.assertTrue(os.path.isfile(os.path.join(self.root, "out/0.002/U")))
        self.assertNotIn("warning", done.stderr)

    def test_wrong_number_of_ranks(self):
        gas_box.write(self.case, control=COLLATED)
        support.must(self.case, "decomposePar")
        self.stopped(support.execute(self.case, 3), "decomposed into 2 parts.*3 ranks.*start 2 ranks")


class Names(Paths):
    def test_letters_that_openfoam_strips(self):
        """It would look in another folder, which may be there."""
        gas_box.write(self.case, end=0.001)
        shutil.copytree(self.case, os.path.join(self.root, "mybox"))
        for name in ("my box", "my'box", "my$box", "my;box"):
            folder = os.path.join(self.root, name)
            shutil.copytree(self.case, folder)
            with self.subTest(name):
                self.stopped(support.execute(folder), f"bears no `{re.escape(name[2])}` in a path.*{re.escape(name)}.*link")
                self.assertFalse(os.path.exists(os.path.join(self.root, "mybox/results.h5")))

    def test_a_link_without_them(self):
        folder = gas_box.write(os.path.join(self.root, "plain"), end=0.001)
        support.must(folder, "decomposePar")
        os.rename(folder, os.path.join(self.root, "my box"))
        link = os.path.join(self.root, "link")
        os.symlink(os.path.join(self.root, "my box"), link)
        for ranks in (1, 2):
            done = support.execute_from(self.root, link, ranks)
            self.assertEqual(done.code, 0, done.text)
            os.remove(os.path.join(self.root, "my box/results.h5"))

    def test_a_script_beside_the_folders(self):
        gas_box.write(self.case, end=0.001)
        shutil.move(os.path.join(self.case, "dem/in.liggghts"), os.path.join(self.case, "in.liggghts"))
        os.rmdir(os.path.join(self.case, "dem"))
        self.edit(self.case, "system/couplingDict", "dem/in.liggghts", "in.liggghts")
        done = self.run_case(self.case)
        self.assertIn("fix move all nve/sphere", support.read(done.path("dem/log.liggghts")))
        self.edit(self.case, "in.liggghts", "nve/sphere", "nve/spere")
        self.stopped(support.execute(self.case), "LIGGGHTS stopped.*nve/spere")


class Rights(Paths):
    """Of somebody who may read the case and not write: root, who may do all, takes another's place."""

    def execute(self, ranks=1):
        place = {"user": 65534, "group": 65534, "extra_groups": []} if os.geteuid() == 0 else {}
        command = support.launch.command(support.PROGRAM, self.case, ranks)
        done = subprocess.run(
            command, env=support.environment(HOME=self.root, TMPDIR="/tmp"), stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=60, **place
        )
        return support.Finished(self.case, done.returncode, done.stdout, done.stderr)

    def setUp(self):
        super().setUp()
        gas_box.write(self.case, end=0.001)
        os.chmod(self.root, 0o755)
        os.chmod(self.shared, 0o755)

    def closed(self, *names):
        for name in names:
            path = os.path.join(self.case, name)
            if os.geteuid() != 0:
                mode = os.stat(path).st_mode
                os.chmod(path, mode & ~0o222)
                self.addCleanup(os.chmod, path, mode)

    def opened(self, *names):
        for name in names:
            if os.geteuid() == 0:
                os.chown(os.path.join(self.case, name), 65534, 65534)

    def test_a_case_that_cannot_be_written(self):
        self.closed("", "dem")
        self.stopped(self.execute(), f"cannot write into the case: Permission denied.*{self.case}.*tools/run")

    def test_a_folder_of_it(self):
        self.opened("")
        self.closed("dem")
        self.stopped(self.execute(), "LIGGGHTS's log cannot be written: Permission denied.*dem/log.liggghts")

    def test_results_of_another_user(self):
        support.write(os.path.join(self.case, "results.h5"), "")
        self.opened("", "dem")
        self.closed("results.h5")
        self.stopped(self.execute(), "Permission denied.*results.h5")

    def test_all_that_is_needed(self):
        self.opened("", "dem")
        self.assertEqual(self.execute().code, 0)
