"""What functions and utilities see of a flow between walls: Poiseuille's, which is known everywhere."""
import csv
import io
import os
import unittest

from cases import BIN, CaseTest

FUNCTIONS = """    flow { type flowStatistics; }
    wall { type wallProfile; patch floor; }
    pull { type forces; patches (floor lid); CofR (0 0.5 0); }
    means { type fieldAverage; fields (U p vorticity); }
    points { type probes; probeLocations ((0.3 0.98 0)); fields (U vorticity); }
"""


def rows(text):
    return [{name: float(value) for name, value in row.items()} for row in csv.DictReader(io.StringIO(text))]


class BetweenWalls(CaseTest):
    """u = 4 y (1 - y), driven by a force of 8 nu."""

    def channel(self, points=33, arrangement="collocated"):
        case = self.case(endTime=0.2, deltaT=0.01, nu="0.01", functions=FUNCTIONS)
        case.put("system/latticeDict", f"""origin (0 0 0); extent (1 1 0); count (16 {points} 1);
arrangement {arrangement};
patches
{{
    ends  {{ type periodic; axis x; }}
    floor {{ type wall; face yMin; }}
    lid   {{ type wall; face yMax; }}
}}
""")
        case.put("constant/transportProperties", "nu 0.01; rho 1000; bodyForce uniform (0.08 0 0);\n")
        case.put("0/U", """dimensions [0 1 -1 0 0 0 0]; internalField expression ("4*y*(1 - y)" "0" "0");
boundaryField { ends { type periodic; } "floor|lid" { type noSlip; } }
""")
        case.put("0/p", """dimensions [0 2 -2 0 0 0 0]; internalField uniform 0;
boundaryField { ends { type periodic; } "floor|lid" { type zeroGradient; } }
""")
        case.put("system/schemes", "kernel { type exact; }\n")
        case.put("system/sampleDict", """lines { across { start (0.31 0 0); end (0.31 1 0); nPoints 41; } }
fields (U vorticity Q);
""")
        self.succeeds(case, "makeLattice")
        return case

    def assertPoiseuille(self, case, tolerance, *arguments):
        self.succeeds(case, "sampleLines", *arguments)
        time = arguments[-1]
        sampled = rows(case.text(f"postProcessing/sampleLines/{time}/across.csv"))
        self.assertEqual(len(sampled), 41)
        for row in sampled:
            y = row["y [m]"]
            self.assertAlmostEqual(row["U.x [m/s]"], 4 * y * (1 - y), delta=tolerance)
            self.assertAlmostEqual(row["vorticity [1/s]"], 8 * y - 4, delta=100 * tolerance)
            self.assertAlmostEqual(row["Q [1/s2]"], 0, delta=100 * tolerance)

    def test_functions(self):
        case = self.channel()
        self.succeeds(case, "isphFoam")
        last = {name: float(value) for name, value in case.table("flow")[-1].items()}
        self.assertAlmostEqual(last["kineticEnergy"], 8 / 30, delta=1e-8)
        self.assertAlmostEqual(last["enstrophy"], 8 / 3, delta=1e-7)
        self.assertAlmostEqual(last["enstrophyBudget"], 8 / 3, delta=1e-5)
        self.assertAlmostEqual(last["palinstrophy"], 32, delta=1e-5)

        force = rows(case.text("postProcessing/pull/0/forces.csv"))[-1]
        self.assertAlmostEqual(force["viscousForce.x [N/m]"], 1000 * 0.08, delta=1e-5)
        self.assertAlmostEqual(force["pressureForce.y [N/m]"], 0, delta=1e-5)
        self.assertAlmostEqual(force["viscousMoment.z [N]"], 0, delta=1e-5)

        for row in rows(case.text("postProcessing/wall/0.2/floor.csv")):
            self.assertEqual(row["y [m]"], 0)
            self.assertAlmostEqual(row["vorticity [1/s]"], -4, delta=1e-6)
            self.assertAlmostEqual(row["shearStress.x [m2/s2]"], 0.04, delta=1e-8)

        probe = rows(case.text("postProcessing/points/0/probes.csv"))[-1]
        self.assertAlmostEqual(probe["U.x(0) [m/s]"], 4 * 0.98 * 0.02, delta=1e-8)
        self.assertAlmostEqual(probe["vorticity(0) [1/s]"], 8 * 0.98 - 4, delta=1e-6)
        self.assertTrue(os.path.exists(case.path("postProcessing/means/0.2/fields.h5")))
        self.assertPoiseuille(case, 1e-8, "-time", "0.2")

        again = self.succeeds(case, "isphFoam", "-postProcess", "-latestTime")
        self.assertIn("Time = 0.2", again.stdout)
        self.assertEqual(rows(case.text("postProcessing/pull/0.2/forces.csv"))[0].keys(), force.keys())

    def test_maps_reach_the_walls(self):
        source = self.channel()
        for points, arrangement, tolerance in ((49, "collocated", 1e-8), (40, "staggered", 1e-6)):
            with self.subTest(arrangement):
                target = self.channel(points, arrangement)
                target.replace("0/U", "4*y", "0*y")  # so that what is found afterwards was mapped
                result = target.run("mapFields", source.dir)
                self.assertEqual(result.returncode, 0, result.stderr)
                self.assertIn("spectral along x, spectral by continuation along y", result.stdout)
                self.assertPoiseuille(target, tolerance, "-time", "0")

    def test_functions_name_what_they_cannot_find(self):
        case = self.channel()
        case.replace("system/controlDict", "patch floor", "patch flor")
        case.replace("system/controlDict", "(floor lid)", "(floor ends)")
        before = case.state()
        result = case.run("isphFoam")
        self.assertEqual(result.returncode, 1)
        self.assertIn("functions.wall.patch: 'flor' is not a known patch\n    known are: floor, lid", result.stderr)
        self.assertIn("functions.pull.patches: 'ends' is not a known patch\n    known are: floor, lid", result.stderr)
        self.assertEqual(case.state(), before)

    @unittest.skipUnless(os.path.exists(os.path.join(BIN, "toVTK")), "built without VTK")
    def test_images_end_at_the_walls(self):
        for points, arrangement, origin in ((33, "collocated", "0 0 0"), (32, "staggered", "0 0.015625 0")):
            with self.subTest(arrangement):
                case = self.channel(points, arrangement)
                self.succeeds(case, "toVTK", "-derived")
                with open(case.path("VTK/vortex_0.vti"), "rb") as file:
                    image = file.read(4000).decode("latin-1")
                self.assertIn(f'WholeExtent="0 16 0 {points - 1} 0 0" Origin="{origin}"', image)
                for name in ("vorticity", "divergence", "Q", "streamFunction"):
                    self.assertIn(f'Name="{name}"', image)


if __name__ == "__main__":
    unittest.main()
