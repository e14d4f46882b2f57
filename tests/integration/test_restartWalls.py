"""Flows between walls go on in the same bits too, whatever stopped them; their functions can be run afterwards."""
import os
import random
import signal
import time
import unittest

from cases import CaseTest, header, wait_for

SIDES = {"walls": ("wall", "xMin xMax"), "floor": ("wall", "yMin"), "lid": ("wall", "yMax"),
         "inlet": ("patch", "xMin"), "outlet": ("patch", "xMax")}
OSCILLATING = 'type fixedValue; value expression ("sin(pi*x)^2*(1 + sin(20*t))" "0" "0");'
SCENES = {  # name: (patches and their conditions of U, schemes)
    "channel": ({"sides": None, "floor": "type noSlip;", "lid": OSCILLATING}, ""),
    "cavity": ({"walls": "type noSlip;", "floor": "type slip;", "lid": OSCILLATING}, ""),
    "outlet": ({"inlet": 'type fixedValue; value expression ("6*y*(1 - y)*(1 + 0.2*sin(9*t))" "0" "0");',
                "outlet": "type outflow;", "floor": "type noSlip;", "lid": "type noSlip;"}, ""),
    "staggered": ({"sides": None, "floor": "type noSlip;", "lid": OSCILLATING}, "// staggered"),
    "direct": ({"walls": "type noSlip;", "floor": "type noSlip;", "lid": OSCILLATING}, "// direct"),
    "iterated": ({"sides": None, "floor": "type noSlip;", "lid": OSCILLATING}, "// BiCGStab"),
    "iteratedBox": ({"walls": "type noSlip;", "floor": "type slip;", "lid": OSCILLATING}, "// staggered, CG"),
}
# With a loose tolerance, so that start values show in the bits. The matrix wants dense samples, and mirrors.
ITERATED = "kernel { type gaussian; order 4; smoothingLength 2; }\ncontinuation { type mirror; }"
SCHEMES = ("viscous CrankNicolson;", "viscous explicit;", "viscous explicit; walls incremental;",
           "viscous explicit; walls rotational;", "viscous explicit; walls slip;",
           "viscous explicit; walls pressurePoisson;", "viscous explicit; filter { type exponential; }")


