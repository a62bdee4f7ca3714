# SPDX-License-Identifier: GPL-3.0-or-later
"""The contact law of cases/sscp1 gives, in the native `liggghts`, the restitution and contact time it is asked for.

Two spheres, or a sphere and a wall, meet once, without gravity. The script is the case's own dem/contact.liggghts and
the numbers are those of its `parameters`, for particles and for parcels.
"""

import math
import os
import shutil
import subprocess
import tempfile
import unittest

import interphase.parameters
import measured

CASE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "cases", "sscp1")
EXPONENTS = {"none": 0, "cubeRoot": 1 / 3, "twoThirds": 2 / 3, "linear": 1}  # of a parcel's spring with its weight
STEPS_PER_COLLISION = 200  # ten times finer than a run: the law is tested, not the time step

SCRIPT = """
units        si
atom_style   granular
atom_modify  map array
boundary     f f f
newton       off
communicate  single vel yes
region       box block -0.05 0.05 -0.05 0.05 -0.01 0.05 units box
create_box   2 box
{spheres}
include      dem/contact.liggghts
neighbor     0.002 bin
neigh_modify delay 0
set          group all diameter ${{trackedDiameter}} density ${{particleDensity}}
{velocities}
{wall}
fix          move all nve/sphere
variable     dt equal v_collisionTime/{steps_per_collision}
timestep     ${{dt}}
compute      spin all property/atom omegay
thermo       100000
run          0
{rows}
fix          rows all print 1 "{row}" file {out} screen no title "#"
run          {steps}
"""


def parameters():
    return interphase.parameters.read(os.path.join(CASE, "parameters"))


def handed_over():
    """Names of the variables that couplingDict hands to the script as the case's parameters."""
    variables = interphase.parameters.read(os.path.join(CASE, "system", "couplingDict"))["particles"]["variables"]
    return [name for name, value in variables.items() if value.startswith("$")]


class Meeting:
    """One sphere that meets a wall at z = 0, or sphere 2 that meets sphere 1 from above.

    `rows`: per step time, and the motion of sphere 2 (of the only one at a wall) relative to the other body: gap along
    z, vz, vx, and vx of the surfaces in contact.
    """

    def __init__(self, with_wall, weight, normal, tangential=0.0, **changed):
        value = {**parameters(), "weight": str(weight), **{k: str(v) for k, v in changed.items()}}
        self.value = {k: float(v) for k, v in value.items() if k not in ("method", "stiffnessScaling")}
        self.spring = self.value["springConstant"] * weight ** EXPONENTS[value["stiffnessScaling"]]
        self.diameter = self.value["diameter"] * weight ** (1 / 3)
        self.mass = self.value["particleDensity"] * math.pi / 6 * self.diameter**3
        self.with_wall = with_wall
        radius = self.diameter / 2
        gap = 5 * normal * self.solid_step()
        if with_wall:
            spheres = f"create_atoms 1 single 0 0 {radius + gap!r}"
            velocities = f"velocity all set {tangential!r} 0 {-normal!r}"
            wall = (
                "fix wall all wall/gran model hooke/stiffness tangential history "
                "primitive type 2 zplane 0.0 absolute_damping on"
            )
            names = ["z[1]", "vz[1]", "vx[1]", "c_spin[1]"]
        else:
            spheres = f"create_atoms 1 single 0 0 0.02\ncreate_atoms 1 single 0 0 {0.02 + self.diameter + gap!r}"
            velocities = (
                "group below id 1\ngroup above id 2\nvelocity below set 0 0 0\n"
                f"velocity above set {tangential!r} 0 {-normal!r}"
            )
            wall = ""
            names = ["z[1]", "vz[1]", "vx[1]", "c_spin[1]", "z[2]", "vz[2]", "vx[2]", "c_spin[2]"]
        with tempfile.TemporaryDirectory() as folder:
            out = os.path.join(folder, "rows.txt")
            script = os.path.join(folder, "in.meeting")
            with open(script, "w", encoding="ascii") as file:
                file.write(
                    SCRIPT.format(
                        spheres=spheres,
                        velocities=velocities,
                        wall=wall,
                        steps_per_collision=STEPS_PER_COLLISION,
                        steps=3 * STEPS_PER_COLLISION,
                        rows="variable t equal step*v_dt\n"
                        + "\n".join(f"variable q{i} equal {name}" for i, name in enumerate(names)),
                        row=" ".join(["${t}"] + [f"${{q{i}}}" for i in range(len(names))]),
                        out=out,
                    )
                )
            command = ["liggghts", "-in", script, "-log", os.path.join(folder, "log")]
            for name in ["weight"] + handed_over():
                command += ["-var", name, value[name]]
            run = subprocess.run(command, cwd=CASE, capture_output=True, text=True, timeout=60)
            if run.returncode != 0 or not os.path.exists(out):
                raise AssertionError(f"liggghts failed:\n{run.stdout[-2000:]}{run.stderr[-2000:]}")
            with open(out, encoding="ascii") as file:
                table = [[float(x) for x in line.split()] for line in file if not line.startswith("#")]
        self.rows = [self.relative(row) for row in table]

    def relative(self, row):
        t, z, vz, vx, spin = row[:5]
        radius = self.diameter / 2
        if self.with_wall:
            return t, z - radius, vz, vx, vx - spin * radius
        z2, vz2, vx2, spin2 = row[5:]
        # The lower one's surface moves by + spin radius, the upper one's by - spin radius.
        return t, z2 - z - self.diameter, vz2 - vz, vx2 - vx, vx2 - vx - (spin + spin2) * radius

    def restitution(self):
        return -self.rows[-1][2] / self.rows[0][2]

    def tangential_restitution(self):
        return -self.rows[-1][4] / self.rows[0][4]

    def contact_time(self):
        """Between the two instants at which the gap is zero, interpolated between steps [s]."""
        crossings = [
            before[0] + (after[0] - before[0]) * before[1] / (before[1] - after[1])
            for before, after in zip(self.rows, self.rows[1:])
            if (before[1] < 0) != (after[1] < 0)
        ]
        if len(crossings) != 2:
            raise AssertionError(f"the bodies met {len(crossings) / 2} times")
        return crossings[1] - crossings[0]

    def solid_step(self):
        return self.linear_contact_time(self.mass / 2, self.value["restitution"]) / STEPS_PER_COLLISION

    def expected_contact_time(self, restitution):
        return self.linear_contact_time(self.mass if self.with_wall else self.mass / 2, restitution)

    def linear_contact_time(self, reduced, restitution):
        return math.sqrt(reduced / self.spring * (math.pi**2 + math.log(restitution) ** 2))


