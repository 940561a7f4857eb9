// SPDX-License-Identifier: Apache-2.0
#include "output/nodout.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/index.hpp"
#include "impact/recording/histories.hpp"
#include "impact/recording/history_by_rows.hpp"
#include "impact/recording/node_motion.hpp"
#include "impact/recording/nodout_rows.hpp"
#include "model/axes.hpp"
#include "model/history_files.hpp"

namespace nugget::impact {
namespace {

/// Acceleration that body loads on all parts give every node.
Vec3d gravity(const Snapshot& now) {
  const model::Model& model = now.system.model;
  Vec3d sum;
  for (const model::BodyLoad& load : model.body_loads) {
    if (!load.parts.empty() || !load.nodes.empty() || load.centrifugal) continue;
    const Curve& curve = model.curves[load.curve];
    if (curve.in_run) sum -= load.scale * curve.zero_outside(now.state.time) * load.direction;
  }
  return sum;
}

/// Bits of the global accelerations of body loads that an accelerometer leaves out now.
unsigned without_gravity(const Snapshot& now, const model::Accelerometer& a) {
  if (a.gravity_curve == model::none) return a.without_gravity;
  const double flag = now.system.model.curves[a.gravity_curve].clamped(now.state.time);
  return model::gravity_left_out(static_cast<int>(std::lround(flag)));
}

/// Histories of accelerometers are in axes that turn with the nodes.
void turn_into_accelerometer(const Snapshot& now, model::Index node, output::NodoutRow& row) {
  const model::Model& model = now.system.model;
  const auto found = std::find_if(model.accelerometers.begin(), model.accelerometers.end(),
                                  [&](const model::Accelerometer& a) { return a.node[0] == node; });
  if (found == model.accelerometers.end()) return;
  const Frame3d axes = accelerometer_axes(now.system, now.state, *found);
  const unsigned without = without_gravity(now, *found);
  const Vec3d g = without != 0 ? gravity(now) : Vec3d{};
  const auto left_out = [&](unsigned i, double value) { return without >> i & 1u ? value : 0.0; };
  row.acceleration -= Vec3d{left_out(0, g.x), left_out(1, g.y), left_out(2, g.z)};
  for (Vec3d* v : {&row.displacement, &row.velocity, &row.acceleration, &row.rotation, &row.rotational_velocity,
                   &row.rotational_acceleration})
    *v = axes.local(*v);
  if (!found->sums_local) return;
  const auto k = at(now.system.node_of[node]);
  const Vec3d change = vec(now.state.v[k]) - vec(now.v_before[k]);
  row.velocity =
      now.components.accelerometers.velocity(static_cast<std::size_t>(found - model.accelerometers.begin())) +
      share_before_now(now.state) * axes.local(change);
}

/// The motion of a node in the axes that its history asks for; coordinates stay global.
/// `of_origin`: the motion of the origin of axes that a motion is relative to.
void turn_into_local_axes(const Snapshot& now, const model::NamedEntity& entity,
                          const std::optional<NodeMotion>& of_origin, output::NodoutRow& row) {
  if (entity.system == model::none) return;
  const model::CoordinateSystem& system = now.system.model.systems[entity.system];
  Frame3d axes = system.axes;
  const auto index = [&](model::Index n) { return at(now.system.node_of[n]); };
  const auto place = [&](model::Index n) { return vec(now.state.x[index(n)]); };
  if (entity.turning)
    model::frame_of_points(place(system.nodes->origin), place(system.nodes->on_axis), place(system.nodes->in_plane),
                           system.nodes->axis, axes);
  if (of_origin) {
    const model::Index origin = system.nodes->origin;
    row.velocity -= of_origin->velocity;
    row.acceleration -= of_origin->acceleration;
    const auto start = [&](model::Index n) { return now.system.model.nodes.x[n]; };
    row.displacement =
        row.coordinate - place(origin) - axes.global(system.axes.local(start(entity.index) - start(origin)));
  }
  for (Vec3d* vector : {&row.displacement, &row.velocity, &row.acceleration, &row.rotation, &row.rotational_velocity,
                        &row.rotational_acceleration})
    *vector = axes.local(*vector);
}

}  // namespace

namespace {

/// What is known of a node where its motion is: the first rank makes its row of it.
struct Motion {
  Vec3d place, rotation;
  NodeMotion motion;
};

Motion motion_of(const Snapshot& now, std::size_t i) {
  const auto k = at(now.system.node_of[now.system.model.requests.history_nodes[i].index]);
  return {vec(now.state.x[k]), now.history_rotation[i], node_motion(now, k)};
}

/// The motion of the node that history `i` is relative to.
std::optional<NodeMotion> motion_of_origin(const Snapshot& now, std::size_t i) {
  const model::Model& model = now.system.model;
  const model::NamedEntity& entity = model.requests.history_nodes[i];
  if (entity.system == model::none || !entity.relative) return {};
  return node_motion(now, at(now.system.node_of[model.systems[entity.system].nodes->origin]));
}

output::NodoutRow row_of(const Snapshot& now, std::size_t i, const Motion& of,
                         const std::optional<NodeMotion>& of_origin) {
  const model::Model& model = now.system.model;
  const model::NamedEntity& entity = model.requests.history_nodes[i];
  output::NodoutRow row;
  row.node = model.nodes.id[entity.index];
  row.coordinate = of.place;
  row.displacement = row.coordinate - model.nodes.x[entity.index];
  row.velocity = of.motion.velocity;
  row.acceleration = of.motion.acceleration;
  row.rotational_velocity = of.motion.rotational_velocity;
  row.rotational_acceleration = of.motion.rotational_acceleration;
  row.rotation = of.rotation;
  turn_into_local_axes(now, entity, of_origin, row);
  turn_into_accelerometer(now, entity.index, row);
  return row;
}

}  // namespace

void MeanAccelerations::begin(double time, std::size_t motions) {
  if (time == time_) return;
  before_ = std::move(now_);
  time_before_ = std::exchange(time_, time);
  now_.assign(motions, {});
}

NodeMotion MeanAccelerations::averaged(std::size_t i, NodeMotion motion) {
  now_[i] = {motion.velocity, motion.rotational_velocity};
  if (before_.empty()) return motion;
  const double over = 1.0 / (time_ - time_before_);
  motion.acceleration = over * (motion.velocity - before_[i].velocity);
  motion.rotational_acceleration = over * (motion.rotational_velocity - before_[i].spin);
  return motion;
}

void NodoutRows::set_head(State& s, const Snapshot& now) {
  const model::Model& model = now.system.model;
  s.cycle = now.state.cycle + 1;
  s.time = now.state.time;
  s.rotations = model.shells.size() > 0 || model.beams.size() > 0;
}

std::vector<output::NodoutTable> NodoutRows::tables(const model::Model& model) {
  constexpr model::HistoryName nodout("nodout");
  std::vector<Table> tables{Table::translations};
  const bool rotations = model.shells.size() > 0 || model.beams.size() > 0;
  if (rotations && model.requests[nodout].ascii()) tables.push_back(Table::rotations);
  return tables;
}

void NodoutRows::blank(const system::System& system, const Take& take) {
  const model::Model& model = system.model;
  State state;
  state.rotations = model.shells.size() > 0 || model.beams.size() > 0;
  const std::vector<model::NamedEntity>& asked = model.requests.history_nodes;
  for (std::size_t begin = 0; begin < asked.size(); begin += ResultParcels::rows_at_a_time) {
    state.rows.resize(std::min(ResultParcels::rows_at_a_time, asked.size() - begin));
    for (std::size_t i = 0; i < state.rows.size(); ++i) state.rows[i].node = model.nodes.id[asked[begin + i].index];
    take(state);
  }
}

void NodoutRows::pass(const Snapshot& now, Table, ResultParcels& parcels, const Take& take) {
  const std::vector<model::NamedEntity>& asked = now.system.model.requests.history_nodes;
  const bool means = now.system.model.control.average_accelerations;
  if (means) means_.begin(now.state.time, 2 * asked.size());
  const auto row = [&](std::size_t i, Motion motion) {
    std::optional<NodeMotion> of_origin = motion_of_origin(now, i);
    if (means) {
      motion.motion = means_.averaged(i, motion.motion);
      if (of_origin) of_origin = means_.averaged(asked.size() + i, *of_origin);
    }
    return row_of(now, i, motion, of_origin);
  };
  std::size_t done = 0;
  pass_rows<Motion>(
      &parcels, asked.size(),
      [&](std::size_t i) { return parcels.owner_of_node(at(now.system.node_of[asked[i].index])); },
      [](std::size_t) { return Motion(); }, [&](std::size_t i, Motion& motion) { motion = motion_of(now, i); },
      [](Motion& motion, system::Parcel& parcel) { parcel(&motion, 1); },
      [&](const std::vector<Motion>& motions) {
        State piece;
        set_head(piece, now);
        for (const Motion& motion : motions) piece.rows.push_back(row(done++, motion));
        take(piece);
      });
}

output::NodoutState nodout_state(const Snapshot& now) {
  output::NodoutState all;
  NodoutRows::set_head(all, now);
  ResultParcels parcels(now.system);
  NodoutRows().pass(now, output::NodoutTable::translations, parcels, [&](const output::NodoutState& piece) {
    all.rows.insert(all.rows.end(), piece.rows.begin(), piece.rows.end());
  });
  return all;
}

template <>
HistoryFile history<"nodout">() {
  HistoryFile file = make_history(
      output::nodout(), nodout_state,
      {.concerns = [](const system::System& system) { return !system.model.requests.history_nodes.empty(); },
       .legends =
           [](const model::Model& model) {
             std::vector<output::LegendEntry> headings;
             for (const model::NamedEntity& n : model.requests.history_nodes)
               if (!n.heading.empty()) headings.push_back({model.nodes.id[n.index], n.heading});
             return std::vector<Legend>{{"nodout", headings}};
           }});
  file.open = HistoryByRows<NodoutRows>::open;
  return file;
}

}  // namespace nugget::impact
