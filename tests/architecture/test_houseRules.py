"""Rules of the house that a reader of the sources can check: lengths, forbidden words, no paths of a machine."""
import os
import re
import shutil
import subprocess
import unittest

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", ".."))
LONGEST = {".cpp": 450, ".hpp": 200}
FORBIDDEN = [
    (r"\bshared_ptr\b", "ownership is unique or by value"),
    (r"\bstd::(exit|quick_exit|abort|terminate)\b", "errors are thrown"),
    (r"^\s*#\s*define\b", "no macros"),
    (r"\busing namespace std\b", "names are spelt out"),
    (r"\b(TODO|FIXME|XXX|HACK)\b", "finish it, or say so in an issue"),
    (r"-ffast-math|-Ofast", "the same bits every time"),
]
# What CMake looks for, and the Debian package that has it.
PACKAGES = {
    "fmt": "libfmt-dev", "OpenMP": "g++", "FFTW3": "libfftw3-dev", "HDF5": "libhdf5-dev", "PkgConfig": "pkg-config",
    "muparser": "libmuparser-dev", "Eigen3": "libeigen3-dev", "VTK": "libvtk9-dev", "GTest": "libgtest-dev",
    "Python3": "python3", "MPI": "libopenmpi-dev",
}
MACHINE = re.compile(r"(?<![\w.])/(work|home|root|Users)/\w|(?<![\w.$}])/tmp/\w")


def tracked():
    names = ""
    if shutil.which("git"):
        names = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, text=True, capture_output=True, check=False).stdout
    if names:
        return [name for name in names.split("\0") if name and os.path.isfile(os.path.join(ROOT, name))]
    found = []
    for folder, folders, files in os.walk(ROOT):
        folders[:] = [name for name in folders if not name.startswith((".", "build", "__pycache__"))]
        found += [os.path.relpath(os.path.join(folder, name), ROOT) for name in files]
    return found


def lines(name):
    with open(os.path.join(ROOT, name), encoding="utf-8") as file:
        return file.read().splitlines()


class HouseRules(unittest.TestCase):
    def test_lengths(self):
        for name in tracked():
            limit = LONGEST.get(os.path.splitext(name)[1])
            if limit and name.startswith(("libraries/", "applications/")):
                with self.subTest(name):
                    self.assertLessEqual(len(lines(name)), limit)

    def test_forbidden_words(self):
        for name in tracked():
            if not name.startswith(("libraries/", "applications/")) or not name.endswith((".cpp", ".hpp")):
                continue
            for number, line in enumerate(lines(name), 1):
                for pattern, why in FORBIDDEN:
                    self.assertIsNone(re.search(pattern, line), f"{name}:{number}: {line.strip()} ({why})")

    def test_no_paths_of_a_machine(self):
        for name in tracked():
            if name.endswith((".png", ".h5", ".pdf")) or name == "tests/architecture/test_houseRules.py":
                continue
            for number, line in enumerate(lines(name), 1):
                self.assertIsNone(MACHINE.search(line), f"{name}:{number}: {line.strip()}")

    def test_every_library_and_program_is_described(self):
        for top in ("libraries", "applications"):
            for folder, _, files in os.walk(os.path.join(ROOT, top)):
                if "CMakeLists.txt" in files and any(f.endswith((".cpp", ".hpp")) for f in files):
                    with self.subTest(folder):
                        self.assertIn("README.md", files)

    def test_what_cmake_looks_for_is_installed_by_the_two_commands(self):
        with open(os.path.join(ROOT, "bin", "packages"), encoding="utf-8") as file:
            packages = set(re.split(r"[\s|?]+", file.read()))
        for name in tracked():
            if not name.endswith(("CMakeLists.txt", ".cmake")):
                continue
            for number, line in enumerate(lines(name), 1):
                for wanted in re.findall(r"(?:find_package|pkg_check_modules)\((\w+)", line):
                    self.assertIn(wanted, PACKAGES, f"{name}:{number}")
                    self.assertIn(PACKAGES[wanted], packages, f"{name}:{number}")

    def test_annotated_dictionaries_are_shipped(self):
        for name in ("latticeDict", "controlDict", "schemes", "solution", "sampleDict", "transportProperties", "U", "p"):
            self.assertTrue(os.path.isfile(os.path.join(ROOT, "etc", "annotated", name)), name)


if __name__ == "__main__":
    unittest.main()
