// SPDX-License-Identifier: Apache-2.0
#include "report/model_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <tuple>

#include "base/index.hpp"
#include "output/d3plot_reader.hpp"
#include "output/history_reader.hpp"
#include "report/colour_field.hpp"
#include "report/colours.hpp"
#include "report/packed_arrays.hpp"
#include "report/picture_file.hpp"
#include "report/plot.hpp"
#include "report/quantity.hpp"
#include "report/raster.hpp"
#include "report/response_page.hpp"
#include "report/run_data.hpp"
#include "report/shown_welds.hpp"
#include "report/skin.hpp"

namespace nugget::report {
namespace {

namespace fs = std::filesystem;
using output::D3plotGeometry;
using output::D3plotReader;
using output::D3plotState;

constexpr Colour sheet{196, 202, 208};                    // what has no value
constexpr double margin = 24.0;                           // pixels
constexpr double above_model = 46.0, below_model = 54.0;  // pixels above and below the model

/// `von Mises stress` as options name it: `von_mises_stress`.
std::string option_name(std::string_view name) {
  std::string text;
  for (const char c : name) text += c == ' ' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

const ColourField* element_field(const std::string& name) {
  for (const ColourField& field : colour_fields)
    if (option_name(field.name) == name) return &field;
  return nullptr;
}

/// The run, the state that is drawn and what can be seen of it.
struct Scene {
  const PictureOptions& options;
  RunData run;
  D3plotReader file;
  bool modes;
  std::size_t number = 0;  // of the state
  D3plotState state;
  std::vector<Vec3d> x;  // displacements scaled
  std::vector<Facet> facets;
  std::vector<ShownWeld> welds;

  const D3plotGeometry& geometry() const { return file.geometry(); }
  bool shows(int part) const {
    return options.parts.empty() ||
           std::find(options.parts.begin(), options.parts.end(), geometry().parts[at(part)].id) != options.parts.end();
  }
  /// The nodes of a failed weld may fly anywhere: its place is that of the sheet that it was tied to.
  Vec3d place_of(const ShownWeld& weld) const {
    const std::vector<std::size_t>& nodes =
        weld.has_failed_by(state.time) && !weld.segment.empty() ? weld.segment : weld.nodes;
    return middle_of(nodes, x);
  }
};

/// Rigid body motions come first and have next to no frequency.
std::size_t first_elastic(const std::vector<double>& frequencies) {
  const double least = 1e-3 * *std::max_element(frequencies.begin(), frequencies.end());
  const auto found = std::find_if(frequencies.begin(), frequencies.end(), [=](double f) { return f > least; });
  return static_cast<std::size_t>(found - frequencies.begin()) % frequencies.size();
}

std::size_t asked_state(const PictureOptions& options, const std::vector<double>& times, bool modes) {
  if (times.empty()) throw std::runtime_error("there is no whole state to draw");
  if (at(options.state) > times.size())
    throw std::runtime_error(
        fmt::format("there is no {} {}, expected 1 to {}", modes ? "mode" : "state", options.state, times.size()));
  if (options.state != 0) return at(options.state) - 1;
  if (modes) return first_elastic(times);
  if (std::isinf(options.time)) return times.size() - 1;
  const auto nearer = [&](double a, double b) { return std::abs(a - options.time) < std::abs(b - options.time); };
  return static_cast<std::size_t>(std::min_element(times.begin(), times.end(), nearer) - times.begin());
}

/// Displacements times the scale; those of modes, which have any size, first brought to 6 % of the model's diagonal.
std::vector<Vec3d> displaced(const D3plotGeometry& g, const D3plotState& s, bool modes, double scale) {
  constexpr double share_of_diagonal = 0.06;
  if (modes) {
    Vec3d low = g.x.front(), high = low;
    double largest = 0.0;
    for (std::size_t i = 0; i < g.x.size(); ++i) {
      low = {std::min(low.x, g.x[i].x), std::min(low.y, g.x[i].y), std::min(low.z, g.x[i].z)};
      high = {std::max(high.x, g.x[i].x), std::max(high.y, g.x[i].y), std::max(high.z, g.x[i].z)};
      largest = std::max(largest, norm(s.x[i] - g.x[i]));
    }
    if (largest > 0.0) scale *= share_of_diagonal * norm(high - low) / largest;
  }
  std::vector<Vec3d> x = g.x;
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += scale * (s.x[i] - g.x[i]);
  return x;
}

std::vector<int> end_of(const std::vector<char>& alive, std::size_t elements) {
  std::vector<int> end(elements, 1);
  for (std::size_t e = 0; e < alive.size(); ++e) end[e] = alive[e] != 0 ? 1 : 0;
  return end;
}

Scene read_scene(const fs::path& directory, const PictureOptions& options) {
  RunData run = read_run(directory);
  const bool modes = run.summary.contains("modes") && !run.summary["modes"].empty();
  D3plotReader file(directory, modes ? D3plotGeometry::Family::d3eigv : D3plotGeometry::Family::d3plot);
  Scene scene{options, std::move(run), std::move(file), modes, 0, {}, {}, {}, {}};
  const D3plotGeometry& g = scene.geometry();
  for (const int id : options.parts)
    if (std::none_of(g.parts.begin(), g.parts.end(), [=](const output::D3plotPart& part) { return part.id == id; }))
      throw std::runtime_error(fmt::format("there is no part {}", id));
  scene.number = asked_state(options, scene.file.times(), modes);
  scene.state = scene.file.read(scene.number);
  scene.x = displaced(g, scene.state, modes, options.scale);
  scene.facets =
      facets(g, end_of(scene.state.shell_alive, g.shells.size()), end_of(scene.state.solid_alive, g.solids.size()), 1);
  std::erase_if(scene.facets, [&](const Facet& f) { return f.until == 0 || !scene.shows(f.part); });
  scene.welds = shown_welds(scene.run, g);
  const auto is_asked = [&](int part) { return std::ranges::find(options.parts, part) != options.parts.end(); };
  if (!options.parts.empty())
    std::erase_if(scene.welds, [&](const ShownWeld& weld) {
      return weld.id != options.weld && std::ranges::none_of(weld.parts, is_asked);
    });
  if (scene.facets.empty()) throw std::runtime_error("there is no shell and no brick to draw");
  return scene;
}

// ---- colours

/// A value for each facet; not a number where it has none.
struct FacetValues {
  std::string name;  ///< with its unit
  std::vector<double> values;
  double low = 0.0, high = 0.0, largest = 0.0;
  bool of_damage = false;  ///< welds have it too
};

bool has_yielded(const Scene& s) {
  return std::any_of(s.facets.begin(), s.facets.end(),
                     [&](const Facet& f) { return colour_fields[0].of(f, s.state, s.geometry()) > 0.0; });
}

std::string asked_field(const Scene& s) {
  if (!s.options.field.empty()) return s.options.field;
  if (s.modes) return "displacement";
  return has_yielded(s) ? "plastic_strain" : "part";
}

bool is_damaged_at_the_end(const Scene& s) {
  if (std::any_of(s.welds.begin(), s.welds.end(), [](const ShownWeld& w) { return w.is_damaged(); })) return true;
  const D3plotState last = s.file.read(s.file.times().size() - 1);
  return std::any_of(s.facets.begin(), s.facets.end(),
                     [&](const Facet& f) { return damage_field.of(f, last, s.geometry()) > 0.0; });
}

double displacement_of(const Facet& facet, const Scene& s) {
  double sum = 0.0;
  for (const int node : facet.nodes) sum += norm(s.state.x[at(node)] - s.geometry().x[at(node)]) / 4.0;
  return sum;
}

/// Nothing where facets are coloured by their parts.
std::optional<FacetValues> values_of(const Scene& s) {
  const std::string name = asked_field(s);
  const ColourField* field = element_field(name);
  if (name == "part") return std::nullopt;
  if (s.modes && field)
    throw std::runtime_error(fmt::format("natural modes have no {}, expected displacement or part", field->name));
  FacetValues of;
  of.name = s.modes ? std::string("displacement, any scale")
                    : std::string(field ? field->name : "displacement") +
                          in_units(s.run.summary, field ? field->dimension : dimension::length);
  std::vector<double> sorted;
  for (const Facet& f : s.facets) {
    of.values.push_back(field ? field->of(f, s.state, s.geometry()) : displacement_of(f, s));
    if (std::isfinite(of.values.back())) sorted.push_back(of.values.back());
  }
  const bool of_damage = field && field->name == damage_field.name;
  if (of_damage && std::none_of(of.values.begin(), of.values.end(), [](double value) { return value > 0.0; })) {
    if (!is_damaged_at_the_end(s))
      throw std::runtime_error(
          "nothing that is shown has damage: d3plot has that of elements where NEIPH and NEIPS of "
          "*DATABASE_EXTENT_BINARY are 2 or more, welds.csv that of welds");
    sorted.assign({0.0, 1.0});
  }
  if (sorted.empty()) throw std::runtime_error(fmt::format("nothing that is shown has {}", name));
  of.of_damage = of_damage;
  std::sort(sorted.begin(), sorted.end());
  of.low = sorted.front();
  of.largest = sorted.back();
  // The last hundredth of a strain or stress stands in a few elements: it would leave all others grey.
  of.high = s.modes ? of.largest : sorted[(sorted.size() - 1) - (sorted.size() - 1) / 100];
  if (!(of.high > of.low)) of.high = of.largest;
  if (s.options.range != std::pair{0.0, 0.0}) std::tie(of.low, of.high) = s.options.range;
  return of;
}

Colour colour_of(const Scene& s, const std::optional<FacetValues>& of, std::size_t facet) {
  if (!of) return colour_of_part(s.facets[facet].part);
  const double value = of->values[facet];
  if (!std::isfinite(value)) return sheet;
  return ramp(of->high > of->low ? (value - of->low) / (of->high - of->low) : 0.0);
}

// ---- projection

/// From the model to pixels.
class Camera {
 public:
  Camera(const Scene& s, const Vec3d& towards) : options_(s.options), towards_(unit(towards)) {
    Vec3d right = cross(options_.up, towards_);
    if (!(norm(right) > 1e-9 * norm(options_.up))) right = cross(Vec3d{0.0, 1.0, 0.0}, towards_);
    if (!(norm(right) > 1e-9)) right = {1.0, 0.0, 0.0};
    right_ = unit(right);
    top_ = cross(towards_, right_);
    options_.weld != 0 ? look_at_weld(s) : look_at_all(s);
  }

  PicturePoint operator()(const Vec3d& x) const {
    return {0.5 * options_.width + scale_ * (dot(x, right_) - u_),
            above_model + 0.5 * (options_.height - above_model - below_model) - scale_ * (dot(x, top_) - v_),
            dot(x, towards_)};
  }
  double scale() const { return scale_; }  // pixels a unit of length
  double light(const Vec3d& normal) const {
    const double length = norm(normal);
    if (!(length > 0.0)) return 1.0;
    const Vec3d lamp = 0.8 * towards_ + 0.5 * top_ + 0.25 * right_;
    return 0.62 + 0.38 * std::min(1.0, std::abs(dot(normal, lamp)) / (length * norm(lamp)) * 1.05);
  }
  const Vec3d& right() const { return right_; }
  const Vec3d& top() const { return top_; }

 private:
  void look_at_all(const Scene& s) {
    double low_u = std::numeric_limits<double>::max(), high_u = -low_u, low_v = low_u, high_v = -low_u;
    for (const Facet& facet : s.facets)
      for (const int node : facet.nodes) {
        const double u = dot(s.x[at(node)], right_), v = dot(s.x[at(node)], top_);
        low_u = std::min(low_u, u), high_u = std::max(high_u, u);
        low_v = std::min(low_v, v), high_v = std::max(high_v, v);
      }
    u_ = 0.5 * (low_u + high_u), v_ = 0.5 * (low_v + high_v);
    fit(high_u - low_u, high_v - low_v);
  }
  void look_at_weld(const Scene& s) {
    constexpr double diameters = 12.0;
    const auto weld =
        std::find_if(s.welds.begin(), s.welds.end(), [&](const ShownWeld& w) { return w.id == options_.weld; });
    if (weld == s.welds.end())
      throw std::runtime_error(fmt::format("there is no weld {} in the picture", options_.weld));
    const Vec3d x = s.place_of(*weld);
    u_ = dot(x, right_), v_ = dot(x, top_);
    fit(diameters * weld->diameter, diameters * weld->diameter);
  }
  void fit(double wide, double high) {
    const double least = 1e-12 * (wide + high) + 1e-300;
    scale_ = std::min((options_.width - 2.0 * margin) / std::max(wide, least),
                      (options_.height - above_model - below_model - margin) / std::max(high, least));
  }

  const PictureOptions& options_;
  Vec3d towards_, right_, top_;
  double u_ = 0.0, v_ = 0.0, scale_ = 1.0;
};

// ---- drawing

std::string css(const Colour& c) {
  return fmt::format("#{:02x}{:02x}{:02x}", std::lround(c[0]), std::lround(c[1]), std::lround(c[2]));
}

/// Facets and their edges, twice as wide and high as the picture, so that their borders are smooth in it. Facet i has
/// the mark 2 i + 1, its edges the next one.
class DrawnFacets {
 public:
  DrawnFacets(const Scene& s, const Camera& camera, const std::optional<FacetValues>& values)
      : scene_(s), camera_(camera), raster_(2 * s.options.width, 2 * s.options.height) {
    constexpr double edge_shade = 0.72;
    palette_.reserve(2 * s.facets.size() + 1);
    palette_.emplace_back();
    for (std::size_t i = 0; i < s.facets.size(); ++i) {
      const std::array<int, 4>& n = s.facets[i].nodes;
      const double light = camera.light(cross(s.x[at(n[2])] - s.x[at(n[0])], s.x[at(n[3])] - s.x[at(n[1])]));
      const Colour colour = colour_of(s, values, i);
      palette_.push_back(shaded(colour, light));
      palette_.push_back(shaded(colour, light * edge_shade));
      draw(n, mark_of(i));
    }
    if (s.options.edges && edges_are_wide()) draw_edges();
  }

  /// Whether a sheet hides a point of the picture that lies behind it by more than `slack`.
  bool hide(const PicturePoint& p, double slack) const {
    return raster_.hides({doubled * p.u, doubled * p.v, p.near}, slack);
  }

  std::string as_pixels() const {
    return fmt::format("<image width=\"{0}\" height=\"{1}\" xlink:href=\"data:image/png;base64,{2}\"/>\n",
                       scene_.options.width, scene_.options.height,
                       base64(png_of(raster_.halved(palette_), scene_.options.width)));
  }
  /// Those that cover a pixel, from the farthest to the nearest.
  std::string as_shapes() const {
    std::vector<char> seen(scene_.facets.size(), 0);
    for (const Raster::Mark mark : raster_.marks())
      if (mark != Raster::nothing) seen[(mark - 1) / 2] = 1;
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i < seen.size(); ++i)
      if (seen[i] != 0) order.emplace_back(nearness(i), i);
    std::sort(order.begin(), order.end());
    std::string text = fmt::format("<g stroke-linejoin=\"round\" stroke-width=\"{}\">\n",
                                   scene_.options.edges && edges_are_wide() ? 0.5 : 0.3);
    for (const auto& [near, i] : order) {
      const std::string fill = css(palette_[mark_of(i)]);
      std::string path;
      for (const int node : scene_.facets[i].nodes) {
        const PicturePoint p = camera_(scene_.x[at(node)]);
        path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", p.u, p.v);
      }
      text += fmt::format("<path fill=\"{}\" stroke=\"{}\" d=\"{}z\"/>\n", fill,
                          scene_.options.edges && edges_are_wide() ? css(palette_[mark_of(i) + 1]) : fill, path);
    }
    return text + "</g>\n";
  }

 private:
  static constexpr double doubled = 2.0;
  static Raster::Mark mark_of(std::size_t facet) { return static_cast<Raster::Mark>(2 * facet + 1); }
  static Colour shaded(const Colour& colour, double light) {
    return {light * colour[0], light * colour[1], light * colour[2]};
  }

  PicturePoint seen_at(int node) const {
    const PicturePoint p = camera_(scene_.x[at(node)]);
    return {doubled * p.u, doubled * p.v, p.near};
  }
  void draw(const std::array<int, 4>& n, Raster::Mark mark) {
    raster_.triangle({seen_at(n[0]), seen_at(n[1]), seen_at(n[2])}, mark);
    if (n[2] != n[3]) raster_.triangle({seen_at(n[0]), seen_at(n[2]), seen_at(n[3])}, mark);
  }
  bool edges_are_wide() const {
    constexpr double narrowest = 5.0;  // pixels
    double sum = 0.0;
    for (const Facet& facet : scene_.facets) sum += norm(scene_.x[at(facet.nodes[1])] - scene_.x[at(facet.nodes[0])]);
    return camera_.scale() * sum > narrowest * static_cast<double>(scene_.facets.size());
  }
  void draw_edges() {
    const double slack = 3.0 / (doubled * camera_.scale());
    for (std::size_t i = 0; i < scene_.facets.size(); ++i) {
      const std::array<int, 4>& n = scene_.facets[i].nodes;
      for (std::size_t k = 0; k < 4; ++k)
        if (n[k] != n[(k + 1) % 4]) raster_.line(seen_at(n[k]), seen_at(n[(k + 1) % 4]), slack, mark_of(i) + 1);
    }
  }
  double nearness(std::size_t facet) const {
    double sum = 0.0;
    for (const int node : scene_.facets[facet].nodes) sum += camera_(scene_.x[at(node)]).near;
    return sum;
  }

  const Scene& scene_;
  const Camera& camera_;
  Raster raster_;
  std::vector<Colour> palette_;
};

/// Largest failure value of each weld up to a time, from swforc; from welds.csv where its peak came before.
class FailureValues {
 public:
  FailureValues(const fs::path& directory, double time) : time_(time) {
    constexpr std::string_view file[] = {"swforc"};
    for (output::HistoryRecord& record : output::read_histories(directory, file)) {
      times_ = std::move(record.times);
      for (output::Channel& channel : record.channels)
        if (channel.quantity == "failure") of_.emplace(channel.entity, std::move(channel.values));
    }
  }
  double of(const ShownWeld& weld) const {
    if (weld.has_failed_by(time_)) return 1.0;
    if (weld.peak_failure_time <= time_) return std::min(weld.peak_failure, almost_failed);
    double largest = 0.0;
    if (const auto found = of_.find(fmt::format("weld {}", weld.id)); found != of_.end())
      for (std::size_t i = 0; i < times_.size() && times_[i] <= time_; ++i)
        largest = std::max(largest, found->second[i]);
    return std::min(largest, almost_failed);
  }

