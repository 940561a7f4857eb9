// SPDX-License-Identifier: Apache-2.0
// Tetrahedra of ten nodes (ELFORM 16): statics, modes, impact, pressure and contact.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <set>

#include "base/index.hpp"
#include "impact/simulation/strains.hpp"
#include "linear.hpp"
#include "model/segments.hpp"
#include "nvh/statics/statics.hpp"
#include "specimen.hpp"

namespace nugget::verify {
namespace {

constexpr double young = 210000.0, poisson = 0.3, density = 7.85e-9;

/// Boxes of cubes in six tetrahedra each, around the diagonal from the first corner to the last.
class Mesh {
 public:
  /// `moved`: what an inner node is moved by.
  Mesh(Specimen& s, int part, const Vec3d& corner, const Vec3d& size, std::array<int, 3> cells, const Vec3d& moved = {})
      : specimen_(s) {
    static constexpr int pieces[6][4] = {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7},
                                         {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}};
    const auto inner = [&](int axis, int i) { return i > 0 && i < cells[axis]; };
    std::vector<int> nodes;
    const auto at = [&](int i, int j, int k) -> int& { return nodes[(k * (cells[1] + 1) + j) * (cells[0] + 1) + i]; };
    nodes.resize(std::size_t((cells[0] + 1) * (cells[1] + 1) * (cells[2] + 1)));
    for (int k = 0; k <= cells[2]; ++k)
      for (int j = 0; j <= cells[1]; ++j)
        for (int i = 0; i <= cells[0]; ++i)
          at(i, j, k) = node(corner + Vec3d{size.x * i / cells[0], size.y * j / cells[1], size.z * k / cells[2]} +
                             (inner(0, i) && inner(1, j) && inner(2, k) ? moved : Vec3d{}));
    for (int k = 0; k < cells[2]; ++k)
      for (int j = 0; j < cells[1]; ++j)
        for (int i = 0; i < cells[0]; ++i)
          for (const auto& p : pieces) {
            const auto c = [&](int b) { return at(i + (p[b] & 1), j + (p[b] >> 1 & 1), k + (p[b] >> 2)); };
            tetrahedron(part, {c(0), c(1), c(2), c(3)});
          }
  }
  std::string text() const { return "*ELEMENT_SOLID\n" + elements_; }
  std::vector<int> where(const std::function<bool(const Vec3d&)>& holds) const {
    std::vector<int> found;
    for (const auto& [id, x] : place_)
      if (holds(x)) found.push_back(id);
    return found;
  }
  std::vector<int> plane(int axis, double at) const {
    return where([=](const Vec3d& x) { return std::abs((axis == 0 ? x.x : axis == 1 ? x.y : x.z) - at) < 1e-9; });
  }
  /// *SET_SEGMENT of the faces in a plane of constant x, named by their three corners.
  std::string segments(int set, double x) const {
    std::string text = "*SET_SEGMENT\n" + fields({1.0 * set});
    static constexpr int face[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    for (const auto& c : corners_)
      for (const auto& f : face) {
        const int a = c[f[0]], b = c[f[1]], d = c[f[2]];
        const auto on = [&](int n) { return std::abs(place_.at(n).x - x) < 1e-9; };
        if (on(a) && on(b) && on(d)) text += fields({1.0 * a, 1.0 * b, 1.0 * d, 1.0 * d});
      }
    return text;
  }
  const std::vector<std::array<int, 4>>& corners() const { return corners_; }
  const Vec3d& place(int id) const { return place_.at(id); }

 private:
  int node(const Vec3d& x) {
    const int id = specimen_.node(x);
    place_[id] = x;
    return id;
  }
  int amid(int a, int b) {
    const auto [it, is_new] = amid_.try_emplace(std::minmax(a, b), 0);
    if (is_new) it->second = node(0.5 * (place_.at(a) + place_.at(b)));
    return it->second;
  }
  void tetrahedron(int part, const std::array<int, 4>& c) {
    static int last = 0;  // ids of different meshes must differ
    corners_.push_back(c);
    elements_ += fmt::format("{:8d}{:8d}\n", ++last, part);
    for (const int n : {c[0], c[1], c[2], c[3], amid(c[0], c[1]), amid(c[1], c[2]), amid(c[2], c[0]), amid(c[0], c[3]),
                        amid(c[1], c[3]), amid(c[2], c[3])})
      elements_ += fmt::format("{:8d}", n);
    elements_ += '\n';
  }

  Specimen& specimen_;
  std::map<int, Vec3d> place_;
  std::map<std::pair<int, int>, int> amid_;
  std::vector<std::array<int, 4>> corners_;
  std::string elements_;
};

Specimen steel(const std::string& control) {
  Specimen s;
  s.text(control);
  s.card("MAT_ELASTIC", {1, density, young, poisson}).card("SECTION_SOLID", {1, 16}).part(1, 1, 1);
  return s;
}

const std::string statics =
    "*CONTROL_IMPLICIT_GENERAL\n         1       1.0\n*CONTROL_IMPLICIT_SOLUTION\n         1\n"
    "*CONTROL_TERMINATION\n       1.0\n";
const std::string unit_ramp =
    "*DEFINE_CURVE\n         9\n                 0.0                 0.0\n                 1.0                 1.0\n";

nvh::Statics solve(const LinearExperiment& experiment) {
  Findings findings;
  nvh::Statics solved = nvh::solve_statics(experiment.matrices(), findings);
  EXPECT_EQ(findings.errors(), 0);
  EXPECT_LT(solved.residual, 1e-7);
  return solved;
}

void hold_in_planes_of_symmetry(Specimen& s, const Mesh& mesh) {
  for (int axis = 0; axis < 3; ++axis)
    s.node_set(1 + axis, mesh.plane(axis, 0.0))
        .card("BOUNDARY_SPC_SET", {1.0 + axis, 0, 1.0 * (axis == 0), 1.0 * (axis == 1), 1.0 * (axis == 2)});
}

// A linear field, which every mesh must give exactly; inner nodes out of line. The end is pulled by a pressure on its
// faces, named by their corners. Sabotage: thirds of the pressure to the corners; a facet of the set left out.
TEST(QuadraticTetrahedra, PulledByPressure) {
  Specimen s = steel(statics + unit_ramp);
  const Mesh mesh(s, 1, {}, {40, 10, 10}, {4, 2, 2}, {1.3, 0.9, -0.7});
  s.text(mesh.text()).text(mesh.segments(5, 40.0)).card("LOAD_SEGMENT_SET", {5, 9, -100.0});
  hold_in_planes_of_symmetry(s, mesh);
  const LinearExperiment experiment(s.deck());
  const nvh::Statics solved = solve(experiment);
  double least = 1e9, most = 0.0;
  for (const int id : mesh.plane(0, 40.0)) {
    const model::Index n = experiment.system().model.node_index(id);
    const double u = solved.motion[experiment.system().node_of[n]][0];
    least = std::min(least, u);
    most = std::max(most, u);
  }
  expect_reference("patch", "bar of 96 ten-node tetrahedra under 100 MPa: least displacement of its end [mm]", least,
                   100.0 / young * 40.0, 1e-9);
  expect_reference("patch", "the same: greatest", most, 100.0 / young * 40.0, 1e-9);
  expect_reference("patch", "the same: strain energy", solved.energy, 0.5 * 100.0 * 100.0 / young * 4000.0, 1e-9);
}

/// 100 x 10 x 10, clamped at x = 0.
Mesh cantilever(Specimen& s, std::array<int, 3> cells) {
  const Mesh mesh(s, 1, {}, {100, 10, 10}, cells);
  s.text(mesh.text()).node_set(1, mesh.plane(0, 0.0)).card("BOUNDARY_SPC_SET", {1, 0, 1, 1, 1});
  return mesh;
}

// Pure bending is a quadratic field, so one layer of elements has it exactly: the end is turned by theta about y, free
// across; its energy is E I theta^2 / (2 L). Sabotage: the element's derivatives without the nodes amid its edges.
TEST(QuadraticTetrahedra, PureBendingInOneLayerIsExact) {
  constexpr double theta = 1e-4;
  Specimen s = steel(statics + unit_ramp);
  const Mesh mesh(s, 1, {}, {100, 10, 10}, {10, 1, 1});
  s.text(mesh.text());
  const auto hold = [&](const std::vector<int>& nodes, std::array<double, 3> held) {
    for (const int id : nodes) s.card("BOUNDARY_SPC_NODE", {1.0 * id, 0, held[0], held[1], held[2]});
  };
  const auto at = [&](const Vec3d& place) {
    return mesh.where([place](const Vec3d& x) { return norm(x - place) < 1e-9; });
  };
  hold(mesh.plane(0, 0.0), {1, 0, 0});
  hold(at({0, 5, 5}), {0, 1, 1});
  hold(at({0, 0, 5}), {0, 0, 1});
  for (const int id : mesh.plane(0, 100.0)) {
    const double z = mesh.place(id).z - 5.0;
    if (z == 0.0)
      hold({id}, {1, 0, 0});
    else
      s.card("BOUNDARY_PRESCRIBED_MOTION_NODE", {1.0 * id, 1, 2, 9, theta * z});
  }
  const LinearExperiment experiment(s.deck());
  expect_reference("tetrahedra", "bar of 10 x 1 x 1 x 6 ten-node tetrahedra in pure bending: energy",
                   solve(experiment).energy, 0.5 * young * 1e4 / 12.0 * theta * theta / 100.0, 1e-9);
}

/// Mean deflection of a cantilever's end under a shear force of 1, spread evenly over its nodes.
double bent(std::array<int, 3> cells) {
  Specimen s = steel(statics + unit_ramp);
  const Mesh mesh = cantilever(s, cells);
  const std::vector<int> end = mesh.plane(0, 100.0);
  for (const int id : end) s.card("LOAD_NODE_POINT", {1.0 * id, 3, 9, 1.0 / static_cast<double>(end.size())});
  const LinearExperiment experiment(s.deck());
  const nvh::Statics solved = solve(experiment);
  double deflection = 0.0;
  for (const int id : end) {
    const model::Index n = experiment.system().model.node_index(id);
    deflection += solved.motion[experiment.system().node_of[n]][2] / static_cast<double>(end.size());
  }
  return deflection;
}

// Against CalculiX 2.20 (C3D10) on the very meshes. Timoshenko's beam: 0.00191962 mm.
TEST(QuadraticTetrahedra, CantileverAsInCalculix) {
  expect_reference("tetrahedra", "cantilever of 60 ten-node tetrahedra: deflection under 1 N, by CalculiX [mm]",
                   bent({10, 1, 1}), 0.0018730164444, 1e-6);
  expect_reference("tetrahedra", "the same, 480: deflection, by CalculiX [mm]", bent({20, 2, 2}), 0.0018983972, 1e-6);
}

const std::string modal = "*CONTROL_IMPLICIT_GENERAL\n         1       1.0\n*CONTROL_IMPLICIT_EIGENVALUE\n         8\n";

// Bending against CalculiX 2.20 (C3D10, consistent masses) on the very meshes; torsion, for which lumped masses have
// too much inertia, against Saint-Venant's bar, J = 0.1406 a^4, with its error going down with the square of the mesh.
// Sabotage: equal masses at all nodes.
TEST(QuadraticTetrahedra, ModesOfACantilever) {
  const auto frequencies = [](std::array<int, 3> cells) {
    Specimen s = steel(modal);
    cantilever(s, cells);
    const nvh::Modes modes = LinearExperiment(s.deck()).modes(5);
    std::vector<double> f;
    for (std::size_t i = 0; i < 5; ++i) f.push_back(modes.frequency(i));
    return f;
  };
  static constexpr double one_layer[] = {841.62, 843.45, 5067.37, 5094.34},
                          two_layers[] = {834.92, 835.28, 5008.91, 5012.73};
  const std::vector<double> coarse = frequencies({10, 1, 1}), fine = frequencies({20, 2, 2});
  for (std::size_t i = 0; i < 4; ++i) {
    expect_reference("tetrahedra", fmt::format("cantilever, 60 ten-node tetrahedra, mode {} by CalculiX [Hz]", i + 1),
                     coarse[i], one_layer[i], 2e-2);
    expect_reference("tetrahedra", fmt::format("cantilever, 480 ten-node tetrahedra, mode {} by CalculiX [Hz]", i + 1),
                     fine[i], two_layers[i], 1e-2);
  }
  const double torsion = std::sqrt(young / 2.6 / density * 0.1406 * 6.0) / 400.0;
  expect_reference("tetrahedra", "cantilever, 480 ten-node tetrahedra: torsion [Hz]", fine[4], torsion, 5e-2);
  EXPECT_LT(std::abs(fine[4] / torsion - 1.0), 0.4 * std::abs(coarse[4] / torsion - 1.0));
}

// Thrown, stretched and twisted at once, free of everything: energy and momentum stay, at the usual share of the step.
TEST(QuadraticTetrahedra, AFreeBlockKeepsItsEnergy) {
  Specimen s = steel("*CONTROL_TERMINATION\n5.0e-4\n*CONTROL_BULK_VISCOSITY\n0.0,1.0e-9\n");
  const Mesh mesh(s, 1, {}, {40, 10, 10}, {4, 2, 2}, {1.3, 0.9, -0.7});
  s.text(mesh.text()).node_set(1, mesh.plane(0, 40.0));
  s.card("INITIAL_VELOCITY", {1}).text("2000.0,1000.0,-500.0\n");
  Experiment experiment(s.deck());
  double start = 0.0, worst = 0.0, moved = 0.0;
  const int corner = mesh.where([](const Vec3d& x) { return norm(x - Vec3d{40, 10, 10}) < 1e-9; }).front();
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    const double total = now.energy.kinetic + now.energy.internal + now.energy.hourglass;
    if (start == 0.0) start = total;
    worst = std::max(worst, std::abs(total / start - 1.0));
    moved = std::max(moved, norm(experiment.displacement(now, corner)));
  });
  EXPECT_GT(moved, 0.1);
  EXPECT_LT(worst, 0.01);
}

