"""Flows of the tutorials against published and independent figures: cavities, dipoles, vortices in a channel."""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "support"))

from bench import LONG, row  # noqa: E402
from tutorials import Tutorial, at, deviation, peak  # noqa: E402

EXTREMA = {100: (-0.2140424, 0.1795728, -0.2538030), 1000: (-0.3885698, 0.3769447, -0.5270771)}  # Botella & Peyret 1998
WIDE = {"kernel__order": "4", "kernel__smoothingLength": "1.3"}


def tutorial(bench, name, nu, intervals, end, sample=True, **schemes):
    case = Tutorial(name)
    bench.scenes.append(case)
    case.set_flow(nu, intervals, end, **schemes)
    for program in ("makeLattice", "isphFoam") + (("sampleLines",) if sample else ()):
        done = case.run(program, *(["-latestTime"] if program == "sampleLines" else []), timeout=LONG)
        if done.returncode:
            raise RuntimeError(f"{program}: exit {done.returncode}: {done.stderr.strip()}")
    return case


def columns(case):
    rows = case.table("flow")
    return {name: [float(entry[name]) for entry in rows] for name in rows[0]}


def extrema(bench, Re, intervals, end, bound, **schemes):
    case = tutorial(bench, "cavity", 1 / Re, (intervals, intervals), end, **schemes)
    u, v = case.line("vertical", "y", "U.x")[1], case.line("horizontal", "x", "U.y")[1]
    errors = [abs(value / wanted - 1) for value, wanted in zip((min(u), max(v), min(v)), EXTREMA[Re])]
    bench.at_most("largest of three extrema off by", max(errors), bound)


def profiles(bench, Re, intervals, end, bound):
    case = tutorial(bench, "cavity", 1 / Re, (intervals, intervals), end)
    u = deviation(case.line("vertical", "y", "U.x"), case.reference("cavity_check_own_u.csv", "y", f"Re{Re}"))
    v = deviation(case.line("horizontal", "x", "U.y"), case.reference("cavity_check_own_v.csv", "x", f"Re{Re}"))
    bench.at_most("profiles off by", max(u, v), bound)


def dipoleStart(bench):
    found = columns(tutorial(bench, "dipoleWall", 0.01, (96, 96), 1e-3, sample=False))
    bench.at_most("energy off by a part of", abs(found["kineticEnergy"][0] / 2 - 1), 1e-13)
    bench.at_most("enstrophy off by a part of", abs(found["enstrophy"][0] / 800 - 1), 1e-13)


def dipole100(bench):
    found = columns(tutorial(bench, "dipoleWall", 0.01, (96, 96), 1.0, sample=False))
    t, E, Z = found["time"], found["kineticEnergy"], found["enstrophy"]
    for time, energy, enstrophy, dE, dZ in ((0.5, 0.2770, 27.72, 3e-4, 0.05), (1.0, 0.1163, 9.02, 1e-4, 0.01)):
        bench.at_most(f"E({time:g}) off by", abs(at(time, t, E) - energy), dE)
        bench.at_most(f"Z({time:g}) off by", abs(at(time, t, Z) - enstrophy), dZ)


def dipole625(bench):
    found = columns(tutorial(bench, "dipoleWall", 1 / 625, (256, 256), 0.5, sample=False))
    t, E, Z = found["time"], found["kineticEnergy"], found["enstrophy"]
    bench.at_most("E(.25) off by", abs(at(0.25, t, E) - 1.502), 1e-3)
    bench.at_most("Z(.25) off by", abs(at(0.25, t, Z) - 472.7), 0.5)
    bench.at_most("E(.5) off by a part of", abs(at(0.5, t, E) / 1.013 - 1), 0.006)
    bench.at_most("Z(.5) off by a part of", abs(at(0.5, t, Z) / 380.6 - 1), 0.01)
    first, height = peak(t, Z, 0.25, 0.48)
    bench.at_most("first peak: time off by", abs(first - 0.3711), 0.002)
    bench.at_most("height off by a part of", abs(height / 933.6 - 1), 0.1)


def dipoleFine(bench):
    found = columns(tutorial(bench, "dipoleWall", 1 / 625, (400, 400), 0.4, sample=False))
    first, height = peak(found["time"], found["enstrophy"], 0.25, 0.39)
    bench.at_most("first peak: time off by", abs(first - 0.3711), 0.002)
    bench.at_most("height off by a part of", abs(height / 933.6 - 1), 0.04)


