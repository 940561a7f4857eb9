// SPDX-License-Identifier: Apache-2.0
#include "report/view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "base/index.hpp"
#include "output/d3plot_reader.hpp"
#include "report/colour_field.hpp"
#include "report/skin.hpp"

namespace nugget::report {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using output::D3plotGeometry;
using output::D3plotReader;
using output::D3plotState;

/// States of the file that are shown: the first, every `stride`th, the last.
std::vector<std::size_t> every(std::size_t stride, std::size_t states) {
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i + 1 < states; i += stride) chosen.push_back(i);
  if (states > 0) chosen.push_back(states - 1);
  return chosen;
}

/// As the page's table of units calls it.
std::string dimension_name(const ColourField& field) {
  return field.dimension == dimension::stress ? "stress" : field.dimension == dimension::length ? "length" : "";
}

/// What of a state the view shows.
struct ShownState {
  std::vector<Vec3d> x;
  std::vector<char> shell_alive, solid_alive, beam_alive;
  std::array<std::vector<float>, std::size(colour_fields)> of_shells, of_solids;
};

ShownState shown_state(const D3plotGeometry& g, const D3plotState& s, bool modes) {
  ShownState shown{s.x, s.shell_alive, s.solid_alive, s.beam_alive, {}, {}};
  for (std::size_t f = 0; !modes && f < std::size(colour_fields); ++f) {
    for (std::size_t e = 0; e < g.shells.size(); ++e)
      shown.of_shells[f].push_back(static_cast<float>(colour_fields[f].of_shell(e, s, g)));
    for (std::size_t e = 0; e < g.solids.size(); ++e)
      shown.of_solids[f].push_back(static_cast<float>(colour_fields[f].of_solid(e, s, g)));
  }
  return shown;
}

/// States as they are asked for, each read once.
class ShownStates {
 public:
  ShownStates(const D3plotReader& file, bool modes) : file_(file), modes_(modes) {}
  const ShownState& operator[](std::size_t i) {
    const auto found = known_.find(i);
    if (found != known_.end()) return found->second;
    file_.read(i, read_);
    return known_.emplace(i, shown_state(file_.geometry(), read_, modes_)).first->second;
  }
  const D3plotReader& file() const { return file_; }
  bool modes() const { return modes_; }

 private:
  const D3plotReader& file_;
  bool modes_;
  D3plotState read_;
  std::map<std::size_t, ShownState> known_;
};

/// First chosen state in which each element is deleted; their number where it never is.
std::vector<int> ends(std::size_t elements, const std::vector<ShownState>& states,
                      std::vector<char> ShownState::*alive) {
  std::vector<int> end(elements, static_cast<int>(states.size()));
  for (std::size_t e = 0; e < elements; ++e)
    for (std::size_t i = states.size(); i-- > 0 && (states[i].*alive)[e] == 0;) end[e] = static_cast<int>(i);
  return end;
}

