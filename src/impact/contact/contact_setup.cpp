// SPDX-License-Identifier: Apache-2.0
#include "impact/contact/contact_setup.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include "base/bvh.hpp"
#include "base/index.hpp"
#include "impact/contact/edge_setup.hpp"
#include "impact/contact/element_alive.hpp"
#include "impact/contact/friction_kinds.hpp"
#include "impact/contact/whole_sides.hpp"
#include "kernel/element/tetrahedron.hpp"
#include "model/bond.hpp"
#include "model/contact_form.hpp"
#include "model/segments.hpp"
#include "weld/tie/welds.hpp"

namespace nugget::impact {
namespace {

constexpr unsigned tracked = 1, reference = 2;  // bits of contact::Segment::side

/// Corners of the six faces of a brick, outward.
constexpr int faces[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};

double volume(const std::array<model::Index, 8>& n, const std::vector<Vec3d>& x) {
  if (n[3] == n[4]) return std::abs(kernel::tetrahedron_volume({x[n[0]], x[n[1]], x[n[2]], x[n[3]]}));
  Vec3d middle{};
  for (model::Index k : n) middle += 0.125 * x[k];
  double v = 0.0;
  for (const auto& f : faces) {
    const Vec3d a = x[n[f[0]]], b = x[n[f[1]]], c = x[n[f[2]]], d = x[n[f[3]]];
    v += dot(0.25 * (a + b + c + d) - middle, 0.5 * cross(c - a, d - b)) / 3.0;
  }
  return std::abs(v);
}

/// The directions in which a body is held.
struct Directions {
  std::array<Vec3d, 3> rows{};  // of the sum of n n^t

  void add(const Vec3d& n) {
    rows[0] += n.x * n;
    rows[1] += n.y * n;
    rows[2] += n.z * n;
  }
  bool all() const { return dot(rows[0], cross(rows[1], rows[2])) > 1e-6; }
};

/// A segment by its nodes, in whatever order they stand.
using Key = std::array<model::Index, 4>;
Key key_of(Key nodes) {
  std::sort(nodes.begin(), nodes.end());
  const auto end = std::unique(nodes.begin(), nodes.end());
  std::fill(end, nodes.end(), model::none);  // a triangle, wherever it repeats a node
  return nodes;
}

/// Numbers keys as they come: each once.
class Keys {
 public:
  /// The number of a key, and whether it is a new one.
  std::pair<std::size_t, bool> add(const Key& key) {
    if (2 * (keys_.size() + 1) > table_.size()) grow(4 * (keys_.size() + 1));
    std::size_t at = hash(key) & (table_.size() - 1);
    for (; table_[at] != 0; at = (at + 1) & (table_.size() - 1))
      if (keys_[table_[at] - 1] == key) return {table_[at] - 1, false};
    keys_.push_back(key);
    table_[at] = static_cast<std::uint32_t>(keys_.size());
    return {keys_.size() - 1, true};
  }
  /// Makes room for so many.
  void reserve(std::size_t count) {
    keys_.reserve(count);
    if (2 * count > table_.size()) grow(2 * count);
  }

 private:
  static std::size_t hash(const Key& key) {
    std::uint64_t h = 0;
    for (const model::Index n : key)
      h = (h ^ static_cast<std::uint64_t>(static_cast<std::uint32_t>(n))) * 0x9e3779b97f4a7c15u;
    return h ^ (h >> 32);
  }
  void grow(std::size_t size) {
    table_.assign(std::bit_ceil(size), 0);
    for (std::size_t k = 0; k < keys_.size(); ++k) {
      std::size_t at = hash(keys_[k]) & (table_.size() - 1);
      while (table_[at] != 0) at = (at + 1) & (table_.size() - 1);
      table_[at] = static_cast<std::uint32_t>(k + 1);
    }
  }

