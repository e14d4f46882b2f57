"""checkStability on every tutorial of isphFoam, on coarse lattices: predictions and trials agree."""
import json
import os
import unittest

from cases import ROOT, CaseTest
from tutorials import Tutorial

LATTICES = {  # tutorial: entry of latticeDict and its value; without: the lattice it has
    "beltrami3D": ("count", "(16 16 16)"),
    "cavity": ("intervals", "(32 32 0)"),
    "channelInletOutlet": ("intervals", "(64 16 0)"),
    "channelManufactured": ("intervals", "(24 24 0)"),
    "couette": None,
    "dipoleWall": ("intervals", "(48 48 0)"),
    "doubleShearLayer": ("count", "(64 64 1)"),
    "doubleVortexChannel": ("intervals", "(48 24 0)"),
    "ductFlow3D": ("intervals", "(8 16 16)"),
    "gresho": None,
    "movingTaylorGreen2D": None,
    "oscillatingWall": ("intervals", "(8 40 0)"),
    "poiseuille": None,
    "taylorGreen2D": ("count", "(40 40 1)"),
    "taylorGreen3D": ("count", "(16 16 16)"),
}


class EveryTutorial(CaseTest):
    def test_agrees(self):
        self.assertEqual(sorted(LATTICES), sorted(os.listdir(os.path.join(ROOT, "tutorials", "isphFoam"))))
        for name, lattice in LATTICES.items():
            with self.subTest(name):
                case = Tutorial(name)
                self.addCleanup(case.remove)
                if lattice:
                    case.set("system/latticeDict", *lattice)
                self.succeeds(case, "makeLattice")
                result = case.run("checkStability", "-json")
                self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
                report = json.loads(result.stdout)
                self.assertTrue(report["agree"])
                self.assertFalse(report["modesGrow"])
                for term in report["terms"]:
                    for row in term["trials"]:
                        if row["fraction"] <= 1 and "note" in term and not term["note"]:
                            self.assertEqual(row["observed"], "stable", (term["term"], row))
                        # Every term has a step that is too long, but for implicit ones and the case's own flow.
                        if row["fraction"] == 2 and term["term"] in ("convective", "viscous"):
                            self.assertEqual(row["observed"], "unstable", (term["term"], row))


if __name__ == "__main__":
    unittest.main()