struct Box {
  Vec3d low{std::numeric_limits<double>::max(), std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
  Vec3d high = -low;
  void add(const Vec3d& p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
};

/// The nodes that something visible hangs on, in their order.
class UsedNodes {
 public:
  UsedNodes(const D3plotGeometry& g, const std::vector<Facet>& seen) : number_(g.node_ids.size(), -1) {
    for (const Facet& facet : seen)
      for (const int node : facet.nodes) number_[node] = 0;
    for (const auto& beam : g.beams)
      for (const int node : beam.nodes) number_[node] = 0;
    for (std::size_t i = 0; i < number_.size(); ++i) {
      if (number_[i] < 0) continue;
      number_[i] = static_cast<int>(nodes_.size());
      nodes_.push_back(static_cast<int>(i));
    }
  }
  const std::vector<int>& nodes() const { return nodes_; }
  std::uint32_t number(int node) const { return static_cast<std::uint32_t>(number_[node]); }

 private:
  std::vector<int> number_, nodes_;
};

/// Coordinates of the used nodes in steps of a 65535th of the box, x of all, y of all, z of all. A node that flies off,
/// because all on it is deleted, stays at the box's side.
std::vector<std::uint16_t> in_steps(const std::vector<Vec3d>& x, const UsedNodes& used, const Box& box) {
  constexpr double steps = 65535.0;
  const std::size_t count = used.nodes().size();
  std::vector<std::uint16_t> all(3 * count);
  const auto step = [](double value, double low, double high) {
    return static_cast<std::uint16_t>(std::lround(steps * std::clamp((value - low) / (high - low), 0.0, 1.0)));
  };
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3d& p = x[used.nodes()[i]];
    all[i] = step(p.x, box.low.x, box.high.x);
    all[count + i] = step(p.y, box.low.y, box.high.y);
    all[2 * count + i] = step(p.z, box.low.z, box.high.z);
  }
  return all;
}

/// The box of what is seen in some state. Flat ones get some depth.
Box box_of(const D3plotGeometry& g, const std::vector<Facet>& seen, const std::vector<int>& beam_end,
           const std::vector<ShownState>& states) {
  Box box;
  for (const Facet& facet : seen)
    for (const int node : facet.nodes) {
      box.add(g.x[node]);
      for (int i = facet.from; i < facet.until; ++i) box.add(states[i].x[node]);
    }
  for (std::size_t e = 0; e < g.beams.size(); ++e)
    for (const int node : g.beams[e].nodes) {
      box.add(g.x[node]);
      for (int i = 0; i < beam_end[e]; ++i) box.add(states[i].x[node]);
    }
  const double least = 1e-6 * std::max({box.high.x - box.low.x, box.high.y - box.low.y, box.high.z - box.low.z, 1e-30});
  box.high = {std::max(box.high.x, box.low.x + least), std::max(box.high.y, box.low.y + least),
              std::max(box.high.z, box.low.z + least)};
  return box;
}

void add_shapes(PackedArrays& arrays, const D3plotGeometry& g, const std::vector<Facet>& seen,
                const std::vector<ShownState>& states, Json& view) {
  const UsedNodes used(g, seen);
  const std::vector<int> beam_end = ends(g.beams.size(), states, &ShownState::beam_alive);
  const Box box = box_of(g, seen, beam_end, states);
  view["low"] = {box.low.x, box.low.y, box.low.z};
  view["high"] = {box.high.x, box.high.y, box.high.z};
  std::vector<std::uint32_t> ids;
  for (const int node : used.nodes()) ids.push_back(static_cast<std::uint32_t>(g.node_ids[node]));
  arrays.add("node_ids", std::span<const std::uint32_t>(ids));
  std::vector<std::uint16_t> before = in_steps(g.x, used, box);
  arrays.add("x", std::span<const std::uint16_t>(before));
  for (std::size_t i = 0; i < states.size(); ++i) {
    const std::vector<std::uint16_t> now = in_steps(states[i].x, used, box);
    std::vector<std::uint16_t> change(now.size());
    for (std::size_t k = 0; k < now.size(); ++k) change[k] = static_cast<std::uint16_t>(now[k] - before[k]);
    arrays.add(fmt::format("dx{}", i), std::span<const std::uint16_t>(change));
    before = now;
  }
  std::vector<std::uint32_t> corners, elements;
  std::vector<std::uint16_t> parts, from, until;
  for (const Facet& facet : seen) {
    for (const int node : facet.nodes) corners.push_back(used.number(node));
    elements.push_back(
        static_cast<std::uint32_t>(facet.of_shell ? g.shells[at(facet.element)].id : g.solids[at(facet.element)].id));
    parts.push_back(static_cast<std::uint16_t>(facet.part));
    from.push_back(static_cast<std::uint16_t>(facet.from));
    until.push_back(static_cast<std::uint16_t>(facet.until));
  }
  arrays.add("facet_nodes", std::span<const std::uint32_t>(corners));
  arrays.add("facet_elements", std::span<const std::uint32_t>(elements));
  arrays.add("facet_parts", std::span<const std::uint16_t>(parts));
  arrays.add("facet_from", std::span<const std::uint16_t>(from));
  arrays.add("facet_until", std::span<const std::uint16_t>(until));
  corners.clear(), elements.clear(), parts.clear(), until.clear();
  for (std::size_t e = 0; e < g.beams.size(); ++e) {
    for (const int node : g.beams[e].nodes) corners.push_back(used.number(node));
    elements.push_back(static_cast<std::uint32_t>(g.beams[e].id));
    parts.push_back(static_cast<std::uint16_t>(g.beams[e].part));
    until.push_back(static_cast<std::uint16_t>(beam_end[e]));
  }
  arrays.add("beam_nodes", std::span<const std::uint32_t>(corners));
  arrays.add("beam_elements", std::span<const std::uint32_t>(elements));
  arrays.add("beam_parts", std::span<const std::uint16_t>(parts));
  arrays.add("beam_until", std::span<const std::uint16_t>(until));
}

/// 0 to 254 from the lowest to the highest value in any state; 255 where a facet has none.
void add_fields(PackedArrays& arrays, const std::vector<Facet>& seen, const std::vector<ShownState>& states,
                Json& view) {
  constexpr double steps = 254.0;
  constexpr std::uint8_t none = 255;
  int number = 0;
  for (std::size_t f = 0; f < std::size(colour_fields); ++f) {
    const auto value_of = [&](const Facet& facet, const ShownState& state) {
      return static_cast<double>((facet.of_shell ? state.of_shells : state.of_solids)[f][at(facet.element)]);
    };
    double low = std::numeric_limits<double>::max(), high = -low;
    for (std::size_t i = 0; i < states.size(); ++i)
      for (const Facet& facet : seen) {
        const double value = value_of(facet, states[i]);
        if (!std::isfinite(value) || static_cast<int>(i) < facet.from || static_cast<int>(i) >= facet.until) continue;
        low = std::min(low, value);
        high = std::max(high, value);
      }
    if (!(low < high)) continue;
    view["fields"].push_back({{"name", colour_fields[f].name},
                              {"dimension", dimension_name(colour_fields[f])},
                              {"low", low},
                              {"high", high}});
    for (std::size_t i = 0; i < states.size(); ++i) {
      std::vector<std::uint8_t> scaled;
      scaled.reserve(seen.size());
      for (const Facet& facet : seen) {
        const double value = value_of(facet, states[i]), share = std::clamp((value - low) / (high - low), 0.0, 1.0);
        scaled.push_back(std::isfinite(value) ? static_cast<std::uint8_t>(std::lround(steps * share)) : none);
      }
      arrays.add(fmt::format("field{}_{}", number, i), std::span<const std::uint8_t>(scaled));
    }
    ++number;
  }
}

void describe(const D3plotReader& file, const std::vector<std::size_t>& chosen, const std::vector<Facet>& seen,
              Json& view) {
  const D3plotGeometry& g = file.geometry();
  for (const output::D3plotPart& part : g.parts) view["parts"].push_back({{"id", part.id}, {"title", part.title}});
  for (const std::size_t i : chosen) view["times"].push_back(file.times()[i]);
  view["shown"] = chosen;
  view["states"] = file.times().size();
  view["nodes"] = g.node_ids.size();
  view["facets"] = seen.size();
  view["fields"] = Json::array();
}

/// Modes have any size (their mass is normalized): each is brought to 6 % of the model's diagonal, by the factors
/// that are returned.
std::vector<double> scale_modes(const D3plotGeometry& g, std::vector<ShownState>& states) {
  Box box;
  for (const Vec3d& x : g.x) box.add(x);
  std::vector<double> factors;
  for (ShownState& state : states) {
    double largest = 0.0;
    for (std::size_t i = 0; i < g.x.size(); ++i) largest = std::max(largest, norm(state.x[i] - g.x[i]));
    const double factor = largest > 0.0 ? 0.06 * norm(box.high - box.low) / largest : 1.0;
    for (std::size_t i = 0; i < g.x.size(); ++i) state.x[i] = g.x[i] + factor * (state.x[i] - g.x[i]);
    factors.push_back(factor);
  }
  return factors;
}

/// The view with these states.
PackedArrays with_states(ShownStates& of_file, const std::vector<std::size_t>& chosen) {
  const D3plotReader& file = of_file.file();
  const D3plotGeometry& g = file.geometry();
  const bool modes = of_file.modes();
  std::vector<ShownState> states;
  states.reserve(chosen.size());
  for (const std::size_t i : chosen) states.push_back(of_file[i]);
  const std::vector<Facet> seen =
      facets(g, ends(g.shells.size(), states, &ShownState::shell_alive),
             ends(g.solids.size(), states, &ShownState::solid_alive), static_cast<int>(states.size()));
  PackedArrays arrays;
  Json& view = arrays.about["view"];
  describe(file, chosen, seen, view);
  view["modes"] = modes;
  if (modes) view["factors"] = scale_modes(g, states);
  add_shapes(arrays, g, seen, states, view);
  if (!modes) add_fields(arrays, seen, states, view);
  return arrays;
}

}  // namespace

