"""Kernels from h/dx 0.7 to 6 and of orders 2 to 66, closed and sampled, periodic and between walls."""
import math
import re

from bench import growth, row
from symbols import morris, second, wallDefect

WIDTHS = (0.7, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0)
ORDERS = (2, 4, 10, 20, 66)
N = 32
VORTEX = ("sin(2*pi*x)*cos(2*pi*y)", "-cos(2*pi*x)*sin(2*pi*y)")


def kernel(order, width, symbol="closed"):
    return f"type gaussian; order {order}; smoothingLength {width}; symbol {symbol};"


def decay(bench, width):
    """The vortex decays as its symbol says, by the integrating factor and by explicit steps below their limit."""
    nu, end, steps = 0.01, 0.5, 60
    worst = 0.0
    for order in ORDERS:
        rate = nu * morris([2 * math.pi] * 2, [width / N] * 2, order)
        for viscous, growth in (("integratingFactor", math.exp(rate * end)),
                                ("explicit", sum((rate * end / steps) ** m / math.factorial(m)
                                                 for m in range(4)) ** steps)):
            scene = bench.scene(nu=nu, start=VORTEX, exact=[f"{u}*{growth!r}" for u in VORTEX], deltaT=end / steps,
                                endTime=end, kernel=kernel(order, width), schemes=f"viscous {viscous};")
            worst = max(worst, scene.solve().error("relL2(U)"))
    bench.at_most("error, worst of five orders", worst, 1e-13)


def manyWaves(bench, width):
    largest = enstrophy = 0.0
    for order in ORDERS:
        scene = bench.scene(nu=1e-3, start=[f"{u} + 0.1*noise({c})" for c, u in enumerate(VORTEX, 1)], endTime=1.0,
                            kernel=kernel(order, width), statistics=True, every=1)
        run = scene.solve()
        K, Z = run.column("flow", "kineticEnergy"), run.column("flow", "enstrophy")
        largest = max(largest, growth(K))
        enstrophy = max(enstrophy, max(Z[1:]) / Z[0])
    bench.at_most("growth of the energy in a step", largest, 1e-9)
    bench.at_most("enstrophy over its start", enstrophy, 1)


def warned(scene):
    """Whether checkCase says that modes at the walls will grow; makes the lattice."""
    scene.run("makeLattice")
    checked = scene.run("checkCase")
    return bool(re.search("smooths too much|anti-diffusive", checked.stdout + checked.stderr))


def channel(bench, width):
    nu, end = 0.01, 1.0
    worst, unstable = 0.0, []
    for order in ORDERS:
        rate = nu * second([math.pi], [width / N], order)
        scene = bench.scene(axes="pw", intervals=(8, N), nu=nu, start=["sin(pi*y)"],
                            exact=[f"sin(pi*y)*exp({rate!r}*t)"],
                            endTime=end, kernel=kernel(order, width))
        if warned(scene):
            unstable.append(str(order))
            continue
        error = scene.solve().error("relL2(U)")
        # What the kernel takes from the wave itself, s^n/n!, is in the rate; as much again where the line is continued.
        s, n = (math.pi * width / N) ** 2 / 4, order // 2
        decayed = nu * math.pi**2 * end
        worst = max(worst, error / (decayed * s**n / math.factorial(n) + wallDefect(decayed, N)))
    bench.at_most("error over its bound, worst order", worst, 1)
    if unstable:
        bench.note(f"orders {', '.join(unstable)} left out: checkCase warns of them")


def channelNoise(bench, width):
    largest, grew = 0.0, []
    for order in ORDERS:
        scene = bench.scene(axes="pw", intervals=(16, N), nu=0.01, start=("1e-3*noise(1)", "1e-3*noise(2)"),
                            statistics=True,
                            every=1, kernel=kernel(order, width), schemes="viscous explicit;")
        said = warned(scene)
        step = min(0.02, 0.8 * scene.limits()["largestStableStep"])
        scene.step(step, 100 * step)
        run = scene.solve()
        if not said:
            largest = max(largest, growth(run.column("flow", "kineticEnergy")) + 1)
            continue
        caught = run.code == 3 and "diverged" in run.err
        grew.append(f"{order} ({'exit 3' if caught else 'noise grows'})")
        bench.holds(f"order {order}: warned of, {'and caught' if caught else 'and noise grows'}",
                    caught or growth(run.column("flow", "kineticEnergy")) > 0)
    bench.at_most("energy over that a step before, orders not warned of", largest, 1)


def wideSamples(bench):
    """Supports of 7.5 h = 25 dx on 32 and 16 points: periodic images are summed."""
    for points in (32, 16):
        for order in (20, 66):
            nu, end, steps = 0.01, 0.5, 100
            rate = nu * morris([2 * math.pi] * 2, [3.3 / points] * 2, order)
            scene = bench.scene(intervals=(points, points), nu=nu, start=VORTEX, deltaT=end / steps, endTime=end,
                                exact=[f"{u}*{math.exp(rate * end)!r}" for u in VORTEX],
                                kernel=kernel(order, 3.3, "sampled") + " supportRadius 7.5;")
            bench.at_most(f"order {order}, {points}²", scene.solve().error("relL2(U)"), 1e-12)


for number, width in enumerate(WIDTHS, 1):
    where = f"h/dx {width:g}, orders 2, 4, 10, 20, 66"
    row(f"H{number}", "Taylor-Green vortex, periodic", f"{where}, 32²", "decays by the symbol's factor to round-off, "
        "integrating factor and explicit")(lambda bench, width=width: decay(bench, width))
    row(f"H1{number}", "vortex and noise, periodic", f"{where}, nu 1e-3, `deltaT auto`",
        "energy and enstrophy do not grow")(lambda bench, width=width: manyWaves(bench, width))
    row(f"H2{number}", "decaying mode in a channel", f"{where}, 32 intervals",
        "decays by the kernel's factor; at walls off by no more than the kernel's own error again and (pi dy)^3.5")(
            lambda bench, width=width: channel(bench, width))
    row(f"H3{number}", "noise in a channel", f"{where}, nu 0.01, explicit",
        "checkCase warns of kernels too wide for walls; with the others energy falls in every step")(
            lambda bench, width=width: channelNoise(bench, width))
row("H41", "Taylor-Green vortex, sampled kernels", "h/dx 3.3, 7.5 h, orders 20 and 66, supports wider than the box",
    "the closed symbol's factor to 1e-12")(wideSamples)
