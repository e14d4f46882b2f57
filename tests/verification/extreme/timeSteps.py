"""Steps from 1e-6 of the stable one to 1e5 times it: right below, caught beyond, implicit terms right anywhere."""
import math
import re

from bench import caught, refused, row, short
from symbols import morris, wallDefect

N = 32
VORTEX = ("sin(2*pi*x)*cos(2*pi*y)", "-cos(2*pi*x)*sin(2*pi*y)")
RATE = morris([2 * math.pi] * 2, [1.5 / N] * 2, 10)
ROUND_OFF = 1e-14  # of a field, in a few hundred steps


def polynomial(z, terms):
    return sum(z**m / math.factorial(m) for m in range(terms))


def vortex(bench, times, viscous, time="RK3", nu=0.1, steps=40):
    """A vortex in steps of the limit of its explicit viscosity; the growth factor of the scheme, to round-off."""
    scene = bench.scene(nu=nu, start=VORTEX, schemes=f"viscous explicit; time {time};", deltaT=1e-9)
    limit = scene.limits()["largestStableStep"]
    dt = times * limit
    z = nu * RATE * dt
    factor = math.exp(steps * z) if viscous == "integratingFactor" else polynomial(z, 4
                                                                                   if time == "RK3" else 2) ** steps
    scene = bench.scene(nu=nu, start=VORTEX, exact=[f"{u}*{factor!r}" for u in VORTEX], deltaT=dt, endTime=steps * dt,
                        schemes=f"viscous {viscous}; time {time};", writeInterval=1 if times < 1e-3 else "endTime")
    run = scene.solve().demand()
    bench.at_most("error, of the scheme's factor", run.error("L2(U)") / math.sqrt(0.5), ROUND_OFF)
    bench.holds(f"{steps} steps", scene.report()["steps"] == steps)
    if times < 1e-3:
        written = scene.times()
        apart = {float(name) for name in written}
        bench.holds(f"{steps} time folders whose names tell them apart", len(written) == len(apart) == steps + 1)
    return run


def periodicBeyond(bench, schemes, nu, start, times):
    """Noise beyond the limit: warned of with the limit, then caught; the start, or what was written, goes on."""
    scene = bench.scene(nu=nu, start=start, schemes=schemes, writeInterval=5, deltaT=1e-9)
    beyond(bench, scene, times)


def beyond(bench, scene, times):
    limit = scene.limits()["largestStableStep"]
    scene.step(times * limit, 2000 * times * limit)
    run = scene.solve()
    warned = re.search(r"above the largest stable step ([-+.e0-9]+)", run.err)
    # checkCase knows the start as it is written, the solver as it is projected.
    bench.holds(f"warned with the limit {warned.group(1) if warned else ''} s",
                warned and 0.85 < float(warned.group(1)) / limit < 1.18, run.err)
    caught(bench, f"{times:g} times the limit", run, 2 * limit)


def channelMode(bench, times, viscous, nu=1.0, steps=40):
    """A decaying mode across a channel in steps of the explicit limit; Crank-Nicolson: its own factor."""
    mode = ("sin(pi*y)",)
    scene = bench.scene(axes="pw", intervals=(8, N), nu=nu, start=mode, schemes="viscous explicit;", deltaT=1e-9)
    dt = times * scene.limits()["largestStableStep"]
    z = -nu * math.pi**2 * dt
    if viscous == "explicit":
        factor = polynomial(z, 4) ** steps
    else:
        factor = 1.0
        for a in (8 / 15, 2 / 15, 1 / 3):
            factor *= (1 + a * z / 2) / (1 - a * z / 2)
        factor **= steps
    scene = bench.scene(axes="pw", intervals=(8, N), nu=nu, start=mode, exact=[f"sin(pi*y)*{factor!r}"], deltaT=dt,
                        endTime=steps * dt, schemes=f"viscous {viscous};", writeInterval=1
                        if times < 1e-3 else "endTime")
    run = scene.solve()
    bench.at_most("error, of the scheme's factor", run.error("L2(U)") / math.sqrt(0.5), wallDefect(steps * abs(z), N))
    bench.holds(f"{steps} steps", scene.report()["steps"] == steps)
    if times < 1e-3:
        bench.holds(f"{steps} time folders whose names tell them apart", len(scene.times()) == steps + 1)