// Stretched far beyond yield, free across: the stress of the law at the strain, log(1 + u/L).
TEST(QuadraticTetrahedra, PlasticBar) {
  constexpr double end = 1.0e-3, stretch = 4.0, length = 40.0, yield = 300.0, tangent = 2100.0;
  Specimen s;
  s.text("*CONTROL_TERMINATION\n" + fields({end})).text(smooth_ramp(9, end, stretch));
  s.card("MAT_PLASTIC_KINEMATIC", {1, density, young, poisson, yield, tangent, 1.0}).text(fields({}));
  s.card("SECTION_SOLID", {1, 16}).part(1, 1, 1);
  const Mesh mesh(s, 1, {}, {length, 10, 10}, {2, 2, 2}, {1.3, 0.9, -0.7});
  s.text(mesh.text());
  hold_in_planes_of_symmetry(s, mesh);
  s.node_set(4, mesh.plane(0, length)).card("BOUNDARY_PRESCRIBED_MOTION_SET", {4, 1, 2, 9});
  s.card("DATABASE_EXTENT_BINARY", {0, 0, 3, 1});
  Experiment experiment(s.deck());
  const int first = experiment.model().solids.id.front(), last = experiment.model().solids.id.back();
  double ratio = 0.0, least = 1e9, most = 0.0, plastic = 0.0, shown = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    ratio = std::max(ratio, std::abs(now.energy.ratio() - 1.0));
    if (now.state.time < 0.999 * end) return;
    least = 1e9, most = 0.0;
    for (int e = first; e <= last; ++e) {
      const auto layer = brick_layer(experiment, now, e);
      least = std::min(least, layer.stress[0]);
      most = std::max(most, layer.stress[0]);
      plastic = layer.plastic_strain;
    }
    shown = 0.0;
    const auto& places = now.system.solid_location;
    for (const auto& place : places)
      shown += impact::solid_strain(*now.system.groups[place.group], static_cast<std::size_t>(place.element))[0] /
               static_cast<double>(places.size());
  });
  const double strain = std::log(1.0 + stretch / length);
  const double stress = yield + tangent * (strain - yield / young);
  expect_reference("tetrahedra", "bar of 48 ten-node tetrahedra, stretched by a tenth: least stress [MPa]", least,
                   stress, 1e-2);
  expect_reference("tetrahedra", "the same: greatest stress [MPa]", most, stress, 1e-2);
  expect_reference("tetrahedra", "the same: plastic strain", plastic, strain - stress / young, 1e-2);
  expect_reference("tetrahedra", "the same: mean strain of the output", shown, strain, 1e-3);
  EXPECT_LT(ratio, 0.01);
}

