"""The sweeps of the tutorials with their reduced lists: orders, and errors of the largest run, are what they should be.

    test_workPrecision.py TUTORIAL
"""
import csv
import os
import subprocess
import sys
import tempfile
import unittest

from cases import ROOT, program, run

# Variant: order in N and how far it may be off, or None; the error of the largest run may be at most so much. Orders of exact
# solutions are those of the scheme (docs/theory), within what coarse lattices leave of them; where a scheme is not in its
# asymptotic range on so few points only the error is bounded, 5 % above what it is.
EXPECTED = {
    "taylorGreen2D": {
        "gaussian4": (4, 0.15, 2.1e-5), "quinticSpline": (2, 0.15, 5e-3), "firstOrder": (1, 0.15, 4.1e-4),
        "gaussian10": (None, None, 3.3e-11), "integratingFactor": (10, 0.15, 1e-12), "paper2021": (None, None, 9.4e-6),
    },
    "movingTaylorGreen2D": {
        "gaussian4": (4, 0.2, 2.44e-3), "exact": (3, 0.1, 3.4e-7), "firstOrder": (1, 0.15, 1.72e-2),
        "meanFlow": (10, 0.15, 1e-10), "gaussian10": (None, None, 3.4e-7), "quinticSpline": (None, None, 9.6e-2),
        "paper2021": (4, 0.2, 2.4e-3),
    },
    "gresho": {
        # The vorticity jumps: about order 1.5 for every scheme.
        "gaussian10": (1.5, 0.35, 1.47e-2), "exact": (1.5, 0.35, 1.42e-2), "gaussian4": (1.5, 0.35, 1.48e-2),
        "quinticSpline": (1.5, 0.35, 8.8e-3), "rotational4": (1.5, 0.35, 8.5e-3), "paper2021": "diverged",
    },
    "doubleShearLayer": {
        "gaussian4": (None, None, 6e-4), "gaussian10": (None, None, 1.42e-2), "gaussian20": (None, None, 1.73e-2),
        "exact": (None, None, 1.73e-2), "quinticSpline": (None, None, 0.171), "rotational": (None, None, 2.14e-2),
    },
    "poiseuille": {
        "degree3": (4, 0.15, 1.97e-6), "degree4": (5, 0.25, 9.8e-8), "degree5": (6, 0.35, 9e-9),
        "gaussian4": (None, None, 2.1e-7), "CrankNicolson": (None, None, 9.5e-7), "paper2021": (2, 0.45, 6.5e-4),
    },
    "couette": {
        "degree3": (4, 0.15, 1.39e-6), "degree4": (5, 0.25, 1.62e-7), "degree5": (6, 0.35, 1.57e-8),
        "gaussian4": (None, None, 1.28e-6), "CrankNicolson": (None, None, 1.15e-6), "paper2021": (2, 0.2, 1.03e-4),
    },
    "cavity": {
        "degree4": (None, None, 0.119), "degree3": (None, None, 0.137), "filtered3": (None, None, 0.102),
        "gaussian4": (None, None, 0.34), "paper2021": "diverged",
    },
    "dipoleWall": {
        "degree4": (None, None, 1.91e-2), "degree3": (None, None, 1.9e-3), "filtered3": (None, None, 4.1e-3),
        "gaussian4": (None, None, 5.31e-2),
    },
}
NAME = sys.argv[1] if len(sys.argv) > 1 else None


class Sweep(unittest.TestCase):
    def rows(self, name):
        with open(os.path.join(self.case, "postProcessing", "workPrecision", name), encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def test_sweep(self):
        with tempfile.TemporaryDirectory(prefix="continua-") as folder:
            self.case = os.path.join(folder, NAME)
            source = os.path.join(ROOT, "tutorials", "isphFoam", NAME)
            self.assertEqual(run("cloneCase", source, self.case).returncode, 0)
            result = run("workPrecision", "-case", self.case, "-reduced")
            self.assertEqual(result.returncode, 0, result.stderr + result.stdout)
            runs, slopes = self.rows("workPrecision.csv"), self.rows("slopes.csv")
            self.assertEqual({row["variant"] for row in runs}, set(EXPECTED[NAME]))
            # The first measure is the one that counts; it stands behind the status.
            measure = list(runs[0])[list(runs[0]).index("status") + 1]
            for variant, expected in EXPECTED[NAME].items():
                with self.subTest(variant):
                    last = [row for row in runs if row["variant"] == variant][-1]
                    if expected == "diverged":
                        self.assertEqual(last["status"], "diverged")
                        self.assertIn("diverged at t = ", last["message"])
                        continue
                    order, slack, bound = expected
                    self.assertEqual(last["status"], "done", last["message"])
                    self.assertLessEqual(float(last[measure]), bound)
                    if order is None:
                        continue
                    found = [row["order"] for row in slopes if row["variant"] == variant and row["quantity"] == measure
                             and row["order"]]
                    self.assertAlmostEqual(float(found[0]), order, delta=slack)
            published = subprocess.run([program("publishResults"), "-to", os.path.join(folder, "results"), self.case],
                                       text=True, capture_output=True, check=False)
            self.assertEqual(published.returncode, 0, published.stderr)
            with open(os.path.join(folder, "results", NAME + ".md"), encoding="utf-8") as file:
                page = file.read()
            self.assertIn("(reduced lists)", page)
            for variant in EXPECTED[NAME]:
                self.assertIn(f"| {variant} |", page)


if __name__ == "__main__":
    if NAME not in EXPECTED:
        sys.exit(f"name one of {', '.join(EXPECTED)}")
    unittest.main(argv=sys.argv[:1])