PackedArrays packed_view(const fs::path& directory, bool modes, const ViewLimits& limits) {
  PackedArrays none;
  std::optional<D3plotReader> file;
  try {
    file.emplace(directory, modes ? D3plotGeometry::Family::d3eigv : D3plotGeometry::Family::d3plot);
  } catch (const std::runtime_error& error) {
    none.about["view"]["note"] = fmt::format("No view of the model: {}.", error.what());
    return none;
  }
  const D3plotGeometry& g = file->geometry();
  const std::size_t points = g.node_ids.size() + g.shells.size() + g.solids.size();
  if (points > limits.points) {
    none.about["view"]["note"] =
        fmt::format("No view here: the model has {} nodes and {} elements. Open {} in LS-PrePost, META or ParaView.",
                    g.node_ids.size(), g.shells.size() + g.solids.size(), (directory / g.stem()).string());
    return none;
  }
  const std::size_t count = file->times().size();
  ShownStates states(*file, modes);
  // What a state takes is measured on two of them, so that of a large file no more are read than are shown.
  std::size_t stride = 1;
  if (count > 2 && count * points > limits.text / 10) {
    const std::size_t two = with_states(states, {0, count - 1}).text().size(),
                      one = with_states(states, {0}).text().size();
    const std::size_t of_state = std::max<std::size_t>(1, two - std::min(two, one)), base = std::min(one, limits.text);
    const std::size_t fit = std::max<std::size_t>(2, 1 + (limits.text - base) / of_state);
    stride = (count - 1 + fit - 2) / (fit - 1);
  }
  for (;; stride *= 2) {
    const std::vector<std::size_t> chosen = every(stride, count);
    PackedArrays arrays = with_states(states, chosen);
    if (stride < count && arrays.text().size() > limits.text) continue;
    if (chosen.size() < count)
      arrays.about["view"]["note"] =
          fmt::format("{} of {} states are shown; {} has all.", chosen.size(), count, g.stem());
    return arrays;
  }
}

}  // namespace nugget::report
