# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
"""tools/CLUSTERS.md: its batch script, with a stand-in for srun that calls mpirun; hostfile and pinning; the bare command line
of the README, as root too; exit codes on the way."""

import os
import re
import signal
import subprocess
import time

import gas_box
import support

PAGE = support.read(support.SOURCE, "tools/CLUSTERS.md")

# As srun does, it sends SIGTERM on to the ranks; mpirun, which would kill them a second later, gets none.
SRUN = """#!/bin/bash
echo "srun $*" > "$CALLED"
[ "$1" = -n ] && [ "$3" = --cpu-bind=cores ] || exit 99
ranks=$2; shift 3
mpirun --oversubscribe -n "$ranks" "$@" &
run=$!
trap 'for rank in $(ps -o pid= --ppid $run); do kill -TERM $rank; done' TERM
wait $run; code=$?
while kill -0 $run 2>/dev/null; do wait $run; code=$?; done
exit $code
"""


class Launching(support.ProgramTest):
    def setUp(self):
        super().setUp()
        self.tools = os.path.join(self.root, "bin")
        support.write(os.path.join(self.tools, "srun"), SRUN)
        os.chmod(os.path.join(self.tools, "srun"), 0o755)
        support.write(os.path.join(self.tools, "scontrol"), '#!/bin/bash\necho "scontrol $*" >> "$CALLED"\n')
        os.chmod(os.path.join(self.tools, "scontrol"), 0o755)
        self.called = os.path.join(self.root, "called")

    def case(self, end=0.002):
        folder = gas_box.write(os.path.join(self.root, f"case{len(os.listdir(self.root))}"), end=end)
        support.must(folder, "decomposePar")
        return folder

    def batch(self, folder, **changes):
        """The page's script on two ranks, running."""
        script = os.path.join(self.root, "script.sh")
        support.write(script, re.search(r"```bash\n(.*?)```", PAGE, re.S).group(1))
        variables = support.environment(PATH=self.tools + os.pathsep + os.environ["PATH"], SLURM_NTASKS="2", SLURM_JOB_ID="17", CALLED=self.called,
                                        PROGRAM=support.PROGRAM, CASE=folder, WM_PROJECT_DIR=None, **changes)  # fmt: skip
        return subprocess.Popen(["bash", script], env=variables, cwd="/", stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, text=True, start_new_session=True)  # fmt: skip

    def test_batch_script(self):
        folder = self.case()
        job = self.batch(folder)
        out, err = job.communicate(timeout=60)
        self.assertEqual(job.returncode, 0, out + err)
        self.assertEqual(support.read(self.called).split()[:4], ["srun", "-n", "2", "--cpu-bind=cores"])
        self.assertIn("Reached t = 0.002 s", out)

    def test_batch_script_gives_the_exit_code(self):
        folder = self.case()
        self.edit(folder, "system/couplingDict", "^method DEM", "method DEMM")
        job = self.batch(folder)
        out, err = job.communicate(timeout=60)
        self.assertEqual(job.returncode, 1, out + err)
        self.assertTrue(err.rstrip("\n").split("\n")[-1].startswith("  remedy: "), err)

    def test_batch_script_at_its_limit(self):
        """SIGTERM to the script reaches the ranks, and their end the script, which is queued again and goes on."""
        folder = self.case(end=1000)
        # a fast machine lets the sphere fall out of the box before the signal comes
        self.edit(folder, "system/couplingDict", "^method DEM;", "method DEM; outsideMesh ignore;")
        job = self.batch(folder)
        while "t = 0 " not in (line := job.stdout.readline()):
            self.assertTrue(line, "ended before its first step")
        time.sleep(0.5)
        self.assertIsNone(job.poll())
        job.send_signal(signal.SIGTERM)
        out, err = job.communicate(timeout=60)
        self.assertEqual(job.returncode, 128 + signal.SIGTERM, out + err)
        left = subprocess.run(["pgrep", "-f", folder], capture_output=True, text=True).stdout
        self.assertEqual(left, "")
        self.assertIn("scontrol requeue 17\n", support.read(self.called))

        (reached,) = os.listdir(os.path.join(folder, "checkpoints"))
        self.set_entry(folder, "system/controlDict", "endTime", float(reached) + 0.001)
        again = self.batch(folder)
        out, err = again.communicate(timeout=60)
        self.assertEqual(again.returncode, 0, out + err)
        self.assertIn(f"the run goes on from checkpoints/{reached}", err)
        self.assertNotIn("requeue", support.read(self.called))

    def mpirun(self, *options, **changes):
        done = subprocess.run(["mpirun", *options, support.PROGRAM, "-parallel", "-case", self.case()], capture_output=True, text=True,
                              env=support.environment(**changes), stdin=subprocess.DEVNULL, timeout=60)  # fmt: skip
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("Reached t = 0.002 s", done.stdout)
        return done

    def test_hostfile(self):
        hosts = os.path.join(self.root, "hosts")
        support.write(hosts, "localhost slots=2\n")
        self.mpirun("--hostfile", hosts, "-n", "2")

    def test_pinning(self):
        if len(os.sched_getaffinity(0)) < 2:
            self.skipTest("there is one core")
        done = self.mpirun("-n", "2", "--host", "localhost:2", "--map-by", "core", "--bind-to", "core", "--report-bindings",
                           OMPI_MCA_rmaps_base_oversubscribe=None)  # fmt: skip
        self.assertEqual(len(set(re.findall(r"rank \d bound to (.*)", done.stderr))), 2, done.stderr)

    def test_line_of_the_page(self):
        """As it stands in tools/CLUSTERS.md, by a user who has set nothing: as root Open MPI wants the two variables that tools/README.md names."""
        line = re.search(r"^    (mpirun -n 4 build/release/interphase -parallel -case DIR)$", support.read(support.TOOLS, "CLUSTERS.md"), re.M)
        wanted = re.search(r"`(OMPI_ALLOW_RUN_AS_ROOT=1 \S+)`", support.read(support.TOOLS, "README.md"))
        folder = self.case()
        support.must(self.four(folder), "decomposePar", "-force")
        command = f"{wanted[1]} {line[1]}".replace("build/release/interphase", support.PROGRAM).replace("DIR", folder)
        done = subprocess.run(["bash", "-c", command], capture_output=True, text=True, stdin=subprocess.DEVNULL, timeout=60,
                              env=support.environment(OMPI_ALLOW_RUN_AS_ROOT=None, OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=None, WM_PROJECT_DIR=None,
                                                      OMPI_MCA_rmaps_base_oversubscribe="1"))  # fmt: skip
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def four(self, folder):
        self.edit(folder, "system/decomposeParDict", r"numberOfSubdomains 2", "numberOfSubdomains 4")
        self.edit(folder, "system/decomposeParDict", r"n \(1 1 2\)", "n (1 1 4)")
        return folder
