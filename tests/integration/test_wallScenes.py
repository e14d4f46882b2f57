"""Random flows between walls: each is refused with its place and a cure, or steps to finite values."""
import os
import random
import re
import unittest

from cases import CaseTest, header

SCENES = 60
TREATMENTS = {"": ("consistent", "paper", "incremental", "rotational", "slip", "pressurePoisson"),
              "staggered": ("paper", "incremental", "rotational")}
CONTINUATIONS = {"": ("smoothGram", "smoothGram", "mirror", "polynomial", "gram"), "staggered": ("mirror",)}
KERNELS = ("gaussian;", "exact;", "gaussian; order 4; smoothingLength 1.3;", "quinticSpline; smoothingLength 1;",
           "gaussian; symbol sampled;")


class Scene:
    """Words drawn at random; most draws make a flow, some make none."""

    def __init__(self, seed):
        self.draw = draw = random.Random(seed)
        self.axes = "xyz" if draw.random() < 0.25 else "xy"
        self.sane = draw.random() < 0.9
        self.unit = draw.choice(("", "", "e-9", "e6"))
        self.extents = [draw.choice(("1", "1", "30")) + self.unit for _ in self.axes]
        self.counts = [draw.choice((4, 5, 8, 9, 10, 12, 16, 20) if self.sane else (1, 2, 3, 4)) for _ in self.axes]
        self.arrangement = draw.choice(("", "", "staggered"))
        self.nu = float(draw.choice(("0", "0.01", "1e-6", "1", "1e6"))) * float("1" + self.unit)
        self.patches = {}  # name: (patch, U, p)
        for axis in self.axes:
            if draw.random() < 0.3:
                self.patches[axis] = (f"type periodic; axis {axis};", "type periodic;", "type periodic;")
                continue
            for side in ("Min", "Max"):
                self.patches[axis + side] = self.face(axis + side)
        self.schemes = self.words()

    def face(self, name):
        words = ["noSlip", "noSlip", "noSlip", "slip", "symmetry"]
        if name[0] != "x" or not self.sane:
            words += ["moving", "oscillating"]
        if name == "xMin" or not self.sane:
            words += ["inlet"]
        if name.endswith("Max"):
            words += ["outflow", "outflow"]
        word = self.draw.choice(words)
        p = "type fixedValue; value uniform 0;" if word == "outflow" else "type zeroGradient;"
        if self.draw.random() < 0.1:
            p = self.draw.choice(("type fixedValue; value uniform 0;", "type fixedGradient; gradient uniform 1e-3;"))
        U = {"moving": "fixedValue; value uniform (1 0 0)",
             "oscillating": 'fixedValue; value expression ("sin(3*t)" "0" "0")',
             "inlet": f'fixedValue; value expression ("4*y/{self.extents[1]}*(1 - y/{self.extents[1]})" "0" "0")'}
        kind = "patch" if word in ("inlet", "outflow") else "wall"
        return f"type {kind}; face {name};", f"type {U.get(word, word)};", p

    def words(self):
        draw = self.draw
        words = [f"kernel {{ type {draw.choice(KERNELS)} }}"]
        if draw.random() < 0.6:
            words.append(f"walls {draw.choice(TREATMENTS[self.arrangement if self.sane else ''])};")
        if draw.random() < 0.6 and not (self.sane and words[1:]):
            words.append(f"viscous {draw.choice(('auto', 'explicit', 'CrankNicolson'))};")
        if draw.random() < 0.4:
            continuation = draw.choice(CONTINUATIONS[self.arrangement if self.sane else ''])
            words.append(f"continuation {{ type {continuation}; }}")
        elif draw.random() < 0.2:
            words.append(f"continuation {{ degree {draw.choice((1, 2, 3, 6, 8))}; }}")
        if draw.random() < 0.2:
            words.append("filter { type exponential; }")
        if draw.random() < 0.1:
            words.append("time firstOrderProjection;")
        return "\n".join(words) if draw.random() < 0.9 else f"preset {draw.choice(('paper2021', 'paper2026'))};"

    def step(self):
        """A tenth of what the spacing bears, roughly."""
        spacing = min(float(extent) / count for extent, count in zip(self.extents, self.counts))
        step = spacing / 1.5
        if self.nu > 0 and "CrankNicolson" not in self.schemes:
            step = min(step, spacing**2 / (4 * self.nu))
        if "firstOrder" in self.schemes:
            step = min(step, self.nu)
        return 0.1 * step or spacing


