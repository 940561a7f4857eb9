// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

// The vocabulary in which the cards of a deck are described. A card is a table of fields, each bound to the member of a
// struct that takes its value; the reader, its checks, its messages, the unit and id offsets of *INCLUDE_TRANSFORM and
// `nugget keywords` all come from that one table.
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
inline constexpr Dimension force_per_length{1, 0, -2};
inline constexpr Dimension damping_constant{1, 0, -1};
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

/// As what a field's value is written to the member that it is bound to.
enum class Store : unsigned char { nowhere, real, integer, flag, text };

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
  Store store = Store::nowhere;      ///< nowhere: the field is checked, and no more is made of it
  std::ptrdiff_t offset = 0;         ///< of the member, in bytes from the beginning of its struct
};

/// A field whose kind is known to the compiler, so that it is bound to a member of that kind only.
template <Kind kind_of_value>
struct FieldOfKind : Field {};
using RealField = FieldOfKind<Kind::real>;
using IntegerField = FieldOfKind<Kind::integer>;
using TextField = FieldOfKind<Kind::text>;

// Makers, so that a table reads like the manual. Called, not inlined: a folder's tables are made by one function before
// main, which took the compiler long and is run once.
[[gnu::noinline]] constexpr RealField real(std::string_view name, Dimension d, double fallback, Range range,
                                           std::string_view meaning) {
  return {{name, Kind::real, d, fallback, range, meaning, IdSpace::none, 10, true}};
}
[[gnu::noinline]] constexpr IntegerField integer(std::string_view name, double fallback, Range range,
                                                 std::string_view meaning) {
  return {{name, Kind::integer, {}, fallback, range, meaning, IdSpace::none, 10, true}};
}
[[gnu::noinline]] constexpr IntegerField id(std::string_view name, IdSpace space, double fallback,
                                            std::string_view meaning) {
  return {{name, Kind::integer, {}, fallback, any_value, meaning, space, 10, true}};
}
[[gnu::noinline]] constexpr TextField text(std::string_view name, int width, std::string_view meaning) {
  return {{name, Kind::text, {}, 0.0, any_value, meaning, IdSpace::none, width, true}};
}
constexpr Field unused(int width = 10) {
  return {{}, Kind::text, {}, 0.0, any_value, {}, IdSpace::none, width, true};
}
/// The same field with another number of columns.
template <class AnyField>
[[gnu::noinline]] constexpr AnyField wide(AnyField f, int width) {
  f.width = width;
  return f;
}

/// The same field, of which a negative value stands for an id: moved like one, and free of units.
template <class AnyField>
[[gnu::noinline]] constexpr AnyField or_negative(AnyField f, IdSpace space) {
  f.negative = space;
  return f;
}

/// The same field with other values allowed.
template <class AnyField>
[[gnu::noinline]] constexpr AnyField within_range(AnyField f, Range range) {
  f.range = range;
  return f;
}

struct Card {
  std::vector<Field> fields;
};

/// Bytes from the beginning of a T to a member. A pointer to a data member is just that (Itanium C++ ABI, 2.3.1, which
/// GCC and Clang follow).
template <class T, class V>
std::ptrdiff_t offset_of(V T::*member) {
  static_assert(sizeof(member) == sizeof(std::ptrdiff_t));
  return std::bit_cast<std::ptrdiff_t>(member);
}
/// Component `i` of an array that is a member, as if it were a member itself.
template <class T, class V, std::size_t n>
V T::*at(std::array<V, n> T::*list, std::size_t i) {
  return std::bit_cast<V T::*>(offset_of(list) + static_cast<std::ptrdiff_t>(i * sizeof(V)));
}
/// A member of a struct that is a member, likewise.
template <class T, class S, class V>
V T::*within(S T::*outer, V S::*inner) {
  return std::bit_cast<V T::*>(offset_of(outer) + offset_of(inner));
}

/// A field and the place that takes its value. Called like the makers above, and for the same reason.
struct BoundField : Field {
 protected:
  BoundField(const Field& field, Store as, std::ptrdiff_t bytes);
};

/// A field and the member of T that takes its value. A real stands in a double, a whole number or an id in an int, a
/// bool (not 0) or an enumeration, a text in a string; else the table does not compile.
template <class T>
struct FieldOf : BoundField {
  FieldOf(const Field& unbound) : BoundField(unbound, Store::nowhere, 0) {}
  FieldOf(double T::*member, const RealField& field) : BoundField(field, Store::real, offset_of(member)) {}
  FieldOf(int T::*member, const IntegerField& field) : BoundField(field, Store::integer, offset_of(member)) {}
  FieldOf(bool T::*member, const IntegerField& field) : BoundField(field, Store::flag, offset_of(member)) {}
  FieldOf(std::string T::*member, const TextField& field) : BoundField(field, Store::text, offset_of(member)) {}
  template <class Choice, class Base>
  requires std::is_enum_v<Choice> &&(sizeof(Choice) == sizeof(int)) &&
      std::is_base_of_v<Base, T> FieldOf(Choice Base::*member, const IntegerField& field)
      : BoundField(field, Store::integer, offset_of<T, Choice>(member)) {}
};

/// Puts fields behind those of the card.
void append(Card& card, const Field* fields, std::size_t count);

/// A card whose fields are bound to members of T:
///     const CardOf<Hourglass> hourglass_card{
///         {&Hourglass::type, integer("ihq", 0, between(0, 10), "type")},
///         unused(),
///     };
template <class T>
struct CardOf : Card {
  CardOf() = default;
  CardOf(std::initializer_list<FieldOf<T>> table) {
    static_assert(sizeof(FieldOf<T>) == sizeof(Field));
    append(*this, table.begin(), table.size());
  }
  void add(const FieldOf<T>& field) { append(*this, &field, 1); }
  /// Puts the fields of a member's own card behind those of the card.
  template <class Inner>
  void add(Inner T::*member, const CardOf<Inner>& card) {
    for (Field field : card.fields) {
      field.offset += offset_of(member);
      append(*this, &field, 1);
    }
  }
};

}  // namespace nugget
