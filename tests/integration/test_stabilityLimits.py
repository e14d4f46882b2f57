"""The limits that checkCase prints are those of the solver: stable at 0.98 of them, unstable at 1.03."""
import json
import os
import re
import unittest

from cases import CaseTest, header


class StabilityLimits(CaseTest):
    """Stable at 0.98 of the printed limit, unstable at 1.03: a uniform flow, or a fluid at rest, with noise."""

    STEPS = 400
    POINTS = 24

    def stability(self, case):
        return json.loads(self.succeeds(case, "checkCase", "-json").stdout)["stability"]

    def growth(self, schemes, nu, velocity, number, diffusive, height):
        """Largest and last error norm over the first, after STEPS steps of that part of the printed limit."""
        case = self.case(points=self.POINTS, nu=nu, functions="")
        case.replace("system/latticeDict", "extent (1 1 0)", f"extent (1 {height} 0)")
        self.succeeds(case, "makeLattice")
        noise = [f"{mean} + 1e-6*noise({seed})" for mean, seed in zip(velocity, (1, 2))]
        case.put("0/U", re.sub(r"internalField.*;", f'internalField expression ("{noise[0]}" "{noise[1]}" "0");',
                               case.text("0/U")))
        case.put("system/schemes", header("schemes") + schemes)
        stability = self.stability(case)
        limit = stability["viscousNumber" if diffusive else "courant"]
        dx, dy = 1 / self.POINTS, height / self.POINTS
        rate = float(nu) / min(dx, dy) ** 2 if diffusive else max(velocity[0] / dx, velocity[1] / dy)
        deltaT = number * limit / rate
        case.set("system/controlDict", "deltaT", repr(deltaT))
        case.set("system/controlDict", "endTime", repr(self.STEPS * deltaT))
        case.set("system/controlDict", "writeInterval", "endTime")
        uniform = f'exact {{ U uniform ({velocity[0]} {velocity[1]} 0); }}'
        case.replace("system/controlDict", "functions\n{", f"functions\n{{\n    errors {{ type errorNorms; "
                     f"writeInterval {self.STEPS // 8}; {uniform} }}")
        ruling = self.stability(case)["ruling"]
        self.assertEqual(ruling, "viscous" if diffusive else "convective")
        result = case.run("isphFoam")
        if result.returncode == 3:
            return float("inf"), float("inf")
        self.assertEqual(result.returncode, 0, result.stderr)
        norms = [float(row["L2(U)"]) for row in case.table("errors")]
        return max(norms) / norms[0], norms[-1] / norms[0]

    def check(self, schemes, nu="0", velocity=(1, 0), diffusive=False, height=1):
        largest, _ = self.growth(schemes, nu, velocity, 0.98, diffusive, height)
        self.assertLess(largest, 2, f"not stable at 0.98: {schemes}")
        _, last = self.growth(schemes, nu, velocity, 1.03, diffusive, height)
        self.assertGreater(last, 100, f"stable at 1.03: {schemes}")

    KERNELS = {
        "gaussian 4": "kernel { type gaussian; order 4; smoothingLength 1.3; }",
        "gaussian 10": "kernel { type gaussian; order 10; }",
        "exact": "kernel { type exact; }",
        "quintic spline": "kernel { type quinticSpline; smoothingLength 1.5; }",
        "sampled": "kernel { type gaussian; order 6; symbol sampled; supportRadius 4; renormalise yes; }",
    }

    def test_courant_number(self):
        for name, kernel in self.KERNELS.items():
            with self.subTest(name):
                self.check(kernel + "meanFlow none;")
                self.check(kernel + "meanFlow none; dealiasing none;", velocity=(0, 2))

    def test_stretched_lattice(self):
        self.check(self.KERNELS["gaussian 4"] + "meanFlow none;", velocity=(0, 1), height=3)
        self.check(self.KERNELS["gaussian 4"] + "convection none; viscous explicit;", "0.1", (0, 0), True, 3)

    def test_courant_number_of_every_form(self):
        for form in ("rotational", "advective", "skewSymmetric"):
            with self.subTest(form):
                self.check(self.KERNELS["gaussian 4"] + f"meanFlow none; convection {form};")

    def test_viscous_number(self):
        for name, kernel in self.KERNELS.items():
            for laplacian in ("morris", "exact"):
                with self.subTest(name, laplacian=laplacian):
                    self.check(kernel + f"convection none; viscous explicit; laplacian {laplacian};", "0.1", (0, 0),
                               True)

    def test_viscous_number_of_other_schemes(self):
        rest = "convection none; viscous explicit;"
        for schemes in ("laplacian secondDerivative;", "time firstOrderProjection;", "dealiasing none;"):
            with self.subTest(schemes):
                self.check(self.KERNELS["gaussian 4"] + rest + schemes, "0.1", (0, 0), True)

    def test_neighbour_summation(self):
        kernel = self.KERNELS["quintic spline"] + "operators directSum; viscous explicit; meanFlow none;"
        self.check(kernel)
        self.check(kernel + "convection none;", "0.1", (0, 0), True)

    def test_forward_euler_has_no_courant_number(self):
        case = self.ready_case(mean=(1, 0.5))
        case.put("system/schemes", self.KERNELS["exact"] + "time firstOrderProjection; meanFlow none;")
        stability = self.stability(case)
        self.assertEqual(stability["courant"], 0)
        self.assertRegex(self.succeeds(case, "checkCase").stdout, r"2 nu/\|u\|\^2")
        case.put("system/schemes", self.KERNELS["exact"] + "time RK3; convection none;")
        self.assertIsNone(self.stability(case)["courant"])
        self.assertIsNone(self.stability(case)["largestStableStep"])


