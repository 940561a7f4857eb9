// SPDX-License-Identifier: Apache-2.0
#include <pybind11/pybind11.h>

#include "python/topics.hpp"

PYBIND11_MODULE(_nugget, module) {
  module.doc() = "The compiled half of nugget: what it holds is shown by the package.";
  module.attr("version") = NUGGET_VERSION;
  nugget::python::add_findings(module);
  nugget::python::add_deck(module);
  nugget::python::add_pictures(module);
  nugget::python::add_changes(module);
  nugget::python::add_run(module);
  nugget::python::add_results(module);
}