// A block flies onto another, both of ten-node tetrahedra: what the first loses the second has, and no node, corner or
// amid an edge, goes through. Sabotage: the faces of three corners only.
TEST(QuadraticTetrahedra, BlocksCollide) {
  Specimen s = steel("*CONTROL_TERMINATION\n4.0e-5\n");
  s.part(2, 1, 1);
  const Mesh struck(s, 1, {}, {20, 20, 10}, {2, 2, 1}), flying(s, 2, {3, 4, 10.02}, {12, 11, 10}, {2, 2, 1});
  s.text(struck.text()).text(flying.text());
  s.text("*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n" + fields({1, 2, 3, 3}) + fields({}) + fields({}));
  s.node_set(1, flying.where([](const Vec3d&) { return true; }));
  s.card("INITIAL_VELOCITY", {1}).text("0.0,0.0,-5000.0\n");
  Experiment experiment(s.deck());
  double deepest = 0.0, momentum = 0.0, contact = 0.0;
  const std::vector<int> lower = flying.plane(2, 10.02), upper = struck.plane(2, 10.0);
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    momentum = 0.0;
    for (const Mesh* mesh : {&struck, &flying})
      for (const int id : mesh->where([](const Vec3d&) { return true; }))
        momentum += experiment.system().mass[experiment.node(id)] * experiment.velocity(now, id).z;
    double top = 0.0;
    for (const int id : upper) top = std::max(top, experiment.position(now, id).z);
    for (const int id : lower) deepest = std::max(deepest, top - experiment.position(now, id).z);
    contact = std::max(contact, now.energy.contact);
  });
  const double given = -density * 12 * 11 * 10 * 5000.0;
  expect_reference("tetrahedra", "two blocks of ten-node tetrahedra collide: momentum [N s]", momentum, given, 1e-9);
  EXPECT_GT(contact, 0.0);
  EXPECT_LT(deepest, 0.1);
}

