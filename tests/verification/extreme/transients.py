"""What begins at once or changes fast: forces, walls, lids."""
import math

from bench import row, short
from symbols import morris

LID = "type fixedValue; value uniform (1 0 0);"


def uniformForce(bench, steps):
    """A force that is off until half a step after t = 0.1, and 1 from there: of that step the quadrature of RK3, with
    weights of 1/4 at its beginning and 3/4 at two thirds of it, sees three quarters."""
    end = 0.2
    step = end / steps
    switch = 0.1 + 0.5 * step
    scene = bench.scene(intervals=(8, 8), start=("0",), force=(f"t >= {switch!r} ? 1 : 0", "0.5"), deltaT=step,
                        endTime=end, exact=(f"{end - switch + 0.25 * step!r}", f"{0.5 * end!r}"), nu=0.01)
    bench.at_most(f"{steps} steps: error", scene.solve().error("Linf(U)"), 2e-14)


def kolmogorov(bench):
    """sin(2 pi y) switched on at once at t = 0 is exact to the time scheme; in the middle of a step, to that step."""
    nu = 0.05
    rate = -nu * morris([2 * math.pi], [1.5 / 32], 10)
    for begin, steps, bound in ((0.0, 100, 1e-7), (0.1, 100, 0.001), (0.1, 1000, 0.0001)):
        end = 1.0
        amplitude = (1 - math.exp(-rate * (end - begin))) / rate
        scene = bench.scene(intervals=(8, 32), nu=nu, start=("0",),
                            force=(f"t >= {begin + 0.5 * end / steps if begin else 0!r} ? sin(2*pi*y) : 0",),
                            exact=(f"{amplitude!r}*sin(2*pi*y)",), deltaT=end / steps, endTime=end)
        bench.at_most(f"begins at {begin:g}, dt {short(end / steps)}: error", scene.solve().error("L2(U)"), bound)


def poiseuille(bench, viscous):
    """The force starts a channel at rest at once: the series."""
    series = "4*y*(1 - y) - sum(k, 0, 24, 32/((2*k + 1)*pi)^3*sin((2*k + 1)*pi*y)*exp(-((2*k + 1)*pi)^2*nu*t))"
    for intervals, bound in ((20, 1.3e-6), (40, 4.6e-8), (80, 1.5e-9)):
        scene = bench.scene(axes="pw", intervals=(8, intervals), nu=0.01, force=("0.08",), exact=(series,),
                            endTime=11.0,
                            schemes=f"viscous {viscous};", deltaT=11 / 8000 if intervals == 80 else 11 / 4000)
        bench.at_most(f"{intervals} intervals: error", scene.solve().error("L2(U)"), 1.1 * bound)


def strongForce(bench, axes, force, nu, bound):
    """A force that makes a fluid at rest fast in far less than a step of the default: laminar flow, and its approach."""
    walls = axes == "pw"
    rate = nu * math.pi**2 if walls else -nu * morris([2 * math.pi], [1.5 / 32], 10)
    wave = "sin(pi*y)" if walls else "sin(2*pi*y)"
    for times in (0.1, 8):
        end = times / rate
        scene = bench.scene(axes=axes, intervals=(8, 32), nu=nu, start=("0",), force=(f"{force!r}*{wave}",),
                            exact=(f"{force / rate * -math.expm1(-times)!r}*{wave}",), endTime=end)
        error = scene.solve().error("Linf(U)")
        bench.at_most(f"t = {times:g} of its time: error over the speed", error / (force / rate), bound)


def onOff(bench, axes):
    """A strong force of short pulses: the energy is what their work leaves, and falls once they are over."""
    force = "t < 0.05 ? 200*sin(2*pi*y)*sin(pi*y)^2*(floor(t*400) - 2*floor(t*200) < 0.5 ? 1 : 0) : 0"
    scene = bench.scene(axes=axes, intervals=(32, 32), nu=0.01, force=(force,), endTime=1.0, statistics=True, every=1,
                        control="maxDeltaT 0.0005;")
    run = scene.solve()
    t, K = run.column("flow", "time"), run.column("flow", "kineticEnergy")
    # |u| <= the integral of the force, half of 0.05 s long.
    bench.at_most("energy over that of the impulse", max(K) / (0.5 * (200 * 0.025) ** 2), 1)
    after = [energy for time, energy in zip(t, K) if time > 0.051]
    bench.at_most("growth in a step when all is over", max(0.0, max(b / a for a, b in zip(after, after[1:])) - 1), 1e-9)