 private:
  static constexpr double almost_failed = 0.9999;  // a value of 1 is told by the weld's verdict alone
  double time_;
  std::vector<double> times_;
  std::map<std::string, std::vector<double>> of_;
};

/// By the colours of the sheets where these show damage and the weld has some, else by its failure value.
Colour colour_of(const ShownWeld& weld, const Scene& s, const std::optional<FacetValues>& of,
                 const FailureValues& failure) {
  if (s.modes) return colour_of_failure(0.0);
  if (!of || !of->of_damage) return colour_of_failure(failure.of(weld));
  const std::optional<double> damage = weld.has_failed_by(s.state.time) ? 1.0 : weld.damage;
  return damage && of->high > of->low ? ramp((*damage - of->low) / (of->high - of->low)) : colour_of_failure(0.0);
}

/// So many welds cover what they stand in: those that are far from failing step back.
bool are_crowded(const Scene& s) {
  constexpr std::size_t few = 200;
  return s.welds.size() > few && s.options.weld == 0;
}

/// The higher its failure value, the farther in front a weld is drawn.
std::string drawn_welds(const Scene& s, const Camera& camera, const DrawnFacets& sheets,
                        const std::optional<FacetValues>& values, const FailureValues& failure) {
  constexpr double least_radius = 3.5, least_of_many = 1.5, far_from_failing = 0.5;
  const bool crowded = are_crowded(s);
  std::vector<std::pair<double, const ShownWeld*>> order;
  for (const ShownWeld& weld : s.welds) order.emplace_back(s.modes ? 0.0 : failure.of(weld), &weld);
  std::ranges::stable_sort(order, {}, [](const auto& of) { return of.first; });
  std::string text;
  for (const auto& [value, weld] : order) {
    const PicturePoint p = camera(s.place_of(*weld));
    const bool hidden = sheets.hide(p, weld->diameter), steps_back = crowded && value < far_from_failing;
    if (hidden && steps_back) continue;
    const std::string colour = css(colour_of(*weld, s, values, failure));
    text += fmt::format(
        "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" fill=\"{}\" stroke=\"{}\" stroke-width=\"{}\">"
        "<title>weld {}</title></circle>\n",
        p.u, p.v, std::max(steps_back ? least_of_many : least_radius, 0.5 * weld->diameter * camera.scale()),
        hidden ? "none" : colour, hidden || steps_back ? colour : "#fff",
        hidden       ? 1.4
        : steps_back ? 0.0
                     : 1.0,
        weld->id);
  }
  return text;
}

/// Beams that are no welds.
std::string drawn_beams(const Scene& s, const Camera& camera) {
  std::set<std::pair<std::size_t, std::size_t>> welds;
  for (const ShownWeld& weld : s.welds)
    if (weld.nodes.size() == 2) welds.emplace(weld.nodes[0], weld.nodes[1]);
  std::string text;
  const D3plotGeometry& g = s.geometry();
  for (std::size_t e = 0; e < g.beams.size(); ++e) {
    const std::size_t i = at(g.beams[e].nodes[0]), j = at(g.beams[e].nodes[1]);
    const bool dead = !s.state.beam_alive.empty() && s.state.beam_alive[e] == 0;
    if (dead || !s.shows(g.beams[e].part) || welds.contains({i, j}) || welds.contains({j, i})) continue;
    const PicturePoint a = camera(s.x[i]), b = camera(s.x[j]);
    text += fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"#234\"/>\n", a.u, a.v,
                        b.u, b.v);
  }
  return text;
}

// ---- words

std::string text_at(double x, double y, const std::string& text, const char* more = "") {
  if (text.empty()) return {};
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\"{}>{}</text>\n", x, y, more, escaped(text));
}