  std::vector<Key> keys_;
  std::vector<std::uint32_t> table_;  // by hash, or the next free place after it: a number, from 1 on; 0: free
};

/// The shells whose contact thickness SPOTHIN scales: those that a weld is tied to, and with SWRADF those of its sheets
/// whose centre is within so many radii of an end of the weld.
std::vector<char> shells_near_welds(const ContactMesh& mesh) {
  const model::Model& model = mesh.model;
  std::vector<char> near(model.shells.size(), 0);
  if (model.control.weld_thinning <= 0.0 || model.control.weld_thinning >= 1.0) return near;
  std::vector<Box> centres(model.shells.size());
  for (std::size_t e = 0; e < model.shells.size(); ++e) {
    Vec3d centre{};
    for (model::Index n : model.shells.node[e]) centre += 0.25 * mesh.x[n];
    centres[e].add(centre);
  }
  const BoxTree tree(centres);
  for (const weld::Weld& w : mesh.welds) {
    const double radius = 0.5 * w.diameter * model.control.weld_thinning_radius;
    for (const weld::Projection& p : w.ends) {
      if (!p.tied || p.projection_case == 0 || p.tie.shell == model::none) continue;
      near[p.tie.shell] = 1;
      if (radius <= 0.0) continue;
      const Vec3d& x = p.tie.point;
      tree.overlapping(Box{x, x}.grown(radius), [&](int e) {
        if (model.shells.part[e] == p.tie.part && norm(centres[e].low - x) <= radius) near[e] = 1;
      });
    }
  }
  return near;
}

/// Gathers the segments of the two sides of a contact; one that belongs to both stands once. `choice`: keeps those that
/// are chosen, and an outline of all; null: keeps all.
class Surfaces {
 public:
  Surfaces(const ContactMesh& mesh, const model::Contact& card, const FrictionKinds& rough,
           const contact::SurfaceChoice* choice = nullptr)
      : mesh_(mesh),
        model_(mesh.model),
        card_(card),
        rough_(rough),
        choice_(choice),
        sides_(mesh.model),
        thinned_(shells_near_welds(mesh)) {
    if (choice_ != nullptr) outline_.sides.resize(mesh.nodes);
  }

  void add(const model::Surface& surface, unsigned side) {
    surface_ = &surface;
    std::vector<bool> in(model_.parts.size(), surface.everything);
    for (model::Index p : surface.parts) in[p] = true;
    for (std::size_t p = 0; p < in.size(); ++p)
      if (weld::of_weld_material(model_, static_cast<model::Index>(p))) in[p] = false;
    std::map<Key, bool> wanted;
    for (const model::Segment& s : surface.segments) wanted.emplace(key_of(s), false);
    keys_.reserve(model_.shells.size());
    segments_.reserve(segments_.size() + model_.shells.size());  // what is not written takes no room
    for (std::size_t e = 0; e < model_.shells.size(); ++e) {
      const auto found = wanted.find(key_of(model_.shells.node[e]));
      if ((in[model_.shells.part[e]] || found != wanted.end()) && in_box(model_.shells.node[e])) add_shell(e, side);
      if (found != wanted.end()) found->second = true;
    }
    add_faces(in, wanted, side);
  }

  std::vector<contact::Segment> take() { return std::move(segments_); }

  /// With `choice`: what is known of the whole surface, and where the segments that were kept stand in it.
  void take(contact::SurfaceContactSetup& setup) {
    setup.segments = take();
    if (choice_ == nullptr) return;
    // As contact::search_margin has it.
    if (outline_.segments > 0) setup.margin = 0.25 * (sum_of_edges_ / static_cast<double>(outline_.segments));
    outline_.thickest_node = thickest_;
    setup.number = std::move(number_);
    setup.whole = std::move(outline_);
  }

 private:
  static constexpr auto not_kept = std::numeric_limits<std::uint32_t>::max();

  bool in_box(const Key& nodes) const {
    return std::all_of(nodes.begin(), nodes.end(), [this](model::Index n) { return surface_->holds(mesh_.x[n]); });
  }

  /// 0 of a rigid part that is held.
  double density(const model::Part& part) const {
    const bool held = part.rigid_body != model::none && is_fully_prescribed(model_, part.rigid_body);
    return held ? 0.0 : model_.materials[part.material].density;
  }

  double area(const Key& nodes) const {
    const auto& x = mesh_.x;
    return 0.5 * norm(cross(x[nodes[2]] - x[nodes[0]], x[nodes[3]] - x[nodes[1]]));
  }

  double stiffness_scale(unsigned side) const {
    return side == tracked ? card_.stiffness_scale_a : card_.stiffness_scale_b;
  }

  /// `nodes`: its corners, in order.
  void add_segment(const Key& nodes, contact::Segment segment, unsigned side) {
    const auto [number, is_new] = keys_.add(key_of(nodes));
    if (is_new) {
      segment.side = side;
      place_.push_back(put(nodes, segment));
      return;
    }
    if (choice_ != nullptr) mark(segment, side);
    if (place_[number] != not_kept) segments_[place_[number]].side |= side;
  }

