// SPDX-License-Identifier: Apache-2.0
// The branches of binout0000 that hold sections, groups of nodes and elements: secforc, nodfor, elout.
#include "output/binout.hpp"
#include "output/columns.hpp"

namespace nugget::output {
namespace {

/// `*` of a name by each of xx yy zz xy yz zx, with the values of that component. `put(name, values)` writes one.
template <class Rows, class Member, class Put>
void put_tensors(const std::string& name, const Rows& rows, Member member, Put put) {
  static constexpr const char* components[] = {"xx", "yy", "zz", "xy", "yz", "zx"};
  for (std::size_t c = 0; c < 6; ++c)
    put(name + components[c], extract_column(rows, [&](const auto& row) { return member(row)[c]; }));
}

/// Place in the list of states, `elastic,plastic`, counted from 1.
int state_number(const EloutPoint& point) {
  return point.plastic_strain > 0.0 ? 2 : 1;
}
constexpr const char* states = "elastic,plastic";

/// The parts of several rows one after the other: layers of shells, points of beams.
template <class Rows, class Member>
auto joined(const Rows& rows, Member member) {
  std::vector<typename std::decay_t<decltype(member(rows.front()))>::value_type> all;
  for (const auto& row : rows) all.insert(all.end(), member(row).begin(), member(row).end());
  return all;
}

}  // namespace

void Binout::write(const SecforcState& s) {
  const auto column_of = [this](const std::string& name, const std::vector<double>& values) { reals(name, values); };
  const auto id_where = [&](SectionAxes axes) {
    return extract_column(s.rows, [axes](const SecforcRow& r) { return r.axes == axes ? r.axes_id : 0; });
  };
  if (begin_state("secforc", extract_column(s.rows, [](const SecforcRow& r) { return r.id; }))) {
    integers("rigidbody", id_where(SectionAxes::rigid_body));
    integers("accelerometer", id_where(SectionAxes::accelerometer));
    integers("coordinate_system", id_where(SectionAxes::system));
  }
  begin_data("secforc");
  real("time", s.time);
  put_vectors(
      "*_force", s.rows, [](const SecforcRow& r) { return r.force; }, column_of);
  reals("total_force", extract_column(s.rows, [](const SecforcRow& r) { return norm(r.force); }));
  put_vectors(
      "*_moment", s.rows, [](const SecforcRow& r) { return r.moment; }, column_of);
  reals("total_moment", extract_column(s.rows, [](const SecforcRow& r) { return norm(r.moment); }));
  put_vectors(
      "*_centroid", s.rows, [](const SecforcRow& r) { return r.centroid; }, column_of);
  reals("area", extract_column(s.rows, [](const SecforcRow& r) { return r.area; }));
  end_state();
}

void Binout::write(const NodforState& s) {
  const auto column_of = [this](const std::string& name, const std::vector<double>& values) { reals(name, values); };
  const std::vector<NodforRow> rows = joined(
      s.groups, [](const NodforGroup& g) -> const auto& { return g.rows; });
  const auto totals = extract_column(s.groups, [](const NodforGroup& g) { return total(g); });
  std::vector<Vec3d> local;
  for (std::size_t g = 0; g < s.groups.size(); ++g)
    if (s.groups[g].axes) local.push_back(s.groups[g].axes->local(totals[g].force));
  if (begin_state("nodfor", extract_column(rows, [](const NodforRow& r) { return r.node; }))) {
    integers("groups", extract_column(s.groups, [](const NodforGroup& g) { return static_cast<int>(g.rows.size()); }));
    integers("local",
             extract_column(s.groups, [](const NodforGroup& g) { return static_cast<int>(g.axes.has_value()); }));
  }
  begin_data("nodfor");
  real("time", s.time);
  put_vectors(
      "*_force", rows, [](const NodforRow& r) { return r.force; }, column_of);
  reals("energy", extract_column(rows, [](const NodforRow& r) { return r.energy; }));
  put_vectors(
      "*_total", totals, [](const NodforRow& r) { return r.force; }, column_of);
  reals("etotal", extract_column(totals, [](const NodforRow& r) { return r.energy; }));
  if (!local.empty())
    put_vectors(
        "*_local", local, [](const Vec3d& v) { return v; }, column_of);
  end_state();
}

void Binout::write(const EloutState& s) {
  if (!s.beams.empty()) write_beams(s);
  if (!s.shells.empty()) write_shells(s);
  if (!s.solids.empty()) write_solids(s);
  end_state();
}

void Binout::write_beams(const EloutState& s) {
  begin_state("elout/beam", {});
  begin_data("elout/beam");
  real("time", s.time);
  integer("cycle", s.cycle);
  integers("ids", extract_column(s.beams, [](const EloutBeam& b) { return b.id; }));
  integers("mat", extract_column(s.beams, [](const EloutBeam& b) { return b.part; }));
  integers("mtype", extract_column(s.beams, [](const EloutBeam& b) { return b.material_type; }));
  integers("nip", extract_column(s.beams, [](const EloutBeam& b) { return static_cast<int>(b.points.size()); }));
  reals("axial", extract_column(s.beams, [](const EloutBeam& b) { return b.axial; }));
  reals("shear_s", extract_column(s.beams, [](const EloutBeam& b) { return b.shear_s; }));
  reals("shear_t", extract_column(s.beams, [](const EloutBeam& b) { return b.shear_t; }));
  reals("moment_s", extract_column(s.beams, [](const EloutBeam& b) { return b.moment_s; }));
  reals("moment_t", extract_column(s.beams, [](const EloutBeam& b) { return b.moment_t; }));
  reals("torsion", extract_column(s.beams, [](const EloutBeam& b) { return b.torsion; }));
  // Of muscles only, but readers of files with `mtype` expect them.
  reals("coef_length", std::vector<double>(s.beams.size(), 0.0));
  reals("visc_force", std::vector<double>(s.beams.size(), 0.0));
  using Point = EloutBeam::Point;
  const std::vector<Point> points = joined(
      s.beams, [](const EloutBeam& b) -> const auto& { return b.points; });
  if (points.empty()) return;
  reals("sigma_11", extract_column(points, [](const Point& p) { return p.axial; }));
  reals("sigma_12", extract_column(points, [](const Point& p) { return p.rs; }));
  reals("sigma_31", extract_column(points, [](const Point& p) { return p.tr; }));
  reals("plastic_eps", extract_column(points, [](const Point& p) { return p.plastic_strain; }));
}

void Binout::write_shells(const EloutState& s) {
  const auto column_of = [this](const std::string& name, const std::vector<double>& values) { reals(name, values); };
  if (begin_state("elout/shell", {})) {
    text("states", states);
    text("system", s.local_shells ? "local " : "global");
  }
  begin_data("elout/shell");
  real("time", s.time);
  integer("cycle", s.cycle);
  integers("ids", extract_column(s.shells, [](const EloutShell& e) { return e.id; }));
  integers("mat", extract_column(s.shells, [](const EloutShell& e) { return e.part; }));
  integers("nip", extract_column(s.shells, [](const EloutShell& e) { return static_cast<int>(e.layers.size()); }));
  integers("iop", std::vector<int>(s.shells.size(), 0));
  const std::vector<EloutPoint> layers = joined(
      s.shells, [](const EloutShell& e) -> const auto& { return e.layers; });
  integers("state", extract_column(layers, state_number));
  put_tensors(
      "sig_", layers, [](const EloutPoint& p) { return p.stress; }, column_of);
  reals("plastic_strain", extract_column(layers, [](const EloutPoint& p) { return p.plastic_strain; }));
  if (!s.strains) return;
  put_tensors(
      "lower_eps_", s.shells, [](const EloutShell& e) { return e.lower_strain; }, column_of);
  put_tensors(
      "upper_eps_", s.shells, [](const EloutShell& e) { return e.upper_strain; }, column_of);
}

void Binout::write_solids(const EloutState& s) {
  const auto column_of = [this](const std::string& name, const std::vector<double>& values) { reals(name, values); };
  if (begin_state("elout/solid", {})) text("states", states);
  begin_data("elout/solid");
  real("time", s.time);
  integer("cycle", s.cycle);
  integers("ids", extract_column(s.solids, [](const EloutSolid& e) { return e.id; }));
  integers("mtype", extract_column(s.solids, [](const EloutSolid& e) { return e.part; }));
  integers("state", extract_column(s.solids, [](const EloutSolid& e) { return state_number(e.point); }));
  put_tensors(
      "sig_", s.solids, [](const EloutSolid& e) { return e.point.stress; }, column_of);
  reals("yield", extract_column(s.solids, [](const EloutSolid& e) { return e.point.plastic_strain; }));
  reals("effsg", extract_column(s.solids, [](const EloutSolid& e) { return effective(e.point.stress); }));
  if (s.strains)
    put_tensors(
        "eps_", s.solids, [](const EloutSolid& e) { return e.strain; }, column_of);
}

}  // namespace nugget::output
