// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/contact.hpp"

// What the keyword of a sliding contact says besides its kind.
namespace nugget::model {

/// *CONTACT_AUTOMATIC_GENERAL: beams take part, against each other and against shells.
inline bool checks_beams(const Contact& contact) {
  return contact.keyword.starts_with("CONTACT_AUTOMATIC_GENERAL");
}
/// The nodes of SURFA's beams are pressed by segments: beside that also in *CONTACT_AUTOMATIC_SINGLE_SURFACE, by nodes,
/// and where SURFA only has nodes to be pressed.
inline bool tracks_beams(const Contact& contact) {
  if (contact.kind == Contact::Kind::one_way) return true;
  return checks_beams(contact) ||
         (contact.keyword.starts_with("CONTACT_AUTOMATIC_SINGLE_SURFACE") && contact.soft != 2);
}
/// ..._GENERAL_INTERIOR, and segment-based contact with DEPTH = 3 or more: all edges of shells are checked against each
/// other.
inline bool checks_all_edges(const Contact& contact) {
  const bool by_segments = contact.soft == 2 && contact.depth >= 3 && contact.kind != Contact::Kind::one_way;
  return by_segments || (checks_beams(contact) && contact.keyword.find("_INTERIOR") != std::string::npos);
}
/// Edges are checked: all, or in ..._GENERAL those that one shell alone has.
inline bool checks_edges(const Contact& contact) {
  return checks_beams(contact) || checks_all_edges(contact);
}
/// *CONTACT_ERODING_...: newly exposed faces are added as bricks are deleted.
inline bool erodes(const Contact& contact) {
  return contact.keyword.starts_with("CONTACT_ERODING");
}

}  // namespace nugget::model
