// SPDX-License-Identifier: Apache-2.0
#include "nvh/matrices/equations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/index.hpp"
#include "model/circular_motion.hpp"

namespace nugget::nvh {
namespace {

/// Directions of one node that are held: orthonormal, none to three.
struct Held {
  std::vector<Vec3d> direction;

  /// The unit direction that `d` takes away of what was left; zero: none.
  Vec3d add(Vec3d d) {
    for (const Vec3d& h : direction) d -= dot(h, d) * h;
    if (!(dot(d, d) > 1e-12)) return {};
    direction.push_back(unit(d));
    return direction.back();
  }
  /// Directions that are left: the global axes where those will do, completed otherwise.
  std::vector<Vec3d> free() const {
    Held taken = *this;
    std::vector<Vec3d> rest;
    while (taken.direction.size() < 3) {
      Vec3d best{};
      for (Vec3d d : global_axes) {
        for (const Vec3d& h : taken.direction) d -= dot(h, d) * h;
        if (dot(d, d) > dot(best, best) + 1e-9) best = d;
      }
      rest.push_back(unit(best));
      taken.direction.push_back(rest.back());
    }
    return rest;
  }
};

/// What acts on each node: something that needs its translations, its rotations.
struct Needs {
  std::vector<char> translation, rotation;
};

Needs needs_of(const system::System& system) {
  Needs needs{std::vector<char>(system.all_nodes(), 0), std::vector<char>(system.all_nodes(), 0)};
  for (const auto& group : system.groups)
    for (std::size_t e = 0; e < group->size(); ++e) {
      if (!group->alive(e)) continue;
      const system::ElementNodes node = group->nodes(e);
      for (std::size_t a = 0; a < at(group->nodes_per_element); ++a) {
        needs.translation[node[a]] = 1;
        needs.rotation[node[a]] |= group->rotational;
      }
    }
  for (const system::System::MassOnlyElement& mass_only : system.mass_only_elements())
    for (int a = 0; a < mass_only.corners; ++a) needs.translation[mass_only.node[a]] = 1;
  for (const model::PointMass& m : system.model.masses) needs.translation[system.node_of[m.node]] = 1;
  for (const model::PointInertia& p : system.model.inertias) {
    needs.translation[system.node_of[p.node]] = 1;
    needs.rotation[system.node_of[p.node]] = 1;
  }
  for (const system::RigidBody& body : system.bodies) needs.translation[body.node] = needs.rotation[body.node] = 1;
  // A dependent node hands its needs on; arms make rotations of them.
  for (std::size_t d = 0; d < system.nodes; ++d) {
    if (!system.map.dependent(static_cast<int>(d))) continue;
    for (const system::ConstraintMap::Block& b : system.map.blocks(static_cast<int>(d)))
      for (std::size_t i = 0; i < 6; ++i)
        for (std::size_t j = 0; j < 6; ++j) {
          const bool needed = i < 3 ? needs.translation[d] : needs.rotation[d];
          if (needed && b.of[i][j] != 0.0) (j < 3 ? needs.translation : needs.rotation)[b.node] = 1;
        }
  }
  return needs;
}

struct Supports {
  std::vector<Held> translation, rotation;
  std::vector<Equations::Support> list;

