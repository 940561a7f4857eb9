// SPDX-License-Identifier: Apache-2.0
#include "reading/mesh/brick_clusters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "base/axis_across.hpp"
#include "model/weld_section.hpp"

namespace nugget::reading {
namespace {

constexpr double pi = std::numbers::pi;

/// r along the beam, s towards its third node, else the global axis that is farthest from r: the axes of a weld beam.
Frame3d beam_axes(const Model& m, std::size_t e) {
  const Vec3d &x1 = m.nodes.x[m.beams.node[e][0]], &x2 = m.nodes.x[m.beams.node[e][1]];
  const Vec3d r = unit(x2 - x1);
  const Vec3d s = beam_side(r, m.beams.side(e, m.nodes.x));
  return {r, s, cross(r, s)};
}

class Replacement {
 public:
  Replacement(Model& model, Findings& findings) : m_(model), control_(model.control.weld_beams), findings_(findings) {}

  void run() {
    choose();
    if (std::none_of(chosen_.begin(), chosen_.end(), [](bool c) { return c; })) return;
    keep_beams_of_mixed_parts();
    first_node_ = m_.nodes.id.empty() ? 1 : m_.nodes.id.back() + 1;
    first_solid_ = m_.solids.id.empty() ? 1 : m_.solids.id.back() + 1;
    for (std::size_t e = 0; e < chosen_.size(); ++e)
      if (chosen_[e]) replace(e);
    for (std::size_t p = 0; p < m_.parts.size(); ++p)
      if (replaced_[p] > 0) make_solid(m_.parts[p]);
    track_new_nodes();
    remove_beams();
    report_replacements();
  }

 private:
  void choose();
  void keep_beams_of_mixed_parts();
  void replace(std::size_t beam);
  Index add_node(const Vec3d& x, Index like);
  void make_solid(Part& part);
  void track_new_nodes();
  void remove_beams();
  const std::vector<Index>& bricks_of(Index beam) const { return m_.hex_assemblies[weld_of_.at(beam)].solids; }
  std::string from_beam_to_bricks(Index beam) const;
  void move_deaths(const std::vector<Index>& now);
  void move_axial_forces(const std::vector<Index>& now);
  void move_sensors(const std::vector<Index>& now);
  void move_histories(const std::vector<Index>& now);
  void move_cross_sections(const std::vector<Index>& now);
  void add_bricks(const CrossSection::Facet& beam, CrossSection& section,
                  std::vector<CrossSection::Facet>& facets) const;
  void report_replacements() const;