@unittest.skipUnless(shutil.which("liggghts"), "needs the liggghts binary")
class ContactOfSscp1(unittest.TestCase):
    MEETINGS = [(weight, with_wall) for weight in (1, 8) for with_wall in (False, True)]

    def each(self, check):
        """Call check(weight, with_wall) for particles and parcels, on each other and on walls."""
        for weight, with_wall in self.MEETINGS:
            with self.subTest(weight=weight, meets="wall" if with_wall else "sphere"):
                check(weight, with_wall)

    def test_normal_restitution_and_contact_time(self):
        def check(weight, with_wall):
            meeting = Meeting(with_wall, weight, normal=0.2)
            expected = meeting.value["wallRestitution" if with_wall else "restitution"]
            pair = f"{'particle' if weight == 1 else f'parcel of {weight}'} on {'a wall' if with_wall else 'another'}"
            measured.within(self, f"springs of cases/sscp1 in native LIGGGHTS, {pair}: restitution", meeting.restitution(), expected, 0.005 * expected, "", "asked for")
            time = meeting.expected_contact_time(expected)
            self.assertAlmostEqual(meeting.contact_time() / time, 1, delta=0.01)

        self.each(check)

    def test_scaled_springs(self):
        """By each law of stiffnessScaling: contacts last as the scaled spring says, t_c follows, restitution stays."""
        for law, exponent in EXPONENTS.items():
            for with_wall in (False, True):
                with self.subTest(law=law, meets="wall" if with_wall else "sphere"):
                    meeting = Meeting(with_wall, 8, normal=0.2, stiffnessScaling=law)
                    expected = meeting.value["wallRestitution" if with_wall else "restitution"]
                    self.assertAlmostEqual(meeting.restitution() / expected, 1, delta=0.005)
                    self.assertAlmostEqual(meeting.contact_time() / meeting.expected_contact_time(expected), 1, delta=0.01)
                    # the script's step is its own t_c by STEPS_PER_COLLISION, printed to ten digits
                    self.assertAlmostEqual((meeting.rows[1][0] - meeting.rows[0][0]) / meeting.solid_step(), 1, delta=1e-9)
                    if not with_wall:
                        print(f"{law}: contact lasts {meeting.contact_time():.4g} s, W^{(1 - exponent) / 2:.3f} times a particle's, "
                              f"restitution {meeting.restitution():.4f}")  # fmt: skip

    def test_other_restitution(self):
        """The damping follows the parameter, not the value it happens to have."""

        def check(weight, with_wall):
            name = "wallRestitution" if with_wall else "restitution"
            meeting = Meeting(with_wall, weight, normal=0.2, **{name: 0.5})
            self.assertAlmostEqual(meeting.restitution() / 0.5, 1, delta=0.01)

        self.each(check)

    def test_tangential_restitution_when_nothing_slips(self):
        def check(weight, with_wall):
            name = "wallTangentialRestitution" if with_wall else "tangentialRestitution"
            for asked in (float(parameters()[name]), 0.6):
                meeting = Meeting(
                    with_wall, weight, normal=0.05, tangential=0.002, friction=1e3, wallFriction=1e3, **{name: asked}
                )
                self.assertAlmostEqual(meeting.tangential_restitution() / asked, 1, delta=0.01)

        self.each(check)

    def test_friction_when_all_slips(self):
        """Coulomb: the tangential impulse is mu times the normal one, as long as the surfaces slip."""

        def check(weight, with_wall):
            meeting = Meeting(with_wall, weight, normal=0.01, tangential=0.05)
            friction = meeting.value["wallFriction" if with_wall else "friction"]
            lost = meeting.rows[0][3] - meeting.rows[-1][3]
            gained = meeting.rows[-1][2] - meeting.rows[0][2]
            self.assertAlmostEqual(lost / (friction * gained), 1, delta=0.02)

        self.each(check)

    def test_paper_collision_time(self):
        """DESIGN's figure for the particle of the paper: 3.56e-4 s."""
        meeting = Meeting(False, 1, normal=0.2)
        self.assertAlmostEqual(meeting.expected_contact_time(0.84), 3.56e-4, delta=0.01e-4)