  void add(Equations::Support support) {
    support.taken = (support.rotation ? rotation : translation)[support.node].add(support.direction);
    list.push_back(support);
  }
};

/// SPCs that are not in force all the time: what is made of them.
void report_passing_spcs(const model::Model& model, Findings& findings) {
  int late = 0, early = 0;
  for (const model::SinglePointConstraint& spc : model.spcs) {
    late += !model.holds_at_start(spc);
    early += model.holds_at_start(spc) && !spc.holds_until(std::max(model.control.end_time, 0.0));
  }
  if (late + early > 0)
    findings.warning({model.deck, 0, 0}, "*BOUNDARY_SPC",
                     fmt::format("in a linear analysis SPCs count as they are at time 0: those activated later hold "
                                 "nothing ({} nodes), those deactivated during the run hold ({} nodes)",
                                 late, early),
                     "write BIRTH 0 and no DEATH for what holds, take out what does not");
}

Supports supports_of(const system::System& system, Findings& findings) {
  const model::Model& model = system.model;
  Supports held{std::vector<Held>(system.all_nodes()), std::vector<Held>(system.all_nodes()), {}};
  report_passing_spcs(model, findings);
  std::vector<char> held_alike(model.nodes.size(), 0);
  for (const weld::Tie& tie : system.ties.ties) held_alike[tie.node] = tie.held_alike;
  for (std::size_t s = 0; s < model.spcs.size(); ++s) {
    const model::SinglePointConstraint& spc = model.spcs[s];
    if (!model.holds_at_start(spc)) continue;
    if (held_alike[spc.node]) continue;  // what it follows is held in the same way
    const int node = system.node_of[spc.node];
    if (system.map.dependent(node) && system.follows_tied_node(node)) continue;  // likewise
    // A node that is tied by its translations alone has its own rotations.
    const unsigned own = !system.map.dependent(node) ? 63u : system.map.rotations(node) ? 0u : 56u;
    const unsigned obeyed = spc.fixed & own;
    if (obeyed != spc.fixed)
      findings.warning({model.deck, 0, 0}, "*BOUNDARY_SPC",
                       fmt::format("node {} is held by an SPC, but it moves with a rigid body or a tie; the SPC {} "
                                   "there",
                                   model.nodes.id[spc.node], obeyed == 0 ? "does nothing" : "holds its rotations only"),
                       "constrain the rigid body (MAT_RIGID CMO, *CONSTRAINED_NODAL_RIGID_BODY_SPC) instead");
    if (obeyed == 0) continue;
    for (int i = 0; i < 6; ++i) {
      if (!(obeyed >> i & 1u)) continue;
      const Frame3d local = spc.system == model::none ? Frame3d{global_axes[0], global_axes[1], global_axes[2]}
                                                      : model.systems[spc.system].axes;
      const Vec3d axis = i % 3 == 0 ? local.e1 : i % 3 == 1 ? local.e2 : local.e3;
      held.add({Equations::Support::Source::spc, s, node, i >= 3, axis, {}});
    }
  }
  for (std::size_t b = 0; b < system.bodies.size(); ++b)
    for (int i = 0; i < 6; ++i) {
      const Frame3d& own = system.bodies[b].fixed_axes;
      const Vec3d axis = i % 3 == 0 ? own.e1 : i % 3 == 1 ? own.e2 : own.e3;
      if (system.bodies[b].fixed >> i & 1u)
        held.add({Equations::Support::Source::body, b, system.bodies[b].node, i >= 3, axis, {}});
    }
  for (std::size_t m = 0; m < model.motions.size(); ++m) {
    const model::PrescribedMotion& motion = model.motions[m];
    const auto constrain = [&](int node) {
      constexpr auto source = Equations::Support::Source::motion;
      if (motion.circular) {
        const model::PlaceOnCircle place = model::place_on_circle(motion, system.ties.x[system.model_node[node]]);
        if (place.radius > 0.0 || motion.radius_fixed) held.add({source, m, node, false, place.around, {}, true});
        if (motion.radius_fixed) held.add({source, m, node, false, place.outwards, {}});
        return;
      }
      held.add({source, m, node, motion.rotation, motion.direction, {}, true});
      if (motion.only_direction) return;
      for (const Vec3d& axis : global_axes) {
        const Vec3d across = axis - dot(axis, motion.direction) * motion.direction;
        if (dot(across, across) > 1e-12) held.add({source, m, node, motion.rotation, unit(across), {}});
      }
    };
    if (motion.target != model::PrescribedMotion::Target::nodes) {
      constrain(system.bodies[system.body_of[motion.rigid_body]].node);
      continue;
    }
    for (model::Index n : motion.nodes) {
      const int node = system.node_of[n];
      if (system.map.dependent(node) && system.follows_tied_node(node)) continue;  // what it follows is driven alike
      if (system.map.dependent(node))
        findings.error(motion.place, "*BOUNDARY_PRESCRIBED_MOTION",
                       fmt::format("node {} moves with {} and cannot be driven on its own", model.nodes.id[n],
                                   system.constraint_name(node)),
                       "drive the rigid body with *BOUNDARY_PRESCRIBED_MOTION_RIGID, or nodes of the sheet");
      else
        constrain(node);
    }
  }
  return held;
}

/// Linear equations of the model in the unknowns: one after the other gives one unknown by the others.
class Eliminated {
 public:
  explicit Eliminated(int unknowns) : given_(at(unknowns)), is_given_(at(unknowns), 0) {}

