"""The same flows at Re 100 in boxes of 1e-9 m to 1e6 m at speeds of 1e-12 m/s to 1e9 m/s."""
import math

from bench import row, vector

PAIRS = ((1e-9, 1.0), (1e-9, 1e9), (1e-9, 1e-12), (1e6, 1e-12), (1e6, 1e9), (3.7, 0.11))


def periodic(bench, L, U, schemes):
    x, y = f"(2*pi*(x/{L!r}))", f"(2*pi*(y/{L!r}))"
    dt = 0.2 * (L / U) / 32
    scene = bench.scene(extent=(L, L), intervals=(32, 24), nu=U * L / 100, deltaT=dt, endTime=40 * dt, schemes=schemes,
                        start=(f"{U!r}*(0.5 + sin{y} + 0.3*cos(2*{x} + {y}))",
                               f"{U!r}*(0.25 + sin{x} - 0.6*cos(2*{x} + {y}))"))
    return fields(scene, U)


def lid(bench, L, U, schemes):
    speed = f"{U!r}*sin(pi*x/{L!r})^2*(1 + 0.1*sin(t*{U / L!r}))"
    dt = 0.005 * (L / U)
    scene = bench.scene(axes="ww", extent=(L, L), intervals=(16, 20), nu=U * L / 50, deltaT=dt, endTime=100 * dt,
                        schemes=schemes, walls={"yMax": f'type fixedValue; value expression ("{speed}" "0" "0");'})
    return fields(scene, U)


def inlet(bench, L, U, schemes):
    y = f"(y/{L!r})"
    dt = 0.002 * (L / U)
    profile = f"{U!r}*4*{y}*(1 - {y})"
    scene = bench.scene(axes="ww", extent=(2 * L, L), intervals=(32, 16), nu=U * L / 50, deltaT=dt, endTime=100 * dt,
                        schemes=schemes, start=(profile,), inlets=("xMin",),
                        pressures={"xMax": "type fixedValue; value uniform 0;"},
                        walls={"xMin": f"type fixedValue; value {vector([f'{profile}*(1 + 0.1*sin(t*{U / L!r}))'])};",
                               "xMax": "type outflow;"})
    return fields(scene, U)


def fields(scene, U):
    scene.solve().demand()
    return [u / U for u in scene.field()], [p / U / U for p in scene.field(dataset="p")]


def relative(a, b):
    return math.sqrt(sum((x - y) ** 2 for x, y in zip(a, b)) / sum(y * y for y in b))


def compare(bench, flow, schemes, velocity, pressure):
    reference = flow(bench, 1.0, 1.0, schemes)
    worst = [0.0, 0.0]
    for L, U in PAIRS:
        found = flow(bench, L, U, schemes)
        worst = [max(before, relative(a, b)) for before, a, b in zip(worst, found, reference)]
    bench.at_most("velocity over U", worst[0], velocity)
    bench.at_most("pressure over U²", worst[1], pressure)


SETTING = "(L, U) = (1e-9, 1), (1e-9, 1e9), (1e-9, 1e-12), (1e6, 1e-12), (1e6, 1e9), (3.7, 0.11)"
for identifier, case, flow, schemes, bounds in (
        ("U1", "two vortices and a mean flow, periodic, defaults", periodic, "", (2e-14, 5e-14)),
        ("U2", "the same, explicit, rotational, filter", periodic,
         "viscous explicit; convection rotational; filter { type exponential; }", (2e-14, 5e-14)),
        ("U3", "the same, `preset paper2021`", periodic, "preset paper2021;", (2e-14, 5e-14)),
        ("U4", "lid-driven cavity, explicit", lid, "viscous explicit;", (5e-13, 1e-11)),
        ("U5", "lid-driven cavity, Crank-Nicolson", lid, "viscous CrankNicolson;", (1e-12, 1e-11)),
        ("U6", "lid-driven cavity, walls incremental, mirrors", lid,
         "walls incremental; continuation { type mirror; } viscous explicit;", (1e-14, 5e-14)),
        ("U7", "channel with inlet and outlet", inlet, "", (1e-12, 3e-10))):
    row(identifier, case, SETTING, "the numbers of (1, 1) but for round-off")(
        lambda bench, flow=flow, schemes=schemes, bounds=bounds: compare(bench, flow, schemes, *bounds))
