// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <type_traits>
#include <vector>

// Tables of rows as the columns that binout wants.
namespace nugget::output {

/// One member of each row.
template <class Rows, class Member>
auto extract_column(const Rows& rows, Member member) {
  std::vector<std::decay_t<decltype(member(rows.front()))>> values;
  values.reserve(rows.size());
  for (const auto& row : rows) values.push_back(member(row));
  return values;
}

/// Three names from one: `*_force` gives x_force, y_force, z_force.
inline std::string component_name(std::string name, char axis) {
  name[name.find('*')] = axis;
  return name;
}

/// Three columns of a table, one for each component of the vector that `member` picks. `put(name, values)` writes one.
template <class Rows, class Member, class Put>
void put_vectors(const std::string& name, const Rows& rows, Member member, Put put) {
  put(component_name(name, 'x'), extract_column(rows, [&](const auto& row) { return member(row).x; }));
  put(component_name(name, 'y'), extract_column(rows, [&](const auto& row) { return member(row).y; }));
  put(component_name(name, 'z'), extract_column(rows, [&](const auto& row) { return member(row).z; }));
}

}  // namespace nugget::output
