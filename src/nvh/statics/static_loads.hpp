// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/finding.hpp"
#include "nvh/matrices/matrices.hpp"
#include "nvh/matrices/nodal.hpp"

namespace nugget::nvh {

/// What the loads of a model put on the nodes at one time. A kind of load that linear statics knows has a function
/// `add` here; gas in control volumes has an empty one, since it takes no part (linear_model warns of it).
class StaticLoads {
 public:
  StaticLoads(const Matrices& matrices, double time) : m_(matrices), time_(time), load_(matrices.system.all_nodes()) {}

  void add(const model::NodalLoad& load);
  void add(const model::PressureLoad& load);
  void add(const model::ControlVolume&) {}
  void add(const model::BodyLoad& load);
  const Nodal& nodal() const { return load_; }

 private:
  double level(model::Index curve, double time) const;
  int node(model::Index n) const { return m_.system.node_of[n]; }
  Vec3d place(model::Index n) const { return m_.system.ties.x[n]; }

  const Matrices& m_;
  double time_;
  Nodal load_;
};

template <class Load>
concept KnownInStatics = requires(StaticLoads& loads, const Load& load) {
  loads.add(load);
};

/// An error for a load of a kind that StaticLoads does not know, by its `keyword` (without star) and `place`.
template <class Load>
void refuse_unknown(const Load& load, Findings& findings) {
  if constexpr (!KnownInStatics<Load>)
    findings.error(load.place, '*' + load.keyword, "this load is not built in linear statics",
                   "take it out, or solve the deck by explicit dynamics (*CONTROL_IMPLICIT_GENERAL IMFLAG 0)");
}

/// Loads that act where nothing resists motion: an error by the load's place; of body loads a warning. With a
/// preload, which resists motion in the end, all are warnings: its statics leaves such loads out.
void check_resistance(const Matrices& matrices, Findings& findings);

/// All loads of the model that linear statics knows, at a time.
Nodal external_loads(const Matrices& matrices, double time);

/// The same, and what springs and discrete beams do to their nodes
/// by the offsets and preloads that they have at time 0.
Nodal static_loads(const Matrices& matrices, double time);

}  // namespace nugget::nvh
