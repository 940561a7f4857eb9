// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "nvh/eigen/modes.hpp"
#include "specimen.hpp"

// A deck in a linear analysis inside a test.
namespace nugget::verify {

class LinearExperiment {
 public:
  /// Reads, checks, ties, assembles K and M. A refused deck throws std::runtime_error with all its findings.
  explicit LinearExperiment(const std::string& deck);

  const nvh::Matrices& matrices() const { return *matrices_; }
  const system::System& system() const { return *system_; }
  const Findings& findings() const { return findings_; }

  /// The lowest modes; that none is missing is asserted.
  nvh::Modes modes(int count) const;
  /// The same without rigid motions: those below a thousandth of the mode after the first six, which must be six.
  std::vector<double> elastic_frequencies(int count) const;
  /// Motion of the node with a user id in a mode.
  nvh::SixDof motion(const nvh::Modes& modes, std::size_t mode, int node) const;

 private:
  Findings findings_;
  std::unique_ptr<model::Model> model_;
  std::unique_ptr<weld::Ties> ties_;
  std::unique_ptr<model::Model> linear_;
  std::unique_ptr<system::System> system_;
  std::unique_ptr<nvh::Matrices> matrices_;
};

/// Motion of the node with a user id in the linear statics of a specimen, which gets the cards of the analysis and
/// curve 1, constant.
nvh::SixDof static_motion(Specimen specimen, int node);

}  // namespace nugget::verify
