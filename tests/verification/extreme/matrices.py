"""The tests of docs/theory as rows: programs of tests/ run anew, their figures read from the results they write.

A row names its tests, and the recorded figures with their bounds; where a test states its bounds itself it records how
close the closest figure came (tests/support/record.hpp). In the short form the rows see that their tests are there.
"""
import os
import re
import subprocess
import tempfile
import xml.etree.ElementTree

from bench import LONG, row

TESTS = os.environ.get("CONTINUA_TESTS", os.path.join(os.environ.get("CONTINUA_BIN", "build/bin"), "..", "tests"))
ATTRIBUTES = {"name", "file", "line", "status", "result", "time", "timestamp", "classname"}


def figures(bench, program, tests):
    """Runs tests of a program; what they recorded, as pairs of name and value; fails the row where a test fails."""
    with tempfile.TemporaryDirectory() as folder:
        result = os.path.join(folder, "result.xml")
        done = subprocess.run([os.path.join(TESTS, program), "--gtest_filter=" + tests, "--gtest_output=xml:" + result],
                              capture_output=True, text=True, timeout=LONG, check=False)
        cases = xml.etree.ElementTree.parse(result).getroot().findall(".//testcase") if os.path.exists(result) else []
    failed = [case.get("name") for case in cases if case.find("failure") is not None]
    bench.holds(f"{len(cases)} test{'s' * (len(cases) > 1)} passed", cases and done.returncode == 0,
                ", ".join(failed) or done.stderr.strip() or "no such test")
    found = []
    for case in cases:
        found += [(name, value) for name, value in case.attrib.items() if name not in ATTRIBUTES]
        found += [(entry.get("name"), entry.get("value")) for entry in case.findall("properties/property")]
    return [(name, float(value)) for name, value in found]


def listed(bench, program, tests):
    done = subprocess.run([os.path.join(TESTS, program), "--gtest_filter=" + tests, "--gtest_list_tests"],
                          capture_output=True, text=True, timeout=60, check=False)
    names = [line for line in done.stdout.splitlines() if line.startswith("  ")]
    bench.holds(f"{len(names)} tests", done.returncode == 0 and len(names) >= tests.count(":") + 1, done.stderr)


def ofTests(bench, program, tests, bounds):
    if not bench.full:
        listed(bench, program, tests)
        return
    found = figures(bench, program, tests)
    if not bounds and not any(name == "closest" for name, _ in found):
        return
    for pattern, kind, bound in bounds:
        values = [abs(value) if kind == "most" else value for name, value in found if re.fullmatch(pattern, name)]
        what = pattern.replace(".*", "").replace("\\", "").strip("_ ") or pattern
        if not values:
            bench.holds(f"{what} recorded", False)
        elif kind == "most":
            bench.at_most(what, max(values), bound)
        elif kind == "least":
            bench.at_least(what, min(values), bound)
        else:
            wanted, part = bound
            worst = max(values, key=lambda value: abs(value / wanted - 1))
            bench.at_most(f"{what} {worst:.4g}, off {wanted:.4g} by", abs(worst / wanted - 1), part)
    closest = [value for name, value in found if name == "closest"]
    if closest:
        bench.at_most("closest figure over its bound", max(closest), 1)


def near(wanted, part):
    return wanted, part


