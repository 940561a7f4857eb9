// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/commands.hpp"
#include "model/model.hpp"
#include "weld/coupon/coupon.hpp"

namespace nugget::app {

/// What is wrong with a card as the start of coupons; said to the user, nothing is run.
struct CardFault : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A card as coupons take it, and what is to be said of it.
struct TakenCard {
  weld::CouponCard card;
  std::vector<std::string> notes;
  model::WeldLaw law;
  Place place;  ///< of the weld's material
};

/// Reads the card of `arguments`; decks will stand in `directory`. Throws CardFault.
TakenCard take_card(const CouponArguments& arguments, const std::filesystem::path& directory);

/// The file of a card with other strengths (NRR NRS NRT MRR MSS MTT) on the second card of its *MAT_SPOTWELD and
/// `remarks` above it, all else as it was. Throws CardFault where the text does not allow it.
std::string with_strengths(const TakenCard& taken, const std::array<double, 6>& strength,
                           const std::vector<std::string>& remarks);

}  // namespace nugget::app
