"""A dipole meets a wall: energy and enstrophy against Chebyshev solutions; the long ones are in test_dipoleWallLong.py."""
from cases import CaseTest, unittest
from tutorials import Tutorial, at


class DipoleTest(CaseTest):
    def dipole(self, Re, intervals, end, **schemes):
        """Times and columns of flow.csv, the reference of the same Reynolds number."""
        case = Tutorial("dipoleWall")
        self.addCleanup(case.remove)
        case.set_flow(1 / Re, (intervals, intervals), end, **schemes)
        case.solve(self, sample=False)
        rows = case.table("flow")
        columns = {name: [float(row[name]) for row in rows] for name in rows[0]}
        return case, columns

    def check_curves(self, case, columns, reference, energy, enstrophy):
        """The largest relative deviations over the whole time."""
        for name, column, bound in (("E", "kineticEnergy", energy), ("Z", "enstrophy", enstrophy)):
            times, values = case.reference(reference, "t", name)
            errors = [(abs(at(t, columns["time"], columns[column]) / value - 1), t)
                      for t, value in zip(times, values) if t <= columns["time"][-1]]
            print(f"{self.id()}: {name} off by {100 * max(errors)[0]:.3f} % at t = {max(errors)[1]:g}")
            self.assertLessEqual(max(errors)[0], bound, f"{name} at {max(errors)[1]}")


class Dipole(DipoleTest):
    def test_re100(self):
        case, columns = self.dipole(100, 96, 2)
        self.assertAlmostEqual(columns["kineticEnergy"][0], 2, delta=2e-5)
        self.assertAlmostEqual(columns["enstrophy"][0], 800, delta=8e-3)
        self.check_curves(case, columns, "dipole_re100_energy.csv", 0.002, 0.005)


if __name__ == "__main__":
    unittest.main()
