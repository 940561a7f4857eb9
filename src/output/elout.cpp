// SPDX-License-Identifier: Apache-2.0
#include "output/elout.hpp"

#include <cmath>

namespace nugget::output {
namespace {

const char* state_of(const EloutPoint& point) {
  return point.plastic_strain > 0.0 ? "plastic" : "elastic";
}

void tensor(AsciiFile& file, const Tensor& t) {
  for (const double component : t) file.print("{:12.4E}", column(component));
}

void element(AsciiFile& file, int id, int part) {
  file.print("{:8}-{:7}\n", id, part);
}

void head(AsciiFile& file, const char* what, const EloutState& state) {
  file.print(
      "\n\n\n e l e m e n t   {}   c a l c u l a t i o n s   f o r   t i m e  s t e p{:9}   ( at time {:12.5E} )\n\n",
      what, state.cycle, column(state.time));
}

bool has_strains(const EloutState& s) {
  return s.strains;
}

/// Place in the list of states, counted from 1.
int state_number(const EloutPoint& point) {
  return point.plastic_strain > 0.0 ? 2 : 1;
}
const char* states(const EloutState&) {
  return "elastic,plastic";
}

/// Of all elements, one after the other.
std::vector<EloutPoint> layers_of_shells(const EloutState& s) {
  std::vector<EloutPoint> all;
  for (const EloutShell& e : s.shells) all.insert(all.end(), e.layers.begin(), e.layers.end());
  return all;
}
std::vector<EloutPoint> layers_of_thick_shells(const EloutState& s) {
  std::vector<EloutPoint> all;
  for (const EloutShell& e : s.thick_shells) all.insert(all.end(), e.layers.begin(), e.layers.end());
  return all;
}
std::vector<EloutBeam::Point> points_of_beams(const EloutState& s) {
  std::vector<EloutBeam::Point> all;
  for (const EloutBeam& b : s.beams) all.insert(all.end(), b.points.begin(), b.points.end());
  return all;
}

void head_of_solids(AsciiFile& file, const EloutState& state) {
  head(file, "s t r e s s", state);
  file.print(
      " element  materl\n"
      "     ipt  stress       sig-xx      sig-yy      sig-zz      sig-xy      sig-yz      sig-zx                       "
      "yield\n"
      "           state                                                                                  effsg      "
      "function\n");
}

void rows_of_solids(AsciiFile& file, const EloutState& state) {
  for (const EloutSolid& solid : state.solids) {
    element(file, solid.id, solid.part);
    file.print("       1 {:<7} ", state_of(solid.point));
    tensor(file, solid.point.stress);
    file.print("{:14.4E}{:14.4E}\n", column(effective(solid.point.stress)), column(solid.point.plastic_strain));
  }
}

void head_of_solid_strains(AsciiFile& file, const EloutState& state) {
  head(file, "s t r a i n", state);
  file.print(
      " element  strain       eps-xx      eps-yy      eps-zz      eps-xy      eps-yz      eps-zx                       "
      " "
      "    yield\n num/ipt   state\n");
}

void rows_of_solid_strains(AsciiFile& file, const EloutState& state) {
  for (const EloutSolid& solid : state.solids) {
    element(file, solid.id, solid.part);
    file.print("      1  {:<7} ", state_of(solid.point));
    tensor(file, solid.strain);
    file.print("\n");
  }
}

void head_of_beams(AsciiFile& file, const EloutState& state) {
  file.print(" r e s u l t a n t s   a n d   s t r e s s e s   f o r   t i m e  s t e p{:9}   ( at time{:12.5E} )\n",
             state.cycle, column(state.time));
}

void rows_of_beams(AsciiFile& file, const EloutState& state) {
  for (const EloutBeam& beam : state.beams) {
    file.print("\n\n beam/truss # ={:8}      part ID  ={:10}      material type={:8}\n", beam.id, beam.part,
               beam.material_type);
    file.print("\n resultants      axial    shear-s    shear-t    moment-s   moment-t   torsion\n{:11}", "");
    for (const double r : {beam.axial, beam.shear_s, beam.shear_t, beam.moment_s, beam.moment_t, beam.torsion})
      file.print("{:11.3E}", column(r));
    file.print("\n");
    if (beam.points.empty()) continue;
    file.print("\n\n integration point stresses\n{:23}sigma 11       sigma 12       sigma 31   plastic  eps\n", "");
    int number = 0;
    for (const EloutBeam::Point& p : beam.points)
      file.print("{:5}           {:15.6E}{:15.6E}{:15.6E}{:15.6E}\n", ++number, column(p.axial), column(p.rs),
                 column(p.tr), column(p.plastic_strain));
  }
}

const char* axes_of_shells(bool local) {
  return local ? "(local)" : "(global)";
}

void head_of_shells(AsciiFile& file, const EloutState& state, bool local) {
  head(file, "s t r e s s", state);
  file.print(
      " element  materl{:<8}\n"
      " ipt-shl  stress       sig-xx      sig-yy      sig-zz      sig-xy      sig-yz      sig-zx       plastic\n"
      "           state                                                                                 strain \n",
      axes_of_shells(local));
}

void rows_of_shells(AsciiFile& file, const std::vector<EloutShell>& shells) {
  for (const EloutShell& shell : shells) {
    element(file, shell.id, shell.part);
    int number = 0;
    for (const EloutPoint& layer : shell.layers) {
      file.print("{:4}-{:3} {:<7} ", ++number, 0, state_of(layer));
      tensor(file, layer.stress);
      file.print("{:14.4E}\n", column(layer.plastic_strain));
    }
  }
}

void head_of_shell_strains(AsciiFile& file, bool local) {
  file.print("\n strains {:<8}      eps-xx      eps-yy      eps-zz      eps-xy      eps-yz      eps-zx{:36}\n{:117}\n",
             axes_of_shells(local), "", "");
}

void rows_of_shell_strains(AsciiFile& file, const std::vector<EloutShell>& shells) {
  for (const EloutShell& shell : shells) {
    element(file, shell.id, shell.part);
    file.print(" lower ipt       ");
    tensor(file, shell.lower_strain);
    file.print("\n upper ipt       ");
    tensor(file, shell.upper_strain);
    file.print("\n");
  }
}

bool has_rows(EloutTable table, const EloutState& s) {
  if (shows_strains(table) && !s.strains) return false;
  switch (table) {
    case EloutTable::solids:
    case EloutTable::strains_of_solids: return !s.solids.empty();
    case EloutTable::beams: return !s.beams.empty();
    case EloutTable::shells:
    case EloutTable::strains_of_shells: return !s.shells.empty();
    case EloutTable::thick_shells:
    case EloutTable::strains_of_thick: return !s.thick_shells.empty();
  }
  return false;
}

void print(AsciiFile& file, const EloutState& state) {
  for (const EloutTable table : elout_tables) {
    if (!has_rows(table, state)) continue;
    print_head(file, table, state);
    print_rows(file, table, state);
  }
}

}  // namespace

void print_head(AsciiFile& file, EloutTable table, const EloutState& state) {
  switch (table) {
    case EloutTable::solids: return head_of_solids(file, state);
    case EloutTable::strains_of_solids: return head_of_solid_strains(file, state);
    case EloutTable::beams: return head_of_beams(file, state);
    case EloutTable::shells: return head_of_shells(file, state, state.local_shells);
    case EloutTable::strains_of_shells: return head_of_shell_strains(file, state.local_shells);
    case EloutTable::thick_shells: return head_of_shells(file, state, false);
    case EloutTable::strains_of_thick: return head_of_shell_strains(file, false);
  }
}

void print_rows(AsciiFile& file, EloutTable table, const EloutState& rows) {
  switch (table) {
    case EloutTable::solids: return rows_of_solids(file, rows);
    case EloutTable::strains_of_solids: return rows_of_solid_strains(file, rows);
    case EloutTable::beams: return rows_of_beams(file, rows);
    case EloutTable::shells: return rows_of_shells(file, rows.shells);
    case EloutTable::strains_of_shells: return rows_of_shell_strains(file, rows.shells);
    case EloutTable::thick_shells: return rows_of_shells(file, rows.thick_shells);
    case EloutTable::strains_of_thick: return rows_of_shell_strains(file, rows.thick_shells);
  }
}

double effective(const Tensor& s) {
  const double a = s[0] - s[1], b = s[1] - s[2], c = s[2] - s[0];
  return std::sqrt(0.5 * (a * a + b * b + c * c) + 3.0 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]));
}

