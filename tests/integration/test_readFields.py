"""What docs/howto/readFields.md tells users to type works, on a file that our programs wrote."""
import os
import re
import subprocess
import sys
import unittest

from cases import ROOT, CaseTest

HAS_H5PY = subprocess.run([sys.executable, "-c", "import h5py"], capture_output=True, check=False).returncode == 0


class ReadFields(CaseTest):
    def setUp(self):
        with open(os.path.join(ROOT, "docs", "howto", "readFields.md"), encoding="utf-8") as file:
            self.reading, self.sealing = re.findall(r"```python\n(.*?)```", file.read(), re.DOTALL)
        source, self.target = self.ready_case(), self.ready_case(points=36)
        result = self.target.run("mapFields", source.dir)
        self.assertEqual(result.returncode, 0, result.stderr)

    def python(self, text, folder="."):
        return subprocess.run([sys.executable, "-c", text], cwd=self.target.path(folder), text=True,
                              capture_output=True, check=False)

    @unittest.skipUnless(HAS_H5PY, "h5py is not installed")
    def test_reading(self):
        self.assertLessEqual(len(self.reading.strip().splitlines()), 20)
        result = self.python(self.reading.replace("0.25/fields.h5", "0/fields.h5"))
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertRegex(result.stdout, r"fastest at \(\S+ \S+ 0\): 1\.3\d+ m/s")

    @unittest.skipUnless(HAS_H5PY, "h5py is not installed")
    def test_sealing_what_was_changed(self):
        result = self.python("import h5py\nwith h5py.File('0/fields.h5', 'r+') as file: file['U'][:, :, :, 0] = 7")
        self.assertEqual(result.returncode, 0, result.stderr)
        result = self.target.run("sampleLines", "-stdout", "-quiet")
        self.assertEqual(result.returncode, 1)
        self.assertIn("0/fields.h5: is damaged", result.stderr)
        result = self.python(self.sealing, "0")
        self.assertEqual(result.returncode, 0, result.stderr)
        result = self.succeeds(self.target, "sampleLines", "-stdout", "-quiet", "-interpolation", "linear")
        self.assertRegex(result.stdout.splitlines()[1], r"^0,0,-0.5,0,7,")


if __name__ == "__main__":
    unittest.main()
