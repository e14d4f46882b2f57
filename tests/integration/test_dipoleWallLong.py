"""A dipole meets a wall at Re 625, on 256 intervals to t = 0.5; at Re 100 to the end of the reference; minutes."""
from cases import unittest
from test_dipoleWall import DipoleTest
from tutorials import at, peak


class DipoleLong(DipoleTest):
    def collision(self, direct, budget, **schemes):
        """The first collision at Re 625 on 256 intervals; bounds of the peak of the enstrophy and of its budget."""
        _, columns = self.dipole(625, 256, 0.5, **schemes)
        t, E, Z = columns["time"], columns["kineticEnergy"], columns["enstrophy"]
        first, height = peak(t, Z, 0.25, 0.48)
        _, lost = peak(t, columns["enstrophyBudget"], 0.25, 0.48)
        found = {"E(.25)": at(0.25, t, E), "Z(.25)": at(0.25, t, Z), "E(.5)": at(0.5, t, E), "Z(.5)": at(0.5, t, Z),
                 "time": first, "direct": height, "budget": lost}
        print(self.id(), found)
        for name, wanted, bound in (("E(.25)", 1.502, 0.002), ("Z(.25)", 472.6, 0.002), ("E(.5)", 1.013, 0.006),
                                    ("Z(.5)", 380.6, 0.01), ("direct", 933.6, direct), ("budget", 933.6, budget)):
            self.assertLessEqual(abs(found[name] / wanted - 1), bound, name)
        self.assertLessEqual(abs(first - 0.3711), 0.002)

    def test_re625(self):
        self.collision(0.1, 0.03)

    def test_re625_with_a_closure_for_marginal_layers(self):
        self.collision(0.04, 0.02, continuation__degree="3", filter="{ type exponential; order 16; }")

    def test_re100_to_the_end(self):
        case, columns = self.dipole(100, 96, 10)
        self.check_curves(case, columns, "dipole_re100_energy.csv", 0.002, 0.005)


if __name__ == "__main__":
    unittest.main()
