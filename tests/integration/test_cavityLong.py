"""The lid-driven cavity on fine lattices and at high Reynolds number; minutes."""
from cases import unittest
from test_cavity import MILD, CavityTest


class CavityLong(CavityTest):
    def test_re100_profiles(self):
        self.check_profiles(self.cavity(100, 96, 20), 100, 0.005)

    def test_re400_profiles(self):
        self.check_profiles(self.cavity(400, 96, 45), 400, 0.005)

    def test_re1000_fine(self):
        self.check_extrema(self.cavity(1000, 128, 60), 1000, 0.007)

    def test_re1000_fine_mild_closure(self):
        self.check_extrema(self.cavity(1000, 128, 60, **MILD), 1000, 0.003)

    def test_re10000_bounded(self):
        case = self.cavity(10000, 128, 40)
        self.assertEqual(case.report()["endedBecause"], "endTime")
        rows = case.table("flow")
        self.assertLess(float(rows[-1]["maxSpeed"]), 1.5)
        self.check_profiles(case, 10000, 0.5)  # the core takes hundreds of turns of the lid to spin up


if __name__ == "__main__":
    unittest.main()
