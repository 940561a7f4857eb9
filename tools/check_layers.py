# SPDX-License-Identifier: Apache-2.0
"""Checks who includes whom, and draws the house.

    python3 tools/check_layers.py [ROOT]       prints `file:line: what is wrong` for each breach, exits with 1 if there is one
    python3 tools/check_layers.py --draw [ROOT]   puts the picture of today into CONTRIBUTING.md

A folder of src/ (a room) includes only the rooms below it; a folder inside a room only those that stand before it there.
CMakeLists.txt links the rooms in the same way, and CONTRIBUTING.md shows the picture that this table gives.
"""
import pathlib
import re
import sys

# Each room: what is in it, the rooms it stands on (and on all that those stand on), and its inner folders in their order.
# Files that lie directly in a room with inner folders put these together: they may include all of them, and no inner
# folder includes them.
HOUSE = {
    "base": ("vectors, curves, findings, threads, archives", [], []),
    "deck": ("the text: cards, fields, includes, parameters", ["base"], []),
    "kernel": ("the physics of one element, point or pair: pure functions", ["base"], ["law", "element", "contact"]),
    "model": ("plain data: what is to be computed, without a deck", ["kernel"], []),
    "reading": ("a deck becomes a model: card tables, checks", ["deck", "model"],
                ["builder", "sets", "bodies", "cards", "mesh", "checks"]),
    "weld": ("what a weld is: ties, failure, audit, placement, coupons", ["deck", "model"],
             ["tie", "failure", "audit", "placement", "coupon"]),
    "system": ("the model ready to compute: nodes, element groups, constraints", ["weld"], []),
    "contact": ("contacts, glue and walls as they run", ["system"], []),
    "output": ("file formats: d3plot, binout, ASCII histories", ["system"], []),
    "impact": ("explicit dynamics", ["contact", "output"],
               ["energy", "conditions", "connections", "contact", "simulation", "recording"]),
    "nvh": ("modes, frequency response, linear statics", ["output"], ["matrices", "eigen", "response", "statics"]),
    "report": ("report.html", ["impact", "nvh"], []),
    "app": ("the command nugget", ["report", "reading"], []),
    "python": ("import nugget", ["app"], []),
}

# A kernel is a pure function of one element or point: it does no input or output and starts no threads.
NOT_IN_KERNEL = {"iostream", "fstream", "ostream", "istream", "cstdio", "stdio.h", "filesystem", "thread", "mutex", "mpi.h"}

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')
BEGIN, END = "<!-- house: begin (tools/check_layers.py --draw) -->\n", "<!-- house: end -->"


def below(room):
    """All rooms that `room` may include besides itself."""
    found = set()
    for other in HOUSE[room][1]:
        found |= {other} | below(other)
    return found


def floor(room):
    return 1 + max((floor(other) for other in HOUSE[room][1]), default=-1)


def breaches(root):
    """All breaches under root/src, as `file:line: text`."""
    found = []
    src = root / "src"
    for path in sorted(src.rglob("*")):
        if path.suffix not in (".cpp", ".hpp", ".h", ".inl"):
            continue
        place = path.relative_to(root).as_posix()
        room, *folders = path.relative_to(src).parts[:-1]
        if room not in HOUSE:
            found.append(f"{place}:1: src/{room} has no place among the layers; give it one in tools/check_layers.py")
            continue
        inside = folders[0] if folders else None
        if HOUSE[room][2] and inside and inside not in HOUSE[room][2]:
            found.append(f"{place}:1: src/{room}/{inside} has no place in {room}; give it one in tools/check_layers.py")
            continue
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), start=1):
            match = INCLUDE.match(line)
            if match:
                text = fault(room, inside, match.group(1) == '"', match.group(2))
                if text:
                    found.append(f"{place}:{number}: {text}")
    return found


def fault(room, inside, quoted, name):
    """What is wrong with `#include "name"` (or <name>) in a file of src/room/inside; None where nothing is."""
    target, *rest = name.split("/")
    if rest and target in HOUSE:
        if target != room and target not in below(room):
            return f'{room} may not include "{name}": {target} does not stand below {room}'
        order = HOUSE[room][2]
        if target == room and inside in order and rest[0] != inside:
            if rest[0] not in order:
                return f'{room}/{inside} may not include "{name}": that file puts the inner folders together'
            if order.index(rest[0]) > order.index(inside):
                return f'{room}/{inside} may not include "{name}": {rest[0]} stands behind {inside}'
    elif quoted:
        return f'"{name}": own headers are included from src/, as "folder/file.hpp"'
    elif room == "kernel" and name in NOT_IN_KERNEL:
        return f"kernel may not include <{name}>: kernels are pure functions"
    return None


def links(root):
    """Rooms that CMakeLists.txt links otherwise than they stand."""
    path = root / "CMakeLists.txt"
    if not path.exists():
        return []
    found = []
    text = path.read_text(encoding="utf-8")
    for match in re.finditer(r"^nugget_room\((\w+)([^)]*)\)", text, re.M):
        room, linked = match[1], set(re.findall(r"\bnugget_(\w+)", match[2]))
        number = text.count("\n", 0, match.start()) + 1
        if room not in HOUSE:
            found.append(f"CMakeLists.txt:{number}: {room} has no place among the layers; give it one in tools/check_layers.py")
        elif linked != set(HOUSE[room][1]):
            stands = " ".join(f"nugget_{other}" for other in HOUSE[room][1])
            found.append(f"CMakeLists.txt:{number}: {room} is linked otherwise than it stands; expected: {stands}")
    return found


def picture():
    """The house, the top floor first; a room includes the rooms that it names after `on` and all that those stand on."""
    lines = ["```"]
    for level in range(max(map(floor, HOUSE)), -1, -1):
        for room in (r for r in HOUSE if floor(r) == level):
            what, on, inside = HOUSE[room]
            stands = f"   on {', '.join(on)}" if on else ""
            lines.append(f"{level}  {room:<8} {what}{stands}")
            if inside:
                lines.append(f"   {'':<8} inside, in this order: {' < '.join(inside)}")
    return "\n".join(lines + ["```", ""])


def drawn(text):
    """The text with today's picture between its marks."""
    head, rest = text.split(BEGIN)
    return head + BEGIN + picture() + END + rest.split(END, 1)[1]


def main():
    arguments = [a for a in sys.argv[1:] if a != "--draw"]
    root = pathlib.Path(arguments[0] if arguments else pathlib.Path(__file__).parent.parent)
    guide = root / "CONTRIBUTING.md"
    if "--draw" in sys.argv:
        guide.write_text(drawn(guide.read_text(encoding="utf-8")), encoding="utf-8")
        return 0
    found = breaches(root) + links(root)
    if guide.exists() and drawn(guide.read_text(encoding="utf-8")) != guide.read_text(encoding="utf-8"):
        found.append("CONTRIBUTING.md:1: the picture of the house is not that of today; run tools/check_layers.py --draw")
    for line in found:
        print(line)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