def twoVortices(bench):
    case = tutorial(bench, "doubleVortexChannel", 0.01, (160, 80), 0.05, sample=False)
    bench.at_most("energy after the projection off by", abs(columns(case)["kineticEnergy"][0] - 0.140577), 5e-7)
    values = [float(word) for word in case.values(case.times()[-1]).split("}")[0].split(",")]
    nx, ny = 160, 81
    mirrored = [(3 * (nx * j + i), 3 * (nx * j + (nx - i) % nx)) for j in range(ny) for i in range(nx)]
    bench.at_most("mirror symmetry", max(max(abs(values[a] + values[b]), abs(values[a + 1] - values[b + 1]))
                                         for a, b in mirrored), 1e-12)


def firstOrder(bench):
    """The manufactured flow in a channel by forward Euler: dt and half of it."""
    errors = []
    for deltaT in (4e-3, 2e-3, 1e-3):
        case = Tutorial("channelManufactured")
        bench.scenes.append(case)
        case.set("system/latticeDict", "intervals", "(48 48 0)")
        case.set("system/schemes", "time", "firstOrderProjection")
        case.set("system/schemes", "viscous", "explicit")
        case.set("system/controlDict", "deltaT", repr(deltaT))
        case.set("system/controlDict", "adjustTimeStep", "no")
        case.set("system/controlDict", "endTime", "0.48")
        for program in ("makeLattice", "isphFoam"):
            done = case.run(program, timeout=LONG)
            if done.returncode:
                raise RuntimeError(f"{program}: exit {done.returncode}: {done.stderr.strip()}")
        last = case.table("errors")[-1]
        errors.append((float(last["L2(U)"]), float(last["L2(p)"])))
    for what, index in (("velocity", 0), ("pressure", 1)):
        for coarse, fine in zip(errors, errors[1:]):
            bench.at_most(f"{what}: half the step, error over half of it, off by",
                          abs(2 * fine[index] / coarse[index] - 1), 0.1)


row("W8", "first order projection between walls", "manufactured channel, N = 48, dt = 4e-3, 2e-3, 1e-3", "order 1.0",
    slow=True)(
    firstOrder)
row("W13", "cavity Re 100, defaults", "N = 48", "extrema to 1 %", slow=True)(lambda bench: extrema(bench, 100, 48, 20,
                                                                                                   0.01))
row("W13b", "cavity Re 100, degree 3", "N = 48", "extrema to 0.5 %", slow=True)(
    lambda bench: extrema(bench, 100, 48, 20, 0.005, continuation__degree="3"))
row("W13c", "cavity Re 100, gaussian 4", "N = 48, h/dx 1.3", "extrema to 1 %", slow=True)(
    lambda bench: extrema(bench, 100, 48, 20, 0.01, **WIDE))
row("W13d", "cavity Re 400", "N = 48", "profiles to 1.5 % of the lid's speed", slow=True)(
    lambda bench: profiles(bench, 400, 48, 40, 0.015))
row("W13e", "cavity Re 1000", "N = 64", "extrema to 1.7 %", slow=True)(lambda bench: extrema(bench, 1000, 64, 60,
                                                                                             0.017))
row("W14", "cavity Re 1000", "N = 128", "extrema to 0.7 %", slow=True)(lambda bench: extrema(bench, 1000, 128, 60,
                                                                                             0.007))
row("W15", "dipole at the start", "N = 96", "E = 2, Z = 800 to round-off", slow=True)(dipoleStart)
row("W16", "dipole Re 100 at a wall", "N = 96", "E, Z at t = 0.5, 1 of the reference", slow=True)(dipole100)
row("W17", "dipole Re 625 at a wall", "N = 256", "E, Z at t = 0.25, 0.5, the first peak", slow=True)(dipole625)
row("W18", "dipole Re 625 at a wall", "N = 400", "the first peak to 4 %", slow=True)(dipoleFine)
row("W20", "two vortices in a channel", "N = 80", "energy of the projected start in all digits of 0.140577, mirror symmetry",
    slow=True)(
    twoVortices)
