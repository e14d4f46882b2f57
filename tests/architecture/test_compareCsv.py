"""bin/compareCsv passes what is close enough and fails what is not."""
import os
import shutil
import subprocess
import tempfile
import unittest

COMPARE = os.path.join(os.path.dirname(__file__), "..", "..", "bin", "compareCsv")
RESULT = "time [s],step,error [m/s],div [1/s]\n0,0,1,1e-15\n1,10,2.01,2e-15\n2,20,4,1e-15\n"


class CompareCsv(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp(prefix="continua-")
        self.addCleanup(shutil.rmtree, self.folder)

    def compare(self, reference, result=RESULT, *options):
        for name, text in (("result.csv", result), ("reference.csv", reference)):
            with open(os.path.join(self.folder, name), "w", encoding="utf-8") as file:
                file.write(text)
        return subprocess.run([COMPARE, *options, "result.csv", "reference.csv"], cwd=self.folder, text=True,
                              capture_output=True, check=False)

    def passes(self, reference, **options):
        result = self.compare(reference, **options)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)

    def fails(self, reference, part, **options):
        result = self.compare(reference, **options)
        self.assertEqual(result.returncode, 1, result.stdout)
        self.assertIn(part, result.stdout + result.stderr)

    def test_tolerances(self):
        self.passes("# compare error relative 0.01\ntime [s],error [m/s]\n1,2\n")
        self.fails("# compare error relative 0.004\ntime [s],error [m/s]\n1,2\n", "MISSED")
        self.passes("# compare error absolute 0.02\ntime,error\n1,2\n2,4\n")
        self.fails("# compare error absolute 0.001\ntime,error\n1,2\n2,4\n", "MISSED")
        self.passes("# compare div below\ntime,div\n1,1e-12\n")
        self.fails("# compare div below\ntime,div\n1,1e-16\n", "MISSED")

    def test_what_is_not_finite_is_a_miss(self):
        self.fails("# compare error relative 10\ntime,error\n1,2\n", "MISSED", result="time,error\n1,nan\n")

    def test_rows(self):
        self.fails("# compare error relative 1\ntime,error\n1.5,3\n", "no row")
        self.passes("# compare error relative 0.01\n# rows interpolate\ntime,error\n1.5,3\n")
        self.fails("# compare error relative 1\n# rows interpolate\ntime,error\n3,3\n", "no row")

    def test_references_that_say_nothing(self):
        self.fails("time,error\n1,2\n", "what to compare")
        self.fails("# compare error relative 0.1\ntime,error\n", "no rows")
        self.fails("# compare missing relative 0.1\ntime,error\n1,2\n", "missing")

    def test_renew(self):
        self.assertEqual(self.compare("# compare error relative 0.004\ntime,error\n1,2\n", RESULT, "--renew").returncode, 0)
        with open(os.path.join(self.folder, "reference.csv"), encoding="utf-8") as file:
            self.assertEqual(file.read(), "# compare error relative 0.004\ntime,error\n1,2.01\n")


if __name__ == "__main__":
    unittest.main()
