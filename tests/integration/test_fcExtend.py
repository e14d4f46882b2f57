"""fcExtend: what it writes, the errors it finds, and what it refuses."""
import csv
import os
import unittest

from cases import CaseTest, header, program

FIELD = """dimensions [0 0 0 0 0 0 0];
internalField expression "sin(2*pi*x)*(exp(y)*sin(5*y) + 0.5*y^3)";
boundaryField { sides { type periodic; } walls { type fixedValue; value uniform 0; } }
"""
EXACT = """exact
{
    gradient expression ("2*pi*cos(2*pi*x)*(exp(y)*sin(5*y) + 0.5*y^3)"
        "sin(2*pi*x)*(exp(y)*(sin(5*y) + 5*cos(5*y)) + 1.5*y^2)" "0");
    laplacian expression "sin(2*pi*x)*(exp(y)*(-24*sin(5*y) + 10*cos(5*y)) + 3*y - 4*pi^2*(exp(y)*sin(5*y) + 0.5*y^3))";
}
"""


def lattice(intervals="(12 100 0)", patches="sides { type periodic; axis x; } walls { type wall; faces (yMin yMax); }",
            extent="(1 1 0)", more=""):
    return header("latticeDict") + f"""origin (0 0 0);
extent {extent};
intervals {intervals};
patches {{ {patches} }}
{more}
"""


class FcExtend(CaseTest):
    def channel(self, **arguments):
        case = self.case()
        for name in ("0/U", "0/p"):
            os.remove(case.path(name))
        case.put("0/f", header("f", "latticeScalarField") + FIELD)
        case.put("system/schemes", header("schemes") + "kernel { type gaussian; }\n")
        case.put("system/fcExtendDict", header("fcExtendDict") + EXACT)
        case.put("system/latticeDict", lattice(**arguments))
        self.succeeds(case, "makeLattice")
        return case

    def errors(self, case, *arguments):
        self.succeeds(case, "fcExtend", "-derivatives", *arguments)
        with open(case.path("postProcessing/fcExtend/0/errors.csv"), encoding="utf-8") as file:
            return {name: float(value) for name, value in next(csv.DictReader(file)).items()}

    def refusal(self, case, *arguments):
        result = case.run("fcExtend", *arguments)
        self.assertEqual(result.returncode, 1, result.stdout)
        return result.stderr

    def test_a_channel(self):
        case = self.channel()
        errors = self.errors(case)
        # The measured 1.4e-6 and 5.7e-4 of the line, times the mean of sin^2 over x.
        self.assertAlmostEqual(errors["L2(gradient.y) [1/m]"], 9.62e-7, delta=5e-8)
        self.assertAlmostEqual(errors["L2(laplacian) [1/m2]"], 4.05e-4, delta=2e-5)
        self.assertLess(errors["L2(gradient.x) [1/m]"], 1e-12)
        self.assertEqual(sorted(name for name in os.listdir(case.path("0"))), ["derivatives.h5", "extended.h5", "f"])
        with open(case.path("postProcessing/fcExtend/0/line_f_y.csv"), encoding="utf-8") as file:
            line = list(csv.DictReader(file))
        self.assertEqual(len(line), 129)
        self.assertEqual(sum(float(row["new"]) for row in line), 28)
        self.assertEqual(line[0]["f [1]"], line[-1]["f [1]"])

    def test_the_whole_extended_box(self):
        case = self.channel()
        case.put("system/schemes", "kernel { type gaussian; }\ncontinuation { extended yes; }\n")
        self.assertAlmostEqual(self.errors(case)["L2(gradient.y) [1/m]"], 9.62e-7, delta=5e-8)

    def test_other_continuations(self):
        case = self.channel()
        for entries, least, largest in (("type polynomial;", 1e-4, 2e-3), ("type polynomial; points 8; smoothness 9;", 5e-8, 5e-7),
                                        ("type gram;", 9e-7, 1.1e-6), ("type mirror;", 1e-3, 1e-1)):
            case.put("system/schemes", "kernel { type exact; }\ncontinuation { %s }\n" % entries)
            found = self.errors(case)["L2(gradient.y) [1/m]"]
            self.assertGreater(found, least, entries)
            self.assertLess(found, largest, entries)

    def test_three_dimensions_and_vectors(self):
        case = self.channel(intervals="(8 60 60)", extent="(1 1 1)",
                         patches="sides { type periodic; axis x; } walls { type wall; faces (yMin yMax zMin zMax); }")
        case.put("0/f", header("f", "latticeVectorField") + FIELD.replace(
            'expression "sin(2*pi*x)*(exp(y)*sin(5*y) + 0.5*y^3)"', 'expression ("sin(2*pi*x)*y*z" "z^2" "exp(y)")'))
        os.remove(case.path("system/fcExtendDict"))
        said = self.succeeds(case, "fcExtend", "-derivatives").stdout
        for part in ("f.x along y: 61 + 35 points", "f.z along z: 61 + 35 points", "Wrote 0/derivatives.h5"):
            self.assertIn(part, said)

    def test_paraview(self):
        case = self.channel()
        if not os.path.exists(program("toVTK")):
            self.assertIn("-vtk needs toVTK, which was not built", self.refusal(case, "-vtk"))
            self.assertEqual(os.listdir(case.path("0")), ["f"])
            return
        self.assertIn("Wrote VTK/vortex_extended.pvd", self.succeeds(case, "fcExtend", "-vtk").stdout)
        self.assertEqual(sorted(os.listdir(case.path("VTK"))), ["vortex_extended.pvd", "vortex_extended_0.vti"])
        # 12 and 128 periodic points, and the first again at the end.
        with open(case.path("VTK/vortex_extended_0.vti"), "rb") as file:
            self.assertIn(b'WholeExtent="0 12 0 128 0 0"', file.read(500))
        result = case.run("toVTK", "-extended", "-derived")
        self.assertEqual(result.returncode, 2, result.stderr)

    def test_what_it_refuses(self):
        case = self.channel()
        case.put("system/schemes", "kernel { type gaussian; }\ncontinuation { type polynomial; points 200; }\n")
        self.assertIn("system/schemes:2: continuation.points: needs 200 points at each end, but axis y has 101",
                      self.refusal(case))
        case.put("system/schemes", "kernel { type gaussian; }\ncontinuation { extension 400; }\n")
        self.assertIn("system/schemes:2: continuation.extension: is 400 new points on axis y",
                      self.refusal(case))
        self.assertEqual(os.listdir(case.path("0")), ["f"])
        case.put("system/schemes", "kernel { type gaussian; }\n")
        case.put("0/g", header("g", "latticeScalarField") + FIELD)
        self.assertIn("exact: does not tell which of f, g it is for",
                      self.refusal(case, "-derivatives"))
        case = self.channel(patches="a { type periodic; axis x; } b { type periodic; axis y; }")
        self.assertIn("has no bounded axis: there is nothing to continue", self.refusal(case))


if __name__ == "__main__":
    unittest.main()
