// SPDX-License-Identifier: Apache-2.0
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <string>
#include <string_view>
#include <vector>

#include "base/sae_filter.hpp"
#include "model/units.hpp"
#include "output/d3plot_reader.hpp"
#include "output/history_reader.hpp"
#include "python/arrays.hpp"
#include "python/topics.hpp"

// Results of a folder: histories, states of d3plot, shapes of d3eigv.
namespace nugget::python {
namespace {

using output::D3plotGeometry;
using output::D3plotReader;
using output::D3plotState;

/// (times, [(entity, title, quantity, unit, values)]); None where the folder has no such history.
py::object read_history(const std::string& directory, const std::string& file, const std::string& unit_names) {
  const std::string_view name = file;
  const std::vector<output::HistoryRecord> found = output::read_histories(directory, {&name, 1});
  if (found.empty()) return py::none();
  const auto units = model::units_named(unit_names);
  py::list channels;
  for (const output::Channel& c : found[0].channels)
    channels.append(py::make_tuple(c.entity, c.title, c.quantity,
                                   units ? model::symbol(*units, c.dimension) : std::string(), numbers(c.values)));
  return py::make_tuple(numbers(found[0].times), channels);
}

std::vector<std::string> histories_in(const std::string& directory) {
  std::vector<std::string> names;
  for (const output::HistoryRecord& record : output::read_histories(directory)) names.push_back(record.file);
  return names;
}

/// (ids, positions of nodes from 0, ids of parts)
template <std::size_t n>
py::tuple elements(const D3plotGeometry& g, const std::vector<output::D3plotElement<n>>& all) {
  return py::make_tuple(
      column<int>(all.size(), [&](std::size_t e) { return all[e].id; }),
      matrix<int>(all.size(), n, [&](std::size_t e, std::size_t i) { return all[e].nodes[i]; }),
      column<int>(all.size(), [&](std::size_t e) { return g.parts[static_cast<std::size_t>(all[e].part)].id; }));
}

py::dict geometry(const D3plotReader& reader) {
  const D3plotGeometry& g = reader.geometry();
  py::dict parts;
  for (const output::D3plotPart& part : g.parts) parts[py::int_(part.id)] = part.title;
  py::dict out;
  out["title"] = g.title;
  out["times"] = numbers(reader.times());
  out["node_ids"] = column<int>(g.node_ids.size(), [&](std::size_t i) { return g.node_ids[i]; });
  out["coordinates"] = vectors(g.x);
  out["parts"] = parts;
  out["shells"] = elements(g, g.shells);
  out["solids"] = elements(g, g.solids);
  out["beams"] = elements(g, g.beams);
  return out;
}

py::array_t<bool> deleted(const std::vector<char>& alive, std::size_t count) {
  return column<bool>(count, [&](std::size_t e) { return !alive.empty() && alive[e] == 0; });
}

/// A column of each member, by its name.
template <class Record>
void put_columns(py::dict& out, const std::vector<Record>& records,
                 std::initializer_list<std::pair<const char*, double Record::*>> members) {
  for (const auto& [name, member] : members)
    out[name] = column<double>(records.size(), [&, from = member](std::size_t e) { return records[e].*from; });
}

py::dict shells_of(const D3plotGeometry& g, const D3plotState& s) {
  const auto layers = static_cast<std::size_t>(g.layers);
  py::array_t<double> stress({g.shells.size(), layers, std::size_t{6}});
  auto entry = stress.mutable_unchecked<3>();
  for (py::ssize_t e = 0; e < entry.shape(0); ++e)
    for (py::ssize_t l = 0; l < entry.shape(1); ++l)
      for (py::ssize_t c = 0; c < 6; ++c)
        entry(e, l, c) =
            s.shell_layers[static_cast<std::size_t>(e * entry.shape(1) + l)].stress[static_cast<std::size_t>(c)];
  py::dict out;
  out["deleted"] = deleted(s.shell_alive, g.shells.size());
  out["stress"] = stress;
  out["plastic_strain"] = matrix<double>(g.shells.size(), layers, [&](std::size_t e, std::size_t l) {
    return s.shell_layers[e * layers + l].plastic_strain;
  });
  using Shell = output::ShellRecord;
  put_columns<Shell>(out, s.shells,
                     {{"thickness", &Shell::thickness},
                      {"internal_energy", &Shell::internal_energy},
                      {"mx", &Shell::mx},
                      {"my", &Shell::my},
                      {"mxy", &Shell::mxy},
                      {"qx", &Shell::qx},
                      {"qy", &Shell::qy},
                      {"nx", &Shell::nx},
                      {"ny", &Shell::ny},
                      {"nxy", &Shell::nxy}});
  return out;
}

py::dict solids_of(const D3plotGeometry& g, const D3plotState& s) {
  py::dict out;
  out["deleted"] = deleted(s.solid_alive, g.solids.size());
  out["stress"] =
      matrix<double>(s.solids.size(), 6, [&](std::size_t e, std::size_t c) { return s.solids[e].stress[c]; });
  out["plastic_strain"] = column<double>(s.solids.size(), [&](std::size_t e) { return s.solids[e].plastic_strain; });
  return out;
}

py::dict beams_of(const D3plotGeometry& g, const D3plotState& s) {
  py::dict out;
  out["deleted"] = deleted(s.beam_alive, g.beams.size());
  using Beam = output::BeamRecord;
  put_columns<Beam>(out, s.beams,
                    {{"axial", &Beam::axial},
                     {"shear_s", &Beam::shear_s},
                     {"shear_t", &Beam::shear_t},
                     {"moment_s", &Beam::moment_s},
                     {"moment_t", &Beam::moment_t},
                     {"torsion", &Beam::torsion}});
  return out;
}

py::dict state(const D3plotReader& reader, std::size_t number) {
  if (number >= reader.times().size()) throw py::index_error("there is no such state");
  const D3plotGeometry& g = reader.geometry();
  const D3plotState s = [&] {
    const py::gil_scoped_release others_may_go_on;
    return reader.read(number);
  }();
  py::dict out;
  out["time"] = s.time;
  out["coordinates"] = vectors(s.x);
  out["velocity"] = vectors(s.v);
  out["acceleration"] = vectors(s.a);
  const bool modes = g.family == D3plotGeometry::Family::d3eigv;
  if (modes) return out;
  out["shells"] = shells_of(g, s);
  out["solids"] = solids_of(g, s);
  out["beams"] = beams_of(g, s);
  return out;
}

py::tuple sae_filter(const std::vector<double>& times, const std::vector<double>& values, int cfc, double second,
                     double before) {
  const TimeHistory filtered = sae_filtered(times, values, cfc, second, before);
  return py::make_tuple(numbers(filtered.times), numbers(filtered.values));
}

/// One second in the unit of time of these units; None where they are not known.
py::object second_in(const std::string& unit_names) {
  const auto units = model::units_named(unit_names);
  return units ? py::object(py::float_(1e6 * units->microsecond)) : py::none();
}

}  // namespace

void add_results(py::module_& module) {
  module.def("histories_in", &histories_in);
  module.def("read_history", &read_history);
  module.def("second_in", &second_in);
  module.attr("channel_classes") =
      py::make_tuple(channel_classes[0], channel_classes[1], channel_classes[2], channel_classes[3]);
  module.def("sae_filter", &sae_filter);
  py::class_<D3plotReader>(module, "D3plot")
      .def(py::init([](const std::string& directory, bool modes) {
        return D3plotReader(directory, modes ? D3plotGeometry::Family::d3eigv : D3plotGeometry::Family::d3plot);
      }))
      .def("geometry", &geometry)
      .def("state", &state);
}

}  // namespace nugget::python
