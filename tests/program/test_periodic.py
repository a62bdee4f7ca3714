# SPDX-License-Identifier: GPL-3.0-or-later
# timeout: 900
"""cases/periodic-duct: gas and particles that repeat, across sides that ranks cut as they like. What leaves on one side comes back on the
other as if there were no side."""

import math

import numpy
from scipy.integrate import solve_ivp

import measured
import support
from interphase.uniform_suspension import Suspension

METHODS = (("DEM", 1), ("TDHS", 1), ("CGPM", 2), ("CGHS", 2), ("MPPIC", 2))


class Periodic(support.ProgramTest):
    def duct(self, name, ranks=1, cut=None, **settings):
        if cut:
            settings["system/decomposeParDict:simpleCoeffs/n"] = "({} {} {})".format(*cut)
        done = self.run_case(self.prepared("periodic-duct", name, ranks=ranks, **settings), ranks)
        self.assert_books_close(done)
        return done

    def test_a_suspension_settles_at_its_hindered_velocity(self):
        law = Suspension(0.3, 1e-3, 2000, 1000, 1e-3, "WenYu").hindered_velocity()
        for method, weight in METHODS:
            with self.subTest(method):
                snapshots = self.duct(method, method=method, weight=weight, until=0.16, recordInterval=0.02).snapshots()
                found = []
                for time, one in snapshots.items():
                    middle = abs(one["position"][:, 2] - 0.03) < 0.01
                    if time > 0.06:
                        found.append(-one["velocity"][middle, 2].mean())
                # solids of the cells vary by some percent, and drag is not linear in them
                measured.within(self, f"suspension of solid fraction 0.3 in water, {method}: settling velocity", numpy.mean(found), law, 0.015 * law, "m/s",
                                "Wen and Yu, hindered")  # fmt: skip

    def test_any_cut_through_the_sides_gives_the_same(self):
        def state(name, **options):
            return self.duct(name, until=0.02, gasStep=1e-3, recordInterval=0.02, **options).last()

        for ends in ("closed", "cyclic"):
            whole = state(f"{ends}-1", ends=ends)
            for cut in ((2, 1, 1), (1, 2, 1), (1, 1, 2), (2, 2, 1)):
                with self.subTest(ends=ends, cut=cut):
                    parts = state("{}-{}{}{}".format(ends, *cut), ranks=math.prod(cut), cut=cut, ends=ends)
                    numpy.testing.assert_array_equal(parts["id"], whole["id"])
                    # the pressure's solver stops at 1e-6 of its first residual; nothing else differs before spheres have met often
                    numpy.testing.assert_allclose(parts["velocity"], whole["velocity"], rtol=0, atol=2e-5 * 0.037)

    def test_without_ends_all_of_it_falls_and_the_slip_is_what_carries(self):
        """Uniform, and p_rgh repeats: rho_p dv/dt = -(rho_p - rho) g - k (v - u), eps rho du/dt = phi k (v - u)."""
        phi, density, fluid, g = 0.3, 2000.0, 1000.0, 9.81
        law = Suspension(phi, 1e-3, density, fluid, 1e-3, "WenYu")

        def rates(_, y):
            v, u = y
            drag = law.rate(abs(v - u)) * (v - u)
            return [-(1 - fluid / density) * g - drag / density, phi * drag / ((1 - phi) * fluid)]

        for method, weight in METHODS:
            with self.subTest(method):
                done = self.duct(f"cyclic-{method}", ends="cyclic", method=method, weight=weight, until=0.05, gasStep=2.5e-4,
                                 recordInterval=0.01)  # fmt: skip
                snapshots = done.snapshots()
                times = sorted(snapshots)
                exact = solve_ivp(rates, (0, times[-1]), [0.0, 0.0], t_eval=times, rtol=1e-10, atol=1e-12).y[0]
                found = [snapshots[t]["velocity"][:, 2].mean() for t in times]
                # the drag rate is held over a gas step of a sixtieth of the relaxation time, and the first of them starts at rest
                numpy.testing.assert_allclose(found[1:], exact[1:], rtol=0.02)
                measured.within(self, f"suspension falling without ends, {method}: velocity after 0.05 s", found[-1], exact[-1], 0.02 * abs(exact[-1]), "m/s",
                                "two coupled equations of motion")  # fmt: skip

    def test_what_repeats_otherwise_is_refused(self):
        folder = self.prepared("periodic-duct", "other")
        self.edit(folder, "dem/bed.data", r"0\.0 0\.01 xlo xhi", "0.0 0.0101 xlo xhi")
        done = support.execute(folder)
        self.assertEqual(done.code, 1, done.text)
        self.assertIn("particles repeat along x from 0 to 0.0101 m", done.err)
        self.assertIn("a cyclic pair of it moves by", done.err)


    def test_homogeneous_cooling(self):
        """Grains that move at random lose their energy in collisions and to the gas. With s the deviation of a velocity component,
        ds/dt = -k(s)/rho_p s - 4 (1 - e^2) phi g_0 s^2/(sqrt(pi) d) (Lun et al., J. Fluid Mech. 140 (1984) 223; g_0 of Carnahan and
        Starling)."""
        d, density, phi, e, start = 1e-4, 2500.0, 0.1, 0.8, 0.05
        side = (1222 * math.pi / 6 * d**3 / phi) ** (1 / 3)
        law = Suspension(phi, d, density, 1.2, 1.8e-5, "WenYu")
        radial = (1 - phi / 2) / (1 - phi) ** 3

        def rate(_, s):
            mean_speed = s[0] * math.sqrt(8 / math.pi)
            lost = 4 * (1 - e * e) * phi * radial * s[0] ** 2 / (math.sqrt(math.pi) * d)
            return [-law.rate(mean_speed) / density * s[0] - lost]

        for method, spring, until in (("TDHS", 20, 0.05), ("DEM", 4, 0.03)):
            with self.subTest(method):
                done = self.duct(
                    method, ranks=2, cut=(2, 1, 1), ends="cyclic", method=method, diameter=d, particleDensity=density,
                    solidFraction=phi, width=side, depth=side, height=side, cells="(5 5 5)", gasDensity=1.2, gasViscosity=1.8e-5,
                    gravity=0, speedSpread=start, restitution=e, friction=0, springConstant=spring, until=until, gasStep=2e-4,
                    recordInterval=0.005,
                )  # fmt: skip
                snapshots = done.snapshots()
                times = sorted(snapshots)
                exact = solve_ivp(rate, (0, times[-1]), [start], t_eval=times, rtol=1e-10, atol=1e-12).y[0]
                found = numpy.array([snapshots[t]["velocity"].std() for t in times])
                self.assertLess(exact[-1], 0.35 * start)
                # 3666 components have a deviation of 1.2 % of their own; the gas takes from them what they have in common in a cell,
                # and velocities that collisions have shaped are not quite Gaussian
                measured.below(self, f"cooling grains in air, {method}: largest difference of their random velocity from theory", 100 * abs(found / exact - 1).max(),
                               5, "%", "Lun et al., J. Fluid Mech. 140 (1984) 223, and drag")  # fmt: skip
