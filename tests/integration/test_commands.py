"""What every program shares: -help, -version, listings, exit code 2 for a wrong command line."""
import os
import re
import unittest

from cases import BIN, CaseTest, ROOT, run

PROGRAMS = sorted(name for name in os.listdir(BIN) if os.access(os.path.join(BIN, name), os.X_OK))


class Commands(CaseTest):
    def test_help_and_version(self):
        self.assertIn("isphFoam", PROGRAMS)
        with open(os.path.join(ROOT, "CMakeLists.txt"), encoding="utf-8") as file:
            version = re.search(r"project\(Continua VERSION ([0-9.]+)", file.read()).group(1)
        for name in PROGRAMS:
            with self.subTest(name):
                for option in ("-help", "--help"):
                    result = run(name, option)
                    self.assertEqual(result.returncode, 0)
                    for part in (name, "-case", "-version", "-quiet"):
                        self.assertIn(part, result.stdout)
                result = run(name, "-version")
                self.assertEqual(result.returncode, 0)
                self.assertIn(version, result.stdout)

    def test_unknown_option_names_the_nearest(self):
        for name in PROGRAMS:
            with self.subTest(name):
                result = run(name, "-quite")
                self.assertEqual(result.returncode, 2)
                self.assertIn("-quiet", result.stderr)
                self.assertEqual(result.stdout, "")

    def test_missing_argument(self):
        for name in PROGRAMS:
            with self.subTest(name):
                result = run(name, "-case")
                self.assertEqual(result.returncode, 2)
                self.assertIn("-case", result.stderr)

    def test_listings_hold_the_words(self):
        listings = re.findall(r"-(list\w+)", run("isphFoam", "-help").stdout)
        self.assertIn("listKernels", listings)
        everything = ""
        for listing in listings:
            result = run("isphFoam", "-" + listing)
            self.assertEqual(result.returncode, 0, listing)
            self.assertGreaterEqual(len(result.stdout.splitlines()), 1, listing)
            everything += result.stdout
        for word in ("gaussian", "quinticSpline", "divergence", "rotational", "RK3", "errorNorms"):
            self.assertIn(word, everything)

    def test_every_program_is_described(self):
        folders = {}
        for folder, _, files in os.walk(os.path.join(ROOT, "applications")):
            folders[os.path.basename(folder)] = files
        for name in PROGRAMS:
            with self.subTest(name):
                self.assertIn("README.md", folders[name])


if __name__ == "__main__":
    unittest.main()
