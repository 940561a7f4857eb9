// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "impact/simulation/simulation.hpp"
#include "model/model.hpp"
#include "system/system.hpp"
#include "weld/tie/ties.hpp"

// A deck, run inside a test and looked at in every cycle.
namespace nugget::verify {

using Watch = std::function<void(const impact::Snapshot&)>;

/// Throws std::runtime_error with all findings if one is an error.
void stop_on_errors(const Findings& findings);

/// The deck's model as the command makes it: with *CONTROL_COARSEN obeyed.
model::Model read_model(const std::string& deck, Findings& findings);

class Experiment {
 public:
  /// Reads, checks, ties. A refused deck throws std::runtime_error with all its findings. NUGGET_PRECISION=single in
  /// the environment has it computed as `nugget run --precision single` would (tools/precision_table.py).
  explicit Experiment(const std::string& deck);

  /// Runs to the deck's end time (or `until`), calling `watch` at each t(n) with everything known. Energies are up to
  /// date. With NUGGET_RESUME in the environment the run is done once more from a state that was kept on the way, as
  /// from a restart file, and must end with the same bits: what a restart file lacks shows in one deck or another.
  impact::Outcome run(const Watch& watch, double until = 0.0);

  const model::Model& model() const { return *model_; }
  const Findings& findings() const { return findings_; }
  const weld::Ties& ties() const { return *ties_; }
  system::System& system() { return *system_; }
  impact::Simulation& simulation() { return *simulation_; }

  /// System node of a user id.
  std::size_t node(int id) const;
  Vec3d position(const impact::Snapshot& now, int id) const { return vec(now.state.x[node(id)]); }
  Vec3d displacement(const impact::Snapshot& now, int id) const;
  Vec3d velocity(const impact::Snapshot& now, int id) const { return now.velocity(node(id)); }
  /// Resultants of the weld beam with a user id, filtered as its failure sees them.
  const weld::Resultants& weld(const impact::Snapshot& now, int id) const;
  const weld::History& history(const impact::Snapshot& now, int id) const;

 private:
  void expect_same_end(const std::string& kept, double until) const;

  std::string text_;
  Findings findings_;
  std::unique_ptr<model::Model> model_;
  std::unique_ptr<weld::Ties> ties_;
  std::unique_ptr<system::System> system_;
  std::unique_ptr<impact::Simulation> simulation_;
};

/// Compares a value with its reference from outside and writes a row for the book's table: case (a heading of
/// docs/verification/cases.md), what was measured, and the gate as a share of the reference (of `scale` where that is
/// given, for references near 0). A failure is a test failure.
void expect_reference(const std::string& test_case, const std::string& what, double value, double reference,
                      double gate, double scale = 0.0);

// Deck text in fixed columns.
std::string fields(std::initializer_list<double> values);     ///< 10 columns each, full precision that fits
std::string node_line(int id, double x, double y, double z);  ///< *NODE
std::string element_line(int id, int part, std::initializer_list<int> nodes);        ///< 8 columns each
std::string curve(int id, std::initializer_list<std::pair<double, double>> points);  ///< *DEFINE_CURVE, whole

}  // namespace nugget::verify
