// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "base/card.hpp"
#include "base/vec3.hpp"
#include "output/ascii.hpp"

// A history file is described by one table of columns: binout, the lines of a regular ASCII file, units and meanings
// come from it.
namespace nugget {

namespace dimension {
inline constexpr Dimension energy = moment;
inline constexpr Dimension momentum{1, 1, -1};
inline constexpr Dimension mass_flow{1, 0, -1};
inline constexpr Dimension angle = number;  ///< [radian]
inline constexpr Dimension angular_acceleration{0, 0, -2};
}  // namespace dimension

namespace output {

/// Six components xx yy zz xy yz zx.
using Tensor = std::array<double, 6>;

/// What a column holds at one time: nothing, where it is left out; one number for all or one of each row; text.
using Values = std::variant<std::monostate, std::vector<int>, std::vector<double>, std::string>;

/// A column as the readers of a file see it.
struct ColumnMeaning {
  std::string branch;  ///< of binout
  std::string name;    ///< in that branch
  Dimension dimension;
  std::string_view meaning;
};

template <class State>
struct Column {
  std::string name;
  Dimension dimension;
  std::string_view meaning;
  bool of_rows = false;  ///< one number of each row, not one of the state
  std::function<Values(const State&)> values;
};

template <class State>
struct Columns : std::vector<Column<State>> {
  Columns() noexcept {}  // GCC 12 cannot make its own one for a Branch that names no columns
  /// Both, one after the other.
  Columns operator+(const Columns& others) const {
    Columns all = *this;
    all.insert(all.end(), others.begin(), others.end());
    return all;
  }
  /// The same, left out of a state that `condition` is false of.
  Columns where(bool (*condition)(const State&)) const {
    Columns some = *this;
    for (Column<State>& column : some)
      column.values = [values = column.values, condition](const State& state) {
        return condition(state) ? values(state) : Values{};
      };
    return some;
  }
};

// ---- what a column can be made of

template <class T>
inline constexpr int components_of = 1;
template <>
inline constexpr int components_of<Vec3d> = 3;
template <>
inline constexpr int components_of<Tensor> = 6;

template <class T>
auto component(const T& value, int) {
  if constexpr (std::is_same_v<T, double>)
    return value;
  else
    return static_cast<int>(value);  // counts, flags, LS-DYNA's numbers of kinds
}
inline double component(const Vec3d& value, int i) {
  return i == 0 ? value.x : i == 1 ? value.y : value.z;
}
inline double component(const Tensor& value, int i) {
  return value[i];
}

/// `*_force` gives x_force, y_force, z_force of a vector, sig_xx ... sig_zx come from `sig_*` of a tensor, and
/// `dircos_#1` gives dircos_11, dircos_21, dircos_31.
std::string component_name(std::string_view name, int component, int components);

template <class T>
Values values_of_state(const T& value) {
  if constexpr (std::is_same_v<T, Values>)
    return value;
  else if constexpr (std::is_convertible_v<T, std::string>)
    return std::string(value);
  else
    return std::vector{component(value, 0)};
}
template <class T>
Values values_of_state(const std::optional<T>& value) {
  return value ? values_of_state(*value) : Values{};
}

/// One line of a table of columns: its name in binout, what of a row or of the whole state it is (a member, or a
/// function of it), dimension and meaning. A vector or a tensor stands for a column of each component.
template <class State, class Row>
struct Quantity {
  template <class Pick>
  Quantity(std::string_view name, Pick pick, Dimension dimension, std::string_view meaning) {
    if constexpr (std::is_invocable_v<Pick, const Row&>) {
      using T = std::decay_t<std::invoke_result_t<Pick, const Row&>>;
      add<T>(name, dimension, meaning, true, [pick](int i) {
        return [pick, i](const State&, const std::vector<Row>& rows) -> Values {
          std::vector<decltype(component(std::declval<T>(), 0))> all;
          all.reserve(rows.size());
          for (const Row& row : rows) all.push_back(component(std::invoke(pick, row), i));
          return all;
        };
      });
    } else {
      using T = std::decay_t<std::invoke_result_t<Pick, const State&>>;
      add<T>(name, dimension, meaning, false, [pick](int i) {
        return [pick, i](const State& state, const std::vector<Row>&) -> Values {
          const T value = std::invoke(pick, state);
          if constexpr (1 < components_of<T>)
            return std::vector{component(value, i)};
          else
            return i == 0 ? values_of_state(value) : Values{};
        };
      });
    }
  }

  struct Part {
    std::string name;
    Dimension dimension;
    std::string_view meaning;
    bool of_rows;
    std::function<Values(const State&, const std::vector<Row>&)> values;
  };
  std::vector<Part> parts;