std::string colour_bar(const Scene& s, const FacetValues& of) {
  constexpr double left = margin, wide = 320.0, tall = 12.0;
  constexpr int marks = 5;
  const double y = s.options.height - 34.0;
  std::string gradient, labels;
  for (int i = 0; i <= 12; ++i)
    gradient += fmt::format("<stop offset=\"{:.3f}\" stop-color=\"{}\"/>", i / 12.0, css(ramp(i / 12.0)));
  for (int i = 0; i < marks; ++i) {
    const double share = static_cast<double>(i) / (marks - 1);
    labels += text_at(left + share * wide, y + tall + 14.0, fmt::format("{:.3g}", of.low + share * (of.high - of.low)),
                      " text-anchor=\"middle\"");
  }
  std::string largest;
  if (!s.modes && of.largest > of.high) largest = fmt::format(" (largest {:.4g})", of.largest);
  if (of.of_damage) largest += "; 1: failed; welds as at the end of the run";
  return fmt::format(
      "<defs><linearGradient id=\"ramp\">{}</linearGradient></defs>\n<rect x=\"{:.0f}\" y=\"{:.0f}\" width=\"{:.0f}\" "
      "height=\"{:.0f}\" fill=\"url(#ramp)\"/>\n{}{}",
      gradient, left, y, wide, tall, labels, text_at(left, y - 6.0, of.name + largest));
}