  void mark(const contact::Segment& segment, unsigned side) {
    for (const int n : segment.node) outline_.sides[n] |= static_cast<unsigned char>(side);
  }

  /// Where it stands among the segments; `not_kept` where it is not chosen.
  std::uint32_t put(const Key& nodes, const contact::Segment& segment) {
    if (choice_ != nullptr) {
      mark(segment, segment.side);
      outline_.covers = outline_.covers || segment.covered_by >= 0;
      thickest_ = std::max(thickest_, segment.thickness);
      std::array<Row, 4> corners{};
      for (std::size_t a = 0; a < 4; ++a) set(corners[a], mesh_.x[nodes[a]]);
      sum_of_edges_ += std::sqrt(contact::area(contact::Facet{{0, 1, 2, 3}}, corners));
      const auto number = static_cast<int>(outline_.segments++);
      if (!choice_->segment(segment)) return not_kept;
      number_.push_back(number);
    }
    segments_.push_back(segment);
    return static_cast<std::uint32_t>(segments_.size() - 1);
  }

  void add_shell(std::size_t e, unsigned side) {
    const model::Part& part = model_.parts[model_.shells.part[e]];
    contact::Segment s;
    s.thickness = shell_contact_thickness(model_, card_, e, side == tracked, mesh_.x);
    if (thinned_[e]) s.thickness *= model_.control.weld_thinning;
    s.scale = stiffness_scale(side) * part.stiffness_scale;
    s.bulk_modulus = stiffness_scale(side) * bulk_modulus(model_, part);
    s.mass = density(part) * area(model_.shells.node[e]) * model_.shells.thickness[e];
    s.kind = rough_.of_part[model_.shells.part[e]];
    s.element = static_cast<int>(e);
    const Key& whole = model_.shells.node[e];
    const std::vector<Key> pieces = sides_.pieces(whole, mesh_.x);
    for (const Key& piece : pieces) {
      for (std::size_t a = 0; a < 4; ++a) s.node[a] = mesh_.node_of[piece[a]];
      contact::Segment part_of_it = s;
      if (pieces.size() > 1) {
        // It presses as the shell does.
        const double own = shape_stiffness(piece);
        if (own > 0.0) part_of_it.bulk_modulus *= shape_stiffness(whole) / own;
      }
      add_segment(piece, part_of_it, side);
    }
  }

  /// Penalty stiffness by the shape of a shell alone, its modulus 1 [length].
  double shape_stiffness(const Key& nodes) const {
    contact::Segment s;
    s.node = nodes[3] == nodes[2] ? std::array{0, 1, 2, 2} : std::array{0, 1, 2, 3};
    s.bulk_modulus = 1.0;
    std::array<Row, 4> x{};
    for (std::size_t a = 0; a < 4; ++a) set(x[a], mesh_.x[nodes[a]]);
    return contact::penalty_stiffness(s, x);
  }

  /// Faces that one brick alone has, among those of the parts; those of a segment set that no shell is; and of an
  /// eroding contact those between two bricks, once for each: it is exposed when the other is deleted.
  void add_faces(const std::vector<bool>& in, const std::map<Key, bool>& wanted, unsigned side) {
    struct Face {
      Key node;
      std::size_t solid;
      bool listed;
    };
    std::map<Key, std::vector<Face>> found;
    for (std::size_t e = 0; e < model_.solids.size(); ++e) {
      // The sheets touch, not the adhesive between them.
      if (model::bond_of(model_, model_.parts[model_.solids.part[e]])) continue;
      for (const model::Segment& node : model::faces_of(model_.solids, e)) {
        const Key key = key_of(node);
        const auto set = wanted.find(key);
        const bool listed = set != wanted.end() && !set->second;
        if (!in_box(node)) continue;
        if (in[model_.solids.part[e]] || listed) found[key].push_back({node, e, listed});
      }
    }
    for (const auto& [key, of] : found) {
      if (of.size() == 1 || of.front().listed)
        add_segment(of.front().node, face(of.front().node, of.front().solid, side), side);
      if (!erodes(card_) || of.size() != 2 || of.front().listed) continue;
      add_covered_face(of[0].node, of[0].solid, of[1].solid, side);
      add_covered_face(of[1].node, of[1].solid, of[0].solid, side);
    }
  }

