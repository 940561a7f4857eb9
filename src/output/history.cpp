// SPDX-License-Identifier: Apache-2.0
#include "output/history.hpp"

#include <fmt/args.h>

#include <iterator>

#include "base/index.hpp"

namespace nugget::output {
namespace {

using Store = fmt::dynamic_format_arg_store<fmt::format_context>;

void put(Store& store, const std::string& name, const Values& values, std::size_t row) {
  if (const auto* reals = std::get_if<std::vector<double>>(&values))
    store.push_back(fmt::arg(name.c_str(), column(reals->at(row))));
  else if (const auto* integers = std::get_if<std::vector<int>>(&values))
    store.push_back(fmt::arg(name.c_str(), integers->at(row)));
}

}  // namespace

std::string component_name(std::string_view name, int component, int components) {
  static constexpr std::array<std::string_view, 3> axes{"x", "y", "z"}, numbers{"1", "2", "3"};
  static constexpr std::array<std::string_view, 6> pairs{"xx", "yy", "zz", "xy", "yz", "zx"};
  std::string full(name);
  const auto i = at(component);
  if (const std::size_t place = full.find('*'); place != full.npos)
    full.replace(place, 1, components == 6 ? pairs[i] : axes[i]);
  else if (const std::size_t hash = full.find('#'); hash != full.npos)
    full.replace(hash, 1, numbers[i]);
  return full;
}

void print_lines(AsciiFile& file, const Lines& lines, const std::vector<int>& ids, const std::vector<Cells>& columns) {
  Store of_state;
  for (const Cells& column : columns)
    if (!column.of_rows) put(of_state, column.name, column.values, 0);
  file.print_text(fmt::vformat(lines.head, of_state));
  for (std::size_t row = 0; row < ids.size(); ++row) {
    Store of_row;
    of_row.push_back(fmt::arg("id", ids[row]));
    for (const Cells& column : columns) put(of_row, column.name, column.values, column.of_rows ? row : 0);
    file.print_text(fmt::vformat(lines.row, of_row));
  }
  file.print_text(fmt::vformat(lines.tail, of_state));
}

}  // namespace nugget::output
