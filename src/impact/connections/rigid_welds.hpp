// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "base/archive.hpp"
#include "system/system.hpp"
#include "weld/failure/rigid_weld.hpp"

namespace nugget::impact {

/// The rigid welds while the model moves. A weld's force on one of its nodes is what that node's acceleration wants and
/// its load does not give,
///     f_i = m_i a_i - f_i(applied),   a_i = a_c + alpha x r_i + omega x (omega x r_i),
/// with the mass of the node itself (docs/theory/weld.md#rigid-welds). When a weld fails its nodes continue as free
/// nodes with that mass and the velocity they have; of a spot of more than two nodes the outermost node is released
/// first. A fillet or butt weld fails seam by seam (model::Seam), and releases the nodes that no seam holds any more: a
/// node with one neighbour hands all its force to the seams to it; the three seams of a triangle are equally stiff.
/// Welds limit no time step.
class RigidWelds {
 public:
  /// The system must outlive it. A weld that can fail, but whose nodes ties follow, is an error.
  RigidWelds(system::System& system, Findings& findings);

  /// Before the loads of dependent nodes are collected: remembers them.
  void store_loads(const system::State& state);
  /// After that: forces of the welds at this time; releases what fails. True if any node was released.
  bool update(system::State& state);

  std::size_t size() const { return welds_.size(); }
  const model::RigidWeld& weld(std::size_t i) const { return *welds_[i].source; }
  /// Of the joint that governs: the one that has failed or is nearer to it.
  const weld::RigidWeldHistory& history(std::size_t i) const;
  /// The same by index in Model::rigid_bodies; null where that body is no weld.
  const weld::RigidWeldHistory* history_of_body(model::Index body) const;
  /// Distance of the outermost nodes [length].
  double length(std::size_t i, const system::State& state) const;
  int failed() const { return failed_; }
  const std::vector<std::string>& events() const { return events_; }  ///< failures, a line each, for run.log

  /// See Components::elements_read.
  template <class Visit>
  void elements_read(const Visit& visit) const {
    for (const Weld& weld : welds_)
      for (const std::vector<Neighbour>& around : weld.around)
        for (const Neighbour& n : around) visit(system::System::ElementLocation{n.group, static_cast<int>(n.element)});
  }

  void archive(Archive& a);

 private:
  struct Load {
    Vec3d force, moment;
  };
  struct Neighbour {
    int group;
    std::size_t element;
  };
  /// A seam as it runs, beside its history in `joints`.
  struct SeamNow {
    const model::Seam* source;
    std::array<int, 2> nodes;  ///< system nodes
    Vec3d tension, normal;     ///< in body axes
    weld::RigidWeldLoad load;  ///< in this cycle
    void archive(Archive& a);
  };
  struct Weld {
    const model::RigidWeld* source;
    std::size_t body;                            ///< in System::bodies
    std::vector<int> nodes;                      ///< system nodes not yet released, in the weld's order
    std::vector<Load> loads;                     ///< on these nodes
    std::vector<std::vector<Neighbour>> around;  ///< elements at these nodes; only where plastic strain matters
    Vec3d axis;                                  ///< given one, in body axes; zero: the line of the outermost nodes
    /// Of a spot: at the first node; with more than two nodes, at the last one too. Of others: one a seam.
    std::vector<weld::RigidWeldHistory> joints;
    std::vector<SeamNow> seams;  ///< empty of a spot
    void archive(Archive& a);
  };

  void find_neighbours();
  void refuse_ties_on_failing_welds(Findings& findings) const;
  void add_joints(Weld& weld) const;
  Load force_on(const Weld& weld, std::size_t i, const system::State& state) const;
  weld::RigidWeldLoad joint_load(const Weld& weld, bool last, const system::State& state) const;
  weld::RigidWeldLoad seam_load(const Weld& weld, std::size_t j, const system::State& state) const;
  double plastic_strain(const Weld& weld, bool last, const system::State& state) const;
  double seam_strain(const Weld& weld, std::size_t j, const system::State& state) const;
  double largest_strain(const std::vector<Neighbour>& around, const system::State& state) const;
  bool update_spot(Weld& weld, system::State& state);
  bool update_seams(Weld& weld, system::State& state);
  void release(Weld& weld, bool first, bool last, system::State& state);
  bool release_unseamed(Weld& weld, system::State& state);
  void release_unmarked(Weld& weld, const std::vector<char>& holds, system::State& state);
  void report(const Weld& weld, const weld::RigidWeldHistory& joint, const std::string& where,
              const system::State& state);

  system::System& system_;
  std::vector<Weld> welds_;
  int failed_ = 0;
  std::vector<std::string> events_;
};

}  // namespace nugget::impact