def channelNoise(bench, times):
    """Noise and a parabola under a force in Crank-Nicolson steps: the parabola stays, noise does not grow."""
    parabola = ("4*y*(1 - y)",)
    scene = bench.scene(axes="pw", intervals=(16, N), nu=1.0, start=parabola,
                        schemes="viscous explicit; convection none;", deltaT=1e-9)
    dt = times * scene.limits()["largestStableStep"]
    scene = bench.scene(axes="pw", intervals=(16, N), nu=1.0, start=("4*y*(1 - y) + 1e-3*noise(1)", "1e-3*noise(2)"),
                        force=("8",),
                        exact=parabola, every=1, deltaT=dt, endTime=400 * dt,
                        schemes="viscous CrankNicolson; convection none;")
    errors = scene.solve().column("errors", "L2(U)")
    # In the first step noise meets the walls.
    bench.at_most("noise over that after the first step, largest", max(errors[2:]) / errors[1], 1)
    bench.note(f"over its start: after the first step {short(errors[1] / errors[0])}, "
               f"at the end {short(errors[-1] / errors[0])}")


def lidBeyond(bench, times):
    scene = bench.scene(axes="ww", intervals=(24, 24), nu=0.01, deltaT=1e-9, writeInterval=5,
                        schemes="viscous explicit;",
                        walls={"yMax": "type fixedValue; value uniform (1 0 0);"})
    beyond(bench, scene, times)


def channelBeyond(bench, times, nu):
    scene = bench.scene(axes="pw", intervals=(24, 24), nu=nu, deltaT=1e-9, writeInterval=5, schemes="viscous explicit;",
                        start=("1 + 0.01*noise(1)", "0.01*noise(2)"),
                        walls={face: "type fixedValue; value uniform (1 0 0);" for face in ("yMin", "yMax")})
    beyond(bench, scene, times)


def oneStep(bench):
    """A step longer than the whole run is cut to its end."""
    end = 0.01
    scene = bench.scene(nu=0.1, start=VORTEX, exact=[f"{u}*{math.exp(0.1 * RATE * end)!r}" for u in VORTEX], deltaT=1e6,
                        endTime=end)
    run = scene.solve().demand()
    bench.at_most("error, of the symbol's factor", run.error("relL2(U)"), ROUND_OFF)
    bench.holds("one step", scene.report()["steps"] == 1)


def resting(bench):
    """Nothing moves: no step is too long."""
    for axes in ("pp", "pw", "ww"):
        scene = bench.scene(axes=axes, intervals=(16, 16), endTime=1e12, deltaT=1e11, nu=1e-6, schemes=""
                            if axes == "pp" else "viscous CrankNicolson;")
        scene.solve().demand()
        bench.holds(f"{axes}: exactly at rest", not any(scene.field()) and not any(scene.field(dataset="p")))
        scene = bench.scene(axes=axes, intervals=(16, 16), endTime=1.0, nu=1e-6)
        run = scene.solve()
        bench.holds(f"{axes}: deltaT auto ends", run.code == 0 and not any(scene.field()), run.err)


def impossible(bench):
    for value in ("0", "-1", "nan", "1e-400"):
        scene = bench.scene(start=VORTEX, deltaT="0.1")
        scene.run("makeLattice")
        scene.replace("system/controlDict", "deltaT 0.1;", f"deltaT {value};")
        refused(bench, f"deltaT {value}", scene.solve(), r"system/controlDict:\d+")
    scene = bench.scene(nu=0.0, start=VORTEX, schemes="time firstOrderProjection;", deltaT=1e-3)
    refused(bench, "first order, no viscosity", scene.solve(), r"system/\w+", r"2 nu/\|u\|\^2")