/// The first letters of a long name, with an ellipsis.
std::string shortened(const std::string& name) {
  constexpr std::size_t longest = 32;
  if (name.size() <= longest) return name;
  std::size_t end = longest - 1;
  while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xc0U) == 0x80U) --end;  // not within a letter
  return name.substr(0, end) + "…";
}

std::string part_list(const Scene& s) {
  constexpr std::size_t most = 8;
  constexpr double letter = 7.8, and_more = 90.0;  // pixels, at most
  std::string text;
  std::set<int> shown;
  for (const Facet& facet : s.facets) shown.insert(facet.part);
  double x = margin;
  std::size_t named = 0;
  for (const int part : shown) {
    const output::D3plotPart& p = s.geometry().parts[at(part)];
    const std::string name =
        shortened(p.title.empty() ? fmt::format("part {}", p.id) : fmt::format("{} {}", p.id, p.title));
    const double wide = 36.0 + letter * static_cast<double>(name.size());
    if (named == most || (named > 0 && x + wide > s.options.width - and_more)) {
      text += text_at(x, s.options.height - 20.0, fmt::format("and {} more", shown.size() - named));
      break;
    }
    ++named;
    text += fmt::format("<rect x=\"{:.0f}\" y=\"{:.0f}\" width=\"11\" height=\"11\" fill=\"{}\"/>", x,
                        s.options.height - 30.0, css(colour_of_part(part)));
    text += text_at(x + 16.0, s.options.height - 20.0, name);
    x += wide;
  }
  return text;
}

