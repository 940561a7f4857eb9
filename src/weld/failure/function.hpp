// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>

#include "base/archive.hpp"
#include "base/finding.hpp"
#include "model/model.hpp"
#include "weld/failure/failure_mode.hpp"
#include "weld/failure/resultants.hpp"
#include "weld/tie/ties.hpp"

// The failure functions of MAT_100, one file for each kind. Formulas and what is known of their source:
// docs/theory/failure.md.
namespace nugget::weld::failure {

/// What a failure function knows of its weld beside the load; constant over the run.
struct Geometry {
  double diameter = 0.0;            ///< outer [length]
  double area = 0.0;                ///< of the cross-section [length^2]
  double section_modulus = 0.0;     ///< Z, of bending; of torsion it is 2 Z [length^3]
  std::array<double, 2> thickness;  ///< of the shells that its ends are tied to; 0: none [length]
  std::array<model::Index, 2> sheet{model::none, model::none};  ///< their parts

  int id = 0;  ///< of the weld
  model::Index part = model::none;
  double length = 0.0;  ///< at the start [length]

  double height = 0.0;  ///< of bricks: over which the shear force makes moments at the ends; 0: none [length]
  /// LCT, LCS, T_ORT and T_ORS of *CONTROL_SPOTWELD_BEAM at the shells that the ends of a beam, or of bricks for it,
  /// are tied to.
  struct ShellFactor {
    double size = 0.0;  ///< of the shell, sqrt of its area; 0: none [length]
    double tension = 1.0, shear = 1.0;
    double place = 0.0;  ///< of a beam: 0 in the middle of the shell, 1 on its border
    double angle = 0.0;  ///< of a beam: 0 towards the middle of a side, 45 towards a corner [degrees]
  };
  std::array<ShellFactor, 2> shell{};

  double thinner() const;  ///< of the two thicknesses that are not 0; 0: there is none
};
/// Of a solid disc.
Geometry disc(double diameter);
/// Of a weld as it was tied.
Geometry geometry_of(const model::Model& model, const Weld& weld);

struct Load {
  Resultants resultants;
  double rate = 0.0;  ///< effective strain rate [1/time]
  double time = 0.0;
  double area = 0.0;            ///< of a weld of bricks now, across the line of its faces' centres [length^2]
  double plastic_strain = 0.0;  ///< mean over the weld
  double energy = 0.0;          ///< work done on the weld's elements so far
};

/// A failure value and what it is made of. At 1 the weld fails.
struct Value {
  struct Term {
    FailureMode mode = FailureMode::axial;
    double value = 0.0;
  };
  double value = 0.0;
  std::array<Term, 4> term;  ///< those that add up to `value`; of a largest value (OPT 5) the candidates
  int terms = 0;
  // Of connections (MAT_100_DA) only.
  double load = 0.0;        ///< over that on the failure surface in the same direction
  double area = 0.0;        ///< of the section that the stresses are made with [length^2]
  double solid_area = 0.0;  ///< of the bricks [length^2]
  double rate = 0.0;        ///< smoothed strain rate [1/time]

  void add(FailureMode mode, double share) {
    term[terms++] = {mode, share};
    value += share;
  }
  /// The largest term; meaningful if there is one.
  FailureMode largest() const;
};

/// Left side of the failure criterion of one weld. It may remember earlier loads: to be called once a cycle.
class Function {
 public:
  virtual ~Function() = default;
  virtual Value operator()(const Load& load) = 0;
  /// What it remembers.
  virtual void archive(Archive& a) = 0;
};

/// The failure function that OPT of `law` asks for, or the connection of MAT_100_DA. What the weld lacks for it (a
/// sheet, a thickness, a strength) is a warning at `place`, and its terms are left out. `model` and `law` must outlive
/// it.
std::unique_ptr<Function> make_function(const model::Model& model, const model::WeldLaw& law, const Geometry& weld,
                                        const Place& place, Findings& findings);

// Each kind. Several OPT may share one.
std::unique_ptr<Function> resultant_surface(const model::WeldLaw& law);  ///< OPT -2 -1 0
std::unique_ptr<Function> beam_stress(model::RateValue normal, model::RateValue shear, const Geometry& weld);  ///< 1, 7
/// OPT 6: the sheets' own stresses at failure, each raised by its material's Cowper-Symonds factor; the weaker counts.
struct SheetStrength {
  double normal = 0.0, shear = 0.0;   ///< [stress]; 0: left out
  double rate_c = 0.0, rate_p = 0.0;  ///< Cowper-Symonds; C = 0: no rate effect
};
std::unique_ptr<Function> sheet_stress(std::array<SheetStrength, 2> sheets, const Geometry& weld);
/// OPT 3 and 4: diameter and thickness of the law, or the weld's own.
std::unique_ptr<Function> notch_stress(const model::WeldLaw& law, double diameter, double thickness);
std::unique_ptr<Function> structural_stress(double diameter, std::array<double, 2> thickness, double limit);  ///< OPT 5
/// OPT 10. `normal` and `shear` are static strengths, `thickness` the effective one (TFLAG, TSCALE).
std::unique_ptr<Function> load_rate_stress(const model::LoadRateStrengths& table, double normal, double shear,
                                           double diameter, double thickness);
std::unique_ptr<Function> direction(const model::WeldLaw& law);  ///< OPT 11
/// FVAL of OPT -2 -1 0 2 12 22: a *DEFINE_FUNCTION. `formula` must outlive it.
std::unique_ptr<Function> user_formula(const Formula& formula, const model::WeldLaw& law, const Geometry& weld);
/// OPT 2 12 22 by the library of the model.
std::unique_ptr<Function> user_library(const model::Model& model, const model::WeldLaw& law, const Geometry& weld);
/// MAT_100_DA. `rate_filter`: RFILTF. `properties` must outlive it.
std::unique_ptr<Function> connection_stress(const model::ConnectionProperties& properties,
                                            const model::ConnectionProperties::Record& record, double rate_filter,
                                            const Geometry& weld);

/// Of a beam tied to shells, or bricks in its place (mean size); all factors 1 without curves.
std::array<Geometry::ShellFactor, 2> shell_factors(const model::Model& model, const Weld& weld);

// Around another function.
/// The value at the end of a weld of bricks where it is larger, the shear force acting over `height` (TRUE_T). `once`:
/// `inner` remembers, and is asked for the end with the larger bending moment only.
std::unique_ptr<Function> worse_end(std::unique_ptr<Function> inner, double height, bool once);
/// The value with its parts by tension and by shear over the factors of the shells, at the worse end.
std::unique_ptr<Function> by_shell_size(std::unique_ptr<Function> inner,
                                        const std::array<Geometry::ShellFactor, 2>& ends);

}  // namespace nugget::weld::failure
