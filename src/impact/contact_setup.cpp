// SPDX-License-Identifier: Apache-2.0
#include "impact/contact_setup.hpp"

#include <algorithm>
#include <unordered_map>

#include "base/bvh.hpp"
#include "base/index.hpp"

namespace nugget::impact {
namespace {

/// Corners of the six faces of a brick, outward.
constexpr int faces[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};

struct Face {
  std::array<int, 4> sorted;
  std::array<int, 4> node;
  std::size_t solid;
};

double volume(const model::Solids& solids, std::size_t e, const std::vector<Vec3d>& x) {
  const auto& n = solids.node[e];
  Vec3d middle{};
  for (model::Index k : n) middle += 0.125 * x[at(k)];
  double v = 0.0;
  for (const auto& f : faces) {
    const Vec3d a = x[at(n[at(f[0])])], b = x[at(n[at(f[1])])], c = x[at(n[at(f[2])])], d = x[at(n[at(f[3])])];
    v += dot(0.25 * (a + b + c + d) - middle, 0.5 * cross(c - a, d - b)) / 3.0;
  }
  return v;
}

/// The shells whose contact thickness SPOTHIN scales: those that a weld is tied to, and with SWRADF those of its sheets
/// whose centre is within so many radii of an end of the weld.
std::vector<char> shells_near_welds(const system::System& system) {
  const model::Model& model = system.model;
  std::vector<char> near(model.shells.size(), 0);
  if (model.control.weld_thinning <= 0.0 || model.control.weld_thinning >= 1.0) return near;
  std::vector<Box> centres(model.shells.size());
  for (std::size_t e = 0; e < model.shells.size(); ++e) {
    Vec3d centre{};
    for (model::Index n : model.shells.node[e]) centre += 0.25 * system.ties.x[at(n)];
    centres[e].add(centre);
  }
  const BoxTree tree(centres);
  for (const weld::Weld& w : system.ties.welds) {
    const double radius = 0.5 * w.diameter * model.control.weld_thinning_radius;
    for (const weld::Projection& p : w.ends) {
      if (!p.tied || p.kase == 0 || p.tie.shell == model::none) continue;
      near[at(p.tie.shell)] = 1;
      if (radius <= 0.0) continue;
      const Vec3d& x = p.tie.point;
      tree.overlapping(Box{x, x}.grown(radius), [&](int e) {
        if (model.shells.part[at(e)] == p.tie.part && norm(centres[at(e)].low - x) <= radius) near[at(e)] = 1;
      });
    }
  }
  return near;
}

}  // namespace

contact::SingleSurfaceSetup contact_setup(const system::System& system, const model::Contact& card) {
  const model::Model& model = system.model;
  contact::SingleSurfaceSetup setup;
  std::vector<bool> in(model.parts.size(), card.a.everything);
  for (model::Index p : card.a.parts) in[at(p)] = true;

  const auto bulk_modulus = [&](const model::Part& part) {
    const model::Material& material = model.materials[at(part.material)];
    return part.stiffness_scale * material.young() / (3.0 * (1.0 - 2.0 * std::min(material.poisson(), 0.49)));
  };
  const auto thickness = [&](const model::Part& part, double own) {
    const double t = card.thickness_a > 0.0         ? card.thickness_a
                     : part.contact_thickness > 0.0 ? part.contact_thickness
                                                    : own;
    return t * card.thickness_scale_a * part.contact_scale;
  };
  const std::vector<char> thinned = shells_near_welds(system);
  for (std::size_t e = 0; e < model.shells.size(); ++e) {
    if (!in[at(model.shells.part[e])]) continue;
    const model::Part& part = model.parts[at(model.shells.part[e])];
    contact::Segment s;
    for (std::size_t a = 0; a < 4; ++a) s.node[a] = system.node_of[at(model.shells.node[e][a])];
    s.thickness = thickness(part, model.shells.thickness[e]);
    if (thinned[e]) s.thickness *= model.control.weld_thinning;
    s.bulk_modulus = bulk_modulus(part);
    s.shell = static_cast<int>(e);
    setup.segments.push_back(s);
  }

  // Faces that only one brick has.
  std::vector<Face> all;
  for (std::size_t e = 0; e < model.solids.size(); ++e) {
    if (!in[at(model.solids.part[e])]) continue;
    for (const auto& f : faces) {
      Face face;
      face.solid = e;
      for (std::size_t a = 0; a < 4; ++a) face.node[a] = model.solids.node[e][at(f[a])];
      face.sorted = face.node;
      std::sort(face.sorted.begin(), face.sorted.end());
      const auto distinct = std::unique(face.sorted.begin(), face.sorted.end()) - face.sorted.begin();
      if (distinct < 3) continue;  // a collapsed face of a wedge or a tetrahedron
      all.push_back(face);
    }
  }
  std::stable_sort(all.begin(), all.end(), [](const Face& a, const Face& b) { return a.sorted < b.sorted; });
  for (std::size_t i = 0; i < all.size();) {
    std::size_t same = i + 1;
    while (same < all.size() && all[same].sorted == all[i].sorted) ++same;
    if (same == i + 1) {
      const Face& face = all[i];
      const model::Part& part = model.parts[at(model.solids.part[face.solid])];
      contact::Segment s;
      // A triangle repeats its third node, wherever the repetition stood in the face.
      std::vector<int> corner;
      for (int n : face.node)
        if (std::find(corner.begin(), corner.end(), n) == corner.end()) corner.push_back(n);
      if (corner.size() == 3) corner.push_back(corner[2]);
      for (std::size_t a = 0; a < 4; ++a) s.node[a] = system.node_of[at(corner[a])];
      s.bulk_modulus = bulk_modulus(part);
      s.volume = std::abs(volume(model.solids, face.solid, system.ties.x));
      setup.segments.push_back(s);
    }
    i = same;
  }
  setup.nodes = contact::nodes_of(setup.segments);
  setup.stiffness_scale = model.control.penalty_scale * card.stiffness_scale_a;
  setup.law.soft = card.soft == 1;
  setup.law.soft_scale = card.soft_scale;
  setup.law.damping = card.damping;
  setup.birth = card.birth;
  setup.death = card.death;
  return setup;
}

}  // namespace nugget::impact
