"""scalarTransportFoam: cases that are wrong, restarts in the same bits, what it writes and when it stops."""
import json
import os
import shutil
import signal
import tempfile

from cases import Case, CaseTest, header, unittest, wait_for

EXACT = "exp(-100*(sqr(x - 0.5 - t) + sqr(y - 0.5 - 0.5*t)))"


class ScalarCase(Case):
    """A Gaussian that leaves the unit square, inlets below and left."""

    def __init__(self, intervals=24, endTime=0.2, deltaT="auto", DT="0", schemes="", functions=None, control="",
                 U="uniform (1 0.5 0)", writeInterval="0.1"):
        self.dir = os.path.join(tempfile.mkdtemp(prefix="continua-"), "scalar")
        self.put("system/latticeDict", header("latticeDict") + f"""origin (0 0 0);
extent (1 1 0);
intervals ({intervals} {intervals} 0);
patches
{{
    inlet {{ type patch; faces (xMin yMin); }}
    outlet {{ type patch; faces (xMax yMax); }}
}}
""")
        self.put("constant/transportProperties", header("transportProperties") + f"DT [0 2 -1 0 0 0 0] {DT};\n")
        self.put("0/T", header("T", "latticeScalarField") + f"""dimensions [0 0 0 1 0 0 0];
internalField expression "{EXACT}";
boundaryField
{{
    inlet {{ type fixedValue; value expression "{EXACT}"; }}
    outlet {{ type outflow; }}
}}
""")
        self.put("0/U", header("U", "latticeVectorField") + f"""dimensions [0 1 -1 0 0 0 0];
internalField {U};
boundaryField
{{
    inlet {{ type fixedValue; value uniform (1 0.5 0); }}
    outlet {{ type outflow; }}
}}
""")
        self.put("system/schemes", header("schemes") + f"kernel {{ type gaussian; }}\n{schemes}\n")
        if functions is None:
            functions = f'errors {{ type errorNorms; writeControl writeTime; exact {{ T expression "{EXACT}"; }} }}'
        self.put("system/controlDict", header("controlDict") + f"""application scalarTransportFoam;
startFrom latestTime;
endTime {endTime};
deltaT {deltaT};
maxCo 0.4;
writeControl adjustableRunTime;
writeInterval {writeInterval};
timePrecision 12;
{control}
functions
{{
{functions}
}}
""")


class ScalarTest(CaseTest):
    def scalar(self, **settings):
        case = ScalarCase(**settings)
        self.addCleanup(case.remove)
        self.succeeds(case, "makeLattice")
        return case


