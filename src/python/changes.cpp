// SPDX-License-Identifier: Apache-2.0
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <memory>
#include <string>

#include "app/deck_changes.hpp"
#include "python/checked_deck.hpp"
#include "python/topics.hpp"

// Changes of a deck's text.
namespace nugget::python {
namespace {

namespace py = pybind11;
using app::DeckChanges;

/// None of a blank field, the text where it is no number.
py::object object_of(const DeckChanges::Value& value) {
  if (value.text.empty() && value.kind != Kind::text) return py::none();
  if (value.kind == Kind::text || !value.readable) return py::str(value.text);
  if (value.kind == Kind::integer) return py::int_(static_cast<long>(value.number));
  return py::float_(value.number);
}

py::dict parameters(const DeckChanges& changes) {
  py::dict out;
  for (const auto& [name, value] : changes.parameters()) out[py::str(name)] = object_of(value);
  return out;
}

}  // namespace

void add_changes(py::module_& module) {
  py::class_<DeckChanges>(module, "DeckChanges")
      .def(py::init([](const CheckedDeck& deck) {
             const py::gil_scoped_release others_may_go_on;
             return std::make_unique<DeckChanges>(deck.arguments, deck.prepared);
           }),
           py::keep_alive<1, 2>())
      .def("cards_of", &DeckChanges::cards_of)
      .def("keyword", [](const DeckChanges& c, std::size_t cards) { return c.cards().at(cards).keyword; })
      .def("place",
           [](const DeckChanges& c, std::size_t cards) {
             const Place& place = c.cards().at(cards).place;
             return py::make_tuple(place.file, place.line);
           })
      .def("fields", &DeckChanges::fields)
      .def("value", [](const DeckChanges& c, std::size_t cards,
                       const std::string& field) { return object_of(c.value(cards, field)); })
      .def("text",
           [](const DeckChanges& c, std::size_t cards, const std::string& field) { return c.value(cards, field).text; })
      .def("set_number", &DeckChanges::set_number)
      .def("set_text", &DeckChanges::set_text)
      .def("parameters", &parameters)
      .def("set_parameter_number", &DeckChanges::set_parameter_number)
      .def("set_parameter_text", &DeckChanges::set_parameter_text)
      .def("remove_weld", &DeckChanges::remove_weld)
      .def("move_weld",
           [](DeckChanges& c, int id, const std::array<double, 3>& x) {
             c.move_weld(id, {x[0], x[1], x[2]});
           })
      .def("move_node",
           [](DeckChanges& c, int id, const std::array<double, 3>& x) {
             c.move_node(id, {x[0], x[1], x[2]});
           })
      .def_property_readonly("empty", &DeckChanges::empty)
      .def("write", [](const DeckChanges& c, const std::string& master) { return c.write(master); });
}

}  // namespace nugget::python
