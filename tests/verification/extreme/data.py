"""Starts that are not smooth: jumps, white noise, walls that start at once."""
import cmath
import math

from bench import growth, row, short
from symbols import morris

JUMPS = ("sin(2*pi*y) > 0 ? 1 : -1", "sin(4*pi*x) > 0 ? 0.5 : -0.5")


def periodicJump(bench, dealiasing):
    """u = sign(y) in a shear flow is linear: every Fourier mode of the data decays by its symbol."""
    n, nu, end = 64, 1e-3, 1.0
    scene = bench.scene(intervals=(8, n), nu=nu, start=("y < 0.5 ? 1 : -1",), deltaT=0.02, endTime=end, statistics=True,
                        every=50, schemes=f"dealiasing {dealiasing};")
    K = scene.solve().column("flow", "kineticEnergy")
    u = [1.0 if j < n // 2 else -1.0 for j in range(n)]
    expected = [0.0, 0.0]
    for m in range(n):
        wave = min(m, n - m)
        if dealiasing == "twoThirds" and 3 * wave >= n:
            continue
        modulus = abs(sum(value * cmath.exp(-2j * math.pi * m * j / n) for j, value in enumerate(u)) / n) ** 2 / 2
        rate = nu * morris([2 * math.pi * wave], [1.5 / n], 10)
        expected[0] += modulus
        expected[1] += modulus * math.exp(2 * rate * end)
    bench.at_most("energy of the start off by", abs(K[0] / expected[0] - 1), 2e-14)
    bench.at_most("energy at the end off by", abs(K[-1] / expected[1] - 1), 2e-14)


def periodicJumps(bench, nu):
    scene = bench.scene(intervals=(48, 48), nu=nu, start=JUMPS, endTime=2.0, statistics=True, every=1,
                        schemes="filter { type exponential; }")
    run = scene.solve()
    K, Z = run.column("flow", "kineticEnergy"), run.column("flow", "enstrophy")
    bench.at_most("growth of the energy in a step", max(0.0, growth(K)), 1e-9)
    bench.at_most("enstrophy over its start", max(Z[1:]) / Z[0], 1)
    bench.note(f"at the end K {short(K[-1] / K[0])}, Z {short(Z[-1] / Z[0])}")


def noise(bench, axes, nu):
    scene = bench.scene(axes=axes, intervals=(32, 32), nu=nu, start=("noise(1)", "noise(2)"), endTime=1.0,
                        statistics=True,
                        every=1, schemes="filter { type exponential; }" if nu < 1e-3 else "")
    run = scene.solve()
    K = run.column("flow", "kineticEnergy")
    bench.at_most("growth of the energy in a step", max(0.0, growth(K)), 1e-9)
    bench.note(f"at the end K {short(K[-1] / K[0])}")


def couette(bench, intervals, bounds):
    """The upper wall starts at once: the series solution."""
    series = "y + 2/pi*sum(n, 1, 64, (-1)^n/n*exp(-(n*pi)^2*nu*t)*sin(n*pi*y))"
    for time, bound in bounds:
        scene = bench.scene(axes="pw", intervals=(8, intervals), nu=1.0, start=("y >= 1 ? 1 : 0",), exact=(series,),
                            endTime=time,
                            walls={"yMax": "type fixedValue; value uniform (1 0 0);"}, schemes="viscous explicit;")
        bench.at_most(f"nu t = {time:g}", scene.solve().error(), bound)


def channelJump(bench):
    """Half the channel moves, and stands at its wall at once."""
    coefficient = "2*(cos(n*pi/2) - (-1)^n)/(n*pi)"
    series = f"sum(n, 1, 64, {coefficient}*exp(-(n*pi)^2*nu*t)*sin(n*pi*y))"
    errors = []
    for intervals in (40, 80):
        scene = bench.scene(axes="pw", intervals=(8, intervals), nu=1.0, exact=(series,), endTime=0.05,
                            schemes="viscous explicit;", start=("y > 0.5001 ? 1 : y > 0.4999 ? 0.5 : 0",))
        errors.append(scene.solve().error())
    # A jump between points is known to a fraction of the spacing: second order by the value of one half in the middle.
    bench.at_most("error on 40 intervals", errors[0], 1.0 / 40**2)
    bench.at_least("order", math.log2(errors[0] / errors[1]), 1.9)


for number, dealiasing in enumerate(("none", "twoThirds"), 1):
    row(f"J{number}", "a jump of the velocity, shear flow, periodic", f"64 points, nu 1e-3, dealiasing {dealiasing}",
        "energy by the symbols of its Fourier modes to round-off")(lambda bench, d=dealiasing: periodicJump(bench, d))
for number, nu in enumerate((1e-2, 1e-6), 1):
    row(f"J1{number}", "jumps across both axes, periodic, `deltaT auto`", f"48², nu {nu:g}, filter",
        "energy falls in every step, enstrophy stays below its start")(lambda bench, nu=nu: periodicJumps(bench, nu))
for number, (axes, nu) in enumerate((("pp", 1e-3), ("pp", 1e-6), ("pw", 1e-2), ("pw", 1e-6), ("ww", 1e-2),
                                     ("ww", 1e-6)), 1):
    where = {"pp": "periodic", "pw": "channel", "ww": "box"}[axes]
    row(f"J2{number}", f"white noise, {where}, `deltaT auto`", f"32², nu {nu:g}", "energy falls in every step")(
        lambda bench, a=axes, nu=nu: noise(bench, a, nu))
row("J31", "Couette flow whose wall starts at once", "80 intervals, nu t = 0.01, 0.1",
    "within 5e-7, 5e-9 of the series")(
    lambda bench: couette(bench, 80, ((0.01, 5e-7), (0.1, 5e-9))))
row("J32", "half a channel moves at once", "40 and 80 intervals, nu t = 0.05", "second order, below dy²")(channelJump)
