"""Boxes up to 1000 times as long as wide, and lattices with one point along an axis."""
import math

from bench import growth, refused, row
from symbols import morris, wallDefect


def stretched(bench, extent, counts):
    """psi = cos(kx x) cos(ky y) decays by its symbol on lattices whose spacings differ a thousandfold."""
    nu, end = 1e-3, 5.0
    k = [2 * math.pi / L for L in extent]
    # Slowly: the shear is unstable to waves along x, which would lift round-off into sight.
    wave = (f"-0.01*{k[1]!r}*cos({k[0]!r}*x)*sin({k[1]!r}*y)", f"0.01*{k[0]!r}*sin({k[0]!r}*x)*cos({k[1]!r}*y)")
    for order in (4, 10):
        rate = nu * morris(k, [1.5 * L / n for L, n in zip(extent, counts)], order)
        scene = bench.scene(extent=extent, intervals=counts, nu=nu, start=wave, deltaT=end / 50, endTime=end,
                            exact=[f"({u})*{math.exp(rate * end)!r}" for u in wave],
                            kernel=f"type gaussian; order {order}; smoothingLength 1.5;")
        error = scene.solve().error("relL2(U)")
        bench.at_most(f"order {order}: error, of the symbol's factor", error, 2e-14)


def stretchedNoise(bench, extent, counts):
    nu = 0.01 * min(extent)
    scene = bench.scene(extent=extent, intervals=counts, nu=nu, start=("1 + noise(1)", "noise(2)"), endTime=0.5,
                        statistics=True, every=1, schemes="meanFlow none;")
    run = scene.solve()
    K, Z = run.column("flow", "kineticEnergy"), run.column("flow", "enstrophy")
    bench.at_most("growth of the energy in a step", max(0.0, growth(K)), 1e-9)
    bench.at_most("enstrophy over its start", max(Z[1:]) / Z[0], 1)
    bench.at_most("divergence over the largest velocity gradient", max(run.column("flow", "divLinf")) * min(L / n for L,
        n in zip(extent, counts))
                  / max(run.column("flow", "maxSpeed")), 2e-15)


def thinChannel(bench, length, width):
    """A decaying mode across a channel; its length does not matter."""
    nu = 0.01 * width**2
    exact = [f"sin(pi*(y/{width!r}))*exp(-{nu * math.pi**2 / width**2!r}*t)"]
    scene = bench.scene(axes="pw", extent=(length, width), nu=nu, start=exact, exact=exact, endTime=2.0, deltaT=0.02)
    bench.at_most("error", scene.solve().error("relL2(U)"), wallDefect(0.02 * math.pi**2, 32))


def thinBox(bench, length, width):
    """A cell in a box with walls all round, its inertia and the friction between the long walls of a size."""
    x, y = f"(pi*x/{length!r})", f"(pi*y/{width!r})"
    nu = width**2 / length
    scene = bench.scene(axes="ww", extent=(length, width), intervals=(24, 24), nu=nu, endTime=0.1 * length,
                        statistics=True, every=1,
                        start=(f"sin{x}^2*sin(2*{y})", f"-{width / length!r}*sin(2*{x})*sin{y}^2"))
    K = scene.solve().column("flow", "kineticEnergy")
    bench.at_most("growth of the energy in a step", max(0.0, growth(K)), 1e-9)
    # No mode between the walls is slower than the first, and this one changes its sign in the middle.
    bench.at_most("energy at the end over that of the slowest mode", K[-1] / K[0] / math.exp(-2 * math.pi**2 * 0.1), 1)