class WallLimits(CaseTest):
    """Between walls that move with the flow the printed limits are safe, and within 20 % of where noise grows."""

    STEPS = 500
    stability = StabilityLimits.stability

    def growth(self, schemes, nu, velocity, number, height):
        case = self.case(nu=nu, functions="")
        case.put("system/latticeDict", f"origin (0 0 0); extent (1 {height} 0); intervals (24 24 0);\n"
                 "patches { sides { type periodic; axis x; } walls { type wall; faces (yMin yMax); } }\n")
        case.put("0/U", 'dimensions [0 1 -1 0 0 0 0];\n'
                 f'internalField expression ("{velocity} + 1e-6*noise(1)" "1e-6*noise(2)" "0");\n'
                 "boundaryField { sides { type periodic; }\n"
                 f"    walls {{ type fixedValue; value uniform ({velocity} 0 0); }} }}\n")
        case.put("0/p", "dimensions [0 2 -2 0 0 0 0];\ninternalField uniform 0;\n"
                 "boundaryField { sides { type periodic; } walls { type zeroGradient; } }\n")
        case.put("system/schemes", header("schemes") + schemes)
        os.remove(case.path("system/sampleDict"))
        self.succeeds(case, "makeLattice")
        stability = self.stability(case)
        self.assertEqual(stability["ruling"], "viscous" if float(nu) > 0 else "convective")
        deltaT = number * stability["largestStableStep"]
        case.set("system/controlDict", "deltaT", repr(deltaT))
        case.set("system/controlDict", "endTime", repr(self.STEPS * deltaT))
        case.set("system/controlDict", "writeInterval", "endTime")
        case.replace("system/controlDict", "functions\n{", f"functions\n{{\n    errors {{ type errorNorms; "
                     f"writeInterval {self.STEPS // 8}; exact {{ U uniform ({velocity} 0 0); }} }}")
        result = case.run("isphFoam")
        if result.returncode == 3:
            return float("inf"), float("inf")
        self.assertEqual(result.returncode, 0, result.stderr)
        norms = [float(row["L2(U)"]) for row in case.table("errors")]
        return max(norms) / norms[0], norms[-1] / norms[0]

    def check(self, schemes, nu, velocity, height=1):
        largest, _ = self.growth(schemes, nu, velocity, 0.98, height)
        self.assertLess(largest, 2, f"not stable at 0.98: {schemes}")
        _, last = self.growth(schemes, nu, velocity, 1.2, height)
        self.assertGreater(last, 100, f"stable at 1.2: {schemes}")

    KERNELS = {
        "exact": "kernel { type exact; }",
        "the default": "kernel { type gaussian; }",
        "gaussian 4, wide": "kernel { type gaussian; order 4; smoothingLength 2; }",
        "sampled": "kernel { type gaussian; order 4; symbol sampled; supportRadius 4; }",
    }

    def test_between_walls(self):
        for name, kernel in self.KERNELS.items():
            for height in (1, 3) if name == "exact" else (1,):
                with self.subTest(name, height=height):
                    self.check(kernel + "convection none; viscous explicit;", "0.1", 0, height)
                    self.check(kernel, "0", 1, height)


if __name__ == "__main__":
    unittest.main()