/// Shells or thick shells.
Branch<EloutState> branch_of_shells(const char* path, std::vector<EloutShell> EloutState::*list,
                                    std::vector<EloutPoint> (*layers)(const EloutState&),
                                    const char* (*axes)(const EloutState&), bool (*written)(const EloutState&)) {
  return {
      .path = path,
      .once = columns<EloutState>({
          {"states", states, dimension::number, "names of `state`, from 1"},
          {"system", axes, dimension::number, "axes of the stresses"},
      }),
      .columns =
          columns(list,
                  {
                      {"time", &EloutState::time, dimension::time, "time"},
                      {"cycle", &EloutState::cycle, dimension::number, "number of the cycle, from 1"},
                      {"ids", &EloutShell::id, dimension::number, "id of the element"},
                      {"mat", &EloutShell::part, dimension::number, "id of its part"},
                      {"nip", [](const EloutShell& e) { return static_cast<int>(e.layers.size()); }, dimension::number,
                       "layers that are written"},
                      {"iop", [](const EloutShell&) { return 0; }, dimension::number, "of the format; always 0"},
                  }) +
          columns(layers,
                  {
                      {"state", state_number, dimension::number, "1 elastic, 2 plastic"},
                      {"sig_*", &EloutPoint::stress, dimension::stress, "stress of a layer"},
                      {"plastic_strain", &EloutPoint::plastic_strain, dimension::number, "plastic strain of a layer"},
                  }) +
          columns(list,
                  {
                      {"lower_eps_*", &EloutShell::lower_strain, dimension::number,
                       "logarithmic strain of the lowest layer"},
                      {"upper_eps_*", &EloutShell::upper_strain, dimension::number,
                       "logarithmic strain of the uppermost layer"},
                  })
              .where(has_strains),
      .written = written};
}

