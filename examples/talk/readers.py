# SPDX-License-Identifier: Apache-2.0
"""Reads the results of a run as the studies of the talk need them."""
import csv
import json
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tools"))
import binout  # noqa: E402
from states import states  # noqa: E402, F401


def summary(folder):
    return json.loads((folder / "summary.json").read_text(encoding="utf-8"))


def weld(folder):
    """The row of the only weld in welds.csv."""
    (row,) = csv.DictReader((folder / "welds.csv").read_text(encoding="ascii").splitlines())
    return row


def swforc(folder):
    """[(time, axial, shear, length, moment, torsion)] of the only weld while it holds."""
    rows = []
    for line in (folder / "swforc").read_text(encoding="ascii").splitlines():
        front, found, back = line.partition(" ID ")
        if not found or "failure" in front:
            continue
        _, axial, shear, time = map(float, front.split()[:4])
        rows.append((time, axial, shear, *map(float, back.split()[1:4])))
    return rows


def nodout(folder):
    """{node: [(time, (x, y, z displacement), (about x, y, z))]}"""
    rows, time, turning = {}, 0.0, False
    for line in (folder / "nodout").read_text(encoding="ascii").splitlines():
        if at := re.search(r"at time\s*([-+.\dE]+)", line):
            time = float(at[1])
        elif "nodal point" in line:
            turning = "x-rot" in line
        elif words := re.fullmatch(r"\s*(\d+)((?:\s*[-+]?\d\.\d+E[-+]\d+){9,12})", line):
            values = tuple(map(float, re.findall(r"[-+]?\d\.\d+E[-+]\d+", words[2])))[:3]
            history = rows.setdefault(int(words[1]), [])
            if turning:
                history[-1] = (*history[-1][:2], values)
            else:
                history.append((time, values, (0.0, 0.0, 0.0)))
    return rows


def reactions(folder):
    """{node: (x, y, z)}: the last forces of supports in binout."""
    path = folder / "binout0000"
    history = {name: binout.history(path, "spcforc", f"{name}_force")[-1][1] for name in "xyz"}
    ids = next(v for k, v in binout.variables(path).items() if k.endswith("spcforc/metadata/force_ids"))
    return {n: tuple(history[name][i] for name in "xyz") for i, n in enumerate(ids)}
