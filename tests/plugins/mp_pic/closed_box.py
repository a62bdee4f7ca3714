# SPDX-License-Identifier: GPL-3.0-or-later
"""What tests of parcels in a closed box have in common: the box, parcels, what stress and walls gave, and how a bad one ends."""

import os

import numpy

import boxes
import support

SIZE, CELLS = (0.04, 0.04, 0.08), (4, 4, 8)
DIAMETER, DENSITY = 2e-3, 1000.0
MASS = DENSITY * numpy.pi / 6 * DIAMETER**3
THIN = (1e-30, 1e-30)  # a fluid that nobody feels
FROZEN = "model frozen; coupling oneWay;"
SUMS = ('variable s1 equal "f_move[1]"\nvariable s2 equal "f_move[2]"\nvariable s3 equal "f_move[3]"\nvariable w1 equal "f_move[4]"\n'
        'variable w2 equal "f_move[5]"\nvariable w3 equal "f_move[6]"\n'
        'fix sums all print 1 "${s1} ${s2} ${s3} ${w1} ${w2} ${w3}" file dem/sums screen no\n')  # fmt: skip


def crowd(seed=1, speed=0.2, counts=(12, 12, 24)):
    draw = numpy.random.default_rng(seed)
    position = boxes.lattice(SIZE, counts)
    return position, draw.normal(scale=speed, size=position.shape)


def heaped(seed=2):
    """Denser below than above, anywhere."""
    draw = numpy.random.default_rng(seed)
    place = draw.uniform(0.001, 1, (5000, 3)) * (numpy.array(SIZE) - 2.1e-3) + 1.05e-3
    place[:, 2] = 1.05e-3 + (place[:, 2] - 1.05e-3) * draw.uniform(0.3, 1, 5000)
    return place, draw.normal(scale=0.3, size=place.shape)


class BoxTest(support.ProgramTest):
    def run_box(self, name, ranks=1, **how):
        position, velocity = how.pop("parcels")
        box = boxes.Box(SIZE, CELLS, how.pop("diameter", DIAMETER), DENSITY, position, velocity, **how)
        return self.run_case(box.write(os.path.join(self.root, name), ranks), ranks)

    @staticmethod
    def sums(done):
        """(by the stress, by walls) after the last step [kg m/s]."""
        last = support.read(done.path("dem", "sums")).strip().splitlines()[-1]
        return numpy.split(numpy.array([float(word) for word in last.split()]), 2)

    @staticmethod
    def momentum(snapshot):
        return MASS * snapshot["velocity"].sum(axis=0)

    def ended(self, expected, good=False, ranks=1, **how):
        """A short run that says `expected`, and ends well or not."""
        position, velocity = how.pop("parcels", crowd(speed=0.05, counts=(4, 4, 8)))
        box = boxes.Box(SIZE, CELLS, how.pop("diameter", DIAMETER), DENSITY, position, velocity, end=2e-3, gas=how.pop("gas", FROZEN), **how)
        done = support.execute(box.write(os.path.join(self.root, f"box{len(os.listdir(self.root))}"), ranks), ranks)
        self.assertEqual(done.code == 0, good, done.text[-3000:])
        log = done.path("dem", "log.liggghts")
        done.told = " ".join((done.text + (support.read(log) if os.path.exists(log) else "")).split())
        self.assertRegex(done.told, expected)
        return done
