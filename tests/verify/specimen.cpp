// SPDX-License-Identifier: Apache-2.0
#include "specimen.hpp"
#include "base/index.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

namespace nugget::verify {
namespace {

system::ElementGroup::Layer layer_of(const impact::Snapshot& now, const std::vector<int>& ids,
                                     const std::vector<system::System::ElementLocation>& locations, int id, int k) {
  const auto found = std::find(ids.begin(), ids.end(), id);
  if (found == ids.end()) throw std::runtime_error(fmt::format("no element {}", id));
  const system::System::ElementLocation location = locations[found - ids.begin()];
  return now.system.groups[location.group]->layer(at(location.element), k, now.state);
}

}  // namespace

std::vector<int> Grid::across(int i) const {
  std::vector<int> ids;
  for (int k = 0; k <= cells[2]; ++k)
    for (int j = 0; j <= cells[1]; ++j) ids.push_back((*this)(i, j, k));
  return ids;
}

std::vector<int> Grid::all() const {
  std::vector<int> ids;
  for (int n = first; n <= (*this)(cells[0], cells[1], cells[2]); ++n) ids.push_back(n);
  return ids;
}

Specimen& Specimen::card(const std::string& keyword, std::initializer_list<double> values) {
  return text('*' + keyword + '\n' + fields(values));
}

Specimen& Specimen::text(const std::string& keywords) {
  keywords_ += keywords;
  return *this;
}

Specimen& Specimen::part(int id, int section, int material, int hourglass) {
  return text(fmt::format("*PART\npart {}\n{:10d}{:10d}{:10d}{:10d}{:10d}\n", id, id, section, material, 0, hourglass));
}

Specimen& Specimen::node_set(int id, const std::vector<int>& nodes) {
  keywords_ += fmt::format("*SET_NODE_LIST\n{:10d}", id);
  for (std::size_t i = 0; i < nodes.size(); ++i) keywords_ += fmt::format("{}{:10d}", i % 8 == 0 ? "\n" : "", nodes[i]);
  keywords_ += '\n';
  return *this;
}

int Specimen::node(const Vec3d& x) {
  nodes_ += node_line(++last_node_, x.x, x.y, x.z);
  return last_node_;
}

int Specimen::mass_point(const Vec3d& x, double mass, double inertia) {
  const int n = node(x);
  text(fmt::format("*ELEMENT_INERTIA\n{:8}{:8}\n", n, n) + fields({inertia, 0, 0, inertia, 0, inertia, mass}));
  return n;
}

void Specimen::brick(int part, std::initializer_list<int> nodes) {
  bricks_ += element_line(++last_brick_, part, nodes);
}
void Specimen::shell(int part, std::initializer_list<int> nodes) {
  shells_ += element_line(++last_shell_, part, nodes);
}

Grid Specimen::grid(std::array<int, 3> cells, const Map& place) {
  const Grid grid{last_node_ + 1, cells};
  for (int k = 0; k <= cells[2]; ++k)
    for (int j = 0; j <= cells[1]; ++j)
      for (int i = 0; i <= cells[0]; ++i) node(place(i, j, k));
  return grid;
}

Grid Specimen::bricks(int part, const Vec3d& corner, const Vec3d& size, std::array<int, 3> cells) {
  return bricks(part, cells, [&](int i, int j, int k) {
    return corner + Vec3d{size.x * i / cells[0], size.y * j / cells[1], size.z * k / cells[2]};
  });
}

Grid Specimen::bricks(int part, std::array<int, 3> cells, const Map& place) {
  const Grid n = grid(cells, place);
  for (int k = 0; k < cells[2]; ++k)
    for (int j = 0; j < cells[1]; ++j)
      for (int i = 0; i < cells[0]; ++i)
        brick(part, {n(i, j, k), n(i + 1, j, k), n(i + 1, j + 1, k), n(i, j + 1, k), n(i, j, k + 1), n(i + 1, j, k + 1),
                     n(i + 1, j + 1, k + 1), n(i, j + 1, k + 1)});
  return n;
}

Grid Specimen::shells(int part, const Vec3d& corner, const Vec3d& size, int along, int across) {
  const Grid n = grid({along, across, 0}, [&](int i, int j, int) {
    return corner + Vec3d{size.x * i / along, size.y * j / across, 0.0};
  });
  for (int j = 0; j < across; ++j)
    for (int i = 0; i < along; ++i) shell(part, {n(i, j), n(i + 1, j), n(i + 1, j + 1), n(i, j + 1)});
  return n;
}

std::string Specimen::deck() const {
  std::string deck = "*KEYWORD\n" + keywords_ + "*NODE\n" + nodes_;
  if (!shells_.empty()) deck += "*ELEMENT_SHELL\n" + shells_;
  if (!bricks_.empty()) deck += "*ELEMENT_SOLID\n" + bricks_;
  return deck + "*END\n";
}

std::string smooth_ramp(int id, double rise, double level) {
  std::string text = "*DEFINE_CURVE\n" + fields({static_cast<double>(id), 0, 1, 1, 0, 0, 0});
  constexpr int points = 400;
  for (int i = 0; i <= points; ++i) {
    const double s = static_cast<double>(i) / points;
    text += fmt::format("{:20.12g}{:20.12g}\n", rise * s, level * s * s * s * (10.0 - s * (15.0 - 6.0 * s)));
  }
  return text + fmt::format("{:20.12g}{:20.12g}\n", 1000.0 * rise, level);
}

std::string constant_curve(int id, double level) {
  return curve(id, {{0.0, level}, {1e6, level}});
}

void Passage::add(double time, double value) {
  if (started_ && !seen_ && (value_ - level_) * (value - level_) <= 0.0 && value != value_) {
    at_ = time_ + (time - time_) * (level_ - value_) / (value - value_);
    seen_ = true;
  }
  started_ = true;
  time_ = time;
  value_ = value;
}

void Period::add(double time, double value) {
  if (value_ < 0.0 && value >= 0.0) {
    last_ = time_ + (time - time_) * value_ / (value_ - value);
    if (++count_ == 0) first_ = last_;
  }
  value_ = value;
  time_ = time;
}

void run_to_end(Experiment& experiment, const Watch& watch) {
  const impact::Outcome outcome = experiment.run(watch);
  EXPECT_EQ(outcome.termination, impact::Termination::normal) << outcome.message;
}

system::ElementGroup::Layer shell_layer(const Experiment& experiment, const impact::Snapshot& now, int id, int k) {
  return layer_of(now, experiment.model().shells.id, now.system.shell_location, id, k);
}

system::ElementGroup::Layer brick_layer(const Experiment& experiment, const impact::Snapshot& now, int id) {
  return layer_of(now, experiment.model().solids.id, now.system.solid_location, id, 0);
}

}  // namespace nugget::verify