class Runs(ScalarTest):
    def test_errors_report_and_folders(self):
        case = self.scalar()
        log = self.succeeds(case, "scalarTransportFoam", "-verbose").stdout
        self.assertEqual(case.times(), ["0", "0.1", "0.2"])
        self.assertEqual(sorted(os.listdir(case.path("0.2"))), ["T", "fields.h5", "uniform"])
        self.assertIn("convection (U . grad) T, U as given", log)
        self.assertIn("T min: ", log)
        last = case.table("errors")[-1]
        self.assertEqual(float(last["time"]), 0.2)
        self.assertLess(float(last["relL2(T)"]), 5e-3)
        self.assertIn("L2(T) [K]", case.text("postProcessing/errors/0/errors.csv"))
        report = case.report()
        self.assertEqual(report["endedBecause"], "endTime")
        self.assertEqual(report["lattice"]["axes"], ["bounded", "bounded"])
        self.assertLess(report["stabilityMargin"]["convective"], 0.8)
        self.assertEqual(report["errors"]["T"]["relL2"], float(last["relL2(T)"]))
        self.assertEqual(report["schemes"]["convection"], "advective")

    def test_probes_and_lines(self):
        case = self.scalar(functions="""
    points { type probes; probeLocations ((0.5 0.5 0) (0 0.25 0)); fields (T U); writeInterval 1; }
    lines { type sampleLines; writeControl writeTime; }
""")
        case.put("system/sampleDict", header("sampleDict")
                 + "lines { middle { start (0 0.5 0); end (1 0.5 0); nPoints 25; } }\nfields (T);\n"
                   "interpolation cubic;\n")
        self.succeeds(case, "scalarTransportFoam")
        with open(case.path("postProcessing/points/0/probes.csv"), encoding="utf-8") as file:
            head, first = file.readline().strip(), file.readline().strip()
        self.assertEqual(head, "time [s],T(0) [K],U.x(0) [m/s],U.y(0) [m/s],U.z(0) [m/s],"
                               "T(1) [K],U.x(1) [m/s],U.y(1) [m/s],U.z(1) [m/s]")
        self.assertEqual([float(value) for value in first.split(",")][:5], [0, 1, 1, 0.5, 0])
        self.assertEqual(sorted(os.listdir(case.path("postProcessing/lines")), key=float), ["0", "0.1", "0.2"])

    def test_programs_read_what_it_writes(self):
        case = self.scalar(endTime=0.1)
        self.succeeds(case, "scalarTransportFoam")
        case.put("system/sampleDict", header("sampleDict")
                 + "lines { middle { start (0 0.5 0); end (1 0.5 0); nPoints 25; } }\nfields (T);\n"
                   "interpolation cubic;\n")
        sampled = self.succeeds(case, "sampleLines", "-latestTime", "-stdout").stdout
        self.assertIn("T [K]", sampled.splitlines()[0])
        self.assertEqual(len(sampled.splitlines()), 26)

    def test_a_velocity_that_changes(self):
        case = self.scalar(U='expression ("1 + t" "0.5*cos(t)" "0")',
                           functions='errors { type errorNorms; writeInterval 1; exact { T expression '
                                     '"exp(-100*(sqr(x - 0.5 - t - t^2/2) + sqr(y - 0.5 - 0.5*sin(t))))"; } }')
        self.succeeds(case, "scalarTransportFoam")
        self.assertLess(case.report()["errors"]["T"]["relL2"], 5e-3)

    def test_words(self):
        case = self.scalar()
        self.assertIn("fixedGradient", self.succeeds(case, "scalarTransportFoam", "-listConditions").stdout)
        listed = self.succeeds(case, "scalarTransportFoam", "-listFunctions").stdout
        self.assertIn("probes", listed)
        self.assertNotIn("flowStatistics", listed)
        self.assertIn("gaussian", self.succeeds(case, "scalarTransportFoam", "-listKernels").stdout)

    def test_second_solver_and_second_start(self):
        case = self.scalar()
        self.succeeds(case, "scalarTransportFoam")
        before = case.values("0.2", "T")
        case.replace("system/controlDict", "startFrom latestTime;", "startFrom startTime;")
        self.succeeds(case, "scalarTransportFoam")
        self.assertEqual(case.values("0.2", "T"), before)


class OnAFlow(CaseTest):
    """A scalar in a periodic box, carried by what isphFoam has computed."""

    def test_velocity_from_fields_h5(self):
        flow = self.ready_case()
        self.succeeds(flow, "isphFoam")
        case = self.ready_case(endTime=0.1, deltaT="auto", functions="", writeControl="adjustableRunTime",
                               writeInterval="0.05", control="application scalarTransportFoam;")
        for name in ("U", "fields.h5"):
            shutil.copy(flow.path("0.2", name), case.path("0", name))
        os.remove(case.path("0/p"))
        case.put("constant/transportProperties", "DT 0.001;\n")
        case.put("0/T", header("T", "latticeScalarField") + """dimensions [0 0 0 0 0 0 0];
internalField expression "1 + sin(2*pi*x)*cos(2*pi*y)";
boundaryField { "[xy]Sides" { type periodic; } }
""")
        self.succeeds(case, "checkCase")
        log = self.succeeds(case, "scalarTransportFoam", "-verbose").stdout
        self.assertIn("dealiasing: two thirds of periodic axes", log)
        self.assertEqual(case.report()["lattice"]["axes"], ["periodic", "periodic"])
        self.assertNotEqual(case.values("0.1", "T"), case.values("0.05", "T"))


