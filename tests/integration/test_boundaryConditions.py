"""Boundary conditions that make no flow are refused: file, line, reason and cure; nothing is written."""
import unittest

from cases import CaseTest, run

PATCHES = {"inlet": "xMin", "outlet": "xMax", "floor": "yMin", "lid": "yMax"}
CONDITIONS = {  # a developing channel flow: what is well posed
    "inlet": ("type fixedValue; value expression (\"6*y*(1 - y)\" \"0\" \"0\");", "type zeroGradient;"),
    "outlet": ("type outflow;", "type fixedValue; value uniform 0;"),
    "floor": ("type noSlip;", "type zeroGradient;"),
    "lid": ("type noSlip;", "type zeroGradient;"),
}


class BoundaryConditions(CaseTest):
    def channel(self, types=None, **changed):
        """The channel with some patches changed: (U, p), and their types in the lattice."""
        types = {"inlet": "patch", "outlet": "patch", "floor": "wall", "lid": "wall", **(types or {})}
        conditions = {**CONDITIONS, **changed}
        case = self.case(functions="")
        case.put("system/latticeDict", "origin (0 0 0);\nextent (1 1 0);\nintervals (24 24 0);\npatches\n{\n" + "".join(
            f"    {name} {{ type {types[name]}; {'axis ' + face[0] if types[name] == 'periodic' else 'face ' + face}; }}\n"
            for name, face in PATCHES.items() if not (types[name] == "periodic" and face.endswith("Max"))) + "}\n")
        for field, column, dimensions, value in (("U", 0, "[0 1 -1 0 0 0 0]", "(0 0 0)"), ("p", 1, "[0 2 -2 0 0 0 0]", "0")):
            rows = "".join(f"    {name} {{ {both[column]} }}\n" for name, both in conditions.items() if both)
            case.put(f"0/{field}", f"dimensions {dimensions};\ninternalField uniform {value};\n"
                                   f"boundaryField {{\n{rows}}}\n")
        case.put("system/sampleDict", "lines { centre { start (0.5 0 0); end (0.5 1 0); nPoints 5; } }\nfields (U p);\n")
        self.succeeds(case, "makeLattice")
        return case

    def refused(self, case, where, *expected):
        """Solver and checkCase name the place, file:entry, and all else expected; nothing is written."""
        relative, entry = where
        keys = entry.split(".")
        place = f"{relative}:{case.line_of(relative, keys[0])}: boundaryField"
        place += ": " if keys[0] == "boundaryField" else f".{entry}: "
        before = case.state()
        for program in ("isphFoam", "checkCase"):
            result = case.run(program, timeout=60)
            self.assertEqual(result.returncode, 1, f"{program}: {result.stderr}{result.stdout[-500:]}")
            for part in (place, *expected):
                self.assertIn(part, result.stderr, program)
            self.assertEqual(case.state(), before, f"{program} wrote something")

    def test_a_well_posed_channel_passes(self):
        self.succeeds(self.channel(), "checkCase")

    def test_unknown_words_list_the_known(self):
        case = self.channel(lid=("type noslip;", "type zeroGradeint;"))
        self.refused(case, ("0/U", "lid.type"), "'noslip'", "known are: noSlip", "fixedValue", "symmetry", "outflow",
                     f"0/p:{case.line_of('0/p', 'lid')}: boundaryField.lid.type:", "known are: zeroGradient")

    def test_the_listings_print_the_words(self):
        self.assertIn("noSlip", run("isphFoam", "-listVelocityConditions").stdout)
        self.assertIn("fixedGradient", run("checkCase", "-listPressureConditions").stdout)

    def test_missing_value_and_gradient(self):
        case = self.channel(inlet=("type fixedValue;", "type fixedGradient;"))
        self.refused(case, ("0/U", "inlet.value"), "is missing", "write e.g. value uniform (1 0 0);",
                     "boundaryField.inlet.gradient", "write e.g. gradient uniform 0;")

    def test_missing_patch(self):
        self.refused(self.channel(lid=None), ("0/U", "boundaryField"), "patch lid has no boundary condition",
                     "write lid { type ...; }")

    def test_misspelt_key(self):
        self.refused(self.channel(inlet=("type fixedValue; valeu uniform (1 0 0);", "type zeroGradient;")),
                     ("0/U", "inlet.valeu"), "did you mean 'value'?")

    def test_periodic_where_the_lattice_is_not(self):
        self.refused(self.channel(lid=("type periodic;", "type periodic;")), ("0/U", "lid.type"),
                     "is periodic but patch lid is not", "system/latticeDict", "0/p")

    def test_other_than_periodic_where_the_lattice_is(self):
        case = self.channel(types={"inlet": "periodic", "outlet": "periodic"}, outlet=None)
        self.refused(case, ("0/U", "inlet.type"), "patch inlet is periodic", "write type periodic;")

    def test_velocity_and_pressure_both_prescribed(self):
        for U in ("type noSlip;", "type slip;", "type symmetry;", "type fixedValue; value uniform (1 0 0);"):
            with self.subTest(U):
                self.refused(self.channel(lid=(U, "type fixedValue; value uniform 0;")), ("0/p", "lid.type"),
                             "velocity and pressure cannot both be prescribed", "write type zeroGradient;")

    def test_an_outlet_needs_a_pressure(self):
        for p in ("type zeroGradient;", "type fixedGradient; gradient uniform 0;"):
            with self.subTest(p):
                self.refused(self.channel(outlet=("type outflow;", p)), ("0/p", "outlet.type"),
                             "nothing holds the pressure", "write type fixedValue; value uniform 0;")

    def test_a_wall_lets_nothing_out(self):
        self.refused(self.channel(types={"outlet": "wall"}), ("0/U", "outlet.type"), "patch outlet is a wall",
                     "write type patch; for it in system/latticeDict")

    def test_net_inflow_without_an_outlet(self):
        self.refused(self.channel(outlet=("type fixedValue; value uniform (0.5 0 0);", "type zeroGradient;")),
                     ("0/U", "boundaryField"), "prescribes 1 m2/s of inflow but 0.5 m2/s of outflow",
                     "make a patch an outlet")

    def test_contradictory_corners(self):
        case = self.channel(inlet=("type fixedValue; value uniform (1 0 0);", "type zeroGradient;"),
                            lid=("type fixedValue; value uniform (2 0 0);", "type zeroGradient;"))
        self.refused(case, ("0/U", "inlet.value"), "contradicts patch lid at their common point (0 1 0)",
                     "(1 0 0) here, (2 0 0) m/s there", "must agree or all but one vanish")

    def test_values_that_are_not_finite(self):
        case = self.channel(lid=("type fixedValue; value expression (\"1/(x - 0.5)\" \"0\" \"0\");", "type zeroGradient;"))
        self.refused(case, ("0/U", "lid.value"), "is infinite at (0.5 1 0)")

    def test_values_that_are_not_finite_later(self):
        case = self.channel(lid=("type fixedValue; value expression (\"0.1*x/(0.1 - t)\" \"0\" \"0\");", "type zeroGradient;"))
        result = case.run("isphFoam")
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertIn(f"0/U:{case.line_of('0/U', 'lid')}: boundaryField.lid.value: ", result.stderr)
        self.assertIn(", t = 0.1", result.stderr)
        self.assertEqual(case.times(), ["0", "0.05"])

    def test_unknown_names_in_expressions(self):
        case = self.channel(lid=("type fixedValue; value expression (\"Umax*x\" \"0\" \"0\");", "type zeroGradient;"))
        self.refused(case, ("0/U", "lid.value"), "Umax")

    def test_a_component_along_an_axis_left_out(self):
        case = self.channel(inlet=("type fixedValue; value uniform (1 0 1);", "type zeroGradient;"))
        self.refused(case, ("0/U", "inlet.value"), "has a component along z")

    def test_missing_table(self):
        case = self.channel(inlet=("type fixedValue; value table \"profile.csv\";", "type zeroGradient;"))
        self.refused(case, ("0/U", "inlet.value"), "profile.csv")

    def test_slips_in_both_fields_are_told_at_once(self):
        case = self.channel(inlet=("type inlet;", "type fixedValue;"), lid=("type wall;", "type zeroGradient;"))
        self.refused(case, ("0/U", "inlet.type"), "boundaryField.lid.type: 'wall'", "boundaryField.inlet.value")


if __name__ == "__main__":
    unittest.main()
