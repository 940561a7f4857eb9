// SPDX-License-Identifier: Apache-2.0
#include <fmt/ranges.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "app/command.hpp"
#include "app/finding_list.hpp"
#include "app/outcome.hpp"
#include "deck/deck.hpp"
#include "python/arrays.hpp"
#include "python/checked_deck.hpp"
#include "python/topics.hpp"

// A deck, read, tied and audited, as arrays.
namespace nugget::python {
namespace {

using model::Index;
using model::Model;

std::unique_ptr<CheckedDeck> check_deck(const std::string& path, int load_case, const std::string& weld_tie,
                                        const std::string& weld_law, bool skip_unsupported) {
  const py::gil_scoped_release others_may_go_on;
  auto deck = std::make_unique<CheckedDeck>();
  app::RunArguments& arguments = deck->arguments;
  arguments.deck = path;
  arguments.load_case = load_case;
  arguments.weld_tie = weld_tie;
  arguments.weld_law = weld_law;
  arguments.skip_unsupported = skip_unsupported;
  deck->prepared = app::prepare(arguments, deck->findings);
  return deck;
}

/// What the command writes on standard error of the findings.
std::string listing(const CheckedDeck& deck) {
  std::string text = fmt::format("{}", fmt::join(app::list_findings(deck.findings.all()), "\n"));
  if (deck.findings.errors() + deck.findings.warnings() > 0) text += '\n' + totals(deck.findings);
  return text;
}

std::string kind_of(model::ElementKind kind) {
  switch (kind) {
    case model::ElementKind::nothing: return "";
    case model::ElementKind::shell: return "shell";
    case model::ElementKind::solid: return "solid";
    case model::ElementKind::beam: return "beam";
    case model::ElementKind::discrete: return "discrete";
  }
  return "";
}

/// Of the part's section.
struct SectionOf {
  int id = 0, elform = 0;
  double thickness = std::numeric_limits<double>::quiet_NaN();
};
SectionOf section_of(const Model& m, const model::Part& part) {
  if (part.section == model::none) return {};
  const auto i = static_cast<std::size_t>(part.section);
  switch (part.kind) {
    case model::ElementKind::shell:
      return {m.shell_sections[i].id, m.shell_sections[i].elform, m.shell_sections[i].thickness};
    case model::ElementKind::solid: return {m.solid_sections[i].id, m.solid_sections[i].elform};
    case model::ElementKind::beam: return {m.beam_sections[i].id, m.beam_sections[i].elform};
    case model::ElementKind::discrete: return {m.discrete_sections[i].id, 0};
    case model::ElementKind::nothing: return {};
  }
  return {};
}

py::list parts(const CheckedDeck& deck) {
  const Model& m = deck.model();
  py::list out;
  for (const model::Part& part : m.parts) {
    const SectionOf section = section_of(m, part);
    py::dict row;
    row["id"] = part.id;
    row["title"] = part.title;
    row["kind"] = kind_of(part.kind);
    row["section"] = section.id;
    row["elform"] = section.elform;
    row["thickness"] = section.thickness;
    const bool has = part.material != model::none;
    const model::Material none;
    const model::Material& material = has ? m.materials[static_cast<std::size_t>(part.material)] : none;
    row["material"] = material.id;
    row["law"] = material.keyword;
    row["density"] = material.density;
    row["young"] = has ? material.young() : 0.0;
    row["poisson"] = has ? material.poisson() : 0.0;
    out.append(row);
  }
  return out;
}

/// (ids, positions of nodes from 0, ids of parts)
template <std::size_t n, class Table>
py::tuple mesh_elements(const Model& m, const Table& all) {
  return py::make_tuple(
      column<int>(all.size(), [&](std::size_t e) { return all.id[e]; }),
      matrix<int>(all.size(), n, [&](std::size_t e, std::size_t i) { return all.node[e][i]; }),
      column<int>(all.size(), [&](std::size_t e) { return m.parts[static_cast<std::size_t>(all.part[e])].id; }));
}

py::dict keywords(const CheckedDeck& deck) {
  py::dict counts;
  for (const model::KeywordUse& use : deck.model().keyword_uses) counts[py::str('*' + use.keyword)] = use.count;
  return counts;
}

}  // namespace

void add_deck(py::module_& module) {
  module.def("case_numbers", [](const std::string& path) {
    std::vector<int> numbers;
    for (const deck::Case& each : deck::cases(path)) numbers.push_back(each.id);
    return numbers;
  });
  py::class_<CheckedDeck>(module, "CheckedDeck")
      .def(py::init(&check_deck))
      .def_property_readonly("errors", [](const CheckedDeck& d) { return d.findings.errors(); })
      .def_property_readonly("findings", [](const CheckedDeck& d) { return d.findings.all(); })
      .def_property_readonly("listing", &listing)
      .def_property_readonly("title", [](const CheckedDeck& d) { return d.model().title; })
      .def_property_readonly("files", [](const CheckedDeck& d) { return d.prepared.files; })
      .def_property_readonly("units", [](const CheckedDeck& d) { return app::unit_name(d.model()); })
      .def_property_readonly("end_time", [](const CheckedDeck& d) { return d.model().control.end_time; })
      .def_property_readonly("keywords", &keywords)
      .def_property_readonly("parts", &parts)
      .def_property_readonly("welds", [](const CheckedDeck& d) { return output::weld_table(d.prepared.welds); })
      .def_property_readonly("node_ids",
                             [](const CheckedDeck& d) {
                               const std::vector<int>& ids = d.model().nodes.id;
                               return column<int>(ids.size(), [&](std::size_t i) { return ids[i]; });
                             })
      .def_property_readonly("coordinates", [](const CheckedDeck& d) { return vectors(d.model().nodes.x); })
      .def_property_readonly("shells",
                             [](const CheckedDeck& d) { return mesh_elements<4>(d.model(), d.model().shells); })
      .def_property_readonly("shell_thickness",
                             [](const CheckedDeck& d) { return numbers(d.model().shells.thickness); })
      .def_property_readonly("solids",
                             [](const CheckedDeck& d) { return mesh_elements<8>(d.model(), d.model().solids); })
      .def_property_readonly("beams",
                             [](const CheckedDeck& d) { return mesh_elements<2>(d.model(), d.model().beams); });
}

}  // namespace nugget::python
