# SPDX-License-Identifier: GPL-3.0-or-later
"""Small scenes for LIGGGHTS alone. ctest sets RUNNER (interphase-liggghts) and PLUGIN (the library)."""

import os
import subprocess
import tempfile

RESTITUTION = 0.7
FRICTION = 0.3
STEP = 1e-5  # s; a collision takes 200 of them and more

# A box of 0.1 m that two ranks and more share along x.
HEAD = f"""
units           si
atom_style      granular
boundary        f f f
newton          off
communicate     single vel yes
processors      * 1 1
region          box block 0 0.1 0 0.1 0 0.1 units box
create_box      1 box
neighbor        0.002 bin
neigh_modify    delay 0
timestep        {STEP}
fix             k all property/global kn peratomtypepair 1 1000.0
fix             e all property/global coefficientRestitution peratomtypepair 1 {RESTITUTION}
fix             mu all property/global coefficientFriction peratomtypepair 1 {FRICTION}
@COLLIDES@
fix             floor all @WALL@ primitive type 1 zplane 0.0
dump            state all custom 100 states id x y z vx vy vz omegax omegay omegaz mass radius
dump_modify     state sort id format "%d{11 * " %.17g"}"
"""
GRAVITY = "fix gravity all gravity 9.81 vector 0.0 0.0 -1.0\n"


def sphere(number, diameter, density, x, v):
    """Lines that make a sphere of this number (the next one) at `x` [m] with `v` [m/s]."""
    return (f"create_atoms 1 single {x[0]} {x[1]} {x[2]} units box\nset atom {number} diameter {diameter} density {density}\n"
            f"group one id {number}\nvelocity one set {v[0]} {v[1]} {v[2]} units box\ngroup one delete\n")  # fmt: skip


def run(script, ranks=1):
    """What LIGGGHTS makes of it: a list of states, each a list of spheres, each a dictionary of the dump's columns."""
    with tempfile.TemporaryDirectory() as folder:
        with open(os.path.join(folder, "in.script"), "w", encoding="utf-8") as file:
            file.write(HEAD + script)
        command = [os.environ["RUNNER"], "-plugin", os.environ["PLUGIN"], "-in", "in.script", "-log", "none"]
        if ranks > 1:
            command = ["mpirun", "-n", str(ranks), "--oversubscribe", *command]
        environment = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
                       "OMPI_MCA_mpi_yield_when_idle": "1"}  # ranks may share a core
        done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, timeout=250)
        if done.returncode != 0:
            raise AssertionError(f"{' '.join(command)} failed:\n{done.stdout}{done.stderr}")
        with open(os.path.join(folder, "states"), encoding="utf-8") as file:
            text = file.read()
    states = []
    for part in text.split("ITEM: ATOMS ")[1:]:
        columns, *rows = part.split("ITEM:")[0].strip().split("\n")
        states.append([dict(zip(columns.split(), map(float, row.split()))) for row in rows])
    return states