  void add(std::map<int, double> row) {
    double most = 0.0;
    for (const auto& [unknown, factor] : row) most = std::max(most, std::abs(factor));
    resolve(row);
    const double nothing = 1e-12 * most;
    auto pivot = row.end();
    for (auto it = row.begin(); it != row.end(); ++it)
      if (std::abs(it->second) > (pivot == row.end() ? nothing : std::abs(pivot->second) * (1.0 + 1e-12))) pivot = it;
    if (pivot == row.end()) return;  // follows from those before it
    std::vector<Equations::Term>& given = given_[at(pivot->first)];
    for (const auto& [unknown, factor] : row)
      if (unknown != pivot->first && std::abs(factor) > nothing) given.push_back({unknown, -factor / pivot->second});
    is_given_[at(pivot->first)] = 1;
    order_.push_back(pivot->first);
  }
  /// When all are there: what is given names only what is not. Later ones first, which those before them may name.
  void finish() {
    for (auto it = order_.rbegin(); it != order_.rend(); ++it) {
      std::map<int, double> row;
      for (const Equations::Term& t : given_[at(*it)]) row[t.equation] += t.factor;
      resolve(row);
      given_[at(*it)].clear();
      for (const auto& [unknown, factor] : row) given_[at(*it)].push_back({unknown, factor});
    }
  }
  bool empty() const { return order_.empty(); }
  bool given(int unknown) const { return is_given_[at(unknown)] != 0; }
  void replace(std::vector<Equations::Term>& row) const {
    if (std::none_of(row.begin(), row.end(), [&](const Equations::Term& t) { return given(t.equation); })) return;
    std::map<int, double> all;
    for (const Equations::Term& t : row) all[t.equation] += t.factor;
    resolve(all);
    row.clear();
    for (const auto& [unknown, factor] : all) row.push_back({unknown, factor});
  }

 private:
  void resolve(std::map<int, double>& row) const {
    for (bool again = true; again;) {
      again = false;
      for (auto it = row.begin(); it != row.end(); ++it) {
        if (!given(it->first)) continue;
        const auto [unknown, factor] = *it;
        row.erase(it);
        for (const Equations::Term& t : given_[at(unknown)]) row[t.equation] += factor * t.factor;
        again = true;
        break;
      }
    }
  }
  std::vector<std::vector<Equations::Term>> given_;
  std::vector<char> is_given_;
  std::vector<int> order_;
};

}  // namespace

Equations::Equations(const system::System& system, Findings& findings) {
  const Needs needs = needs_of(system);
  Supports held = supports_of(system, findings);
  supports_ = std::move(held.list);
  const std::size_t nodes = system.all_nodes();

  // Unknowns of each node: directions of translation and rotation.
  std::vector<std::vector<Term>> own(6 * nodes);
  const auto number = [&](std::size_t node, int first, const Held& h) {
    for (const Vec3d& d : h.free()) {
      const double component[3] = {d.x, d.y, d.z};
      for (int i = 0; i < 3; ++i)
        if (component[i] != 0.0) own[6 * node + at(first + i)].push_back({size_, component[i]});
      owner_.push_back(static_cast<int>(node));
      rotation_.push_back(first == 3);
      ++size_;
    }
  };
  const auto dependent = [&](std::size_t k) { return k < system.nodes && system.map.dependent(static_cast<int>(k)); };
  for (std::size_t k = 0; k < nodes; ++k) {
    if (needs.translation[k] && !dependent(k)) number(k, 0, held.translation[k]);
    const bool own_rotation = !dependent(k) || !system.map.rotations(static_cast<int>(k));
    if (needs.rotation[k] && own_rotation) number(k, 3, held.rotation[k]);
  }

  // Rows of dependent nodes, in independent ones.
  for (std::size_t d = 0; d < system.nodes; ++d) {
    if (!dependent(d)) continue;
    const auto put = [&](int i, int node, int j, double factor) {
      if (factor == 0.0) return;
      std::vector<Term>& row = own[6 * d + at(i)];
      for (const Term& t : own[6 * at(node) + at(j)]) {
        const auto same = std::find_if(row.begin(), row.end(), [&](const Term& r) { return r.equation == t.equation; });
        if (same != row.end())
          same->factor += factor * t.factor;
        else
          row.push_back({t.equation, factor * t.factor});
      }
    };
    for (const system::ConstraintMap::Block& b : system.map.blocks(static_cast<int>(d)))
      for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j) put(i, b.node, j, b.of[i][j]);
  }

