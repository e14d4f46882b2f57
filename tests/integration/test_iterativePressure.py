"""The classical iterative pressure through the programs: log, report, restart, what checkCase says, what is refused."""
import json
import os
import re
import unittest

from cases import CaseTest, header, run
from tutorials import Tutorial

KERNEL = ("kernel { type gaussian; order 4; smoothingLength 2; symbol sampled; supportRadius 4; }\n"
          "dealiasing none; meanFlow none; convection advective; viscous explicit;\n")
CLASSICAL = KERNEL + "operators directSum;"
LINE = re.compile(r"^(BiCGStab|CG):  Solving for p, Initial residual = (\S+), Final residual = (\S+), No Iterations (\d+)$",
                  re.M)


class Iterated(CaseTest):
    def vortex(self, solution, schemes=KERNEL, **settings):
        case = self.case(**settings)
        case.put("system/schemes", schemes)
        case.put("system/solution", f"p {{ {solution} }}\n")
        self.succeeds(case, "makeLattice")
        return case

    def errors(self, case):
        self.succeeds(case, "isphFoam")
        return float(case.table("errors")[-1]["relL2(U)"])

    def test_log_and_report(self):
        case = self.vortex("solver BiCGStab;")
        result = self.succeeds(case, "isphFoam", "-verbose")
        lines = LINE.findall(result.stdout)
        report = case.report()
        self.assertEqual(len(lines), report["steps"])
        for name, initial, final, iterations in lines:
            self.assertEqual(name, "BiCGStab")
            self.assertLessEqual(float(final), 1e-10)
            self.assertLess(float(final), float(initial))
            self.assertLessEqual(float(initial), 1)
            self.assertGreater(int(iterations), 0)
        pressure = report["pressureSolver"]
        self.assertEqual(pressure["name"], "BiCGStab")
        self.assertEqual(pressure["solves"], 3 * report["steps"])
        self.assertGreaterEqual(pressure["iterations"]["max"], pressure["iterations"]["mean"])
        self.assertGreaterEqual(pressure["iterations"]["max"], max(int(line[3]) for line in lines))
        self.assertLessEqual(pressure["finalResidual"]["max"], 1e-10)
        self.assertEqual(pressure["notConverged"], 0)
        self.assertGreater(report["seconds"]["poisson"], 0)
        self.assertEqual(report["schemes"]["solver"], "BiCGStab")
        self.assertEqual(report["schemes"]["eigenvalues"], "morris")

    def test_a_run_by_transforms_has_nothing_of_it(self):
        case = self.vortex("solver fft;")
        result = self.succeeds(case, "isphFoam", "-verbose")
        self.assertNotIn("Solving for p", result.stdout)
        self.assertNotIn("pressureSolver", case.report())

    def test_same_errors_as_by_transforms(self):
        exact = self.errors(self.vortex("solver fft; eigenvalues morris;"))
        for solution, schemes in (("solver BiCGStab;", KERNEL), ("solver CG; preconditioner none;", KERNEL),
                                  ("solver BiCGStab;", CLASSICAL)):
            with self.subTest(solution=solution, schemes=schemes):
                self.assertAlmostEqual(self.errors(self.vortex(solution, schemes)) / exact, 1, delta=1e-6)

    def test_transforms_are_counted(self):
        for schemes in (KERNEL, CLASSICAL):
            case = self.vortex("solver CG;", schemes)
            foreseen = json.loads(self.succeeds(case, "checkCase", "-json").stdout)["transformsPerSubstep"]
            self.succeeds(case, "isphFoam")
            # The start makes the first inputs, and writing none.
            self.assertAlmostEqual(case.report()["transformsPerSubstep"], foreseen, delta=0.1)

    def test_restart_in_the_same_bits(self):
        for schemes in (KERNEL, CLASSICAL):
            with self.subTest(schemes=schemes):
                settings = dict(endTime=0.1, writeControl="runTime", writeInterval="0.05")
                whole = self.vortex("solver BiCGStab; tolerance 1e-5;", schemes, **settings)
                self.succeeds(whole, "isphFoam")
                parts = self.vortex("solver BiCGStab; tolerance 1e-5;", schemes, **settings)
                parts.set("system/controlDict", "endTime", "0.05")
                self.succeeds(parts, "isphFoam")
                parts.set("system/controlDict", "endTime", "0.1")
                self.succeeds(parts, "isphFoam")
                self.same_state(parts, parts.times()[-1], whole, whole.times()[-1])

    def test_too_few_iterations_are_a_warning_and_the_run_goes_on(self):
        case = self.vortex("solver BiCGStab; maxIter 2;", endTime=0.05)
        result = self.succeeds(case, "isphFoam")
        self.assertEqual(result.stderr.count("did not reach its tolerance"), 1)
        report = case.report()
        self.assertGreater(report["pressureSolver"]["notConverged"], 1)
        self.assertEqual(report["pressureSolver"]["iterations"]["max"], 2)
        self.assertIn(f"{report['pressureSolver']['notConverged']} times", result.stdout + result.stderr)

    def test_checkCase_knows_the_matrix(self):
        case = self.vortex("solver BiCGStab;", points=200, endTime=0.005, functions="")
        check = json.loads(self.succeeds(case, "checkCase", "-json").stdout)
        active = next(part for part in check["active"] if part.startswith("pressure: "))
        self.assertIn("BiCGStab, preconditioner jacobi, tolerance 1e-10, at most 1000 iterations, 197 neighbours", active)
        self.assertIn("matrix of 94.6 MB", active)
        self.succeeds(case, "isphFoam")
        self.assertAlmostEqual(case.report()["peakMemory"] / check["memory"], 1, delta=0.25)

    def test_a_closed_kernel_is_sampled_for_it(self):
        case = self.vortex("solver CG; eigenvalues exact;", "kernel { type gaussian; order 6; smoothingLength 1.5; }",
                           endTime=0.02)
        check = json.loads(self.succeeds(case, "checkCase", "-json").stdout)
        self.assertTrue(any("the kernel sampled to 6h" in part for part in check["active"]), check["active"])
        idle = {entry["entry"]: entry["why"] for entry in check["withoutEffect"]}
        self.assertEqual(idle["p.eigenvalues"], "the solver CG has its own")
        self.succeeds(case, "isphFoam")

    def test_matrices_beyond_counting_are_refused_before_they_are_made(self):
        case = self.vortex("solver CG;", "kernel { type gaussian; order 4; smoothingLength 40; symbol sampled; }",
                           points=600)
        for program in ("isphFoam", "checkCase"):
            result = case.run(program)
            self.assertEqual(result.returncode, 1)
            self.assertIn("system/solution:1: p.solver: the matrix of the pressure would have more than 2147 million",
                          result.stderr + result.stdout)

    def test_words(self):
        self.assertIn("BiCGStab", run("isphFoam", "-listPressureSolvers").stdout)
        self.assertIn("jacobi", run("isphFoam", "-listPreconditioners").stdout)


