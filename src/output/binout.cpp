// SPDX-License-Identifier: Apache-2.0
#include "output/binout.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <stdexcept>

#include "output/columns.hpp"

namespace nugget::output {
namespace {

static_assert(std::endian::native == std::endian::little, "LSDA files are written in the machine's byte order");

// Commands and types of LSDA.
constexpr char cd = 2, data_record = 3, variable_record = 4, begin_table = 5, end_table = 6, table_offset = 7;
constexpr char type_text = 1, type_int = 3, type_real = 10;
constexpr std::size_t record_head = 9;  // length, command

template <class T>
void append(std::string& bytes, T value) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  bytes.append(raw, sizeof(T));
}

void append_record_head(std::string& bytes, std::size_t body, char command) {
  append<std::uint64_t>(bytes, record_head + body);
  bytes += command;
}

template <class T>
std::string_view bytes_of(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

/// LS-DYNA counts element types from 1, in the order of glstat/metadata/element_types.
int type_number(ElementKind kind) {
  return static_cast<int>(kind) + 1;
}

}  // namespace

Binout::Binout(const std::filesystem::path& directory, Header header)
    : file_(directory / "binout0000", header.mode), header_(std::move(header)) {
  if (header_.mode == OpenMode::append) return;
  std::string& out = file_.buffer();
  out.append({8, 8, 8, 1, 1, 1, 0, 0});  // head; bytes of length, offset, command, type; little endian; IEEE; spare
  append_record_head(out, 8, table_offset);
  link_ = out.size();
  append<std::uint64_t>(out, 0);
  file_.commit();
}

void Binout::set_legend(const std::string& branch, std::vector<LegendEntry> legend) {
  legends_[branch] = std::move(legend);
}

void Binout::write(const GlstatState& s) {
  if (begin_state("glstat", {})) text("element_types", "solid,beam,shell,thick shell,discrete");
  begin_data("glstat");
  const auto optional_real = [this](const char* name, const std::optional<double>& value) {
    if (value) real(name, *value);
  };
  integer("cycle", s.cycle);
  if (s.controlling) {
    integer("ts_eltype", type_number(s.controlling->kind));
    integer("ts_element", s.controlling->element);
    integer("ts_part", s.controlling->part);
  }
  real("time", s.time);
  real("time_step", s.time_step);
  real("kinetic_energy", s.kinetic);
  real("internal_energy", s.internal);
  if (!s.walls.empty()) reals("stonewall_energy", s.walls);
  optional_real("spring_and_damper_energy", s.spring_and_damper);
  optional_real("joint_internal_energy", s.joint);
  optional_real("hourglass_energy", s.hourglass);
  real("system_damping_energy", s.system_damping);
  real("sliding_interface_energy", s.sliding_interface);
  real("external_work", s.external_work);
  optional_real("eroded_kinetic_energy", s.eroded_kinetic);
  optional_real("eroded_internal_energy", s.eroded_internal);
  optional_real("eroded_hourglass_energy", s.eroded_hourglass);
  real("total_energy", s.total);
  real("energy_ratio", s.ratio);
  optional_real("energy_ratio_wo_eroded", s.ratio_without_eroded);
  real("global_x_velocity", s.velocity.x);
  real("global_y_velocity", s.velocity.y);
  real("global_z_velocity", s.velocity.z);
  if (s.nodes) integer("number_of_nodes", *s.nodes);
  if (s.elements) integer("number_of_elements", *s.elements);
  integer("nzc", s.nanoseconds_per_element_cycle);
  optional_real("added_mass", s.added_mass);
  optional_real("percent_increase", s.percent_increase);
  end_state();
}

void Binout::write(const MatsumState& s) {
  const auto column_of = [this](const std::string& name, const std::vector<double>& values) { reals(name, values); };
  begin_state("matsum", extract_column(s.rows, [](const MatsumRow& r) { return r.part; }));
  begin_data("matsum");
  real("time", s.time);
  reals("internal_energy", extract_column(s.rows, [](const MatsumRow& r) { return r.internal; }));
  reals("kinetic_energy", extract_column(s.rows, [](const MatsumRow& r) { return r.kinetic; }));
  reals("eroded_internal_energy", extract_column(s.rows, [](const MatsumRow& r) { return r.eroded_internal; }));
  reals("eroded_kinetic_energy", extract_column(s.rows, [](const MatsumRow& r) { return r.eroded_kinetic; }));
  reals("mass", extract_column(s.rows, [](const MatsumRow& r) { return r.added_mass; }));
  reals("hourglass_energy", extract_column(s.rows, [](const MatsumRow& r) { return r.hourglass; }));
  put_vectors(
      "*_momentum", s.rows, [](const MatsumRow& r) { return r.momentum; }, column_of);
  put_vectors(
      "*_rbvelocity", s.rows, [](const MatsumRow& r) { return r.velocity; }, column_of);
  if (s.lumped_kinetic) real("lumped_kinetic_energy", *s.lumped_kinetic);
  end_state();
}

void Binout::write(const NodoutState& s) {
  const auto column_of = [this](const std::string& name, const std::vector<double>& values) { reals(name, values); };
  begin_state("nodout", extract_column(s.rows, [](const NodoutRow& r) { return r.node; }));
  begin_data("nodout");
  real("time", s.time);
  integer("cycle", s.cycle);
  put_vectors(
      "*_displacement", s.rows, [](const NodoutRow& r) { return r.displacement; }, column_of);
  put_vectors(
      "*_velocity", s.rows, [](const NodoutRow& r) { return r.velocity; }, column_of);
  put_vectors(
      "*_acceleration", s.rows, [](const NodoutRow& r) { return r.acceleration; }, column_of);
  put_vectors(
      "*_coordinate", s.rows, [](const NodoutRow& r) { return r.coordinate; }, column_of);
  if (s.rotations) {
    put_vectors(
        "r*_displacement", s.rows, [](const NodoutRow& r) { return r.rotation; }, column_of);
    put_vectors(
        "r*_velocity", s.rows, [](const NodoutRow& r) { return r.rotational_velocity; }, column_of);
    put_vectors(
        "r*_acceleration", s.rows, [](const NodoutRow& r) { return r.rotational_acceleration; }, column_of);
  }
  end_state();
}

void Binout::write(const SwforcState& s) {
  if (begin_state("swforc", extract_column(s.rows, [](const SwforcRow& r) { return r.id; }))) {
    text("typenames", "constraint,weld,beam,solid,non nodal, ,solid assembly");
    integers("types", extract_column(s.rows, [](const SwforcRow& r) { return static_cast<int>(r.kind); }));
  }
  begin_data("swforc");
  real("time", s.time);
  reals("axial", extract_column(s.rows, [](const SwforcRow& r) { return r.axial; }));
  reals("shear", extract_column(s.rows, [](const SwforcRow& r) { return r.shear; }));
  reals("failure", extract_column(s.rows, [](const SwforcRow& r) { return r.failure; }));
  reals("failure_time", extract_column(s.rows, [](const SwforcRow& r) { return r.failure_time; }));
  reals("length", extract_column(s.rows, [](const SwforcRow& r) { return r.length; }));
  reals("resultant_moment", extract_column(s.rows, [](const SwforcRow& r) { return r.resultant_moment; }));
  reals("torsion", extract_column(s.rows, [](const SwforcRow& r) { return r.torsion; }));
  if (std::any_of(s.rows.begin(), s.rows.end(), [](const SwforcRow& r) { return r.peak.has_value(); })) {
    const auto peak = [](const SwforcRow& r) { return r.peak.value_or(std::pair{0.0, 0.0}); };
    reals("max_failure", extract_column(s.rows, [&](const SwforcRow& r) { return peak(r).first; }));
    reals("max_failure_time", extract_column(s.rows, [&](const SwforcRow& r) { return peak(r).second; }));
  }
  end_state();
}

void Binout::write(const DcfailState& s) {
  using Row = DcfailRow;
  if (begin_state("dcfail", extract_column(s.rows, [](const Row& r) { return r.id; })))
    integers("type", extract_column(s.rows, [](const Row& r) { return r.connection; }));
  begin_data("dcfail");
  real("time", s.time);
  reals("area", extract_column(s.rows, [](const Row& r) { return r.area; }));
  reals("bending_term", extract_column(s.rows, [](const Row& r) { return r.bending; }));
  reals("effective_strain_rate", extract_column(s.rows, [](const Row& r) { return r.strain_rate; }));
  reals("failure_function", extract_column(s.rows, [](const Row& r) { return r.failure; }));
  reals("normal_term", extract_column(s.rows, [](const Row& r) { return r.normal; }));
  reals("shear_term", extract_column(s.rows, [](const Row& r) { return r.shear; }));
  reals("area_sol", extract_column(s.rows, [](const Row& r) { return r.solid_area; }));
  reals("axial_force", extract_column(s.rows, [](const Row& r) { return r.axial_force; }));
  reals("shear_force", extract_column(s.rows, [](const Row& r) { return r.shear_force; }));
  reals("torsional_moment", extract_column(s.rows, [](const Row& r) { return r.torsional_moment; }));
  reals("bending_moment", extract_column(s.rows, [](const Row& r) { return r.bending_moment; }));
  end_state();
}

void Binout::write(const RwforcState& s) {
  const auto column_of = [this](const std::string& name, const std::vector<double>& values) { reals(name, values); };
  const std::vector<int> walls = extract_column(s.rows, [](const RwforcRow& r) { return r.wall; });
  if (begin_state("rwforc/forces", walls)) integers("setid", walls);
  begin_data("rwforc/forces");
  real("time", s.time);
  reals("normal_force", extract_column(s.rows, [](const RwforcRow& r) { return r.normal; }));
  put_vectors(
      "*_force", s.rows, [](const RwforcRow& r) { return r.force; }, column_of);
  end_state();
}

void Binout::write(const AbstatState& s) {
  const auto put = [&](const char* name, double AbstatRow::*member) {
    reals(name, extract_column(s.rows, [member](const AbstatRow& r) { return r.*member; }));
  };
  begin_state("abstat", extract_column(s.rows, [](const AbstatRow& r) { return r.id; }));
  begin_data("abstat");
  real("time", s.time);
  put("volume", &AbstatRow::volume);
  put("pressure", &AbstatRow::pressure);
  put("internal_energy", &AbstatRow::internal_energy);
  put("density", &AbstatRow::density);
  put("total_mass", &AbstatRow::total_mass);
  put("surface_area", &AbstatRow::surface_area);
  put("dm_dt_in", &AbstatRow::inflow);
  put("dm_dt_out", &AbstatRow::outflow);
  put("gas_temp", &AbstatRow::temperature);
  reals("reaction", std::vector<double>(s.rows.size(), 0.0));
  end_state();
}

void Binout::write(const DeforcState& s) {
  const auto column_of = [this](const std::string& name, const std::vector<double>& values) { reals(name, values); };
  if (begin_state("deforc", extract_column(s.rows, [](const DeforcRow& r) { return r.spring; })))
    integers("irot", extract_column(s.rows, [](const DeforcRow& r) { return r.torsional ? 1 : 0; }));
  begin_data("deforc");
  real("time", s.time);
  put_vectors(
      "*_force", s.rows, [](const DeforcRow& r) { return r.force; }, column_of);
  reals("resultant_force", extract_column(s.rows, [](const DeforcRow& r) { return r.resultant; }));
  reals("displacement", extract_column(s.rows, [](const DeforcRow& r) { return r.displacement; }));
  end_state();
}

// The sixteen numbers of a joint stiffness: the names are LS-DYNA's, which has rotations of
// _GENERALIZED under those of _FLEXION-TORSION (LSTC's l2a.c tells what they mean).
constexpr std::array<const char*, 16> of_displacements{"phi_degrees",          "d(phi)_dt",
                                                       "theta_degrees",        "d(theta)_dt",
                                                       "psi_degrees",          "d(psi)_dt",
                                                       "phi_moment_stiffness", "phi_moment_damping",
                                                       "phi_moment_total",     "theta_moment_stiffness",
                                                       "theta_moment_damping", "theta_moment_total",
                                                       "psi_moment_stiffness", "psi_moment_damping",
                                                       "psi_moment_total",     "joint_energy"};
constexpr std::array<const char*, 16> of_rotations{
    "alpha_degrees",      "d(alpha)_dt",        "gamma_degrees",          "d(gamma)_dt",
    "beta_degrees",       "d(beta)_dt",         "alpha_moment_stiffness", "alpha_moment_damping",
    "alpha_moment_total", "gamma_scale_factor", "beta_moment_stiffness",  "beta_moment_damping",
    "beta_moment_total",  "joint_energy",       "joint_extra1",           "joint_extra2"};

void Binout::write_joint_stiffness(const char* branch, double time, const std::vector<JntforcStiffness>& rows,
                                   const std::array<const char*, 16>& names) {
  if (rows.empty()) return;
  begin_state(branch, extract_column(rows, [](const JntforcStiffness& r) { return r.id; }));
  begin_data(branch);
  real("time", time);
  const char* const* name = names.data();
  for (std::size_t i = 0; i < 3; ++i) {
    reals(*name++, extract_column(rows, [i](const JntforcStiffness& r) { return r.axis[i].place; }));
    reals(*name++, extract_column(rows, [i](const JntforcStiffness& r) { return r.axis[i].rate; }));
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const auto value = [i](const JntforcStiffness& r) { return r.axis[i]; };
    reals(*name++, extract_column(rows, [&](const JntforcStiffness& r) { return value(r).stiffness; }));
    reals(*name++, extract_column(rows, [&](const JntforcStiffness& r) { return value(r).damping; }));
    reals(*name++,
          extract_column(rows, [&](const JntforcStiffness& r) { return value(r).stiffness + value(r).damping; }));
  }
  reals(*name, extract_column(rows, [](const JntforcStiffness& r) { return r.energy; }));
  end_state();
}

void Binout::write(const JntforcState& s) {
  write_joint_stiffness("jntforc/type0", s.time, s.displacements, of_displacements);
  write_joint_stiffness("jntforc/type1", s.time, s.rotations, of_rotations);
  if (s.rows.empty()) return;
  const auto column_of = [this](const std::string& name, const std::vector<double>& values) { reals(name, values); };
  if (begin_state("jntforc/joints", extract_column(s.rows, [](const JntforcRow& r) { return r.joint; })))
    integers("local", extract_column(s.rows, [](const JntforcRow& r) { return r.local ? 1 : 0; }));
  begin_data("jntforc/joints");
  real("time", s.time);
  put_vectors(
      "*_force", s.rows, [](const JntforcRow& r) { return r.force; }, column_of);
  put_vectors(
      "*_moment", s.rows, [](const JntforcRow& r) { return r.moment; }, column_of);
  reals("resultant_force", extract_column(s.rows, [](const JntforcRow& r) { return norm(r.force); }));
  reals("resultant_moment", extract_column(s.rows, [](const JntforcRow& r) { return norm(r.moment); }));
  reals("energy", extract_column(s.rows, [](const JntforcRow& r) { return r.energy; }));
  end_state();
}

void Binout::write(const SpcforcState& s) {
  const auto column_of = [this](const std::string& name, const std::vector<double>& values) { reals(name, values); };
  const auto node = [](const SpcforcRow& r) { return r.node; };
  const auto set = [](const SpcforcRow& r) { return r.set; };
  const auto value = [](const SpcforcRow& r) { return r.value; };
  std::vector<int> held = extract_column(s.forces, node);
  for (const SpcforcRow& row : s.moments) held.push_back(row.node);
  if (begin_state("spcforc", held)) {
    if (!s.forces.empty()) integers("force_ids", extract_column(s.forces, node));
    if (!s.forces.empty()) integers("spc_ids", extract_column(s.forces, set));
    if (!s.moments.empty()) integers("moment_ids", extract_column(s.moments, node));
    if (!s.moments.empty()) integers("spc_mids", extract_column(s.moments, set));
  }
  begin_data("spcforc");
  real("time", s.time);
  if (!s.forces.empty()) put_vectors("*_force", s.forces, value, column_of);
  if (!s.moments.empty()) put_vectors("*_moment", s.moments, value, column_of);
  real("x_resultant", s.resultant.x);
  real("y_resultant", s.resultant.y);
  real("z_resultant", s.resultant.z);
  end_state();
}

void Binout::write(const BndoutState& s) {
  const auto column_of = [this](const std::string& name, const std::vector<double>& values) { reals(name, values); };
  const auto table = [&](const std::string& path, const auto& rows) {
    begin_data(path);
    real("time", s.time);
    put_vectors(
        "*_force", rows, [](const auto& r) { return r.force; }, column_of);
    reals("energy", extract_column(rows, [](const auto& r) { return r.energy; }));
    const BndoutTotal sum = total(rows);
    real("x_total", sum.force.x);
    real("y_total", sum.force.y);
    real("z_total", sum.force.z);
    real("etotal", sum.energy);
  };
  if (!s.nodes.empty()) {
    if (begin_state("bndout/velocity/nodes", extract_column(s.nodes, [](const BndoutNode& r) { return r.node; })))
      integers("setid", extract_column(s.nodes, [](const BndoutNode& r) { return r.set; }));
    table("bndout/velocity/nodes", s.nodes);
  }
  if (!s.bodies.empty()) {
    begin_state("bndout/velocity/rigidbodies", extract_column(s.bodies, [](const BndoutBody& r) { return r.part; }));
    table("bndout/velocity/rigidbodies", s.bodies);
    put_vectors(
        "*moment", s.bodies, [](const BndoutBody& r) { return r.moment; }, column_of);
  }
  end_state();
}

void Binout::write(const RbdoutState& s) {
  std::vector<RbdoutRow> rows = s.parts;
  rows.insert(rows.end(), s.nodal.begin(), s.nodal.end());
  const auto column_of = [this](const std::string& name, const std::vector<double>& values) { reals(name, values); };
  if (begin_state("rbdout", extract_column(rows, [](const RbdoutRow& r) { return r.id; })))
    integer("num_nodal", static_cast<long>(s.nodal.size()));
  begin_data("rbdout");
  real("time", s.time);
  integer("cycle", s.cycle);
  put_vectors(
      "global_*", rows, [](const RbdoutRow& r) { return r.coordinate; }, column_of);
  for (const bool local : {false, true}) {
    const std::string frame = local ? "local_" : "global_";
    const auto motion = [&](const char* name, auto member) {
      put_vectors(
          frame + name, rows, [&](const RbdoutRow& r) { return local ? r.axes.local(r.*member) : r.*member; },
          column_of);
    };
    motion("d*", &RbdoutRow::displacement);
    motion("rd*", &RbdoutRow::rotation);
    motion("v*", &RbdoutRow::velocity);
    motion("rv*", &RbdoutRow::angular_velocity);
    motion("a*", &RbdoutRow::acceleration);
    motion("ra*", &RbdoutRow::angular_acceleration);
  }
  const auto direction = [&](const std::string& column_number, auto member) {
    reals("dircos_1" + column_number, extract_column(rows, [&](const RbdoutRow& r) { return (r.axes.*member).x; }));
    reals("dircos_2" + column_number, extract_column(rows, [&](const RbdoutRow& r) { return (r.axes.*member).y; }));
    reals("dircos_3" + column_number, extract_column(rows, [&](const RbdoutRow& r) { return (r.axes.*member).z; }));
  };
  direction("1", &Frame3d::e1);
  direction("2", &Frame3d::e2);
  direction("3", &Frame3d::e3);
  end_state();
}

void Binout::write(const RcforcState& s) {
  const auto column_of = [this](const std::string& name, const std::vector<double>& values) { reals(name, values); };
  if (begin_state("rcforc", extract_column(s.rows, [](const RcforcRow& r) { return r.contact; })))
    integers("side", extract_column(s.rows, [](const RcforcRow& r) { return static_cast<int>(r.side); }));
  begin_data("rcforc");
  real("time", s.time);
  put_vectors(
      "*_force", s.rows, [](const RcforcRow& r) { return r.force; }, column_of);
  reals("mass", extract_column(s.rows, [](const RcforcRow& r) { return r.mass; }));
  end_state();
}

void Binout::write(const SleoutState& s) {
  if (begin_state("sleout", extract_column(s.rows, [](const SleoutRow& r) { return r.contact; })))
    integers("single_sided", extract_column(s.rows, [](const SleoutRow& r) { return r.single_surface ? 1 : 0; }));
  begin_data("sleout");
  real("time", s.time);
  integer("cycle", s.cycle);
  reals("slave", extract_column(s.rows, [](const SleoutRow& r) { return r.tracked; }));
  reals("master", extract_column(s.rows, [](const SleoutRow& r) { return r.reference; }));
  reals("friction_energy", extract_column(s.rows, [](const SleoutRow& r) { return r.friction; }));
  real("total_slave", s.total_tracked());
  real("total_master", s.total_reference());
  real("total_energy", s.total_tracked() + s.total_reference());
  real("total_friction", s.total_friction());
  end_state();
}

bool Binout::begin_state(const std::string& path, std::vector<int> ids) {
  Branch& branch = branches_[path];
  if (++branch.states > 1) {
    if (ids != branch.ids) throw std::logic_error("binout: the entities of " + path + " changed between two states");
    return false;
  }
  branch.ids = std::move(ids);
  metadata(path, path.substr(0, path.find('/')), branch.ids);
  return true;
}

void Binout::metadata(const std::string& path, const std::string& branch, const std::vector<int>& ids) {
  directory("/" + path + "/metadata");
  text("title", fixed_width(header_.title, 80));
  text("version", fixed_width(header_.version, 12));
  text("revision", fixed_width("0", 10));
  text("date", fixed_width(header_.date, 10));
  if (!ids.empty() && branch != "spcforc") integers("ids", ids);

  // A branch of several kinds (elout/shell, elout/solid) has a legend for each.
  auto legend = legends_.find(path);
  if (legend == legends_.end()) legend = legends_.find(branch);
  if (legend == legends_.end() || legend->second.empty()) return;
  std::string headings;
  for (const LegendEntry& entry : legend->second) headings += fixed_width(entry.heading, 70);
  text("legend", headings);
  integers("legend_ids", extract_column(legend->second, [](const LegendEntry& entry) { return entry.id; }));
}

void Binout::begin_data(const std::string& path) {
  const int state = branches_.at(path).states;
  directory(state <= 999999 ? fmt::format("/{}/d{:06}", path, state) : fmt::format("/{}/d{:08}", path, state));
}

void Binout::end_state() {
  if (variables_.empty()) return;
  const std::uint64_t position = file_.size() + file_.buffer().size();
  file_.buffer() += symbol_table();
  file_.commit();
  std::string link;
  append<std::uint64_t>(link, position);
  file_.write_at(link_, link);  // only now does a reader see the state
  link_ = file_.size() - sizeof(std::uint64_t);
  variables_.clear();
}

void Binout::archive(Archive& a) {
  a(file_, branches_, directory_, link_);
  a.built(header_, legends_, variables_);
  if (a.reading()) file_.write_at(link_, std::string(sizeof(std::uint64_t), '\0'));
}

void Binout::directory(const std::string& path) {
  append_record_head(file_.buffer(), path.size(), cd);
  file_.buffer() += path;
  directory_ = path;
}

void Binout::text(const std::string& name, const std::string& value) {
  data(name, type_text, value.size(), value);
}

void Binout::integers(const std::string& name, const std::vector<int>& values) {
  data(name, type_int, values.size(), bytes_of(values));
}

void Binout::reals(const std::string& name, const std::vector<double>& values) {
  data(name, type_real, values.size(), bytes_of(values));
}

void Binout::integer(const std::string& name, long value) {
  integers(name, {static_cast<int>(value)});
}
void Binout::real(const std::string& name, double value) {
  reals(name, {value});
}

void Binout::data(const std::string& name, char type, std::uint64_t count, std::string_view bytes) {
  std::string& out = file_.buffer();
  variables_[directory_][name] = {type, file_.size() + out.size(), count};
  append_record_head(out, 2 + name.size() + bytes.size(), data_record);
  out += type;
  out += static_cast<char>(name.size());
  out += name;
  out += bytes;
}

/// The table of all data since the last one, in alphabetical order as LSTC's library writes it; its last word is the
/// link to the next table.
std::string Binout::symbol_table() const {
  std::string body;
  for (const auto& [path, names] : variables_) {
    append_record_head(body, path.size(), cd);
    body += path;
    for (const auto& [name, variable] : names) {
      append_record_head(body, name.size() + 1 + 8 + 8, variable_record);
      body += name;
      body += variable.type;
      append(body, variable.offset);
      append(body, variable.count);
    }
  }
  append_record_head(body, 8, end_table);
  append<std::uint64_t>(body, 0);
  std::string table;
  append_record_head(table, body.size(), begin_table);
  return table + body;
}

}  // namespace nugget::output
