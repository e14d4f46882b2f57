"""Schemes of boxes with walls: what makeLattice steers to, what checkCase says of them, and what is refused."""
import json
import os
import re

from cases import CaseTest, header


class Boxes(CaseTest):
    def box(self, intervals="(48 60 0)", schemes="", arrangement="collocated", nu="0.01", extent="(1 1 0)", **settings):
        """A box with walls all round and a lid that moves."""
        case = self.case(functions="", nu=nu, **settings)
        flat = extent.endswith(" 0)")
        case.put("system/latticeDict", f"origin (0 0 0);\nextent {extent};\nintervals {intervals};\n"
                 f"arrangement {arrangement};\npatches\n{{\n    lid {{ type wall; face yMax; }}\n"
                 f"    walls {{ type wall; faces (xMin xMax yMin{'' if flat else ' zMin zMax'}); }}\n}}\n")
        case.put("0/U", "dimensions [0 1 -1 0 0 0 0];\ninternalField uniform (0 0 0);\nboundaryField\n{\n"
                 "    lid { type fixedValue; value uniform (1 0 0); }\n    walls { type noSlip; }\n}\n")
        case.put("0/p", "dimensions [0 2 -2 0 0 0 0];\ninternalField uniform 0;\nboundaryField\n{\n"
                 "    \".*\" { type zeroGradient; }\n}\n")
        case.put("system/schemes", header("schemes") + f"kernel {{ type gaussian; }}\n{schemes}\n")
        os.remove(case.path("system/sampleDict"))
        return case

    def ready_box(self, **settings):
        case = self.box(**settings)
        self.succeeds(case, "makeLattice")
        return case

    def report(self, case):
        return json.loads(self.succeeds(case, "checkCase", "-json").stdout)


class Steering(Boxes):
    def said(self, **settings):
        return self.succeeds(self.box(**settings), "makeLattice").stdout

    def test_fast_counts_are_said_to_be_fast(self):
        said = self.said()
        self.assertIn("Transform along x: pressure 48 intervals, fast; derivatives 49 points and 31 new ones make 80, "
                      "fast\n", said)
        self.assertIn("Transform along y: pressure 60 intervals, fast; derivatives 61 points and 35 new ones make 96, "
                      "fast\n", said)

    def test_slow_counts_name_the_nearest_fast_ones(self):
        said = self.said(intervals="(61 22 0)")
        self.assertIn("Transform along x: pressure 61 intervals, slow: 60 and 63 are the nearest fast ones; ", said)
        self.assertIn("Transform along y: pressure 22 intervals, slow: 21 and 24 are the nearest fast ones; ", said)

    def test_staggered_axes_have_as_many_intervals_as_points(self):
        said = self.said(intervals="(64 61 0)", arrangement="staggered")
        self.assertIn("Transform along x: pressure 64 intervals, fast; ", said)
        self.assertIn("Transform along y: pressure 61 intervals, slow: 60 and 63", said)

    def test_checkCase_knows_the_same(self):
        report = self.report(self.ready_box(intervals="(61 48 0)"))
        self.assertFalse(report["lattice"]["fastTransforms"])
        self.assertEqual(report["warnings"], ["transforms of 61 intervals along x are slow: 60 and 63 are the nearest fast "
                                              "ones"])