  Model& m_;
  const WeldBeamControl control_;
  Findings& findings_;
  std::vector<bool> chosen_;                      // of beams
  std::vector<int> replaced_;                     // beams of each part
  std::map<Index, std::vector<Index>> nodes_at_;  // new nodes of a beam's node
  std::map<Index, std::size_t> weld_of_;          // of each replaced beam, in the model's hex_assemblies
  int first_node_ = 0, first_solid_ = 0, torsion_off_ = 0;
};

void Replacement::choose() {
  chosen_.assign(m_.beams.size(), false);
  replaced_.assign(m_.parts.size(), 0);
  for (std::size_t e = 0; e < m_.beams.size(); ++e) {
    const Part& part = m_.parts[m_.beams.part[e]];
    const bool is_weld = part.material != none && m_.materials[part.material].weld != none;
    const bool is_meant = !control_.only_listed || std::find(control_.beams.begin(), control_.beams.end(),
                                                             static_cast<Index>(e)) != control_.beams.end();
    if (!is_weld || !is_meant) continue;
    const auto& n = m_.beams.node[e];
    if (norm(m_.nodes.x[n[1]] - m_.nodes.x[n[0]]) == 0.0) {
      findings_.error(
          m_.beams.place[e], "*CONTROL_SPOTWELD_BEAM",
          fmt::format("weld beam {} has no length, so that bricks in its place have no axis", m_.beams.id[e]),
          "put its nodes onto its two sheets, or leave it out by BMSID");
      continue;
    }
    chosen_[e] = true;
    ++replaced_[m_.beams.part[e]];
  }
}

/// Beams that stay and share their part with others that go get a part of their own.
void Replacement::keep_beams_of_mixed_parts() {
  std::map<Index, Index> own;
  int next = 1;
  for (const Part& part : m_.parts) next = std::max(next, part.id + 1);
  for (std::size_t e = 0; e < chosen_.size(); ++e) {
    const Index p = m_.beams.part[e];
    if (chosen_[e] || replaced_[p] == 0) continue;
    const auto [at_own, is_new] = own.try_emplace(p, static_cast<Index>(m_.parts.size()));
    if (is_new) {
      Part copy = m_.parts[p];
      copy.id = control_.part_offset != 0 ? copy.id + control_.part_offset : next++;
      if (m_.part_index(copy.id) != none)
        findings_.error(control_.place, "*CONTROL_SPOTWELD_BEAM",
                        fmt::format("the beams of part {} that stay would get the part id {}, which is taken",
                                    m_.parts[p].id, copy.id),
                        "choose another ID_OFF");
      findings_.note(
          control_.place, "*CONTROL_SPOTWELD_BEAM",
          fmt::format("the beams of part {} that are not replaced are part {} now", m_.parts[p].id, copy.id));
      m_.parts.push_back(std::move(copy));
      const auto also = [p, stays = at_own->second](std::vector<Index>& parts) {
        if (std::find(parts.begin(), parts.end(), p) != parts.end()) parts.push_back(stays);
      };
      for (Contact& c : m_.contacts) {
        also(c.a.parts);
        also(c.b.parts);
      }
      for (Set<Index>& set : m_.sets.parts) also(set.members);
      for (BodyLoad& load : m_.body_loads) also(load.parts);
      for (CrossSection& section : m_.requests.cross_sections) also(section.parts);
      for (SectionStress& stress : m_.initial_state.section_stresses) also(stress.parts);
      for (FrequencyRangeDamping& damping : m_.damping.range) also(damping.parts);
      for (RelativeDamping& damping : m_.damping.relative) also(damping.parts);
      const auto again = [p, stays = at_own->second](auto& dampings) {
        for (std::size_t i = 0, count = dampings.size(); i < count; ++i) {
          if (dampings[i].part != p) continue;
          dampings.push_back(dampings[i]);
          dampings.back().part = stays;
        }
      };
      again(m_.damping.mass);
      again(m_.damping.stiffness);
    }
    m_.beams.part[e] = at_own->second;
  }
  replaced_.resize(m_.parts.size(), 0);
}

Index Replacement::add_node(const Vec3d& x, Index like) {
  const auto node = static_cast<Index>(m_.nodes.size());
  m_.nodes.id.push_back(m_.nodes.id.back() + 1);
  m_.nodes.x.push_back(x);
  // It starts as a point of a body that moves and turns with the beam's node.
  if (!m_.initial_velocity.empty()) {
    Vec3d v = m_.initial_velocity[like];
    if (!m_.initial_spin.empty()) v += cross(m_.initial_spin[like], x - m_.nodes.x[like]);
    m_.initial_velocity.push_back(v);
  }
  if (!m_.initial_spin.empty()) m_.initial_spin.push_back(m_.initial_spin[like]);
  nodes_at_[like].push_back(node);
  return node;
}

void Replacement::replace(std::size_t e) {
  const Index part = m_.beams.part[e];
  const SectionBeam& section = m_.beam_sections[m_.parts[part].section];
  torsion_off_ += !section.torsion;
  double area = 0.0;
  for (std::size_t end = 0; end < 2; ++end)
    area += 0.125 * pi * (section.outer[end] * section.outer[end] - section.inner[end] * section.inner[end]);
  const WeldSection shape = weld_section(control_.bricks, area);
  const Frame3d axes = beam_axes(m_, e);
  std::array<std::vector<Index>, 2> nodes;
  for (std::size_t end = 0; end < 2; ++end) {
    const Index like = m_.beams.node[e][end];
    const Vec3d centre = m_.nodes.x[like];
    for (const auto& [s, t] : shape.point) nodes[end].push_back(add_node(centre + s * axes.e2 + t * axes.e3, like));
  }
  HexAssembly weld{m_.beams.id[e], {}, axes.e2, m_.beams.tied_parts[e], m_.beams.place[e]};
  for (const auto& quad : shape.quad) {
    weld.solids.push_back(static_cast<Index>(m_.solids.size()));
    m_.solids.id.push_back(m_.solids.id.empty() ? 1 : m_.solids.id.back() + 1);
    m_.solids.part.push_back(part);
    std::array<Index, 8>& corner = m_.solids.node.emplace_back();
    for (std::size_t i = 0; i < 4; ++i) {
      corner[i] = nodes[0][quad[i]];
      corner[4 + i] = nodes[1][quad[i]];
    }
    m_.solids.place.append(m_.beams.place, e);
  }
  weld_of_[static_cast<Index>(e)] = m_.hex_assemblies.size();
  m_.hex_assemblies.push_back(std::move(weld));
}

void Replacement::make_solid(Part& part) {
  const SectionBeam& beam = m_.beam_sections[part.section];
  part.kind = ElementKind::solid;
  part.section = static_cast<Index>(m_.solid_sections.size());
  SectionSolid solid;
  solid.id = beam.id;
  solid.elform = 1;
  solid.in_swforc = beam.in_swforc;
  solid.place = beam.place;
  m_.solid_sections.push_back(solid);
  if (part.hourglass != none) return;
  part.hourglass = static_cast<Index>(m_.hourglass.size());
  Hourglass h = m_.control.hourglass;
  h.type = 6;
  h.membrane = h.bending = h.warping = 1.0;
  h.place = control_.place;
  m_.hourglass.push_back(h);
}

/// Contacts, sets, rigid bodies and groups that name a node of a replaced beam name the nodes in its place too.
void Replacement::track_new_nodes() {
  const auto add = [&](std::vector<Index>& nodes) {
    const std::size_t count = nodes.size();
    for (std::size_t i = 0; i < count; ++i)
      if (const auto found = nodes_at_.find(nodes[i]); found != nodes_at_.end())
        nodes.insert(nodes.end(), found->second.begin(), found->second.end());
  };
  for (Contact& c : m_.contacts) add(c.a.nodes);
  for (Set<Index>& set : m_.sets.nodes) add(set.members);
  for (NodalForceGroup& group : m_.requests.nodal_force_groups) add(group.nodes);
  for (RigidBody& body : m_.rigid_bodies) {
    if (body.origin == RigidBody::Origin::weld) continue;
    add(body.nodes);  // the new ones come last, in their order
    std::ranges::sort(body.nodes);
  }
}

void Replacement::remove_beams() {
  std::vector<Index> now(chosen_.size(), none);
  Beams kept;
  kept.place = m_.beams.place.none_of_them();
  const Beams& all = m_.beams;
  for (std::size_t e = 0; e < chosen_.size(); ++e) {
    if (chosen_[e]) continue;
    kept.place.append(all.place, e);
    now[e] = static_cast<Index>(kept.id.size());
    kept.id.push_back(all.id[e]);
    kept.part.push_back(all.part[e]);
    kept.node.push_back(all.node[e]);
    kept.orientation.push_back(all.orientation[e]);
    kept.direction.push_back(all.direction[e]);
    kept.tied_parts.push_back(all.tied_parts[e]);
  }
  // Before the beams go: what else of the model names them.
  move_deaths(now);
  move_axial_forces(now);
  move_sensors(now);
  move_histories(now);
  move_cross_sections(now);
  m_.beams = std::move(kept);
  for (Set<Index>& set : m_.sets.beams) {
    for (Index& e : set.members) e = now[e];
    std::erase(set.members, none);
  }
}

/// `weld beam 31 is replaced by bricks (RPBHX of *CONTROL_SPOTWELD_BEAM)`.
std::string Replacement::from_beam_to_bricks(Index beam) const {
  return fmt::format("weld beam {} is replaced by bricks (RPBHX of *CONTROL_SPOTWELD_BEAM)", m_.beams.id[beam]);
}

/// All bricks of a weld are deleted when its beam was to be.
void Replacement::move_deaths(const std::vector<Index>& now) {
  std::vector<ElementDeath> deaths;
  for (ElementDeath death : m_.element_deaths) {
    if (death.kind != ElementKind::beam) {
      deaths.push_back(death);
    } else if (const Index beam = death.element; now[beam] != none) {
      death.element = now[beam];
      deaths.push_back(death);
    } else {
      death.kind = ElementKind::solid;
      for (const Index brick : bricks_of(beam)) {
        death.element = brick;
        deaths.push_back(death);
      }
    }
  }
  m_.element_deaths = std::move(deaths);
}

void Replacement::move_axial_forces(const std::vector<Index>& now) {
  for (AxialForce& force : m_.initial_state.axial_forces) {
    const auto gone = std::ranges::find_if(force.beams, [&](Index beam) { return now[beam] == none; });
    if (gone != force.beams.end())
      findings_.error(force.place, "*INITIAL_AXIAL_FORCE_BEAM",
                      from_beam_to_bricks(*gone) + ", which take no axial force of a beam",
                      "leave it a beam by BMSID, or preload the bricks by *INITIAL_STRESS_SECTION");
    for (Index& beam : force.beams) beam = now[beam];
    std::erase(force.beams, none);
  }
}

void Replacement::move_sensors(const std::vector<Index>& now) {
  for (Sensor& sensor : m_.sensors) {
    if (sensor.kind != ElementKind::beam || sensor.element == none) continue;
    if (now[sensor.element] == none)
      findings_.error(
          control_.place, "*CONTROL_SPOTWELD_BEAM",
          fmt::format("{}, and sensor {} measures that beam", from_beam_to_bricks(sensor.element), sensor.id),
          "leave it a beam by BMSID");
    sensor.element = now[sensor.element];
  }
}

void Replacement::move_histories(const std::vector<Index>& now) {
  std::vector<NamedEntity>& beams = m_.requests.history_beams;
  const auto gone = std::ranges::find_if(beams, [&](const NamedEntity& n) { return now[n.index] == none; });
  if (gone != beams.end())
    findings_.warning(control_.place, "*CONTROL_SPOTWELD_BEAM",
                      from_beam_to_bricks(gone->index) + ": elout has no rows of it and of others like it",
                      "see swforc, which has their forces");
  for (NamedEntity& n : beams) n.index = now[n.index];
  std::erase_if(beams, [](const NamedEntity& n) { return n.index == none; });
}

/// A section that a beam passes is passed by its bricks, with their nodes on the side where the beam's was.
void Replacement::move_cross_sections(const std::vector<Index>& now) {
  for (CrossSection& section : m_.requests.cross_sections) {
    std::vector<CrossSection::Facet> facets;
    const std::vector<CrossSection::Facet> before = std::move(section.facets);
    for (const CrossSection::Facet& facet : before) {
      if (facet.kind == ElementKind::beam && now[facet.element] == none) {
        add_bricks(facet, section, facets);
        continue;
      }
      facets.push_back(facet);
      if (facet.kind == ElementKind::beam) facets.back().element = now[facet.element];
    }
    section.facets = std::move(facets);
    std::ranges::sort(section.nodes);
  }
}

void Replacement::add_bricks(const CrossSection::Facet& beam, CrossSection& section,
                             std::vector<CrossSection::Facet>& facets) const {
  const std::array<Index, 2>& ends = m_.beams.node[beam.element];
  const auto end_of = [&](Index node) { return node == ends[0] ? std::size_t{0} : std::size_t{4}; };
  const std::vector<Index> named = section.nodes;
  const auto take = [&](Index node) {
    if (std::ranges::find(section.nodes, node) == section.nodes.end()) section.nodes.push_back(node);
  };
  for (const Index brick : bricks_of(beam.element)) {
    const std::array<Index, 8>& node = m_.solids.node[brick];
    CrossSection::Facet& facet = facets.emplace_back(CrossSection::Facet{ElementKind::solid, brick, {}});
    for (std::size_t i = 0; i < 4; ++i) {
      for (const CrossSection::Corner& at_beam : beam.corners)
        facet.corners.push_back({node[end_of(at_beam.from) + i], node[end_of(at_beam.to) + i], at_beam.share});
      for (const Index end : ends)
        if (std::ranges::find(named, end) != named.end()) take(node[end_of(end) + i]);
    }
  }
}

void Replacement::report_replacements() const {
  int beams = 0;
  std::string parts;
  for (std::size_t p = 0; p < replaced_.size(); ++p) {
    if (replaced_[p] == 0) continue;
    beams += replaced_[p];
    parts += fmt::format("{}{}", parts.empty() ? "" : " ", m_.parts[p].id);
  }
  findings_.note(
      control_.place, "*CONTROL_SPOTWELD_BEAM",
      fmt::format(
          "weld beams replaced by {} brick{} each: {}, of parts {}; nodes {} to {} and bricks {} to {} are new, "
          "the welds keep the ids of their beams (list in run.log)",
          control_.bricks, control_.bricks == 1 ? "" : "s", beams, parts, first_node_, m_.nodes.id.back(), first_solid_,
          m_.solids.id.back()));
  if (torsion_off_ > 0)
    findings_.warning(control_.place, "*CONTROL_SPOTWELD_BEAM",
                      fmt::format("{} of them have ITOFF = 1: bricks carry torsion all the same", torsion_off_),
                      "leave these welds beams by BMSID");
}

}  // namespace

Model with_brick_clusters(Model model, Findings& findings) {
  if (model.control.weld_beams.bricks > 0) Replacement(model, findings).run();
  return model;
}

}  // namespace nugget::reading
