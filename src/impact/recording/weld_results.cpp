// SPDX-License-Identifier: Apache-2.0
#include "impact/recording/weld_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/index.hpp"
#include "model/history_files.hpp"
#include "weld/tie/welds.hpp"

namespace nugget::impact {
namespace {

output::WeldKind kind(weld::Weld::Kind k) {
  switch (k) {
    case weld::Weld::Kind::beam: return output::WeldKind::beam;
    case weld::Weld::Kind::solid: return output::WeldKind::solid;
    case weld::Weld::Kind::assembly: return output::WeldKind::assembly;
    case weld::Weld::Kind::rigid:
    case weld::Weld::Kind::connector: return output::WeldKind::generalized;
  }
  return output::WeldKind::beam;
}

constexpr double not_available = std::numeric_limits<double>::quiet_NaN();  ///< an empty cell

void add_term(std::string& terms, weld::FailureMode mode, double value) {
  if (value > 0.0) terms += fmt::format("{}{} {:.3g}", terms.empty() ? "" : ", ", weld::to_string(mode), value);
}

/// `length`: of the weld, over which the shear force makes moments at its ends.
output::WeldLoad last_load(const weld::History& history, double length) {
  const weld::Resultants& r = history.last_load().resultants;
  std::string terms;
  for (int i = 0; i < history.last_value().terms; ++i) {
    const auto& [mode, value] = history.last_value().term[i];
    add_term(terms, mode, value);
  }
  const auto at_end = [&](double half) {
    return std::hypot(r.moment_s + half * r.shear_t, r.moment_t - half * r.shear_s);
  };
  return {r.axial,
          r.shear(),
          r.moment(),
          r.torsion,
          history.last_load().rate,
          history.failure_value(),
          terms,
          {at_end(-0.5 * length), at_end(0.5 * length)}};
}

/// A load of which nothing but the axial force is known.
output::WeldLoad axial_load(double axial) {
  return {axial,
          not_available,
          not_available,
          not_available,
          not_available,
          not_available,
          {},
          {not_available, not_available}};
}

output::WeldPeak peak_of(const weld::Peaks& p) {
  return {p.axial, p.shear, p.moment, p.torsion, p.force};
}

void add_course(const weld::FailureCourse& course, output::WeldReport& report) {
  report.course_interval = course.interval();
  report.failure_course.assign(course.largest().begin(), course.largest().end());
}

void add_work(const WeldWork& work, output::WeldReport& report) {
  report.passed = work.passed();
  report.most_passed = work.most_passed();
}

void add_rigid_weld(const weld::RigidWeldHistory& history, output::WeldReport& report) {
  report.failed = history.failed();
  if (history.failed()) report.failure_time = history.failure_time();
  report.failure_mode = weld::to_string(history.mode());
  report.peak = peak_of(history.peaks());
  report.peak_failure = history.peak_failure_value();
  report.peak_failure_time = history.peak_failure_time();
  const weld::RigidWeldHistory::Last& last = history.last();
  report.last = {last.axial,    last.shear, last.moment, last.torsion,
                 not_available, last.value, {},          {not_available, not_available}};
  add_term(report.last.terms, weld::FailureMode::axial, last.normal_term);
  add_term(report.last.terms, weld::FailureMode::shear, last.shear_term);
  report.energy = not_available;
  add_course(history.course(), report);
}

/// How far the damage of a weld has gone at the end, of points that are damaged one by one the mean; not a number where
/// its law has none.
double damage_of(const system::System& system, const weld::Weld& w, const weld::History& history) {
  if (history.failed()) return 1.0;
  if (history.damage().law().growth != weld::DamageLaw::Growth::immediate) return history.damage().damage();
  const auto& law = std::get<kernel::Spotweld>(system.model.materials[system.model.parts[w.part].material].law);
  if (law.damage.growth == kernel::PointDamage::Growth::none) return std::numeric_limits<double>::quiet_NaN();
  double sum = 0.0;
  for (const model::Index element : w.elements) {
    const system::System::ElementLocation location = system.location_of(w, element);
    const system::ElementGroup& group = *system.groups[location.group];
    const double left = group.alive(at(location.element)) ? group.integrity(at(location.element)) : 0.0;
    const double beta = law.damage.beta;
    sum += left <= 0.0 ? 1.0 : beta == 0.0 ? 1.0 - left : std::min(-std::log(left) / beta, 1.0);
  }
  return w.elements.empty() ? 0.0 : sum / static_cast<double>(w.elements.size());
}

void add_rivet(const Rivets& rivets, std::size_t i, output::WeldReport& report) {
  report.failed = rivets.failed(i);
  if (report.failed) {
    report.failure_time = rivets.failure_time(i);
    report.failure_mode = weld::to_string(weld::FailureMode::time);
  }
  report.peak.axial = report.peak.force = rivets.peak(i);
  report.last = axial_load(rivets.axial(i));
  report.peak_failure = report.peak_failure_time = report.energy = not_available;
}

/// A weld of *CONSTRAINED_INTERPOLATION_SPOTWELD, a rivet of _SPR2.
void add_joint(const Connectors::Record& record, const weld::Weld& weld, output::WeldReport& report) {
  const double length = weld.length;
  const weld::Resultants& r = record.last;
  const auto at_end = [&](double half) {
    return std::hypot(r.moment_s + half * r.shear_t, r.moment_t - half * r.shear_s);
  };
  report.last = {
      r.axial,
      r.shear(),
      r.moment(),
      r.torsion,
      not_available,
      record.failure,
      weld.self_piercing
          ? fmt::format("effective displacement {:.3g}, mode mixity {:.3g}", record.damage, record.mode_mixity)
          : fmt::format("plastic displacement {:.3g}, mode mixity {:.3g}", record.plastic, record.mode_mixity),
      {at_end(-0.5 * length), at_end(0.5 * length)}};
  report.peak_failure = record.peak_failure;
  report.peak_failure_time = record.peak_time;
  report.damage = record.damage;
  if (record.failed) report.failure_mode = fmt::format("rupture at mode mixity {:.3g}", record.mode_mixity);
}

void add_connector(const system::System& system, const weld::Weld& weld, const Connectors::Record& record,
                   const WeldWork& work, output::WeldReport& report) {
  report.failed = record.failed;
  if (record.failed) report.failure_time = record.failure_time;
  if (record.failed) report.failure_mode = "limit of its law";
  report.peak = peak_of(record.peaks);
  report.last = axial_load(not_available);
  report.peak_failure = report.peak_failure_time = not_available;
  const system::System::ElementLocation location = system.beam_location[weld.element];
  report.energy = system.groups[location.group]->internal_energy(at(location.element));
  if (weld.interpolated) add_joint(record, weld, report);
  add_work(work, report);
}

/// A weld of a beam or of bricks.
void add_deformable_weld(const system::System& system, const weld::Weld& weld, const weld::History& history,
                         const WeldWork& work, output::WeldReport& report) {
  for (const model::Index element : weld.elements) {
    const system::System::ElementLocation location = system.location_of(weld, element);
    const system::ElementGroup& group = *system.groups[location.group];
    const auto e = at(location.element);
    report.added_mass += group.mass(e) * (group.mass_scale(e) - 1.0);
    report.energy += group.internal_energy(e) + group.hourglass_energy(e);
  }
  report.failed = history.failed();
  if (history.failed()) report.failure_time = history.failure_time();
  report.failure_mode = weld::to_string(history.mode());
  report.peak = peak_of(history.peaks());
  report.peak_failure = history.peak_failure_value();
  report.peak_failure_time = history.peak_failure_time();
  report.last = last_load(history, weld.length);
  add_work(work, report);
  report.damage = damage_of(system, weld, history);
  add_course(history.course(), report);
}

}  // namespace

void add_weld_results(const system::System& system, const Components& components,
                      std::vector<output::WeldReport>& reports) {
  for (std::size_t i = 0; i < reports.size(); ++i) {
    const weld::Weld& weld = system.ties.welds[i];
    if (weld.kind == weld::Weld::Kind::rigid && weld.rigid == weld::Weld::Rigid::rivet)
      add_rivet(components.rivets, components.rivets.find(reports[i].id), reports[i]);
    else if (weld.kind == weld::Weld::Kind::rigid) {
      if (const auto* rigid = components.rigid_welds.history_of_body(weld.element)) add_rigid_weld(*rigid, reports[i]);
    } else if (const Connectors::Record* record = components.connectors.record(i))
      add_connector(system, weld, *record, components.connectors.work(i), reports[i]);
    else if (const weld::History* history = components.welds.history(i))
      add_deformable_weld(system, weld, *history, components.welds.work(i), reports[i]);
  }
}

static output::SwforcRow row_of_joint(const weld::Weld& weld, const Connectors::Record& record, double length) {
  const weld::Resultants now = record.failed ? weld::Resultants{} : record.last;
  return {weld.id,     output::WeldKind::nonnodal,           now.axial,           now.shear(), length, now.moment(),
          now.torsion, record.failed ? 1.0 : record.failure, record.failure_time, {}};
}

output::SwforcState swforc_state(const Snapshot& now) {
  const model::Model& model = now.system.model;
  output::SwforcState s;
  s.time = now.state.time;
  s.resultant_force = model.requests["swforc"].resultant_force;
  const std::vector<weld::Weld>& welds = now.system.ties.welds;
  for (std::size_t i = 0; i < welds.size(); ++i) {
    if (welds[i].interpolated) {
      if (const Connectors::Record* record = now.components.connectors.record(i))
        s.rows.push_back(row_of_joint(welds[i], *record, now.components.connectors.length(i)));
      continue;
    }
    const weld::History* history = now.components.welds.history(i);
    if (history == nullptr) continue;
    const model::Part& part = model.parts[welds[i].part];
    const bool wanted = welds[i].of_bricks() ? model.solid_sections[part.section].in_swforc
                                             : model.beam_sections[part.section].in_swforc;
    if (!wanted) continue;
    const weld::Resultants& r = history->resultants();
    s.rows.push_back({welds[i].id,
                      kind(welds[i].kind),
                      r.axial,
                      r.shear(),
                      now.components.welds.length(i, now.state),
                      r.moment(),
                      r.torsion,
                      history->failed() ? 1.0 : history->failure_value(),
                      history->failure_time(),
                      {}});
    if (model.weld_laws[model.materials[part.material].weld].option == -2)
      s.rows.back().peak = {history->peak_failure_value(), history->peak_failure_time()};
  }
  for (std::size_t i = 0; i < now.components.rigid_welds.size(); ++i) {
    const model::RigidWeld& weld = now.components.rigid_welds.weld(i);
    const weld::RigidWeldHistory& h = now.components.rigid_welds.history(i);
    s.rows.push_back({weld.id,
                      weld.on_a_set() ? output::WeldKind::generalized : output::WeldKind::constraint,
                      h.axial(),
                      h.shear(),
                      now.components.rigid_welds.length(i, now.state),
                      h.moment(),
                      h.torsion(),
                      h.failed() ? 1.0 : h.failure_value(),
                      h.failure_time(),
                      {}});
  }
  for (std::size_t i = 0; i < now.components.rivets.size(); ++i)
    s.rows.push_back({now.components.rivets.rivet(i).id,
                      output::WeldKind::constraint,
                      now.components.rivets.axial(i),
                      0.0,
                      now.components.rivets.length(i, now.state),
                      0.0,
                      0.0,
                      now.components.rivets.failed(i) ? 1.0 : 0.0,
                      now.components.rivets.failure_time(i),
                      {}});
  return s;
}

output::DcfailState dcfail_state(const Snapshot& now) {
  const model::Model& model = now.system.model;
  output::DcfailState s;
  s.time = now.state.time;
  const std::vector<weld::Weld>& welds = now.system.ties.welds;
  for (std::size_t i = 0; i < welds.size(); ++i) {
    const weld::History* history = now.components.welds.history(i);
    if (history == nullptr) continue;
    const model::WeldLaw& law = weld::law_of(model, welds[i]);
    if (!law.connection || law.properties == model::none) continue;
    output::DcfailRow row;
    row.id = welds[i].id;
    row.connection = model.connections[law.properties].id;
    const weld::failure::Value& value = history->last_value();
    row.failure = value.value;
    row.normal = value.term[0].value;
    row.bending = value.term[1].value;
    row.shear = value.term[2].value;
    row.area = value.area;
    row.solid_area = value.solid_area;
    row.strain_rate = value.rate;
    const weld::Resultants& r = history->resultants();
    row.axial_force = r.axial;
    row.shear_force = r.shear();
    row.torsional_moment = r.torsion;
    row.bending_moment = r.moment();
    s.rows.push_back(row);
  }
  return s;
}

}  // namespace nugget::impact
