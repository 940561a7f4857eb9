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

}  // namespace

double effective(const Tensor& s) {
  const double a = s[0] - s[1], b = s[1] - s[2], c = s[2] - s[0];
  return std::sqrt(0.5 * (a * a + b * b + c * c) + 3.0 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]));
}

Elout::Elout(std::filesystem::path path, const Header& header, std::span<const LegendEntry> legend)
    : file_(std::move(path), header, legend_lines(legend)) {}

void Elout::write(const EloutState& state) {
  if (!state.solids.empty()) write_solids(state);
  if (!state.beams.empty()) write_beams(state);
  if (!state.shells.empty()) write_shells(state);
  file_.end_state();
}

void Elout::write_solids(const EloutState& state) {
  head(file_, "s t r e s s", state);
  file_.print(
      " element  materl\n"
      "     ipt  stress       sig-xx      sig-yy      sig-zz      sig-xy      sig-yz      sig-zx                       "
      "yield\n"
      "           state                                                                                  effsg      "
      "function\n");
  for (const EloutSolid& solid : state.solids) {
    element(file_, solid.id, solid.part);
    file_.print("       1 {:<7} ", state_of(solid.point));
    tensor(file_, solid.point.stress);
    file_.print("{:14.4E}{:14.4E}\n", column(effective(solid.point.stress)), column(solid.point.plastic_strain));
  }
  if (!state.strains) return;
  head(file_, "s t r a i n", state);
  file_.print(
      " element  strain       eps-xx      eps-yy      eps-zz      eps-xy      eps-yz      eps-zx                       "
      " "
      "    yield\n num/ipt   state\n");
  for (const EloutSolid& solid : state.solids) {
    element(file_, solid.id, solid.part);
    file_.print("      1  {:<7} ", state_of(solid.point));
    tensor(file_, solid.strain);
    file_.print("\n");
  }
}

void Elout::write_beams(const EloutState& state) {
  file_.print(" r e s u l t a n t s   a n d   s t r e s s e s   f o r   t i m e  s t e p{:9}   ( at time{:12.5E} )\n",
              state.cycle, column(state.time));
  for (const EloutBeam& beam : state.beams) {
    file_.print("\n\n beam/truss # ={:8}      part ID  ={:10}      material type={:8}\n", beam.id, beam.part,
                beam.material_type);
    file_.print("\n resultants      axial    shear-s    shear-t    moment-s   moment-t   torsion\n{:11}", "");
    for (const double r : {beam.axial, beam.shear_s, beam.shear_t, beam.moment_s, beam.moment_t, beam.torsion})
      file_.print("{:11.3E}", column(r));
    file_.print("\n");
    if (beam.points.empty()) continue;
    file_.print("\n\n integration point stresses\n{:23}sigma 11       sigma 12       sigma 31   plastic  eps\n", "");
    int number = 0;
    for (const EloutBeam::Point& p : beam.points)
      file_.print("{:5}           {:15.6E}{:15.6E}{:15.6E}{:15.6E}\n", ++number, column(p.axial), column(p.rs),
                  column(p.tr), column(p.plastic_strain));
  }
}

void Elout::write_shells(const EloutState& state) {
  const char* axes = state.local_shells ? "(local)" : "(global)";
  head(file_, "s t r e s s", state);
  file_.print(
      " element  materl{:<8}\n"
      " ipt-shl  stress       sig-xx      sig-yy      sig-zz      sig-xy      sig-yz      sig-zx       plastic\n"
      "           state                                                                                 strain \n",
      axes);
  for (const EloutShell& shell : state.shells) {
    element(file_, shell.id, shell.part);
    int number = 0;
    for (const EloutPoint& layer : shell.layers) {
      file_.print("{:4}-{:3} {:<7} ", ++number, 0, state_of(layer));
      tensor(file_, layer.stress);
      file_.print("{:14.4E}\n", column(layer.plastic_strain));
    }
  }
  if (!state.strains) return;
  file_.print("\n strains {:<8}      eps-xx      eps-yy      eps-zz      eps-xy      eps-yz      eps-zx{:36}\n{:117}\n",
              axes, "", "");
  for (const EloutShell& shell : state.shells) {
    element(file_, shell.id, shell.part);
    file_.print(" lower ipt       ");
    tensor(file_, shell.lower_strain);
    file_.print("\n upper ipt       ");
    tensor(file_, shell.upper_strain);
    file_.print("\n");
  }
}

}  // namespace nugget::output
