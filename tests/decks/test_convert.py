# SPDX-License-Identifier: Apache-2.0
"""nugget convert: VTK's own readers see in the .vtu what they see in d3plot; one tidy table has all histories."""
import csv
import unittest

import damaged
from lap_joint import deck
from nugget_command import CommandTest
from test_mode_studies import strips
from test_responses import fields, frf, strip


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

    def test_a_run_writes_them_itself_and_the_next_one_removes_them(self):
        self.run_deck()
        self.nugget("convert", ".", "--to", "vtk", "-o", "vtk")
        self.nugget("run", "model.k", "--vtk", "-o", "run", "--quiet")
        names = sorted(path.name for path in (self.folder / "vtk").iterdir())
        self.assertIn("welds0001.vtu", names)
        for name in names:
            self.assertEqual((self.folder / "run" / name).read_bytes(), (self.folder / "vtk" / name).read_bytes())
        self.nugget("convert", "run", "--to", "csv")
        (self.folder / "run" / "state_of_mine.vtu").write_text("", encoding="utf-8")
        self.nugget("run", "model.k", "-o", "run", "--quiet", "--max-cycles", 2)
        left = {path.name for path in (self.folder / "run").iterdir()}
        self.assertFalse(left & {*names, "histories.csv"})
        self.assertIn("state_of_mine.vtu", left)

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

    def hdf5(self, name="results.h5"):
        try:
            import h5py
        except ImportError:
            self.skipTest("this Python has no h5py")
        file = h5py.File(self.folder / name, "r")
        self.addCleanup(file.close)
        return file

    def test_hdf5_has_what_the_tidy_table_has(self):
        """Every value of histories.csv at its time, entity and unit. Sabotage: columns and rows swapped; an entity off by one."""
        self.write(deck(("*DATABASE_HISTORY_NODE\n       216\n", "*DATABASE_HISTORY_NODE\n       216       113\n")))
        self.nugget("run", "model.k", "--quiet")
        self.nugget("convert", ".", "--to", "csv")
        said = self.nugget("convert", ".", "--to", "hdf5", "-o", "out").stdout
        self.assertIn("glstat, matsum, nodout, swforc, welds", said)
        file = self.hdf5("out/results.h5")
        self.assertEqual(file.attrs["units"], "mm, t, s")
        self.assertEqual(file.attrs["title"], "lap joint of two sheets and one weld")
        times = {name: file[name]["time"][:].tolist() for name in ("glstat", "matsum", "nodout", "swforc")}
        self.assertEqual({file[name]["time"].attrs["unit"] for name in times}, {"s"})
        with open(self.folder / "histories.csv", newline="", encoding="utf-8") as table:
            rows = list(csv.DictReader(table))
        self.assertGreater(len(rows), 500)
        for row in rows:
            values = file[row["file"]][row["quantity"]]
            self.assertEqual(values.attrs["unit"], row["unit"])
            at = times[row["file"]].index(float(row["time"]))
            if row["entity"]:
                entities = [name.decode() for name in file[row["file"]]["entity"][:]]
                self.assertEqual(values[at, entities.index(row["entity"])], float(row["value"]))
            else:
                self.assertEqual(values[at], float(row["value"]))
        self.assertEqual(file["swforc"]["axial"].shape, (len(times["swforc"]), 1))
        self.assertEqual(file["nodout"]["x_displacement"].shape[1], 2)

    def test_hdf5_has_the_welds_with_units(self):
        self.run_deck()
        self.nugget("convert", ".", "--to", "hdf5")
        welds = self.hdf5()["welds"]
        with open(self.folder / "welds.csv", newline="", encoding="utf-8") as table:
            row, = csv.DictReader(table)
        self.assertEqual(set(welds), {name.replace("/", "_") for name in row})
        self.assertEqual(welds["id"][:].tolist(), [int(row["id"])])
        self.assertEqual(welds["peak_shear"][0], float(row["peak_shear"]))
        self.assertEqual((welds["peak_shear"].attrs["unit"], welds["peak_bending"].attrs["unit"]), ("N", "N mm"))
        self.assertEqual(welds["tied"][0].decode(), "yes")
        self.assertTrue(welds["damage"][0] != welds["damage"][0], "an empty cell is not a number")

    def test_hdf5_of_a_response(self):
        self.write(strip(lambda tip: "*CONTROL_IMPLICIT_EIGENVALUE\n" + fields(5) +
                         frf((tip, 0, 3, 3), (0.02,), (tip, 0, 3, 2), (0.0, 300.0, 100)), 20, 2))
        self.nugget("frf", "model.k", "--quiet")
        self.nugget("convert", ".", "--to", "hdf5")
        response, = self.hdf5()["frf"].values()
        with open(self.folder / "frf.csv", newline="", encoding="utf-8") as table:
            rows = list(csv.DictReader(table))
        for name in ("frequency", "amplitude", "phase"):
            self.assertEqual(response[name][:].tolist(), [float(row[name]) for row in rows])
        self.assertEqual(response["frequency"].attrs["unit"], "Hz")
        self.assertEqual(len(self.hdf5()["modes"]["frequency"]), 5)

    def test_hdf5_twice_is_the_same_bytes(self):
        self.run_deck()
        self.nugget("convert", ".", "--to", "hdf5", "-o", "a")
        self.nugget("convert", ".", "--to", "hdf5", "-o", "b")
        self.assertEqual((self.folder / "a" / "results.h5").read_bytes(), (self.folder / "b" / "results.h5").read_bytes())
        self.write("", "full")
        self.assertIn("full", self.nugget("convert", ".", "--to", "hdf5", "-o", "full/x", expect=4).stderr)

    def test_what_cannot_be_converted_is_told(self):
        self.assertIn("holds no results", self.nugget("convert", ".", "--to", "vtk", expect=2).stderr)
        self.run_deck()
        self.assertIn("--to", self.nugget("convert", ".", "--to", "parquet", expect=2).stderr)
        for path in self.folder.iterdir():
            if path.name != "summary.json":
                path.unlink()
        self.assertIn("*DATABASE_BINARY_D3PLOT", self.nugget("convert", ".", "--to", "vtk", expect=2).stderr)
        for form in ("csv", "hdf5"):
            self.assertIn("*DATABASE_GLSTAT", self.nugget("convert", ".", "--to", form, expect=2).stderr)


if __name__ == "__main__":
    unittest.main()
