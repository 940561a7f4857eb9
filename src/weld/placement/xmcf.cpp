// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <pugixml.hpp>
#include <string_view>

#include "deck/numbers.hpp"
#include "model/units.hpp"
#include "weld/placement/spot_list.hpp"

namespace nugget::weld {
namespace {

/// Millimetres in a length unit of xMCF; 0: no such unit.
double millimetres(std::string_view unit) {
  if (unit == "mm") return 1.0;
  if (unit == "m") return 1000.0;
  if (unit == "in") return 25.4;
  if (unit == "ft") return 304.8;
  return 0.0;
}

class XmcfReader {
 public:
  XmcfReader(const std::string& text, std::string file, const model::Model& model, Findings& findings)
      : text_(text), file_(std::move(file)), model_(model), findings_(findings) {}

  std::vector<SpotPoint> read() {
    pugi::xml_document document;
    const pugi::xml_parse_result result = document.load_buffer(text_.data(), text_.size());
    if (!result) {
      findings_.error(line_at(result.offset), {}, fmt::format("this is no sound XML: {}", result.description()),
                      "repair the file, or export it again");
      return {};
    }
    const pugi::xml_node root = document.child("xmcf");
    if (!root) {
      findings_.error({file_, 1, 0}, {}, "the root element is not <xmcf>",
                      "give an xMCF file of version 3, or a table");
      return {};
    }
    take_units(root.child("units"));
    for (const pugi::xml_node group : root.children("connection_group")) read_group(group);
    for (const auto& [name, left_out] : left_out_)
      findings_.warning(place(left_out.first), '<' + name + '>',
                        fmt::format("{} connection{} of this kind, the first here: not a spot weld, left out",
                                    left_out.second, left_out.second == 1 ? "" : "s"),
                        "model it by other means");
    if (points_.empty() && findings_.errors() == 0)
      findings_.error({file_, 0, 0}, {}, "the file has no spot welds", "expected <connection_0d> with <spotweld>");
    return std::move(points_);
  }

 private:
  Place line_at(std::ptrdiff_t offset) const {
    const auto end = text_.begin() + std::clamp<std::ptrdiff_t>(offset, 0, static_cast<std::ptrdiff_t>(text_.size()));
    return {file_, 1 + static_cast<int>(std::count(text_.begin(), end, '\n')), 0};
  }
  Place place(const pugi::xml_node& node) const { return line_at(node.offset_debug()); }
  void error(const pugi::xml_node& node, std::string text, std::string remedy) {
    findings_.error(place(node), fmt::format("<{}>", node.name()), std::move(text), std::move(remedy));
  }

  void take_units(const pugi::xml_node& units) {
    const std::string unit = units.attribute("length").as_string("mm");  // the schema's default
    const double in_mm = millimetres(unit);
    const auto own = model::units_of(model_);
    if (in_mm == 0.0)
      error(units, fmt::format("length unit '{}', expected mm, m, in or ft", unit), "correct the attribute");
    else if (own)
      scale_ = in_mm * own->millimetre;
    else
      findings_.warning(place(units), "<units>",
                        fmt::format("lengths in {} are taken as the model's, whose units are not recognised", unit),
                        "see that both are the same");
  }

  void read_group(const pugi::xml_node& group) {
    const std::optional<std::vector<int>> parts = parts_of(group.child("connected_to"));
    if (!parts) return;
    for (const pugi::xml_node connection : group.child("connection_list").children()) {
      if (connection.type() != pugi::node_element) continue;
      const pugi::xml_node sequence = connection.child("sequence_connection_0d");
      if (const pugi::xml_node spot = connection.child("spotweld")) {
        read_spot(connection, spot, *parts);
      } else if (sequence && sequence.child("spotweld")) {
        read_sequence(connection, sequence, *parts);
      } else {
        ++left_out_.try_emplace(kind_of(connection), connection, 0).first->second.second;
      }
    }
  }

  /// The element that says what a connection is: bolt, seamweld, adhesive_face.
  static std::string kind_of(const pugi::xml_node& connection) {
    for (const pugi::xml_node child : connection.children()) {
      const std::string_view name = child.name();
      if (child.type() == pugi::node_element && name != "loc" && name != "loc_list" && name != "appdata" &&
          name != "femdata" && name != "contact_list" && name != "custom_attributes_list" && name != "stacking" &&
          name != "face_list")
        return child.name();
    }
    return connection.name();
  }

  std::optional<std::vector<int>> parts_of(const pugi::xml_node& connected) {
    std::vector<int> parts;
    for (const pugi::xml_node part : connected.children()) {
      // An assembly is welded somewhere; which of its parts lies at a spot, the search will find.
      if (std::string_view(part.name()) == "assy") return std::vector<int>{};
      if (std::string_view(part.name()) != "part") continue;
      int id = part.attribute("pid").as_int();
      for (const char* name : {"pname", "label"}) {
        const std::string title = part.attribute(name).as_string();
        if (id != 0 || title.empty()) continue;
        for (const model::Part& own : model_.parts)
          if (own.title == title) id = own.id;
      }
      if (id == 0) {
        error(part, "no pid, and no part of the model has its pname or label as title", "give the pid");
        return std::nullopt;
      }
      parts.push_back(id);
    }
    return parts;
  }

