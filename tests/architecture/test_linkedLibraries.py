"""Each program links what it needs and no more (docs/architecture.md, section 2)."""
import os
import subprocess
import unittest

BIN = os.environ["CONTINUA_BIN"]
FOREIGN = ("fftw", "hdf5", "vtk", "muparser", "libmpi")

# Program: the foreign libraries it may load. A program that is missing here fails, so that the table stays true.
MAY_LINK = {
    "makeLattice": {"muparser"},
    "caseDict": {"muparser"},
    "listTimes": {"muparser"},
    "cloneCase": {"muparser"},
    "cleanCase": {"muparser"},
    "workPrecision": {"muparser"},
    "checkCase": {"muparser", "fftw", "hdf5"},
    "checkStability": {"muparser", "fftw", "hdf5"},
    "isphFoam": {"muparser", "fftw", "hdf5"},
    "scalarTransportFoam": {"muparser", "fftw", "hdf5"},
    "sampleLines": {"muparser", "fftw", "hdf5"},
    "fcExtend": {"muparser", "fftw", "hdf5"},
    "mapFields": {"muparser", "fftw", "hdf5"},
    "toVTK": {"muparser", "fftw", "hdf5", "vtk"},
}


class LinkedLibraries(unittest.TestCase):
    def test_every_program(self):
        programs = sorted(name for name in os.listdir(BIN) if os.access(os.path.join(BIN, name), os.X_OK))
        self.assertIn("isphFoam", programs)
        for name in programs:
            with self.subTest(name):
                self.assertIn(name, MAY_LINK)
                loaded = subprocess.run(["ldd", os.path.join(BIN, name)], text=True, capture_output=True,
                                        check=True).stdout.lower()
                linked = {package for package in FOREIGN if package in loaded}
                self.assertLessEqual(linked, MAY_LINK[name])


if __name__ == "__main__":
    unittest.main()
