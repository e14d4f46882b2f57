"""checkCase: what it says of good cases, every slip in one go, warnings. Its limits: test_stabilityLimits.py."""
import json
import os
import re
import unittest

from cases import CaseTest, header, run


class Checked(CaseTest):
    def report(self, case, code=0):
        """What checkCase -json says; nothing else may be on standard output, and nothing may be written."""
        before = case.state()
        result = case.run("checkCase", "-json")
        self.assertEqual(result.returncode, code, result.stderr + result.stdout)
        self.assertEqual(case.state(), before, "something was written")
        if code == 0:
            self.assertEqual(result.stderr, "")
        return json.loads(result.stdout)

    def schemes(self, case, kernel, rest=""):
        case.put("system/schemes", header("schemes") + f"kernel {{ {kernel} }}\n{rest}\n")

    def warning(self, report, *parts):
        """The warning that holds all parts."""
        for warning in report["warnings"]:
            if all(part in warning for part in parts):
                return warning
        raise AssertionError(f"no warning with {parts} in {report['warnings']}")


class Reports(Checked):
    def test_a_good_case(self):
        case = self.ready_case()
        report = self.report(case)
        self.assertTrue(report["ok"])
        self.assertEqual(report["errors"], [])
        self.assertEqual(report["notLookedAt"], [])
        self.assertEqual(report["warnings"], [])
        self.assertEqual(report["lattice"], {"points": [24, 24, 1], "spacing": [1 / 24, 1 / 24],
                                             "axes": ["periodic", "periodic"], "fastTransforms": True})
        self.assertEqual(report["transformsPerSubstep"], 4)
        self.assertEqual(report["substepsPerStep"], 3)
        self.assertEqual(report["schemes"]["kernel.order"], "6")
        self.assertEqual(report["schemes"]["viscous"], "integratingFactor")
        self.assertIn("viscous", report["defaults"])
        self.assertNotIn("kernel.order", report["defaults"])
        self.assertIn("filter", report["leftOut"])
        stability = report["stability"]
        self.assertIsNone(stability["viscousNumber"])
        self.assertEqual(stability["deltaT"], 0.005)
        self.assertEqual(stability["steps"], 40)
        self.assertEqual(stability["ruling"], "convective")

    def test_the_text_says_the_same(self):
        case = self.ready_case()
        said = self.succeeds(case, "checkCase").stdout
        report = self.report(case)
        for part in ("Active", "Left out", "Schemes", "Solution", "Resolution of the kernel", "Cost", "Time steps",
                     "4 a substep, 12 a step", "The case can run."):
            self.assertIn(part, said)
        for item in report["active"] + report["leftOut"]:
            self.assertIn(item, said)
        for key, value in report["schemes"].items():
            self.assertRegex(said, rf"{re.escape(key)} +{re.escape(value)}\b")
        place = f"system/schemes:{case.line_of('system/schemes', 'order 6')}"
        self.assertRegex(said, rf"kernel\.order +6 +{place}\n")
        self.assertRegex(said, r"kernel\.symbol +closed +default\n")
        self.assertEqual(case.run("checkCase", "-quiet").stdout, "")

    def test_every_choice_of_a_preset_is_said_to_be_one(self):
        case = self.ready_case()
        case.put("system/schemes", header("schemes") + "preset paper2021;\nconvection rotational;\n")
        report = self.report(case)
        self.assertEqual(report["schemes"]["kernel.symbol"], "sampled")
        self.assertEqual(report["schemes"]["p.eigenvalues"], "exact")
        self.assertEqual(report["schemes"]["convection"], "rotational")
        said = self.succeeds(case, "checkCase").stdout
        self.assertRegex(said, r"kernel\.order +4 +preset paper2021\n")
        self.assertRegex(said, r"convection +rotational +system/schemes:\d+\n")
        # Sampled with 4h, h/dx 2: 193 neighbours within the open disc, four more on its rim.
        self.assertEqual(report["kernel"]["neighbours"], 197)
        self.assertAlmostEqual(report["kernel"]["longWaveError"] / 3.7e-5, 1, delta=0.02)

    def test_resolution_of_a_kernel(self):
        case = self.ready_case()
        self.schemes(case, "type gaussian; order 10; smoothingLength 1.5;")
        kernel = self.report(case)["kernel"]
        self.assertAlmostEqual(kernel["h"][0], 1.5 / 24)
        # Half height near s = n - 1/3: k dx = 2 sqrt(14/3)/1.5.
        self.assertAlmostEqual(kernel["cutOff"], 2 * (14 / 3) ** 0.5 / 1.5 / 3.14159, delta=2e-3)
        # Relative errors s^n/n! and s^n/(n + 1)! for small s = (h k)^2/4.
        wave = kernel["waves"][-1]
        s = (1.5 * 2 * 3.141592653589793 / wave["pointsPerWavelength"]) ** 2 / 4
        self.assertAlmostEqual(wave["gradientError"] / (s**5 / 120), 1, delta=0.3)
        self.assertAlmostEqual(wave["laplacianError"] / (s**5 / 720), 1, delta=0.3)
        self.schemes(case, "type exact;")
        kernel = self.report(case)["kernel"]
        self.assertIsNone(kernel["cutOff"])
        self.assertEqual([wave["gradientError"] for wave in kernel["waves"]], [0, 0, 0])

    def test_annotated_dictionaries(self):
        case = self.case()
        for name, key in (("schemes", "smoothingLength"), ("solution", "eigenvalues"), ("controlDict", "safetyFactor"),
                          ("latticeDict", "arrangement"), ("transportProperties", "bodyForce"),
                          ("sampleDict", "nPoints")):
            with self.subTest(name):
                text = run("checkCase", "-annotated", name).stdout
                self.assertIn(key, text)
                case.put("annotated", text)
                self.succeeds(case, "caseDict", "annotated", "-keywords")
        result = run("checkCase", "-annotated", "scheme")
        self.assertEqual(result.returncode, 2)
        self.assertIn("known are: schemes", result.stderr)

    def test_listings(self):
        self.assertIn("quinticSpline", run("checkCase", "-listKernels").stdout)

    def test_memory_is_that_of_a_run(self):
        for dimensions, schemes in ((2, ""), (2, "convection rotational; viscous explicit;"), (3, "")):
            with self.subTest(dimensions=dimensions, schemes=schemes):
                case = self.case(endTime=0.01, functions="", schemes=schemes)
                points = "(384 384 1)" if dimensions == 2 else "(48 48 48)"
                case.replace("system/latticeDict", "(24 24 1)", points)
                if dimensions == 3:
                    case.replace("system/latticeDict", "extent (1 1 0)", "extent (1 1 1)")
                    case.replace("system/latticeDict", "ySides", "zSides { type periodic; axis z; }\n    ySides")
                    for field in ("0/U", "0/p"):
                        case.replace(field, "ySides", "zSides { type periodic; }\n    ySides")
                self.succeeds(case, "makeLattice")
                expected = self.report(case)["memory"]
                self.succeeds(case, "isphFoam")
                self.assertAlmostEqual(case.report()["peakMemory"] / expected, 1, delta=0.25)

    def test_the_step_is_that_of_the_run(self):
        for schemes, control in ((("viscous explicit;"), "safetyFactor 0.7;"), ("meanFlow none;", ""),
                                 ("time firstOrderProjection;", "maxCo 0.05;")):
            with self.subTest(schemes):
                case = self.ready_case(deltaT="auto", endTime=0.5, schemes=schemes, control=control, functions="",
                                       writeInterval="endTime")
                expected = self.report(case)["stability"]
                said = self.succeeds(case, "isphFoam", "-verbose").stdout
                first = float(re.search(r"deltaT = (\S+)", said).group(1))
                self.assertAlmostEqual(expected["deltaT"] / first, 1, delta=1e-5)
                self.assertTrue(expected["automatic"])
                steps = case.report()["steps"]
                # The vortex slows down to exp(-8 pi^2 nu t) = 0.67, and steps grow by as much.
                self.assertLessEqual(steps, expected["steps"])
                self.assertGreater(steps, 0.66 * expected["steps"])

    def test_a_restart_is_seen(self):
        case = self.ready_case()
        self.succeeds(case, "isphFoam")
        report = self.report(case)
        self.assertEqual(report["startFolder"], "0.2")
        self.assertEqual(report["stability"]["deltaT"], 0)
        self.warning(report, "endTime", "nothing to do")


