"""sampleLines, mapFields and the plots, on fields that a formula gives."""
import csv
import io
import math
import os
import resource
import shutil
import signal
import unittest

from cases import BIN, CaseTest

WITH_PROGRAMS = {"PATH": os.pathsep.join([BIN, os.environ["PATH"]])}


def exact(x, y, mean=(0.3, 0.1)):
    """Velocity and vorticity of the case at time 0."""
    X, Y = 2 * math.pi * x, 2 * math.pi * y
    return (mean[0] - math.cos(X) * math.sin(Y), mean[1] + math.sin(X) * math.cos(Y),
            4 * math.pi * math.cos(X) * math.cos(Y))


def rows(text):
    return [{name: float(value) for name, value in row.items()} for row in csv.DictReader(io.StringIO(text))]


class Sampling(CaseTest):
    def assertExact(self, sampled, tolerance=1e-13):
        self.assertTrue(sampled)
        for row in sampled:
            Ux, Uy, vorticity = exact(row["x [m]"], row["y [m]"])
            self.assertAlmostEqual(row["U.x [m/s]"], Ux, delta=tolerance)
            self.assertAlmostEqual(row["U.y [m/s]"], Uy, delta=tolerance)
            self.assertEqual(row["U.z [m/s]"], 0)
            if "vorticity [1/s]" in row:
                self.assertAlmostEqual(row["vorticity [1/s]"], vorticity, delta=100 * tolerance)

    def test_lines_and_planes(self):
        case = self.ready_case()
        case.put("system/sampleDict", """
lines { slanted { start (-0.41 -0.5 0); end (0.77 1.3 0); nPoints 37; } }
planes { all { normal z; at 0; } fine { normal z; at 0; nPoints (11 7); } }
fields (U p vorticity);
""")
        self.succeeds(case, "sampleLines")
        for name, points in (("slanted", 37), ("all", 24 * 24), ("fine", 77)):
            sampled = rows(case.text(f"postProcessing/sampleLines/0/{name}.csv"))
            self.assertEqual(len(sampled), points)
            self.assertEqual("distance [m]" in sampled[0], name == "slanted")
            self.assertExact(sampled)

    def test_standard_output_holds_data_only(self):
        case = self.ready_case()
        result = self.succeeds(case, "sampleLines", "-stdout", "-fields", "(U vorticity)")
        self.assertExact(rows(result.stdout))
        self.assertIn("Time = 0", result.stderr)
        self.assertFalse(os.path.exists(case.path("postProcessing")))

        result = self.succeeds(case, "sampleLines", "-stdout", "-quiet", "-plane", "auto", "-raster", "50")
        self.assertEqual(len(rows(result.stdout)), 2500)
        self.assertExact(rows(result.stdout))

    def test_unknown_names(self):
        case = self.ready_case()
        for arguments, known in ((("-fields", "V"), "known are: U, p"), (("-only", "center"), "known are: centre"),
                                 (("-interpolation", "cubik"), "known are: cubic"), (("-time", "3"), "the case has 0")):
            with self.subTest(arguments):
                result = case.run("sampleLines", *arguments)
                self.assertEqual(result.returncode, 1, result.stderr)
                self.assertIn(known, result.stderr)
        self.assertEqual(case.run("sampleLines", "-plane", "w 3").returncode, 2)