class BetweenWalls(CaseTest):
    def between_walls(self, scene, schemes="", intervals=24, nu="0.02", deltaT="0.002", endTime=0.04, writeInterval="5",
                      **settings):
        patches, more = SCENES[scene]
        functions = ('    flow { type flowStatistics; writeControl timeStep; writeInterval 5; }\n'
                     '    pull { type forces; patches (lid); writeControl timeStep; writeInterval 5; }\n')
        case = self.case(functions=functions, nu=nu, deltaT=deltaT, endTime=endTime, writeInterval=writeInterval,
                         **settings)
        rows = "".join(
            f"    {name} {{ type periodic; axis x; }}\n" if U is None else
            f"    {name} {{ type {SIDES[name][0]}; faces ({SIDES[name][1]}); }}\n" for name, U in patches.items())
        staggered = "arrangement staggered;\n" if "staggered" in more else ""
        case.put("system/latticeDict", f"origin (0 0 0);\nextent (1 1 0);\nintervals ({intervals} {intervals} 0);\n"
                                       f"{staggered}patches\n{{\n{rows}}}\n")
        U = "".join(f"    {name} {{ {condition or 'type periodic;'} }}\n" for name, condition in patches.items())
        p = "".join(f"    {name} {{ {self.pressure(name, U)} }}\n" for name, U in patches.items())
        case.put("0/U", "dimensions [0 1 -1 0 0 0 0];\ninternalField uniform (0 0 0);\nboundaryField\n{\n" + U + "}\n")
        case.put("0/p", "dimensions [0 2 -2 0 0 0 0];\ninternalField uniform 0;\nboundaryField\n{\n" + p + "}\n")
        solver = next((word for word in ("direct", "BiCGStab", "CG") if word in more), "fft")
        kernel = ITERATED if solver in ("BiCGStab", "CG") else "kernel { type gaussian; }"
        case.put("system/schemes", header("schemes") + f"{kernel}\n{schemes}\n")
        case.put("system/solution", f"p {{ solver {solver}; tolerance 1e-5; }}\n")
        os.remove(case.path("system/sampleDict"))
        self.succeeds(case, "makeLattice")
        return case

    @staticmethod
    def pressure(name, U):
        return "type periodic;" if U is None else "type fixedValue; value uniform 0;" if name == "outlet" \
            else "type zeroGradient;"

    def goes_on_in_the_same_bits(self, *arguments, **settings):
        whole = self.between_walls(*arguments, **settings)
        self.succeeds(whole, "isphFoam")
        parts = self.between_walls(*arguments, **settings)
        middle = whole.times()[len(whole.times()) // 2]
        parts.set("system/controlDict", "endTime", middle)
        self.succeeds(parts, "isphFoam")
        self.assertEqual(parts.times()[-1], middle)
        parts.set("system/controlDict", "endTime", "0.04")
        said = self.succeeds(parts, "isphFoam")
        self.assertNotIn("transform plans", said.stdout + said.stderr)
        self.assertEqual(parts.times(), whole.times())
        self.same_state(parts, parts.times()[-1], whole, whole.times()[-1])
        return whole


class Restart(BetweenWalls):
    def test_every_scene(self):
        for scene in SCENES:
            with self.subTest(scene):
                self.goes_on_in_the_same_bits(scene)

    def test_every_treatment(self):
        for scene in ("channel", "cavity"):
            for schemes in SCHEMES:
                with self.subTest(scene=scene, schemes=schemes):
                    self.goes_on_in_the_same_bits(scene, schemes)

    def test_outlet_with_other_treatments(self):
        for schemes in ("walls incremental;", "walls pressurePoisson;"):
            with self.subTest(schemes):
                self.goes_on_in_the_same_bits("outlet", f"viscous explicit; {schemes}")

    def test_adapted_steps(self):
        # Thick enough for viscous auto to take the implicit way.
        for nu in ("0.02", "5"):
            with self.subTest(nu=nu):
                self.goes_on_in_the_same_bits("cavity", nu=nu, deltaT="auto", writeControl="adjustableRunTime",
                                              writeInterval="0.01")

    def test_functions_afterwards(self):
        for scene in ("channel", "outlet", "cavity"):
            with self.subTest(scene):
                case = self.between_walls(scene)
                self.succeeds(case, "isphFoam")
                before = {name: case.table(name) for name in ("flow", "pull")}
                self.succeeds(case, "isphFoam", "-postProcess", "-noZero")
                for name, rows in before.items():
                    again = case.table(name)
                    self.assertEqual(len(again), len(case.times()) - 1)
                    kept = {float(row["time"]): row for row in rows}
                    for row in again:
                        old = kept[float(row["time"])]
                        for column, value in row.items():
                            if column == "enstrophyBudget":  # a difference of rows, which here lie further apart
                                continue
                            wanted = float(old[column])
                            self.assertAlmostEqual(float(value), wanted, delta=1e-6 * max(1, abs(wanted)),
                                                   msg=f"{name} {column}")


class Stopped(BetweenWalls):
    LONG = dict(scene="cavity", intervals=48, endTime=0.6)

    def test_by_signals_and_kills(self):
        whole = self.between_walls(**self.LONG)
        begin = time.monotonic()
        self.succeeds(whole, "isphFoam")
        seconds = time.monotonic() - begin
        draw = random.Random(3)
        case = self.between_walls(**self.LONG)
        process = case.start("isphFoam")
        self.assertTrue(wait_for(lambda: len(case.times()) > 3))
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130)
        for _ in range(5):
            process = case.start("isphFoam")
            time.sleep(draw.uniform(0.02, 0.3) * seconds)
            process.kill()
            process.communicate()
            for name in case.times()[1:]:
                if name in whole.times():
                    self.assertEqual(case.values(name), whole.values(name))
        self.succeeds(case, "isphFoam")
        self.same_state(case, case.times()[-1], whole, whole.times()[-1])


if __name__ == "__main__":
    unittest.main()
