"""The programs one after the other: makeLattice, checkCase, isphFoam, sampleLines, toVTK."""
import csv
import os
import unittest
import xml.etree.ElementTree as xml

from cases import CaseTest, program, run


class Pipeline(CaseTest):
    def test_lattice_to_paraview(self):
        case = self.case()
        said = self.succeeds(case, "makeLattice").stdout
        self.assertIn("576", said)  # points
        self.assertTrue(os.path.exists(case.path("constant/lattice")))

        said = self.succeeds(case, "checkCase").stdout
        self.assertIn("gaussian", said)

        said = self.succeeds(case, "isphFoam").stdout
        for part in ("Time = ", "Courant Number mean:", "divergence", "ExecutionTime = ", "End"):
            self.assertIn(part, said)
        self.assertEqual(case.times(), ["0", "0.05", "0.1", "0.15", "0.2"])
        for name in ("U", "p", "fields.h5", "uniform/time"):
            self.assertTrue(os.path.exists(case.path("0.2", name)), name)

        error = case.table("errors")[-1]
        self.assertEqual(float(error["time"]), 0.2)
        self.assertLess(float(error["relL2(U)"]), 1e-4)
        report = case.report()
        self.assertEqual(report["endedBecause"], "endTime")
        self.assertEqual(report["steps"], 40)
        self.assertEqual(report["lattice"]["points"], [24, 24, 1])
        self.assertAlmostEqual(report["errors"]["U"]["relL2"], float(error["relL2(U)"]), delta=1e-12)

        self.succeeds(case, "sampleLines", "-latestTime")
        with open(case.path("postProcessing/sampleLines/0.2/centre.csv"), encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(len(rows), 25)
        for column in ("distance [m]", "x [m]", "U.x [m/s]", "U.y [m/s]"):
            self.assertIn(column, rows[0])

        if os.path.exists(program("toVTK")):
            self.succeeds(case, "toVTK", "-derived")
            tree = xml.parse(case.path("VTK/vortex.pvd"))
            files = [element.get("file") for element in tree.iter("DataSet")]
            self.assertEqual(len(files), 5)
            for name in files:
                self.assertTrue(os.path.exists(case.path("VTK", name)), name)

    def test_lines_through_a_pipe(self):
        case = self.ready_case()
        self.succeeds(case, "isphFoam")
        result = self.succeeds(case, "sampleLines", "-latestTime", "-stdout")
        lines = result.stdout.strip().splitlines()
        self.assertTrue(lines[0].startswith("distance [m]"), lines[0])
        self.assertEqual(len(lines), 26)
        self.assertEqual(len({line.count(",") for line in lines}), 1)

    def test_from_the_folder_of_the_case(self):
        case = self.case()
        for name in ("makeLattice", "isphFoam", "listTimes"):
            result = run(name, cwd=case.dir)
            self.assertEqual(result.returncode, 0, result.stderr)

    def test_checkCase_for_machines(self):
        import json
        case = self.ready_case()
        said = json.loads(self.succeeds(case, "checkCase", "-json").stdout)
        self.assertIsInstance(said, dict)

    def test_checkCase_refuses_what_cannot_run(self):
        case = self.ready_case()
        case.replace("system/schemes", "gaussian", "gausian")
        result = case.run("checkCase")
        self.assertEqual(result.returncode, 1)
        self.assertIn("gaussian", result.stderr)

    def test_lattice_is_not_overwritten_unasked(self):
        case = self.ready_case()
        before = case.text("constant/lattice")
        case.replace("system/latticeDict", "(24 24 1)", "(32 32 1)")
        result = case.run("makeLattice")
        self.assertEqual(result.returncode, 1)
        self.assertIn("-overwrite", result.stderr)
        self.assertEqual(case.text("constant/lattice"), before)
        self.succeeds(case, "makeLattice", "-overwrite")
        self.assertIn("32", case.text("constant/lattice"))

    def test_quiet_says_nothing(self):
        case = self.case()
        for name in ("makeLattice", "isphFoam"):
            result = self.succeeds(case, name, "-quiet")
            self.assertEqual(result.stdout, "", name)

    def test_clone_list_clean(self):
        case = self.ready_case()
        self.succeeds(case, "isphFoam")
        self.assertEqual(self.succeeds(case, "listTimes").stdout.split()[-1], "0.2")
        self.assertEqual(self.succeeds(case, "listTimes", "-latestTime").stdout.split(), ["0.2"])

        clone = os.path.join(os.path.dirname(case.dir), "clone")
        result = run("cloneCase", case.dir, clone)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertTrue(os.path.exists(os.path.join(clone, "0", "U")))
        self.assertTrue(os.path.exists(os.path.join(clone, "system", "controlDict")))
        self.assertFalse(os.path.exists(os.path.join(clone, "0.2")))

        self.succeeds(case, "cleanCase")
        self.assertEqual(case.times(), ["0"])
        self.assertFalse(os.path.exists(case.path("postProcessing")))
        self.assertTrue(os.path.exists(case.path("system/latticeDict")))


if __name__ == "__main__":
    unittest.main()
