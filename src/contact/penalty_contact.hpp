// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "base/archive.hpp"
#include "contact/edge_contact.hpp"
#include "contact/glue.hpp"
#include "contact/surface_contact.hpp"

namespace nugget::contact {

/// What a penalty *CONTACT does: nodes against segments, and where it asks for that, edges against edges, or glue that
/// holds nodes until it fails.
class PenaltyContact {
 public:
  /// `x`: initial coordinates.
  PenaltyContact(SurfaceContactSetup surface, std::optional<EdgeContactSetup> edges, std::optional<model::Glue> glue,
                 std::span<const Row> x);

  /// See SurfaceContact::apply.
  void apply(const Step& step, std::span<Row> force);
  /// See SurfaceContact::add_costs.
  void add_costs(std::span<const Row> x, system::ContactCosts& costs, Ranks* ranks, const SurfaceSource& source) {
    surface_.add_costs(x, costs, ranks, source);
  }
  /// See SurfaceContact::add_costs_now.
  void add_costs_now(std::size_t nodes, system::ContactCosts& costs, Ranks* ranks) const {
    surface_.add_costs_now(nodes, costs, ranks);
  }
  /// See SurfaceContact::take_share.
  void take_share(const SharedNodes& shared, const SurfaceSource& source) { surface_.take_share(shared, source); }
  /// See SurfaceContact::carry.
  void carry(int rank, system::Carried what, system::Parcel& parcel) { surface_.carry(rank, what, parcel); }
  /// See SurfaceContact::keep_hits_for_results.
  void keep_hits_for_results() { surface_.keep_hits_for_results(); }
  /// Calls `visit` with each node that it can press.
  template <class Visit>
  void each_node(const Visit& visit) const {
    for (const int node : surface_.nodes()) visit(node);
    if (!edges_) return;
    for (const int node : edges_->nodes()) visit(node);
  }
  /// The same with the side of each: 0 the tracked one, which has nodes of both, 1 the reference side. A node may come
  /// twice.
  template <class Visit>
  void each_node_of_sides(const Visit& visit) const {
    for (const int node : surface_.nodes()) visit(node, surface_.side(node));
    if (!edges_) return;
    for (const int node : edges_->nodes()) visit(node, edges_->side(node));
  }
  /// Lets all of several ranks follow all its nodes, as glue and edges do, which are computed by each of them.
  void look_everywhere() { surface_.look_everywhere(); }
  bool looks_everywhere() const { return surface_.looks_everywhere(); }
  /// Elements were deleted. `faces`: shells or bricks among them.
  void elements_deleted(bool faces);

  double energy() const;  ///< see SurfaceContact::energy
  std::array<double, 2> energy_of_sides() const;
  ContactEnergies energies() const;  ///< see SurfaceContact::energies; of glue friction alone
  Vec3d resultant() const;           ///< see SurfaceContact::resultant
  Vec3d resultant_of_all_ranks() const;
  bool presses(int node) const;  ///< a force of this cycle acts on the node
  Vec3d force_on(std::span<const unsigned char> marked) const;
  Vec3d force_on(int node) const;  ///< over several ranks where look_everywhere() was asked for [force]
  Vec3d force_between(const TwoBodies& bodies) const;  ///< see SurfaceContact::force_between
  const SurfaceContact& surface() const { return surface_; }
  const Glue* glue() const { return glue_.get(); }

  void archive(Archive& a);

 private:
  Vec3d with_edges_and_glue(Vec3d sum) const;

  bool can_expose_faces_ = false;  // deleted elements expose faces or edges
  SurfaceContact surface_;
  std::optional<EdgeContact> edges_;
  std::unique_ptr<Glue> glue_;
};

}  // namespace nugget::contact
