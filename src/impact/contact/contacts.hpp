// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "contact/penalty_contact.hpp"
#include "impact/energy/energy.hpp"
#include "system/partition.hpp"
#include "system/system.hpp"

namespace nugget::impact {

/// The *CONTACT_... of a run that slide, separate or are glued, in the order of the deck.
class Contacts {
 public:
  /// `x`: places at the start, initial penetrations resolved; what is left of them is kept and gives no force [length].
  /// An error where a contact has no segments. Where elements of `system`, which must outlive it, get their states with
  /// the share, so do contacts their segments, as far as nothing looks at the whole surface (docs/decisions/0141).
  Contacts(const system::System& system, std::span<const Row> x, Findings& findings);

  /// Adds the forces of this step, of those contacts that `state` says are turned on.
  void apply(const contact::Step& step, const system::State& state, std::span<Row> force);
  /// Elements were deleted. `faces`: shells or bricks among them.
  void elements_deleted(bool faces);

  const std::vector<contact::PenaltyContact>& all() const { return contacts_; }
  /// Whether some contact presses or holds a node, by its position.
  bool presses(int node) const {
    return std::any_of(contacts_.begin(), contacts_.end(),
                       [node](const contact::PenaltyContact& c) { return c.presses(node); });
  }
  /// How many nodes the glue of each contact held and lost, a line each.
  std::vector<std::string> glue_summary(const system::System& system) const;

  /// What became of the energy that they took, of all together.
  contact::ContactEnergies energies() const;
  /// Of each contact that dropped springs under load: how many, what they held, and which held most, a line each.
  std::vector<std::string> drop_summary(const system::System& system) const;

  /// The contact that took least, by name.
  std::string giving_most(const system::System& system) const;

  void add_energy(Energy& energy) const;
  /// Adds what the contacts cost that act at the start, see contact::SurfaceContact::add_costs.
  void add_costs(std::span<const Row> x, system::ContactCosts& costs, Ranks* ranks) {
    for (std::size_t c = 0; c < contacts_.size(); ++c) contacts_[c].add_costs(x, costs, ranks, source(c));
  }
  /// Adds what they cost by now, see contact::SurfaceContact::add_costs_now.
  void add_costs_now(system::ContactCosts& costs, Ranks* ranks) const {
    for (const contact::PenaltyContact& c : contacts_) c.add_costs_now(system_->all_nodes(), costs, ranks);
  }
  /// Over several ranks: see contact::SurfaceContact::take_share.
  void take_share(const contact::SharedNodes& shared) {
    for (std::size_t c = 0; c < contacts_.size(); ++c) contacts_[c].take_share(shared, source(c));
  }
  /// Over several ranks: see contact::SurfaceContact::carry.
  void carry(system::Carried what, const system::System::Computed& of, system::Parcel& parcel) {
    for (contact::PenaltyContact& contact : contacts_) contact.carry(of.rank, what, parcel);
  }
  void archive(Archive& a) {
    a(contacts_);
    a.built(control_, card_, system_);
  }

 private:
  /// Of contact `c`, for what it was made without.
  contact::SurfaceSource source(std::size_t c) const;

  const system::System* system_;
  std::vector<contact::PenaltyContact> contacts_;
  std::vector<model::Index> control_;        ///< *SENSOR_CONTROL of each
  std::vector<const model::Contact*> card_;  ///< of each
};

}  // namespace nugget::impact
