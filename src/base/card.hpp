// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <string_view>
#include <vector>

// The vocabulary in which the cards of a deck are described. A card is a table of fields; the reader, its checks, its
// messages, the unit and id offsets of *INCLUDE_TRANSFORM and `nugget keywords` all come from that one table.
namespace nugget {

/// Exponents of mass, length and time.
struct Dimension {
  signed char mass = 0, length = 0, time = 0;
  friend bool operator==(const Dimension&, const Dimension&) = default;
};

namespace dimension {
inline constexpr Dimension number{};
inline constexpr Dimension mass{1, 0, 0};
inline constexpr Dimension length{0, 1, 0};
inline constexpr Dimension time{0, 0, 1};
inline constexpr Dimension area{0, 2, 0};
inline constexpr Dimension volume{0, 3, 0};
inline constexpr Dimension density{1, -3, 0};
inline constexpr Dimension velocity{0, 1, -1};
inline constexpr Dimension acceleration{0, 1, -2};
inline constexpr Dimension rate{0, 0, -1};
inline constexpr Dimension force{1, 1, -2};
inline constexpr Dimension moment{1, 2, -2};
inline constexpr Dimension stress{1, -1, -2};
inline constexpr Dimension inertia{1, 2, 0};
inline constexpr Dimension second_moment{0, 4, 0};
inline constexpr Dimension mass_per_area{1, -2, 0};
inline constexpr Dimension mass_per_length{1, -1, 0};
}  // namespace dimension

/// The name spaces of ids; *INCLUDE_TRANSFORM has an offset for each.
enum class IdSpace { none, node, element, part, material, set, function, define, other };

enum class Kind { integer, real, text };

/// Allowed values, both ends included. A field whose only legal value is what this program computes says `only(v)`.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool holds(double v) const { return v >= low && v <= high; }
};
inline constexpr Range any_value{};
constexpr Range at_least(double low) {
  return {low, std::numeric_limits<double>::infinity()};
}
constexpr Range above_zero() {
  return {std::numeric_limits<double>::min(), std::numeric_limits<double>::infinity()};
}
constexpr Range between(double low, double high) {
  return {low, high};
}
constexpr Range only(double value) {
  return {value, value};
}

/// Marks a field that must be given.
inline constexpr double required = std::numeric_limits<double>::quiet_NaN();

/// One field of a card. A blank field takes `fallback`. `zero_is_default` says that a written 0 takes it too (LS-DYNA's
/// habit).
struct Field {
  std::string_view name;  ///< LS-DYNA's name in lower case; empty for an unused field
  Kind kind = Kind::real;
  Dimension dimension{};
  double fallback = 0.0;
  Range range{};
  std::string_view meaning;
  IdSpace id = IdSpace::none;  ///< of which name space the value is an id (a negative value is one too)
  int width = 10;              ///< columns in standard format
  bool zero_is_default = true;
  IdSpace negative = IdSpace::none;  ///< a negative value is no value but, without its sign, an id of this name space
};

// Makers, so that a table reads like the manual.
constexpr Field real(std::string_view name, Dimension d, double fallback, Range range, std::string_view meaning) {
  return {name, Kind::real, d, fallback, range, meaning, IdSpace::none, 10, true};
}
constexpr Field integer(std::string_view name, double fallback, Range range, std::string_view meaning) {
  return {name, Kind::integer, {}, fallback, range, meaning, IdSpace::none, 10, true};
}
constexpr Field id(std::string_view name, IdSpace space, double fallback, std::string_view meaning) {
  return {name, Kind::integer, {}, fallback, any_value, meaning, space, 10, true};
}
constexpr Field text(std::string_view name, int width, std::string_view meaning) {
  return {name, Kind::text, {}, 0.0, any_value, meaning, IdSpace::none, width, true};
}
constexpr Field unused(int width = 10) {
  return {{}, Kind::text, {}, 0.0, any_value, {}, IdSpace::none, width, true};
}
/// The same field with another number of columns.
constexpr Field wide(Field f, int width) {
  f.width = width;
  return f;
}

/// The same field, of which a negative value stands for an id: moved like one, and free of units.
constexpr Field or_negative(Field f, IdSpace space) {
  f.negative = space;
  return f;
}

struct Card {
  std::vector<Field> fields;
};

}  // namespace nugget
