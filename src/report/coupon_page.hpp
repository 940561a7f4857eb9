// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "model/units.hpp"

// What `nugget coupon` says of a weld's card: tables, pictures and a page (docs/manual/coupon.md#what-comes-out).
namespace nugget::report {

/// One coupon that was run.
struct CouponResult {
  std::string name, title;                  ///< `ks2_45`; `KS-2, 45 degrees`
  double angle = 0.0;                       ///< of the load to the sheets [degrees]
  std::vector<double> displacement, force;  ///< of the moving grip along the pull, until the weld failed or the end
  double peak = 0.0, at = 0.0;              ///< largest force, and the displacement there
  double work = 0.0;                        ///< of the grip
  bool failed = false;                      ///< the weld; else `peak` is what it bore until the end
  std::string failure_mode;
  // In the weld when it failed, else at the end; of an interpolation spot weld or a rivet when the force was largest:
  double axial = 0.0, shear = 0.0, bending = 0.0, torsion = 0.0, failure_value = 0.0;
  double surface = 0.0;          ///< force that the failure function allows along `angle`, without moments
  double surface_at_load = 0.0;  ///< the same along the weld's own force
  double load() const;           ///< of the weld: sqrt(axial^2 + shear^2)
  double load_angle() const;     ///< of it to the sheets [degrees]
};

struct CouponStudy {
  std::string card;                ///< its file
  std::vector<std::string> notes;  ///< what was taken from the card and what was added
  model::Units units;
  std::vector<double> angle, surface;  ///< the card's own surface by its failure function
  std::vector<CouponResult> results;
};

/// Table for the terminal.
std::string coupon_table(const CouponStudy& study);
/// coupon.csv (a row a test), curves.csv (test, angle, displacement, force), surface.csv, units.csv, coupon.svg
/// (force over angle), curves.svg, coupon.html. Throws output::WriteError.
void write_coupon_study(const std::filesystem::path& directory, const CouponStudy& study);

}  // namespace nugget::report
