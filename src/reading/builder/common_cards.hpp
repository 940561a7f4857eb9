// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <initializer_list>
#include <string_view>

#include "reading/builder/builder.hpp"

// What several families of cards read in the same way.
namespace nugget::reading {

/// The line in front of each definition with _TITLE.
extern const Card title_card;

/// A card with more fields behind those that several cards have alike.
template <class T>
CardOf<T> with_rest(CardOf<T> card, std::initializer_list<FieldOf<T>> rest) {
  for (const FieldOf<T>& field : rest) card.add(field);
  return card;
}

struct Heading {
  int id = 0;
  std::string text;
};
/// The card in front of each definition with _ID: a number and a heading.
extern const CardOf<Heading> heading_card;
/// Reads the heading where the options ask for one.
Heading read_heading(deck::Cursor& cursor, bool present);

/// Three numbers of a card as a position or a direction in the axes of the model: *INCLUDE_TRANSFORM is applied. Units
/// are the row's business.
Vec3d position(const deck::Block& block, const Vec3d& written);
Vec3d direction(const deck::Block& block, const Vec3d& written);

/// Of a file that *INCLUDE_TRANSFORM mirrors the model is the mirror image: what has a sense of turning, and what
/// depends on which hand axes have, is either turned by its reader or refused by this.
bool is_mirrored(const deck::Block& block);
/// +1, or -1 in a file that is mirrored: of what a cross product gives.
double hand(const deck::Block& block);
/// Refuses a field that is not 0 in a file that is mirrored.
void refuse_in_mirror(Builder& builder, const deck::Block& block, const deck::Entry& field, std::string_view text);
inline constexpr std::string_view turning_in_mirror =
    "a sense of turning is not known in a file that *INCLUDE_TRANSFORM mirrors";
inline constexpr std::string_view mirror_remedy = "write it in a file that is not mirrored";

/// The global axes of the file that the block stands in, as *INCLUDE_TRANSFORM turns them.
Frame3d axes_of_include(const deck::Block& block);

/// Codes of held directions (bits 0..5: x y z rx ry rz) that would be others in other axes.
bool depends_on_axes(unsigned fixed);
inline constexpr std::string_view global_codes_text =
    "holds along the global axes, also where *INCLUDE_TRANSFORM turns the file";
inline constexpr std::string_view global_codes_remedy =
    "name a coordinate system in the file: it turns with it; or write it in the main file";
/// A warning where such codes stand in a file that is turned.
void warn_of_turned_codes(Builder& builder, const deck::Block& block, const deck::Entry& field, unsigned fixed);
/// A warning where what acts along a global axis stands in a file that is turned.
void warn_of_global_axis(Builder& builder, const deck::Block& block, const deck::Entry& field);

/// A death time as it acts: 0 and the deck's various large numbers mean for ever.
double death_time(double written);

/// The id of a curve that a field below 0 (or_negative) gives with its sign turned; 0 from 0 on.
int curve_below_zero(double written);

/// A field that is obeyed at one value only.
struct Supported {
  deck::Entry field;
  double value;
  std::string_view otherwise;  ///< what happens instead, or what is missing
};
/// A finding for each of the fields that has another value.
void expect(Builder& builder, Severity severity, std::initializer_list<Supported> fields);

/// The nodes of all elements of the parts, ascending, each once.
std::vector<Index> nodes_of_parts(const Model& model, const std::vector<Index>& parts);

/// Sorted, each once.
void make_unique(std::vector<Index>& indices);

}  // namespace nugget::reading
