// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <map>
#include <numbers>

#include "base/index.hpp"
#include "deck/reader.hpp"
#include "deck/text.hpp"

namespace nugget::deck {
namespace {

using Matrix = std::array<double, 12>;

constexpr Matrix identity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};

Vec3d turned(const Matrix& m, const Vec3d& v) {
  return {m[0] * v.x + m[1] * v.y + m[2] * v.z, m[4] * v.x + m[5] * v.y + m[6] * v.z,
          m[8] * v.x + m[9] * v.y + m[10] * v.z};
}

Vec3d shift(const Matrix& m) {
  return {m[3], m[7], m[11]};
}

Matrix matrix(const Vec3d& x, const Vec3d& y, const Vec3d& z, const Vec3d& b) {
  return {x.x, y.x, z.x, b.x, x.y, y.y, z.y, b.y, x.z, y.z, z.z, b.z};
}

/// The map that does `inner` first.
Matrix product(const Matrix& outer, const Matrix& inner) {
  const auto column = [&](std::size_t c) { return turned(outer, {inner[c], inner[4 + c], inner[8 + c]}); };
  return matrix(column(0), column(1), column(2), turned(outer, shift(inner)) + shift(outer));
}

/// A linear map about a fixed point.
Matrix about(const Vec3d& point, const Vec3d& x, const Vec3d& y, const Vec3d& z) {
  const Matrix linear = matrix(x, y, z, {});
  return matrix(x, y, z, point - turned(linear, point));
}

Matrix rotation(const Vec3d& axis, const Vec3d& point, double degrees) {
  const Vec3d n = unit(axis);
  const double angle = degrees * std::numbers::pi / 180.0;
  const double c = std::cos(angle), s = std::sin(angle);
  const auto rotated = [&](const Vec3d& e) { return c * e + s * cross(n, e) + (1.0 - c) * dot(n, e) * n; };
  return about(point, rotated({1, 0, 0}), rotated({0, 1, 0}), rotated({0, 0, 1}));
}

Matrix mirror(const Vec3d& point, const Vec3d& normal) {
  const Vec3d n = unit(normal);
  const auto reflected = [&](const Vec3d& e) { return e - 2.0 * dot(n, e) * n; };
  return about(point, reflected({1, 0, 0}), reflected({0, 1, 0}), reflected({0, 0, 1}));
}

/// Origin p1, x towards p2, p3 in the xy plane.
Frame3d frame(const Vec3d& p1, const Vec3d& p2, const Vec3d& p3) {
  const Vec3d e1 = unit(p2 - p1);
  const Vec3d e3 = unit(cross(e1, p3 - p1));
  return {e1, cross(e3, e1), e3};
}

Matrix placed(const std::array<Vec3d, 6>& p) {
  const Frame3d from = frame(p[0], p[1], p[2]), to = frame(p[3], p[4], p[5]);
  const auto image = [&](const Vec3d& e) { return to.global(from.local(e)); };
  const Vec3d x = image({1, 0, 0}), y = image({0, 1, 0}), z = image({0, 0, 1});
  return matrix(x, y, z, p[3] - turned(matrix(x, y, z, {}), p[0]));
}

Frame3d columns_of(const Matrix& m) {
  return {{m[0], m[4], m[8]}, {m[1], m[5], m[9]}, {m[2], m[6], m[10]}};
}

/// The orthogonal factor of the polar decomposition of a map, by Newton's iteration X <- (X + X^-T) / 2 (Higham, SIAM
/// J. Sci. Stat. Comput. 7, 1986): a rotation, and with a mirror where the map mirrors. These come back as they are.
Frame3d rotation_of(const Matrix& m) {
  Frame3d x = columns_of(m);
  for (int i = 0; i < 100; ++i) {
    const Vec3d a = cross(x.e2, x.e3), b = cross(x.e3, x.e1), c = cross(x.e1, x.e2);
    const double determinant = dot(x.e1, a);
    const Vec3d da = 0.5 * ((1.0 / determinant) * a - x.e1), db = 0.5 * ((1.0 / determinant) * b - x.e2),
                dc = 0.5 * ((1.0 / determinant) * c - x.e3);
    if (norm(da) + norm(db) + norm(dc) < 1e-12) break;
    x = {x.e1 + da, x.e2 + db, x.e3 + dc};
  }
  return x;
}

bool is_finite(const Matrix& m) {
  for (const double v : m) {
    if (!std::isfinite(v)) return false;
  }
  return true;
}

struct TransformationId {
  int tranid = 0;
};
const CardOf<TransformationId> id_card{
    {&TransformationId::tranid, id("tranid", IdSpace::define, required, "id of the transformation")},
};

/// A line of *DEFINE_TRANSFORMATION: the kind of motion and its arguments A1 to A7.
struct Motion {
  std::string option;
  std::array<double, 7> a{};
};

FieldOf<Motion> argument(std::size_t i, std::string_view name) {
  RealField f = real(name, dimension::number, 0.0, any_value, "argument of the option");
  f.zero_is_default = false;
  return {at(&Motion::a, i), f};
}
const CardOf<Motion> motion_card{
    {&Motion::option, text("option", 10, "kind of motion")},
    argument(0, "a1"),
    argument(1, "a2"),
    argument(2, "a3"),
    argument(3, "a4"),
    argument(4, "a5"),
    argument(5, "a6"),
    argument(6, "a7"),
};

/// Reads the lines of one *DEFINE_TRANSFORMATION.
class TransformationCards {
 public:
  TransformationCards(const Deck& deck, Findings& findings) : deck_(deck), findings_(findings) {}

