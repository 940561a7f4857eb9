// SPDX-License-Identifier: Apache-2.0
#include "app/without_part.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace nugget::app {

void note_what_takes_no_part(const model::Model& model, bool statics_first, Findings& findings) {
  std::vector<std::string> list;
  const auto add = [&](std::size_t count, const char* one, const char* several) {
    if (count > 0) list.push_back(fmt::format("{} {}", count, count == 1 ? one : several));
  };
  const auto sliding =
      std::count_if(model.contacts.begin(), model.contacts.end(), [](const model::Contact& c) { return c.slides(); });
  add(static_cast<std::size_t>(sliding), "contact", "contacts");
  add(model.walls.size(), "rigid wall", "rigid walls");
  add(model.body_stoppers.size(), "stop of a rigid body", "stops of rigid bodies");
  std::size_t loads = 0;
  model::for_each_load(model, [&]<class Load>(const Load&) { ++loads; });
  loads -= model.control_volumes.size();  // of these linear_model warns
  if (!statics_first) add(loads, "load over time", "loads over time");
  if (!model.initial_velocity.empty() || !model.initial_spin.empty()) list.emplace_back("initial velocities");
  if (list.empty()) return;
  findings.note({model.deck, 0, 0}, "",
                fmt::format("modes and responses over frequency are those of the structure at rest: {} take{} no part",
                            fmt::join(list, ", "), list.size() == 1 && list.front().starts_with("1 ") ? "s" : ""));
}

}  // namespace nugget::app
