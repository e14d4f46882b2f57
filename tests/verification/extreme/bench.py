"""What the rows of the extreme matrix are made of: a scene that isphFoam runs, its outcome, and checks with a margin.

A row is a function that gets a Bench, runs what it needs and states checks. Each check has a criterion that follows
from theory, and where it is a bound the margin by which it holds: bound over measured value. Standard library only.
"""
import json
import math
import os
import re
import resource
import shutil
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "support"))

from cases import Case, header  # noqa: E402

LONG = 400  # seconds a program may take


class Row:
    """One line of the matrix; slow ones run in the full form only."""

    def __init__(self, identifier, case, setting, asked, function, slow):
        self.id, self.case, self.setting, self.asked = identifier, case, setting, asked
        self.function, self.slow = function, slow
        self.theme = function.__module__


ROWS = []


def row(identifier, case, setting, asked, slow=False):
    """Decorates the function of a row; asked is its criterion, in words."""
    def add(function):
        ROWS.append(Row(identifier, case, setting, asked, function, slow))
        return function
    return add


def short(value, digits=2):
    """A figure with two digits, or more."""
    if value == 0:
        return "0"
    if not math.isfinite(value):
        return str(value)
    text = f"{value:.{digits}g}"
    mantissa, _, exponent = text.partition("e")
    return f"{mantissa}e{int(exponent)}" if exponent else text


def growth(values):
    """The largest growth from one value to the next, relative; negative where all fall."""
    return max(b / a if a > 0 else float(b > 0) for a, b in zip(values, values[1:])) - 1


class Bench:
    """The checks of one row, and its scenes, which go away with it."""

    def __init__(self, full):
        self.full = full
        self.happened, self.failed = [], []
        self.margin = math.inf
        self.scenes = []

    def scene(self, **settings):
        scene = Scene(**settings)
        self.scenes.append(scene)
        return scene

    def copy_of(self, scene):
        copy = scene.copy()
        self.scenes.append(copy)
        return copy

    def close(self):
        for scene in self.scenes:
            shutil.rmtree(os.path.dirname(scene.dir), ignore_errors=True)

    def at_most(self, what, measured, bound):
        """measured <= bound, not a number fails."""
        self.state(f"{what} {short(measured)} (≤ {short(bound)})", measured <= bound)
        if measured > 0:
            self.margin = min(self.margin, bound / measured)
        elif not measured <= 0:
            self.margin = 0

    def at_least(self, what, measured, bound):
        self.state(f"{what} {short(measured)} (≥ {short(bound)})", measured >= bound)
        self.margin = min(self.margin, measured / bound if measured == measured else 0)

    def holds(self, what, condition, otherwise=""):
        """What is true or is not; it has no margin."""
        self.state(what if condition else f"not so: {what}{': ' + otherwise if otherwise else ''}", condition)

    def note(self, what):
        self.happened.append(what)

    def state(self, text, passed):
        self.happened.append(text if passed else f"**{text}**")
        if not passed:
            self.failed.append(text)


class Scene(Case):
    """A flow in a box from dictionaries alone: axes periodic ("p") or between walls ("w"), two or three of them."""

    def __init__(self, *, axes="pp", extent=None, intervals=None, arrangement=None, nu=0.01, start=None, walls=None,
                 pressures=None, force=None, schemes="", kernel="type gaussian;", solver="fft", solution="",
                 deltaT="auto", endTime=1.0,
                 control="", exact=None, statistics=False, every=None, writeInterval="endTime", inlets=()):
        self.dir = os.path.join(tempfile.mkdtemp(prefix="continua-"), "scene")
        names = "xyz"[:len(axes)]
        extent = extent or [1] * len(axes)
        intervals = intervals or [32] * len(axes)
        flat = " 0" if len(axes) == 2 else ""
        patches, U, p = [], [], []
        for axis, kind in zip(names, axes):
            if kind == "p":
                patches.append(f"    {axis} {{ type periodic; axis {axis}; }}\n")
                U.append(f"    {axis} {{ type periodic; }}\n")
                p.append(f"    {axis} {{ type periodic; }}\n")
                continue
            for face in (axis + "Min", axis + "Max"):
                condition = (walls or {}).get(face, "type noSlip;")
                kind = "patch" if "outflow" in condition or face in inlets else "wall"
                patches.append(f"    {face} {{ type {kind}; face {face}; }}\n")
                U.append(f"    {face} {{ {condition} }}\n")
                p.append(f"    {face} {{ {(pressures or {}).get(face, 'type zeroGradient;')} }}\n")
        self.put("system/latticeDict", header("latticeDict")
                 + f"origin (0 0 0);\nextent ({numbers(extent)}{flat});\nintervals ({numbers(intervals)}{flat});\n"
                 + (f"arrangement {arrangement};\n" if arrangement else "") + f"patches\n{{\n{''.join(patches)}}}\n")
        self.put("constant/transportProperties", header("transportProperties") + f"nu {nu!r};\n"
                 + (f"bodyForce {vector(force)};\n" if force else ""))
        self.put("0/U", header("U", "latticeVectorField") + "dimensions [0 1 -1 0 0 0 0];\n"
                 + f"internalField {vector(start or ())};\nboundaryField\n{{\n{''.join(U)}}}\n")
        self.put("0/p", header("p", "latticeScalarField") + "dimensions [0 2 -2 0 0 0 0];\ninternalField uniform 0;\n"
                 + f"boundaryField\n{{\n{''.join(p)}}}\n")
        self.put("system/schemes", header("schemes") + f"kernel {{ {kernel} }}\n{schemes}\n")
        self.put("system/solution", header("solution") + f"p {{ solver {solver}; }}\n{solution}\n")
        when = f"writeControl timeStep; writeInterval {every};" if every else "writeControl onEnd;"
        functions = f"    flow {{ type flowStatistics; {when} }}\n" if statistics else ""
        if exact:
            functions += f"    errors {{ type errorNorms; {when} exact {{ U {vector(exact)}; }} }}\n"
        deltaT = deltaT if isinstance(deltaT, str) else repr(deltaT)
        self.put("system/controlDict", header("controlDict") + f"application isphFoam;\nendTime {endTime!r};\n"
                 f"deltaT {deltaT};\nwriteControl timeStep;\nwriteInterval {writeInterval};\n{control}\n"
                 f"functions\n{{\n{functions}}}\n")

    def solve(self, *arguments, timeout=LONG):
        """makeLattice and isphFoam; the outcome."""
        made = self.run("makeLattice", "-overwrite", timeout=timeout)
        return Outcome(self, made if made.returncode else self.run("isphFoam", *arguments, timeout=timeout))

    def limits(self):
        """What checkCase says of stability; makes the lattice."""
        made = self.run("makeLattice", "-overwrite")
        if made.returncode:
            raise RuntimeError(made.stderr)
        checked = self.run("checkCase", "-json")
        if checked.returncode:
            raise RuntimeError(checked.stderr)
        return json.loads(checked.stdout)["stability"]

    def field(self, time=None, dataset="U"):
        """Values of a dataset at a time, the last one by default, as written; vectors point by point."""
        text = self.values(time or self.times()[-1], dataset).split("}")[0]
        return [float(word) for word in re.findall(r"[-+0-9.a-z]+", text)]

    def step(self, deltaT, endTime):
        self.set("system/controlDict", "deltaT", deltaT if isinstance(deltaT, str) else repr(deltaT))
        self.set("system/controlDict", "endTime", repr(endTime))


