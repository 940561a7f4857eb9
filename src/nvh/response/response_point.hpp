// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nvh/matrices/nodal.hpp"

namespace nugget::nvh {

/// A linear form of the motion of nodes: a sum of components, each with a factor.
class Form {
 public:
  void add(int node, int component, double factor) { parts_.push_back({node, component, factor}); }
  double of(const Nodal& motion) const;
  /// The same over the unknowns, each once.
  std::vector<Equations::Term> over(const Equations& equations) const;

 private:
  struct Part {
    int node, component;
    double factor;
  };
  std::vector<Part> parts_;
};

/// What is wanted of a node in a direction: its motion, or the force (moment) by which supports hold it. That force is
/// K u + M u'' + C u' of the elements, masses and followers of the node, less the loads on it.
struct ResponsePoint {
  int id = 0;    ///< of the node, the user's
  int node = 0;  ///< of the system
  Vec3d direction;
  bool rotation = false, force = false;
  Form motion;            ///< the component of the motion; empty for a force
  Form elastic, inertia;  ///< of a force: K u, M u
};

std::vector<ResponsePoint> response_points_of(const Matrices& matrices,
                                              const model::FrequencyResponse::Response& response);

/// Errors for rotations of a node that has none, and for a force where no support holds.
void check_response(const Matrices& matrices, const model::FrequencyResponse::Response& response, const char* keyword,
                    Findings& findings);

}  // namespace nugget::nvh
