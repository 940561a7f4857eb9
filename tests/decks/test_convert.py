# SPDX-License-Identifier: Apache-2.0
"""nugget convert: VTK's own readers see in the .vtu what they see in d3plot; one tidy table has all histories."""
import csv
import unittest

import damaged
from lap_joint import deck
from nugget_command import CommandTest
from test_mode_studies import strips


def read_vtu(case, path):
    try:
        from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
    except ImportError:
        case.skipTest("this Python has no vtk")
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def array(data, name):
    values = data.GetArray(name)
    return [values.GetTuple(i) for i in range(values.GetNumberOfTuples())]


class Convert(CommandTest):
    def run_deck(self):
        self.write(deck())
        self.nugget("run", "model.k", "--quiet")

    def test_states_are_those_of_d3plot(self):
        self.run_deck()
        self.nugget("convert", ".", "--to", "vtk", "-o", "vtk")
        states = self.d3plot()["states"]
        collection = self.read("vtk/states.pvd")
        self.assertEqual(collection.count("<DataSet"), len(states))
        for i, state in enumerate(states, 1):
            grid = read_vtu(self, self.folder / "vtk" / f"state{i:04}.vtu")
            self.assertIn(f'file="state{i:04}.vtu"', collection)
            cells = {tuple(grid.GetPoint(grid.GetCell(c).GetPointId(k)) for k in range(grid.GetCell(c).GetNumberOfPoints())): c
                     for c in range(grid.GetNumberOfCells())}
            strain = array(grid.GetCellData(), "plastic_strain")
            seen = 0
            for block in state["blocks"]:
                x = [tuple(p) for p in block["point_arrays"]["Deflected Coordinates"]]
                names = [n for n in block["cell_arrays"] if n.endswith("EffPlastStrn")]
                for c, corners in enumerate(block["cells"]):
                    ours = cells[tuple(x[k] for k in corners)]
                    if names:
                        self.assertEqual(strain[ours][0], max(block["cell_arrays"][n][c][0] for n in names))
                        seen += 1
            self.assertGreater(seen, 0)

    def test_damage_where_it_was_recorded(self):
        for histories in (3, 0):
            self.write(damaged.sheets(histories))
            self.nugget("run", "model.k", "--quiet")
            self.nugget("convert", ".", "--to", "vtk")
            cells = read_vtu(self, self.folder / "state0004.vtu").GetCellData()
            self.assertEqual(cells.HasArray("damage"), int(histories > 0))
            if histories:
                strain, damage = array(cells, "plastic_strain")[0][0], array(cells, "damage")[0][0]
                self.assertAlmostEqual(damage, (strain / 0.4) ** 2, delta=5e-3)

    def test_welds_are_lines_with_their_histories(self):
        self.run_deck()
        self.nugget("convert", ".", "--to", "vtk")
        last = len(self.d3plot()["states"])
        grid = read_vtu(self, self.folder / f"welds{last:04}.vtu")
        weld, = self.json("summary.json")["weld"]
        self.assertEqual(grid.GetNumberOfCells(), 1)
        self.assertEqual(grid.GetCell(0).GetNumberOfPoints(), 2)
        self.assertEqual([int(v[0]) for v in array(grid.GetCellData(), "weld")], [weld["id"]])
        self.assertAlmostEqual(array(grid.GetCellData(), "diameter")[0][0], weld["diameter"], 5)
        rows = [line.split() for line in self.read("swforc").splitlines() if "spotweld beam" in line]
        self.assertAlmostEqual(array(grid.GetCellData(), "shear")[0][0] / float(rows[-1][2]), 1.0, 5)

    def test_modes(self):
        self.write(strips())
        self.nugget("modes", "model.k", "-n", 4, "--quiet")
        self.nugget("convert", ".", "--to", "vtk")
        self.assertEqual(self.read("modes.pvd").count("<DataSet"), 4)
        grid = read_vtu(self, self.folder / "mode0004.vtu")
        self.assertGreater(max(max(map(abs, v)) for v in array(grid.GetPointData(), "shape")), 0.0)

    def test_one_tidy_table_of_all_histories(self):
        self.run_deck()
        self.nugget("convert", ".", "--to", "csv")
        with open(self.folder / "histories.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        energies = [(float(r["time"]), float(r["value"])) for r in rows if (r["file"], r["quantity"]) == ("glstat", "internal_energy")]
        self.assertEqual(energies, [(s["time"], s["internal energy"]) for s in self.glstat()])
        shear = [r for r in rows if r["file"] == "swforc" and r["quantity"] == "shear"]
        self.assertEqual({r["unit"] for r in shear}, {"N"})
        self.assertEqual({r["entity"] for r in shear}, {f"weld {w['id']}" for w in self.json("summary.json")["weld"]})

    def test_what_cannot_be_converted_is_told(self):
        self.assertIn("holds no results", self.nugget("convert", ".", "--to", "vtk", expect=2).stderr)
        self.run_deck()
        self.assertIn("--to", self.nugget("convert", ".", "--to", "hdf5", expect=2).stderr)
        for path in self.folder.iterdir():
            if path.name != "summary.json":
                path.unlink()
        self.assertIn("*DATABASE_BINARY_D3PLOT", self.nugget("convert", ".", "--to", "vtk", expect=2).stderr)
        self.assertIn("*DATABASE_GLSTAT", self.nugget("convert", ".", "--to", "csv", expect=2).stderr)


if __name__ == "__main__":
    unittest.main()
