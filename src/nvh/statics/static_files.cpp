// SPDX-License-Identifier: Apache-2.0
#include "nvh/statics/static_files.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "base/index.hpp"
#include "model/history_files.hpp"
#include "nvh/matrices/stresses.hpp"
#include "output/binout.hpp"
#include "output/bndout.hpp"
#include "output/jntforc.hpp"
#include "output/model_geometry.hpp"
#include "output/nodout.hpp"
#include "output/spcforc.hpp"
#include "output/swforc.hpp"

namespace nugget::nvh {
namespace {

Vec3d translation(const SixDof& s) {
  return {s[0], s[1], s[2]};
}
Vec3d rotation(const SixDof& s) {
  return {s[3], s[4], s[5]};
}

/// The states of all files; `share` 0: at rest, 1: solved.
class States {
 public:
  States(const Matrices& matrices, const Statics& statics)
      : m_(matrices), s_(statics), model_(m_.system.model), stresses_(m_.system, s_.motion) {}

  double time(double share) const { return share * model_.control.end_time; }

  output::D3plotState d3plot(double share, const output::D3plotGeometry& geometry) const {
    output::D3plotState state;
    state.time = time(share);
    state.internal = state.total = share * s_.energy;
    state.parts.resize(model_.parts.size() + at(geometry.nodal_rigid_bodies));
    for (std::size_t p = 0; p < model_.parts.size(); ++p) {
      state.parts[p].internal = share * s_.part_energy[p];
      state.parts[p].mass = m_.system.part_mass(static_cast<model::Index>(p));
    }
    state.wall_forces.resize(at(geometry.rigid_walls));
    state.x = m_.system.ties.x;
    state.v.resize(state.x.size());
    state.a.resize(state.x.size());
    for (std::size_t n = 0; n < state.x.size(); ++n) state.x[n] += share * displacement(n);
    stresses_.fill(share, state);
    return state;
  }

  output::NodoutState nodout(double share) const {
    output::NodoutState state;
    state.time = time(share);
    state.rotations = model_.shells.size() > 0 || model_.beams.size() > 0;
    for (const model::NamedEntity& entity : model_.requests.history_nodes) {
      const std::size_t n = at(entity.index);
      output::NodoutRow row;
      row.node = model_.nodes.id[n];
      row.displacement = share * displacement(n);
      row.coordinate = model_.nodes.x[n] + row.displacement;
      row.rotation = share * rotation(s_.motion[m_.system.node_of[n]]);
      if (entity.system != model::none) {  // small motions do not turn the axes
        const Frame3d& axes = model_.systems[entity.system].axes;
        row.displacement = axes.local(row.displacement);
        row.rotation = axes.local(row.rotation);
      }
      state.rows.push_back(row);
    }
    return state;
  }

  output::SpcforcState spcforc(double share) const {
    output::SpcforcState state;
    state.time = time(share);
    for (std::size_t i = 0; i < model_.spcs.size(); ++i) {
      const model::SinglePointConstraint& spc = model_.spcs[i];
      const int node = m_.system.node_of[spc.node];
      if (!model_.holds_at_start(spc) || (m_.system.map.dependent(node) && m_.system.map.rotations(node))) continue;
      const SixDof force = support_load(Equations::Support::Source::spc, i, node);
      const Frame3d axes =
          spc.system == model::none ? Frame3d{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}} : model_.systems[spc.system].axes;
      const int id = model_.nodes.id[spc.node];
      if (spc.fixed & 7u) {
        state.forces.push_back({id, axes.local(share * translation(force)), spc.id});
        state.resultant += share * translation(force);
      }
      if (spc.fixed >> 3) state.moments.push_back({id, axes.local(share * rotation(force)), spc.id});
    }
    const auto ascending = [](const output::SpcforcRow& a, const output::SpcforcRow& b) { return a.node < b.node; };
    std::stable_sort(state.forces.begin(), state.forces.end(), ascending);
    std::stable_sort(state.moments.begin(), state.moments.end(), ascending);
    return state;
  }

  output::BndoutState bndout(double share) const {
    output::BndoutState state;
    state.time = time(share);
    for (std::size_t i = 0; i < model_.motions.size(); ++i) {
      const model::PrescribedMotion& motion = model_.motions[i];
      const auto row = [&](int node) {
        const SixDof force = support_load(Equations::Support::Source::motion, i, node);
        const SixDof& u = s_.motion[node];
        const double work = 0.5 * (dot(translation(force), translation(u)) + dot(rotation(force), rotation(u)));
        return std::pair{force, work};
      };
      if (motion.target != model::PrescribedMotion::Target::nodes) {
        const auto [force, work] = row(m_.system.bodies[m_.system.body_of[motion.rigid_body]].node);
        state.bodies.push_back({model_.rigid_bodies[motion.rigid_body].id, share * translation(force),
                                share * rotation(force), share * work});
        continue;
      }
      for (const model::Index n : motion.nodes) {
        const auto [force, work] = row(m_.system.node_of[n]);
        state.nodes.push_back({model_.nodes.id[n], share * translation(force), share * work, motion.id});
      }
    }
    return state;
  }

