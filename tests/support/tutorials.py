"""Cases of the tutorials, to run with other settings than their Allrun has, and profiles to compare."""
import bisect
import csv
import os
import shutil
import tempfile

from cases import ROOT, Case

LONG = 3600  # seconds a solver may take


class Tutorial(Case):
    """A copy of a tutorial's dictionaries."""

    def __init__(self, name, solver="isphFoam"):
        self.source = os.path.join(ROOT, "tutorials", solver, name)
        self.dir = os.path.join(tempfile.mkdtemp(prefix="continua-"), name)
        for folder in ("0", "constant", "system"):
            shutil.copytree(os.path.join(self.source, folder), self.path(folder), ignore=shutil.ignore_patterns("lattice"))

    def set_flow(self, nu, intervals, end, **schemes):
        """Viscosity, intervals of each axis and end time; further entries of system/schemes, / for . in their names."""
        self.set("constant/transportProperties", "nu", f"[0 2 -1 0 0 0 0] {nu!r}")
        self.set("system/latticeDict", "intervals", "(%d %d 0)" % intervals)
        self.set("system/controlDict", "endTime", f"{end!r}")
        self.set("system/controlDict", "writeInterval", f"{end!r}")
        for entry, value in schemes.items():
            self.set("system/schemes", entry.replace("__", "/"), value)

    def solve(self, test, sample=True):
        for program in ("makeLattice", "isphFoam") + (("sampleLines",) if sample else ()):
            test.succeeds(self, program, *(["-latestTime"] if program == "sampleLines" else []), timeout=LONG)

    def line(self, name, abscissa, field):
        """Abscissae and values of a sampled line at the last time."""
        time = max(os.listdir(self.path("postProcessing", "sampleLines")), key=float)
        with open(self.path("postProcessing", "sampleLines", time, name + ".csv"), encoding="utf-8") as file:
            rows = [{key.split(" [")[0]: value for key, value in row.items()} for row in csv.DictReader(file)]
        return [float(row[abscissa]) for row in rows], [float(row[field]) for row in rows]

    def reference(self, name, abscissa, field):
        """Two columns of a file in validation/."""
        with open(os.path.join(self.source, "validation", name), encoding="utf-8") as file:
            rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
        return [float(row[abscissa]) for row in rows], [float(row[field]) for row in rows]


def at(x, xs, ys):
    """Linear interpolation."""
    i = min(max(bisect.bisect_left(xs, x), 1), len(xs) - 1)
    return ys[i - 1] + (ys[i] - ys[i - 1]) * (x - xs[i - 1]) / (xs[i] - xs[i - 1])


def deviation(result, reference):
    """The largest difference of a profile to a reference, at the points of the reference."""
    return max(abs(at(x, *result) - y) for x, y in zip(*reference))


def peak(times, values, start, end):
    """Time and height of the largest value between two times, by a parabola through three points."""
    m = max((n for n in range(1, len(times) - 1) if start < times[n] < end), key=lambda n: values[n])
    a, b = times[m - 1] - times[m], times[m + 1] - times[m]
    left, right = (values[m - 1] - values[m]) / a, (values[m + 1] - values[m]) / b
    curvature = (left - right) / (a - b)
    offset = (right - curvature * b) / (-2 * curvature)
    return times[m] + offset, values[m] - curvature * offset**2