std::string weld_legend(const Scene& s) {
  if (s.welds.empty() || s.modes) return {};
  const auto broken =
      std::count_if(s.welds.begin(), s.welds.end(), [&](const ShownWeld& w) { return w.has_failed_by(s.state.time); });
  const double words = are_crowded(s) ? 400.0 : 250.0;
  constexpr double colour_bar_ends = margin + 340.0;
  const bool beside = s.options.width - words - 110.0 > colour_bar_ends;  // of the colour bar, or else above it
  const double x = beside ? s.options.width - words - 110.0 : margin + 4.0,
               y = s.options.height - (beside ? 16.0 : 60.0);
  std::string text =
      fmt::format("<circle cx=\"{:.0f}\" cy=\"{:.0f}\" r=\"4\" fill=\"{}\"/>", x, y - 4.0, css(colour_of_failure(1.0)));
  return text + text_at(x + 9.0, y,
                        fmt::format("{} of {} welds failed (hollow: behind a sheet{})", broken, s.welds.size(),
                                    are_crowded(s) ? "; small: far from it" : ""));
}

/// The global axes as they lie in the picture.
std::string triad(const Scene& s, const Camera& camera) {
  constexpr double length = 30.0;
  const double u = s.options.width - 50.0, v = s.options.height - 44.0;
  std::string text;
  const std::pair<Vec3d, const char*> axes[] = {{{1, 0, 0}, "x"}, {{0, 1, 0}, "y"}, {{0, 0, 1}, "z"}};
  for (const auto& [axis, name] : axes) {
    const double du = length * dot(axis, camera.right()), dv = -length * dot(axis, camera.top());
    text += fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"#345\"/>", u, v, u + du,
                        v + dv);
    if (std::hypot(du, dv) > 0.1 * length) text += text_at(u + 1.25 * du - 3.0, v + 1.25 * dv + 4.0, name);
  }
  return text;
}