/// Area of the faces that one solid alone has, and how many nodes they have.
std::pair<double, std::size_t> surface(const model::Model& m) {
  std::vector<model::Index> all(m.solids.size());
  std::iota(all.begin(), all.end(), 0);
  double area = 0.0;
  std::set<model::Index> nodes;
  for (const model::Segment& s : model::exterior_faces(m, all)) {
    const auto x = [&](std::size_t a) { return m.nodes.x[s[a]]; };
    area += 0.5 * norm(cross(x(2) - x(0), x(3) - x(1)));
    nodes.insert(s.begin(), s.end());
  }
  return {area, nodes.size()};
}

// A box of 30 x 20 x 10 in cubes of 10 has 24 corners of cubes, all on its surface; that is 22 squares, of two
// triangles each, with 66 edges. Sabotage: the faces of three corners only; a tetrahedron N1 N2 N3 N4 N4 N4 N4 N4 as a
// collapsed brick.
TEST(QuadraticTetrahedra, TheirFacesAreTheSurface) {
  Specimen ten = steel("*CONTROL_TERMINATION\n1.0e-6\n");
  const Mesh mesh(ten, 1, {}, {30, 20, 10}, {3, 2, 1});
  ten.text(mesh.text());
  const auto [area, nodes] = surface(Experiment(ten.deck()).model());
  EXPECT_NEAR(area, 2200.0, 1e-9);
  EXPECT_EQ(nodes, 24u + 66u);
  Specimen four;
  four.text("*CONTROL_TERMINATION\n1.0e-6\n").card("MAT_ELASTIC", {1, density, young, poisson});
  four.card("SECTION_SOLID", {1, 10}).part(1, 1, 1);
  const Mesh corners(four, 1, {}, {30, 20, 10}, {3, 2, 1});
  for (const auto& c : corners.corners()) four.brick(1, {c[0], c[1], c[2], c[3], c[3], c[3], c[3], c[3]});
  const auto [area_of_four, nodes_of_four] = surface(Experiment(four.deck()).model());
  EXPECT_NEAR(area_of_four, 2200.0, 1e-9);
  EXPECT_EQ(nodes_of_four, 24u);
}