class BetweenWalls(CaseTest):
    def lid(self, schemes, solution, arrangement):
        case = self.case(endTime=0.1, deltaT="0.01", functions="")
        case.put("system/latticeDict", f"""origin (0 0 0);
extent (1 1 0);
intervals (20 20 0);
arrangement {arrangement};
patches
{{
    lid {{ type wall; face yMax; }}
    walls {{ type wall; faces (xMin xMax yMin); }}
}}
""")
        case.put("0/U", 'dimensions [0 1 -1 0 0 0 0];\ninternalField uniform (0 0 0);\nboundaryField\n{\n'
                        'lid { type fixedValue; value expression ("16*(x*(1-x))^2" "0" "0"); }\n'
                        'walls { type noSlip; }\n}\n')
        case.put("0/p", "dimensions [0 2 -2 0 0 0 0];\ninternalField uniform 0;\nboundaryField\n{\n"
                        "lid { type zeroGradient; }\nwalls { type zeroGradient; }\n}\n")
        case.put("system/schemes", "kernel { type gaussian; order 4; smoothingLength 2; }\nviscous explicit;\n" + schemes)
        case.put("system/solution", f"p {{ {solution} }}\n")
        os.remove(case.path("system/sampleDict"))
        self.succeeds(case, "makeLattice")
        return case

    def test_goes_as_by_transforms(self):
        for schemes, arrangement in (("", "staggered"), ("continuation { type mirror; }", "collocated")):
            with self.subTest(arrangement=arrangement):
                fft, iterated = (self.lid(schemes, solution, arrangement)
                                 for solution in ("solver fft; eigenvalues morris;", "solver CG;"))
                self.succeeds(fft, "isphFoam")
                result = self.succeeds(iterated, "isphFoam")
                self.assertRegex(result.stdout, LINE)
                self.assertNotIn("mirrors its neighbours", result.stderr)
                self.assertEqual(iterated.report()["pressureSolver"]["solves"], 30)
                a, b = (self.numbers(case.values("0.1")) for case in (fft, iterated))
                self.assertEqual(len(a), len(b))
                largest = max(abs(x - y) for x, y in zip(a, b))
                self.assertLessEqual(largest, 1e-8)
                self.assertGreater(max(a), 0.1)

    def test_checkCase_knows_what_mirrored_walls_need(self):
        case = Tutorial("ductFlow3D")
        self.addCleanup(case.remove)
        case.set("system/latticeDict", "intervals", "(20 32 32)")
        case.put("system/schemes", header("schemes") + "kernel { type gaussian; order 4; smoothingLength 2; symbol sampled; "
                 "supportRadius 4; }\ncontinuation { type mirror; }\nviscous explicit;\n")
        case.put("system/solution", header("solution") + "p { solver fft; eigenvalues morris; }\n")
        case.set("system/controlDict", "endTime", "0.001")
        case.set("system/controlDict", "deltaT", "0.001")
        self.succeeds(case, "makeLattice")
        memory = json.loads(self.succeeds(case, "checkCase", "-json").stdout)["memory"]
        self.succeeds(case, "isphFoam")
        self.assertAlmostEqual(case.report()["peakMemory"] / memory, 1, delta=0.25)

    def test_says_when_the_continuation_does_not_mirror(self):
        case = self.lid("", "solver CG; maxIter 5;", "collocated")
        case.set("system/controlDict", "endTime", "0.01")
        result = self.succeeds(case, "isphFoam")
        self.assertIn("continuation { type mirror; }", result.stderr)
        check = json.loads(self.succeeds(case, "checkCase", "-json").stdout)
        self.assertTrue(any("continuation { type mirror; }" in warning for warning in check["warnings"]))

    @staticmethod
    def numbers(text):
        return [float(number) for number in re.findall(r"-?\d+\.?\d*(?:e[-+]\d+)?", text.split("}", 1)[0])]


if __name__ == "__main__":
    unittest.main()
