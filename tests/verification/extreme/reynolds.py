"""Reynolds numbers from 1e-3 to 1e6, speed and size 1."""
import math

from bench import row, short
from symbols import morris, wallDefect

NUMBERS = (1e-3, 1e-1, 10.0, 1e3, 1e6)
MANY_WAVES = ("sin(2*pi*y) + 0.5*cos(2*pi*(2*x + 3*y)) + 0.3*sin(2*pi*(5*x - 2*y))",
              "sin(2*pi*x) - 0.3333333333333333*cos(2*pi*(2*x + 3*y)) + 0.75*sin(2*pi*(5*x - 2*y))")


def vortex(bench, Re):
    nu, end = 1 / Re, min(1.0, 0.02 * Re)
    wave = ("cos(2*pi*(x - t))*sin(2*pi*(y - 0.5*t))", "sin(2*pi*(x - t))*cos(2*pi*(y - 0.5*t))")
    decay = "exp(-8*pi^2*nu*t)"
    exact = (f"1 - {wave[0]}*{decay}", f"0.5 + {wave[1]}*{decay}")
    scene = bench.scene(nu=nu, start=exact, exact=exact, deltaT=end / 40, endTime=end)
    error = scene.solve().error()
    rate = nu * morris([2 * math.pi] * 2, [1.5 / 32] * 2, 10)
    predicted = math.sqrt(0.5) * abs(math.exp(rate * end) - math.exp(-8 * math.pi**2 * nu * end))
    bench.at_most("error less the symbol's", abs(error - predicted), 5e-14)


def manyWaves(bench, Re):
    scene = bench.scene(nu=1 / Re, start=MANY_WAVES, statistics=True, every=1, endTime=2.0)
    run = scene.solve()
    for what, name in (("energy", "kineticEnergy"), ("enstrophy", "enstrophy")):
        values = run.column("flow", name)
        bench.at_most(f"{what} over its start, largest", max(values[1:]) / values[0], 1)
        bench.note(f"at the end {short(values[-1] / values[0])}")


def channelMode(bench, Re):
    nu = 1 / Re
    end = min(2.0, 0.05 * Re)
    exact = ("sin(pi*y)*exp(-nu*pi^2*t)",)
    steps = 200
    scene = bench.scene(axes="pw", intervals=(8, 32), nu=nu, start=exact, exact=exact, deltaT=end / steps, endTime=end)
    error = scene.solve().error()
    decayed = nu * math.pi**2 * end
    # Crank-Nicolson in the substeps: (rate dt)^2/12 at most.
    bound = math.sqrt(0.5) * (wallDefect(decayed, 32) + decayed * (decayed / steps) ** 2 / 12)
    bench.at_most("error", error, bound)


def stokesCavity(bench, Re):
    scene = bench.scene(axes="ww", intervals=(24, 24), nu=1 / Re,
                        walls={"yMax": "type fixedValue; value uniform (1 0 0);"},
                        endTime=0.3 * Re, statistics=True, every=10)
    run = scene.solve()
    n = 25
    U = scene.field()
    asymmetry = max(max(abs(U[3 * (n * j + i)] - U[3 * (n * j + n - 1 - i)]),
                        abs(U[3 * (n * j + i) + 1] + U[3 * (n * j + n - 1 - i) + 1])) for j in range(n)
                        for i in range(n))
    bench.at_most("asymmetry", asymmetry, 0.05 * Re)
    bench.at_most("largest speed over the lid's", max(run.column("flow", "maxSpeed")), 1 + 1e-9)


def cavity(bench, Re, schemes=""):
    scene = bench.scene(axes="ww", intervals=(32, 32), nu=1 / Re,
                        walls={"yMax": "type fixedValue; value uniform (1 0 0);"},
                        schemes=schemes,
                        endTime=min(10.0, Re), statistics=True, every=10)
    run = scene.solve()
    if Re > 1e5 and run.code == 3:
        bench.holds("caught: exit 3, speeds have grown", "diverged" in run.err and "filter" in run.err, run.err)
        return
    bench.at_most("largest speed over the lid's", max(run.column("flow", "maxSpeed")), 1.5)
    bench.at_most("energy over the lid's", max(run.column("flow", "kineticEnergy")) / 0.5, 0.25)


for number, Re in enumerate(NUMBERS, 1):
    row(f"R{number}", "moving Taylor-Green vortex, periodic", f"Re {Re:g}, 32²",
        "its error is that of the kernel's symbol, to round-off")(lambda bench, Re=Re: vortex(bench, Re))
    row(f"R1{number}", "five waves, periodic, `deltaT auto`", f"Re {Re:g}, 32², t = 2",
        "energy and enstrophy never grow")(lambda bench, Re=Re: manyWaves(bench, Re))
    row(f"R2{number}", "decaying mode in a channel", f"Re {Re:g}, 32 intervals",
        "error below that of its eigenvalue, 1e-6, of the second derivative at walls and of the time scheme")(
            lambda bench, Re=Re: channelMode(bench, Re))
    if Re < 1:
        row(f"R3{number}", "lid-driven cavity", f"Re {Re:g}, 24², `deltaT auto`, t = 0.3 Re: steady",
            "mirror symmetry but for 0.05 Re; no speed above the lid's")(lambda bench, Re=Re: stokesCavity(bench, Re))
    else:
        row(f"R3{number}", "lid-driven cavity", f"Re {Re:g}, 32², `deltaT auto`, t = 10",
            "bounded" if Re < 1e5 else "bounded, or caught with the cure")(lambda bench, Re=Re: cavity(bench, Re))
row("R36", "lid-driven cavity, degree 3, filter", "Re 1e+06, 32², `deltaT auto`, t = 10", "bounded")(
    lambda bench: cavity(bench, 1e6, "continuation { degree 3; } filter { type exponential; }"))