 private:
  template <class T, class Make>
  void add(std::string_view name, Dimension dimension, std::string_view meaning, bool of_rows, Make make) {
    for (int i = 0; i < components_of<T>; ++i)
      parts.push_back({component_name(name, i, components_of<T>), dimension, meaning, of_rows, make(i)});
  }
};

template <class State, class Row, class Rows>
Columns<State> columns_of(Rows rows, std::initializer_list<Quantity<State, Row>> quantities) {
  Columns<State> columns;
  for (const auto& quantity : quantities)
    for (const auto& part : quantity.parts)
      columns.push_back({part.name, part.dimension, part.meaning, part.of_rows,
                         [rows, values = part.values](const State& state) { return values(state, rows(state)); }});
  return columns;
}

/// Columns of a list of rows that the state holds, or of the state itself.
template <class State, class Row>
Columns<State> columns(std::vector<Row> State::*rows,
                       std::type_identity_t<std::initializer_list<Quantity<State, Row>>> quantities) {
  return columns_of<State, Row>([rows](const State& s) -> const std::vector<Row>& { return s.*rows; }, quantities);
}
/// Of rows that are put together from the state.
template <class State, class Row>
Columns<State> columns(std::vector<Row> (*rows)(const State&),
                       std::type_identity_t<std::initializer_list<Quantity<State, Row>>> quantities) {
  return columns_of<State, Row>(rows, quantities);
}
/// Of the state alone.
struct NoRow {};
template <class State>
Columns<State> columns(std::initializer_list<Quantity<State, NoRow>> quantities) {
  return columns_of<State, NoRow>([](const State&) { return std::vector<NoRow>{}; }, quantities);
}

/// User ids of the rows of a state.
template <class State>
using Ids = std::function<std::vector<int>(const State&)>;
template <class State, class Row>
Ids<State> ids(std::vector<Row> State::*rows, int Row::*id) {
  return [rows, id](const State& state) {
    std::vector<int> all;
    for (const Row& row : state.*rows) all.push_back(row.*id);
    return all;
  };
}

/// A branch of binout.
template <class State>
struct Branch {
  std::string path;
  Ids<State> ids{};       ///< of the rows, the same in every state; without it there are none
  Columns<State> once{};  ///< in the metadata, beside the ids
  Columns<State> columns{};
  bool (*written)(const State&) = nullptr;  ///< in states of which it is true; without it in all
  bool lists_ids = true;                    ///< in the metadata

  bool is_in(const State& state) const { return !written || written(state); }
  std::vector<int> ids_in(const State& state) const { return ids ? ids(state) : std::vector<int>{}; }
};

/// A regular ASCII file: text in which `{name:format}` stands for a column of the first branch, `{id}` for the id of a
/// row. `row` is printed for each row; `head` and `tail` stand around them and have columns of the whole state only.
struct Lines {
  std::string_view head, row, tail;
};

/// Which lines stand between the title of an ASCII file and its first state.
enum class LegendLines {
  none,
  empty,   ///< LS-DYNA's two empty lines, where a file can have no legend
  titles,  ///< headings of the deck; without any the two empty lines
};

/// All that is to be said of one history file.
template <class State>
struct HistoryFormat {
  std::vector<Branch<State>> branches;
  LegendLines legend = LegendLines::none;
  std::string_view heading{};                         ///< of the ASCII file, after the legend
  Lines lines{};                                      ///< of each state, or
  void (*print)(AsciiFile&, const State&) = nullptr;  ///< where lines alone do not do
  bool tables_apart = false;  ///< a symbol table of binout for each branch, not one of the state
};

template <class State>
std::vector<ColumnMeaning> meanings(const HistoryFormat<State>& format) {
  std::vector<ColumnMeaning> all;
  for (const Branch<State>& branch : format.branches)
    for (const Columns<State>& part : {branch.once, branch.columns})
      for (const Column<State>& c : part) all.push_back({branch.path, c.name, c.dimension, c.meaning});
  return all;
}

/// The values of one column.
struct Cells {
  const std::string& name;
  bool of_rows;
  Values values;
};
void print_lines(AsciiFile& file, const Lines& lines, const std::vector<int>& ids, const std::vector<Cells>& columns);

/// The ASCII file of a history.
template <class State>
class AsciiHistory {
 public:
  AsciiHistory(const HistoryFormat<State>& format, std::filesystem::path path, const Header& header,
               std::span<const LegendEntry> legend = {})
      : format_(format), file_(std::move(path), header, head(format, legend)) {}

  void write(const State& state) {
    if (format_.print) {
      format_.print(file_, state);
    } else {
      const Branch<State>& branch = format_.branches.front();
      std::vector<Cells> cells;
      for (const Columns<State>* part : {&branch.once, &branch.columns})
        for (const Column<State>& c : *part) cells.push_back({c.name, c.of_rows, c.values(state)});
      print_lines(file_, format_.lines, branch.ids_in(state), cells);
    }
    file_.end_state();
  }
  /// A state that is printed by parts (AsciiFile::end_part).
  template <class Print>
  void write_by(const Print& print_state) {
    print_state(file_);
    file_.end_state();
  }
  void archive(Archive& a) {
    a(file_);
    a.built(format_);
  }

 private:
  static std::string head(const HistoryFormat<State>& format, std::span<const LegendEntry> legend) {
    std::string heading(format.heading);
    switch (format.legend) {
      case LegendLines::none: return heading;
      case LegendLines::empty: return legend_lines({}) + heading;
      case LegendLines::titles: return legend_lines(legend) + heading;
    }
    return heading;
  }

  const HistoryFormat<State>& format_;
  AsciiFile file_;
};

}  // namespace output
}  // namespace nugget