def onePoint(bench, counts, axes="pp"):
    """A shear flow on lattices that are one point wide."""
    along = "x" if counts[0] > 1 else "y"
    n = max(counts)
    nu, end = 0.01, 1.0
    shear = f"sin(2*pi*{along})"
    rate = nu * morris([2 * math.pi], [1.5 / n], 10)
    profile = (shear, "0") if along == "y" else ("0", shear)
    scene = bench.scene(intervals=counts, nu=nu, start=profile, exact=[f"{u}*{math.exp(rate * end)!r}"
                                                                       for u in profile],
                        deltaT=0.02, endTime=end)
    bench.at_most("error, of the symbol's factor", scene.solve().error("relL2(U)"), 2e-14)
    # Across the shear, a uniform flow carries the profile along.
    scene = bench.scene(intervals=counts, nu=nu, start=["1" if u == "0" else f"0.5 + {u}" for u in profile],
                        deltaT=0.02,
                        endTime=end, statistics=True, every=10)
    run = scene.solve()
    K = run.column("flow", "kineticEnergy")
    bench.at_most("growth of the energy", max(0.0, growth(K)), 1e-12)


def singlePoint(bench):
    scene = bench.scene(intervals=(1, 1), start=("1", "0.3"), exact=("1", "0.3"), deltaT=0.1, endTime=1.0)
    bench.at_most("error of a uniform flow", scene.solve().error("Linf(U)"), 1e-14)


def onePointChannel(bench, axes, counts):
    """Poiseuille from rest and a decaying mode where the channel is one point long."""
    across = "y" if axes == "pw" else "x"
    n = max(counts)
    profile = f"4*{across}*(1 - {across})"
    component = (lambda u: (u,)) if across == "y" else (lambda u: ("0", u))
    scene = bench.scene(axes=axes, intervals=counts, nu=0.01, start=component(profile), exact=component(profile),
                        force=component("0.08"), endTime=5.0)
    bench.at_most("Poiseuille's parabola after t = 5", scene.solve().error("Linf(U)"), 1e-9)
    mode = f"sin(pi*{across})*exp(-nu*pi^2*t)"
    scene = bench.scene(axes=axes, intervals=counts, nu=0.01, start=component(mode), exact=component(mode), endTime=2.0)
    bench.at_most("decaying mode", scene.solve().error("relL2(U)"), wallDefect(0.02 * math.pi**2, n))
    noise = bench.scene(axes=axes, intervals=counts, nu=0.01, start=("noise(1)", "noise(2)"), endTime=1.0,
                        statistics=True,
                        every=1)
    K = noise.solve().column("flow", "kineticEnergy")
    bench.at_most("noise: growth of the energy in a step", max(0.0, growth(K)), 1e-9)


def threeDimensions(bench):
    """A wall-bounded column of points, and a stretched periodic box."""
    parabola = ("4*z*(1 - z)",)
    scene = bench.scene(axes="ppw", intervals=(1, 1, 32), nu=0.01, start=parabola, exact=parabola, force=("0.08",),
                        endTime=5.0)
    bench.at_most("column: Poiseuille's parabola after t = 5", scene.solve().error("Linf(U)"), 1e-9)
    nu, end, extent, counts = 0.01, 1.0, (1000.0, 1.0, 30.0), (8, 16, 8)
    rate = nu * morris([2 * math.pi], [1.5 / 16], 10)
    shear = ("sin(2*pi*y)", "0", "0.5*cos(2*pi*y)")
    scene = bench.scene(axes="ppp", extent=extent, intervals=counts, nu=nu, start=shear, deltaT=0.02, endTime=end,
                        exact=[f"({u})*{math.exp(rate * end)!r}" for u in shear])
    bench.at_most("box 1000 × 1 × 30: error, of the symbol's factor", scene.solve().error("relL2(U)"), 2e-14)
    for axes in ("ppp", "pww", "www"):
        scene = bench.scene(axes=axes, extent=(100.0, 1.0, 1.0), intervals=(8, 8, 8), nu=0.01, endTime=0.5,
                            start=("noise(1)", "noise(2)", "noise(3)"), statistics=True, every=1)
        K = scene.solve().column("flow", "kineticEnergy")
        bench.at_most(f"noise, {axes}, 100 : 1 : 1: growth of the energy in a step", max(0.0, growth(K)), 1e-9)


