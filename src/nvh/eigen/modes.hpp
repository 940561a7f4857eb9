// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <limits>
#include <string>

#include "nvh/eigen/lanczos.hpp"

namespace nugget::nvh {

/// Which modes: frequencies in cycles per time of the deck.
struct ModeRequest {
  int count = 0;  ///< at most so many; 0: all between `low` and `high`, which must then be given
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
  double centre = 0.0;  ///< above 0: those nearest to it
  /// Where many more than these are wanted, they are sought from several places of the spectrum, at least so many at
  /// each.
  std::size_t slice = 128;
};

/// Natural modes, ascending, mass-normalized (phi^t M phi = 1).
struct Modes {
  std::vector<double> eigenvalue;         ///< omega^2 [1/time^2]; about 0 for rigid motions, of either sign
  Columns shape;                          ///< in the unknowns of the Equations
  double frequency(std::size_t i) const;  ///< cycles per time; 0 for a negative eigenvalue
  bool elastic(std::size_t i) const;      ///< no rigid motion, whose eigenvalue is round-off only

  /// Participation phi^t M r, r the rigid motions of unit size: translations, and rotations about the centre of mass.
  /// Its square is the effective mass (or inertia).
  std::vector<SixDof> participation;
  SixDof total{};  ///< mass and inertia about the centre of mass that effective masses are shares of
  Vec3d centre;    ///< of mass

  /// Sylvester's count between the ends of the interval that was searched, against what was found.
  struct Proof {
    double low = 0.0, high = 0.0;  ///< frequencies at which was counted; low = 0: everything below `high`
    int counted = 0, found = 0;
    bool complete() const { return counted == found; }
  } proof;
  struct Cost {
    double factor_seconds = 0.0, lanczos_seconds = 0.0;
    int factorizations = 0, solves = 0;
    double factor_entries = 0.0;
    double most_memory = 0.0, memory = 0.0;  ///< see Factorization::Cost
  } cost;
};

/// A note on the directions of prescribed motions, which stand still in modes.
void report_fixed_motions(const Equations& equations, const model::Model& model, Findings& findings);

/// What is going on, in words, for a progress line.
using ProgressCallback = std::function<void(const std::string&)>;

/// Throws Factorization::SolverError.
Modes find_modes(const Matrices& matrices, const ModeRequest& request, const ProgressCallback& progress = {});

/// A small part of the first elastic eigenvalue of a slender body of the model's size and thickness: with it K + shift
/// M of a free body is positive definite and the shift costs no digits [1/time^2]. Without a material that has a speed
/// of sound: 1e-6 of the largest quotient of a diagonal entry of K and one of M.
double small_shift(const Matrices& matrices);

/// How the strain energy of each mode is spread: rows are parts or welds, columns are modes; a column of `part` sums to
/// 1 (welds are elements of their part). Rigid motions, which have none, have zeros.
struct EnergyShares {
  Columns part;  ///< by model part
  Columns weld;  ///< by Ties::welds
};
EnergyShares energy_shares(const Matrices& matrices, const Modes& modes);

/// Modal assurance criterion between nodal motions: |a^t b|^2 / (a^t a b^t b), over translations. Entry j of column i
/// compares mode i of `a` with mode j of `b`; both have 3 numbers a node, the same nodes.
Columns compute_mac(const Columns& a, const Columns& b);

/// Partners by likeness (modes of one run in columns, of the other in rows), the most alike first: the row of each
/// column, each row once; -1 where none is left.
std::vector<int> partners(const Columns& mac);

}  // namespace nugget::nvh
