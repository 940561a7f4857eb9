// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/contact.hpp"

// What the keyword of a sliding contact says besides its kind.
namespace nugget::model {

/// *CONTACT_AUTOMATIC_GENERAL: beams, and the edges that one shell alone has, are checked against each other.
inline bool checks_edges(const Contact& contact) {
  return contact.keyword.starts_with("CONTACT_AUTOMATIC_GENERAL");
}
/// ..._GENERAL_INTERIOR: all edges of shells are.
inline bool checks_all_edges(const Contact& contact) {
  return checks_edges(contact) && contact.keyword.find("_INTERIOR") != std::string::npos;
}
/// *CONTACT_ERODING_...: faces of bricks come to light as the bricks before them die.
inline bool erodes(const Contact& contact) {
  return contact.keyword.starts_with("CONTACT_ERODING");
}

}  // namespace nugget::model
