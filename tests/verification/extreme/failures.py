"""What cannot work: schemes known to blow up are caught and can be cured, scenes that make no sense are refused."""
import math
import re
import resource

from bench import Outcome, refused, row

LAYER = ("y <= 0.5 ? tanh(80*(y - 0.25)) : tanh(80*(0.75 - y))", "0.05*sin(2*pi*(x + 0.25))")


def shearLayer(bench, kernel, schemes, Re, lost):
    """A thin shear layer on too few points: lost when the theory's table says, and cured from the last good state."""
    scene = bench.scene(intervals=(64, 64), nu=1 / Re, start=LAYER, endTime=2.0, kernel=kernel, schemes=schemes,
                        statistics=True,
                        every=1, writeInterval=20, control="maxCo 0.4;")
    run = scene.solve()
    bench.holds("exit 3 with reason and cure", run.code == 3 and "diverged" in run.err
                and "dealiasing twoThirds" in run.err,
                f"exit {run.code}, {run.err.strip()}")
    if run.code != 3:
        return
    last = scene.times()[-1]
    K = [float(entry["kineticEnergy"]) for entry in scene.table("flow")]
    t = [float(entry["time"]) for entry in scene.table("flow")]
    gone = next((time for time, energy in zip(t, K) if not energy < 1.5 * K[0]), t[-1])
    bench.at_most(f"energy grows by half at t = {gone:.3g}, off the theory's {lost:g} by", abs(gone / lost - 1), 0.25)
    bench.holds(f"folder {last} whole and finite", all(map(math.isfinite, scene.field(last) + scene.field(last, "p"))))
    # From a folder written before, with what the message advises.
    before = [name for name in scene.times() if float(name) < 0.8 * gone][-1]
    scene.replace("system/controlDict", "application", f"startFrom startTime; startTime {before};\napplication")
    scene.put("system/schemes", "kernel { type gaussian; order 10; }\nfilter { type exponential; }\n")
    again = Outcome(scene, scene.run("isphFoam"))
    bench.holds(f"with the cure it goes on from {before}", again.code == 0, again.err.strip())
    if again.code == 0:
        bench.at_most("energy at the end over its start", [float(e["kineticEnergy"])
                                                           for e in scene.table("flow")][-1] / K[0], 1)


def polynomials(bench):
    """`preset paper2026` in a cavity on 24 intervals: its viscous term grows; checkCase says so, the solver stops."""
    scene = bench.scene(axes="ww", intervals=(24, 24), nu=0.01, schemes="preset paper2026;",
                        kernel="type gaussian; order 4;",
                        walls={"yMax": "type fixedValue; value uniform (1 0 0);"}, endTime=50.0)
    scene.run("makeLattice")
    checked = scene.run("checkCase")
    bench.holds("checkCase warns of growing modes", "anti-diffusive" in checked.stdout + checked.stderr)
    run = scene.solve()
    bench.holds("exit 3 with reason and cure", run.code == 3 and "diverged" in run.err
                and "another continuation" in run.err,
                f"exit {run.code}, {run.err.strip()}")


