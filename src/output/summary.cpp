// SPDX-License-Identifier: Apache-2.0
#include "output/summary.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "output/result_file.hpp"

namespace nugget::output {
namespace {

using Json = nlohmann::ordered_json;

std::string text_of(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

void write_json(const std::filesystem::path& path, const Json& json) {
  write_whole_file(path, text_of(json) + "\n");
}

Json to_json(const WeldProjection& p) {
  return {{"node", p.node},   {"segment", p.segment},  {"xi", p.xi},        {"eta", p.eta},
          {"moved", p.moved}, {"case", p.case_number}, {"reason", p.reason}};
}

Json to_json(const WeldReport& w) {
  Json projections = Json::array();
  for (const WeldProjection& projection : w.projections) projections.push_back(to_json(projection));
  return {{"id", w.id},
          {"kind", w.kind},
          {"part", w.part},
          {"parts", w.sheets},
          {"diameter", w.diameter},
          {"length", w.length},
          {"tied", w.tied},
          {"projection", projections},
          {"added_mass", w.added_mass},
          {"failed", w.failed},
          {"failure_time", w.failure_time ? Json(*w.failure_time) : Json()},
          {"failure_mode", w.failure_mode},
          {"peak",
           {{"axial", w.peak.axial},
            {"shear", w.peak.shear},
            {"bending", w.peak.bending},
            {"torsion", w.peak.torsion},
            {"force", w.peak.force}}},
          {"remarks", w.remarks}};
}

Json to_json(const ModeReport& m) {
  return {{"mode", m.mode},
          {"frequency_hz", m.frequency_hz},
          {"participation", m.participation},
          {"effective_mass", m.effective_mass}};
}

Json to_json(const ResponseReport& r) {
  Json json{{"kind", r.kind},
            {"node", r.node},
            {"direction", r.direction},
            {"response", r.response},
            {"peak", {{"frequency", r.frequency}, {"amplitude", r.amplitude}, {"phase", r.phase}}}};
  if (r.load_case > 0) json["case"] = r.load_case;
  return json;
}

Json to_json(const WeldDropReport& d) {
  Json json{{"welds", d.welds},
            {"mode", d.mode},
            {"frequency_hz", d.frequency},
            {"first_order_hz", d.first_order},
            {"without_hz", d.without}};
  json["solved_hz"] = d.solved ? Json(*d.solved) : Json(nullptr);
  return json;
}

Json to_json(const Summary::Seconds& s) {
  Json phases = Json::object();
  for (const auto& [name, seconds] : s.phases) phases[name] = seconds;
  return {{"read", s.read}, {"setup", s.setup}, {"solve", s.solve}, {"output", s.output}, {"phases", phases}};
}

Json to_json(const Summary::Energies& e) {
  return {{"kinetic", e.kinetic},
          {"internal", e.internal},
          {"hourglass", e.hourglass},
          {"contact", e.contact},
          {"damping", e.damping},
          {"external", e.external},
          {"eroded", e.eroded},
          {"step_change", e.step_change},
          {"initial", e.initial},
          {"ratio", e.ratio},
          {"ratio_without_step_change", e.ratio_without_step_change},
          {"bulk_viscosity", e.bulk_viscosity},
          {"contact_springs", e.contact_springs},
          {"contact_friction", e.contact_friction},
          {"contact_damping", e.contact_damping},
          {"contact_lost", e.contact_lost}};
}

Json to_json(const Summary& s) {
  Json json = {{"version", s.version}, {"deck", s.deck}, {"termination", s.termination}, {"message", s.message}};
  if (s.load_case > 0) json["case"] = s.load_case;
  json["title"] = s.title;
  json["date"] = s.date;
  json["files"] = s.files;
  json["units"] = s.units;
  json["nodes"] = s.count.nodes;
  json["elements"] = {
      {"shell", s.count.shells}, {"solid", s.count.solids}, {"beam", s.count.beams}, {"discrete", s.count.discretes}};
  json["parts"] = s.count.parts;
  json["welds"] = s.count.welds;
  json["cycles"] = s.cycles;
  json["time"] = s.time;
  json["time_step"] = {
      {"first", s.time_step.first}, {"smallest", s.time_step.smallest}, {"controlling", s.time_step.controlling}};
  if (s.relaxation)
    json["relaxation"] = {{"cycles", s.relaxation->cycles},
                          {"time", s.relaxation->time},
                          {"kinetic_energy_ratio", s.relaxation->kinetic_energy_ratio},
                          {"at_rest", s.relaxation->at_rest}};
  json["mass"] = {{"physical", s.mass.physical}, {"added", s.mass.added}, {"added_to_welds", s.mass.added_to_welds}};
  json["energy"] = to_json(s.energy);
  if (s.hourglass)
    json["hourglass"] = {{"part", s.hourglass->part},
                         {"energy", s.hourglass->energy},
                         {"elements", s.hourglass->elements},
                         {"remedy", s.hourglass->remedy}};
  json["seconds"] = to_json(s.seconds);
  json["ns_per_element_cycle"] = s.ns_per_element_cycle;
  json["peak_memory_mb"] = s.peak_memory;
  json["threads"] = s.threads;
  json["lanes"] = s.lanes;
  json["precision"] = s.precision;
  for (const Summary::Period& p : s.periods)
    json["subcycling"].push_back({{"cycles", p.cycles}, {"elements", p.elements}});
  if (s.precision == "single")
    json["elements_by_precision"] = {{"single", s.elements_by_precision.single},
                                     {"double", s.elements_by_precision.of_double}};
  json["ranks"] = s.ranks;
  for (const Summary::Rank& r : s.rank)
    json["rank"].push_back({{"elements", r.elements},
                            {"states", r.states},
                            {"segments", r.segments},
                            {"nodes", r.nodes},
                            {"shared_nodes", r.shared_nodes},
                            {"neighbours", r.neighbours},
                            {"expected_load", r.expected_load},
                            {"expected_contact_load", r.expected_contact_load},
                            {"messages_per_cycle", r.messages},
                            {"bytes_per_cycle", r.bytes},
                            {"busy", r.busy},
                            {"waiting", r.waiting},
                            {"peak_memory_mb", r.peak_memory}});
  json["weld"] = Json::array();  // filled in by write_summary
  json["modes"] = Json::array();
  for (const ModeReport& mode : s.modes) json["modes"].push_back(to_json(mode));
  for (const ResponseReport& r : s.responses) json["responses"].push_back(to_json(r));
  for (const WeldDropReport& drop : s.weld_drops) json["drop_weld"].push_back(to_json(drop));
  return json;
}

/// As an object of a list of the outermost object.
void append_indented(std::string& to, std::string_view text) {
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.size(), text.find('\n', begin));
    to.append(4, ' ');
    to += text.substr(begin, end - begin);
    if (end < text.size()) to += '\n';
    begin = end + 1;
  }
}

}  // namespace

