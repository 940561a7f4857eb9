// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/command.hpp"
#include "model/model.hpp"
#include "weld/coupon/coupon.hpp"

namespace nugget::app {

/// What is wrong with a card as the start of coupons; said to the user, nothing is run.
struct CardFault : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Runs `work`, a study of a weld card, in its folder (guarded); a fault of the card or of a coupon's run becomes its
/// exit code.
template <class Work>
ExitCode study_card(const std::string& directory, Work work) {
  return guarded(directory, [&](const std::filesystem::path& folder) {
    try {
      return work(folder);
    } catch (const CardFault& fault) {
      fmt::print(stderr, "nugget: {}\n", fault.what());
      return ExitCode::refused;
    } catch (const output::WriteError&) {
      throw;
    } catch (const std::runtime_error& error) {
      fmt::print(stderr, "nugget: {}\n", error.what());
      return ExitCode::error_termination;
    }
  });
}

/// A card as coupons take it, and what is to be said of it.
struct TakenCard {
  weld::CouponCard card;
  std::vector<std::string> notes;
  model::WeldLaw law;  ///< of a weld of a *MAT_SPOTWELD
  Place place;         ///< of the weld's material, or of its own first card
};

/// Reads the card of `arguments`; decks will stand in `directory`. Throws CardFault.
TakenCard take_card(const CouponArguments& arguments, const std::filesystem::path& directory);

/// The file of a card with other strengths (NRR NRS NRT MRR MSS MTT) on the second card of its *MAT_SPOTWELD, another
/// RS (above 0) on its third, and `remarks` above them, all else as it was. Throws CardFault where the text does not
/// allow it.
std::string with_strengths(const TakenCard& taken, const std::array<double, 6>& strength, double rupture,
                           const std::vector<std::string>& remarks);

/// The same of an interpolation spot weld: its RN, RS, ALPHA1 and GAMMA as in `joint`.
std::string with_joint_strengths(const TakenCard& taken, const kernel::Spr3& joint,
                                 const std::vector<std::string>& remarks);

}  // namespace nugget::app
