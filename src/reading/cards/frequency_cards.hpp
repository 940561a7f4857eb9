// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include "reading/builder/common_cards.hpp"

// What the cards of *FREQUENCY_DOMAIN_FRF and _SSD have in common.
namespace nugget::reading {

/// A number whose 0 has a meaning of its own beside the default.
constexpr Field zero_counts(Field f) {
  f.zero_is_default = false;
  return f;
}

/// What a value of VAD means; the two keywords number them differently.
struct Driven {
  FrequencyResponse::Excitation::Kind kind;
  FrequencyResponse::Quantity quantity = FrequencyResponse::Quantity::displacement;
  bool turning = false;
};

/// Names of an excitation's fields.
struct ExcitationFields {
  std::string_view entity, type, direction, kind, vector;
};

/// What is driven, and where. An entity that is not built or a set without members is refused.
FrequencyResponse::Excitation excitation_of(Builder& builder, const deck::Row& row, const ExcitationFields& fields,
                                            const Driven& driven);

/// Nodes of a node or a node set, which must not be empty.
std::vector<Index> nodes_of(Builder& builder, const deck::Row& row, std::string_view entity, std::string_view type);
/// A unit vector: axis 1, 2, 3, or else that of *DEFINE_VECTOR.
Vec3d direction_of(Builder& builder, const deck::Row& row, std::string_view axis, std::string_view vector);

/// The fields FMIN to LCFREQ, which several cards have; `rest` follows them.
Card frequency_card(std::initializer_list<Field> rest = {});
/// What they ask for.
Frequencies frequencies_of(Builder& builder, const deck::Row& row);
FrequencyResponse::Selection selection_of(Builder& builder, const deck::Row& row);
FrequencyResponse::Damping damping_of(Builder& builder, const deck::Row& row);

/// A warning where nothing damps. `row`: the card of the damping.
void check_damped(Builder& builder, const deck::Row& row, const FrequencyResponse::Damping& damping);

/// What only the whole model shows: whether the analysis runs, whether there is a base to move. `field`: where findings
/// stand. `modal`: by modes, which must be the lowest ones.
void check_analysis(Builder& builder, const deck::Row& row, std::string_view field, bool modal);
void check_excitation(Builder& builder, const deck::Row& row, std::string_view field,
                      const FrequencyResponse::Excitation& excitation);

}  // namespace nugget::reading
