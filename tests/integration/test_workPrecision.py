"""workPrecision: sweeps of a solver that makes known errors, and of isphFoam; stopped, killed, diverged, refused."""
import csv
import json
import os
import random
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

from cases import Case, CaseTest, header, program, wait_for

# Error 3 N^-order, 0.1 N^2 seconds by its own account; says in $LEDGER what it has finished.
SOLVER = """#!/bin/sh
value() { sed -n "s/^ *$1  *\\\\(.*\\\\);/\\\\1/p" system/flow; }
N="$(value N)"; order="$(value order)"
[ "$N" = "$(value blowsUpAt)" ] && diverge=yes
[ "$N" = "$(value failsAt)" ] && { echo "fakeFoam: system/flow:1: N: is unlucky"; echo End; exit 1; }
mkdir -p postProcessing
awk -v N="$N" -v order="$order" -v diverge="$diverge" 'BEGIN {
    printf "{\\"cpuTime\\": %.17g, \\"wallTime\\": 1, \\"peakMemory\\": 1000, \\"time\\": 0.25, \\"steps\\": %d}\\n", 0.1*N^2, N
    printf "%.17g\\n", 3*N^-order > "error" }' > postProcessing/report.json
[ "$diverge" ] && exit 3
sleep "$(value sleeps)"
[ -z "$LEDGER" ] || echo "$order $N" >> "$LEDGER"
"""

DICTIONARY = """
N 10;
parameters { N (10 20 40); }
set { "system/flow" { N $N; } }
commands (./fakeFoam);
variants
{
    second { set { "system/flow" { order 2; } } }
    fourth { set { "system/flow" { order 4; } } }
}
error { command "cat error"; }
"""


class Fake:
    """A case whose solver is a script."""

    def __init__(self, test, dictionary=DICTIONARY, sleeps=0.01, **flow):
        self.dir = os.path.join(tempfile.mkdtemp(prefix="continua-"), "fake")
        test.addCleanup(shutil.rmtree, os.path.dirname(self.dir), True)
        entries = {"N": 0, "order": 0, "sleeps": sleeps, "blowsUpAt": -1, "failsAt": -1, **flow}
        self.put("system/flow", header("flow") + "".join(f"{key} {value};\n" for key, value in entries.items()))
        self.put("system/workPrecisionDict", header("workPrecisionDict") + dictionary)
        self.put("fakeFoam", SOLVER)
        os.chmod(self.path("fakeFoam"), 0o755)

    path = Case.path
    put = Case.put
    text = Case.text
    replace = Case.replace
    line_of = Case.line_of
    run = Case.run
    start = Case.start


def table(case, name="workPrecision"):
    """Rows of a table of the sweep."""
    with open(case.path("postProcessing", "workPrecision", name + ".csv"), encoding="utf-8") as file:
        return list(csv.DictReader(file))


def orders(case):
    return {row["variant"]: float(row["order"]) for row in table(case, "slopes") if row["order"]}


def without_times(rows):
    return [{key: value for key, value in row.items() if not key.endswith("[s]") and "bytes" not in key} for row in rows]