class Reports(Boxes):
    def test_defaults_are_those_of_bounded_axes(self):
        report = self.report(self.ready_box())
        self.assertEqual(report["warnings"], [])
        self.assertEqual(report["lattice"], {"points": [49, 61, 1], "spacing": [1 / 48, 1 / 60],
                                             "axes": ["bounded", "bounded"], "fastTransforms": True})
        expected = {"kernel.order": "20", "convection": "advective", "laplacian": "secondDerivative",
                    "viscous": "auto", "meanFlow": "none", "dealiasing": "none", "continuation.type": "smoothGram",
                    "continuation.degree": "4", "continuation.smoothness": "16",
                    "continuation.extension": "31 along x, 35 along y", "continuation.extended": "no",
                    "walls": "consistent"}
        self.assertEqual({key: report["schemes"][key] for key in expected}, expected)
        self.assertNotIn("continuation.points", report["schemes"])
        self.assertNotIn("coupling.type", report["schemes"])
        self.assertIn("walls: consistent", report["active"])
        self.assertIn("continuation along y: smoothGram, degree 4, 5 points at each end, 35 new points make a period of 96, "
                      "fast", report["active"])
        self.assertEqual(report["transformsPerSubstep"], 24)
        self.assertIn("24 a substep, 72 a step, each of the lines along one axis",
                      self.succeeds(self.ready_box(), "checkCase").stdout)

    def test_staggered_lattices_are_mirrored(self):
        report = self.report(self.ready_box(arrangement="staggered"))
        self.assertEqual(report["schemes"]["continuation.type"], "mirror")
        self.assertEqual(report["schemes"]["walls"], "paper")

    def test_presets(self):
        for preset, kind in (("paper2021", "mirror"), ("paper2026", "polynomial")):
            with self.subTest(preset):
                case = self.ready_box(intervals="(64 64 0)")
                case.put("system/schemes", f"preset {preset};\n")
                report = self.report(case)
                self.assertEqual(report["schemes"]["continuation.type"], kind)
                self.assertEqual(report["schemes"]["walls"], "paper")
                self.assertEqual(report["kernel"]["neighbours"], 17)  # of a line
                self.assertRegex(self.succeeds(case, "checkCase").stdout, rf"walls +paper +preset {preset}\n")

    def test_entries_without_effect(self):
        case = self.ready_box(schemes="continuation { type mirror;\n degree 3;\n points 9; }")
        case.put("system/solution", "p { solver direct;\n eigenvalues exact;\n tolerance 1e-8; }\n"
                                    "coupling { type nonIncremental; }\n")
        idle = {entry["entry"]: entry["why"] for entry in self.report(case)["withoutEffect"]}
        for entry in ("continuation.degree", "continuation.points", "p.eigenvalues", "p.tolerance", "coupling.type"):
            self.assertIn(entry, idle)
        self.assertEqual(idle["p.tolerance"], "the solver direct does not iterate")

    def test_memory_is_that_of_a_run(self):
        for intervals, extent in (("(320 320 0)", "(1 1 0)"), ("(48 48 48)", "(1 1 1)")):
            with self.subTest(intervals):
                case = self.ready_box(intervals=intervals, extent=extent, endTime=1e-4, deltaT="1e-5",
                                      schemes="viscous explicit;")
                expected = self.report(case)["memory"]
                self.succeeds(case, "isphFoam")
                self.assertAlmostEqual(case.report()["peakMemory"] / expected, 1, delta=0.25)

    def test_the_step_is_that_of_the_run(self):
        for schemes in ("viscous explicit;", "viscous CrankNicolson;", "preset paper2026; viscous explicit;"):
            with self.subTest(schemes):
                case = self.ready_box(schemes=schemes, deltaT="auto", endTime=0.02, writeInterval="endTime")
                expected = self.report(case)["stability"]
                said = self.succeeds(case, "isphFoam", "-verbose").stdout
                first = float(re.search(r"deltaT = (\S+)", said).group(1))
                self.assertAlmostEqual(expected["deltaT"] / first, 1, delta=1e-5)

    def test_crank_nicolson_where_it_pays(self):
        thick = self.report(self.ready_box(nu="10", deltaT="auto"))["stability"]
        self.assertTrue(thick["crankNicolson"])
        self.assertEqual(thick["ruling"], "convective")
        thin = self.report(self.ready_box(nu="0.001", deltaT="auto"))["stability"]
        self.assertFalse(thin["crankNicolson"])
        # A step that the explicit term does not bear.
        case = self.ready_box(nu="0.01", deltaT="0.02")
        self.assertTrue(self.report(case)["stability"]["crankNicolson"])
        case.set("system/controlDict", "deltaT", "0.001")
        self.assertFalse(self.report(case)["stability"]["crankNicolson"])


