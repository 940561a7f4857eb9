// SPDX-License-Identifier: Apache-2.0
#include "kernel/element/section_shape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/index.hpp"
#include "kernel/element/weld_beam.hpp"

namespace nugget::kernel {
namespace {

/// How a piece is cut into cells; each has 2 x 2 Gauss points, which integrate what is needed exactly.
enum class Cut { along_s, along_t, both };

/// A rectangle or trapezoid: its middle, its height along t, its widths along s at its lower and upper side.
struct Piece {
  std::string_view name;
  double s = 0.0, t = 0.0, lower = 0.0, upper = 0.0, height = 0.0;
  Cut cut = Cut::both;
};

Piece flat(std::string_view name, double s, double t, double width, double height) {
  return {name, s, t, width, width, height, Cut::along_s};
}
Piece upright(std::string_view name, double s, double t, double width, double height) {
  return {name, s, t, width, width, height, Cut::along_t};
}

bool is_round(int type) {
  return type == 8 || type == 9;
}

/// The pieces of a shape that is not round, seen from the middle of the rectangle around it. Overlaps count once.
std::vector<Piece> pieces(const SectionShape& shape) {
  const auto& [d1, d2, d3, d4, d5, d6] = shape.d;
  switch (shape.type) {
    case 1: {  // W TF D TW
      const double web = d3 - 2.0 * d2, at = 0.5 * (d3 - d2);
      return {flat("upper flange", 0, at, d1, d2), flat("lower flange", 0, -at, d1, d2), upright("web", 0, 0, d4, web)};
    }
    case 2: {
      const double web = d3 - 2.0 * d2, at = 0.5 * (d3 - d2);
      return {flat("upper flange", 0, at, d1, d2), flat("lower flange", 0, -at, d1, d2),
              upright("web", -0.5 * (d1 - d4), 0, d4, web)};
    }
    case 3:
      return {upright("upright leg", -0.5 * (d1 - d4), 0.5 * d2, d4, d3 - d2),
              flat("lower leg", 0, -0.5 * (d3 - d2), d1, d2)};
    case 4: return {flat("flange", 0, 0.5 * (d3 - d2), d1, d2), upright("web", 0, -0.5 * d2, d4, d3 - d2)};
    case 5: {
      const double side = d3 - 2.0 * d2, at = 0.5 * (d3 - d2), across = 0.5 * (d1 - d4);
      return {flat("upper wall", 0, at, d1, d2), flat("lower wall", 0, -at, d1, d2),
              upright("left wall", -across, 0, d4, side), upright("right wall", across, 0, d4, side)};
    }
    case 6: {
      const double flange = 0.5 * (d1 + d4), at = 0.5 * (d3 - d2), across = 0.5 * (d1 - flange);
      return {flat("upper flange", -across, at, flange, d2), flat("lower flange", across, -at, flange, d2),
              upright("web", 0, 0, d4, d3 - 2.0 * d2)};
    }
    case 7: return {{"trapezium", 0, 0, d1, d2, d3, Cut::both}};
    case 10: {  // depth, lower and upper width, web, lower and upper thickness
      const double web = d1 - d5 - d6;
      return {flat("upper flange", 0, 0.5 * (d1 - d6), d3, d6), flat("lower flange", 0, -0.5 * (d1 - d5), d2, d5),
              upright("web", 0, 0.5 * (d5 - d6), d4, web)};
    }
    case 11: return {{"rectangle", 0, 0, d1, d1, d2, Cut::both}};
    case 12: {
      const double arm = 0.5 * d1, across = 0.5 * (d2 + arm);
      return {upright("stem", 0, 0, d2, d3), flat("left arm", -across, 0, arm, d4),
              flat("right arm", across, 0, arm, d4)};
    }
    case 13: {
      const double side = 0.5 * d2, across = 0.5 * (d1 + side);
      return {upright("left flange", -across, 0, side, d3), upright("right flange", across, 0, side, d3),
              flat("web", 0, 0, d1, d4)};
    }
    case 14: return {upright("flange", 0.5 * d2, 0, d3, d1), flat("web", -0.5 * d3, 0, d2, d4)};
    case 15: {
      const double flange = 0.5 * (d4 - d3), at = 0.5 * (d3 + flange);
      return {flat("upper flange", 0, at, d1 + d2, flange), flat("lower flange", 0, -at, d1 + d2, flange),
              upright("web", 0, 0, d2, d3)};
    }
    case 16: {
      const double flange = 0.5 * (d4 - d3), at = 0.5 * (d3 + flange);
      return {flat("upper flange", 0, at, d1 + d2, flange), flat("lower flange", 0, -at, d1 + d2, flange),
              upright("web", -0.5 * d1, 0, d2, d3)};
    }
    case 17: {
      const double leg = d3 - d2, across = 0.5 * (d4 - d1);
      return {flat("web", 0, -0.5 * leg, d4, d2), upright("left leg", -across, 0.5 * d2, d1, leg),
              upright("right leg", across, 0.5 * d2, d1, leg)};
    }
    case 18: return {flat("flange", 0, -0.5 * (d2 - d3), d1, d3), upright("web", 0, 0.5 * d3, d4, d2 - d3)};
    case 19: {
      const double side = d2 - d3 - d4, at = 0.5 * (d4 - d3);
      return {flat("upper wall", 0, 0.5 * (d2 - d3), d1, d3), flat("lower wall", 0, -0.5 * (d2 - d4), d1, d4),
              upright("left wall", -0.5 * (d1 - d6), at, d6, side),
              upright("right wall", 0.5 * (d1 - d5), at, d5, side)};
    }
    case 20: {
      const double narrow = d2 - 2.0 * d1, half = 0.5 * d3;
      return {{"upper half", 0, 0.5 * half, d2, narrow, half, Cut::both},
              {"lower half", 0, -0.5 * half, narrow, d2, half, Cut::both}};
    }
    case 21: {
      const double side = d1 - 2.0 * d2, across = 0.5 * (d3 - d2), brim = d4 + d2, out = 0.5 * d3 - d2 + 0.5 * brim;
      return {flat("top", 0, 0.5 * (d1 - d2), d3, d2), upright("left side", -across, 0, d2, side),
              upright("right side", across, 0, d2, side), flat("left brim", -out, -0.5 * (d1 - d2), brim, d2),
              flat("right brim", out, -0.5 * (d1 - d2), brim, d2)};
    }
    case 22: {
      const double side = d2 - 2.0 * d4 - d5, across = 0.5 * (d3 - d4), brim = d6 + d4,
                   out = 0.5 * d3 - d4 + 0.5 * brim;
      const double low = -0.5 * d2 + d5 + 0.5 * d4;
      return {flat("top", 0, 0.5 * (d2 - d4), d3, d4),
              upright("left side", -across, 0.5 * d5, d4, side),
              upright("right side", across, 0.5 * d5, d4, side),
              flat("left brim", -out, low, brim, d4),
              flat("right brim", out, low, brim, d4),
              flat("plate", 0, -0.5 * (d2 - d5), d1, d5)};
    }
    default: return {};
  }
}

/// Points of a piece cut into cells.
template <class Add>
void each_point(const Piece& p, int cells_s, int cells_t, const Add& add) {
  const double gauss = std::sqrt(1.0 / 3.0);
  for (int j = 0; j < 2 * cells_t; ++j) {
    const double eta = (2.0 * (j / 2) + 1.0 + (j % 2 == 0 ? -gauss : gauss)) / cells_t - 1.0;
    const double width = 0.5 * (p.lower + p.upper) + 0.5 * eta * (p.upper - p.lower);
    for (int i = 0; i < 2 * cells_s; ++i) {
      const double xi = (2.0 * (i / 2) + 1.0 + (i % 2 == 0 ? -gauss : gauss)) / cells_s - 1.0;
      add(p.s + 0.5 * xi * width, p.t + 0.5 * eta * p.height, 0.25 * width * p.height / (cells_s * cells_t));
    }
  }
}

/// Radii at Gauss points in their square, so that the second moments are exact.
void add_rings(FibreRule& rule, double outer, double inner, int rings, int angles) {
  const LayerRule gauss = gauss_layers(rings);
  const double area = std::numbers::pi * (outer * outer - inner * inner);
  for (int i = 0; i < rings; ++i) {
    const double square =
        0.5 * (outer * outer + inner * inner) + 0.5 * (outer * outer - inner * inner) * gauss.zeta[at(i)];
    for (int j = 0; j < angles; ++j) {
      const double angle = std::numbers::pi * (2.0 * j + 1.0) / angles;
      const auto k = at(rule.count++);
      rule.s[k] = std::sqrt(square) * std::cos(angle);
      rule.t[k] = std::sqrt(square) * std::sin(angle);
      rule.area[k] = area * gauss.weight[at(i)] / angles;
    }
  }
}

/// Of plates that are open: the sum of b t^3 / 3.
double open_torsion(const std::vector<Piece>& all) {
  double sum = 0.0;
  for (const Piece& p : all) {
    const double thickness = std::min(p.lower, p.height), length = std::max(p.lower, p.height);
    sum += length * thickness * thickness * thickness / 3.0;
  }
  return sum;
}

/// Bredt's for a rectangular cell between the middles of its walls.
double cell_torsion(double width, double height, double upper, double lower, double left, double right) {
  const double enclosed = width * height;
  return 4.0 * enclosed * enclosed / (width / upper + width / lower + height / left + height / right);
}

double torsion_constant(const SectionShape& shape, const ShapeConstants& c) {
  const auto& [d1, d2, d3, d4, d5, d6] = shape.d;
  const double polar = c.moment_s + c.moment_t;
  switch (shape.type) {
    case 5: return cell_torsion(d1 - d4, d3 - d2, d2, d2, d4, d4);
    case 19: return cell_torsion(d1 - 0.5 * (d5 + d6), d2 - 0.5 * (d3 + d4), d3, d4, d6, d5);
    case 22: return cell_torsion(d3 - d4, d2 - 0.5 * (d4 + d5), d4, d5, d4, d4);
    case 7:
    case 20: return c.area * c.area * c.area * c.area / (40.0 * polar);
    case 8:
    case 9: return polar;
    case 11: return polar * rectangle_torsion_share(d1, d2);
    default: return open_torsion(pieces(shape));
  }
}

struct Form {
  std::string_view name;
  int dimensions;
};
constexpr std::array<Form, section_shapes> forms{{
    {"a W-section", 4},
    {"a channel", 4},
    {"an angle", 4},
    {"a T-section", 4},
    {"a rectangular tube", 4},
    {"a Z-section", 4},
    {"a trapezium", 3},
    {"a full circle", 1},
    {"a round tube", 2},
    {"an I-section of two flanges", 6},
    {"a full rectangle", 2},
    {"a cross", 4},
    {"an H-section", 4},
    {"a T-section on its side", 4},
    {"an I-section by its web", 4},
    {"a channel by its web", 4},
    {"a U-section", 4},
    {"a T-section upside down", 4},
    {"a box of four walls", 6},
    {"a hexagon", 3},
    {"a hat", 4},
    {"a hat on a plate", 6},
}};

}  // namespace

std::string_view shape_name(int type) {
  return forms[at(type - 1)].name;
}

int shape_dimensions(int type) {
  return forms[at(type - 1)].dimensions;
}

std::optional<ShapeFault> shape_fault(const SectionShape& shape) {
  const int count = shape_dimensions(shape.type);
  for (int i = 0; i < 6; ++i) {
    const double d = shape.d[at(i)];
    // A tube without a hole and a triangle are shapes, too; a plate needs no brims of its own.
    const bool may_be_zero = (shape.type == 9 && i == 1) || (shape.type == 7 && i < 2);
    if (i < count && !(d > 0.0 || (may_be_zero && d == 0.0)))
      return ShapeFault{i, fmt::format("{} needs D1 to D{}, above 0", shape_name(shape.type), count)};
    if (i >= count && d != 0.0)
      return ShapeFault{i, fmt::format("{} has {} dimension{}", shape_name(shape.type), count, count == 1 ? "" : "s")};
  }
  if (shape.type == 9 && shape.d[1] >= shape.d[0])
    return ShapeFault{1, "the inner radius must be smaller than the outer one"};
  if (shape.type == 7 && !(shape.d[0] + shape.d[1] > 0.0)) return ShapeFault{0, "a trapezium needs a width"};
  const auto wrong = [](const Piece& p) {
    return !(p.lower >= 0.0 && p.upper >= 0.0 && p.height > 0.0 && p.lower + p.upper > 0.0);
  };
  for (const Piece& p : pieces(shape))
    if (wrong(p))
      return ShapeFault{0, fmt::format("these dimensions do not make {}: its {} would be {:g} wide and {:g} high",
                                       shape_name(shape.type), p.name, std::min(p.lower, p.upper), p.height)};
  return std::nullopt;
}

ShapeConstants shape_constants(const SectionShape& shape) {
  ShapeConstants c;
  if (is_round(shape.type)) {
    const double outer = shape.d[0], inner = shape.type == 9 ? shape.d[1] : 0.0;
    c.area = std::numbers::pi * (outer * outer - inner * inner);
    c.moment_s = c.moment_t = 0.25 * c.area * (outer * outer + inner * inner);
    c.extent_s = c.extent_t = 2.0 * outer;
  } else {
    double first_s = 0.0, first_t = 0.0;
    for (const Piece& p : pieces(shape)) {
      each_point(p, 1, 1, [&](double s, double t, double area) {
        c.area += area;
        first_s += area * s;
        first_t += area * t;
        c.moment_s += area * t * t;
        c.moment_t += area * s * s;
        c.product += area * s * t;
      });
      c.extent_s = std::max(c.extent_s, 2.0 * (std::abs(p.s) + 0.5 * std::max(p.lower, p.upper)));
      c.extent_t = std::max(c.extent_t, 2.0 * (std::abs(p.t) + 0.5 * p.height));
    }
    c.centre_s = first_s / c.area;
    c.centre_t = first_t / c.area;
    c.moment_s -= c.area * c.centre_t * c.centre_t;
    c.moment_t -= c.area * c.centre_s * c.centre_s;
    c.product -= c.area * c.centre_s * c.centre_t;
  }
  c.torsion = torsion_constant(shape, c);
  return c;
}

FibreRule shape_fibres(const SectionShape& shape, int refinement) {
  const int cells = 2 * (1 + refinement);
  FibreRule rule;
  if (is_round(shape.type)) {
    const int rings = 2 + refinement, angles = 8 * (1 + refinement);
    if (rings * angles <= most_fibres) add_rings(rule, shape.d[0], shape.type == 9 ? shape.d[1] : 0.0, rings, angles);
    return rule;
  }
  const std::vector<Piece> all = pieces(shape);
  const auto cells_of = [&](Cut cut, Cut other) { return cut == other ? 1 : cells; };
  int count = 0;
  for (const Piece& p : all) count += 4 * cells_of(p.cut, Cut::along_t) * cells_of(p.cut, Cut::along_s);
  if (count > most_fibres) return rule;
  for (const Piece& p : all)
    each_point(p, cells_of(p.cut, Cut::along_t), cells_of(p.cut, Cut::along_s), [&](double s, double t, double area) {
      const auto k = at(rule.count++);
      rule.s[k] = s;
      rule.t[k] = t;
      rule.area[k] = area;
    });
  return rule;
}

SectionPoints shape_points(const SectionShape& shape, int refinement, double node_s, double node_t) {
  const ShapeConstants c = shape_constants(shape);
  const double away_s = 0.5 * node_s * c.extent_s, away_t = 0.5 * node_t * c.extent_t;
  SectionPoints points{shape_fibres(shape, refinement), c.torsion / (c.moment_s + c.moment_t), c.centre_s - away_s,
                       c.centre_t - away_t};
  for (std::size_t k = 0; k < at(points.fibres.count); ++k) {
    points.fibres.s[k] -= away_s;
    points.fibres.t[k] -= away_t;
  }
  return points;
}

SectionPoints user_points(const FibreRule& fibres) {
  double area = 0.0, s = 0.0, t = 0.0;
  for (std::size_t k = 0; k < at(fibres.count); ++k) {
    area += fibres.area[k];
    s += fibres.area[k] * fibres.s[k];
    t += fibres.area[k] * fibres.t[k];
  }
  return {fibres, 1.0, s / area, t / area};
}

}  // namespace nugget::kernel
