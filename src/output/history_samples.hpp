// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <map>
#include <set>
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
    if (!record_.times.empty()) put(place(entity, quantity), value);
  }
  /// The same for those who keep the place() of a channel.
  void put(std::size_t place, double value) {
    Channel& channel = record_.channels[place];
    channel.values.resize(record_.times.size(), 0.0);
    channel.values.back() = value;
  }
  std::size_t place(const std::string& entity, std::string_view quantity) {
    const auto [found, is_new] = place_.try_emplace({entity, std::string(quantity)}, record_.channels.size());
    if (is_new) record_.channels.push_back({entity, {}, std::string(quantity), {}, {}});
    return found->second;
  }

  /// Without a last state that lacks entities of the one before it: it was cut off.
  HistoryRecord take() {
    if (is_cut_off()) drop_last();
    fill();
    return std::move(record_);
  }

 private:
  bool is_cut_off() const {
    std::set<std::string> before, last;
    for (const Channel& channel : record_.channels) {
      if (channel.values.size() + 1 >= record_.times.size()) before.insert(channel.entity);
      if (channel.values.size() == record_.times.size()) last.insert(channel.entity);
    }
    return record_.times.size() > 1 && !std::includes(last.begin(), last.end(), before.begin(), before.end());
  }
  void drop_last() {
    record_.times.pop_back();
    for (Channel& channel : record_.channels)
      if (channel.values.size() > record_.times.size()) channel.values.pop_back();
  }
  void fill() {
    for (Channel& channel : record_.channels) channel.values.resize(record_.times.size(), 0.0);
  }

  HistoryRecord record_;
  std::map<std::pair<std::string, std::string>, std::size_t> place_;
};

}  // namespace nugget::output
