"""Cases and programs for the tests that run programs: write a case, run, look at what came out.

The programs are those of CONTINUA_BIN (ctest sets it). Standard library only.
"""
import csv
import json
import math
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", ".."))
BIN = os.environ.get("CONTINUA_BIN", os.path.join(ROOT, "build", "bin"))
TIMEOUT = 240


def program(name):
    """Path of a program of the suite, or of a script in bin/."""
    built = os.path.join(BIN, name)
    return built if os.path.exists(built) else os.path.join(ROOT, "bin", name)


def run(name, *arguments, cwd=None, env=None, timeout=TIMEOUT, preexec=None):
    """Runs a program; the result has returncode, stdout and stderr."""
    return subprocess.run(
        [program(name), *map(str, arguments)], cwd=cwd, timeout=timeout, text=True, capture_output=True,
        stdin=subprocess.DEVNULL, env={**os.environ, **(env or {})}, preexec_fn=preexec)


def header(name, kind="dictionary"):
    return f"FoamFile\n{{\n    version 2.0;\n    format ascii;\n    class {kind};\n    object {name};\n}}\n\n"


class Case:
    """A two-dimensional Taylor-Green vortex with a mean flow in the unit box, exact solution attached."""

    def __init__(self, points=24, endTime=0.2, deltaT="0.005", nu="0.01", mean=(0.3, 0.1), control="", schemes="",
                 writeControl="timeStep", writeInterval="10", functions=None):
        self.dir = os.path.join(tempfile.mkdtemp(prefix="continua-"), "vortex")
        X, Y = f"(2*pi*(x - {mean[0]}*t))", f"(2*pi*(y - {mean[1]}*t))"
        decay = "exp(-8*pi^2*nu*t)"
        U = (f'("{mean[0]} - cos{X}*sin{Y}*{decay}" "{mean[1]} + sin{X}*cos{Y}*{decay}" "0")')
        p = f'"-0.25*(cos(2*{X}) + cos(2*{Y}))*{decay}^2"'
        self.put("system/latticeDict", header("latticeDict") + f"""origin (-0.5 -0.5 0);
extent (1 1 0);
count ({points} {points} 1);
patches
{{
    xSides {{ type periodic; axis x; }}
    ySides {{ type periodic; axis y; }}
}}
""")
        self.put("constant/transportProperties", header("transportProperties") + f"""nu [0 2 -1 0 0 0 0] {nu};
rho [1 -3 0 0 0 0 0] 1;
""")
        sides = "boundaryField\n{\n    xSides { type periodic; }\n    ySides { type periodic; }\n}\n"
        self.put("0/U", header("U", "latticeVectorField")
                 + f"dimensions [0 1 -1 0 0 0 0];\ninternalField expression {U};\n{sides}")
        self.put("0/p", header("p", "latticeScalarField")
                 + f"dimensions [0 2 -2 0 0 0 0];\ninternalField expression {p};\n{sides}")
        self.put("system/schemes", header("schemes")
                 + f"kernel {{ type gaussian; order 6; smoothingLength 1.5; }}\n{schemes}\n")
        self.put("system/solution", header("solution") + "p { solver fft; }\n")
        self.put("system/sampleDict", header("sampleDict") + """lines
{
    centre { start (0 -0.5 0); end (0 0.5 0); nPoints 25; }
}
fields (U p);
interpolation spectral;
""")
        if functions is None:
            functions = (f"    errors {{ type errorNorms; writeControl timeStep; writeInterval 5; "
                         f"exact {{ U expression {U}; p expression {p}; }} }}\n"
                         "    flow { type flowStatistics; writeControl timeStep; writeInterval 5; }\n")
        self.put("system/controlDict", header("controlDict") + f"""application isphFoam;
startFrom latestTime;
startTime 0;
stopAt endTime;
endTime {endTime};
deltaT {deltaT};
writeControl {writeControl};
writeInterval {writeInterval};
{control}
functions
{{
{functions}}}
""")

    # ------------------------------------------------------------------------------------------------------- files

    def path(self, *parts):
        return os.path.join(self.dir, *parts)

    def put(self, relative, text):
        os.makedirs(os.path.dirname(self.path(relative)), exist_ok=True)
        with open(self.path(relative), "w", encoding="utf-8") as file:
            file.write(text)

    def text(self, relative):
        with open(self.path(relative), encoding="utf-8") as file:
            return file.read()

    def replace(self, relative, old, new):
        text = self.text(relative)
        assert old in text, f"{old!r} is not in {relative}"
        self.put(relative, text.replace(old, new, 1))

    def line_of(self, relative, part):
        """Number of the first line that holds part."""
        for number, line in enumerate(self.text(relative).splitlines(), 1):
            if part in line:
                return number
        raise AssertionError(f"{part!r} is not in {relative}")

    def remove(self):
        shutil.rmtree(os.path.dirname(self.dir), ignore_errors=True)

    def copy(self):
        """The same case, results included, somewhere else."""
        other = object.__new__(Case)
        other.dir = os.path.join(tempfile.mkdtemp(prefix="continua-"), "vortex")
        shutil.copytree(self.dir, other.dir)
        return other

    # ---------------------------------------------------------------------------------------------------- programs

    def run(self, name, *arguments, **options):
        return run(name, *arguments, "-case", self.dir, **options)

    def start(self, name, *arguments):
        """Starts a program and returns at once."""
        return subprocess.Popen([program(name), *arguments, "-case", self.dir], stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, stdin=subprocess.DEVNULL, text=True)

    def set(self, relative, entry, value):
        result = self.run("caseDict", relative, "-entry", entry, "-set", value)
        assert result.returncode == 0, result.stderr

    # ----------------------------------------------------------------------------------------------------- results

    def times(self):
        """Names of the time folders in order of time."""
        names = []
        for name in os.listdir(self.dir):
            try:
                names.append((float(name), name))
            except ValueError:
                pass
        return [name for _, name in sorted(names)]

    def table(self, function, start=None):
        """Rows of a function's newest CSV file, columns named without their units."""
        folder = self.path("postProcessing", function)
        start = start or max(os.listdir(folder), key=float)
        name = sorted(n for n in os.listdir(os.path.join(folder, start)) if n.endswith(".csv"))[0]
        with open(os.path.join(folder, start, name), encoding="utf-8") as file:
            return [{key.split(" [")[0]: value for key, value in row.items()} for row in csv.DictReader(file)]

    def report(self):
        return json.loads(self.text("postProcessing/report.json"))

    def state(self):
        """Every path below the case with size and content, for "nothing was written"."""
        found = {}
        for folder, names, files in os.walk(self.dir):
            for name in names:
                found[os.path.relpath(os.path.join(folder, name), self.dir)] = "folder"
            for name in files:
                with open(os.path.join(folder, name), "rb") as file:
                    found[os.path.relpath(os.path.join(folder, name), self.dir)] = file.read()
        return found

    def values(self, time, dataset="U"):
        """The values of a dataset as h5dump prints them, to 17 digits."""
        result = subprocess.run(["h5dump", "-m", "%.17g", "-y", "-w", "0", "-d", "/" + dataset,
                                 self.path(time, "fields.h5")], text=True, capture_output=True, check=True)
        return result.stdout.split("DATA {", 1)[1]


def wait_for(condition, seconds=60):
    """Waits until condition() is true; whether it became so."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        if condition():
            return True
        time.sleep(0.01)
    return False


class CaseTest(unittest.TestCase):
    """A test with a case that goes away afterwards."""

    def case(self, **settings):
        case = Case(**settings)
        self.addCleanup(case.remove)
        return case

    def copy_of(self, case):
        copy = case.copy()
        self.addCleanup(copy.remove)
        return copy

    def ready_case(self, **settings):
        """A case with its lattice made."""
        case = self.case(**settings)
        self.succeeds(case, "makeLattice")
        return case

    def succeeds(self, case, name, *arguments, **options):
        result = case.run(name, *arguments, **options)
        self.assertEqual(result.returncode, 0, f"{name} {arguments}: {result.stderr}\n{result.stdout[-2000:]}")
        return result

    def same_state(self, a, time_a, b, time_b):
        for dataset in ("U", "p"):
            self.assertEqual(a.values(time_a, dataset), b.values(time_b, dataset), f"{dataset} differs in its bits")