class Sweeps(CaseTest):
    def fake(self, *arguments, **options):
        return Fake(self, *arguments, **options)

    def sweeps(self, case, *arguments, **options):
        result = case.run("workPrecision", *arguments, **options)
        self.assertEqual(result.returncode, 0, result.stderr + result.stdout)
        return result.stdout

    def refuses(self, case, *parts, arguments=("-list",)):
        result = case.run("workPrecision", *arguments)
        self.assertEqual(result.returncode, 1, result.stdout)
        for part in parts:
            self.assertIn(part, result.stderr)

    def test_slopes_are_those_of_the_solver(self):
        case = self.fake()
        said = self.sweeps(case)
        found = orders(case)
        self.assertAlmostEqual(found["second"], 2, places=9)
        self.assertAlmostEqual(found["fourth"], 4, places=9)
        slopes = {(r["variant"], r["quantity"], r["against"]): float(r["slope"]) for r in table(case, "slopes")}
        self.assertAlmostEqual(slopes["second", "error", "cpuTime"], -1, places=9)
        self.assertAlmostEqual(slopes["fourth", "cpuTime", "N"], 2, places=9)
        self.assertIn("[6/6] fourth, N 40", said)
        rows = table(case)
        self.assertEqual([(r["variant"], r["N"], r["status"]) for r in rows][:3],
                         [("second", "10", "done"), ("fourth", "10", "done"), ("second", "20", "done")])
        self.assertAlmostEqual(float(rows[0]["error"]), 0.03, places=15)
        self.assertEqual(float(rows[0]["cpuTime [s]"]), 10)
        cheapest = {float(r["error"]): r for r in table(case, "cheapest")}
        self.assertEqual(cheapest[1e-5]["cheapest"], "fourth")
        # 3 N^-4 = 1e-5 at N = 23.4, which costs 0.1 N^2
        self.assertAlmostEqual(float(cheapest[1e-5]["cpuTime [s]"]), 0.1*(3e5)**0.5, places=6)
        self.assertEqual(cheapest[1e-2]["second"], "second")
        with open(case.path("postProcessing/workPrecision/provenance.json"), encoding="utf-8") as file:
            provenance = json.load(file)
        self.assertLessEqual({"version", "commit", "compiler", "processor", "cores", "date", "command"}, set(provenance))
        if shutil.which("gnuplot"):
            for kind, head in (("png", b"\x89PNG"), ("svg", b"<?xml")):
                with open(case.path("postProcessing/workPrecision/workPrecision." + kind), "rb") as file:
                    self.assertTrue(file.read().startswith(head))
            svg = case.text("postProcessing/workPrecision/workPrecision.svg")
            self.assertIn("fourth (order 4.00)", svg)

    def test_what_is_done_is_not_repeated(self):
        case = self.fake()
        ledger = case.path("ledger")
        self.sweeps(case, env={"LEDGER": ledger})
        self.assertIn("6 runs", self.sweeps(case, "-list"))
        self.sweeps(case, env={"LEDGER": ledger})
        self.assertEqual(len(case.text("ledger").splitlines()), 6)
        # Other settings are other runs: only those.
        case.replace("system/workPrecisionDict", "order 4;", "order 5;")
        self.sweeps(case, env={"LEDGER": ledger})
        self.assertEqual(len(case.text("ledger").splitlines()), 9)
        self.assertAlmostEqual(orders(case)["fourth"], 5, places=9)
        # Another base case: all of them. So with a program that works on the results.
        case.replace("system/flow", "sleeps 0.01", "sleeps 0.011")
        self.sweeps(case, env={"LEDGER": ledger})
        self.assertEqual(len(case.text("ledger").splitlines()), 15)
        case.put("afterwards", "#!/bin/sh\n")
        os.chmod(case.path("afterwards"), 0o755)
        case.replace("system/workPrecisionDict", "commands", "after (./afterwards);\ncommands")
        self.sweeps(case, env={"LEDGER": ledger})
        case.put("afterwards", "#!/bin/sh\necho 1 > error\n")
        self.sweeps(case, env={"LEDGER": ledger})
        self.assertEqual(len(case.text("ledger").splitlines()), 27)
        self.assertEqual({row["error"] for row in table(case)}, {"1"})

    def test_repetitions_take_the_smallest_time(self):
        case = self.fake(DICTIONARY + "repetitions 3;\n")
        ledger = case.path("ledger")
        self.sweeps(case, "-jobs", "2", env={"LEDGER": ledger})
        self.assertEqual(len(case.text("ledger").splitlines()), 18)
        self.assertEqual({row["repetitions"] for row in table(case)}, {"3"})
        self.assertFalse(os.path.exists(case.path("workPrecision/second/N10.repetition")))

    def test_repetitions_of_a_run_wait_for_each_other(self):
        # More jobs than runs, and a sweep that has only repetitions left.
        case = self.fake(DICTIONARY.replace("10 20 40", "10") + "repetitions 2;\n")
        self.sweeps(case, "-jobs", "5")
        self.assertEqual([row["repetitions"] for row in table(case)], ["2", "2"])
        case.replace("system/workPrecisionDict", "repetitions 2", "repetitions 4")
        self.sweeps(case, "-jobs", "5")
        self.assertEqual([row["repetitions"] for row in table(case)], ["4", "4"])

    def test_a_diverged_run_is_reported_and_left_out(self):
        case = self.fake(blowsUpAt=40)
        said = self.sweeps(case)
        self.assertIn("diverged at t = 0.25", said)
        rows = table(case)
        self.assertEqual([r["status"] for r in rows if r["N"] == "40"], ["diverged", "diverged"])
        self.assertEqual(rows[-1]["message"], "diverged at t = 0.25")
        self.assertEqual(rows[-1]["error"], "")
        self.assertAlmostEqual(orders(case)["second"], 2, places=9)

    def test_a_failed_run_is_reported_with_its_words_and_tried_again(self):
        case = self.fake(failsAt=20)
        said = self.sweeps(case)
        self.assertIn("fakeFoam: system/flow:1: N: is unlucky (exit code 1)", said)
        case.replace("fakeFoam", "exit 1; }", "}")
        self.sweeps(case)
        self.assertEqual({r["status"] for r in table(case)}, {"done"})

    def test_half_a_report_is_that_of_a_failed_run(self):
        case = self.fake(failsAt=20)
        case.replace("fakeFoam", 'echo "fakeFoam:', 'mkdir postProcessing; printf "{\\"cpuTime" > postProcessing/report.json; '
                                                    'echo "fakeFoam:')
        self.assertIn("is unlucky (exit code 1)", self.sweeps(case))
        self.assertEqual([r["status"] for r in table(case) if r["N"] == "20"], ["failed", "failed"])
        self.assertEqual([r["status"] for r in table(case) if r["N"] != "20"], ["done"] * 4)

    def test_exit_codes_reach_a_sweep_whose_parent_ignores_children(self):
        case = self.fake(failsAt=20)
        said = case.run("workPrecision", preexec=lambda: signal.signal(signal.SIGCHLD, signal.SIG_IGN))
        self.assertEqual(said.returncode, 0, said.stderr)
        self.assertIn("is unlucky (exit code 1)", said.stdout)

    def test_it_fails_if_no_run_gives_a_result(self):
        case = self.fake(DICTIONARY.replace("10 20 40", "10"), failsAt=10)
        self.refuses(case, "no run gave a result\n    the first: fakeFoam: system/flow:1: N: is unlucky", arguments=("-quiet",))

    def test_a_run_that_takes_too_long_is_stopped(self):
        case = self.fake(DICTIONARY.replace("10 20 40", "10") + "timeLimit 0.3;\n", sleeps=60)
        start = time.monotonic()
        result = case.run("workPrecision")
        self.assertLess(time.monotonic() - start, 30)
        self.assertIn("exceeded 0.3 s", result.stdout)
        self.assertEqual({r["status"] for r in table(case)}, {"timeLimit"})

    def test_killed_at_any_moment_it_goes_on_to_the_same_table(self):
        whole = self.fake(sleeps=0.1)
        self.sweeps(whole)
        case = self.fake(sleeps=0.1)
        ledger = case.path("ledger")
        moments = random.Random(1).sample(range(1, 400), 10)
        for moment in moments:
            process = subprocess.Popen([program("workPrecision"), "-case", case.dir], stdout=subprocess.DEVNULL,
                                       stderr=subprocess.DEVNULL, env={**os.environ, "LEDGER": ledger})
            time.sleep(moment/1000)
            process.kill()
            process.wait()
        self.sweeps(case, env={"LEDGER": ledger})
        self.assertEqual(without_times(table(case)), without_times(table(whole)))
        self.assertEqual(orders(case), orders(whole))
        # What was finished was not made again, but for a run killed between its last act and its record.
        self.assertLessEqual(len(case.text("ledger").splitlines()), 6 + len(moments))

    def test_what_a_killed_sweep_left_running_is_ended(self):
        case = self.fake(sleeps=300)
        process = case.start("workPrecision")
        self.assertTrue(wait_for(lambda: os.path.exists(case.path("workPrecision/second/N10/postProcessing/report.json"))))
        time.sleep(0.2)  # the script has started a program of its own
        process.kill()
        process.communicate()
        case.replace("system/flow", "sleeps 300", "sleeps 0.01")
        start = time.monotonic()
        self.sweeps(case)
        self.assertLess(time.monotonic() - start, 60)
        self.assertEqual({r["status"] for r in table(case)}, {"done"})

    def test_isphFoam_killed_at_any_moment_gives_the_same_errors(self):
        dictionary = header("workPrecisionDict") + """
N 8;
parameters { N (8 12 16); }
set { "system/latticeDict" { count ($N $N 1); } }
variants { four { set { "system/schemes" { kernel { order 4; } } } } six { } }
error { function errors; column "relL2(U)"; }
"""
        whole = self.case()
        whole.put("system/workPrecisionDict", dictionary)
        self.sweeps(whole)
        case = self.case()
        case.put("system/workPrecisionDict", dictionary)
        for moment in random.Random(2).sample(range(1, 300), 10):
            process = case.start("workPrecision")
            time.sleep(moment/1000)
            process.kill()
            process.communicate()
        self.sweeps(case)
        self.assertEqual(without_times(table(case)), without_times(table(whole)))

    def test_a_signal_stops_what_it_started(self):
        for number, code in ((signal.SIGINT, 130), (signal.SIGTERM, 143)):
            case = self.fake(sleeps=300)
            process = case.start("workPrecision", "-jobs", "2")
            report = case.path("workPrecision/fourth/N10/postProcessing/report.json")
            self.assertTrue(wait_for(lambda: os.path.exists(report)))
            process.send_signal(number)
            out, err = process.communicate(timeout=30)
            self.assertEqual(process.returncode, code, err)
            self.assertIn("goes on with the others", out)
            # The solver's own program, sleep, is gone as well: nothing holds the lock.
            self.assertEqual(subprocess.run(["flock", "-n", case.path("workPrecision/fourth/.N10.lock"), "true"],
                                            check=False).returncode, 0)
            case.replace("system/flow", "sleeps 300", "sleeps 0.01")
            self.sweeps(case)
            self.assertEqual(len(table(case)), 6)

    def test_a_signal_stops_a_command_that_takes_long(self):
        case = self.fake(DICTIONARY.replace("cat error", "touch begun; sleep 300"))
        process = case.start("workPrecision")
        self.assertTrue(wait_for(lambda: os.path.exists(case.path("workPrecision/second/N10/begun"))))
        process.send_signal(signal.SIGTERM)
        process.communicate(timeout=30)
        self.assertEqual(process.returncode, 143)

    def test_a_second_sweep_of_the_same_case_is_refused(self):
        case = self.fake(sleeps=300)
        process = case.start("workPrecision")
        self.addCleanup(process.communicate)
        self.addCleanup(process.kill)
        self.assertTrue(wait_for(lambda: os.path.exists(case.path("workPrecision/second/N10/postProcessing/report.json"))))
        self.refuses(case, "another sweep of this case is running", arguments=())
        self.refuses(case, "another sweep of this case is running", arguments=("-clean",))
        self.assertTrue(os.path.exists(case.path("workPrecision/second/N10/postProcessing/report.json")))

    def test_two_jobs_give_the_table_of_one(self):
        one, two = self.fake(), self.fake()
        self.sweeps(one)
        self.sweeps(two, "-jobs", "2")
        self.assertEqual(without_times(table(one)), without_times(table(two)))

    def test_a_time_step_has_an_order_as_well(self):
        # Here the error grows with the parameter, and the runs become smaller.
        case = self.fake("""
dt 0.1;
parameters { dt (0.1 0.05 0.025); }
set { "system/flow" { N #eval{ 1/$dt }; } }
commands (./fakeFoam);
variants { second { set { "system/flow" { order 2; } } fit { to 0.05; } } }
error { command "cat error"; }
""")
        self.sweeps(case)
        self.assertAlmostEqual(orders(case)["second"], 2, places=9)
        self.assertEqual(table(case, "slopes")[0]["points"], "2")
        self.assertLess(float(table(case, "slopes")[1]["slope"]), 0)

    def test_external_results_are_compared(self):
        case = self.fake(DICTIONARY + """
external { other { file "validation/other.csv"; title "another code"; columns { cpuTime seconds; error relL2; } } }
""")
        case.put("validation/other.csv", "# from somewhere\nN,relL2,seconds\n10,1e-3,0.001\n20,1e-6,0.002\n")
        self.assertIn("another code", self.sweeps(case))
        self.assertEqual({r["cheapest"] for r in table(case, "cheapest")}, {"another code"})
        self.assertIn("with linespoints lw 1.4 dt 3 pt 6", case.text("postProcessing/workPrecision/workPrecision.gp"))

    def test_reduced_has_its_own_lists(self):
        case = self.fake(DICTIONARY + "reduced { parameters { N (4 8); } }\n")
        self.sweeps(case, "-reduced")
        self.assertEqual([r["N"] for r in table(case)], ["4", "4", "8", "8"])

    def test_the_base_case_may_be_another(self):
        base = self.fake()
        case = self.fake(DICTIONARY + 'baseCase "../../%s/fake";\n' % os.path.basename(os.path.dirname(base.dir)))
        case.replace("system/flow", "sleeps", "snores")
        os.remove(case.path("fakeFoam"))
        self.sweeps(case)
        self.assertAlmostEqual(orders(case)["fourth"], 4, places=9)
        self.assertFalse(os.path.exists(base.path("workPrecision")))

    def test_without_gnuplot_there_are_tables(self):
        case = self.fake()
        tools = case.path("tools")
        os.mkdir(tools)
        for tool in ("sh", "sed", "awk", "mkdir", "sleep", "cat"):
            os.symlink(shutil.which(tool), os.path.join(tools, tool))
        said = self.sweeps(case, env={"PATH": tools})
        self.assertIn("no pictures: gnuplot is not installed", said)
        self.assertEqual(len(table(case)), 6)
        self.assertFalse(os.path.exists(case.path("postProcessing/workPrecision/workPrecision.png")))
        published = subprocess.run([program("publishResults"), "-to", case.path("pages"), case.dir], text=True,
                                   capture_output=True, check=False)
        self.assertEqual(published.returncode, 0, published.stderr)
        self.assertNotIn("![", case.text("pages/fake.md") + case.text("pages/README.md"))

    def test_a_page_of_any_name(self):
        case = self.fake('title "a \\"quoted\\" title";\n' + DICTIONARY)
        self.sweeps(case)
        odd = os.path.join(os.path.dirname(case.dir), "it's (odd)")
        os.rename(case.dir, odd)
        results = os.path.join(os.path.dirname(odd), "made", "results")

        def page():
            made = subprocess.run([program("publishResults"), "-to", results, odd], text=True, capture_output=True,
                                  check=False)
            self.assertEqual((made.returncode, made.stderr), (0, ""))
            with open(os.path.join(results, "it's (odd).md"), encoding="utf-8") as file:
                return file.read()

        self.assertTrue(page().startswith("# a \"quoted\" title\n\n"
                                          "![workPrecision](<it's (odd)/workPrecision.png>)\n"))
        with open(os.path.join(results, "README.md"), encoding="utf-8") as file:
            self.assertIn("| [a \"quoted\" title](<it's (odd).md>) |", file.read())
        os.remove(os.path.join(odd, "postProcessing/workPrecision/workPrecision.png")) # no gnuplot
        self.assertNotIn("![", page())
        self.assertEqual(subprocess.run([program("publishResults"), "-to"], capture_output=True, check=False).returncode, 2)

    def test_wrong_options(self):
        case = self.fake()
        for arguments in (("-jobs", "0"), ("-jobs", "two"), ("-plott",)):
            self.assertEqual(case.run("workPrecision", *arguments).returncode, 2)

    def test_plot_and_clean(self):
        case = self.fake()
        self.refuses(case, "no run gave a result", arguments=("-plot",))
        self.sweeps(case)
        shutil.rmtree(case.path("postProcessing"))
        self.sweeps(case, "-plot")
        self.assertEqual(len(table(case)), 6)
        self.assertIn("nothing left to run", self.sweeps(case, "-list"))
        self.assertIn("6 of 6 runs are there already", self.sweeps(case))
        self.sweeps(case, "-clean")
        self.assertFalse(os.path.exists(case.path("workPrecision")))
        self.assertIn("nothing to remove", self.sweeps(case, "-clean"))

    def test_errors_without_a_logarithm_are_told(self):
        # A run without any error is as good as one can ask for; one whose error is no number is not.
        case = self.fake(DICTIONARY.replace(
            "cat error", "case $(cat system/flow) in *'N 20;'*'order 2;'*) echo nan;; *'N 20;'*) echo 0;; "
            "*'order 2;'*) echo 0.1;; *) echo 0.001;; esac"))
        said = self.sweeps(case)
        self.assertIn("second, N 20: error is no number", said)
        self.assertIn("fourth, N 20: error is 0, which has no logarithm", said)
        self.assertNotIn("-0.00", said)
        self.assertEqual([(r["status"], r["error"]) for r in table(case) if r["N"] == "20"], [("done", ""), ("done", "0")])
        self.assertEqual({r["cheapest"] for r in table(case, "cheapest") if float(r["error"]) < 0.1}, {"fourth"})

    def test_an_axis_of_few_decades_has_numbers(self):
        for error, tics in (("echo 0.00003", "'2·10^{-5}' 2e-05, '5·10^{-5}' 5e-05"), ("echo 0.3", "'0.2' 0.2, '0.5' 0.5")):
            case = self.fake(DICTIONARY.replace("cat error", error))
            self.sweeps(case)
            self.assertIn(tics, case.text("postProcessing/workPrecision/workPrecision.gp"))

    def test_no_picture_of_nothing(self):
        case = self.fake(DICTIONARY.replace("cat error", "echo 0"))
        self.assertIn("no workPrecision.svg: nothing to draw", self.sweeps(case))
        self.assertFalse(os.path.exists(case.path("postProcessing/workPrecision/workPrecision.png")))

    def test_lists_of_lists_and_columns_that_only_some_runs_have(self):
        case = self.case(endTime=0.02, functions="")
        case.put("system/workPrecisionDict", header("workPrecisionDict") + """
parameters
{
    count  { values ((10 10 1) (14 14 1)); entry system/latticeDict.count; }
    solver { values (fft CG); entry system/solution.p.solver; }
}
resolution count;
set { "system/schemes" { kernel { order 4; smoothingLength 2; } } }
plot { x count; y cpuTime; }
collect { iterations { report pressureSolver.iterations.mean; optional yes; } }
""")
        self.sweeps(case)
        self.assertEqual([(r["count"], r["points"]) for r in table(case)][::2], [("(10 10 1)", "100"), ("(14 14 1)", "196")])
        for row in table(case):
            self.assertEqual(row["iterations"] == "", row["solver"] == "fft")
        self.assertIn("set xtics ('10' 10, '14' 14)", case.text("postProcessing/workPrecision/workPrecision.gp"))

    def test_a_picture_of_costs(self):
        case = self.fake(DICTIONARY + """
collect { perStep { report cpuTime; per steps; title "seconds of a step"; } }
plot { workPrecision { y error; } cost { x N; y perStep; } }
""")
        self.sweeps(case)
        slopes = {(r["variant"], r["quantity"], r["against"]): float(r["slope"]) for r in table(case, "slopes")}
        self.assertAlmostEqual(slopes["fourth", "perStep", "N"], 1, places=9)
        self.assertIn("set ylabel 'seconds of a step'", case.text("postProcessing/workPrecision/cost.gp"))

    def test_what_is_wrong_is_said_before_anything_is_run(self):
        case = self.fake(DICTIONARY.replace("./fakeFoam", "isphFom"))
        self.refuses(case, "there is no program 'isphFom'", "did you mean 'isphFoam'?")
        case = self.fake(DICTIONARY.replace('"system/flow" { N', '"system/flw" { N'))
        self.refuses(case, "system/workPrecisionDict:%d: " % case.line_of("system/workPrecisionDict", "flw"),
                     "the base case has no file system/flw")
        case = self.fake(DICTIONARY + "baseCase ../nowhere;\n")
        self.refuses(case, "system/workPrecisionDict:%d: baseCase: " % case.line_of("system/workPrecisionDict", "baseCase"),
                     "there is no such case directory")
        case = self.fake("parameters { N { values (10 20); entry system/flw.N; } }\ncommands (./fakeFoam);\n"
                         'error { command "cat error"; }\n')
        self.refuses(case, "system/workPrecisionDict:%d: " % case.line_of("system/workPrecisionDict", "flw"),
                     "the base case has no file system/flw")
        case = self.case()
        case.put("system/workPrecisionDict", header("workPrecisionDict") +
                 'parameters { N (8); }\nerror { function erors; column "relL2(U)"; }\n')
        self.refuses(case, "'erors' is not a known function", "known are: errors, flow")
        self.assertFalse(os.path.exists(case.path("workPrecision")))
        case = self.case()
        self.refuses(case, "system/workPrecisionDict", "is missing", "etc/annotated/workPrecisionDict")

    def test_a_column_that_is_not_there_ends_the_sweep_at_once(self):
        case = self.case()
        case.put("system/workPrecisionDict", header("workPrecisionDict") +
                 'parameters { N (8 12); }\nset { "system/latticeDict" { count ($N $N 1); } }\n'
                 'error { function errors; column "relL2(V)"; }\n')
        self.refuses(case, "errors.csv has no column 'relL2(V)'", "it has: relL2(U)", arguments=())
        self.assertFalse(os.path.exists(case.path("workPrecision/vortex/N12")))


if __name__ == "__main__":
    unittest.main()
