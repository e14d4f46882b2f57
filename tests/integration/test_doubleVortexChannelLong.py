"""Two vortices in a channel on 160 intervals a metre, both viscosities; minutes."""
from cases import unittest
from test_doubleVortexChannel import ChannelTest


class ChannelLong(ChannelTest):
    def test_profiles(self):
        for nu in (0.01, 0.001):
            with self.subTest(nu=nu):
                coarse, fine = (self.error(self.channel(nu, n), nu) for n in (80, 160))
                self.assertLessEqual(fine, 0.005)
                self.assertLess(fine, 0.7 * coarse)


if __name__ == "__main__":
    unittest.main()