FLOW, WALLS, LINES = "verification_flow", "verification_walls", "verification_continuation"
TAYLOR_GREEN = ((20, 4.66e-3, 2.25e-4), (40, 3.13e-4, 3.84e-6), (80, 1.99e-5, 6.13e-8), (160, 1.25e-6, 9.60e-10))
MATRIX = (
    ("K1", "transforms of the kernels by quadrature", "1 to 3 dimensions, orders 2 to 66", "1e-13", "property_kernels",
     "GaussianTransform.*", ()),
    ("K2", "sampled symbols against closed ones", "R = 8 h, h/dx 2.5, to a quarter of Nyquist", "1e-12",
     "unit_operators", "DerivativeSymbol.SampledOneIsTheClosedOneWhereNothingIsCutOff", ()),
    ("K3", "the misprinted kernel of order 10", "its moments", "second moment 3 h² found", "property_kernels",
     "KernelMoments.TellTheMisprinted*", ()),
    ("K4", "Morris' symbol, two terms against the sum", "s = 1e-6 ... 1e3, orders 2 to 66", "1e-13, negative",
     "unit_kernels",
     "Gaussian.MorrisSymbolIsTheSum*", ()),
    ("O1", "convolution against the sum over neighbours", "random data, 2-D and 3-D", "1e-13", "property_operators",
     "Operators.ConvolutionIsTheSumOverNeighbours", ()),
    ("O2", "plus, minus and plain gradients", "2-D and 3-D", "1e-14 of the weights", "property_operators",
     "Operators.PlusMinusAndPlainGradientsAgree", ()),
    ("O3", "first derivative at Nyquist", "every kernel", "exactly 0; real fields stay real", "unit_operators",
     "DerivativeSymbol.VanishesExactlyAtNyquistOfItsAxis", ()),
    ("O4", "order of the operators", "N = 20 ... 80, orders 2 to 10", "within 0.1", "unit_operators",
     "SpectralOperators.HaveTheOrderOfTheirKernel", ()),
    ("P1", "divergence after projection", "random data, aspect ratio 1 and 1000", "1e-13 of |D| |u|",
     "property_poisson",
     "Projection.LeavesNoDivergence", ()),
    ("P2", "projection: twice, of gradients, of solenoidal fields", "the same", "1e-14", "property_poisson",
     "Projection.TwiceIsOnce:Projection.RemovesGradientsWhole:Projection.LeavesSolenoidalFieldsAlone", ()),
    ("T1", "Taylor-Green vortex, gaussian 4", "Re 100, CFL 0.1, h/dx 2, N = 20 ... 160", "theory's errors to 1 %", FLOW,
     "TaylorGreen.closedGaussianOrder4", tuple((f"error{n}", "near", near(error, 0.01)) for n, error,
                                               _ in TAYLOR_GREEN)),
    ("T1b", "the same, gaussian 6", "the same", "theory's errors to 1 %", FLOW, "TaylorGreen.closedGaussianOrder6",
     tuple((f"error{n}", "near", near(error, 0.01)) for n, _, error in TAYLOR_GREEN)),
    ("T1c", "the same, nine kernels", "N = 20, 40, 80", "the digits printed", FLOW, "TaylorGreen.everyKernelOfTheTable",
     ()),
    ("T2", "order in time, RK3, moving vortex", "N = 32", "velocity 2.95 ... 3.05, pressure ≥ 2.9", FLOW,
     "TimeOrder.T2_rungeKutta*", (("velocityOrder", "near", near(3, 0.0167)), ("pressureOrder", "least", 2.9))),
    ("T2b", "order in time, first order projection", "N = 32", "0.95 ... 1.10", FLOW, "TimeOrder.T2_firstOrder*",
     (("velocityOrder", "near", near(1.025, 0.0732)),)),
    ("T3", "integrating factor, exact Laplacian", "nu dt/dx² to 410", "1e-13", FLOW,
     "TaylorGreen.integratingFactorWithExactLaplacianLeavesRoundOff:TaylorGreen.stiffStepsAreExact", ()),
    ("T4", "stiff: noise beside the vortex", "nu = 1, N = 64, nu dt/dx² = 41 ... 410", "no growth; 1e-13", FLOW,
     "StiffViscosity.*", (("error410", "most", 1e-13),)),
    ("T5", "stability limits: 0.98 and 1.03 times", "five kernels, all forms", "bounded; growth > 100", FLOW,
     "StabilityLimits.T5_*", ()),
    ("T6", "mean flow 100 times the vortex", "mean CFL 16 ... 64, 2-D and 3-D", "1e-12 of the vortex", FLOW,
     "MeanFlow.T6_*:MovingTaylorGreen.aLargeMeanFlow*", (("error.*", "most", 1e-12),)),
    ("E1", "energy of an inviscid random field", "CFL 0.04, 0.02, all forms", "drift ≤ 1e-7, order ≥ 2.8", FLOW,
     "Energy.E1_*",
     ((".*_drift", "most", 1e-7), (".*_order", "least", 2.8))),
    ("G1", "Gresho vortex, divergence form, filter", "N = 64, t = 10", "error 0.07, energy 3e-4, pressure 0.04", FLOW,
     "Gresho.G1_*", (("velocityError", "most", 0.07), ("energyDrift", "most", 3e-4), ("pressureError", "most", 0.04))),
    ("G2", "Gresho vortex, rotational form", "N = 64, t = 10", "error 0.045, energy 1e-4", FLOW, "Gresho.G2_*",
     (("velocityError", "most", 0.045), ("energyDrift", "most", 1e-4))),
    ("G3", "Gresho vortex converges", "N = 32, 64, 128, t = 2", "0.042, 0.024, 0.0055", FLOW, "Gresho.G3_*",
     (("keptVelocityError32", "most", 0.042), ("keptVelocityError64", "most", 0.024),
      ("keptVelocityError128", "most", 0.0055))),
    ("G4", "Gresho vortex, `preset paper2021`", "N = 80, h/dx 2",
     "grows as the paper says: 0.065 ± 0.005, lost at 1.4 ... 1.7", FLOW,
     "Gresho.G4_*", (("velocityError", "near", near(0.065, 0.077)), ("energyDoubledAt", "near", near(1.55, 0.0968)))),
    ("D1", "thin shear layer, gaussian 10 and exact", "Re 1e4, N = 128, five times", "energy 1e-4, enstrophy 2e-3",
     FLOW,
     "ThinShearLayer.D1_exactDerivative:ThinShearLayer.D1_gaussian10*",
     (("energyDifference", "most", 1e-4), ("enstrophyDifference", "most", 2e-3))),
    ("D1b", "thin shear layer, gaussian 4", "the same", "2e-4, 8e-3", FLOW, "ThinShearLayer.D1_gaussian4",
     (("energyDifference", "most", 2e-4), ("enstrophyDifference", "most", 8e-3))),
    ("D2", "thin shear layer, under-resolved", "Re 1e4, 1e5, 1e6, N = 64, t = 2, three kernels",
     "Z/Z0 ≤ 1, energy in range", FLOW,
     "ThinShearLayer.D2_*", (("mostEnstrophy.*", "most", 1),)),
    ("X1", "units", "(L, U) from 1e-150 to 1e100, five schemes", "velocity 2e-14, pressure 5e-14", FLOW, "Units.X1_*",
     (("velocity", "most", 2e-14), ("pressure", "most", 5e-14))),
    ("X2", "stretched lattices", "1000 : 1, both ways", "errors of the symbol: 6.06e-5, 2.67e-4, 3.35e-3 to 0.5 %",
     FLOW,
     "Units.X2_*", tuple((f"G4_{n}", "near", near(error, 0.005))
                         for n, error in (("32x32", 6.06e-5), ("64x16", 2.67e-4), ("1024x8", 3.35e-3)))),
    ("X4", "odd, prime, unequal and few points", "N = 1 ... 100", "as their neighbours; nothing not finite", FLOW,
     "Extremes.X4_*", ()),
    ("X5", "zero, constant, a mode at Nyquist", "fifteen schemes", "zero, constant, removed and reported", FLOW,
     "Extremes.X5_*", ()),
    ("X6", "supports larger than half the box", "5 to 9 points, R = 16 dx", "the sum over all images", "unit_operators",
     "DerivativeSymbol.SupportsLargerThanTheBoxReachItsImages", ()),
    ("X7", "first order projection without viscosity", "no stable step", "said so", FLOW, "StabilityLimits.X7_*", ()),
    ("W1", "derivatives of continued lines", "exp(y) sin(5y), N = 50 ... 200", "2e-6, 7e-4, orders ≥ 4.3, 3.3", LINES,
     "ContinuedOperators.HaveTheErrorsOfTheDefault:ContinuedOperators.ConvergeWithTheDegreeOverTheRoot", ()),
    ("W2", "the same, gaussian 4", "h/dx 1.3, N = 100", "5e-6, order 4.0 ± 0.2", LINES,
     "ContinuedOperators.HaveTheOrderOfTheKernelWhereItIsLower", ()),
    ("W3", "polynomials up to the degree", "25 to 40 new points, N to 400", "1e-8", LINES,
     "ContinuedOperators.AreExactForPolynomialsUpToTheDegree", ()),
    ("W4", "the published continuation", "quintic, a quarter of the interval", "2e-4, order 2.4; as printed it fails",
     LINES,
     "ContinuedOperators.OfThePublished*:ContinuedOperators.OfTheQuintic*:ContinuedOperators.FailWith*", ()),
    ("W5", "eigenvalues on continued lines", "N = 64", "diffusion real, negative, -pi² to 1e-6; advection ≤ 0", LINES,
     "Eigenvalues.*", ()),
    ("W6", "manufactured flow in a box", "N = 24 ... 64", "velocity 1.1e-7 × 1.2 at 64, order ≥ 4", WALLS,
     "BoundedManufactured.W6*",
     (("manufactured box N 64", "most", 1.32e-7),)),
    ("W7", "manufactured flow in a channel", "N = 24 ... 64", "velocity 4.7e-8 × 1.2, pressure 1e-6 at 64", WALLS,
     "BoundedManufactured.W7*", (("manufactured channel N 64", "most", 5.64e-8), ("pressure", "most", 1e-6))),
    ("W9", "Neumann problem by cosines", "N = 16 ... 256", "order 2; 4 with the slopes of the source",
     "verification_poisson",
     "BoundedPoissonConvergence.neumann*:BoundedPoissonConvergence.isSecondOrderAndFourth*", ()),
    ("W10", "Poiseuille from the parabola and from rest", "t = 11", "1e-9; 1.3e-6, 4.6e-8, 1.5e-9", WALLS,
     "Poiseuille.*",
     (("N 20", "most", 1.3e-6), ("N 40", "most", 4.6e-8), ("N 80", "most", 1.5e-9), ("order .*, N 40", "most", 1e-9))),
    ("W11", "Couette start-up", "N = 80, nu t = 0.01, 0.1", "5e-7, 5e-9", WALLS, "Couette.*",
     (("nu t 0.01.*, N 80", "most", 5e-7), ("nu t 0.10.*, N 80", "most", 5e-9))),
    ("W12", "a Gaussian leaves the box", "CFL 0.4, N = 40 ... 160", "3e-5 at N = 80; 1e-4 left at t = 3",
     "verification_transport", "GaussianVortex.defaultKernel", ((".*passing.80", "most", 3e-5),
                                                                (".*left.(80|160)", "most", 1e-4))),
    ("W19", "Crank-Nicolson on continued lines", "nu dt/dy² = 0.1 ... 1e6", "no growth, second order",
     "verification_poisson",
     "CrankNicolson.*", ()),
    ("W21", "units between walls", "1e-9 ... 1e6 m, 1e-12 ... 1e9 m/s, six treatments", "velocity 1e-12, pressure 1e-11",
     WALLS,
     "WallExtremes.sameFlowInAnyUnits", (("velocity", "most", 1e-12), ("pressure", "most", 1e-11))),
    ("W22", "thin boxes at 0.95 of their limit", "aspect ratio 100 and 1000", "bounded", WALLS,
     "WallExtremes.thinBoxes*", ()),
    ("W23", "Couette at Re 0.01 in steps beyond the limit", "125 to 1000 times it", "5e-6", WALLS,
     "StiffWalls.couette*",
     (("dt over the explicit limit 1000.*", "most", 5e-6),)),
)
for identifier, case, setting, asked, program, tests, bounds in MATRIX:
    row(identifier, case, setting, asked)(
        lambda bench, program=program, tests=tests, bounds=bounds: ofTests(bench, program, tests, bounds))
