// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "output/history.hpp"

namespace nugget::output {

/// One integration point: stress, of shells in the axes that EloutState says, of bricks in global ones
/// [force/length^2].
struct EloutPoint {
  Tensor stress{};
  double plastic_strain = 0.0;
};

/// A brick: its centre, or the mean of its points.
struct EloutSolid {
  int id = 0, part = 0;  ///< user ids
  EloutPoint point;
  Tensor strain{};  ///< logarithmic, written where EloutState::strains is set
};
/// Von Mises' stress.
double effective(const Tensor& stress);

/// Resultants of a beam in its own axes, and the points over its section (axial stress and the two shear stresses).
struct EloutBeam {
  int id = 0, part = 0;
  int material_type = 0;                                 ///< number of the law, e.g. 100
  double axial = 0.0, shear_s = 0.0, shear_t = 0.0;      ///< [force]
  double moment_s = 0.0, moment_t = 0.0, torsion = 0.0;  ///< [force length]
  struct Point {
    double axial = 0.0, rs = 0.0, tr = 0.0, plastic_strain = 0.0;
  };
  std::vector<Point> points;
};

/// All layers of a shell, from the bottom to the top.
struct EloutShell {
  int id = 0, part = 0;
  std::vector<EloutPoint> layers;
  Tensor lower_strain{}, upper_strain{};  ///< at the outermost layers; as EloutSolid::strain
};

struct EloutState {
  long cycle = 0;
  double time = 0.0;
  bool strains = false;       ///< STRFLG
  bool local_shells = false;  ///< shells in axes of their own, else in global ones
  std::vector<EloutSolid> solids;
  std::vector<EloutBeam> beams;
  std::vector<EloutShell> shells;
  std::vector<EloutShell> thick_shells;  ///< in global axes
};

/// The tables of `elout` as text, in their order: each has its head, then rows of elements, all at once or some at a
/// time.
enum class EloutTable { solids, strains_of_solids, beams, shells, strains_of_shells, thick_shells, strains_of_thick };
inline constexpr std::array elout_tables{
    EloutTable::solids,          EloutTable::strains_of_solids, EloutTable::beams,
    EloutTable::shells,          EloutTable::strains_of_shells, EloutTable::thick_shells,
    EloutTable::strains_of_thick};
/// Whether a table shows strains, which EloutState::strains asks for.
constexpr bool shows_strains(EloutTable table) {
  return table == EloutTable::strains_of_solids || table == EloutTable::strains_of_shells ||
         table == EloutTable::strains_of_thick;
}
/// `state`: what it says besides elements.
void print_head(AsciiFile& file, EloutTable table, const EloutState& state);
void print_rows(AsciiFile& file, EloutTable table, const EloutState& rows);

/// The file `elout`; the legend holds the headings of *DATABASE_HISTORY_..._ID. The state of a point is `plastic`
/// once it has a plastic strain.
const HistoryFormat<EloutState>& elout();

}  // namespace nugget::output
