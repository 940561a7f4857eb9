# SPDX-License-Identifier: Apache-2.0
"""What report.html gives its viewer: the shapes, fields and welds of the files beside it, within the steps they are packed in."""
import base64
import json
import re
import struct
import unittest
import zlib

import damaged
from lap_joint import deck
from nugget_command import CommandTest

SIZES = {"u8": 1, "u16": 2, "u32": 4, "f32": 4}


def unpacked(page):
    """(about, {name: numbers}) of the packed data in a page, as src/report/packed_arrays.hpp lays them out."""
    plain = zlib.decompress(base64.b64decode(re.search(r'id="run-data">([^<]*)<', page)[1], validate=True))
    length, = struct.unpack("<I", plain[:4])
    head, place, arrays = json.loads(plain[4:4 + length]), 4 + length, {}
    for array in head["arrays"]:
        size, count = SIZES[array["type"]], array["count"]
        planes = plain[place:place + size * count]
        place += size * count
        rows = [bytes(planes[p * count + i] for p in range(size)) for i in range(count)]
        values = [struct.unpack("<f", r)[0] if array["type"] == "f32" else int.from_bytes(r, "little") for r in rows]
        if array["differences"]:
            for i in range(1, count):
                values[i] = (values[i] + values[i - 1]) % 2 ** (8 * size)
        arrays[array["name"]] = values
    assert place == len(plain)
    return head["about"], arrays


class Viewer(CommandTest):
    def packed(self, folder="."):
        page = self.read(f"{folder}/report.html")
        if 'id="run-data"' not in page:
            self.skipTest("this program was built without the viewer: no Node, or no web/node_modules")
        return unpacked(page)

    def run_deck(self):
        self.write(deck())
        self.nugget("run", "model.k", "--quiet")
        return self.packed()

    def coordinates(self, view, steps):
        count = len(steps) // 3
        size = [(high - low) / 65535 for low, high in zip(view["low"], view["high"])]
        return [[view["low"][k] + size[k] * steps[k * count + i] for k in range(3)] for i in range(count)]

    def test_page_carries_the_licences_of_its_libraries(self):
        self.run_deck()
        page = self.read("report.html")
        for line in ("Copyright (c) 2010-2026 three.js authors", "Copyright (c) 2022 Leon Sorokin"):
            self.assertIn(line, page)
        self.assertEqual(page.count("Permission is hereby granted, free of charge"), 2)

    def test_coordinates_are_those_of_d3plot(self):
        about, arrays = self.run_deck()
        view = about["view"]
        states = self.d3plot()["states"]
        self.assertEqual(len(view["times"]), len(states))
        for shown, state in zip(view["times"], states):
            self.assertAlmostEqual(shown, state["time"], delta=1e-6 * max(abs(state["time"]), 1e-30))
        steps = arrays["x"]
        widest = max(high - low for low, high in zip(view["low"], view["high"]))
        for i, state in enumerate(states):
            steps = [(a + b) % 65536 for a, b in zip(steps, arrays[f"dx{i}"])]
            ours = dict(zip(arrays["node_ids"], self.coordinates(view, steps)))
            points = [[a + b for a, b in zip(p, u)] for block in state["blocks"]
                      for p, u in zip(block["points"], block["point_arrays"]["Deflection"])]
            self.assertGreater(len(points), 0)
            for point in points:
                nearest = min(max(abs(a - b) for a, b in zip(point, x)) for x in ours.values())
                self.assertLess(nearest, widest / 65535)

    def test_facets_are_the_shells_of_the_deck(self):
        about, arrays = self.run_deck()
        text = self.read("model.k")
        rows = text.split("*ELEMENT_SHELL\n")[1].split("*")[0].splitlines()
        shells = {int(row[:8]): [int(row[8 * k:8 * k + 8]) for k in range(1, 6)] for row in rows if not row.startswith("$")}
        self.assertEqual(sorted(arrays["facet_elements"]), sorted(shells))
        for f, element in enumerate(arrays["facet_elements"]):
            nodes = [arrays["node_ids"][n] for n in arrays["facet_nodes"][4 * f:4 * f + 4]]
            self.assertEqual(nodes, shells[element][1:])
            self.assertEqual(about["view"]["parts"][arrays["facet_parts"][f]]["id"], shells[element][0])
        self.assertEqual(set(arrays["facet_until"]), {len(about["view"]["times"])})

    def test_fields_are_in_their_range(self):
        """The thickness of the deck's sheets is the range's end that nothing has thinned yet."""
        about, arrays = self.run_deck()
        for number, field in enumerate(about["view"]["fields"]):
            for i in range(len(about["view"]["times"])):
                self.assertEqual(len(arrays[f"field{number}_{i}"]), len(arrays["facet_elements"]))
        names = [field["name"] for field in about["view"]["fields"]]
        self.assertIn("von Mises stress", names)
        stress = arrays[f"field{names.index('von Mises stress')}_0"]
        self.assertEqual(set(stress), {0}, "the model starts without stresses")

    def field(self, about, name):
        return next((field for field in about["view"]["fields"] if field["name"] == name), None)

    def test_damage_is_a_field_where_it_was_recorded(self):
        """D = (p / 0.4)^2 of the deck's own law. Sabotage: the instability in its place; the field where nothing is damaged."""
        for histories, law, there in ((3, True, True), (0, True, False), (3, False, False)):
            with self.subTest(histories=histories, law=law):
                self.write(damaged.sheets(histories, law))
                self.nugget("run", "model.k", "--quiet")
                about, _ = self.packed()
                field = self.field(about, "damage")
                self.assertEqual(field is not None, there)
                if there:
                    strain = self.field(about, "plastic strain")["high"]
                    self.assertGreater(strain, 0.2)
                    lost = max((strain / 0.4) ** 2, ((strain / 0.4) ** 2 - 0.25) / 0.75)
                    self.assertAlmostEqual(field["high"], lost, delta=5e-3)
                    self.assertEqual(field["dimension"], "")

    def test_welds_and_units(self):
        about, _ = self.run_deck()
        table = about["welds"]
        welds = [dict(zip(table["columns"], row)) for row in table["rows"]]
        self.assertEqual([int(w["id"]) for w in welds], [w["id"] for w in self.json("summary.json")["weld"]])
        self.assertEqual(about["units"]["stress"], "MPa")
        self.assertEqual(about["units"]["moment"], "N mm")
        self.assertEqual(about["second"], 1.0)

    def test_without_d3plot_the_page_says_why_there_is_no_view(self):
        self.run_deck()
        for path in self.folder.glob("d3plot*"):
            path.unlink()
        self.nugget("report", ".")
        about, _ = self.packed()
        self.assertIn("No view of the model", about["view"]["note"])
        self.assertIn("no such file", about["view"]["note"])


if __name__ == "__main__":
    unittest.main()
