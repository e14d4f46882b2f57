"""The lid-driven cavity against published profiles; the long ones are in test_cavityLong.py."""
from cases import CaseTest, unittest
from tutorials import Tutorial, deviation

EXTREMA = {100: (-0.2140424, 0.1795728, -0.2538030), 1000: (-0.3885698, 0.3769447, -0.5270771)}  # Botella & Peyret 1998


class CavityTest(CaseTest):
    def cavity(self, Re, intervals, end, **schemes):
        case = Tutorial("cavity")
        self.addCleanup(case.remove)
        case.set_flow(1 / Re, (intervals, intervals), end, **schemes)
        case.solve(self)
        return case

    def check_extrema(self, case, Re, bound):
        u, v = case.line("vertical", "y", "U.x")[1], case.line("horizontal", "x", "U.y")[1]
        errors = [abs(value / wanted - 1) for value, wanted in zip((min(u), max(v), min(v)), EXTREMA[Re])]
        print(f"{self.id()}: extrema off by {', '.join(f'{100 * error:.2f} %' for error in errors)}")
        self.assertLessEqual(max(errors), bound)

    def check_profiles(self, case, Re, bound):
        u = deviation(case.line("vertical", "y", "U.x"), case.reference("cavity_check_own_u.csv", "y", f"Re{Re}"))
        v = deviation(case.line("horizontal", "x", "U.y"), case.reference("cavity_check_own_v.csv", "x", f"Re{Re}"))
        print(f"{self.id()}: profiles off by {u:.5f} (u) and {v:.5f} (v) of the lid's speed")
        self.assertLessEqual(max(u, v), bound)


MILD = {"continuation__degree": "3", "filter": "{ type exponential; order 16; }"}


class Cavity(CavityTest):
    def test_re100(self):
        self.check_extrema(self.cavity(100, 48, 20), 100, 0.01)

    def test_re100_where_friction_rules_the_step(self):
        self.check_profiles(self.cavity(100, 72, 8), 100, 0.006)

    def test_re100_degree3(self):
        self.check_extrema(self.cavity(100, 48, 20, continuation__degree="3"), 100, 0.005)

    def test_re100_gaussian4(self):
        case = self.cavity(100, 48, 20, kernel__order="4", kernel__smoothingLength="1.3")
        self.check_extrema(case, 100, 0.01)

    def test_re1000(self):
        self.check_extrema(self.cavity(1000, 64, 60), 1000, 0.017)

    def test_re1000_mild_closure(self):
        self.check_extrema(self.cavity(1000, 64, 50, **MILD), 1000, 0.008)

    def test_increments_of_the_pressure_are_warned_of(self):
        for schemes in ({"viscous": "CrankNicolson"}, {"walls": "incremental"}):
            case = Tutorial("cavity")
            self.addCleanup(case.remove)
            case.set_flow(0.01, (16, 16), 0.1, **schemes)
            self.succeeds(case, "makeLattice")
            self.assertIn("increments of the pressure", self.succeeds(case, "isphFoam").stderr)

    def test_re10000_coarse_stays_bounded(self):
        case = self.cavity(10000, 64, 8)
        self.assertEqual(case.report()["endedBecause"], "endTime")
        self.assertLess(float(case.table("flow")[-1]["maxSpeed"]), 1.5)


if __name__ == "__main__":
    unittest.main()