class Mapping(CaseTest):
    def map(self, source, target, *arguments, **options):
        return target.run("mapFields", source.dir, *arguments, **options)

    def test_there_and_back(self):
        coarse, fine = self.ready_case(), self.ready_case(points=36)
        before = fine.text("0/U")
        fine.replace("0/U", "cos", "0*cos")  # so that what is found afterwards was mapped
        result = self.map(coarse, fine)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("Fourier modes", result.stdout)
        self.assertIn('internalField   hdf5 "fields.h5";', fine.text("0/U"))
        def conditions(text):
            return text.split("boundaryField")[1].split()

        self.assertEqual(conditions(before.replace(";", " ;")), conditions(fine.text("0/U").replace(";", " ;")))
        self.assertIn("0*cos", fine.text("0.orig/U"))
        result = self.succeeds(fine, "sampleLines", "-stdout", "-quiet", "-fields", "(U vorticity)")
        sampled = rows(result.stdout)
        for row in sampled:
            self.assertAlmostEqual(row["U.x [m/s]"], exact(row["x [m]"], row["y [m]"])[0], delta=1e-13)

        # Only U, back again: p, which lies in the same file, stays.
        fine.put("0/p.expected", fine.text("0/p"))
        result = self.map(coarse, fine, "-fields", "(U)")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.succeeds(fine, "sampleLines", "-stdout", "-quiet", "-fields", "(U p)")

    def test_failures_leave_the_start_alone(self):
        coarse, middle, fine = self.ready_case(), self.ready_case(points=30), self.ready_case(points=36)
        self.assertEqual(self.map(coarse, middle).returncode, 0)
        before = fine.state()

        def tight():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (8192, 8192))

        result = self.map(coarse, fine, "-fields", "(U)", preexec=tight)
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertIn("fields.h5: could not be written: File too large", result.stderr)
        self.assertEqual(fine.state(), before)

        with open(middle.path("0/fields.h5"), "r+b") as file:
            file.seek(5000)
            byte = file.read(1)
            file.seek(5000)
            file.write(bytes([byte[0] ^ 1]))
        result = self.map(middle, fine)
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertIn(middle.path("0/fields.h5") + ": is damaged", result.stderr)
        self.assertEqual(fine.state(), before)

    def test_what_cannot_be_mapped(self):
        coarse, fine = self.ready_case(), self.case(points=36)
        fine.replace("system/latticeDict", "extent (1 1 0)", "extent (1.5 1 0)")
        self.succeeds(fine, "makeLattice")
        result = self.map(coarse, fine)
        self.assertEqual(result.returncode, 1)
        self.assertIn("a period of 1 m, and 1.5 m is no whole number of them", result.stderr)
        result = self.map(coarse, fine, "-fields", "T")
        self.assertEqual(result.returncode, 1)
        self.assertIn("known are: U, p", result.stderr)
        self.assertEqual(fine.run("mapFields").returncode, 2)


class Plots(CaseTest):
    def test_pictures(self):
        if shutil.which("gnuplot") is None:
            self.skipTest("gnuplot is not installed")
        case = self.ready_case()
        case.put("points.csv", "# from a book\ny [m],U.x [m/s]\n-0.25,1.3\n0.25,-0.7\n")
        for arguments, name in (
                (("plotField", "-field", "vorticity"), "vorticity_0"),
                (("plotField", "-field", "U.x", "-plane", "z 0", "-range", "-1:1"), "U.x_z0_0"),
                (("plotLines", "-field", "U.x", "-abscissa", "y", "-reference", "points.csv:y:U.x:Book"), "centre_U.x")):
            self.succeeds(case, *arguments, env=WITH_PROGRAMS)
            with open(case.path("pictures", name + ".png"), "rb") as file:
                self.assertEqual(file.read(8), b"\x89PNG\r\n\x1a\n")
            self.assertIn("</svg>", case.text(f"pictures/{name}.svg"))
        self.assertEqual(sorted(os.listdir(case.path("pictures"))),
                         ["U.x_z0_0.png", "U.x_z0_0.svg", "centre_U.x.png", "centre_U.x.svg", "vorticity_0.png",
                          "vorticity_0.svg"])

    def test_slips(self):
        if shutil.which("gnuplot") is None:
            self.skipTest("gnuplot is not installed")
        case = self.ready_case()
        for arguments, said, code in (
                (("plotField", "-field", "W"), "known are: ", 1), (("plotField", "-feild", "U"), "unknown option -feild", 2),
                (("plotField", "-range", "1"), "is not MIN:MAX", 2), (("plotLines", "-abscissa", "r"), "not one of", 2),
                (("plotLines", "-line", "center"), "known are: centre", 1),
                (("plotLines", "-reference", "none.csv:y:U.x"), "there is no file none.csv", 1)):
            with self.subTest(arguments):
                result = case.run(*arguments, env=WITH_PROGRAMS)
                self.assertEqual(result.returncode, code, result.stderr)
                self.assertIn(said, result.stderr)

    def test_without_gnuplot(self):
        case = self.ready_case()
        folder = case.path("..", "tools")
        os.makedirs(folder)
        for tool in ("bash", "dirname", "basename", "mktemp", "rm", "sed"):
            os.symlink(shutil.which(tool), os.path.join(folder, tool))
        result = case.run("plotField", env={"PATH": os.pathsep.join([folder, BIN])})
        self.assertEqual(result.returncode, 1)
        self.assertIn("gnuplot is not installed (Debian package gnuplot-nox)", result.stderr)


if __name__ == "__main__":
    unittest.main()
