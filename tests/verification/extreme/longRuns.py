"""A flow that has long decayed: nothing drifts, nothing blows up, and steps do not become slow where numbers do."""
import math
import statistics

from bench import row


def decayed(bench, steps, axes, mean):
    """Speeds below the least normal number from a fiftieth of the run on."""
    # exp(-rate t) passes 1e-308 at rate t = 709.
    dt = 0.01
    rate = 8 * math.pi**2 if axes == "pp" else math.pi**2
    nu = 1.0 if axes == "pw" else 709 / rate / (0.02 * steps * dt)
    start = (f"{mean[0]!r} + sin(2*pi*x)*cos(2*pi*y)", f"{mean[1]!r} - cos(2*pi*x)*sin(2*pi*y)")
    if axes == "pw":
        start = ("sin(pi*y)*(1 + 0.1*cos(2*pi*x))",)
    scene = bench.scene(axes=axes, intervals=(8, 8) if axes == "pp" else (8, 12), nu=nu, start=start, deltaT=dt,
                        endTime=steps * dt, schemes="" if axes == "pp" else "viscous CrankNicolson;",
                        exact=(repr(mean[0]), repr(mean[1])), every=steps // 100)
    run = scene.solve(timeout=1700)
    error, cpu = run.column("errors", "Linf(U)"), run.column("errors", "cpuTime")
    bench.holds(f"{steps} steps", scene.report()["steps"] == steps)
    bench.at_most("error of the mean flow at the end", error[-1], 1e-12)
    bench.at_most("more than at half of the time by", max(0.0, error[-1] - error[len(error) // 2]), 1e-14)
    taken = [b - a for a, b in zip(cpu, cpu[1:])]
    bench.at_most("a step at the end over one at the start, fastest of each", min(taken[-50:]) / min(taken[:5]), 2)
    bench.note(f"{1e6 * statistics.median(taken) / (steps // 100):.1f} µs a step")


for number, (axes, mean) in enumerate((("pp", (1.0, 0.5)), ("pp", (0.0, 0.0)), ("pw", (0.0, 0.0))), 1):
    case = {"pp": "periodic", "pw": "channel, Crank-Nicolson"}[axes] + (", in a stream" if any(mean) else "")
    for steps, slow in ((20000, False), (1000000, True)):
        row(f"L{number}{'' if slow else 'r'}", f"decayed flow, {case}", f"{steps} steps, decayed after a fiftieth",
            "rest, or the stream to 1e-12; steps as fast as at the start", slow=slow)(
                lambda bench, n=steps, a=axes, m=mean: decayed(bench, n, a, m))
