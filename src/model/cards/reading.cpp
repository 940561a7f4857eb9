// SPDX-License-Identifier: Apache-2.0
#include "model/cards/reading.hpp"

#include <algorithm>
#include <cmath>

namespace nugget::model {

const Card heading_card{{
    id("id", IdSpace::other, 0, "number of this definition in results and messages"),
    text("heading", 70, "its name"),
}};

const Card title_card{{text("title", 80, "its name")}};

Heading read_heading(deck::Cursor& cursor, bool present) {
  if (!present) return {};
  const deck::Row row = cursor.read(heading_card);
  return {row.integer("id"), row.text("heading")};
}

Vec3d triple(const deck::Row& row, std::string_view x, std::string_view y, std::string_view z) {
  return {row.real(x), row.real(y), row.real(z)};
}

Vec3d direction(const deck::Block& block, const deck::Row& row, std::string_view x, std::string_view y,
                std::string_view z) {
  const Vec3d d = triple(row, x, y, z);
  return block.transform ? block.transform->direction(d) : d;
}

Vec3d position(const deck::Block& block, const deck::Row& row, std::string_view x, std::string_view y,
               std::string_view z) {
  const Vec3d p = triple(row, x, y, z);
  if (!block.transform) return p;
  // The row has converted the length already; what is left is the affine map itself.
  const auto& m = block.transform->matrix;
  return {m[0] * p.x + m[1] * p.y + m[2] * p.z + m[3], m[4] * p.x + m[5] * p.y + m[6] * p.z + m[7],
          m[8] * p.x + m[9] * p.y + m[10] * p.z + m[11]};
}

int curve_below_zero(const deck::Block& block, const deck::Row& row, std::string_view field,
                     const Dimension& dimension) {
  const double value = row.real(field);
  if (!(value < 0.0)) return 0;
  if (block.transform == nullptr) return static_cast<int>(std::lround(-value));
  return static_cast<int>(std::lround(-value / block.transform->factor(dimension)) +
                          block.transform->id_offset[static_cast<std::size_t>(IdSpace::function)]);
}

double death_time(double written) {
  return written <= 0.0 || written >= forever ? forever : written;
}

void expect(Builder& builder, const deck::Row& row, Severity severity, std::initializer_list<Obeyed> fields) {
  for (const Obeyed& f : fields)
    if (row.real(f.field) != f.value) row.complain(builder.findings, severity, f.field, std::string(f.otherwise));
}

void make_unique(std::vector<Index>& indices) {
  std::sort(indices.begin(), indices.end());
  indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
}

std::vector<Index> nodes_of_parts(const Model& model, const std::vector<Index>& parts) {
  std::vector<char> wanted(model.parts.size(), 0), used(model.nodes.size(), 0);
  for (const Index p : parts) wanted[static_cast<std::size_t>(p)] = 1;
  const auto collect = [&](const auto& elements) {
    for (std::size_t e = 0; e < elements.size(); ++e) {
      if (elements.part[e] == none || !wanted[static_cast<std::size_t>(elements.part[e])]) continue;
      for (const Index n : elements.nodes(e))
        if (n != none) used[static_cast<std::size_t>(n)] = 1;
    }
  };
  collect(model.shells);
  collect(model.solids);
  collect(model.beams);
  std::vector<Index> nodes;
  for (std::size_t n = 0; n < used.size(); ++n)
    if (used[n]) nodes.push_back(static_cast<Index>(n));
  return nodes;
}

}  // namespace nugget::model