  output::JntforcState jntforc(double share) const {
    output::JntforcState state;
    state.time = time(share);
    for (std::size_t i = 0; i < model_.joints.size(); ++i) {
      const model::Joint& joint = model_.joints[i];
      output::JntforcRow row{joint.id, share * translation(s_.joint[i]), share * rotation(s_.joint[i])};
      if (joint.output) {
        row.local = true;
        for (Vec3d* load : {&row.force, &row.moment}) *load = joint.output->axes.local(*load);
      }
      state.rows.push_back(row);
    }
    return state;
  }

  output::SwforcState swforc(double share) const {
    output::SwforcState state;
    state.time = time(share);
    state.resultant_force = model_.requests["swforc"].resultant_force;
    for (std::size_t i = 0; i < s_.weld.size(); ++i) {
      if (!s_.weld[i]) continue;
      const weld::Weld& weld = m_.system.ties.welds[i];
      const auto section = at(model_.parts[weld.part].section);
      const bool wanted =
          weld.of_bricks() ? model_.solid_sections[section].in_swforc : model_.beam_sections[section].in_swforc;
      if (!wanted) continue;
      const weld::Resultants& r = s_.weld[i]->resultants;
      const double failure = std::isnan(s_.weld[i]->failure) ? 0.0 : share * s_.weld[i]->failure;
      state.rows.push_back({weld.id, kind(weld), share * r.axial, share * r.shear(), weld.length, share * r.moment(),
                            share * r.torsion, failure, 0.0});
    }
    return state;
  }

 private:
  Vec3d displacement(std::size_t n) const { return translation(s_.motion[m_.system.node_of[n]]); }

  static output::WeldKind kind(const weld::Weld& weld) {
    return weld.interpolated                         ? output::WeldKind::nonnodal
           : weld.kind == weld::Weld::Kind::solid    ? output::WeldKind::solid
           : weld.kind == weld::Weld::Kind::assembly ? output::WeldKind::assembly
                                                     : output::WeldKind::beam;
  }

  /// Force and moment of one SPC or motion on a node.
  SixDof support_load(Equations::Support::Source source, std::size_t index, int node) const {
    SixDof sum{};
    const std::vector<Equations::Support>& all = m_.equations.supports();
    const auto before = [](const Equations::Support& a, const std::pair<int, std::size_t>& b) {
      return std::pair{static_cast<int>(a.source), a.index} < b;
    };
    auto first = std::lower_bound(all.begin(), all.end(), std::pair{static_cast<int>(source), index}, before);
    for (; first != all.end() && first->source == source && first->index == index; ++first) {
      if (first->node != node) continue;
      const Vec3d force = s_.support_force[first - all.begin()] * first->taken;
      const double component[3] = {force.x, force.y, force.z};
      for (std::size_t i = 0; i < 3; ++i) sum[i + (first->rotation ? 3 : 0)] += component[i];
    }
    return sum;
  }

  const Matrices& m_;
  const Statics& s_;
  const model::Model& model_;
  ElasticStresses stresses_;
};

}  // namespace

void write_statics(const std::filesystem::path& directory, const output::Header& header, const Matrices& matrices,
                   const Statics& statics) {
  const States states(matrices, statics);
  const model::Model& model = matrices.system.model;
  const model::Requests& ask = model.requests;
  output::D3plotGeometry geometry = output::d3plot_geometry(matrices.system);
  output::D3plot plot(directory, geometry);
  for (const double share : {0.0, 1.0}) plot.write(states.d3plot(share, geometry));

  std::unique_ptr<output::Binout> binout;
  const auto write = [&](model::HistoryName name, const auto& format, bool any, auto state,
                         const std::vector<output::LegendEntry>& legend = {}) {
    const model::Request& request = ask[name];
    if (!request.asked() || !any) return;
    if (request.binout() && !binout) binout = std::make_unique<output::Binout>(directory, header);
    std::optional<output::AsciiHistory<decltype(state(0.0))>> file;
    if (request.ascii()) file.emplace(format, directory / name.text(), header, legend);
    for (const double share : {0.0, 1.0}) {
      if (file) file->write(state(share));
      if (request.binout()) binout->write(format, state(share));
    }
  };
  write("nodout", output::nodout(), !ask.history_nodes.empty(), [&](double share) { return states.nodout(share); });
  write("spcforc", output::spcforc(), !model.spcs.empty(), [&](double share) { return states.spcforc(share); });
  write("bndout", output::bndout(), !model.motions.empty(), [&](double share) { return states.bndout(share); });
  std::vector<output::LegendEntry> joints;
  for (const model::Joint& j : model.joints)
    if (!j.title.empty()) joints.push_back({j.id, j.title});
  write(
      "jntforc", output::jntforc(), !model.joints.empty(), [&](double share) { return states.jntforc(share); }, joints);
  write("swforc", output::swforc(), !statics.weld.empty(), [&](double share) { return states.swforc(share); });
}

}  // namespace nugget::nvh