  Eliminated linear(size_);
  for (const model::LinearConstraint& equation : system.model.linear_constraints) {
    std::map<int, double> row;
    for (const model::LinearConstraint::Term& t : equation.terms) {
      const std::size_t k = at(system.node_of[t.node]);
      const auto refuse = [&](std::string_view why, const char* remedy) {
        findings.error(equation.place, equation.keyword,
                       fmt::format("equation {}: node {} {}", equation.id, system.model.nodes.id[t.node], why), remedy);
      };
      if (!(t.rotation ? needs.rotation : needs.translation)[k]) {
        refuse(t.rotation ? "has no rotation that an element knows" : "belongs to no element and no mass",
               "take nodes of elements");
        continue;
      }
      const auto& taken = (t.rotation ? held.rotation : held.translation)[k].direction;
      if (std::any_of(taken.begin(), taken.end(),
                      [&](const Vec3d& h) { return std::abs(dot(h, t.direction)) > 1e-9; })) {
        refuse("is held or driven in this direction, which is not built in linear analyses",
               "take it out of the equation where it is held");
        continue;
      }
      const double component[3] = {t.direction.x, t.direction.y, t.direction.z};
      for (int i = 0; i < 3; ++i)
        for (const Term& own_term : own[6 * k + at(i) + (t.rotation ? 3u : 0u)])
          row[own_term.equation] += t.factor * component[i] * own_term.factor;
    }
    linear.add(std::move(row));
  }
  if (!linear.empty()) {
    linear.finish();
    std::vector<int> renumbered(at(size_), -1), owner;
    std::vector<char> rotation;
    for (int i = 0; i < size_; ++i) {
      if (linear.given(i)) continue;
      renumbered[at(i)] = static_cast<int>(owner.size());
      owner.push_back(owner_[at(i)]);
      rotation.push_back(rotation_[at(i)]);
    }
    for (std::vector<Term>& row : own) {
      linear.replace(row);
      for (Term& t : row) t.equation = renumbered[at(t.equation)];
    }
    size_ = static_cast<int>(owner.size());
    owner_ = std::move(owner);
    rotation_ = std::move(rotation);
  }

  start_.reserve(own.size() + 1);
  start_.push_back(0);
  for (const std::vector<Term>& row : own) {
    terms_.insert(terms_.end(), row.begin(), row.end());
    start_.push_back(terms_.size());
  }
}

void Equations::constrain(const std::vector<char>& marked) {
  std::vector<Turned> held;
  for (std::size_t i = 0; i < marked.size(); ++i)
    if (marked[i]) held.push_back({static_cast<int>(i), 1, 0, {1.0}});
  turn(held);
}

void Equations::turn(std::span<const Turned> blocks) {
  // Of each old unknown its block, or -1, and the number that it has now; of a block that of its first direction.
  std::vector<int> block(at(size_), -1), number(at(size_), -1), owner;
  std::vector<char> rotation;
  std::size_t next = 0;
  for (int i = 0; i < size_;) {
    const bool turned = next < blocks.size() && blocks[next].first == i;
    const int count = turned ? blocks[next].count : 1, kept = turned ? blocks[next].kept : 1;
    for (int k = 0; k < count; ++k) {
      if (turned) block[at(i + k)] = static_cast<int>(next);
      number[at(i + k)] = static_cast<int>(owner.size());
    }
    owner.insert(owner.end(), at(kept), owner_[at(i)]);
    rotation.insert(rotation.end(), at(kept), rotation_[at(i)]);
    next += turned;
    i += count;
  }
  std::vector<Term> kept;
  std::vector<std::size_t> start{0};
  const auto add = [&](int equation, double factor) {
    const auto own = kept.begin() + static_cast<std::ptrdiff_t>(start.back());
    const auto same = std::find_if(own, kept.end(), [&](const Term& t) { return t.equation == equation; });
    if (same != kept.end())
      same->factor += factor;
    else
      kept.push_back({equation, factor});
  };
  for (std::size_t row = 0; row + 1 < start_.size(); ++row) {
    for (std::size_t t = start_[row]; t < start_[row + 1]; ++t) {
      const Term& term = terms_[t];
      const int first = number[at(term.equation)], b = block[at(term.equation)];
      if (b < 0) {
        kept.push_back({first, term.factor});
        continue;
      }
      const Turned& of = blocks[b];
      for (int k = 0; k < of.kept; ++k)
        if (const double share = of.basis[at((term.equation - of.first) * of.count + k)]; share != 0.0)
          add(first + k, term.factor * share);
    }
    start.push_back(kept.size());
  }
  size_ = static_cast<int>(owner.size());
  owner_ = std::move(owner);
  rotation_ = std::move(rotation);
  terms_ = std::move(kept);
  start_ = std::move(start);
}

SixDof Equations::motion(int node, std::span<const double> q) const {
  SixDof u{};
  for (int i = 0; i < 6; ++i)
    for (const Term& t : terms(node, i)) u[i] += t.factor * q[t.equation];
  return u;
}

void Equations::add_load(int node, const SixDof& load, std::span<double> f) const {
  for (int i = 0; i < 6; ++i)
    for (const Term& t : terms(node, i)) f[t.equation] += t.factor * load[i];
}

}  // namespace nugget::nvh