class Slips(Checked):
    def test_every_wrong_file_is_named_in_one_go(self):
        case = self.ready_case()
        case.replace("system/schemes", "order 6", "ordr 6")
        case.replace("system/solution", "fft", "ftt")
        case.replace("system/controlDict", "writeInterval 10", "writeIntervall 10")
        case.replace("system/sampleDict", "spectral", "spectrall")
        case.replace("constant/transportProperties", "0.01", "-0.01")
        result = case.run("checkCase")
        self.assertEqual(result.returncode, 1)
        for place in ("system/schemes", "system/solution", "system/controlDict", "system/sampleDict",
                      "constant/transportProperties"):
            self.assertIn(f"checkCase: {place}:", result.stderr)
        self.assertIn("The case cannot run: 5 errors.", result.stdout)
        self.assertIn("fields of time 0", result.stdout)

    def test_schemes_and_fields(self):
        case = self.ready_case()
        case.replace("system/schemes", "order 6", "order 7")
        case.replace("0/U", "xSides {", "xSide {")
        case.replace("0/p", "xSides { type periodic; }", "xSides { type wall; }")
        report = self.report(case, 1)
        self.assertFalse(report["ok"])
        errors = {error["file"]: error for error in report["errors"]}
        self.assertEqual(set(errors), {"system/schemes", "0/U", "0/p"})
        self.assertEqual(errors["system/schemes"]["line"], case.line_of("system/schemes", "order 7"))
        self.assertEqual(errors["system/schemes"]["entry"], "kernel.order")
        self.assertIsNone(report["stability"])

    def test_expressions_and_functions(self):
        case = self.ready_case()
        case.replace("0/U", "sin", "sinn")
        case.replace("0/p", "cos", "1/0*cos")
        case.replace("system/controlDict", "type flowStatistics", "type flowStatistic")
        errors = self.report(case, 1)["errors"]
        self.assertEqual({error["file"] for error in errors}, {"0/U", "0/p", "system/controlDict"})

    def test_values_that_are_not_finite(self):
        case = self.ready_case()
        case.put("0/U", re.sub(r"internalField.*;", 'internalField expression ("1/(x - x)" "0" "0");',
                               case.text("0/U")))
        errors = self.report(case, 1)["errors"]
        self.assertEqual([error["file"] for error in errors], ["0/U"])
        self.assertIn("finite", errors[0]["what"])

    def test_a_missing_lattice_does_not_hide_the_rest(self):
        case = self.case()
        case.replace("0/U", "xSides {", "xSide {")
        report = self.report(case, 1)
        self.assertEqual([error["file"] for error in report["errors"][:1]], ["constant/lattice"])
        self.assertIn("makeLattice", report["errors"][0]["advice"])
        self.assertIn("0/U", [error["file"] for error in report["errors"]])
        self.assertEqual(report["lattice"]["points"], [24, 24, 1])

    def test_missing_files_are_all_named(self):
        case = self.ready_case()
        missing = ["system/schemes", "system/solution", "constant/transportProperties", "0/p"]
        for relative in missing:
            os.remove(case.path(relative))
        errors = self.report(case, 1)["errors"]
        for relative in missing[:3]:
            self.assertIn(relative, [error["file"] for error in errors])

    def test_no_case_at_all(self):
        case = self.case()
        case.remove()
        result = case.run("checkCase", "-json")
        self.assertEqual(result.returncode, 1)
        self.assertFalse(json.loads(result.stdout)["ok"])
        self.assertIn("vortex", result.stderr)

    def test_what_cannot_run_in_the_solver_cannot_run_here(self):
        for relative, old, new in (("system/controlDict", "endTime 0.2", "endTime -1"),
                                   ("system/schemes", "kernel {", "operators directSum; viscous integratingFactor;\n"
                                                                  "kernel { symbol sampled;"),
                                   ("constant/transportProperties", "0.01;", "0; // "),
                                   ("0/p", "[0 2 -2 0 0 0 0]", "[0 2 -1 0 0 0 0]")):
            with self.subTest(relative):
                case = self.ready_case()
                case.replace(relative, old, new)
                if relative == "constant/transportProperties":
                    case.replace("system/schemes", "kernel {", "time firstOrderProjection;\nkernel {")
                errors = self.report(case, 1)["errors"]
                refused = case.run("isphFoam")
                self.assertEqual(refused.returncode, 1)
                self.assertIn(f"{errors[0]['file']}:{errors[0]['line']}:", refused.stderr)
                self.assertIn(errors[0]["what"], refused.stderr)