  std::optional<Vec3d> location(const pugi::xml_node& loc) {
    std::array<double, 3> x{};
    std::string_view text = loc.child_value();
    constexpr std::string_view space = " \t\r\n";
    std::size_t count = 0;
    while (true) {
      const std::size_t begin = text.find_first_not_of(space);
      if (begin == std::string_view::npos) break;
      const std::size_t end = std::min(text.find_first_of(space, begin), text.size());
      if (count == 3 || !deck::parse_real(text.substr(begin, end - begin), x[count])) {
        count = 0;
        break;
      }
      ++count;
      text.remove_prefix(end);
    }
    if (count == 3) return scale_ * Vec3d{x[0], x[1], x[2]};
    error(loc, fmt::format("'{}', expected three numbers", loc.child_value()), "correct the location");
    return std::nullopt;
  }

  void add(const pugi::xml_node& connection, const pugi::xml_node& spot, const Vec3d& x,
           const std::vector<int>& parts) {
    SpotPoint point;
    point.x = x;
    point.parts = parts;
    point.place = place(connection);
    point.spot_class = spot.attribute("technology").as_string();
    if (const pugi::xml_attribute diameter = spot.attribute("diameter")) {
      if (!deck::parse_real(diameter.value(), point.diameter) || point.diameter <= 0.0)
        return error(spot, fmt::format("diameter '{}', expected a number above 0", diameter.value()),
                     "correct it, or leave it out: then it follows from the sheets");
      point.diameter *= scale_;
    }
    points_.push_back(std::move(point));
  }

  void read_spot(const pugi::xml_node& connection, const pugi::xml_node& spot, const std::vector<int>& parts) {
    const pugi::xml_node loc = connection.child("loc");
    if (!loc) return error(connection, "no <loc>", "give its location");
    if (const auto x = location(loc)) add(connection, spot, *x, parts);
  }

  /// Spots along a polyline: `spacing` apart, the rest shared by both ends; with priority `margin` the margins are kept
  /// and the spacing gives.
  void read_sequence(const pugi::xml_node& connection, const pugi::xml_node& sequence, const std::vector<int>& parts) {
    std::vector<std::pair<double, Vec3d>> line;  // by v, the order of the locations
    for (const pugi::xml_node loc : connection.child("loc_list").children("loc"))
      if (const auto x = location(loc)) line.emplace_back(loc.attribute("v").as_double(), *x);
    std::stable_sort(line.begin(), line.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    double length = 0.0;
    for (std::size_t i = 1; i < line.size(); ++i) length += norm(line[i].second - line[i - 1].second);
    const double spacing = scale_ * sequence.attribute("spacing").as_double();
    const double margin = scale_ * sequence.attribute("margin").as_double();
    const double inner = length - 2.0 * margin;
    if (line.size() < 2 || spacing <= 0.0 || inner < 0.0)
      return error(sequence,
                   fmt::format("{} locations, spacing {:.4g}, margin {:.4g} on a length of {:.4g}", line.size(),
                               spacing, margin, length),
                   "expected a line of two locations or more, longer than both margins, and a spacing above 0");
    const bool keep_margin = std::string_view(sequence.attribute("priority").as_string()) == "margin";
    const double spaces = keep_margin ? std::max(1.0, std::round(inner / spacing)) : std::floor(inner / spacing + 1e-9);
    const double step = keep_margin ? inner / spaces : spacing;
    const double start = keep_margin ? margin : 0.5 * (length - spaces * spacing);
    for (int k = 0; k <= static_cast<int>(spaces); ++k)
      add(connection, sequence.child("spotweld"), along(line, start + k * step), parts);
  }

  static Vec3d along(const std::vector<std::pair<double, Vec3d>>& line, double distance) {
    for (std::size_t i = 1; i < line.size(); ++i) {
      const Vec3d side = line[i].second - line[i - 1].second;
      const double length = norm(side);
      if (distance <= length) return line[i - 1].second + (length > 0.0 ? distance / length : 0.0) * side;
      distance -= length;
    }
    return line.back().second;
  }

  const std::string& text_;
  std::string file_;
  const model::Model& model_;
  Findings& findings_;
  double scale_ = 1.0;
  std::vector<SpotPoint> points_;
  std::map<std::string, std::pair<pugi::xml_node, int>> left_out_;
};

}  // namespace

std::vector<SpotPoint> read_xmcf(const std::string& text, const std::string& file, const model::Model& model,
                                 Findings& findings) {
  return XmcfReader(text, file, model, findings).read();
}

}  // namespace nugget::weld
