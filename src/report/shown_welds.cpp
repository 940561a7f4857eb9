// SPDX-License-Identifier: Apache-2.0
#include "report/shown_welds.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <map>
#include <sstream>

#include "report/weld_page.hpp"

namespace nugget::report {

Vec3d middle_of(const std::vector<std::size_t>& nodes, const std::vector<Vec3d>& x) {
  Vec3d middle;
  for (const std::size_t node : nodes) middle += 1.0 / static_cast<double>(nodes.size()) * x[node];
  return middle;
}

std::vector<ShownWeld> shown_welds(const RunData& run, const output::D3plotGeometry& geometry) {
  std::map<int, std::size_t> place;
  for (std::size_t i = 0; i < geometry.node_ids.size(); ++i) place[geometry.node_ids[i]] = i;
  const auto add = [&](int node, std::vector<std::size_t>& nodes) {
    if (const auto found = place.find(node); found != place.end()) nodes.push_back(found->second);
  };
  std::vector<ShownWeld> welds;
  for (const WeldRow& row : run.welds) {
    const auto number = [&](const char* column) { return std::strtod(cell(row, column).c_str(), nullptr); };
    ShownWeld weld;
    weld.id = std::atoi(cell(row, "id").c_str());
    weld.diameter = number("diameter");
    weld.tied = cell(row, "tied") == "yes";
    weld.failed = cell(row, "failed") == "yes";
    weld.failure_time = number("failure_time");
    weld.peak_failure = number("peak_failure");
    weld.peak_failure_time = number("peak_failure_time");
    if (!cell(row, "damage").empty()) weld.damage = number("damage");
    const auto belongs_to = [&](const std::string& part) {
      if (!part.empty()) weld.parts.push_back(std::atoi(part.c_str()));
      return !part.empty();
    };
    belongs_to(cell(row, "part"));
    for (int sheet = 1; belongs_to(cell(row, fmt::format("sheet{}", sheet)));) ++sheet;
    for (int end = 1;; ++end) {
      const std::string node = cell(row, fmt::format("node{}", end));
      if (node.empty()) break;
      add(std::atoi(node.c_str()), weld.nodes);
    }
    std::istringstream segment(cell(row, "segment1"));
    for (int node = 0; segment >> node;) add(node, weld.segment);
    if (!weld.nodes.empty()) welds.push_back(std::move(weld));
  }
  return welds;
}

}  // namespace nugget::report