class Warnings(Checked):
    def test_a_step_above_the_limit(self):
        case = self.ready_case(deltaT="0.1", endTime=1)
        report = self.report(case)
        limit = report["stability"]["largestStableStep"]
        self.assertLess(limit, 0.1)
        said = self.warning(report, "deltaT", "convective")
        self.assertIn(f"{limit:.4g}", said)
        self.schemes(case, "type gaussian; order 6;", "viscous explicit;")
        case.replace("constant/transportProperties", "0.01", "1")
        self.warning(self.report(case), "deltaT", "viscous")
        self.assertIn("checkCase: warning: deltaT", case.run("checkCase", "-quiet").stderr)

    def test_waves_that_viscosity_makes_grow(self):
        case = self.ready_case()
        self.schemes(case, "type quinticSpline; smoothingLength 1.5;", "laplacian secondDerivative; dealiasing none;")
        self.warning(self.report(case), "anti-diffusive", "laplacian morris;")
        self.schemes(case, "type quinticSpline; smoothingLength 1.5;", "dealiasing none;")
        self.assertEqual(self.report(case)["warnings"], [])
        # Dealiasing drops the waves that would grow.
        self.schemes(case, "type quinticSpline; smoothingLength 1.5;", "laplacian secondDerivative;")
        self.assertEqual(self.report(case)["warnings"], [])

    def test_samples_that_miss_their_moments(self):
        case = self.ready_case()
        self.schemes(case, "type gaussian; order 10; symbol sampled; smoothingLength 1.3; supportRadius 4;")
        self.warning(self.report(case), "supportRadius")
        self.schemes(case, "type gaussian; order 10; symbol sampled;")
        self.assertEqual(self.report(case)["warnings"], [])

    def test_slow_transforms(self):
        case = self.ready_case(points=46)
        report = self.report(case)
        self.assertFalse(report["lattice"]["fastTransforms"])
        self.warning(report, "46", "45", "48")

    def test_a_lattice_that_is_not_the_one_asked_for(self):
        case = self.ready_case()
        case.replace("system/latticeDict", "(24 24 1)", "(32 32 1)")
        self.warning(self.report(case), "makeLattice -overwrite")
        case.replace("system/latticeDict", "count", "cuont")
        self.warning(self.report(case), "system/latticeDict:")

    def test_entries_without_effect(self):
        case = self.ready_case(control="safetyFactor 0.5;\nmaxCo 0.5;\nwriteFormat ascii;")
        case.put("system/schemes", header("schemes") + "\n".join((
            "kernel { type quinticSpline; order 4; symbol closed; renormalise yes; }",
            "filter { strength 30; }", "continuation { type gram; }", "walls paper;", "meanFlow none;")))
        case.replace("system/solution", "solver fft;", "solver fft; tolerance 1e-8; preconditioner jacobi;")
        case.replace("constant/transportProperties", "rho", "DT [0 2 -1 0 0 0 0] 1;\nrho")
        idle = {f"{entry['file']}: {entry['entry']}": entry for entry in self.report(case)["withoutEffect"]}
        expected = {"system/schemes: kernel.order", "system/schemes: kernel.symbol", "system/schemes: filter.strength",
                    "system/schemes: continuation", "system/schemes: walls", "system/solution: p.tolerance",
                    "system/solution: p.preconditioner", "constant/transportProperties: DT",
                    "constant/transportProperties: rho", "system/controlDict: startTime",
                    "system/controlDict: safetyFactor", "system/controlDict: maxCo", "system/controlDict: writeFormat"}
        self.assertEqual(set(idle), expected)
        self.assertEqual(idle["system/schemes: walls"]["line"], case.line_of("system/schemes", "walls"))
        said = self.succeeds(case, "checkCase").stdout
        self.assertIn("Written, but without effect here", said)
        # What an expression uses has an effect.
        case.replace("0/p", "-0.25*", "-0.25*rho*")
        self.assertNotIn("rho", [entry["entry"] for entry in self.report(case)["withoutEffect"]])


if __name__ == "__main__":
    unittest.main()
