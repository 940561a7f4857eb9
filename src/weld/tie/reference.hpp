// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <vector>

#include "base/bvh.hpp"
#include "model/model.hpp"
#include "weld/tie/segment.hpp"

namespace nugget::weld {

using model::Index;
using model::none;

/// One face of the reference side of a tie.
struct ReferenceSegment {
  model::Segment node{};
  Index shell = none;      ///< none: the face of something else
  Index part = none;       ///< of the shell or brick
  double thickness = 0.0;  ///< as the contact sees it [length]
  double diagonal = 0.0;   ///< the shorter one [length]
  double moved = 0.0;      ///< how far contact has moved its nodes, at most [length]

  bool triangle() const { return node[3] == node[2]; }
  bool has(Index n) const;
};

/// A segment that a node can be tied to.
struct Candidate {
  Index contact = none;
  Index order = none;  ///< position of the segment on the reference side
  ReferenceSegment segment;
  Foot foot;
  double tolerance = 0.0;  ///< [length]
  /// Foot::gap and Foot::distance where the deck has the segment: they say which sheet is meant, though contact may
  /// have moved another one closer since [length].
  double gap = 0.0, distance = 0.0;

  bool within_tolerance() const { return gap <= tolerance; }
};

/// What the surroundings of one tracked node offer it.
struct NearbySegments {
  std::vector<Candidate> within_tolerance;  ///< the best of each part, the best of all first
  Candidate closest;  ///< without regard to the tolerance; `contact` is none if there is no segment at all
  /// The distance to the plane of a sheet that is closer than the best candidate but ends before it reaches the node
  /// (projection case 6); infinite if there is none [length].
  double plane_of_other_sheet = std::numeric_limits<double>::infinity();
};

/// A tracked node as the search needs it.
struct Tracked {
  Index node = none;
  double thickness = 0.0;  ///< t_s [length]
  Index only_part = none;  ///< of *ELEMENT_BEAM_PID
  Index not_part = none;   ///< of the other end's sheet; see aim_clusters
  double aside = -1.0;     ///< t_s for segments beside which the node lies; below 0: `thickness` [length]
};

/// The reference side of one tie contact, ready to be searched.
class Reference {
 public:
  /// `x`: places of the nodes [length].
  Reference(const model::Model& model, const std::vector<Vec3d>& x, Index contact);

  bool empty() const { return segments_.empty(); }
  const std::vector<ReferenceSegment>& segments() const { return segments_; }
  NearbySegments search(const Tracked& tracked) const;
  /// The closest segment of any part but this one, however far; `contact` is none if there is none.
  Candidate closest_elsewhere(const Tracked& tracked, Index part) const;

 private:
  void add_shell(Index shell);
  void add_brick_faces(Index part);
  void add_segments(const std::vector<model::Segment>& segments);
  void add_face(const model::Segment& nodes, Index part);
  /// Holds every point that the segment may be in reach of, but for the share of the node's own thickness.
  Box neighbourhood(const ReferenceSegment& segment) const;
  bool allowed(const ReferenceSegment& segment, const Tracked& tracked) const;
  double tolerance(const ReferenceSegment& segment, const Tracked& tracked) const;
  void add(ReferenceSegment segment);
  Corners corners(const ReferenceSegment& segment) const;
  Corners corners_in_deck(const ReferenceSegment& segment) const;
  Candidate candidate(Index order, const Tracked& tracked) const;
  template <class Wanted>
  Candidate closest(const Tracked& tracked, double bound, Wanted&& wanted) const;
  double plane_of_other_sheet(const Tracked& tracked, const NearbySegments& nearby) const;

  const model::Model& model_;
  const std::vector<Vec3d>& x_;
  const model::Contact& contact_;
  Index contact_index_;
  std::vector<ReferenceSegment> segments_;
  BoxTree tree_;
};

}  // namespace nugget::weld