std::string caption(const Scene& s) {
  const double at_time = s.file.times()[s.number];
  if (s.modes)
    return fmt::format("mode {} of {}, {:.5g}{}", s.number + 1, s.file.times().size(), at_time,
                       frequency_unit(s.run.summary));
  std::string text = fmt::format("t = {:.4g}{} (state {} of {})", at_time, unit_of(s.run.summary, dimension::time),
                                 s.number + 1, s.file.times().size());
  if (s.options.scale != 1.0) text += fmt::format(", displacements {:g} times", s.options.scale);
  return text;
}

std::string drawn(const Scene& scene, const Camera& camera, const std::optional<FacetValues>& values,
                  const FailureValues& failure) {
  const PictureOptions& options = scene.options;
  const DrawnFacets sheets(scene, camera, values);
  const std::string title = scene.run.summary.value("title", scene.geometry().title);
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" viewBox=\"0 0 {0} {1}\" "
      "width=\"{0}\" height=\"{1}\">\n<style>text {{ font: 13px sans-serif; fill: #234; stroke: #fff; stroke-width: "
      "3px; "
      "paint-order: stroke; }}</style>\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n{2}{3}{4}{5}{6}{7}{8}{9}</svg>\n",
      options.width, options.height, options.shapes ? sheets.as_shapes() : sheets.as_pixels(),
      drawn_beams(scene, camera), drawn_welds(scene, camera, sheets, values, failure),
      text_at(margin, 22.0, title, " style=\"font-weight: bold\""), text_at(margin, 40.0, caption(scene)),
      values ? colour_bar(scene, *values) : part_list(scene), weld_legend(scene), triad(scene, camera));
}

}  // namespace

const std::vector<std::string>& picture_fields() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const ColourField& field : colour_fields) all.push_back(option_name(field.name));
    all.insert(all.end(), {"displacement", "part"});
    return all;
  }();
  return names;
}

std::vector<std::string> model_pictures(const fs::path& directory, const PictureOptions& options,
                                        std::span<const Vec3d> towards) {
  const Scene scene = read_scene(directory, options);
  const std::optional<FacetValues> values = values_of(scene);
  const FailureValues failure(directory, scene.modes ? 0.0 : scene.state.time);
  std::vector<std::string> pictures;
  for (const Vec3d& direction : towards) pictures.push_back(drawn(scene, Camera(scene, direction), values, failure));
  return pictures;
}

std::string model_picture(const fs::path& directory, const PictureOptions& options) {
  return model_pictures(directory, options, {&options.towards, 1}).front();
}

}  // namespace nugget::report
