// SPDX-License-Identifier: Apache-2.0
#include "reading/builder/common_cards.hpp"

#include <algorithm>
#include <cmath>

namespace nugget::reading {

const CardOf<Heading> heading_card{
    {&Heading::id, id("id", IdSpace::other, 0, "number of this definition in results and messages")},
    {&Heading::text, text("heading", 70, "its name")},
};

const Card title_card{{text("title", 80, "its name")}};

Heading read_heading(deck::Cursor& cursor, bool present) {
  if (!present) return {};
  return *cursor.read(heading_card);
}

Vec3d direction(const deck::Block& block, const Vec3d& written) {
  return block.transform ? block.transform->direction(written) : written;
}
Vec3d position(const deck::Block& block, const Vec3d& written) {
  return block.transform ? block.transform->moved(written) : written;
}

bool is_mirrored(const deck::Block& block) {
  return block.transform && block.transform->mirrors();
}
double hand(const deck::Block& block) {
  return is_mirrored(block) ? -1.0 : 1.0;
}
void refuse_in_mirror(Builder& builder, const deck::Block& block, const deck::Entry& field, std::string_view text) {
  if (is_mirrored(block) && field.value != 0.0) refuse(builder, field, text, mirror_remedy);
}

Frame3d axes_of_include(const deck::Block& block) {
  const auto axis = [&](const Vec3d& e) { return block.transform ? block.transform->direction(e) : e; };
  return {axis({1, 0, 0}), axis({0, 1, 0}), axis({0, 0, 1})};
}

bool depends_on_axes(unsigned fixed) {
  const unsigned translations = fixed & 7u, rotations = fixed >> 3;
  return (translations != 0 && translations != 7u) || (rotations != 0 && rotations != 7u);
}

void warn_of_turned_codes(Builder& builder, const deck::Block& block, const deck::Entry& field, unsigned fixed) {
  if (block.transform && !block.transform->keeps_axes() && depends_on_axes(fixed))
    field.report(builder.findings, Severity::warning, global_codes_text, global_codes_remedy);
}

void warn_of_global_axis(Builder& builder, const deck::Block& block, const deck::Entry& field) {
  if (block.transform && block.transform->turns())
    field.report(builder.findings, Severity::warning,
                 "acts along the global axes, also where *INCLUDE_TRANSFORM turns the file", global_codes_remedy);
}

int curve_below_zero(double written) {
  return static_cast<int>(std::max(0.0, -written));
}

double death_time(double written) {
  return written <= 0.0 || written >= forever ? forever : written;
}

void expect(Builder& builder, Severity severity, std::initializer_list<Supported> fields) {
  for (const Supported& f : fields)
    if (f.field.value != f.value) f.field.report(builder.findings, severity, f.otherwise);
}

void make_unique(std::vector<Index>& indices) {
  std::sort(indices.begin(), indices.end());
  indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
}

std::vector<Index> nodes_of_parts(const Model& model, const std::vector<Index>& parts) {
  std::vector<char> wanted(model.parts.size(), 0), used(model.nodes.size(), 0);
  for (const Index p : parts) wanted[p] = 1;
  const auto collect = [&](const auto& elements) {
    for (std::size_t e = 0; e < elements.size(); ++e) {
      if (elements.part[e] == none || !wanted[elements.part[e]]) continue;
      for (const Index n : elements.nodes(e))
        if (n != none) used[n] = 1;
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

}  // namespace nugget::reading
