// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "output/history_reader.hpp"

namespace nugget::output {

/// Collects what a reader of history files meets, state by state, into channels.
class HistorySamples {
 public:
  explicit HistorySamples(std::string file) { record_.file = std::move(file); }

  void begin_state(double time) {
    fill();
    record_.times.push_back(time);
  }
  double time() const { return record_.times.empty() ? 0.0 : record_.times.back(); }
  bool empty() const { return record_.times.empty(); }

  /// Whether this state has a value of it already, so that the next one belongs to another state.
  bool has(const std::string& entity, std::string_view quantity) const {
    const auto found = place_.find({entity, std::string(quantity)});
    return found != place_.end() && record_.channels[found->second].values.size() == record_.times.size();
  }

  void put(const std::string& entity, std::string_view quantity, double value) {
    if (record_.times.empty()) return;
    const auto [found, is_new] = place_.try_emplace({entity, std::string(quantity)}, record_.channels.size());
    if (is_new) record_.channels.push_back({entity, {}, std::string(quantity), {}, {}});
    Channel& channel = record_.channels[found->second];
    channel.values.resize(record_.times.size(), 0.0);
    channel.values.back() = value;
  }

  HistoryRecord take() {
    fill();
    return std::move(record_);
  }

 private:
  void fill() {
    for (Channel& channel : record_.channels) channel.values.resize(record_.times.size(), 0.0);
  }

  HistoryRecord record_;
  std::map<std::pair<std::string, std::string>, std::size_t> place_;
};

}  // namespace nugget::output
