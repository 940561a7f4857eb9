// SPDX-License-Identifier: Apache-2.0
#include <pybind11/pybind11.h>

#include <stdexcept>
#include <string>

#include "base/finding.hpp"
#include "python/topics.hpp"

namespace nugget::python {
namespace {

namespace py = pybind11;

Severity severity_of(const std::string& word) {
  for (const Severity severity : {Severity::note, Severity::warning, Severity::error})
    if (to_string(severity) == word) return severity;
  throw std::invalid_argument("'" + word + "' is no severity, expected note, warning or error");
}

Finding make_finding(std::string file, int line, int column, const std::string& severity, std::string keyword,
                     std::string field, std::string value, std::string text, std::string remedy) {
  return {severity_of(severity), {std::move(file), line, column},
          std::move(keyword),    std::move(field),
          std::move(value),      std::move(text),
          std::move(remedy)};
}

}  // namespace

void add_findings(py::module_& module) {
  py::class_<Finding>(module, "Finding",
                      "One remark on the input. As text it is the line that the command prints: "
                      "`FILE:LINE:COLUMN: severity: KEYWORD field = value: text [remedy]`.")
      .def(py::init(&make_finding), py::kw_only(), py::arg("file"), py::arg("line"), py::arg("column"),
           py::arg("severity"), py::arg("keyword"), py::arg("field"), py::arg("value"), py::arg("text"),
           py::arg("remedy"))
      .def_property_readonly(
          "severity", [](const Finding& f) { return std::string(to_string(f.severity)); }, "note, warning or error")
      .def_property_readonly(
          "file", [](const Finding& f) { return f.place.file; }, "as the deck names it")
      .def_property_readonly(
          "line", [](const Finding& f) { return f.place.line; }, "from 1; 0: the whole file")
      .def_property_readonly(
          "column", [](const Finding& f) { return f.place.column; }, "from 1; 0: the whole line")
      .def_readonly("keyword", &Finding::keyword, "with its star")
      .def_readonly("field", &Finding::field, "the card's own name, lower case")
      .def_readonly("value", &Finding::value, "what stands in the field")
      .def_readonly("text", &Finding::text, "what is wrong and what was expected")
      .def_readonly("remedy", &Finding::remedy, "what to do")
      .def("__str__", [](const Finding& f) { return to_string(f); })
      .def("__repr__", [](const Finding& f) { return "<" + to_string(f) + ">"; });
}

}  // namespace nugget::python