const HistoryFormat<EloutState>& elout() {
  static const HistoryFormat<EloutState> format{
      .branches =
          {
              {.path = "elout/beam",
               .columns =
                   columns(
                       &EloutState::beams,
                       {
                           {"time", &EloutState::time, dimension::time, "time"},
                           {"cycle", &EloutState::cycle, dimension::number, "number of the cycle, from 1"},
                           {"ids", &EloutBeam::id, dimension::number, "id of a beam"},
                           {"mat", &EloutBeam::part, dimension::number, "id of its part"},
                           {"mtype", &EloutBeam::material_type, dimension::number, "LS-DYNA's number of its law, or 0"},
                           {"nip", [](const EloutBeam& b) { return static_cast<int>(b.points.size()); },
                            dimension::number, "points that are written"},
                           {"axial", &EloutBeam::axial, dimension::force, "axial force"},
                           {"shear_s", &EloutBeam::shear_s, dimension::force, "shear force along s"},
                           {"shear_t", &EloutBeam::shear_t, dimension::force, "shear force along t"},
                           {"moment_s", &EloutBeam::moment_s, dimension::moment, "bending moment about s"},
                           {"moment_t", &EloutBeam::moment_t, dimension::moment, "bending moment about t"},
                           {"torsion", &EloutBeam::torsion, dimension::moment, "torsional moment"},
                           // Readers of files with `mtype` expect these two.
                           {"coef_length", [](const EloutBeam&) { return 0.0; }, dimension::number,
                            "of muscles only; always 0"},
                           {"visc_force", [](const EloutBeam&) { return 0.0; }, dimension::force,
                            "of muscles only; always 0"},
                       }) +
                   columns(points_of_beams,
                           {
                               {"sigma_11", &EloutBeam::Point::axial, dimension::stress, "axial stress of a point"},
                               {"sigma_12", &EloutBeam::Point::rs, dimension::stress, "shear stress rs of a point"},
                               {"sigma_31", &EloutBeam::Point::tr, dimension::stress, "shear stress tr of a point"},
                               {"plastic_eps", &EloutBeam::Point::plastic_strain, dimension::number,
                                "plastic strain of a point"},
                           })
                       .where([](const EloutState& s) { return !points_of_beams(s).empty(); }),
               .written = [](const EloutState& s) { return !s.beams.empty(); }},
              branch_of_shells(
                  "elout/shell", &EloutState::shells, layers_of_shells,
                  [](const EloutState& s) { return s.local_shells ? "local " : "global"; },
                  [](const EloutState& s) { return !s.shells.empty(); }),
              branch_of_shells(
                  "elout/thickshell", &EloutState::thick_shells, layers_of_thick_shells,
                  [](const EloutState&) { return "global"; },
                  [](const EloutState& s) { return !s.thick_shells.empty(); }),
              {.path = "elout/solid",
               .once = columns<EloutState>({{"states", states, dimension::number, "names of `state`, from 1"}}),
               .columns = columns(&EloutState::solids,
                                  {
                                      {"time", &EloutState::time, dimension::time, "time"},
                                      {"cycle", &EloutState::cycle, dimension::number, "number of the cycle, from 1"},
                                      {"ids", &EloutSolid::id, dimension::number, "id of a solid"},
                                      {"mtype", &EloutSolid::part, dimension::number, "id of its part"},
                                      {"state", [](const EloutSolid& e) { return state_number(e.point); },
                                       dimension::number, "1 elastic, 2 plastic"},
                                      {"sig_*", [](const EloutSolid& e) { return e.point.stress; }, dimension::stress,
                                       "stress"},
                                      {"yield", [](const EloutSolid& e) { return e.point.plastic_strain; },
                                       dimension::number, "plastic strain"},
                                      {"effsg", [](const EloutSolid& e) { return effective(e.point.stress); },
                                       dimension::stress, "von Mises stress"},
                                  }) +
                          columns(&EloutState::solids,
                                  {{"eps_*", &EloutSolid::strain, dimension::number, "logarithmic strain"}})
                              .where(has_strains),
               .written = [](const EloutState& s) { return !s.solids.empty(); }},
          },
      .legend = LegendLines::titles,
      .print = print,
  };
  return format;
}

}  // namespace nugget::output
