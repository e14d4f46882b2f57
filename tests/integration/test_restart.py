"""A run that was stopped, by whatever, goes on in the same bits; no false folder is ever left behind."""
import os
import random
import resource
import signal
import time
import unittest

from cases import CaseTest, wait_for

LONG = dict(points=64, endTime=0.5, deltaT="0.002", writeInterval="5")


class Restart(CaseTest):
    def test_in_one_go_and_in_two(self):
        for schemes, deltaT in (("", "0.005"), ("viscous explicit; convection rotational;", "0.005"), ("", "auto")):
            with self.subTest(schemes=schemes, deltaT=deltaT):
                settings = dict(schemes=schemes, deltaT=deltaT, writeControl="runTime", writeInterval="0.1",
                                control="timePrecision 12;")
                whole = self.ready_case(**settings)
                self.succeeds(whole, "isphFoam")
                parts = self.ready_case(**settings)
                parts.replace("system/controlDict", "endTime 0.2;", f"endTime {whole.times()[1]};")
                self.succeeds(parts, "isphFoam")
                self.assertEqual(len(parts.times()), 2)
                parts.set("system/controlDict", "endTime", "0.2")
                self.succeeds(parts, "isphFoam")
                self.assertEqual(parts.times()[-1], whole.times()[-1])
                self.same_state(parts, parts.times()[-1], whole, whole.times()[-1])

    def test_appends_under_its_own_start_time(self):
        case = self.ready_case(endTime=0.1)
        self.succeeds(case, "isphFoam")
        case.set("system/controlDict", "endTime", "0.2")
        self.succeeds(case, "isphFoam")
        self.assertEqual(sorted(os.listdir(case.path("postProcessing/errors")), key=float), ["0", "0.1"])
        self.assertEqual(float(case.table("errors", "0")[-1]["time"]), 0.1)
        self.assertEqual(float(case.table("errors", "0.1")[-1]["time"]), 0.2)

    def test_start_again_from_zero(self):
        case = self.ready_case()
        self.succeeds(case, "isphFoam")
        before = case.values("0.2")
        case.set("system/controlDict", "startFrom", "startTime")
        self.succeeds(case, "isphFoam")
        self.assertEqual(case.values("0.2"), before)

    def test_folder_0_is_not_touched(self):
        case = self.ready_case()
        before = case.text("0/U"), case.text("0/p"), sorted(os.listdir(case.path("0")))
        self.succeeds(case, "isphFoam")
        self.assertEqual((case.text("0/U"), case.text("0/p"), sorted(os.listdir(case.path("0")))), before)


class Stopped(CaseTest):
    def setUp(self):
        self.whole = self.ready_case(**LONG)
        begin = time.monotonic()
        self.succeeds(self.whole, "isphFoam")
        self.seconds = time.monotonic() - begin

    def goes_on_in_the_same_bits(self, case):
        for name in case.times()[1:]:
            self.assertTrue(os.path.exists(case.path(name, "uniform", "time")), f"{name} is not whole")
        self.succeeds(case, "isphFoam")
        self.same_state(case, case.times()[-1], self.whole, self.whole.times()[-1])

    def test_by_a_signal(self):
        for number, code in ((signal.SIGINT, 130), (signal.SIGTERM, 143)):
            with self.subTest(number):
                case = self.ready_case(**LONG)
                process = case.start("isphFoam")
                self.assertTrue(wait_for(lambda: len(case.times()) > 3))
                process.send_signal(number)
                process.communicate(timeout=60)
                if process.returncode == 0:
                    self.skipTest("the run was over before the signal came")
                self.assertEqual(process.returncode, code)
                self.assertEqual(case.report()["endedBecause"], "signal")
                self.goes_on_in_the_same_bits(case)

    def test_by_kill_at_any_moment(self):
        draw = random.Random(20)
        case = self.ready_case(**LONG)
        kills = 0
        for _ in range(12):
            process = case.start("isphFoam")
            time.sleep(draw.uniform(0.02, 0.4) * self.seconds)
            process.kill()
            process.communicate()
            if process.returncode == 0:
                break
            kills += 1
            # What a killed run left half-written does not carry the name of a time.
            for name in case.times()[1:]:
                self.assertIn(name, self.whole.times())
                self.assertEqual(case.values(name), self.whole.values(name), f"folder {name} after kill {kills}")
        self.assertGreaterEqual(kills, 2)
        self.goes_on_in_the_same_bits(case)

    def test_by_a_full_disk(self):
        # A limit on the size of files acts like a disk that fills up, at ever later places of the output.
        size = os.path.getsize(self.whole.path(self.whole.times()[-1], "fields.h5"))
        for limit in (size // 3, size - 100):
            with self.subTest(limit=limit):
                case = self.copy_of(self.whole)
                older = {name: case.values(name) for name in case.times()[1:]}
                case.set("system/controlDict", "endTime", "0.6")

                def full():
                    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
                    resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))

                result = case.run("isphFoam", preexec=full)
                self.assertEqual(result.returncode, 1, result.stderr)
                self.assertIn("fields.h5", result.stderr)
                self.assertEqual({name: case.values(name) for name in case.times()[1:]}, older)
                left = [name for name in os.listdir(case.dir) if name.startswith(("0.51", ".0.51"))]
                self.assertEqual(left, [])
                self.succeeds(case, "isphFoam")


if __name__ == "__main__":
    unittest.main()
