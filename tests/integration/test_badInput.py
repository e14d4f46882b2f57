"""Wrong cases: the message names file, line and cure; the exit code is right; nothing is written."""
import os
import shutil
import subprocess
import unittest

from cases import CaseTest, program


NOBODY = 65534


class BadInput(CaseTest):
    def refused(self, case, *expected, by="isphFoam", arguments=(), at=None, code=1):
        """Runs the program and checks that it refuses: exit code, parts of the message, place, and no trace left."""
        before = case.state()
        result = case.run(by, *arguments, timeout=60)
        said = result.stderr
        self.assertEqual(result.returncode, code, said + result.stdout[-500:])
        for part in expected:
            self.assertIn(part, said)
        if at is not None:
            self.assertIn(f"{at[0]}:{at[1]}:", said)
        self.assertNotIn("bug", said.lower())
        if by == "isphFoam" and code == 1:
            check = case.run("checkCase", timeout=60)
            self.assertEqual(check.returncode, 1, "checkCase sees nothing wrong: " + said)
            for part in expected:
                self.assertIn(part, check.stderr + check.stdout)
        self.assertEqual(case.state(), before, "something was written")
        return said

    def edited(self, relative, old, new, **settings):
        case = self.ready_case(**settings)
        case.replace(relative, old, new)
        return case

    # ---------------------------------------------------------------------------------------------------- files

    def test_missing_files(self):
        for relative in ("system/controlDict", "system/schemes", "constant/transportProperties", "0/U", "0/p"):
            with self.subTest(relative):
                case = self.ready_case()
                os.remove(case.path(relative))
                self.refused(case, relative)

    def test_missing_lattice_names_makeLattice(self):
        self.refused(self.case(), "constant/lattice", "makeLattice")

    def test_missing_latticeDict(self):
        case = self.case()
        os.remove(case.path("system/latticeDict"))
        self.refused(case, "system/latticeDict", by="makeLattice")

    def test_missing_case(self):
        case = self.case()
        shutil.rmtree(case.dir)
        result = case.run("isphFoam")
        self.assertEqual(result.returncode, 1)
        self.assertIn("vortex", result.stderr)
        self.assertFalse(os.path.exists(case.dir))

    def test_folder_in_place_of_a_file(self):
        case = self.ready_case()
        os.remove(case.path("system/schemes"))
        os.mkdir(case.path("system/schemes"))
        self.refused(case, "system/schemes")

    def test_unreadable_file(self):
        case = self.ready_case()
        os.chmod(case.path("system/schemes"), 0)
        if os.geteuid() == 0:
            for folder, _, files in os.walk(case.dir):
                for name in [folder] + [os.path.join(folder, name) for name in files]:
                    os.chown(name, NOBODY, NOBODY)
        before = sorted(os.listdir(case.dir))
        result = self.run_unprivileged(case)
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertIn("system/schemes", result.stderr)
        self.assertEqual(sorted(os.listdir(case.dir)), before)

    def test_include_cycle(self):
        case = self.ready_case()
        case.put("system/a", '#include "b"\n')
        case.put("system/b", '#include "a"\n')
        case.replace("system/schemes", "kernel", '#include "a"\nkernel')
        self.refused(case, "include", "system/")

    def test_missing_include(self):
        case = self.edited("system/schemes", "kernel", '#include "nowhere"\nkernel')
        self.refused(case, "nowhere", at=("system/schemes", case.line_of("system/schemes", "nowhere")))

    # ----------------------------------------------------------------------------------------------------- keys

    def test_missing_key(self):
        case = self.edited("system/controlDict", "endTime 0.2;", "")
        self.refused(case, "endTime", "system/controlDict")

    def test_missing_kernel_type(self):
        case = self.edited("system/schemes", "type gaussian;", "")
        self.refused(case, "type", "system/schemes:")

    def test_misspelt_key_names_the_nearest(self):
        case = self.edited("system/schemes", "kernel {", "kernal {")
        self.refused(case, "kernal", "kernel", at=("system/schemes", case.line_of("system/schemes", "kernal")))

    def test_misspelt_key_within(self):
        case = self.edited("system/schemes", "smoothingLength", "smothingLength")
        self.refused(case, "smoothingLength", at=("system/schemes", case.line_of("system/schemes", "smothing")))

    def test_misspelt_key_of_controlDict(self):
        case = self.edited("system/controlDict", "writeInterval 10;", "writeIntervall 10;")
        self.refused(case, "writeInterval",
                     at=("system/controlDict", case.line_of("system/controlDict", "writeIntervall 10;")))

    def test_unknown_function_type(self):
        case = self.edited("system/controlDict", "flowStatistics", "flowStatistic")
        self.refused(case, "flowStatistics", "system/controlDict:")

    def test_two_slips_are_told_at_once(self):
        case = self.ready_case()
        case.put("system/schemes", "kernel { type gaussian; odrer 4; smothingLength 2; }\n")
        self.refused(case, "odrer", "smothingLength")

    def test_unknown_words(self):
        for old, new, known in (
            ("gaussian", "gausian", "gaussian"),
            ("order 6;", "order 6; symbol clozed;", "closed"),
            ("kernel", "convection advectiv;\nkernel", "advective"),
            ("kernel", "time RK4;\nkernel", "RK3"),
        ):
            with self.subTest(new):
                case = self.edited("system/schemes", old, new)
                self.refused(case, known, "system/schemes:")

    # --------------------------------------------------------------------------------------------------- values

    def test_wrong_types(self):
        for relative, old, new in (
            ("system/controlDict", "endTime 0.2", "endTime banana"),
            ("system/controlDict", "endTime 0.2", "endTime (1 2)"),
            ("system/controlDict", "deltaT 0.005", "deltaT soon"),
            ("system/schemes", "order 6", "order six"),
            ("system/schemes", "order 6", "order 5"),
            ("system/schemes", "smoothingLength 1.5", "smoothingLength 0"),
            ("system/schemes", "smoothingLength 1.5", "smoothingLength -2"),
            ("constant/transportProperties", "0.01;", "-0.01;"),
            ("constant/transportProperties", "0.01;", "nan;"),
            ("constant/transportProperties", "[0 2 -1 0 0 0 0]", "[0 1 -1 0 0 0 0]"),
            ("0/U", "[0 1 -1 0 0 0 0]", "[0 2 -1 0 0 0 0]"),
        ):
            with self.subTest(new):
                case = self.edited(relative, old, new)
                key = new.split()[0].strip("[")
                line = case.line_of(relative, new)
                self.refused(case, at=(relative, line))
                self.assertTrue(key)

    def test_negative_viscosity(self):
        case = self.edited("constant/transportProperties", "0.01;", "-0.01;")
        self.refused(case, "nu", "-0.01",
                     at=("constant/transportProperties", case.line_of("constant/transportProperties", "-0.01")))

    def test_end_before_start(self):
        case = self.edited("system/controlDict", "startFrom latestTime;\nstartTime 0;",
                           "startFrom startTime;\nstartTime 0;")
        case.replace("system/controlDict", "endTime 0.2;", "endTime -1;")
        self.refused(case, "endTime", at=("system/controlDict", case.line_of("system/controlDict", "endTime -1")))

    def test_step_not_positive(self):
        case = self.edited("system/controlDict", "deltaT 0.005;", "deltaT -0.005;")
        self.refused(case, "deltaT", "system/controlDict:")

    def test_missing_semicolon(self):
        case = self.edited("system/controlDict", "endTime 0.2;", "endTime 0.2")
        self.refused(case, "system/controlDict:")

    def test_unclosed_brace(self):
        case = self.edited("system/schemes", "1.5; }", "1.5;")
        self.refused(case, "system/schemes:")

    def test_expressions(self):
        for old, new, part in (("cos(", "cos((", ""), ("cos(", "foo(x)*cos(", "foo"), ("- cos", "- velocity*cos", "velocity")):
            with self.subTest(new):
                case = self.edited("0/U", old, new)
                self.refused(case, part, at=("0/U", case.line_of("0/U", "internalField")))

    def test_expression_that_is_not_finite(self):
        case = self.edited("0/U", "- cos", "- log(x)*cos")
        self.refused(case, "0/U:", "not a number")

    def test_unknown_patch_and_missing_patch(self):
        case = self.edited("0/U", "xSides", "xSide")
        self.refused(case, "xSides", "0/U:")

    def test_boundary_type_that_does_not_fit(self):
        case = self.edited("0/U", "xSides { type periodic; }", "xSides { type noSlip; }")
        self.refused(case, "xSides", "0/U:")

    def test_lattice_that_is_none(self):
        case = self.ready_case()
        case.put("constant/lattice", "FoamFile { object lattice; }\n")
        self.refused(case, "constant/lattice")

    # -------------------------------------------------------------------------------------------------- lattice

    def test_extent_is_no_multiple_of_the_spacing(self):
        case = self.case()
        case.replace("system/latticeDict", "count (24 24 1);", "spacing 0.03;")
        self.refused(case, "spacing", "0.03", by="makeLattice",
                     at=("system/latticeDict", case.line_of("system/latticeDict", "spacing 0.03")))

    def test_counts_that_cannot_be(self):
        for count in ("(0 24 1)", "(-4 24 1)", "(24 24 4)", "(2.5 24 1)"):
            with self.subTest(count):
                case = self.case()
                case.replace("system/latticeDict", "(24 24 1)", count)
                self.refused(case, by="makeLattice",
                             at=("system/latticeDict", case.line_of("system/latticeDict", "count")))

    def test_memory_is_refused_before_it_is_taken(self):
        case = self.case()
        case.replace("system/latticeDict", "(24 24 1)", "(1000000000 1000000000 1)")
        said = self.refused(case, by="makeLattice")
        self.assertIn("memory", said)

    def test_periodic_patch_with_one_face(self):
        case = self.case()
        case.replace("system/latticeDict", "xSides { type periodic; axis x; }", "xSides { type periodic; face xMin; }")
        self.refused(case, "xSides", "xMax", by="makeLattice")

    def test_face_in_two_patches(self):
        case = self.case()
        case.replace("system/latticeDict", "ySides {", "more { type wall; face xMin; }\n    ySides {")
        self.refused(case, "xMin", by="makeLattice")

    def test_face_in_no_patch(self):
        case = self.case()
        case.replace("system/latticeDict", "    ySides { type periodic; axis y; }\n", "")
        self.refused(case, "yM", by="makeLattice")

    # ------------------------------------------------------------------------------------------------ command line

    def test_command_line(self):
        case = self.ready_case()
        self.refused(case, "-verbose", arguments=("-verbos",), code=2)
        result = case.run("isphFoam", "stray")
        self.assertEqual(result.returncode, 2)
        self.assertIn("stray", result.stderr)

    # --------------------------------------------------------------------------------------------- stored fields

    def test_damaged_fields_are_refused(self):
        case = self.ready_case()
        self.succeeds(case, "isphFoam")
        case.replace("system/controlDict", "endTime 0.2;", "endTime 0.3;")
        whole = open(case.path("0.2/fields.h5"), "rb").read()
        middle = bytearray(whole)
        middle[len(middle) // 2] ^= 0x10
        for name, data in (("flipped bit", bytes(middle)), ("cut short", whole[: len(whole) // 2]), ("empty", b"")):
            with self.subTest(name):
                with open(case.path("0.2/fields.h5"), "wb") as file:
                    file.write(data)
                self.refused(case, "fields.h5")
        os.remove(case.path("0.2/fields.h5"))
        self.refused(case, "fields.h5")

    def test_any_flipped_bit_is_noticed(self):
        case = self.ready_case()
        self.succeeds(case, "isphFoam")
        case.replace("system/controlDict", "endTime 0.2;", "endTime 0.3;")
        with open(case.path("0.2/fields.h5"), "rb") as file:
            whole = file.read()
        for part in range(1, 16):
            place = len(whole) * part // 16
            data = bytearray(whole)
            data[place] ^= 0x04
            with open(case.path("0.2/fields.h5"), "wb") as file:
                file.write(data)
            with self.subTest(place=place):
                self.refused(case, "fields.h5")

    def test_fields_of_another_lattice(self):
        case = self.ready_case()
        self.succeeds(case, "isphFoam")
        case.replace("system/controlDict", "endTime 0.2;", "endTime 0.3;")
        case.replace("system/latticeDict", "(24 24 1)", "(32 32 1)")
        self.succeeds(case, "makeLattice", "-overwrite")
        self.refused(case, "lattice")

    # -------------------------------------------------------------------------------------------------- no room

    def test_results_cannot_be_written(self):
        # A file where the folder should be stops every user, root included.
        case = self.ready_case()
        case.put("postProcessing", "in the way\n")
        result = case.run("isphFoam")
        self.assertEqual(result.returncode, 1)
        self.assertIn("postProcessing", result.stderr)

    def test_read_only_case(self):
        case = self.ready_case()
        for folder, _, files in os.walk(case.dir, topdown=False):
            for name in files:
                os.chmod(os.path.join(folder, name), 0o444)
            os.chmod(folder, 0o555)
        self.addCleanup(lambda: [os.chmod(folder, 0o755) for folder, _, _ in os.walk(case.dir)])
        before = case.state()
        result = self.run_unprivileged(case)
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertRegex(result.stderr, "(?i)permission|write")
        self.assertEqual(case.state(), before)

    def run_unprivileged(self, case):
        """isphFoam as somebody whom permissions stop; root becomes nobody for it."""
        command = [program("isphFoam"), "-case", case.dir]
        if os.geteuid() == 0:
            if not shutil.which("setpriv"):
                self.skipTest("root may do everything and there is no setpriv")
            nobody = ["setpriv", f"--reuid={NOBODY}", f"--regid={NOBODY}", "--clear-groups"]
            os.chmod(os.path.dirname(case.dir), 0o755)
            if subprocess.run([*nobody, "test", "-x", program("isphFoam")], check=False).returncode != 0:
                self.skipTest("another user cannot reach the programs")
            command = nobody + command
        return subprocess.run(command, text=True, capture_output=True, timeout=60, stdin=subprocess.DEVNULL,
                              env={**os.environ, "HOME": "/nonexistent"}, check=False)


class Diverging(CaseTest):
    def test_step_above_the_limit_is_warned_and_caught(self):
        case = self.ready_case(deltaT="0.25", endTime=60, nu="0", writeControl="runTime", writeInterval="0.25",
                               schemes="viscous explicit; meanFlow none; dealiasing none; convection advective;",
                               mean=(1, 0.5))
        result = case.run("isphFoam")
        self.assertEqual(result.returncode, 3, result.stderr)
        said = result.stderr
        self.assertIn("deltaT", said)
        self.assertRegex(said, r"0\.0\d+|limit")
        self.assertEqual(case.report()["endedBecause"], "diverged")
        for name in case.times():
            if name != "0":
                self.assertNotIn("nan", case.values(name).lower())
                self.assertNotIn("inf", case.values(name).lower())


if __name__ == "__main__":
    unittest.main()