void write_summary(const std::filesystem::path& directory, const Summary& summary) {
  // A car has thousands of welds, whose objects would take more room than any other part of a run's end.
  const std::string text = text_of(to_json(summary)), list = "\n  \"weld\": [";
  const std::size_t inside = text.find(list) + list.size();  // the only such line: in strings it would be escaped
  write_whole_file(directory / "summary.json", [&](ResultFile& file) {
    std::string& buffer = file.buffer();
    buffer.append(text, 0, inside);
    const char* between = "\n";
    for (const WeldReport& weld : summary.welds) {
      buffer += std::exchange(between, ",\n");
      append_indented(buffer, text_of(to_json(weld)));
      if (buffer.size() >= part_of_text) file.commit();
    }
    if (!summary.welds.empty()) buffer += "\n  ";
    buffer.append(text, inside);
    buffer += '\n';
    file.commit();
  });
}

void write_findings(const std::filesystem::path& directory, const std::vector<Finding>& findings) {
  Json list = Json::array();
  for (const Finding& f : findings)
    list.push_back({{"severity", to_string(f.severity)},
                    {"file", f.place.file},
                    {"line", f.place.line},
                    {"column", f.place.column},
                    {"keyword", f.keyword},
                    {"field", f.field},
                    {"value", f.value},
                    {"text", f.text},
                    {"remedy", f.remedy}});
  write_json(directory / "findings.json", list);
}

}  // namespace nugget::output
