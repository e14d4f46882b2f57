"""checkStability: what it predicts of the schemes of a case, and that trials bear it out."""
import json
import os
import unittest

from cases import ROOT, CaseTest, header, run
from tutorials import Tutorial


class CheckStability(CaseTest):
    def report(self, case, *arguments, code=0):
        result = case.run("checkStability", "-json", *arguments)
        self.assertEqual(result.returncode, code, result.stdout + result.stderr)
        return json.loads(result.stdout)

    def tutorial(self, name, points, schemes=None, entry="intervals"):
        case = Tutorial(name)
        self.addCleanup(case.remove)
        case.set("system/latticeDict", entry, points)
        if schemes is not None:
            case.put("system/schemes", header("schemes") + schemes)
        self.succeeds(case, "makeLattice")
        return case

    def rows(self, report, term):
        """Rows of a term by their fraction."""
        found = [t for t in report["terms"] if t["term"] == term]
        self.assertEqual(len(found), 1, [t["term"] for t in report["terms"]])
        return {row["fraction"]: row for row in found[0]["trials"]}

    def check_sharp(self, rows, above=1.03):
        self.assertEqual(rows[0.98]["observed"], "stable")
        self.assertEqual(rows[above]["observed"], "unstable")
        for row in rows.values():
            self.assertTrue(row["agree"])

    def test_periodic_box(self):
        case = self.tutorial("taylorGreen2D", "(24 24 1)", entry="count")
        before = case.state()
        report = self.report(case)
        self.assertEqual(case.state(), before)
        self.assertTrue(report["agree"])
        self.assertFalse(report["modesGrow"])
        for term in ("convective", "viscous"):
            rows = self.rows(report, term)
            self.check_sharp(rows)
            # Modes are the flow: its growth is theirs.
            self.assertAlmostEqual(rows[1.03]["growth"], rows[1.03]["predictedGrowth"], delta=0.005)
        self.assertEqual(self.rows(report, "own start")[0.98]["observed"], "stable")
        limits = json.loads(self.succeeds(case, "checkCase", "-json").stdout)["stability"]
        self.assertAlmostEqual(report["courant"], limits["courant"])
        self.assertAlmostEqual(report["viscousNumber"], limits["viscousNumber"])

    def test_integrating_factor_and_filter(self):
        case = self.tutorial("doubleShearLayer", "(24 24 1)", entry="count")
        rows = self.rows(self.report(case), "implicit viscous")
        self.assertEqual(sorted(rows), [1, 100, 1e4])
        self.assertTrue(all(row["observed"] == "stable" for row in rows.values()))
        # A flow that comes to rest in steps that grow with it, before a trial is through: what was seen counts.
        case.put("system/schemes", header("schemes") + "kernel { type gaussian; order 4; }\n")
        case.set("constant/transportProperties", "nu", "0.5")
        rows = self.rows(self.report(case), "own start")
        self.assertLess(rows[0.5]["steps"], 100)
        self.assertLess(rows[0.5]["growth"], 0.98)
        case = self.tutorial("gresho", "(24 24 1)", entry="count")
        report = self.report(case)
        self.assertIn("viscous: the fluid has no viscosity", report["leftOut"])

    def test_forward_euler_bears_convection_by_its_viscosity(self):
        case = self.tutorial("taylorGreen2D", "(24 24 1)",
                             "kernel { type gaussian; order 4; }\ntime firstOrderProjection;\n", entry="count")
        report = self.report(case)
        self.assertEqual(report["courant"], 0)
        rows = self.rows(report, "convective")
        self.assertEqual(rows[0.98]["observed"], "stable")
        self.assertEqual(rows[2]["observed"], "unstable")

    def test_channel(self):
        case = self.tutorial("doubleVortexChannel", "(32 16 0)")
        report = self.report(case)
        self.check_sharp(self.rows(report, "convective"))
        self.assertEqual(self.rows(report, "convective")[1.03]["expected"], "unstable")
        self.check_sharp(self.rows(report, "viscous"), above=2)
        self.assertTrue(all(row["observed"] == "stable" for row in self.rows(report, "implicit viscous").values()))
        self.assertAlmostEqual(report["growthAtRest"], 1, delta=0.003)
        self.assertFalse(any(spectrum["grows"] for spectrum in report["spectra"]))

    def test_closed_box(self):
        report = self.report(self.tutorial("cavity", "(16 16 0)"))
        for term in ("convective", "viscous"):
            self.check_sharp(self.rows(report, term), above=2)

    def test_inlet_and_outlet(self):
        report = self.report(self.tutorial("channelInletOutlet", "(32 12 0)"))
        self.check_sharp(self.rows(report, "convective"))

    def test_papers(self):
        report = self.report(self.tutorial("taylorGreen2D", "(24 24 1)", "preset paper2021;\n", entry="count"))
        self.check_sharp(self.rows(report, "convective"))
        # On few points the continuation of the second paper makes viscosity and projection grow: predicted, and so.
        case = self.tutorial("cavity", "(48 48 0)", "preset paper2026;\n")
        report = self.report(case, "-fractions", "(0.5 0.98)")
        self.assertTrue(report["modesGrow"])
        self.assertGreater(report["growthAtRest"], 1.1)
        rows = self.rows(report, "convective")
        self.assertEqual((rows[0.5]["expected"], rows[0.5]["observed"]), ("unstable", "unstable"))
        text = self.succeeds(case, "checkStability", "-noTrials").stdout
        self.assertRegex(text, r"d2/dx2 .* modes at the ends grow in exact time")

    def test_a_limit_that_does_not_hold_is_told(self):
        # Increments of the pressure bear less than the convective term by itself where a box is flowed through.
        case = self.tutorial("cavity", "(24 24 0)", "kernel { type gaussian; order 20; }\nwalls incremental;\n"
                             "viscous explicit;\n")
        result = case.run("checkStability")
        self.assertEqual(result.returncode, 1)
        self.assertRegex(result.stdout, r"stable +unstable +NO")
        self.assertIn("trials contradict", result.stderr)

    def test_options(self):
        case = self.tutorial("poiseuille", "(4 16 0)")
        self.assertNotIn("Trials", self.succeeds(case, "checkStability", "-noTrials").stdout)
        report = self.report(case, "-noTrials")
        self.assertFalse(report["tried"])
        self.assertIsNone(report["agree"])
        self.assertTrue(all(not term["trials"] for term in report["terms"]))
        rows = self.rows(self.report(case, "-fractions", "(1.3 0.7)", "-steps", "200"), "viscous")
        self.assertEqual(list(rows), [0.7, 1.3])
        self.assertLessEqual(rows[0.7]["steps"], 200)
        for arguments in (("-fractions", "()"), ("-fractions", "(1 zwei)"), ("-fractions", "inf"), ("-steps", "3"),
                          ("-steps", "70.5"), ("-steps", "1e12")):
            self.assertEqual(case.run("checkStability", *arguments).returncode, 2, arguments)

    def test_table_of_schemes(self):
        """The page of results is what the program prints."""
        printed = run("checkStability", "-table")
        self.assertEqual(printed.returncode, 0, printed.stderr)
        with open(os.path.join(ROOT, "docs", "results", "stability.md"), encoding="utf-8") as file:
            kept = file.read().split("```\n")[1]
        rows = [[line.split() for line in text.splitlines()] for text in (kept, printed.stdout)]
        self.assertEqual(len(rows[0]), len(rows[1]))
        for expected, found in zip(*rows):
            self.assertEqual(len(expected), len(found), (expected, found))
            for old, new in zip(expected, found):
                try:
                    value = float(old)
                except ValueError:
                    self.assertEqual(old, new, (expected, found))
                else:
                    self.assertAlmostEqual(float(new), value, delta=0.1 * value, msg=f"{expected} {found}")
        table = json.loads(run("checkStability", "-table", "-json").stdout)
        self.assertEqual(table["periodic"][0]["kernel"], "quinticSpline")
        self.assertEqual({row["continuation"] for row in table["walls"] if row["crankNicolson"]
                          and row["kernel"] == "gaussian 20"},
                         {"smoothGram 3", "smoothGram 4", "smoothGram 5", "polynomial 5, a quarter", "mirror"})

    def test_scalars_are_refused(self):
        case = self.tutorial("poiseuille", "(4 16 0)")
        case.set("system/controlDict", "application", "scalarTransportFoam")
        result = case.run("checkStability")
        self.assertEqual(result.returncode, 1)
        self.assertRegex(result.stderr, "system/controlDict:[0-9]+: application: .*tries flows")


if __name__ == "__main__":
    unittest.main()