class Warnings(Boxes):
    def warnings(self, schemes, kernel="type gaussian; order 4; smoothingLength 1.3;", intervals="(128 128 0)"):
        case = self.ready_box(intervals=intervals, endTime=1e-4, deltaT="1e-5")
        case.put("system/schemes", f"kernel {{ {kernel} }}\n{schemes}\n")
        return self.report(case)["warnings"]

    def test_polynomials_that_make_viscosity_grow(self):
        found = self.warnings("continuation { type polynomial; points 8; extension 31; }")
        self.assertTrue(any("the Laplacian of the continued lines is anti-diffusive" in text for text in found), found)
        self.assertEqual(self.warnings("continuation { type polynomial; points 32; extension 31; }"), [])

    def test_kernels_that_smooth_too_much_for_the_projection(self):
        spline = "type quinticSpline;"
        found = self.warnings("", spline, "(24 24 0)")
        self.assertIn("the kernel smooths too much for the continuation along x", found[0])
        self.assertEqual(self.warnings("continuation { degree 2; }", spline, "(24 24 0)"), [])
        self.assertEqual(self.warnings("continuation { type mirror; }", spline, "(24 24 0)"), [])

    def test_a_preset_at_another_courant_number_than_its_paper(self):
        case = self.ready_box(intervals="(48 48 0)", deltaT="auto", arrangement="staggered")
        case.put("0/U", case.text("0/U").replace("uniform (0 0 0)", "uniform (1 0 0)", 1))
        case.put("system/schemes", "preset paper2021;\n")
        self.assertIn("write deltaT auto; and maxCo 0.1;", self.report(case)["warnings"][0])
        case.set("system/controlDict", "maxCo", "0.1")
        self.assertEqual(self.report(case)["warnings"], [])

    def test_extensions_that_are_slow(self):
        found = self.warnings("continuation { extension 30; }", intervals="(48 48 0)")  # 49 + 30 is a prime
        self.assertIn("transforms of 79 points along x, 30 of them new, are slow: an extension of 31 points", found[0])


class BadInput(Boxes):
    """Refused by solver and checkCase alike, with file and line; nothing is written."""

    def refused(self, case, part, *expected):
        before = case.state()
        place = f"system/schemes:{case.line_of('system/schemes', part)}: "
        for program in ("isphFoam", "checkCase"):
            result = case.run(program, timeout=60)
            self.assertEqual(result.returncode, 1, result.stderr)
            for text in (place, *expected):
                self.assertIn(text, result.stderr, program)
            self.assertEqual(case.state(), before, f"{program} wrote something")

    def test_more_matching_points_than_the_lattice_has(self):
        case = self.ready_box(intervals="(16 16 0)", schemes="continuation\n{\n    type polynomial;\n    points 18;\n}")
        self.refused(case, "points 18", "continuation.points: needs 18 points at each end, but axis x has 17",
                     "take more lattice points in system/latticeDict, or fewer here")

    def test_an_extension_longer_than_allowed(self):
        for extension in ("65", "1.5"):
            case = self.ready_box(intervals="(16 16 0)", schemes=f"continuation\n{{\n    extension {extension};\n}}")
            self.refused(case, "extension", "continuation.extension: is ")

    def test_fewer_points_than_the_stencil_needs(self):
        case = self.ready_box(intervals="(3 16 0)", schemes="continuation\n{\n    degree 4;\n}")
        self.refused(case, "degree 4", "continuation.degree: needs 5 points at each end, but axis x has 4")

    def test_a_kernel_that_reaches_around_the_line(self):
        case = self.ready_box(intervals="(16 16 0)")
        case.put("system/schemes", "kernel { type gaussian; symbol sampled; smoothingLength 6; }\n")
        for program in ("isphFoam", "checkCase"):
            result = case.run(program)
            self.assertEqual(result.returncode, 1)
            self.assertIn("the kernel reaches", result.stderr)

    def test_words_of_periodic_boxes(self):
        for line, reason in (("convection rotational;", "convection: rotational is of periodic boxes"),
                             ("viscous integratingFactor;", "write viscous CrankNicolson;"),
                             ("dealiasing twoThirds;", "dealiasing: acts in periodic boxes only"),
                             ("meanFlow exact;", "meanFlow: exact is of periodic boxes"),
                             ("walls wet;", "known are: consistent, paper")):
            with self.subTest(line):
                self.refused(self.ready_box(schemes=line), line, reason)

    def test_walls_without_points(self):
        case = self.ready_box(arrangement="staggered", schemes="walls consistent;")
        self.refused(case, "walls consistent", "walls: consistent needs points on the walls",
                     "write walls paper; or arrangement collocated; in system/latticeDict")


if __name__ == "__main__":
    import unittest
    unittest.main()
