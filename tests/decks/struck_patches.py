# SPDX-License-Identifier: Apache-2.0
"""What holds of patches of a law that are struck, however they are turned, mirrored, moved, numbered or measured: energies, bytes and
the balance."""
import lsda
from test_invariance import Case, included, oblique


class StruckPatches:
    """Beside RepeatedRuns. `patches`: the deck of a Case."""
    QUANTITIES = ("internal_energy", "kinetic_energy", "eroded_internal_energy")

    def energies(self, name, case, text=None):
        self.nugget("run", self.write(text or self.patches(case), f"{name}.k").name, "-o", name, "-j1", "--quiet")
        states = lsda.states(lsda.read(self.folder / name / "binout0000"), "matsum")
        return [[value / case.energy for state in states for value in state[q]] for q in self.QUANTITIES]

    def compare_energies(self, ours, reference):
        size = max(reference[0])
        for one, two in zip(ours, reference, strict=True):
            for a, b in zip(one, two, strict=True):
                self.assertAlmostEqual(a / size, b / size, delta=1e-7)

    def test_invariance(self):
        """Sabotage: lengths, rates or a viscosity without their unit; axes that turn with the nodes of one side."""
        reference = self.energies("reference", Case())
        cases = (Case(turn=oblique()), Case(turn=((-1, 0, 0), (0, 1, 0), (0, 0, 1)), mirrored=True), Case(shift=(4096.0, -2048.0, 1024.0)),
                 Case(mass=1e-3, length=1e3), Case(mass=1e-6, time=1e-3), Case(first=1234567))
        for number, case in enumerate(cases):
            with self.subTest(number):
                self.compare_energies(self.energies("other", case), reference)

    def test_included(self):
        """Axes turn with *INCLUDE_TRANSFORM and are mirrored by it."""
        self.write(self.patches(Case()), "inner.k")
        reference = self.energies("reference", Case())
        case = Case(turn=oblique(), shift=(64.0, -32.0, 16.0))
        for mirrored in (False, True):
            with self.subTest(mirrored=mirrored):
                self.compare_energies(self.energies("other", case, included(case, mirrored)), reference)

    def test_same_bits_and_restart(self):
        text = self.patches(Case())
        self.compare(self.write(text))
        self.resumed(text, shares=(0.4,))

    def test_energy_closes(self):
        self.nugget("run", self.write(self.patches(Case())), "-o", "run", "--quiet")
        states = self.glstat("run/glstat")
        for state in states:
            self.assertAlmostEqual(state["total energy / initial energy"], 1.0, delta=0.02)
        self.assertGreater(states[-1]["internal energy"], 0.3 * states[0]["kinetic energy"])
