// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

// What the compiled half of the module is made of, a function for each topic; the half in Python (src/python/nugget)
// gives it the shape that users see.
namespace nugget::python {

void add_findings(pybind11::module_& module);
void add_deck(pybind11::module_& module);
void add_pictures(pybind11::module_& module);
void add_changes(pybind11::module_& module);
void add_run(pybind11::module_& module);
void add_results(pybind11::module_& module);

}  // namespace nugget::python
