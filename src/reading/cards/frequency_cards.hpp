// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include "reading/builder/common_cards.hpp"

// What the cards of *FREQUENCY_DOMAIN_FRF and _SSD have in common.
namespace nugget::reading {

/// A number whose 0 has a meaning of its own beside the default.
template <class AnyField>
constexpr AnyField zero_counts(AnyField f) {
  f.zero_is_default = false;
  return f;
}

/// What a value of VAD means; the two keywords number them differently.
struct Driven {
  FrequencyResponse::Excitation::Kind kind;
  FrequencyResponse::Quantity quantity = FrequencyResponse::Quantity::displacement;
  bool turning = false;
};

/// Modes that take part (FNMAX, MDMIN, MDMAX), on whichever card they stand.
struct SelectionCard {
  double fnmax = 0;
  int mdmin = 0, mdmax = 0;
};
/// A load: N1 N1TYP DOF1 VAD1 VID1 of *FREQUENCY_DOMAIN_FRF, NID NTYP DOF VAD VID of _SSD.
struct ExcitationCard : SelectionCard {
  int entity = 0, type = 0, direction = 0, vad = 0, vector = 0;
  int lc1 = 0, lc2 = 0;  // of _SSD
  double sf = 0;
};
struct DampingCard {
  double dampf = 0, dmpmas = 0, dmpstf = 0;
  int lcdam = 0, lctyp = 0, dmpflg = 0;
};
struct FrequencyCard {
  double fmin = 0, fmax = 0;
  int nfreq = 0, fspace = 0, lcfreq = 0;
  int restrt = 0, output = 0;  // of FRF
};

/// What is driven, and where. An entity that is not built or a set without members is refused.
FrequencyResponse::Excitation excitation_of(Builder& builder, const deck::RowOf<ExcitationCard>& row,
                                            const Driven& driven);

/// Nodes of a node (type 0) or a node set (1), which must not be empty.
std::vector<Index> nodes_of(Builder& builder, const deck::Entry& entity, int type);
/// A unit vector: axis 1, 2, 3, or else that of *DEFINE_VECTOR.
Vec3d direction_of(Builder& builder, const deck::Entry& axis, const deck::Entry& vector);

/// The fields DAMPF to DMPSTF; `rest` follows them.
CardOf<DampingCard> damping_card_of_response(std::initializer_list<FieldOf<DampingCard>> rest = {});

/// The fields FMIN to LCFREQ, which several cards have; `rest` follows them.
CardOf<FrequencyCard> frequency_card(std::initializer_list<FieldOf<FrequencyCard>> rest = {});
/// What they ask for.
Frequencies frequencies_of(Builder& builder, const deck::RowOf<FrequencyCard>& row);
/// `mdmax`: its field.
FrequencyResponse::Selection selection_of(Builder& builder, const SelectionCard& card, const deck::Entry& mdmax);
FrequencyResponse::Damping damping_of(Builder& builder, const deck::RowOf<DampingCard>& row);

/// A warning where nothing damps. `dampf`: its field.
void check_damped(Builder& builder, const deck::Entry& dampf, const FrequencyResponse::Damping& damping);

/// What only the whole model shows: whether the analysis runs, whether there is a base to move. `mdmin`, `field`: where
/// findings stand. `modal`: by modes, which must be the lowest ones, and as many as the selection begins with.
void check_analysis(Builder& builder, const deck::Entry& mdmin, bool modal,
                    const FrequencyResponse::Selection& selection);
void check_excitation(Builder& builder, const deck::Entry& field, const FrequencyResponse::Excitation& excitation);

}  // namespace nugget::reading
