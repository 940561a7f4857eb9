#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Reads a d3plot family with VTK's vtkLSDynaReader (the reader of ParaView) and prints what it saw as JSON.
Exit code 77: no vtk on this machine."""
import json
import os
import sys
import tempfile

try:
    import vtk
except ImportError:
    sys.exit(77)

KINDS = ["Point", "Beam", "Shell", "Solid", "ThickShell"]


def leaves(data):
    iterator = data.NewIterator()
    iterator.InitTraversal()
    while not iterator.IsDoneWithTraversal():
        yield iterator.GetCurrentMetaData().Get(vtk.vtkCompositeDataSet.NAME()), iterator.GetCurrentDataObject()
        iterator.GoToNextItem()


def rows(array):
    return [list(array.GetTuple(i)) for i in range(array.GetNumberOfTuples())]


def arrays(attributes):
    named = (attributes.GetArray(i) for i in range(attributes.GetNumberOfArrays()))
    return {array.GetName(): rows(array) for array in named if array is not None}


def block(name, grid):
    cells = [[grid.GetCell(c).GetPointId(i) for i in range(grid.GetCell(c).GetNumberOfPoints())]
             for c in range(grid.GetNumberOfCells())]
    return {"name": name, "points": [list(grid.GetPoint(i)) for i in range(grid.GetNumberOfPoints())], "cells": cells,
            "point_arrays": arrays(grid.GetPointData()), "cell_arrays": arrays(grid.GetCellData())}


def main(path):
    log = tempfile.NamedTemporaryFile(delete=False)
    window = vtk.vtkFileOutputWindow()
    window.SetFileName(log.name)
    vtk.vtkOutputWindow.SetInstance(window)

    reader = vtk.vtkLSDynaReader()
    reader.SetFileName(path)
    reader.UpdateInformation()
    reader.SetRemoveDeletedCells(1)
    reader.SetDeletedCellsAsGhostArray(1)
    reader.SetDeformedMesh(0)
    for kind in KINDS:
        for i in range(getattr(reader, f"GetNumberOf{kind}Arrays")()):
            getattr(reader, f"Set{kind}ArrayStatus")(getattr(reader, f"Get{kind}ArrayName")(i), 1)
    states = []
    for step in range(reader.GetNumberOfTimeSteps()):
        reader.SetTimeStep(step)
        reader.UpdateTimeStep(reader.GetTimeValue(step))
        reader.Update()
        states.append({"time": reader.GetTimeValue(step),
                       "blocks": [block(name, grid) for name, grid in leaves(reader.GetOutput())
                                  if grid is not None and grid.GetNumberOfCells()]})
    with open(log.name) as messages:
        complaints = [line for line in messages.read().splitlines() if "rror" in line or "Warn" in line]
    os.unlink(log.name)
    json.dump({"title": (reader.GetTitle() or "").strip(), "nodes": reader.GetNumberOfNodes(),
               "solids": reader.GetNumberOfSolidCells(), "beams": reader.GetNumberOfBeamCells(),
               "shells": reader.GetNumberOfShellCells(), "thick_shells": reader.GetNumberOfThickShellCells(),
               "parts": [reader.GetPartArrayName(i) for i in range(reader.GetNumberOfPartArrays())],
               "states": states, "complaints": complaints}, sys.stdout)


main(sys.argv[1])