// A rigid part weighs as a box and turns as one: masses at corners and amid edges give rho V, and moments of inertia
// whose error over the integral goes with the square of the mesh.
TEST(QuadraticTetrahedra, RigidBox) {
  const auto body = [](int n) {
    Specimen s;
    s.text("*CONTROL_TERMINATION\n1.0e-6\n")
        .card("MAT_RIGID", {1, density, young, poisson})
        .text(fields({}) + fields({}));
    s.card("SECTION_SOLID", {1, 16}).part(1, 1, 1);
    const Mesh mesh(s, 1, {}, {30, 20, 10}, {3 * n, 2 * n, n});
    s.text(mesh.text());
    Experiment experiment(s.deck());
    const system::RigidBody& rigid = experiment.system().bodies.front();
    return std::pair(rigid.mass, rigid.inertia);
  };
  const double mass = density * 6000.0, about_z = mass * (30.0 * 30.0 + 20.0 * 20.0) / 12.0;
  const auto [coarse, coarse_inertia] = body(1);
  const auto [fine, fine_inertia] = body(4);
  expect_reference("tetrahedra", "rigid box of 36 ten-node tetrahedra: mass [t]", coarse, mass, 1e-12);
  expect_reference("tetrahedra", "the same of 2304: mass [t]", fine, mass, 1e-12);
  // The same of four-node tetrahedra. Sabotage: their volume as of a collapsed brick, which is half.
  Specimen four;
  four.text("*CONTROL_TERMINATION\n1.0e-6\n").card("MAT_RIGID", {1, density, young, poisson});
  four.text(fields({}) + fields({})).card("SECTION_SOLID", {1, 10}).part(1, 1, 1);
  const Mesh corners(four, 1, {}, {30, 20, 10}, {3, 2, 1});
  for (const auto& c : corners.corners()) four.brick(1, {c[0], c[1], c[2], c[3], c[3], c[3], c[3], c[3]});
  Experiment experiment(four.deck());
  expect_reference("tetrahedra", "rigid box of 36 four-node tetrahedra: mass [t]",
                   experiment.system().bodies.front().mass, mass, 1e-12);
  const auto z = [](const auto& inertia) { return std::max({inertia[0], inertia[3], inertia[5]}); };
  expect_reference("tetrahedra", "the same of 2304: greatest moment of inertia [t mm2]", z(fine_inertia), about_z,
                   5e-3);
  EXPECT_LT(std::abs(z(fine_inertia) / about_z - 1.0), 0.1 * std::abs(z(coarse_inertia) / about_z - 1.0));
}

