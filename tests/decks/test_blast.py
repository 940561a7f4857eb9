# SPDX-License-Identifier: Apache-2.0
"""Plates under a charge (*LOAD_BLAST_ENHANCED): the same bytes with any number of threads, lanes and ranks and across a restart; energy;
what is refused."""
import subprocess
import unittest

from few_elements import card, nodes, part
from repeated_runs import RepeatedRuns
from under_mpirun import ENVIRONMENT, MPIRUN, mpirun

STEEL = "*MAT_PIECEWISE_LINEAR_PLASTICITY\n" + card(1, 7.85e-9, 2.1e5, 0.3, 250.0, 1000.0, 0.3) + card(40.0, 5.0) + card(0.0) + card(0.0)


def plate(n=10, *, mass=1.0e-3, height=300.0, charge="", units=7, blast=2, more=""):
    """A plate of 500 mm and 2 mm, held at its rim, below 1 kg of TNT; mm, t, s."""
    size = 500.0 / n
    number = lambda i, j: 1 + i + (n + 1) * j  # noqa: E731
    places = [(size * i, size * j, 0.0) for j in range(n + 1) for i in range(n + 1)]
    quads = [(number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)) for j in range(n) for i in range(n)]
    rim = [number(i, j) for j in range(n + 1) for i in range(n + 1) if i in (0, n) or j in (0, n)]
    end = 6.0e-4
    text = "*KEYWORD\n*CONTROL_TERMINATION\n" + card(end) + "*CONTROL_ENERGY\n" + card(2, 2, 2, 2)
    text += "".join(f"*DATABASE_{name}\n" + card(f"{end / 20:g}", 3) for name in ("GLSTAT", "MATSUM", "NODOUT"))
    text += "*DATABASE_BINARY_D3PLOT\n" + card(f"{end / 4:g}") + "*DATABASE_HISTORY_NODE\n" + card(number(n // 2, n // 2))
    text += STEEL + "*SECTION_SHELL\n" + card(1, 16, 0.8333, 3) + card(2.0, 2.0, 2.0, 2.0) + part(1)
    text += "*SET_NODE_LIST\n" + card(1) + "".join(card(*rim[k:k + 8]) for k in range(0, len(rim), 8)) + "*BOUNDARY_SPC_SET\n" + card(1, 0, 1, 1, 1, 1, 1, 1)
    text += "*SET_SEGMENT\n" + card(5) + "".join(card(*q) for q in quads[:-1])
    text += charge or "*LOAD_BLAST_ENHANCED\n" + card(3, mass, 250.0, 250.0, height, -1.0e-5, units, blast) + card("", "", "", "", "", "", 0)
    text += "*LOAD_BLAST_SEGMENT_SET\n" + card(3, 5) + "*LOAD_BLAST_SEGMENT\n" + card(3, *quads[-1])
    text += more + nodes(places) + "*ELEMENT_SHELL\n" + "".join(f"{e:8}{1:8}" + "".join(f"{i:8}" for i in q) + "\n" for e, q in enumerate(quads, 1))
    return text + "*END\n"


class Blast(RepeatedRuns):
    def test_same_bits_and_restart(self):
        self.write(plate())
        self.compare("model.k")
        self.resumed(plate(), shares=(0.2, 0.7))

    @unittest.skipUnless(MPIRUN, "mpirun is not installed")
    def test_same_bits_over_ranks(self):
        self.write(plate())
        self.nugget("run", "model.k", "-o", "one", "-j", 1, "--quiet")
        run = subprocess.run(mpirun(2, "run", "model.k", "-o", "two", "-j", 1, "--quiet"), capture_output=True, text=True, timeout=200,
                             cwd=self.folder, env=ENVIRONMENT)
        self.assertEqual(run.returncode, 0, run.stderr + run.stdout)
        self.assertEqual(self.bits("one"), self.bits("two"))

    def test_energy_closes(self):
        self.write(plate())
        self.nugget("run", "model.k", "-o", "run", "--quiet")
        last = self.glstat("run/glstat")[-1]
        self.assertGreater(last["external work"], 0.0)
        self.assertAlmostEqual(last["total energy"], last["external work"], delta=0.01 * last["external work"])

    def test_what_is_refused(self):
        head = "*LOAD_BLAST_ENHANCED\n"
        for words, changes in (
                ("Mach stem", {"blast": 4}), ("moving charges", {"blast": 3}), ("UNIT 5 needs CFM", {"units": 5}),
                ("nearer to the charge than there are data", {"height": 10.0}),
                ("charge 3 is not defined", {"charge": head + card(4, 1.0e-3, 0.0, 0.0, 900.0, 0.0, 7, 2) + card("")}),
                ("defined twice", {"more": head + card(3, 1.0e-3, 0.0, 0.0, 900.0, 0.0, 7, 2) + card("")}),
                ("this form of blast loads is not built", {"more": "*LOAD_BLAST\n" + card(1.0) + card("")})):
            with self.subTest(words):
                self.write(plate(4, **changes))
                run = self.nugget("check", "model.k", expect=1)
                self.assertIn(words, run.stdout + run.stderr)

    def test_other_units_of_an_included_file(self):
        """Found by running every deck in other units: UNIT then says what the numbers no longer are. Sabotage: only lengths looked at."""
        (self.folder / "plate.inc").write_text(plate(4).replace("*END\n", ""))
        for factors in ((1000, 1, 1), (1, 1000, 1), (1, 1, 0.001)):
            self.write("*KEYWORD\n*INCLUDE_TRANSFORM\nplate.inc\n" + card(0) + card(0) + card(*factors) + card(0) + "*END\n")
            told = self.nugget("check", "model.k", expect=1).stderr
            self.assertIn("*LOAD_BLAST_ENHANCED unit = 7: the unit factors of *INCLUDE_TRANSFORM make other units of it", told)

    def test_what_is_doubtful_is_a_warning(self):
        for words, changes in (("look away from the charge", {"height": -300.0}), ("further from the charge than 40", {"height": 50000.0})):
            with self.subTest(words):
                self.write(plate(4, **changes))
                run = self.nugget("check", "model.k")
                self.assertIn(words, run.stdout + run.stderr)


if __name__ == "__main__":
    unittest.main()
