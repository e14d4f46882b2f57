"""caseDict reads and changes entries, and what it writes OpenFOAM's own parser reads."""
import os
import shutil
import subprocess
import time
import unittest

from cases import CaseTest, ROOT

TEXT = """FoamFile { version 2.0; format ascii; class dictionary; object schemes; }
// Chosen by hand.
kernel
{
    type    gaussian;       // the kernel
    order   #eval{ 2*5 };   // even
}
half    $:kernel.order;
"x(Min|Max)" { type wall; }
#include "more"
"""


class CaseDict(CaseTest):
    def schemes(self):
        case = self.case()
        case.put("system/schemes", TEXT)
        case.put("system/more", "given (1 0 0);\n")
        return case

    def printed(self, case, *arguments):
        result = case.run("caseDict", "system/schemes", *arguments)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result.stdout

    def text(self, case):
        with open(case.path("system/schemes"), encoding="utf-8") as file:
            return file.read()

    def test_reads(self):
        case = self.schemes()
        self.assertEqual(self.printed(case), TEXT)
        self.assertEqual(self.printed(case, "-entry", "kernel.order", "-value"), "10\n")
        self.assertEqual(self.printed(case, "-entry", "kernel/type"), "type            gaussian;\n")
        self.assertEqual(self.printed(case, "-entry", "given", "-value"), "(1 0 0)\n")
        self.assertEqual(self.printed(case, "-entry", "kernel", "-keywords"), "type\norder\n")
        self.assertEqual(self.printed(case, "-keywords"), 'FoamFile\nkernel\nhalf\n"x(Min|Max)"\ngiven\n')
        self.assertIn("half            10;\n", self.printed(case, "-expand"))

    def test_changes_nothing_else(self):
        case = self.schemes()
        for arguments, old, new in (
                (("-entry", "kernel.order", "-set", "12"), "#eval{ 2*5 }", "12"),
                (("-entry", "kernel.h", "-add", "1.5"), "// even\n}", "// even\n    h               1.5;\n}"),
                (("-entry", '"x(Min|Max)".type', "-set", "slip"), "wall", "slip"),
                (("-entry", "kernel.type", "-remove"), "    type    gaussian;       // the kernel\n", ""),
                (("-entry", "given", "-set", "(0 1 0)"), '"more"\n', '"more"\ngiven           (0 1 0);\n')):
            with self.subTest(arguments):
                expected = self.text(case).replace(old, new, 1)
                self.assertEqual(self.printed(case, *arguments), "")
                self.assertEqual(self.text(case), expected)
        self.assertEqual(os.listdir(case.path("system")).count("schemes"), 1)

    def test_refuses_and_leaves_the_file(self):
        case = self.schemes()
        for code, message, *arguments in (
                (1, "system/schemes:4: kernel.odrer: does not exist\n    did you mean kernel.order?",
                 "-entry", "kernel.odrer", "-value"),
                (1, "cannot be set to 1; b 2", "-entry", "half", "-set", "1; b 2"),
                (1, "half: ends before its ')'", "-entry", "half", "-set", "(1"),
                (1, "exists already", "-entry", "half", "-add", "1"),
                (1, "comes from a macro, a pattern or an included file", "-entry", "given", "-remove"),
                (2, "-set needs an -entry", "-set", "1"),
                (2, "-set and -remove exclude each other", "-entry", "half", "-set", "1", "-remove"),
                (2, "unknown option -valeu", "-entry", "half", "-valeu")):
            with self.subTest(arguments):
                result = case.run("caseDict", "system/schemes", *arguments)
                self.assertEqual(result.returncode, code)
                self.assertIn(message, result.stderr)
                self.assertEqual(self.text(case), TEXT)
        result = case.run("caseDict", "system/none")
        self.assertIn("system/none: cannot be read: No such file or directory", result.stderr)

    def test_a_file_that_cannot_be_written_stays(self):
        if os.geteuid() == 0:
            self.skipTest("root may write everywhere")
        case = self.schemes()
        os.chmod(case.path("system"), 0o500)
        result = case.run("caseDict", "system/schemes", "-entry", "half", "-set", "1")
        os.chmod(case.path("system"), 0o700)
        self.assertEqual(result.returncode, 1)
        self.assertEqual(self.text(case), TEXT)

    def test_starts_at_once(self):
        case = self.schemes()
        fastest = 1.0
        for _ in range(5):
            begin = time.perf_counter()
            self.printed(case, "-entry", "half", "-value")
            fastest = min(fastest, time.perf_counter() - begin)
        self.assertLess(fastest, 0.1) # milliseconds; the rest is a busy machine

    @unittest.skipIf(shutil.which("foamDictionary") is None, "OpenFOAM is not installed")
    def test_openfoam_reads_what_it_writes_the_same(self):
        case = self.schemes()
        case.put("system/schemes", TEXT.replace("$:kernel", "$kernel")
                 + '#includeEtc "solutions/gresho"\nb { c (1 (2 3)); d "e f"; g; n -1.5e-07; }\n')
        case.put("system/expanded", self.printed(case, "-expand"))
        environment = {**os.environ, "WM_PROJECT_SITE": ROOT,
                       "WM_PROJECT_DIR": os.environ.get("WM_PROJECT_DIR", "/usr/share/openfoam")}

        def foam(name):
            result = subprocess.run(["foamDictionary", "-expand", case.path(name)], env=environment, text=True,
                                    capture_output=True, timeout=60, check=False)
            self.assertEqual(result.returncode, 0, result.stderr)
            return result.stdout[result.stdout.index("FoamFile"):].split()  # behind the banner, which names the file
        self.assertEqual(foam("system/expanded"), foam("system/schemes"))


if __name__ == "__main__":
    unittest.main()