for number, times in enumerate((1e-6, 1e-3, 0.5, 0.98), 1):
    row(f"N{number}", "Taylor-Green vortex, explicit, periodic", f"dt = {times:g} of the limit",
        "the polynomial of RK3 to "
        "round-off")(lambda bench, t=times: vortex(bench, t, "explicit"))
    row(f"N1{number}", "decaying mode in a channel, explicit", f"dt = {times:g} of the limit",
        "the polynomial of RK3 but for "
        "the second derivative at walls")(lambda bench, t=times: channelMode(bench, t, "explicit"))
for number, times in enumerate((1e-6, 1.0, 100.0, 1e4), 1):
    row(f"N2{number}", "Taylor-Green vortex, integrating factor", f"dt = {times:g} of the explicit limit",
        "the exponential to round-off")(lambda bench, t=times: vortex(bench, t, "integratingFactor", nu=10.0, steps=40
                                                                      if t < 1 else 4))
    row(f"N3{number}", "decaying mode in a channel, Crank-Nicolson", f"dt = {times:g} of the explicit limit",
        "its rational factor but for the second derivative at walls")(
            lambda bench, t=times: channelMode(bench, t, "CrankNicolson"))
for number, times in enumerate((1.0, 100.0, 1e5), 1):
    row(f"N4{number}", "noise on a parabola under a force, Crank-Nicolson",
        f"dt = {times:g} of the explicit limit, 400 steps",
        "noise never above what the first step leaves")(lambda bench, t=times: channelNoise(bench, t))
row("N5", "Taylor-Green vortex, first order projection", "dt = 0.9 of the limit", "1 + z to round-off")(
    lambda bench: vortex(bench, 0.9, "explicit", "firstOrderProjection"))
NOISE = ("noise(1)", "noise(2)")
for number, (case, schemes, nu, times) in enumerate((
        ("noise, viscosity explicit", "viscous explicit; convection none;", 0.1, 1.2),
        ("noise, viscosity explicit", "viscous explicit;", 0.1, 10.0),
        ("noise, viscosity explicit", "viscous explicit;", 0.1, 100.0),
        ("noise in a stream, no viscosity", "meanFlow none; dealiasing none;", 0.0, 1.2),
        ("noise in a stream, no viscosity", "meanFlow none; dealiasing none;", 0.0, 100.0),
        ("noise in a stream, integrating factor", "meanFlow none;", 0.01, 100.0),
        ("noise, first order projection", "time firstOrderProjection; viscous explicit;", 0.1, 100.0)), 1):
    row("X8" if number == 3 else f"N6{number}", f"{case}, periodic", f"dt = {times:g} of the limit",
        "warned with the limit, exit 3, the last good "
        "state whole, and going on")(lambda bench, s=schemes, nu=nu, t=times, stream="stream" in case: periodicBeyond(
            bench, s, nu, ("1 + 0.5*noise(1)", "0.5*noise(2)") if stream else NOISE, t))
for number, times in enumerate((3.0, 10.0, 100.0), 1):
    row(f"N7{number}", "lid-driven cavity, explicit", f"dt = {times:g} of the limit",
        "warned with the limit, exit 3, the last good state whole, and going on")(
        lambda bench, t=times: lidBeyond(bench, t))
for number, (times, nu) in enumerate(((2.0, 0.0), (100.0, 0.0), (100.0, 0.1)), 1):
    row(f"N8{number}", "stream with noise between walls that go along", f"nu {nu:g}, dt = {times:g} of the limit",
        "warned with the limit, exit 3, the last good state whole, and going on")(
        lambda bench, t=times, nu=nu: channelBeyond(bench, t, nu))
row("N91", "a step longer than the run", "dt = 1e6 s, end 0.01 s", "one step, exact")(oneStep)
row("N92", "fluid at rest, periodic, channel, box", "dt = 1e11 s, and auto", "stays at rest exactly, and ends")(resting)
row("N93", "steps that are none; first order without viscosity", "deltaT 0, -1, nan, 1e-400",
    "refused with place")(impossible)
