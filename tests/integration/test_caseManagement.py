"""listTimes, cloneCase and cleanCase on cases that need no solver."""
import fcntl
import os
import unittest

from cases import CaseTest, run


class CaseManagement(CaseTest):
    def case_with_results(self):
        case = self.case()
        for name in ("0.5", "0.25", "1e-05", "10"):
            case.put(f"{name}/U", name)
            case.put(f"{name}/uniform/time", "")
        for name in ("constant/lattice", "postProcessing/errors/0/errors.csv", "VTK/vortex.pvd", "log.isphFoam",
                     ".0.75.tmp-4194303/U", "Allrun", "table.csv", "0.orig/U"):
            case.put(name, name)
        return case

    def listed(self, case, *arguments):
        result = case.run("listTimes", *arguments)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result.stdout.split()

    def refused(self, code, *command):
        result = run(*command)
        self.assertEqual(result.returncode, code, result.stderr)
        return result.stderr

    def test_times_are_listed_as_foamListTimes_does(self):
        case = self.case_with_results()
        self.assertEqual(self.listed(case), ["1e-05", "0.25", "0.5", "10"])
        self.assertEqual(self.listed(case, "-withZero"), ["0", "1e-05", "0.25", "0.5", "10"])
        self.assertEqual(self.listed(case, "-withZero", "-noZero"), ["1e-05", "0.25", "0.5", "10"])
        self.assertEqual(self.listed(case, "-latestTime"), ["10"])
        self.assertEqual(self.listed(case, "--time", "0.25,1:"), ["0.25", "10"])
        self.assertEqual(self.listed(case, "-time", "20:"), [])
        self.assertIn("1e-05, 0.25, 0.5, 10", self.refused(1, "listTimes", "-case", case.dir, "-time", "7"))
        self.refused(2, "listTimes", "-case", case.dir, "-time", "soon")
        self.refused(1, "listTimes", "-case", case.path("0"))

    def test_times_are_removed(self):
        case = self.case_with_results()
        self.listed(case, "-time", "0.25:0.5", "-rm")
        self.assertEqual(case.times(), ["0", "1e-05", "10"])
        self.listed(case, "-rm")
        self.assertEqual(case.times(), ["0"])

    def test_a_clone_has_the_input_and_no_results(self):
        case = self.case_with_results()
        clone = case.path("..", "clone")
        self.assertEqual(run("cloneCase", case.dir, clone).returncode, 0)
        self.assertEqual(sorted(os.listdir(clone)), ["0", "0.orig", "Allrun", "constant", "system", "table.csv"])
        self.assertEqual(sorted(os.listdir(os.path.join(clone, "constant"))), ["lattice", "transportProperties"])

        before = case.state()
        self.assertIn("is there already", self.refused(1, "cloneCase", case.dir, clone))
        self.assertEqual(run("cloneCase", case.dir, clone, "-overwrite", "-latestTime").returncode, 0)
        self.assertEqual(sorted(os.listdir(clone)), ["0.orig", "10", "Allrun", "constant", "system", "table.csv"])
        self.assertEqual(case.state(), before)

    def test_clones_below_the_case(self):
        case = self.case_with_results()
        self.assertEqual(run("cloneCase", ".", "study/fine", cwd=case.dir).returncode, 0)
        self.assertTrue(os.path.exists(case.path("study/fine/system/controlDict")))
        before = case.state()
        for target in (".", "..", "system", "constant/new", "0/new"):
            with self.subTest(target=target):
                self.refused(1, "cloneCase", case.dir, case.path(target), "-overwrite")
        self.refused(1, "cloneCase", case.path("nothing"), case.path("new"))
        self.refused(2, "cloneCase", case.dir)
        self.assertEqual(case.state(), before)

    def test_only_cases_are_overwritten(self):
        case = self.case_with_results()
        case.put("../precious/letter.txt", "dear")
        self.assertIn("is no case", self.refused(1, "cloneCase", case.dir, case.path("../precious"), "-overwrite"))
        self.assertEqual(case.text("../precious/letter.txt"), "dear")

    def test_clean(self):
        case = self.case_with_results()
        before = case.state()
        planned = self.succeeds(case, "cleanCase", "-dryRun").stdout
        self.assertIn("Would remove postProcessing\n", planned)
        self.assertEqual(case.state(), before)
        self.succeeds(case, "cleanCase")
        self.assertEqual(sorted(os.listdir(case.dir)), ["0", "0.orig", "Allrun", "constant", "system", "table.csv"])
        self.assertEqual(os.listdir(case.path("constant")), ["transportProperties"])
        self.assertEqual(sorted(os.listdir(case.path("0"))), ["U", "p"])
        self.assertEqual(self.succeeds(case, "cleanCase").stdout, "")

    def test_what_cannot_be_made_again_stays(self):
        case = self.case_with_results()
        os.remove(case.path("system/latticeDict"))
        os.rename(case.path("0"), case.path("0.1"))
        os.rename(case.path("1e-05"), case.path("0.2"))
        self.succeeds(case, "cleanCase")
        self.assertEqual(case.times(), ["0.1"])
        self.assertTrue(os.path.exists(case.path("constant/lattice")))

    def test_a_case_that_is_being_solved_is_left_alone(self):
        case = self.case_with_results()
        with open(case.path(".isphFoam.lock"), "w", encoding="utf-8") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            for command in (["cleanCase"], ["listTimes", "-rm"]):
                self.assertIn("is being solved", self.refused(1, *command, "-case", case.dir))
            self.assertEqual(len(case.times()), 5)
        self.succeeds(case, "cleanCase")


if __name__ == "__main__":
    unittest.main()