def tooFewPoints(bench):
    """Between walls a degree of 4 needs five points; refused with fewer, and from there stable."""
    for n in (1, 2, 3):
        run = bench.scene(axes="pw", intervals=(32, n), start=("sin(pi*y)",), endTime=1.0).solve()
        refused(bench, f"{n} intervals between walls", run, r"system/\w+(:\d+)?", "points")
    for n in (4, 5, 6, 7, 8):
        run = bench.scene(axes="pw", intervals=(16, n), start=("sin(pi*y) + 0.1*noise(1)", "0.1*noise(2)"), endTime=1.0,
                          statistics=True, every=1).solve()
        if run.code == 1:
            refused(bench, f"{n} intervals", run, r"system/\w+(:\d+)?", "points")
            continue
        K = run.column("flow", "kineticEnergy")
        bench.at_most(f"{n} intervals: energy over its start", max(K[1:]) / K[0], 1)


def oneLength(bench):
    """A kernel has its length in spacings of each axis; one length in metres for both is no entry."""
    for entry in ("h 0.01", "smoothingLength (0.8 800)"):
        run = bench.scene(extent=(1000.0, 1.0), kernel=f"type gaussian; {entry};").solve()
        refused(bench, entry, run, r"system/schemes:\d+: kernel", "smoothingLength")


LONG_BOX = (1000.0, 1.0)
for number, (extent, counts) in enumerate(((LONG_BOX, (32, 32)), (LONG_BOX, (64, 16)), (LONG_BOX, (1024, 8)),
                                           ((1.0, 1000.0), (32, 32))), 1):
    size = f"{extent[0]:g} × {extent[1]:g}, {counts[0]} × {counts[1]} points"
    row(f"S{number}", "decaying cells, periodic", size, "the symbol's factor to round-off")(
        lambda bench, e=extent, c=counts: stretched(bench, e, c))
    row(f"S1{number}", "white noise in a stream, periodic, `deltaT auto`", size, "energy and enstrophy do not grow, "
        "no divergence")(lambda bench, e=extent, c=counts: stretchedNoise(bench, e, c))
for number, (length, width) in enumerate((LONG_BOX, (1.0, 1e-3), (1.0, 1000.0)), 1):
    row(f"S2{number}", "decaying mode across a channel", f"{length:g} × {width:g}, 32²",
        "error below that of the second derivative at walls")(lambda bench, a=length, b=width: thinChannel(bench, a, b))
for number, (length, width) in enumerate((LONG_BOX, (1.0, 1e-3)), 1):
    row(f"S3{number}", "a cell with walls all round", f"{length:g} × {width:g}, 24², `deltaT auto`",
        "energy falls in every step, by more than the slowest mode")(lambda bench, a=length,
                                                                     b=width: thinBox(bench, a, b))
for number, counts in enumerate(((1, 32), (32, 1), (1, 31)), 1):
    row(f"S4{number}", "shear flow, periodic", f"{counts[0]} × {counts[1]} points", "the symbol's factor to round-off; "
        "energy does not grow in a stream")(lambda bench, c=counts: onePoint(bench, c))
row("S44", "uniform flow, periodic", "1 × 1 points", "stays to round-off")(singlePoint)
for number, (axes, counts) in enumerate((("pw", (1, 32)), ("wp", (32, 1)), ("pw", (1, 16))), 1):
    size = " × ".join(map(str, counts))
    row(f"S5{number}", "channel one point long", f"{size} intervals, walls along {'x' if axes == 'pw' else 'y'}",
        "Poiseuille stays, a mode decays, noise dies")(lambda bench, a=axes, c=counts: onePointChannel(bench, a, c))
row("S54", "few points between walls", "1 to 8 intervals",
    "refused with place and cure below five points; above, energy "
    "does not grow")(tooFewPoints)
row("X3", "one smoothing length for spacings of 1000 : 1", "in metres; two of them",
    "refused: h/dx is the same along every axis")(
    oneLength)
row("S61", "three dimensions: a column of points between walls, long boxes", "1 × 1 × 32; 1000 : 1 : 30; 100 : 1 : 1",
    "Poiseuille stays, the symbol's factor, energy falls")(threeDimensions)
