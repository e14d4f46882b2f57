"""Two vortices in a channel, x periodic, walls in y: start by one projection, symmetry, profiles at t = 2."""
from cases import CaseTest, unittest
from tutorials import Tutorial, deviation

SPEED = {0.01: 0.2075, 0.001: 0.5025}  # the largest on y = 0.5


class ChannelTest(CaseTest):
    def channel(self, nu, intervals, end=2):
        case = Tutorial("doubleVortexChannel")
        self.addCleanup(case.remove)
        case.set_flow(nu, (2 * intervals, intervals), end)
        case.solve(self)
        return case

    def error(self, case, nu):
        """The largest deviation of the profiles relative to the largest speed."""
        name = f"double_vortex_channel_nu{nu}_"
        lines = (("horizontal", "x", "U.x", "y05", "u"), ("horizontal", "x", "U.y", "y05", "v"),
                 ("vertical", "y", "U.x", "vertical", "u_x05"), ("vertical", "y", "U.y", "vertical", "v_x05"),
                 ("between", "y", "U.y", "vertical", "v_x1"))
        worst = max(deviation(case.line(line, along, field), case.reference(name + file + ".csv", along, column))
                    for line, along, field, file, column in lines) / SPEED[nu]
        print(f"{self.id()}: profiles off by {100 * worst:.2g} % at nu {nu}")
        return worst


class Channel(ChannelTest):
    def test_one_projection_makes_the_start(self):
        case = self.channel(0.01, 80, 0.05)
        energy = float(case.table("flow")[0]["kineticEnergy"])
        print(f"{self.id()}: energy {energy:.6f}")
        self.assertAlmostEqual(energy, 0.140577, delta=2e-4)  # the torsion constant of the square
        values = [float(word) for word in case.values(case.times()[-1]).split("}")[0].split(",")]
        nx, ny = 160, 81
        self.assertEqual(len(values), 3 * nx * ny)
        worst = 0
        for j in range(ny):
            for i in range(nx):
                here, there = 3 * (nx * j + i), 3 * (nx * j + (nx - i) % nx)
                worst = max(worst, abs(values[here] + values[there]), abs(values[here + 1] - values[there + 1]))
        print(f"{self.id()}: mirrored about x = 1 to {worst:.1e}")
        self.assertLessEqual(worst, 1e-12)

    def test_profiles_converge(self):
        errors = [self.error(self.channel(0.01, n), 0.01) for n in (40, 80)]
        self.assertLess(errors[1], 0.5 * errors[0])


if __name__ == "__main__":
    unittest.main()
