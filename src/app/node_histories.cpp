// SPDX-License-Identifier: Apache-2.0
#include "app/node_histories.hpp"

#include <cstdlib>
#include <fstream>
#include <string>

namespace nugget::app {
namespace {

constexpr std::size_t id_columns = 10, number_columns = 12, numbers = 12;  // of a line of nodout

/// Three numbers of a line of nodout from the `first` one on.
Vec3d vector_of(const std::string& line, std::size_t first) {
  const auto number = [&](std::size_t i) {
    return std::strtod(line.substr(id_columns + (first + i) * number_columns, number_columns).c_str(), nullptr);
  };
  return {number(0), number(1), number(2)};
}

}  // namespace

std::map<int, NodeHistory> read_node_histories(const std::filesystem::path& folder) {
  std::map<int, NodeHistory> histories;
  std::ifstream file(folder / "nodout");
  constexpr const char* head = "( at time";
  double time = 0.0;
  bool places = false;  // else the table of rotations of the same time
  for (std::string line; std::getline(file, line);) {
    if (const std::size_t at = line.find(head); at != std::string::npos)
      time = std::strtod(line.c_str() + at + std::char_traits<char>::length(head), nullptr);
    if (line.find("nodal point") != std::string::npos) places = line.find("x-coor") != std::string::npos;
    if (!places || line.size() < id_columns + numbers * number_columns) continue;
    const int node = std::atoi(line.substr(0, id_columns).c_str());
    if (node == 0) continue;  // the head of the columns
    NodeHistory& history = histories[node];
    history.time.push_back(time);
    history.displacement.push_back(vector_of(line, 0));
    history.place.push_back(vector_of(line, 9));
  }
  return histories;
}

}  // namespace nugget::app