class WallScenes(CaseTest):
    def written(self, scene):
        case = self.case(functions="    flow { type flowStatistics; writeControl timeStep; writeInterval 1; }\n",
                         nu=repr(scene.nu), deltaT=repr(scene.step()), endTime=repr(3 * scene.step()), writeInterval="3")
        flat = " 0" if len(scene.axes) == 2 else ""
        rows = [[], [], []]
        for name, parts in scene.patches.items():
            for row, part in zip(rows, parts):
                row.append(f"    {name} {{ {part} }}\n")
        case.put("system/latticeDict",
                 f"origin (0 0 0);\nextent ({' '.join(scene.extents)}{flat});\n"
                 f"intervals ({' '.join(map(str, scene.counts))}{flat});\n"
                 f"arrangement {scene.arrangement or 'collocated'};\npatches\n{{\n{''.join(rows[0])}}}\n")
        x, y = (f"pi*{axis}/{extent}" for axis, extent in zip("xy", scene.extents))
        start = scene.draw.choice(("uniform (0 0 0)",
                                   f'expression ("0.1*sin({x})*cos({y})" "-0.1*cos({x})*sin({y})" "0")'))
        case.put("0/U", f"dimensions [0 1 -1 0 0 0 0];\ninternalField {start};\nboundaryField\n{{\n{''.join(rows[1])}}}\n")
        case.put("0/p", "dimensions [0 2 -2 0 0 0 0];\ninternalField uniform 0;\nboundaryField\n"
                        f"{{\n{''.join(rows[2])}}}\n")
        case.put("system/schemes", header("schemes") + scene.schemes + "\n")
        case.put("system/solution", f"p {{ solver {scene.draw.choice(('fft', 'fft', 'fft', 'fft', 'fft', 'direct'))}; }}\n")
        os.remove(case.path("system/sampleDict"))
        return case

    def assertRefused(self, result, what):
        self.assertEqual(result.returncode, 1, what)
        self.assertRegex(result.stderr, r"(system/\w+(:\d+)?|0/[Up](:\d+)?|preset \w+(:\d+)?): ", what)
        self.assertRegex(result.stderr, "\n    |must be", what)  # a cure

    def test_scenes(self):
        done = {"refused": 0, "diverged": 0, "finite": 0}
        for seed in range(SCENES):
            case = self.written(scene := Scene(seed))
            what = f"scene {seed}: {scene.schemes}\n{case.text('system/latticeDict')}{case.text('0/U')}"
            result = case.run("makeLattice", timeout=60)
            if result.returncode == 0:
                checked = case.run("checkCase", timeout=60)
                result = case.run("isphFoam", timeout=60)
                if checked.returncode != 0:
                    self.assertRefused(checked, what + checked.stderr)
                    self.assertEqual(result.returncode, 1, what + result.stderr)
            what += result.stderr
            if result.returncode == 3:
                self.assertRegex(result.stderr, "above the largest stable step|boundary", what)
                done["diverged"] += 1
            elif result.returncode != 0:
                self.assertRefused(result, what)
                done["refused"] += 1
            else:
                for name in ("U", "p"):
                    self.assertIsNone(re.search("nan|inf", case.values(case.times()[-1], name)), what)
                done["finite"] += 1
            case.remove()
        print(f"{self.id()}: {done}")
        self.assertGreater(done["finite"], SCENES // 3)
        self.assertGreater(done["refused"], SCENES // 10)


if __name__ == "__main__":
    unittest.main()