class Restart(ScalarTest):
    def test_in_one_go_and_in_two(self):
        for settings in (dict(), dict(DT="0.002"), dict(deltaT="0.005"), dict(schemes="filter { type exponential; }"),
                         dict(U='expression ("1 + t" "0.5*cos(t)" "0")', DT="0.001")):
            with self.subTest(**settings):
                whole = self.scalar(endTime=0.3, **settings)
                self.succeeds(whole, "scalarTransportFoam")
                parts = self.scalar(endTime=0.1, **settings)
                self.succeeds(parts, "scalarTransportFoam")
                parts.replace("system/controlDict", "endTime 0.1;", "endTime 0.3;")
                self.succeeds(parts, "scalarTransportFoam")
                self.assertEqual(parts.times(), whole.times())
                self.assertEqual(parts.values("0.3", "T"), whole.values("0.3", "T"))

    def test_a_written_time_with_new_values(self):
        case = self.scalar(endTime=0.1)
        self.succeeds(case, "scalarTransportFoam")
        case.replace("0.1/T", 'hdf5 "fields.h5"', "uniform 0")
        case.replace("system/controlDict", "endTime 0.1;", "endTime 0.2;")
        self.succeeds(case, "scalarTransportFoam")
        self.assertGreater(float(case.table("errors", "0.1")[0]["Linf(T)"]), 0.9)

    def test_after_a_signal(self):
        settings = dict(intervals=64, endTime=2, writeInterval="0.02")
        whole = self.scalar(**settings)
        self.succeeds(whole, "scalarTransportFoam")
        case = self.scalar(**settings)
        process = case.start("scalarTransportFoam")
        self.assertTrue(wait_for(lambda: len(case.times()) > 3))
        process.send_signal(signal.SIGTERM)
        process.communicate(timeout=60)
        if process.returncode == 0:
            self.skipTest("the run was over before the signal came")
        self.assertEqual(process.returncode, 143)
        self.assertEqual(case.report()["endedBecause"], "signal")
        self.succeeds(case, "scalarTransportFoam")
        self.assertEqual(case.values("2", "T"), whole.values("2", "T"))


class Diverged(ScalarTest):
    def test_a_step_beyond_the_limit(self):
        case = self.scalar(deltaT="0.2", endTime=40, writeInterval="40")
        result = case.run("scalarTransportFoam")
        self.assertEqual(result.returncode, 3)
        self.assertIn("deltaT 0.2 is above the largest stable step", result.stdout + result.stderr)
        self.assertIn("the solution diverged in the step after time", result.stderr)
        self.assertEqual(case.report()["endedBecause"], "diverged")
        self.assertEqual(len(case.times()), 2)
        self.assertNotIn("nan", case.values(case.times()[-1], "T").lower())


class Checked(ScalarTest):
    def test_a_good_case(self):
        case = self.scalar(DT="0.002", schemes="walls consistent;")
        before = case.state()
        check = json.loads(self.succeeds(case, "checkCase", "-json").stdout)
        self.assertEqual(case.state(), before)
        self.assertTrue(check["ok"])
        self.assertEqual(check["transformsPerSubstep"], 6)
        self.assertEqual(check["schemes"]["viscous"], "explicit")
        self.assertEqual(check["withoutEffect"][0]["entry"], "walls")
        self.succeeds(case, "scalarTransportFoam")
        report = case.report()
        self.assertEqual(report["active"], check["active"])
        self.assertEqual(report["leftOut"], check["leftOut"])
        self.assertEqual(report["transformsPerSubstep"], 6)
        self.assertAlmostEqual(report["stabilityMargin"]["viscous"], check["stability"]["margin"]["viscous"],
                               delta=0.05)

    def test_all_slips_at_once(self):
        case = self.scalar(functions="flow { type flowStatistics; }")
        case.replace("0/T", "type outflow;", "type outfow;")
        result = case.run("checkCase")
        self.assertEqual(result.returncode, 1)
        self.assertIn("'outfow' is not a known", result.stderr)
        self.assertIn("'flowStatistics' is not a known function type of a scalar", result.stderr)


