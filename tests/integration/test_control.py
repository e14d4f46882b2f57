"""What controlDict and the command line say about time, output and the log is done."""
import os
import pty
import re
import shutil
import signal
import subprocess
import time
import unittest

from cases import CaseTest, program, wait_for


class Control(CaseTest):
    def test_a_second_solver_is_refused(self):
        case = self.ready_case(points=64, endTime=1000, writeInterval="100000")
        first = case.start("isphFoam")
        self.addCleanup(first.communicate)
        self.addCleanup(first.kill)
        self.assertTrue(wait_for(lambda: os.path.exists(case.path("postProcessing"))))
        second = case.run("isphFoam", timeout=30)
        self.assertEqual(second.returncode, 1)
        self.assertRegex(second.stderr, "(?i)being solved|running|lock")
        first.send_signal(signal.SIGTERM)
        first.communicate(timeout=60)
        self.assertEqual(first.returncode, 143)
        case.set("system/controlDict", "endTime", str(float(case.times()[-1]) + 0.01))
        self.succeeds(case, "isphFoam")

    def test_purgeWrite(self):
        case = self.ready_case(control="purgeWrite 2;", writeInterval="5")
        self.succeeds(case, "isphFoam")
        self.assertEqual(case.times(), ["0", "0.175", "0.2"])

    def test_stopAt_writeNow_while_running(self):
        case = self.ready_case(points=64, endTime=1000, writeInterval="100000", control="runTimeModifiable yes;")
        process = case.start("isphFoam")
        self.addCleanup(process.kill)
        self.assertTrue(wait_for(lambda: os.path.exists(case.path("postProcessing/errors/0"))))
        time.sleep(1.1)  # file times of some systems count whole seconds
        case.set("system/controlDict", "stopAt", "writeNow")
        process.communicate(timeout=60)
        self.assertEqual(process.returncode, 0)
        self.assertEqual(case.report()["endedBecause"], "stopAt")
        self.assertEqual(len(case.times()), 2)

    def test_the_last_step_ends_at_endTime(self):
        case = self.ready_case(deltaT="0.03", control="adjustTimeStep no;")
        self.succeeds(case, "isphFoam")
        self.assertEqual(case.times()[-1], "0.2")
        self.assertEqual(case.report()["time"], 0.2)

    def test_postProcess_on_written_times(self):
        case = self.ready_case()
        self.succeeds(case, "isphFoam")
        during = {row["time"]: row for row in case.table("errors")}
        shutil.rmtree(case.path("postProcessing"))
        self.succeeds(case, "isphFoam", "-postProcess")
        after = case.table("errors")
        self.assertEqual([row["time"] for row in after], ["0", "0.05", "0.1", "0.15", "0.2"])
        for row in after:
            self.assertAlmostEqual(float(row["relL2(U)"]), float(during[row["time"]]["relL2(U)"]), delta=1e-14)

    def test_noFunctionObjects(self):
        case = self.ready_case()
        self.succeeds(case, "isphFoam", "-noFunctionObjects")
        self.assertFalse(os.path.exists(case.path("postProcessing/errors")))

    def test_the_step_is_adjusted_to_maxCo(self):
        case = self.ready_case(control="adjustTimeStep yes;\nmaxCo 0.3;", writeControl="adjustableRunTime",
                               writeInterval="0.05")
        self.succeeds(case, "isphFoam")
        self.assertEqual(case.times(), ["0", "0.05", "0.1", "0.15", "0.2"])
        largest = max(float(row["CoMax"]) for row in case.table("flow"))
        self.assertLessEqual(largest, 0.3 * (1 + 1e-9))
        self.assertGreater(largest, 0.2)

    def test_steadyTolerance_ends_a_run(self):
        case = self.ready_case(control="steadyTolerance 1e-8;")
        case.put("0/U", re.sub(r"internalField.*", "internalField uniform (0 0 0);", case.text("0/U")))
        self.succeeds(case, "isphFoam")
        self.assertEqual(case.report()["endedBecause"], "steady")
        self.assertEqual(case.report()["steps"], 1)

    def test_time_names_stay_apart(self):
        case = self.ready_case(control="timePrecision 1;", deltaT="0.0125", endTime=0.05, writeInterval="1")
        self.succeeds(case, "isphFoam")
        self.assertEqual(case.times(), ["0", "0.013", "0.025", "0.038", "0.05"])

    def test_pressure_in_pascal(self):
        kinematic = self.ready_case()
        self.succeeds(kinematic, "isphFoam")
        case = self.ready_case()
        case.replace("0/p", "[0 2 -2 0 0 0 0]", "[1 -1 -2 0 0 0 0]")
        case.replace("constant/transportProperties", "] 1;", "] 8;")  # a power of two: the same digits
        self.succeeds(case, "isphFoam")
        values = [[float(v) for v in re.findall(r"[-+0-9.e]+", c.values("0.2", "p").split("}")[0])]
                  for c in (kinematic, case)]
        self.assertEqual(len(values[0]), 576)
        self.assertEqual([8 * v for v in values[0]], values[1])
        self.assertEqual(case.values("0.2", "U"), kinematic.values("0.2", "U"))
        case.replace("constant/transportProperties", "rho [1 -3 0 0 0 0 0] 8;", "")
        result = case.run("isphFoam")
        self.assertEqual(result.returncode, 1)
        self.assertIn("rho", result.stderr)

    def on_a_terminal(self, case, *options):
        """What isphFoam shows on a terminal."""
        try:
            ours, theirs = pty.openpty()
        except OSError as problem:
            self.skipTest(f"this machine has no terminals: {problem}")
        process = subprocess.Popen([program("isphFoam"), "-case", case.dir, *options], stdin=subprocess.DEVNULL,
                                   stdout=theirs, stderr=theirs)
        os.close(theirs)
        shown = b""
        while True:
            try:
                part = os.read(ours, 4096)
            except OSError:  # the other end was closed
                part = b""
            if not part:
                break
            shown += part
        os.close(ours)
        self.assertEqual(process.wait(), 0)
        return shown.decode()

    def test_a_terminal_shows_one_line_of_progress(self):
        case = self.ready_case(endTime=1)
        shown = self.on_a_terminal(case)
        self.assertNotIn("ExecutionTime", shown)
        self.assertIn("\r", shown.replace("\r\n", "\n"))
        self.succeeds(case, "cleanCase")
        self.succeeds(case, "makeLattice")
        shown = self.on_a_terminal(case, "-verbose")
        self.assertEqual(len(re.findall(r"^Time = ", shown.replace("\r", ""), re.MULTILINE)), 200)


if __name__ == "__main__":
    unittest.main()
