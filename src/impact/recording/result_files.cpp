// SPDX-License-Identifier: Apache-2.0
#include "impact/recording/result_files.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "impact/recording/cross_sections.hpp"
#include "impact/recording/d3plot_states.hpp"
#include "impact/recording/element_histories.hpp"
#include "impact/recording/histories.hpp"
#include "impact/recording/weld_results.hpp"
#include "output/model_geometry.hpp"

namespace nugget::impact {

namespace {

/// As the deck says, but as text too; where it asks for none, 200 times over the run.
model::Request with_text(model::Request glstat, double end_time) {
  if (!glstat.asked()) glstat.interval = end_time / 200.0;
  if (glstat.binary == 2) glstat.binary = 3;
  return glstat;
}

/// The next mark by a curve of the interval, from the mark `last` at or after which the state at `time` stands. One
/// that a long step has jumped over is not made up for. Infinite where the curve has none.
double next_on_curve(const model::Request& request, const Curve& curve, double last, double time) {
  using Rule = model::Request::Rule;
  const double from = std::max(last, time);
  if (request.rule == Rule::at_points) {
    const auto later = std::upper_bound(curve.x.begin(), curve.x.end(), from + 1e-12 * std::abs(from));
    return later == curve.x.end() ? std::numeric_limits<double>::infinity() : *later;
  }
  if (request.rule == Rule::from_last) return last + std::max(curve.clamped(last), from - last);
  // T - last = y(T): the first root, between two points of the curve or beyond them all.
  const auto excess = [&](double t) { return t - last - curve.clamped(t); };
  double low = last;
  for (const double x : curve.x) {
    if (x <= low) continue;
    if (excess(x) < 0.0) {
      low = x;
      continue;
    }
    double high = x;
    for (int i = 0; i < 200 && low < high; ++i) {
      const double middle = 0.5 * (low + high);
      if (middle <= low || middle >= high) break;
      (excess(middle) < 0.0 ? low : high) = middle;
    }
    return std::max(high, from);
  }
  return std::max(last + curve.clamped(low), from);
}

/// The first mark: the start, but with IOOPT 3 the curve's first abscissa that is not before it.
double first_mark(const model::Request& request, const std::vector<Curve>& curves) {
  if (request.curve == model::none || request.rule != model::Request::Rule::at_points) return 0.0;
  const std::vector<double>& x = curves[static_cast<std::size_t>(request.curve)].x;
  const auto first = std::lower_bound(x.begin(), x.end(), 0.0);
  return first == x.end() ? std::numeric_limits<double>::infinity() : *first;
}

}  // namespace

template <class File, class MakeState>
void ResultFiles::add(const model::Request& request, const char* name, MakeState make_state,
                      std::vector<output::LegendEntry> legend) {
  if (!request.asked()) return;
  std::shared_ptr<File> ascii;
  if (request.ascii()) {
    if constexpr (std::is_constructible_v<File, std::filesystem::path, const output::Header&,
                                          std::span<const output::LegendEntry>>)
      ascii = std::make_shared<File>(directory_ / name, header_, legend);
    else
      ascii = std::make_shared<File>(directory_ / name, header_);
  }
  std::shared_ptr<output::Binout> binary;
  if (request.binout()) {
    if (!legend.empty()) binout().set_legend(name, legend);
    binout();
    binary = binout_;
  }
  channels_.push_back({&request,
                       [=](const Snapshot& now) {
                         const auto state = make_state(now);
                         if (ascii) ascii->write(state);
                         if (binary) binary->write(state);
                       },
                       [=](Archive& a) {
                         if (ascii) a(*ascii);
                       },
                       first_mark(request, model_.curves)});
}

ResultFiles::ResultFiles(const system::System& system, const std::filesystem::path& directory,
                         const output::Header& header)
    : model_(system.model),
      directory_(directory),
      header_(header),
      energies_(with_text(model_.requests.glstat, model_.control.end_time)) {
  const model::Requests& ask = model_.requests;
  std::vector<output::LegendEntry> parts, nodes, walls, contacts;
  for (const model::Part& p : model_.parts) parts.push_back({p.id, p.title});
  for (const model::NamedEntity& n : ask.history_nodes)
    if (!n.heading.empty()) nodes.push_back({model_.nodes.id[static_cast<std::size_t>(n.index)], n.heading});
  for (const model::RigidWall& w : model_.walls)
    if (!w.title.empty()) walls.push_back({w.id, w.title});
  for (const model::Contact& c : model_.contacts)
    if (!c.title.empty()) contacts.push_back({c.id, c.title});
  for (const model::InteriorContact& c : model_.interiors)
    if (!c.title.empty()) contacts.push_back({c.id, c.title});

  std::vector<output::LegendEntry> sections;
  for (const model::CrossSection& c : ask.cross_sections)
    if (!c.title.empty()) sections.push_back({c.id, c.title});

  add<output::Glstat>(energies_, "glstat", glstat_state);
  add<output::Matsum>(ask.matsum, "matsum", matsum_state, parts);
  if (!ask.history_nodes.empty()) add<output::Nodout>(ask.nodout, "nodout", nodout_state, nodes);
  if (!system.ties.welds.empty()) add<output::Swforc>(ask.swforc, "swforc", swforc_state);
  const bool has_connections = std::any_of(model_.weld_laws.begin(), model_.weld_laws.end(),
                                           [](const auto& law) { return law.properties != model::none; });
  if (has_connections) add<output::Dcfail>(ask.dcfail, "dcfail", dcfail_state);
  const auto printed = [](const model::Discrete& d) { return d.in_deforc; };
  if (std::any_of(model_.discretes.begin(), model_.discretes.end(), printed))
    add<output::Deforc>(ask.deforc, "deforc", deforc_state);
  if (!model_.joints.empty() || !model_.joint_stiffnesses.empty()) {
    std::vector<output::LegendEntry> joints;
    for (const model::Joint& j : model_.joints)
      if (!j.title.empty()) joints.push_back({j.id, j.title});
    add<output::Jntforc>(ask.jntforc, "jntforc", jntforc_state, joints);
  }
  if (!model_.walls.empty()) add<output::Rwforc>(ask.rwforc, "rwforc", rwforc_state, walls);
  if (!model_.spcs.empty()) add<output::Spcforc>(ask.spcforc, "spcforc", spcforc_state);
  if (!model_.motions.empty()) add<output::Bndout>(ask.bndout, "bndout", bndout_state);
  if (!system.bodies.empty()) add<output::Rbdout>(ask.rbdout, "rbdout", rbdout_state);
  if (!model_.control_volumes.empty()) {
    std::vector<output::LegendEntry> volumes;
    int number = 0;
    for (const model::ControlVolume& v : model_.control_volumes) {
      ++number;
      if (!v.title.empty()) volumes.push_back({v.id > 0 ? v.id : number, v.title});
    }
    add<output::Abstat>(ask.abstat, "abstat", abstat_state, volumes);
  }
  add<output::Rcforc>(ask.rcforc, "rcforc", rcforc_state, contacts);
  if (!ask.cross_sections.empty()) {
    const auto through = std::make_shared<CrossSections>(system);
    add<output::Secforc>(
        ask.secforc, "secforc", [through](const Snapshot& now) { return through->state(now); }, sections);
  }
  if (!ask.nodal_force_groups.empty())
    add<output::Nodfor>(ask.nodfor, "nodfor",
                        [](const Snapshot& now) { return now.components.nodal_forces.state(now.state); });
  if (!ask.history_shells.empty() || !ask.history_solids.empty() || !ask.history_beams.empty()) add_elout();
  const bool slides = !model_.interiors.empty() || std::any_of(model_.contacts.begin(), model_.contacts.end(),
                                                               [](const auto& c) { return c.slides(); });
  if (slides) add<output::Sleout>(ask.sleout, "sleout", sleout_state, contacts);
  if (ask.d3plot.asked()) {
    output::D3plotGeometry geometry = output::d3plot_geometry(system);
    geometry.strains = ask.strains;
    geometry.solid_histories = ask.solid_histories;
    geometry.shell_histories = ask.shell_histories;
    auto file = std::make_shared<output::D3plot>(directory, std::move(geometry), header.mode);
    channels_.push_back({&ask.d3plot, [file](const Snapshot& now) { file->write(d3plot_state(now)); },
                         [file](Archive& a) { a(*file); }, first_mark(ask.d3plot, model_.curves)});
  }
}

/// Each kind of element has a branch of its own in binout, and the ASCII file a legend of all.
void ResultFiles::add_elout() {
  const model::Requests& ask = model_.requests;
  std::vector<output::LegendEntry> all;
  const auto legend = [&](const std::vector<model::NamedEntity>& entities, const std::vector<int>& ids,
                          const char* branch) {
    std::vector<output::LegendEntry> named;
    for (const model::NamedEntity& e : entities)
      if (!e.heading.empty()) named.push_back({ids[static_cast<std::size_t>(e.index)], e.heading});
    all.insert(all.end(), named.begin(), named.end());
    if (!named.empty() && ask.elout.binout()) binout().set_legend(branch, std::move(named));
  };
  legend(ask.history_solids, model_.solids.id, "elout/solid");
  legend(ask.history_beams, model_.beams.id, "elout/beam");
  legend(ask.history_shells, model_.shells.id, "elout/shell");
  add<output::Elout>(ask.elout, "elout", elout_state, all);
}

output::Binout& ResultFiles::binout() {
  if (!binout_) binout_ = std::make_shared<output::Binout>(directory_, header_);
  return *binout_;
}

/// Due at the last time that is not beyond the mark, as LS-DYNA does: the next step would pass it.
bool ResultFiles::due(const Channel& channel, const system::State& state) const {
  return state.time + state.dt > channel.next + 1e-9 * state.dt;
}

bool ResultFiles::due(const system::State& state) {
  for (const Channel& c : channels_)
    if (due(c, state)) return true;
  return false;
}

void ResultFiles::Channel::archive(Archive& a) {
  archive_file(a);
  a(next);
  a.built(request, write);
}

void ResultFiles::archive(Archive& a) {
  a.section("result files");
  a(channels_);
  if (binout_) a(*binout_);
  a.built(model_, directory_, header_, energies_);
}

void ResultFiles::write(const Snapshot& now, bool last) {
  for (Channel& c : channels_) {
    if (!last && !due(c, now.state)) continue;
    c.write(now);
    if (c.request->curve != model::none) {
      c.next =
          next_on_curve(*c.request, model_.curves[static_cast<std::size_t>(c.request->curve)], c.next, now.state.time);
      continue;
    }
    const double interval = c.request->interval;
    // Marks are multiples of the interval; one that a long step has jumped over is not made up for.
    if (const double missed = std::floor((now.state.time - c.next) / interval); missed > 64.0)
      c.next += missed * interval;
    // An interval far below the step asks for every cycle: it changes nothing in the mark.
    do c.next += interval;
    while (c.next <= now.state.time && c.next + interval > c.next);
  }
}

}  // namespace nugget::impact