class Outcome:
    """What came of a run."""

    def __init__(self, scene, result):
        self.scene, self.code, self.out, self.err = scene, result.returncode, result.stdout, result.stderr

    @property
    def ended(self):
        return self.scene.report()["endedBecause"] if self.code in (0, 3) else f"exit {self.code}"

    def demand(self):
        """The outcome itself where the run was done; an error of the row otherwise."""
        if self.code != 0:
            raise RuntimeError(f"exit {self.code}: {self.err.strip()}")
        return self

    def column(self, function, name):
        return [float(entry[name]) for entry in self.demand().scene.table(function)]

    def error(self, norm="L2(U)"):
        return self.column("errors", norm)[-1]


def numbers(values):
    return " ".join(value if isinstance(value, str) else repr(value) for value in values)


def vector(components):
    """A vector of expressions of x, y, z, t; components left out are zero."""
    components = [str(component) for component in components]
    components += ["0"] * (3 - len(components))
    return "expression (" + " ".join(f'"{component}"' for component in components) + ")"


def refused(bench, what, outcome, place, cure=None):
    """Exit code 1, with the place and a cure on the standard error; no files of a run."""
    first = outcome.err.strip().splitlines()[0] if outcome.err.strip() else "nothing said"
    bench.holds(f"{what}: refused, “{first.split(': ', 1)[-1]}”",
                outcome.code == 1 and re.search(place, outcome.err) and (not cure or re.search(cure, outcome.err)),
                f"exit {outcome.code}, {outcome.err.strip()}")


def caught(bench, what, outcome, stable):
    """Exit code 3 with the reason; the last good state is whole, finite, and goes on in stable steps."""
    scene = outcome.scene
    last = re.search(r"diverged[^\n]*", outcome.err)
    bench.holds(f"{what}: exit 3, “{last.group(0) if last else ''}”",
                outcome.code == 3 and outcome.ended == "diverged" and last and "stable" in outcome.err,
                f"exit {outcome.code}, {outcome.err.strip()}")
    if outcome.code != 3:
        return
    time = scene.times()[-1]
    if float(time) > 0:
        parts = ("U", "p", "fields.h5", "uniform/time")
        bench.holds(f"folder {time} whole", all(os.path.exists(scene.path(time, part)) for part in parts))
        bench.holds("its fields finite", all(map(math.isfinite, scene.field(time) + scene.field(time, "p"))))
    else:
        bench.note("diverged in the first steps: the start is the last good state")
    # A flow that was about to be lost is fast: a hundredth of a step is what it takes to see that it is whole.
    scene.step("auto", float(time) + 0.01 * stable)
    again = Outcome(scene, scene.run("isphFoam", timeout=LONG))
    bench.holds("it goes on in stable steps", again.code == 0 and all(map(math.isfinite, scene.field())),
                f"exit {again.code}, {again.err.strip()}")


def measure(entry, full):
    """Runs a row; its record."""
    bench = Bench(full)
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    try:
        entry.function(bench)
    except Exception as problem:  # a row that could not be run is a row that failed; the others go on
        bench.state(f"{type(problem).__name__}: {problem}", False)
    finally:
        bench.close()
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    cpu = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return {"id": entry.id, "theme": entry.theme, "case": entry.case, "setting": entry.setting, "asked": entry.asked,
            "happened": bench.happened, "failed": bench.failed, "full": full, "cpu": round(cpu, 2),
            "margin": bench.margin if math.isfinite(bench.margin) else None}
