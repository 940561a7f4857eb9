# SPDX-License-Identifier: Apache-2.0
"""Writes LS-DYNA keyword text in standard columns, each card under a line that names its fields."""
import pathlib
import subprocess
import sys


def field(value, width=10):
    """A value in `width` columns; None is a blank field (the default is taken)."""
    if value is None:
        text = ""
    elif isinstance(value, float):
        text = f"{value:.6g}"
        if not any(c in text for c in ".e"):
            text += ".0"
    else:
        text = str(value)
    if len(text) > width:
        raise ValueError(f"{value!r} does not fit {width} columns")
    return text.rjust(width)


class Deck:
    def __init__(self):
        self.lines = []

    def comment(self, text=""):
        self.lines += [("$ " + line).rstrip() for line in text.splitlines() or [""]]

    def keyword(self, name):
        self.lines.append("*" + name)

    def text(self, line):
        self.lines.append(line)

    def card(self, **fields):
        """One card of 10-column fields; a name that begins with `_` is an unused field."""
        names = ["" if name.startswith("_") else name for name in fields]
        self.lines.append("$#" + "".join(name.rjust(10) for name in names)[2:])
        self.lines.append("".join(field(value) for value in fields.values()).rstrip())

    def ids(self, values):
        """Ids, eight a line."""
        values = list(values)
        for i in range(0, len(values), 8):
            self.lines.append("".join(field(v) for v in values[i : i + 8]))

    def part(self, title, **fields):
        self.keyword("PART")
        self.text(title)
        self.card(**fields)

    def curve(self, lcid, points):
        self.keyword("DEFINE_CURVE")
        self.card(lcid=lcid, sidr=0, sfa=1.0, sfo=1.0)
        self.lines += [field(a, 20) + field(o, 20) for a, o in points]

    def node_set(self, sid, nodes):
        self.keyword("SET_NODE_LIST")
        self.card(sid=sid)
        self.ids(nodes)

    def nodes(self, nodes):
        """{id: (x, y, z)}"""
        self.keyword("NODE")
        self.text("$#   nid               x               y               z")
        self.lines += [f"{n:8d}{x:16.6f}{y:16.6f}{z:16.6f}" for n, (x, y, z) in nodes.items()]

    def shells(self, shells):
        """{id: (part, (n1, n2, n3, n4))}"""
        self.keyword("ELEMENT_SHELL")
        self.text("$#   eid     pid      n1      n2      n3      n4")
        self.lines += [f"{e:8d}{p:8d}" + "".join(f"{n:8d}" for n in c) for e, (p, c) in shells.items()]

    def solids(self, solids):
        """{id: (part, (n1, ..., n8))}"""
        self.keyword("ELEMENT_SOLID")
        self.text("$#   eid     pid")
        for e, (p, c) in solids.items():
            self.lines += [f"{e:8d}{p:8d}", "".join(f"{n:8d}" for n in c)]

    def beams(self, beams):
        """{id: (part, (n1, n2))}; a weld beam needs no third node"""
        self.keyword("ELEMENT_BEAM")
        self.text("$#   eid     pid      n1      n2      n3")
        self.lines += [f"{e:8d}{p:8d}{a:8d}{b:8d}{0:8d}" for e, (p, (a, b)) in beams.items()]

    def tie_welds(self, welds, sid, sheets=(), title="welds to sheets", number=1):
        """Ties the weld beams of part `welds` to the part set `sid`; `sheets` are its parts, where it is not there already."""
        self.keyword("CONTACT_SPOTWELD_ID")
        self.text(f"{number:10d}{title}")
        self.card(surfa=welds, surfb=sid, surfatyp=3, surfbtyp=2)
        self.card(fs=None)
        self.card(sfsa=None)
        if not sheets:
            return
        self.keyword("SET_PART_LIST")
        self.card(sid=sid)
        self.ids(sheets)

    def weld_section(self, secid, diameter):
        """Of weld beams."""
        self.keyword("SECTION_BEAM")
        self.card(secid=secid, elform=9, shrf=1.0, qr=2, cst=1.0)
        self.card(ts1=diameter, ts2=diameter, tt1=0.0, tt2=0.0)

    def write(self, path):
        with open(path, "w", encoding="ascii", newline="\n") as file:
            file.write("\n".join(self.lines + ["*END"]) + "\n")


def main(doc, decks):
    """Of a script whose only argument is a folder: writes the decks that `decks()` gives, {name: deck}, into it."""
    if len(sys.argv) != 2:
        sys.exit(doc)
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    for name, deck in decks().items():
        deck.write(folder / f"{name}.k")


def run(nugget, folder, name, deck):
    """Writes a deck and runs it with one thread, unless its results are there already; their folder. Ends the script where it fails."""
    results = folder / name
    if not (results / "summary.json").exists():
        deck.write(folder / f"{name}.k")
        done = subprocess.run([str(nugget), "run", str(folder / f"{name}.k"), "-o", str(results), "-j1", "--quiet"],
                              capture_output=True, text=True)
        if done.returncode:
            sys.exit(f"{name}: {done.stderr}")
    return results
