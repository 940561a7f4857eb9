// SPDX-License-Identifier: Apache-2.0
#include "output/jntforc.hpp"

#include <numbers>

#include "impact/recording/histories.hpp"

namespace nugget::impact {

output::JntforcState jntforc_state(const Snapshot& now) {
  output::JntforcState s;
  s.time = now.state.time;
  for (std::size_t i = 0; i < now.components.joints.size(); ++i) {
    const model::Joint& source = now.system.model.joints[i];
    output::JntforcRow row{source.id, now.components.joints.force(i), now.components.joints.moment(i),
                           now.components.joints.energy(i)};
    if (source.output) {
      const Frame3d& turned = now.system.bodies[now.system.body_of[source.output->body]].axes;
      row.local = true;
      for (Vec3d* load : {&row.force, &row.moment}) *load = source.output->axes.local(turned.local(*load));
    }
    s.rows.push_back(row);
  }
  const JointSprings& springs = now.components.joints.springs();
  for (std::size_t i = 0; i < springs.size(); ++i) {
    const model::JointStiffness& source = now.system.model.joint_stiffnesses[i];
    const double unit = source.rotational ? 180.0 / std::numbers::pi : 1.0;
    output::JntforcStiffness row{source.id, {}, springs.energy(i)};
    for (std::size_t k = 0; k < 3; ++k) {
      const JointSprings::Reading& r = springs.reading(i, k);
      row.axis[k] = {unit * r.place, unit * r.rate, r.stiffness, r.damping};
    }
    (source.rotational ? s.rotations : s.displacements).push_back(row);
  }
  return s;
}

template <>
HistoryFile history<"jntforc">() {
  return make_history(output::jntforc(), jntforc_state,
                      {.concerns =
                           [](const system::System& system) {
                             return !system.model.joints.empty() || !system.model.joint_stiffnesses.empty();
                           },
                       .legends =
                           [](const model::Model& model) {
                             std::vector<output::LegendEntry> titles;
                             for (const auto& j : model.joints)
                               if (!j.title.empty()) titles.push_back({j.id, j.title});
                             return std::vector<Legend>{{"jntforc", titles}};
                           }});
}

}  // namespace nugget::impact
