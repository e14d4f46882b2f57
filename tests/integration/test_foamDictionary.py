"""OpenFOAM's own parser reads every dictionary that we ship or write."""
import glob
import os
import shutil
import subprocess
import sys
import unittest

from cases import CaseTest, ROOT

FOAM = shutil.which("foamDictionary")
ENVIRONMENT = {**os.environ, "WM_PROJECT_DIR": os.environ.get("WM_PROJECT_DIR", "/usr/share/openfoam"),
               "WM_PROJECT_SITE": ROOT}


class Parsed(CaseTest):
    def parses(self, path):
        result = subprocess.run([FOAM, path], text=True, capture_output=True, env=ENVIRONMENT, timeout=60, check=False)
        self.assertEqual(result.returncode, 0, f"{path}: {result.stderr[-400:]}")

    def test_shipped(self):
        found = [path for pattern in ("tutorials/*/*/0/*", "tutorials/*/*/constant/*", "tutorials/*/*/system/*",
                                      "etc/annotated/*", "etc/solutions/*")
                 for path in sorted(glob.glob(os.path.join(ROOT, pattern)))
                 if os.path.isfile(path) and not path.endswith((".csv", ".md"))]
        self.assertGreater(len(found), 40)
        for path in found:
            with self.subTest(path):
                self.parses(path)

    def test_written(self):
        case = self.ready_case()
        self.succeeds(case, "isphFoam")
        case.set("system/controlDict", "endTime", "0.3")
        for relative in ("constant/lattice", "0.2/U", "0.2/p", "0.2/uniform/time", "system/controlDict"):
            with self.subTest(relative):
                self.parses(case.path(relative))


if __name__ == "__main__":
    if FOAM is None:
        print("OpenFOAM is not installed (Debian package openfoam): its parser was not asked")
        sys.exit(77)
    unittest.main()