  /// x' = T1 T2 ... Tn x: the last line acts first.
  Transform read(Cursor& cursor) {
    Matrix total = identity;
    while (cursor.more()) {
      const RowOf<Motion> row = cursor.read(motion_card);
      const Matrix one = motion(row);
      if (is_finite(one)) {
        total = product(total, one);
      } else {
        row[&Motion::option].report(findings_, Severity::error,
                                    "the points or vectors of this line span no axis or plane",
                                    "give points apart from each other and a vector that is not zero");
      }
    }
    Transform transform;
    transform.matrix = total;
    transform.mirrors_systems = mirrors_systems_;
    return transform;
  }

 private:
  Matrix motion(const RowOf<Motion>& row) {
    const std::string option = upper(row->option);
    const auto a = [&](int i) { return row->a[i - 1]; };
    const Vec3d first{a(1), a(2), a(3)}, second{a(4), a(5), a(6)};
    if (option == "TRANSL") return matrix({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, first);
    if (option == "SCALE") return scaling(row, first);
    if (option == "MIRROR") {
      mirrors_systems_ = mirrors_systems_ || a(7) == 1.0;
      return mirror(first, second - first);
    }
    if (option == "POINT") {
      points_[static_cast<long>(a(1))] = {a(2), a(3), a(4)};
      return identity;
    }
    if (option == "TRANSL2ND") {
      const Vec3d d = unit(node(row, 2) - node(row, 1));
      return matrix({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, a(3) * d);
    }
    if (option == "ROTATE") {
      if (a(4) != 0.0 || a(5) != 0.0 || a(6) != 0.0 || a(7) != 0.0) return rotation(first, second, a(7));
      // An axis and no angle (decks that take the angle from a parameter): ids of points are above 0.
      if (!(a(1) > 0.0 && a(2) > 0.0)) return identity;
      const Vec3d from = point_or_node(row, 1);
      return rotation(point_or_node(row, 2) - from, from, a(3));
    }
    if (option == "POS6P" || option == "POS6N") {
      std::array<Vec3d, 6> p;
      for (int i = 0; i < 6; ++i) p[i] = option == "POS6P" ? point_or_node(row, i + 1) : node(row, i + 1);
      return placed(p);
    }
    row[&Motion::option].report(findings_, Severity::error, "this option of *DEFINE_TRANSFORMATION is not supported",
                                "use TRANSL, TRANSL2ND, ROTATE, SCALE, MIRROR, POINT, POS6P or POS6N");
    return identity;
  }

  Matrix scaling(const RowOf<Motion>& row, const Vec3d& f) {
    if (f.x == 0.0 || f.y == 0.0 || f.z == 0.0) {
      row[&Motion::option].report(findings_, Severity::error, "a scale factor is 0",
                                  "give all three factors; 1 keeps an axis as it is");
      return identity;
    }
    return matrix({f.x, 0, 0}, {0, f.y, 0}, {0, 0, f.z}, {});
  }

  /// The point or node that argument `i` (from 1) names.
  Vec3d point_or_node(const RowOf<Motion>& row, int i) {
    const auto point = points_.find(static_cast<long>(row->a[i - 1]));
    return point == points_.end() ? node(row, i) : point->second;
  }

  /// Nodes under *INCLUDE_TRANSFORM are not known yet when transformations are worked out.
  Vec3d node(const RowOf<Motion>& row, int number) {
    if (!nodes_read_) {
      nodes_read_ = true;
      Findings elsewhere;  // the reader of the model reports what is wrong with the nodes
      NodeTable table;
      for (const Block& b : deck_.blocks) {
        if (b.keyword == "NODE" && b.transform == nullptr) read_nodes(deck_, b, table, elsewhere);
      }
      for (std::size_t i = 0; i < table.id.size(); ++i) nodes_[table.id[i]] = table.x[i];
    }
    const auto found = nodes_.find(static_cast<long>(row->a[number - 1]));
    if (found != nodes_.end()) return found->second;
    row[at(&Motion::a, at(number - 1))].report(
        findings_, Severity::error, "there is no such point or node (nodes under *INCLUDE_TRANSFORM do not count)",
        "define it with POINT above this line, or with *NODE outside of *INCLUDE_TRANSFORM");
    return {};
  }

  const Deck& deck_;
  Findings& findings_;
  std::map<long, Vec3d> points_;
  std::map<long, Vec3d> nodes_;
  bool nodes_read_ = false, mirrors_systems_ = false;
};

}  // namespace

Vec3d Transform::point(const Vec3d& x) const {
  return moved(length * x);
}
Vec3d Transform::moved(const Vec3d& x) const {
  return turned(matrix, x) + shift(matrix);
}
Vec3d Transform::direction(const Vec3d& d) const {
  return turn.global(d);
}
bool Transform::turns() const {
  return norm(turn.e1 - Vec3d{1, 0, 0}) + norm(turn.e2 - Vec3d{0, 1, 0}) + norm(turn.e3 - Vec3d{0, 0, 1}) > 1e-9;
}
bool Transform::mirrors() const {
  return handedness(*this) < 0;
}
bool Transform::keeps_axes() const {
  return std::abs(turn.e1.x) + std::abs(turn.e2.y) + std::abs(turn.e3.z) > 3.0 - 1e-12;
}
bool Transform::scales() const {
  const Frame3d a = columns_of(matrix);
  return norm(a.e1 - turn.e1) + norm(a.e2 - turn.e2) + norm(a.e3 - turn.e3) > 1e-9;
}

double Transform::factor(const Dimension& d) const {
  double f = 1.0;
  if (mass != 1.0 && d.mass != 0) f *= std::pow(mass, d.mass);
  if (length != 1.0 && d.length != 0) f *= std::pow(length, d.length);
  if (time != 1.0 && d.time != 0) f *= std::pow(time, d.time);
  return f;
}

Transform composed(const Transform& outer, const Transform& inner) {
  Transform t;
  for (std::size_t i = 0; i < t.id_offset.size(); ++i) t.id_offset[i] = outer.id_offset[i] + inner.id_offset[i];
  t.mass = outer.mass * inner.mass;
  t.length = outer.length * inner.length;
  t.time = outer.time * inner.time;
  // x' = A_o L_o (A_i L_i x + b_i) + b_o, and scaling all axes alike commutes with A_i.
  Matrix rescaled = inner.matrix;
  for (const std::size_t i : {3, 7, 11}) rescaled[i] *= outer.length;
  t.matrix = product(outer.matrix, rescaled);
  return t;
}

int handedness(const Transform& transform) {
  const Matrix& m = transform.matrix;
  const double determinant = dot(cross(Vec3d{m[0], m[4], m[8]}, Vec3d{m[1], m[5], m[9]}), Vec3d{m[2], m[6], m[10]});
  return determinant > 0.0 ? 1 : determinant < 0.0 ? -1 : 0;
}

void Reader::define_transformations() {
  for (const Block& block : transformations_) {
    Cursor cursor(deck_, block, findings_);
    if (block.keyword.ends_with("_TITLE")) cursor.skip();
    const RowOf<TransformationId> row = cursor.read(id_card);
    const Transform transform = TransformationCards(deck_, findings_).read(cursor);
    const int id = row->tranid;
    if (id != 0 && !deck_.impl->transformations.emplace(id, transform).second) {
      row[&TransformationId::tranid].report(findings_, Severity::error, "this id is defined a second time",
                                            "give each transformation its own id");
    }
  }
}

void Reader::resolve_transforms() {
  for (Pending& p : pending_) {
    if (p.id != 0) {
      const Transform* const found = deck_.transformation(p.id);
      if (found == nullptr) {
        findings_.add({Severity::error, p.place, "*INCLUDE_TRANSFORM", "tranid", std::to_string(p.id),
                       "no *DEFINE_TRANSFORMATION has this id", "define it, or leave the field blank"});
      } else if (handedness(*found) == 0) {
        findings_.add({Severity::error, p.place, "*INCLUDE_TRANSFORM", "tranid", std::to_string(p.id),
                       "the transformation flattens the file", "give scale factors other than 0"});
      } else if (found->mirrors_systems) {
        findings_.add({Severity::error, p.place, "*INCLUDE_TRANSFORM", "tranid", std::to_string(p.id),
                       "A7 = 1 of MIRROR, left-handed coordinate systems, is not built",
                       "leave A7 empty: local x and y axes are mirrored, and z is x times y"});
      } else {
        p.own.matrix = found->matrix;
      }
    }
    *p.target = p.outer == nullptr ? p.own : composed(*p.outer, p.own);
    p.target->turn = rotation_of(p.target->matrix);
    if (p.id != 0 && p.target->scales())
      findings_.add(
          {Severity::warning, p.place, "*INCLUDE_TRANSFORM", "tranid", std::to_string(p.id),
           "the transformation scales nodes and points of the file; thicknesses, masses, velocities and loads "
           "stay as they are",
           "convert units with FCTLEN, FCTMAS and FCTTIM"});
  }
}

}  // namespace nugget::deck
