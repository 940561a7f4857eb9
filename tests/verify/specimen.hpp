// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "base/vec3.hpp"
#include "experiment.hpp"

// Bars, strips and blocks as deck text, and what is read from them.
namespace nugget::verify {

/// Node ids of a regular mesh, counted by i, j, k along its directions.
struct Grid {
  int first = 1;
  std::array<int, 3> cells{};
  std::array<int, 3> nodes() const { return {cells[0] + 1, cells[1] + 1, cells[2] + 1}; }
  int operator()(int i, int j, int k = 0) const { return first + (k * (cells[1] + 1) + j) * (cells[0] + 1) + i; }
  /// All nodes with index i along x.
  std::vector<int> across(int i) const;
  std::vector<int> all() const;
};

/// A deck that grows: meshes get consecutive ids, the rest is keyword text.
class Specimen {
 public:
  using Map = std::function<Vec3d(int i, int j, int k)>;  ///< place of a grid node

  /// *KEYWORD with one card of fields.
  Specimen& card(const std::string& keyword, std::initializer_list<double> values);
  Specimen& text(const std::string& keywords);
  /// *PART with a heading; `hourglass` 0: that of the control card.
  Specimen& part(int id, int section, int material, int hourglass = 0);
  Specimen& node_set(int id, const std::vector<int>& nodes);
  int node(const Vec3d& x);
  /// A node with a mass and the same rotary inertia about every axis.
  int mass_point(const Vec3d& x, double mass, double inertia = 0.0);

  /// Bricks between `corner` and `corner + size`.
  Grid bricks(int part, const Vec3d& corner, const Vec3d& size, std::array<int, 3> cells);
  Grid bricks(int part, std::array<int, 3> cells, const Map& place);
  /// Shells in a plane of constant z.
  Grid shells(int part, const Vec3d& corner, const Vec3d& size, int along, int across);
  void brick(int part, std::initializer_list<int> nodes);
  void shell(int part, std::initializer_list<int> nodes);

  std::string deck() const;

 private:
  Grid grid(std::array<int, 3> cells, const Map& place);
  std::string keywords_, nodes_, shells_, bricks_;
  int last_node_ = 0, last_shell_ = 0, last_brick_ = 0;
};

/// *DEFINE_CURVE from 0 to `level` over `rise` without kinks in value, slope or curvature, then constant: a load that
/// grows so within many periods leaves next to no oscillation.
std::string smooth_ramp(int id, double rise, double level = 1.0);
/// *DEFINE_CURVE with the same value at all times.
std::string constant_curve(int id, double level = 1.0);

/// Mean of a quantity over time.
class TimeMean {
 public:
  void add(double value, double weight) { sum_ += weight * value, weight_ += weight; }
  double value() const { return sum_ / weight_; }

 private:
  double sum_ = 0.0, weight_ = 0.0;
};

/// Time at which a sampled signal passes a level, by straight lines between the samples; the first time only.
class Passage {
 public:
  explicit Passage(double level) : level_(level) {}
  void add(double time, double value);
  bool seen() const { return seen_; }
  double time() const { return at_; }

 private:
  double level_, time_ = 0.0, value_ = 0.0, at_ = 0.0;
  bool started_ = false, seen_ = false;
};

/// Mean time between the first and the last upward passage of zero.
class Period {
 public:
  void add(double time, double value);
  double mean() const { return (last_ - first_) / count_; }
  int count() const { return count_; }

 private:
  double first_ = 0.0, last_ = 0.0, value_ = 0.0, time_ = 0.0;
  int count_ = -1;
};

/// Runs the deck to its end time; anything else than normal termination is a test failure.
void run_to_end(Experiment& experiment, const Watch& watch);

/// Stress and plastic strain in layer k of an element, by user id.
system::ElementGroup::Layer shell_layer(const Experiment& experiment, const impact::Snapshot& now, int id, int k);
system::ElementGroup::Layer brick_layer(const Experiment& experiment, const impact::Snapshot& now, int id);

}  // namespace nugget::verify