std::string refusal(Specimen& s) {
  try {
    const Experiment refused(s.deck());
  } catch (const std::runtime_error& e) {
    return e.what();
  }
  return "accepted";
}

TEST(QuadraticTetrahedra, WhatIsNoSuchElementIsRefused) {
  const auto one = [](const std::string& nodes, double elform) {
    Specimen s;
    s.text("*CONTROL_TERMINATION\n1.0\n").card("MAT_ELASTIC", {1, density, young, poisson});
    s.card("SECTION_SOLID", {1, elform}).part(1, 1, 1);
    const Vec3d x[4] = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}};
    for (const Vec3d& corner : x) s.node(corner);
    for (const auto& [i, j] : {std::pair(0, 1), {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}) s.node(0.5 * (x[i] + x[j]));
    s.text("*ELEMENT_SOLID\n       1       1\n" + nodes + "\n");
    return refusal(s);
  };
  const std::string right = "1,2,3,4,5,6,7,8,9,10";
  using testing::HasSubstr;
  EXPECT_EQ(one(right, 16), "accepted");
  EXPECT_EQ(one(right, 17), "accepted");
  EXPECT_THAT(one(right, 10), HasSubstr("solid 1 has 10 nodes, which formulation 10 does not"));
  EXPECT_THAT(one("1,2,3,4,4,4,4,4", 16), HasSubstr("solid 1 has 4 nodes, which formulation 16 does not"));
  EXPECT_THAT(one("1,2,3,4,5,6,7,8,9,0", 16), HasSubstr("expected ten different nodes"));
  EXPECT_THAT(one("1,2,3,4,5,6,7,8,9,9", 16), HasSubstr("expected ten different nodes"));
  EXPECT_THAT(one("2,1,3,4,5,7,6,9,8,10", 16), HasSubstr("solid 1 has the volume"));
}

}  // namespace
}  // namespace nugget::verify
