"""Schemes of the papers between walls through the programs, and choices that only verify: extended, solver direct."""
import math

from cases import unittest
from test_cavity import CavityTest
from tutorials import Tutorial


class Papers(CavityTest):
    def preset(self, name, intervals, arrangement, end, more=""):
        case = Tutorial("cavity")
        self.addCleanup(case.remove)
        case.put("system/schemes", f"preset {name};\n{more}\n")
        case.set_flow(0.01, (intervals, intervals), end)
        case.set("system/latticeDict", "arrangement", arrangement)
        return case

    def test_2021_cavity(self):
        for intervals, bound in ((24, 0.17), (48, 0.025)):
            case = self.preset("paper2021", intervals, "staggered", 20)
            case.solve(self)
            self.check_extrema(case, 100, bound)

    def test_2021_cavity_that_diverges_in_steps_kept_small_leaves_its_last_state(self):
        # Explicit mirrors at Re 1000 on 16 points: speeds grow, and steps shrink to a 23rd of what would be stable.
        case = self.preset("paper2021", 16, "staggered", 60)
        case.set("constant/transportProperties", "nu", "0.001")
        case.set("system/controlDict", "maxCo", "0.1")
        self.succeeds(case, "makeLattice")
        result = case.run("isphFoam")
        self.assertEqual(result.returncode, 3, result.stderr)
        self.assertIn("speeds have grown", result.stderr)
        self.assertEqual(case.report()["endedBecause"], "diverged")
        self.assertAlmostEqual(float(case.times()[-1]), case.report()["time"], places=4)
        self.assertLess(float(case.table("flow")[-1]["maxSpeed"]), 1e6)

    def test_2026_cavity_on_few_points_is_unstable(self):
        case = self.preset("paper2026", 48, "collocated", 20)
        self.succeeds(case, "makeLattice")
        self.assertIn("the Laplacian of the continued lines is anti-diffusive", self.succeeds(case, "checkCase").stdout)
        result = case.run("isphFoam")
        self.assertEqual(result.returncode, 3)
        self.assertRegex(result.stderr, "diverged|largest stable step has become")

    def test_2026_cavity_on_more_points_is_bounded(self):
        case = self.preset("paper2026", 96, "collocated", 1)
        case.solve(self, sample=False)
        self.assertLess(float(case.table("flow")[-1]["maxSpeed"]), 1.5)


class Verifying(CavityTest):
    def errors(self, intervals=24, schemes=(), transforms=23, **solution):
        case = Tutorial("channelManufactured")
        self.addCleanup(case.remove)
        case.set_flow(0.01, (intervals, intervals), 0.25)
        case.set("system/controlDict", "deltaT", str(0.1 / intervals**2 / 0.01))
        for entry, value in schemes:
            case.set("system/schemes", entry, value)
        for entry, value in solution.items():
            case.set("system/solution", "p/" + entry, value)
        case.solve(self, sample=False)
        self.assertAlmostEqual(case.report()["transformsPerSubstep"], transforms, delta=0.6)  # functions ask for some
        self.assertIn(f"{transforms} a substep", self.succeeds(case, "checkCase").stdout)
        row = case.table("errors")[-1]
        return float(row["L2(U)"]), float(row["L2(p)"])

    def test_direct_pressure(self):
        coarse, fine = (self.errors(n, solver="direct", transforms=20) for n in (24, 48))
        orders = [math.log2(a / b) for a, b in zip(coarse, fine)]
        print(f"{self.id()}: U {fine[0]:.2e}, p {fine[1]:.2e}, orders {orders[0]:.1f}, {orders[1]:.1f}")
        self.assertGreaterEqual(orders[0], 4)
        self.assertGreaterEqual(orders[1], 3)

    def test_extended_box(self):
        lines, box = self.errors(), self.errors(schemes=[("continuation/extended", "yes")], transforms=19)
        for a, b in zip(lines, box):
            self.assertAlmostEqual(a / b, 1, delta=1e-6)


del CavityTest  # or its tests would run here, too

if __name__ == "__main__":
    unittest.main()