SLIPS = (
    ("order 65", dict(kernel="type gaussian; order 65;"), r"system/schemes:\d+: kernel.order", "even"),
    ("order 0", dict(kernel="type gaussian; order 0;"), r"system/schemes:\d+: kernel.order", "even"),
    ("h/dx 0", dict(kernel="type gaussian; smoothingLength 0;"), r"system/schemes:\d+: kernel.smoothingLength",
     "positive"),
    ("h/dx -1", dict(kernel="type gaussian; smoothingLength -1;"), r"system/schemes:\d+: kernel.smoothingLength", ""),
    ("one length for all axes", dict(kernel="type gaussian; h 0.01;"), r"system/schemes:\d+: kernel.h",
     "smoothingLength"),
    ("nu -1", dict(nu=-1.0), r"constant/transportProperties:\d+: nu", ""),
    ("nu not a number", dict(nu=float("nan")), r"constant/transportProperties:\d+: nu", ""),
    ("extent 0 1", dict(extent=(0, 1)), r"system/latticeDict:\d+", ""),
    ("extent 1e400", dict(extent=("1e400", 1)), r"system/latticeDict:\d+", "too large"),
    ("0 intervals", dict(intervals=(0, 32)), r"system/latticeDict:\d+: intervals", ""),
    ("1e15 points and more", dict(intervals=(100000000, 100000000)), r"system/latticeDict:\d+", "fewer points"),
    ("a start of 1/0", dict(start=("1/(x - x)",)), r"0/U:\d+", ""),
    ("a start of 1e300 sin", dict(start=("1e300*sin(2*pi*y)", "1e300*sin(2*pi*x)")), "0/U|diverged|finite", ""),
    ("an integrating factor between walls", dict(axes="pw", schemes="viscous integratingFactor;"),
     r"system/schemes:\d+", ""),
    ("Crank-Nicolson in a periodic box", dict(schemes="viscous CrankNicolson;"), r"system/schemes:\d+", ""),
    ("a wall that blows into a closed box", dict(axes="ww", walls={"xMin": "type fixedValue; value uniform (1 0 0);"}),
     r"0/U", "volume|flow"),
    ("endTime before the start", dict(endTime=-1.0), r"system/controlDict:\d+", ""),
)


def slips(bench):
    for what, settings, place, cure in SLIPS:
        scene = bench.scene(**{"endTime": 0.1, "deltaT": 0.01, **settings})
        run = scene.solve()
        if what == "a start of 1e300 sin":
            # The square of a speed is beyond numbers: not a slip of the dictionary, but no result either.
            bench.holds(f"{what}: exit {run.code}, said so", run.code in (1, 3) and re.search(place, run.err),
                        run.err.strip())
        else:
            refused(bench, what, run, place, cure)


def memory(bench):
    """A lattice that no memory holds, under a limit so that the machine does not have to find out."""
    most = 256 << 20

    def limited():
        resource.setrlimit(resource.RLIMIT_AS, (most, most))

    for axes in ("pp", "pw"):
        scene = bench.scene(axes=axes, intervals=(1000000, 1000000), start=("sin(2*pi*y)",), endTime=0.1)
        refused(bench, f"10¹² points, {axes}", scene.solve(), "memory", "fewer points")
        scene = bench.scene(axes=axes, intervals=(2000, 2000), start=("sin(2*pi*y)",), endTime=0.1)
        scene.run("makeLattice")
        run = Outcome(scene, scene.run("isphFoam", preexec=limited))
        refused(bench, f"2000² points, {axes}, under a limit of 256 MiB", run, "memory", "points")
        bench.holds("nothing written", scene.times() == ["0"])


for number, (kernel, schemes, Re, lost) in enumerate((
        ("type exact;", "dealiasing none;", 1e4, 0.53),
        ("type gaussian; order 10; smoothingLength 1.5;", "dealiasing none;", 1e4, 1.26),
        ("type exact;", "dealiasing none;", 1e6, 0.53),
        ("type gaussian; order 4; smoothingLength 2;", "convection advective; dealiasing none;", 1e6, 1.26)), 1):
    row(f"B{number}", "thin shear layer, schemes that the theory warns of", f"{kernel} {schemes} Re {Re:g}, 64²",
        f"lost at t = {lost:g} within 25 %, exit 3, last state whole, cured by what the message says")(
        lambda bench, k=kernel, s=schemes, Re=Re, t=lost: shearLayer(bench, k, s, Re, t))
row("B11", "lid-driven cavity, `preset paper2026`", "24², where its viscous term grows",
    "warned, exit 3 with cure")(polynomials)
row("B12", f"{len(SLIPS)} slips", "one a dictionary", "exit 1 with place and cure")(slips)
row("B13", "a lattice larger than the memory", "10¹² points; 2000² in 256 MiB",
    "exit 1, said so, nothing written")(memory)