class Wrong(ScalarTest):
    def refuses(self, case, file, part, *what):
        """Exit code 1, naming a file and line, and nothing written."""
        before = case.state()
        result = case.run("scalarTransportFoam")
        self.assertEqual(result.returncode, 1, result.stdout[-500:] + result.stderr)
        line = case.line_of(file, part) if part else None
        for text in (f"{file}:{line}" if line else file, *what):
            self.assertIn(text, result.stderr)
        self.assertEqual(case.state(), before)

    def test_field_of_T(self):
        slips = (
            ("type outflow;", "type outfow;", "outfow", "outflow"),
            ("type fixedValue; value", "type fixedValue; gradient", "fixedValue", "value", "is missing"),
            ("outlet { type outflow; }", "", "boundaryField", "patch outlet has no boundary condition"),
            ("outlet { type outflow; }", "outlet { type periodic; }", "type periodic", "is not periodic"),
            ("outlet { type outflow; }", "outlet { type fixedGradient; }", "fixedGradient", "gradient", "is missing"),
            ("outlet {", "exit {", "exit", "is no patch of the lattice"),
            ("inlet { type fixedValue;", "inlet { type outflow;", "boundaryField",
             "patch inlet is outflow, but U enters there"),
            ("type outflow;", "type outflow; valu uniform 0;", "valu uniform", "did you mean 'value'"),
            ("dimensions [0 0 0 1 0 0 0];", "dimensions [0 0 0 1];", "dimensions"),
            (f'internalField expression "{EXACT}"', 'internalField expression "exp(q)"', "exp(q)", "q"),
            (f'internalField expression "{EXACT}"', "internalField uniform", "internalField uniform", "internalField"),
        )
        for old, new, part, *what in slips:
            with self.subTest(new=new):
                case = self.scalar()
                case.replace("0/T", old, new)
                self.refuses(case, "0/T", part if part != "boundaryField" else None, *what)

    def test_a_vector_is_no_scalar(self):
        case = self.scalar()
        case.replace("0/T", f'internalField expression "{EXACT}"', "internalField uniform (1 0 0)")
        case.replace("0/T", "latticeScalarField", "latticeVectorField")
        self.refuses(case, "0/T", None, "is a vector, but T is a scalar")

    def test_walls_let_nothing_out(self):
        case = self.scalar()
        case.replace("system/latticeDict", "outlet { type patch;", "outlet { type wall;")
        self.succeeds(case, "makeLattice", "-overwrite")
        result = case.run("scalarTransportFoam")
        self.assertEqual(result.returncode, 1)
        self.assertIn("outflow", result.stderr)

    def test_a_case_of_a_flow(self):
        case = self.scalar(endTime=0.1)
        self.succeeds(case, "scalarTransportFoam")
        case.put("0.1/U", case.text("0/U"))
        self.refuses(case, "0.1/U", None, "is the velocity of a flow that was solved here")

    def test_missing_files(self):
        for file in ("0/T", "0/U", "constant/transportProperties", "system/schemes"):
            with self.subTest(file):
                case = self.scalar()
                os.remove(case.path(file))
                self.refuses(case, file, None)

    def test_properties(self):
        case = self.scalar(DT="-1")
        self.refuses(case, "constant/transportProperties", "DT", "DT")
        case = self.scalar()
        case.put("constant/transportProperties", "nu 1;\n")
        self.refuses(case, "constant/transportProperties", None, "DT", "is missing")

    def test_schemes(self):
        case = self.scalar(schemes="time firstOrderProjection;")
        self.refuses(case, "system/schemes", "firstOrder", "has no stable step where nothing diffuses")
        case = self.scalar(schemes="operators directSum;")
        self.refuses(case, "system/schemes", "directSum", "directSum is of flows")
        case = self.scalar(schemes="continuation { type smothGram; }")
        self.refuses(case, "system/schemes", "smothGram", "smoothGram")

    def test_functions(self):
        case = self.scalar(functions="flow { type flowStatistics; }")
        self.refuses(case, "system/controlDict", "flowStatistics",
                     "'flowStatistics' is not a known function type of a scalar", "errorNorms")
        case = self.scalar(functions="points { type probes; probeLocations ((0.5 0.5 0)); fields (p); }")
        self.refuses(case, "system/controlDict", "probeLocations", "'p' is not a known field")
        case = self.scalar(functions='errors { type errorNorms; exact { U expression ("1" "0" "0"); } }')
        self.refuses(case, "system/controlDict", "exact")

    def test_a_value_that_is_no_number(self):
        case = self.scalar()
        case.replace("0/T", f'value expression "{EXACT}"', 'value expression "1/(y - y)"')
        self.refuses(case, "0/T", "1/(y - y)", "is infinite at (0 0 0)")


if __name__ == "__main__":
    unittest.main()
