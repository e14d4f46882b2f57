"""bin/checkLayers finds each kind of broken rule."""
import os
import shutil
import subprocess
import tempfile
import unittest

CHECK = os.path.join(os.path.dirname(__file__), "..", "..", "bin", "checkLayers")


class CheckLayers(unittest.TestCase):
    def setUp(self):
        self.root = tempfile.mkdtemp(prefix="continua-")
        self.addCleanup(shutil.rmtree, self.root)
        self.write("libraries/core/Error.hpp", "#pragma once\n#include <string>\n")
        self.write("libraries/flow/Flow.hpp", '#pragma once\n#include "core/Error.hpp"\n')

    def write(self, name, text):
        path = os.path.join(self.root, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)

    def check(self):
        result = subprocess.run([CHECK, self.root], text=True, capture_output=True, check=False)
        return result.returncode, result.stdout

    def finds(self, name, text, *parts):
        self.write(name, text)
        code, said = self.check()
        self.assertEqual(code, 1, said)
        for part in (name, *parts):
            self.assertIn(part, said)
        os.remove(os.path.join(self.root, name))

    def test_a_clean_tree_passes(self):
        self.assertEqual(self.check(), (0, ""))

    def test_broken_rules(self):
        self.finds("libraries/core/a.cpp", '#include "flow/Flow.hpp"\n', ":1:", "upward")
        self.finds("libraries/fields/a.cpp", '\n#include "dictionary/Dictionary.hpp"\n', ":2:", "sideways")
        self.finds("libraries/flow/a.cpp", "#include <fftw3.h>\n", "FFTW")
        self.finds("applications/solvers/x/x.cpp", "#include <hdf5.h>\n", "HDF5")
        self.finds("libraries/operators/a.cpp", "#include <vtkImageData.h>\n", "VTK")
        self.finds("libraries/flow/a.cpp", "#include <Eigen/Dense>\n", "Eigen")
        self.finds("libraries/dictionary/a.cpp", "#include <muParser.h>\n", "muParser")
        self.finds("libraries/flow/a.hpp", "#pragma once\n#include <fmt/format.h>\n", "fmt")
        self.finds("libraries/flow/a.hpp", "#pragma once\n#include <iostream>\n", "iostream")
        self.finds("libraries/flow/a.hpp", "#include <string>\n", "pragma once")
        self.finds("libraries/schemes/Scheme.cpp", '#include "dictionary/Dictionary.hpp"\n', "no dictionaries")
        self.finds("libraries/elsewhere/a.cpp", "\n", "no floor")

    def test_readers_may_read(self):
        for name in ("readFlow.cpp", "timeSchemeSelection.cpp"):
            self.write("libraries/schemes/" + name, '#include "dictionary/Dictionary.hpp"\n')
        self.assertEqual(self.check(), (0, ""))

    def test_internal_headers_stay_inside(self):
        self.write("libraries/spectral/FftwPlan.hpp", "#pragma once\n#include <fftw3.h>\n")
        self.write("libraries/spectral/Transform.cpp", '#include "spectral/FftwPlan.hpp"\n')
        self.assertEqual(self.check(), (0, ""))
        self.finds("libraries/operators/a.cpp", '#include "spectral/FftwPlan.hpp"\n', "internal to spectral")


if __name__ == "__main__":
    unittest.main()
