# SPDX-License-Identifier: GPL-3.0-or-later
"""The file of a study: which runs it asks for, and what is refused, with file, line and the nearest name, before anything runs."""

import json
import os
import shutil
import unittest

import h5py

from interphase import study_file, study_plan
from interphase.case_folder import LEFT_BY_A_RUN
from interphase.input_error import InputError
from interphase.tree import CASES
from scratch import InFolder, read, write


class Study(InFolder):
    def plan(self, text):
        path = os.path.join(self.root, "study")
        write(path, text)
        study = study_file.read(path)
        return study_plan.of(study, os.path.join(self.root, "runs"))

    def refused(self, text):
        with self.assertRaises(InputError) as caught:
            self.plan(text)
        self.assertIn(os.path.join(self.root, "study"), str(caught.exception))
        return str(caught.exception)

    def test_rows_are_products_with_the_files_keys_and_their_own(self):
        plan = self.plan("""
            case "cases/sscp1"; until 3; from 1; weights (8);
            rows
            {
                DEM     { methods (DEM); until 2; from 0.5; }
                parcels { methods (CGPM CGHS); weights (8 27); velocities (2.19 3.28); }
                steps   { methods (CGHS); solidSteps (0.5 2); set { drag/law Gidaspow; } seeds 2; }
            }""")
        self.assertEqual(plan.beds, [])
        self.assertEqual(len(plan.points), 1 + 2 * 2 * 2 + 2 * 2)
        of = {point.name: point for point in plan.points}
        self.assertEqual((of["DEM"].case.weight, of["DEM"].until, plan.starts["DEM"]), (1, 2, 0.5))
        parcels = of["parcels_inletVelocity-3.28_CGHS-w27"]
        self.assertEqual((parcels.case.method, parcels.case.weight, parcels.until), ("CGHS", 27, 3))
        self.assertEqual(parcels.case.value("inletVelocity"), "3.28")
        steps = [point for name, point in of.items() if name.startswith("steps")]
        self.assertEqual({(p.case.value("particles/stepsPerCollision"), p.case.value("drag/law"), p.seed) for p in steps},
                         {(step, "Gidaspow", seed) for step in ("0.5", "2") for seed in (1, 2)})  # fmt: skip

    def test_runs_of_one_weight_start_from_one_bed(self):
        plan = self.plan("""
            case "cases/sscp1"; until 2; developed { time 3; }
            rows { all { methods (TDHS CGHS MPPIC); weights (8); } DEM { methods (DEM); startTimes (1 2 3); } }""")
        self.assertEqual([(bed.name, bed.case.method, bed.until) for bed in plan.beds], [("developed-w1", "TDHS", 3), ("developed-w8", "CGHS", 3)])
        starts = {point.name: os.path.basename(point.start) for point in plan.points}
        self.assertEqual(starts["all_MPPIC-w8"], "developed-w8@3")
        self.assertEqual([starts[f"DEM_from-{n}"] for n in (1, 2, 3)], ["developed-w1@1", "developed-w1@2", "developed-w1@3"])
        self.assertEqual({plan.pieces_of[f"DEM_from-{n}"] for n in (1, 2, 3)}, {"DEM"})
        self.assertEqual(plan.pieces_of["all_TDHS-w1"], "all_TDHS-w1")

    def test_a_bed_is_developed_with_what_all_rows_have_alike(self):
        plan = self.plan("""
            case "cases/sscp1"; until 2; velocities (3.28); set { depth 0.06; records/snapshotInterval 0.5; } solidSteps (40); developed { time 3; }
            rows { a { methods (DEM); } b { methods (CGHS); weights (8); set { restitution 0.5; } } c { methods (CGHS); weights (8); set { restitution (0.6 0.7); } } }""")
        self.assertEqual([bed.case.settings for bed in plan.beds], [{"inletVelocity": "3.28", "depth": "0.06", "records/snapshotInterval": "0.5"}] * 2)
        self.assertIn("no multiple of records/snapshotInterval = 0.5 s", self.refused('case "cases/sscp1"; set { records/snapshotInterval 0.5; } developed { time 1.2; } methods (DEM);'))

    def test_replicates_together_may_be_the_reference(self):
        text = 'case "cases/sscp1"; until 2; developed { time 3; } rows { TDHS { methods (TDHS); } DEM { methods (DEM); startTimes (1 3); } } reference '
        self.plan(text + "DEM;")
        self.assertIn("reference DEM_from-1 is none of the runs", self.refused(text + "DEM_from-1;"))

    def test_what_is_refused(self):
        for text, words in (
            ("until 3;", "no entry case"),
            ('case "cases/sscp2"; ', "did you mean"),
            ('case "cases/sscp1"; metods (DEM);', "line 1: metods is unknown: did you mean 'methods'?"),
            ('case "cases/sscp1"; rows { a { weigths (8); } }', "did you mean 'weights'"),
            ('case "cases/sscp1"; methods (DEN);', "'DEN' is unknown: did you mean 'DEM'"),
            ('case "cases/sscp1"; methods (CGPM CGPM);', "CGPM is there twice"),
            ('case "cases/sscp1"; set { inletVelcity (1 2); }', "inletVelocity"),
            ('case "cases/sscp1"; set { mapping { width 1; } }', "name entries by their path"),
            ('case "cases/sscp1"; until 3; from 4;', "nothing is left to measure"),
            ('case "cases/sscp1"; until 3; methods (CGPM CGHS); reference cgpm;', "is none of the runs"),
            ('case "cases/sscp1"; startTimes (1 2);', "need a block `developed"),
            ('case "cases/sscp1"; developed { time 1.013; } methods (TDHS);', "no multiple of records/snapshotInterval"),
            ('case "cases/sscp1"; developed { time 1; method CGHS; } methods (TDHS);', "tracks every particle"),
            ('case "cases/sscp1"; rows { a { methods (DEM); } b { methods (DEM); } }', "are the same run"),
        ):
            self.assertIn(words, self.refused(text), text)

    def test_a_method_whose_plugin_is_not_built(self):
        path = os.path.join(self.root, "study")
        write(path, 'case "cases/sscp1"; methods (CGPM CGHS);')
        study = study_file.read(path)
        before = os.environ.pop("INTERPHASE_PLUGIN_PATH", None)
        self.addCleanup(lambda: before is not None and os.environ.update(INTERPHASE_PLUGIN_PATH=before))
        with self.assertRaisesRegex(InputError, "no libhard_sphere.so is in"):
            study_plan.check_plugins(study, study_plan.of(study, self.root), os.path.join(self.root, "bin", "interphase"))

    def test_windows_outside_of_the_vessel(self):
        case = shutil.copytree(os.path.join(CASES, "sscp1"), os.path.join(self.root, "case"))
        path = os.path.join(self.root, "study")
        write(path, 'case "case";')
        study_plan.check_windows(study_file.read(path))
        coupling = os.path.join(case, "system", "couplingDict")
        text = read(coupling)
        self.assertEqual(text.count("left        0;"), 1)
        write(coupling, text.replace("left        0;", "left        1;").replace("right       $width;", "right       2;"))
        with self.assertRaisesRegex(InputError, "windows/left and windows/right .* outside"):
            study_plan.check_windows(study_file.read(path))

    def test_what_another_version_or_other_settings_have_made_is_told(self):
        plan = self.plan('case "cases/sscp1"; methods (CGPM); until 2;')
        point, folder = plan.points[0], os.path.join(self.root, "runs", "a")
        self.assertEqual(study_plan.unlike(point, folder, "abc"), "")
        write(os.path.join(folder, "run.json"), json.dumps({"method": "CGPM", "weight": 8.0, "settings": []}))
        self.assertEqual(study_plan.unlike(point, folder, "abc"), "")
        with h5py.File(os.path.join(folder, "results.h5"), "w") as file:
            file.create_group("meta").attrs["commit"] = "def"
        self.assertIn("it is of version def", study_plan.unlike(point, folder, "abc"))
        write(os.path.join(folder, "run.json"), json.dumps({"method": "CGPM", "weight": 8.0, "settings": ["seed=2"]}))
        self.assertIn("other settings", study_plan.unlike(point, folder, "def"))

    def test_results_beside_a_case_are_no_part_of_it(self):
        self.assertIn("study", LEFT_BY_A_RUN)

    def test_every_key_is_described(self):
        text = "\n".join(study_file.described())
        for key in [*study_file.KEYS[""], *study_file.KEYS["developed"]]:
            self.assertIn(key, text)


if __name__ == "__main__":
    unittest.main()
