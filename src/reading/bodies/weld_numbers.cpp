// SPDX-License-Identifier: Apache-2.0
#include "reading/bodies/weld_numbers.hpp"

#include <fmt/format.h>

#include <string>
#include <unordered_map>

namespace nugget::reading {
namespace {

/// Which numbers are whose, by the words for messages.
class TakenNumbers {
 public:
  explicit TakenNumbers(const Model& model) {
    const auto is_weld = [&](Index part) {
      return model.parts[part].material != none && model.materials[model.parts[part].material].weld != none;
    };
    for (std::size_t e = 0; e < model.beams.size(); ++e)
      if (is_weld(model.beams.part[e])) take(model.beams.id[e], "a weld beam");
    for (std::size_t e = 0; e < model.solids.size(); ++e)
      if (is_weld(model.solids.part[e])) take(model.solids.id[e], "a brick of a weld");
    for (const model::HexAssembly& assembly : model.hex_assemblies) take(assembly.id, "an assembly of weld bricks");
  }

  /// What has the number already; null: nothing, and now `owner` has it.
  const char* take(int number, const char* owner) {
    const auto [at, is_new] = owner_.emplace(number, owner);
    return is_new ? nullptr : at->second;
  }
  /// The first free number from `from` on, for `owner`.
  int next(int from, const char* owner) {
    while (take(from, owner)) ++from;
    return from;
  }

 private:
  std::unordered_map<int, const char*> owner_;
};

void take_given(Builder& b, TakenNumbers& taken, const RigidWeld& weld, const char* keyword, const char* owner) {
  if (const char* other = taken.take(weld.id, owner))
    b.findings.warning(weld.place, keyword,
                       fmt::format("{} has the number {}, which {} has, too: tables, pictures and options call both "
                                   "weld {}",
                                   owner, weld.id, other, weld.id),
                       "give it another number");
}

}  // namespace

void number_rigid_welds(Builder& builder) {
  TakenNumbers taken(builder.model);
  constexpr const char* owner = "a rigid weld";
  for (const BodyCards::Weld& card : builder.body_cards.welds)
    if (card.weld.id != 0) take_given(builder, taken, card.weld, "CONSTRAINED_..._WELD", owner);
  for (const RigidBody& body : builder.model.rigid_bodies)  // which may be welds
    if (body.origin == RigidBody::Origin::nodal) taken.take(body.id, "a nodal rigid body");
  int place = 0;
  for (BodyCards::Weld& card : builder.body_cards.welds) {
    ++place;
    if (card.weld.id == 0) card.weld.id = taken.next(place, owner);
  }
}

void number_rivets(Builder& builder) {
  TakenNumbers taken(builder.model);
  constexpr const char* owner = "a rivet";
  for (const RigidWeld& weld : builder.model.rigid_welds)
    if (weld.kind != RigidWeld::Kind::rivet)
      taken.take(weld.id, "a rigid weld");
    else if (weld.id != 0)
      take_given(builder, taken, weld, "CONSTRAINED_RIVET", owner);
  int place = 0;
  for (RigidWeld& weld : builder.model.rigid_welds) {
    if (weld.kind != RigidWeld::Kind::rivet) continue;
    ++place;
    if (weld.id == 0) weld.id = taken.next(place, owner);
  }
}

}  // namespace nugget::reading