  contact::Segment face(const Key& node, std::size_t solid, unsigned side) const {
    contact::Segment s;
    for (std::size_t a = 0; a < 4; ++a) s.node[a] = mesh_.node_of[node[a]];
    const model::Part& part = model_.parts[model_.solids.part[solid]];
    s.scale = stiffness_scale(side) * part.stiffness_scale;
    s.bulk_modulus = stiffness_scale(side) * bulk_modulus(model_, part);
    s.kind = rough_.of_part[model_.solids.part[solid]];
    // Each of the four triangles of a six-node face has its share of the solid behind it.
    s.volume = volume(model_.solids.node[solid], mesh_.x) * (model_.solids.quadratic(solid) ? 0.25 : 1.0);
    s.mass = 0.5 * density(part) * s.volume;
    s.element = place_of(solid);
    return s;
  }

  int place_of(std::size_t solid) const {
    return ElementAlive::place(model_, model::ElementKind::solid, static_cast<model::Index>(solid));
  }

  void add_covered_face(const Key& node, std::size_t solid, std::size_t other, unsigned side) {
    contact::Segment s = face(node, solid, side);
    s.covered_by = place_of(other);
    s.side = side;
    put(node, s);
  }

  const ContactMesh& mesh_;
  const model::Model& model_;
  const model::Contact& card_;
  const FrictionKinds& rough_;
  const contact::SurfaceChoice* choice_;
  const model::Surface* surface_ = nullptr;  // being added
  WholeSides sides_;
  std::vector<char> thinned_;  // shells near welds
  std::vector<contact::Segment> segments_;
  Keys keys_;
  std::vector<std::uint32_t> place_;  // of the segment, by key
  // With `choice_`, of all segments.
  contact::SurfaceOutline outline_;
  double sum_of_edges_ = 0.0, thickest_ = 0.0;
  std::vector<int> number_;  // of those that are kept
};

/// The kind of friction of each node of the contact: of most of the shells at it; where there are none, of the bricks,
/// and else of the beams.
std::vector<int> kind_of_nodes(const ContactMesh& mesh, const FrictionKinds& rough) {
  const model::Model& model = mesh.model;
  std::vector<std::vector<int>> kinds(mesh.nodes);
  const auto add_elements = [&](const auto& elements, std::size_t corners) {
    std::vector<char> taken(kinds.size());
    for (std::size_t n = 0; n < kinds.size(); ++n) taken[n] = !kinds[n].empty();
    for (std::size_t e = 0; e < elements.size(); ++e)
      for (std::size_t a = 0; a < corners; ++a)
        if (const std::size_t n = at(mesh.node_of[elements.node[e][a]]); !taken[n])
          kinds[n].push_back(rough.of_part[elements.part[e]]);
  };
  add_elements(model.shells, 4);
  add_elements(model.solids, 8);
  add_elements(model.beams, 2);
  std::vector<int> of_node;
  for (std::vector<int>& at_node : kinds) of_node.push_back(contact::commonest(at_node));
  return of_node;
}

/// The nodes of a node set, each as thick as the shells at it, and as rough as the elements.
std::vector<contact::TrackedNode> listed_nodes(const ContactMesh& mesh, const model::Contact& card,
                                               const FrictionKinds& rough) {
  if (card.a.nodes.empty()) return {};
  const model::Model& model = mesh.model;
  const std::vector<int> kind = kind_of_nodes(mesh, rough);
  const std::vector<char> thinned = shells_near_welds(mesh);
  std::vector<double> sum(model.nodes.size(), 0.0);
  std::vector<int> count(model.nodes.size(), 0);
  for (std::size_t e = 0; e < model.shells.size(); ++e) {
    const model::Part& part = model.parts[model.shells.part[e]];
    const double own = contact_thickness(card, part, model.shells.thickness[e], true);
    for (int a = 0; a < (model.shells.triangle(e) ? 3 : 4); ++a) {
      sum[model.shells.node[e][a]] += thinned[e] ? own * model.control.weld_thinning : own;
      ++count[model.shells.node[e][a]];
    }
  }
  std::vector<contact::TrackedNode> nodes;
  for (model::Index n : card.a.nodes) {
    if (!card.a.holds(mesh.x[n])) continue;
    const double thickness = count[n] > 0 ? sum[n] / count[n] : contact_thickness(card, {}, 0.0, true);
    const int node = mesh.node_of[n];
    nodes.push_back({node, thickness, reference, false, kind[node]});
  }
  return nodes;
}

/// The faces of shells and bricks that have a node of the node set.
std::vector<contact::Segment> faces_at_listed_nodes(const ContactMesh& mesh, const model::Contact& card,
                                                    const FrictionKinds& rough) {
  const model::Model& model = mesh.model;
  std::vector<char> listed(model.nodes.size(), 0), in(model.parts.size(), 0);
  for (model::Index n : card.a.nodes) listed[n] = 1;
  const auto is_listed = [&](model::Index n) { return listed[n] != 0; };
  const auto mark_nodes_of = [&](const auto& elements) {
    for (std::size_t e = 0; e < elements.size(); ++e)
      if (std::any_of(elements.node[e].begin(), elements.node[e].end(), is_listed)) in[elements.part[e]] = 1;
  };
  mark_nodes_of(model.shells);
  mark_nodes_of(model.solids);
  model::Surface around;
  for (std::size_t p = 0; p < in.size(); ++p)
    if (in[p]) around.parts.push_back(static_cast<model::Index>(p));
  Surfaces surfaces(mesh, card, rough);
  surfaces.add(around, tracked);
  std::vector<contact::Segment> shown = surfaces.take();
  std::vector<char> chosen(mesh.nodes, 0);
  for (model::Index n : card.a.nodes) chosen[mesh.node_of[n]] = 1;
  std::erase_if(shown, [&](const contact::Segment& s) {
    return std::none_of(s.node.begin(), s.node.end(), [&](int n) { return chosen[n] != 0; });
  });
  return shown;
}

/// The nodes of the beams of a contact that looks at these; to be pressed by the segments of the side `against`.
std::vector<contact::TrackedNode> ends_of_bars(const ContactMesh& mesh, const model::Contact& card, unsigned against) {
  std::vector<contact::TrackedNode> nodes;
  if (!tracks_beams(card)) return nodes;
  for (const contact::Edge& bar : bars(mesh, card, false))
    for (int n : bar.node) nodes.push_back({n, bar.thickness, against, false, bar.kind});
  return nodes;
}

/// ENMASS: which nodes an eroding contact keeps when all their elements are deleted, by node.
std::vector<char> kept_without_elements(const ContactMesh& mesh) {
  const model::Model& model = mesh.model;
  std::vector<char> of_shell(mesh.nodes, 0);
  for (const auto& shell : model.shells.node)
    for (model::Index n : shell) of_shell[mesh.node_of[n]] = 1;
  const int keep = model.control.keep_nodes_of_deleted;
  for (char& node : of_shell) node = keep == 2 || (keep == 1 && node == 0) ? 1 : 0;
  return of_shell;
}

/// Both sides' nodes in one list, by node; one on both sides is against both.
std::vector<contact::TrackedNode> merged(std::vector<contact::TrackedNode> nodes) {
  const auto by_node = [](const auto& a, const auto& b) { return a.node < b.node; };
  std::stable_sort(nodes.begin(), nodes.end(), by_node);
  std::vector<contact::TrackedNode> once;
  for (const contact::TrackedNode& n : nodes) {
    if (once.empty() || once.back().node != n.node)
      once.push_back(n);
    else
      once.back().against |= n.against;
  }
  return once;
}

}  // namespace

ContactMesh::ContactMesh(const system::System& system)
    : model(system.model),
      x(system.ties.x),
      welds(system.ties.welds),
      node_of(system.node_of),
      nodes(system.all_nodes()) {}

ContactMesh::ContactMesh(const model::Model& of, const std::vector<Vec3d>& places, const std::vector<weld::Weld>& thin)
    : model(of), x(places), welds(thin), node_of(of.nodes.size()), nodes(of.nodes.size()) {
  std::iota(node_of.begin(), node_of.end(), 0);
}

std::vector<contact::SqueezedBrick> bricks_of(const system::System& system, const model::InteriorContact& contact) {
  const model::Model& model = system.model;
  std::vector<const model::InteriorPart*> in(model.parts.size(), nullptr);
  for (const model::InteriorPart& p : contact.parts)
    if (model.parts[p.part].rigid_body == model::none && !weld::of_weld_material(model, p.part) &&
        !model::bond_of(model, model.parts[p.part]))
      in[p.part] = &p;
  std::vector<contact::SqueezedBrick> bricks;
  for (std::size_t e = 0; e < model.solids.size(); ++e) {
    const model::Part& part = model.parts[model.solids.part[e]];
    const model::InteriorPart* attributes = in[model.solids.part[e]];
    if (!attributes) continue;
    contact::SqueezedBrick brick;
    for (std::size_t a = 0; a < 8; ++a) brick.node[a] = system.node_of[model.solids.node[e][a]];
    brick.element = ElementAlive::place(model, model::ElementKind::solid, static_cast<model::Index>(e));
    brick.activation = attributes->activation;
    brick.modulus = attributes->modulus > 0.0
                        ? attributes->modulus
                        : model.control.penalty_scale * attributes->scale * model.materials[part.material].young();
    bricks.push_back(brick);
  }
  return bricks;
}

bool is_fully_prescribed(const model::Model& model, model::Index rigid_body) {
  const model::RigidBody& body = model.rigid_bodies[rigid_body];
  std::array<Directions, 2> held;  // of translations, of rotations
  const Frame3d& axes = body.fixed_axes;
  const std::array<Vec3d, 3> own{axes.e1, axes.e2, axes.e3};
  for (std::size_t i = 0; i < 6; ++i)
    if (body.fixed >> i & 1u) held[i / 3].add(own[i % 3]);
  for (const model::PrescribedMotion& motion : model.motions) {
    const bool for_good = motion.drives_until(model.control.end_time) && model.curves[motion.curve].in_run;
    if (motion.rigid_body != rigid_body || !for_good) continue;
    Directions& driven = held[motion.rotation ? 1 : 0];
    driven.add(motion.direction);
    if (!motion.only_direction)
      for (const Vec3d& n : own) driven.add(n);
  }
  return held[0].all() && held[1].all();
}

double contact_thickness(const model::Contact& contact, const model::Part& part, double own, bool of_a) {
  const double given = of_a ? contact.thickness_a : contact.thickness_b;
  const double scale = of_a ? contact.thickness_scale_a : contact.thickness_scale_b;
  if (given > 0.0) return contact.keyword.find("MORTAR") != std::string::npos ? given * scale : given;
  return (part.contact_thickness > 0.0 ? part.contact_thickness : own * part.contact_scale) * scale;
}

double shell_contact_thickness(const model::Model& model, const model::Contact& contact, std::size_t shell, bool of_a,
                               const std::vector<Vec3d>& x) {
  constexpr double of_side = 0.4;
  const model::Part& part = model.parts[model.shells.part[shell]];
  const double thickness = contact_thickness(contact, part, model.shells.thickness[shell], of_a);
  const double given = of_a ? contact.thickness_a : contact.thickness_b;
  if (contact.kind != model::Contact::Kind::single_surface || model.control.full_thickness || given > 0.0 ||
      part.contact_thickness > 0.0)
    return thickness;
  double square = std::numeric_limits<double>::infinity();  // of the shortest side
  const auto& node = model.shells.node[shell];
  for (std::size_t a = 0; a < 4; ++a) {
    const Vec3d side = x[node[(a + 1) % 4]] - x[node[a]];
    if (const double own = dot(side, side); own > 0.0) square = std::min(square, own);
  }
  if (thickness * thickness <= of_side * of_side * square || contact.keyword.find("MORTAR") != std::string::npos)
    return thickness;
  return of_side * std::sqrt(square);
}

double bulk_modulus(const model::Model& model, const model::Part& part) {
  const model::Material& material = model.materials[part.material];
  return part.stiffness_scale * material.contact_young() / (3.0 * (1.0 - 2.0 * std::min(material.poisson(), 0.49)));
}

/// Where nodes are tied until the mesh tears.
static contact::CommonPlaces places_of_tied_nodes(const ContactMesh& mesh) {
  contact::CommonPlaces places;
  if (!mesh.model.tied_nodes.empty()) places.assign(mesh.nodes, -1);
  for (std::size_t k = 0; k < mesh.model.tied_nodes.size(); ++k)
    for (const model::Index n : mesh.model.tied_nodes[k].nodes) places[mesh.node_of[n]] = static_cast<int>(k);
  return places;
}

/// The penalty law that the card asks for.
static kernel::PenaltyLaw law_of(const model::Contact& card, const FrictionKinds& rough) {
  kernel::PenaltyLaw law;
  if (card.soft == 1) law.stiffness = kernel::PenaltyStiffness::node_masses;
  if (card.soft == 2) law.stiffness = kernel::PenaltyStiffness::segment_masses;
  law.soft_scale = card.soft_scale;
  law.soft_step = card.soft_step;
  law.damping = card.damping;
  law.balances_friction = card.balances_friction;
  law.friction = rough.table;
  return law;
}

/// Completes the outline of a surface, of which `setup` has the segments that were chosen, and leaves the tracked nodes
/// that were. `apart`: tracked nodes that do not follow from segments.
static void choose_nodes(const contact::SurfaceChoice& choice, const std::vector<contact::TrackedNode>& apart,
                         bool single, bool both_ways, contact::SurfaceContactSetup& setup) {
  contact::SurfaceOutline& whole = *setup.whole;
  std::vector<int> of_segments;
  for (std::size_t n = 0; n < whole.sides.size(); ++n) {
    const bool of_a = (whole.sides[n] & tracked) != 0, of_b = both_ways && (whole.sides[n] & reference) != 0;
    if (of_a) whole.pressing |= single ? tracked : reference;
    if (of_b) whole.pressing |= tracked;
    if (of_a || of_b) of_segments.push_back(static_cast<int>(n));
  }
  std::vector<int> of_others;
  for (const contact::TrackedNode& n : apart) {
    of_others.push_back(n.node);
    whole.pressing |= n.against;
    whole.thickest_node = std::max(whole.thickest_node, n.thickness);
  }
  std::ranges::sort(of_others);
  std::ranges::set_union(of_segments, of_others, std::back_inserter(whole.tracked));
  whole.tracked.erase(std::unique(whole.tracked.begin(), whole.tracked.end()), whole.tracked.end());
  std::erase_if(setup.nodes, [&](const contact::TrackedNode& n) { return !choice.tracked(n.node); });
}

contact::SurfaceContactSetup contact_setup(const ContactMesh& mesh, const model::Contact& card,
                                           const contact::SurfaceChoice* choice) {
  contact::SurfaceContactSetup setup;
  const FrictionKinds rough(mesh.model, card);
  const bool single = card.kind == model::Contact::Kind::single_surface;
  {
    Surfaces surfaces(mesh, card, rough, choice);
    surfaces.add(card.a, tracked);
    if (!single) surfaces.add(card.b, reference);
    surfaces.take(setup);
  }

  const bool both_ways = card.kind == model::Contact::Kind::two_surfaces;
  std::vector<contact::TrackedNode> apart;
  if (single) {
    setup.nodes = contact::nodes_of(setup.segments);
  } else {
    setup.nodes = contact::nodes_of(setup.segments, tracked, reference);
    apart = listed_nodes(mesh, card, rough);
    setup.nodes.insert(setup.nodes.end(), apart.begin(), apart.end());
    if (card.glue && !card.glue->by_force && !card.a.nodes.empty())
      setup.faces_at_nodes = faces_at_listed_nodes(mesh, card, rough);
    if (both_ways) {
      const auto others = contact::nodes_of(setup.segments, reference, tracked);
      setup.nodes.insert(setup.nodes.end(), others.begin(), others.end());
    }
  }
  const auto ends = ends_of_bars(mesh, card, single ? tracked : reference);
  setup.nodes.insert(setup.nodes.end(), ends.begin(), ends.end());
  if (choice != nullptr) {
    apart.insert(apart.end(), ends.begin(), ends.end());
    choose_nodes(*choice, apart, single, both_ways, setup);
  }
  setup.nodes = merged(std::move(setup.nodes));
  if (erodes(card)) {
    std::vector<char> kept = kept_without_elements(mesh);
    for (contact::TrackedNode& n : setup.nodes) n.stays_active = kept[n.node] != 0;
    if (choice != nullptr) setup.whole->stays_active = std::move(kept);
  }
  setup.stiffness_scale = mesh.model.control.penalty_scale;
  setup.deepest = card.deepest;
  setup.edges_meet = checks_edges(card);
  setup.places = places_of_tied_nodes(mesh);
  setup.law = law_of(card, rough);
  setup.birth = card.birth;
  setup.death = card.death;
  return setup;
}

}  // namespace nugget::impact