def stokesLayer(bench, intervals, nu):
    """A wall that oscillates a hundred times per convective time, and the layer at it."""
    omega = 200 * math.pi
    layer = math.sqrt(2 * nu / omega)
    exact = f"exp(-y/{layer!r})*sin({omega!r}*t - y/{layer!r})"
    # The far wall is many layers away; deltaT auto knows no periods.
    scene = bench.scene(axes="pw", intervals=(1, intervals), nu=nu, start=(exact,), exact=(exact,), endTime=0.2, every=10,
                        schemes="viscous explicit;", control="maxDeltaT 0.000125;",
                        walls={"yMin": f'type fixedValue; value expression ("sin({omega!r}*t)" "0" "0");'})
    errors = scene.solve().column("errors", "Linf(U)")
    points = layer * intervals
    bench.note(f"{points:.1f} spacings in the layer")
    # Degree 4: the second derivative is off by (h/layer)^3.5; a layer that is not seen leaves no more than the wall has.
    bench.at_most("largest error", max(errors), min(1.0, 0.1 * points**-3.5))


def fastLid(bench, intervals, nu):
    """A lid too fast for the lattice to see its layer: bounded by the lid."""
    scene = bench.scene(axes="ww", intervals=(intervals, intervals), nu=nu, endTime=1.0, statistics=True, every=1,
                        control="maxDeltaT 0.0007;",
                        walls={"yMax": 'type fixedValue; value expression ("sin(200*pi*t)" "0" "0");'})
    run = scene.solve()
    bench.at_most("largest speed over the lid's", max(run.column("flow", "maxSpeed")), 1 + 1e-9)
    # A layer of sqrt(2 nu/omega) moves, with half of the lid's energy at most.
    layer = max(math.sqrt(2 * nu / (200 * math.pi)), 1 / intervals)
    bench.at_most("energy over that of the layer", max(run.column("flow", "kineticEnergy")) / (0.5 * layer), 1)


def lidCorners(bench, schemes, end, bound):
    scene = bench.scene(axes="ww", intervals=(32, 32), nu=1e-4, endTime=end, statistics=True, every=10,
                        walls={"yMax": LID}, schemes=schemes)
    run = scene.solve()
    if run.code == 3:
        bench.holds("caught: exit 3 with the reason", "diverged" in run.err, run.err)
        return
    bench.at_most("largest speed over the lid's", max(run.column("flow", "maxSpeed")), bound)
    bench.at_most("energy over a quarter of the lid's", max(run.column("flow", "kineticEnergy")) / 0.125, 1)


row("F1", "a uniform force switches on, periodic", "in the middle of a step, 10 and 1000 steps to t = 0.2",
    "what the quadrature of the scheme sees, to round-off")(lambda bench: [uniformForce(bench, n) for n in (10, 1000)])
row("F2", "a shear force switches on, periodic", "at once, or in the middle of a step",
    "exact to the time scheme, or to that "
    "step")(kolmogorov)
for number, viscous in enumerate(("explicit", "CrankNicolson"), 1):
    row(f"F3{number}", "Poiseuille from rest, the force at once", f"{viscous}, N = 20, 40, 80, t = 11",
        "1.1 times 1.3e-6, 4.6e-8, 1.5e-9")(lambda bench, v=viscous: poiseuille(bench, v))
for number, axes in enumerate(("pp", "pw", "ww"), 1):
    row(f"F4{number}", f"pulses of a strong force, {dict(pp='periodic', pw='channel', ww='box')[axes]}",
        "ten in 0.05 s, speed up to 5",
        "no more energy than the impulse has; it falls afterwards")(lambda bench, a=axes: onOff(bench, a))
for number, (axes, force, nu, bound) in enumerate((("pp", 1e6, 10.0, 5e-6), ("pw", 1e6, 100.0, 1e-4)), 1):
    row(f"F8{number}", f"a strong force on a fluid at rest, {dict(pp='periodic', pw='channel')[axes]}",
        f"force {force:g}, nu {nu:g}, `deltaT auto`", f"laminar flow, to {bound:g} of its speed")(
            lambda bench, a=axes, f=force, nu=nu, b=bound: strongForce(bench, a, f, nu, b))
for number, (intervals, nu) in enumerate(((100, 0.01), (200, 0.1), (400, 0.1)), 1):
    row(f"F5{number}", "a wall oscillates, channel",
        f"100 periods per convective time, {intervals} intervals, nu {nu:g}",
        "Stokes' layer, to (dy/layer)^3.5/10; bounded by the wall where there is no layer to see")(
            lambda bench, n=intervals, nu=nu: stokesLayer(bench, n, nu))
for number, (intervals, nu) in enumerate(((32, 1e-2), (32, 1e-4)), 1):
    row(f"F6{number}", "a lid oscillates, cavity", f"100 periods per convective time, {intervals}², nu {nu:g}",
        "nothing faster than the lid, energy in its layer alone")(lambda bench, n=intervals,
                                                                  nu=nu: fastLid(bench, n, nu))
row("F71", "lid corners", "Re 1e4, 32², t = 20", "bounded")(lambda bench: lidCorners(bench, "", 20.0, 1.5))
row("F72", "lid corners, degree 3, filter", "Re 1e4, 32², t = 20", "bounded by the lid's speed, 10 % over")(
    lambda bench: lidCorners(bench, "continuation { degree 3; } filter { type exponential; }", 20.0, 1.1))
