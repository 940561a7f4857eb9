// SPDX-License-Identifier: Apache-2.0
#include "app/run_log.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <map>
#include <numbers>
#include <utility>

#include "app/finding_list.hpp"
#include "base/parallel.hpp"
#include "model/units.hpp"
#include "output/history.hpp"
#include "system/followers.hpp"
#include "system/share.hpp"
#include "weld/failure/function.hpp"
#include "weld/tie/tie_findings.hpp"
#include "weld/tie/touching.hpp"

namespace nugget::app {
namespace {

const char* case_name(int projection_case) {
  switch (projection_case) {
    case 0: return "no projection needed";
    case 1: return "over the interior of an element";
    case 2: return "on an element's edge";
    case 3: return "on a corner node";
    case 4: return "sheets penetrate each other";
    case 5: return "no segment in reach";
    case 6: return "another segment was the closest";
    case 7: return "sheets cross";
    case 8: return "sheets cross, normals outward";
  }
  return "";
}

std::string section_name(const model::Model& model, const model::Part& part, const std::optional<model::Units>& units) {
  const std::string length = model::unit_of(units, dimension::length);
  if (part.kind != model::ElementKind::nothing && part.section == model::none) return "none";
  switch (part.kind) {
    case model::ElementKind::shell: {
      const model::SectionShell& s = model.shell_sections[part.section];
      return fmt::format("shell, ELFORM {}, {} layers, t = {:.4g}{}", s.elform, s.layers, s.thickness, length);
    }
    case model::ElementKind::solid: {
      const model::SectionSolid& s = model.solid_sections[part.section];
      if (s.thickness) return fmt::format("thick shell, ELFORM {}, {} layers", s.elform, s.thickness->layers);
      return fmt::format("solid, ELFORM {}", s.elform);
    }
    case model::ElementKind::beam: {
      const model::SectionBeam& s = model.beam_sections[part.section];
      if (s.elform == 6)
        return fmt::format("discrete beam, ELFORM 6, VOL = {:.4g}{}, SCOOR = {}", s.volume,
                           model::unit_of(units, dimension::volume), s.scoor);
      if (s.area > 0.0)
        return fmt::format("beam, ELFORM {}, A = {:.4g}{}", s.elform, s.area, model::unit_of(units, dimension::area));
      return fmt::format("beam, ELFORM {}, d = {:.4g}{}", s.elform, 0.5 * (s.outer[0] + s.outer[1]), length);
    }
    case model::ElementKind::discrete: {
      const model::SectionDiscrete& s = model.discrete_sections[part.section];
      return s.torsional ? "spring or damper, torsional" : "spring or damper";
    }
    case model::ElementKind::nothing: break;
  }
  return "no elements";
}

/// Of the section, where it has a number: `ELFORM 2, `.
std::string formulation(const model::Model& model, const model::Part& part) {
  if (part.section == model::none) return {};
  switch (part.kind) {
    case model::ElementKind::shell: return fmt::format("ELFORM {}, ", model.shell_sections[part.section].elform);
    case model::ElementKind::solid: return fmt::format("ELFORM {}, ", model.solid_sections[part.section].elform);
    case model::ElementKind::beam: return fmt::format("ELFORM {}, ", model.beam_sections[part.section].elform);
    case model::ElementKind::discrete:
    case model::ElementKind::nothing: break;
  }
  return {};
}

std::string elements_name(const system::System& system, const system::ElementGroup& group) {
  if (group.kind == model::ElementKind::shell && group.nodes_per_element == 3) return "triangles";
  if (group.kind == model::ElementKind::solid && group.nodes_per_element == 8) return "bricks";
  if (group.kind == model::ElementKind::solid && group.nodes_per_element == 6) return "wedges";
  return std::string(system.kind_name(group)) + 's';
}

/// Which bricks each assembly, and each weld that took the place of a beam, is made of.
std::string log_bricks(const model::Model& model, const weld::Ties& ties) {
  std::string s;
  for (const weld::Weld& w : ties.welds) {
    if (!w.of_bricks() || (w.elements.size() == 1 && w.id == model.solids.id[w.element])) continue;
    s += fmt::format(" weld {:>8} of part {:>8}, A = {:.5g}{}:", w.id, model.parts[w.part].id,
                     0.25 * std::numbers::pi * w.diameter * w.diameter,
                     model::unit_of(model::units_of(model), dimension::area));
    for (model::Index e : w.elements) s += fmt::format(" {}", model.solids.id[e]);
    s += '\n';
  }
  return s.empty() ? s : "\nWelds of bricks, and their bricks:\n" + s;
}

/// PRTFLG of *CONTROL_SPOTWELD_BEAM.
std::string log_shell_factors(const model::Model& model, const weld::Ties& ties) {
  if (!model.control.weld_beams.list) return {};
  std::string s =
      "\nFactors on the failure of weld beams, by the size of the shell at each end (LCT, LCS) and by place and "
      "angle on it (T_ORT, T_ORS):\n";
  for (const weld::Weld& w : ties.welds) {
    const auto ends = weld::failure::shell_factors(model, w);
    if (ends[0].size == 0.0 && ends[1].size == 0.0) continue;
    s += fmt::format(" weld {:>8}", w.id);
    for (const auto& end : ends)
      s += fmt::format("   size {:9.4g}  place {:5.3f}  angle {:4.1f}  tension {:9.4g}  shear {:9.4g}", end.size,
                       end.place, end.angle, end.tension, end.shear);
    s += '\n';
  }
  return s;
}

/// Where *CONTACT_AUTOMATIC_SINGLE_SURFACE_TIED ties parts.
std::string log_touching_parts(const model::Model& model, const weld::Ties& ties) {
  std::string s;
  model::Index contact = model::none;
  for (const weld::TouchingParts& pair : weld::touching_parts(model, ties.ties, ties.x)) {
    if (pair.contact != std::exchange(contact, pair.contact))
      s += fmt::format("{} ties parts that touch, distances{}:\n", weld::name_contact(model.contacts[contact]),
                       model::in_units(model::units_of(model), dimension::length));
    s += ' ' + weld::describe(model, pair) + '\n';
  }
  return s;
}

}  // namespace

std::string log_head(const std::string& version, const std::string& deck, int threads, int ranks) {
  return fmt::format("nugget {}\n\n deck     {}\n date     {:%Y-%m-%d %H:%M:%S}\n threads  {}\n{}\n", version, deck,
                     fmt::localtime(std::time(nullptr)), threads,
                     ranks > 1 ? fmt::format(" ranks    {}\n", ranks) : "");
}

std::string log_findings(const Findings& findings) {
  std::string s = fmt::format("Findings: {}, {} in all\n\n", totals(findings), findings.all().size());
  for (const std::string& line : list_findings(findings.all())) s += ' ' + line + '\n';
  return s + '\n';
}

std::string log_model(const model::Model& model) {
  const auto units = model::units_of(model);
  std::string s = fmt::format(
      "Model: {}\n\n units {}\n nodes {}, shells {}, solids {}, beams {}, parts {}, rigid bodies {}, SPCs {}, "
      "prescribed motions {}, contacts {}, rigid walls {}\n\n",
      model.title,
      units ? fmt::format("{} (force {}, stress {}){}", units->name, units->force, units->stress,
                          model.units.empty() ? ", as density and Young's modulus say" : ", as given")
            : "not recognised: give --units",
      model.nodes.size(), model.shells.size(), model.solids.size(), model.beams.size(), model.parts.size(),
      model.rigid_bodies.size(), model.spcs.size(), model.motions.size(),
      model.contacts.size() + model.interiors.size(), model.walls.size());
  std::vector<std::size_t> count(model.parts.size(), 0);
  for (model::Index p : model.shells.part) ++count[p];
  for (model::Index p : model.solids.part) ++count[p];
  for (model::Index p : model.beams.part) ++count[p];
  s += fmt::format(" {:>8}  {:>9}  {:<40}  {:<34}  {}\n", "part", "elements", "section", "material", "title");
  for (std::size_t p = 0; p < model.parts.size(); ++p) {
    const model::Part& part = model.parts[p];
    std::string material = part.material == model::none ? "none" : '*' + model.materials[part.material].keyword;
    if (part.material != model::none && std::holds_alternative<kernel::Laminate>(model.materials[part.material].law))
      material += fmt::format(" of {}", model.materials[part.material].title);  // the layers' materials
    s += fmt::format(" {:>8}  {:>9}  {:<40}  {:<34}  {}\n", part.id, count[p], section_name(model, part, units),
                     material, part.title);
  }
  return s + '\n';
}

std::string log_precision(const system::System& system) {
  const model::Model& model = system.model;
  std::map<std::pair<bool, model::Index>, std::map<std::string, std::size_t>> count;
  for (const auto& group : system.groups)
    count[{group->single_precision(), group->part}][elements_name(system, *group)] += group->size();
  std::string s = "Precision of the elements (--precision single)\n\n";
  for (const bool single : {true, false}) {
    std::string lines;
    for (const auto& [key, kinds] : count) {
      if (key.first != single) continue;
      const model::Part& part = model.parts[key.second];
      for (const auto& [kind, elements] : kinds)
        lines += fmt::format("   part {:>8}  {:>9} {:<10}  {}{}\n", part.id, elements, kind, formulation(model, part),
                             part.material == model::none ? "" : '*' + model.materials[part.material].keyword);
    }
    s += fmt::format(" {}{}\n{}", single ? "single" : "double, as they have no kernel in single precision",
                     lines.empty() ? ": none" : ":", lines);
  }
  return s + '\n';
}

std::string log_ties(const model::Model& model, const weld::Ties& ties, std::size_t most) {
  if (ties.welds.empty() && ties.ties.empty()) return {};
  std::map<int, int> by_case;
  int tied = 0;
  std::size_t open = 0;
  std::string reasons;
  for (const weld::Weld& w : ties.welds) {
    tied += w.tied;
    for (const weld::Projection& p : w.ends) {
      ++by_case[p.projection_case];
      if (!p.tied && ++open <= most)
        reasons += fmt::format(" weld {} of part {}: node {} {}\n", w.id,
                               w.part == model::none ? 0 : model.parts[w.part].id, model.nodes.id[p.node], p.reason);
    }
  }
  std::string s = fmt::format("Welds: {}, tied at all their nodes: {}; tied nodes: {}\n\n", ties.welds.size(), tied,
                              ties.ties.size());
  const auto connectors = std::count_if(ties.welds.begin(), ties.welds.end(), [](const weld::Weld& w) {
    return w.kind == weld::Weld::Kind::connector && !w.interpolated;
  });
  if (connectors > 0) s += fmt::format(" discrete beams (ELFORM 6) among them: {}\n\n", connectors);
  const auto joints =
      std::count_if(ties.welds.begin(), ties.welds.end(), [](const weld::Weld& w) { return w.interpolated; });
  if (joints > 0) s += fmt::format(" of *CONSTRAINED_INTERPOLATION_SPOTWELD among them: {}\n\n", joints);
  for (const auto& [projection_case, n] : by_case)
    s += fmt::format(" case {}  {:>8} nodes  {}\n", projection_case, n, case_name(projection_case));
  if (open > 0) s += "\nNot tied:\n" + reasons;
  if (open > most) s += fmt::format(" and {} more nodes; welds.csv has all\n", open - most);
  s += log_bricks(model, ties) + log_shell_factors(model, ties) + log_touching_parts(model, ties);
  return s + '\n';
}

std::string log_tied_nodes(const model::Model& model, const weld::Ties& ties) {
  if (!model.control.list_ties || ties.ties.empty()) return {};
  std::string s = fmt::format("Tied nodes (OUTSEG = 1), distances{}:\n",
                              model::in_units(model::units_of(model), dimension::length));
  for (const weld::Tie& t : ties.ties) s += ' ' + weld::describe(model, t) + '\n';
  return s + '\n';
}

std::string log_mass(const system::System& system) {
  const system::System::Masses m = system.masses();
  std::string s = fmt::format(
      "Mass{}\n\n physical mass       {:.6e}\n added mass          {:.6e}  ({:.4f} %)\n added to welds      {:.6e}\n",
      model::in_units(model::units_of(system.model), dimension::mass), m.physical, m.added,
      m.physical > 0.0 ? 100.0 * m.added / m.physical : 0.0, m.added_to_welds);
  for (std::size_t p = 0; p < m.added_by_part.size(); ++p)
    if (m.added_by_part[p] != 0.0)
      s += fmt::format("   part {:>8}  {:.6e}\n", system.model.parts[p].id, m.added_by_part[p]);
  return s + '\n';
}

std::string log_computed_by_all(const impact::Simulation& run, const system::Partition& partition) {
  const impact::Simulation::ComputedByAll whole = run.computed_by_all();
  if (whole.names.empty()) return " elements and nodes are shared out\n\n";
  if (whole.every_node)
    return fmt::format(" elements are shared out; every rank moves all nodes and computes whole: {}\n\n",
                       fmt::join(whole.names, ", "));
  const system::FollowersOfNodes of_nodes(run.system(), partition, run.followed_by_all());
  std::size_t of_all = 0;
  for (std::size_t k = 0; k < of_nodes.size(); ++k) of_all += of_nodes[k].all;
  return fmt::format(" elements and nodes are shared out; every rank computes whole, and moves {} nodes for it: {}\n\n",
                     of_all, fmt::join(whole.names, ", "));
}

/// Of a run over several ranks: what each had, sent and waited for.
std::string log_ranks(const impact::Simulation& run, const output::Summary& summary) {
  if (summary.rank.empty()) return {};
  std::string s = "Ranks\n\n" + log_computed_by_all(run, run.system().share()->partition()) +
                  " rank  elements     nodes    shared  neighbours  expected load  of contact  messages a cycle  bytes "
                  "a cycle  busy s  "
                  "waiting  memory MB\n";
  double most = 0.0, mean = 0.0;
  for (std::size_t r = 0; r < summary.rank.size(); ++r) {
    const output::Summary::Rank& rank = summary.rank[r];
    const double seconds = rank.busy + rank.waiting;
    s += fmt::format(
        " {:>4} {:>9} {:>9} {:>9} {:>11} {:>14.3f} {:>11.3f} {:>17.1f} {:>14.0f} {:>7.2f} {:>7.1f} % {:>9.0f}\n", r,
        rank.elements, rank.nodes, rank.shared_nodes, rank.neighbours, rank.expected_load, rank.expected_contact_load,
        rank.messages, rank.bytes, rank.busy, seconds > 0.0 ? 100.0 * rank.waiting / seconds : 0.0, rank.peak_memory);
    most = std::max(most, rank.busy);
    mean += rank.busy / static_cast<double>(summary.rank.size());
  }
  return s + fmt::format("\n the busiest rank has {:.2f} times the mean work\n\n", mean > 0.0 ? most / mean : 1.0);
}

std::string log_run(const impact::Simulation& run, const output::Summary& summary) {
  const auto units = model::units_named(summary.units);
  const std::string in_time = model::unit_of(units, dimension::time);
  std::string s = fmt::format(
      "Run\n\n first step     {:.6e}{}\n smallest step  {:.6e}{}, controlled by {}\n cycles         {}\n time          "
      " "
      "{:.6e}{}\n",
      summary.time_step.first, in_time, summary.time_step.smallest, in_time, summary.time_step.controlling,
      summary.cycles, summary.time, in_time);
  for (std::size_t begin = 0, end = 0; begin < run.step_notes().size(); begin = end + 1) {
    end = run.step_notes().find('\n', begin);
    s += ' ' + run.step_notes().substr(begin, end - begin) + '\n';
  }
  s += '\n';
  if (const auto& r = summary.relaxation)
    s += fmt::format(
        "Dynamic relaxation before the run: {} cycles, time {:.6e}{}, kinetic energy over the largest {:.3e}: {}\n\n",
        r->cycles, r->time, in_time, r->kinetic_energy_ratio, r->at_rest ? "at rest" : "NOT at rest when it ended");
  const output::Summary::Energies& e = summary.energy;
  s += fmt::format(
      "Energy at the end{}\n\n kinetic {:.5e}  internal {:.5e}  hourglass {:.5e}  contact {:.5e}\n external {:.5e}  "
      "eroded "
      "{:.5e}  change of step {:.5e}\n initial {:.5e}  ratio {:.5f}, without change of step {:.5f}\n hourglass / "
      "internal {:.3f} %, of the internal energy by bulk viscosity {:.5e}\n of contact: springs {:.5e}  friction "
      "{:.5e}  damping {:.5e}  lost {:.5e}\n\n",
      model::in_units(units, dimension::energy), e.kinetic, e.internal, e.hourglass, e.contact, e.external, e.eroded,
      e.step_change, e.initial, e.ratio, e.ratio_without_step_change,
      e.internal != 0.0 ? 100.0 * e.hourglass / e.internal : 0.0, e.bulk_viscosity, e.contact_springs,
      e.contact_friction, e.contact_damping, e.contact_lost);
  std::string events;
  run.components().for_each([&](const auto& component) {
    if constexpr (requires { component.events(); })
      for (const std::string& event : component.events()) events += ' ' + event + '\n';
  });
  for (const std::string& event : run.events()) events += ' ' + event + '\n';
  const impact::Joints& joints = run.components().joints;
  if (joints.size() > 0) {
    s += fmt::format("Joints: largest distance between the points that they hold together{}\n\n",
                     model::in_units(units, dimension::length));
    for (std::size_t i = 0; i < joints.size(); ++i)
      s += fmt::format(" joint {:>8} {:12.4e}\n", run.system().model.joints[i].id, joints.largest_opening(i));
    s += '\n';
    for (std::size_t i = 0; i < joints.size(); ++i)
      if (joints.failed(i))
        events += fmt::format(" joint {} fails at {:.6e}{}\n", run.system().model.joints[i].id, joints.failure_time(i),
                              in_time);
  }
  if (!events.empty()) s += fmt::format("Events, times{}\n\n{}\n", model::in_units(units, dimension::time), events);
  s += fmt::format("Seconds\n\n read {:.3f}  setup {:.3f}  solve {:.3f}  output {:.3f}\n", summary.seconds.read,
                   summary.seconds.setup, summary.seconds.solve, summary.seconds.output);
  for (const auto& [name, seconds] : summary.seconds.phases)
    s += fmt::format("   {:<12} {:8.3f}  {:5.1f} %\n", name, seconds,
                     summary.seconds.solve > 0.0 ? 100.0 * seconds / summary.seconds.solve : 0.0);
  s += fmt::format(" {:.1f} ns per element and cycle on {} threads, {} elements at a time",
                   summary.ns_per_element_cycle, summary.threads, summary.lanes);
  if (summary.elements_by_precision.single > 0) s += fmt::format(", of single precision {}", 2 * summary.lanes);
  return s +
         fmt::format("\n {:.0f} MB of memory at most{}\n\n", summary.peak_memory,
                     summary.rank.empty() ? "" : " in the first rank") +
         log_ranks(run, summary);
}

std::string in_short(const output::Summary& summary) {
  const auto units = model::units_named(summary.units);
  const auto with_unit = [&](double value, const Dimension& dimension) {
    return fmt::format("{:.4g}{}", value, model::unit_of(units, dimension));
  };
  const auto place = [&](const output::WeldReport& weld) {
    return fmt::format("at ({:.4g}, {:.4g}, {:.4g}){}", weld.middle.x, weld.middle.y, weld.middle.z,
                       model::unit_of(units, dimension::length));
  };
  const output::Summary::Energies& e = summary.energy;
  std::string text = fmt::format("{} cycles in {:.2f} s to time {}; energy ratio {:.5f}\n", summary.cycles,
                                 summary.seconds.solve, with_unit(summary.time, dimension::time), e.ratio);
  text += fmt::format("energy: kinetic {}, internal {}", with_unit(e.kinetic, dimension::energy),
                      with_unit(e.internal, dimension::energy));
  if (e.internal > 0.0) text += fmt::format(", hourglass {:.2g} % of it", 100.0 * e.hourglass / e.internal);
  if (summary.mass.physical > 0.0)
    text += fmt::format("; mass added {:.2g} %", 100.0 * summary.mass.added / summary.mass.physical);
  if (const auto& of = summary.elements_by_precision; of.single > 0)
    text += fmt::format("; {} of {} elements in single precision", of.single, of.single + of.of_double);
  text += '\n';
  const output::WeldReport *first = nullptr, *nearest = nullptr;
  std::size_t failed = 0;
  for (const output::WeldReport& weld : summary.welds) {
    failed += weld.failed;
    if (weld.failure_time && (!first || *weld.failure_time < *first->failure_time)) first = &weld;
    if (!weld.failed && weld.peak_failure > (nearest ? nearest->peak_failure : 0.0)) nearest = &weld;
  }
  if (summary.welds.empty()) return text;
  text += fmt::format("welds: {} of {} failed", failed, summary.welds.size());
  if (first)
    text += fmt::format(", first {} {} at {} by {}", first->id, place(*first),
                        with_unit(*first->failure_time, dimension::time), first->failure_mode);
  if (nearest)
    text +=
        fmt::format("; nearest to it {}{} {}, failure value {:.3g} at {}", first ? "of the others " : "", nearest->id,
                    place(*nearest), nearest->peak_failure, with_unit(nearest->peak_failure_time, dimension::time));
  return text + '\n';
}

std::string log_resumption(const output::RestartHead& head, const std::string& date) {
  return fmt::format("\n Resumed from a restart file, {}: time {:.6g}, cycle {}, {} threads\n\n", date, head.time,
                     head.cycle, threads());
}

std::string log_termination(const impact::Outcome& outcome) {
  const std::string reason = outcome.message.empty() ? "" : ' ' + outcome.message + "\n\n";
  switch (outcome.termination) {
    case impact::Termination::normal: return reason + " N o r m a l    t e r m i n a t i o n\n";
    case impact::Termination::error: return reason + " E r r o r   t e r m i n a t i o n\n";
    case impact::Termination::interrupted: return reason + " I n t e r r u p t e d\n";
  }
  return reason;
}

}  // namespace nugget::app
