// SPDX-License-Identifier: Apache-2.0
#include "output/d3plot_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <numeric>
#include <stdexcept>
#include <string_view>

#include "base/index.hpp"
#include "output/d3plot_layout.hpp"

namespace nugget::output {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& file, const std::string& why) {
  throw std::runtime_error(fmt::format("{}: {}", file.string(), why));
}

/// Bytes of a file from `offset`; fewer where it ends before.
std::string read_bytes(const fs::path& path, std::uint64_t offset, std::size_t count) {
  std::ifstream file(path, std::ios::binary);
  std::string bytes(count, '\0');
  file.seekg(static_cast<std::streamoff>(offset));
  file.read(bytes.data(), static_cast<std::streamsize>(count));
  bytes.resize(file.gcount() > 0 ? static_cast<std::size_t>(file.gcount()) : 0);
  return bytes;
}

/// Takes 4-byte words one after the other.
class WordReader {
 public:
  WordReader(fs::path file, std::string bytes) : file_(std::move(file)), bytes_(std::move(bytes)) {}

  int integer() { return next<std::int32_t>(); }
  double real() { return static_cast<double>(next<float>()); }
  Vec3d vector() {
    const double x = real(), y = real();
    return {x, y, real()};
  }
  std::array<double, 6> six() {
    std::array<double, 6> all{};
    for (double& value : all) value = real();
    return all;
  }
  std::string text(std::size_t characters) {
    expect(characters);
    std::string value = bytes_.substr(place_, characters);
    place_ += characters;
    value.erase(value.find_last_not_of(std::string_view(" \0", 2)) + 1);
    return value;
  }
  /// A whole number from 0 that counts what follows.
  std::size_t count() {
    const int value = integer();
    if (value < 0) refuse(file_, "not a d3plot: a count is negative");
    return at(value);
  }
  void skip(std::size_t words) { place_ += words * d3plot_word; }
  std::size_t words_left() const { return place_ < bytes_.size() ? (bytes_.size() - place_) / d3plot_word : 0; }
  const fs::path& file() const { return file_; }

 private:
  void expect(std::size_t bytes) const {
    if (bytes_.size() < place_ + bytes) refuse(file_, "cut off");
  }
  template <class T>
  T next() {
    expect(d3plot_word);
    T value{};
    std::memcpy(&value, bytes_.data() + place_, d3plot_word);
    place_ += d3plot_word;
    return value;
  }
  fs::path file_;
  std::string bytes_;
  std::size_t place_ = 0;
};

/// The control section, as far as it is needed beside the geometry.
struct Control {
  std::size_t nodes = 0, solids = 0, thick_shells = 0, beams = 0, shells = 0, parts = 0, numbering = 0;
  int globals = 0, of_solid = 0, of_thick_shell = 0, of_beam = 0, of_shell = 0;
  bool velocities = false, accelerations = false;
};

D3plotGeometry::Family family_of(const fs::path& file, int type) {
  switch (type) {
    case 1: return D3plotGeometry::Family::d3plot;
    case 11: return D3plotGeometry::Family::d3eigv;
    case 21: return D3plotGeometry::Family::d3ssd;
    default: refuse(file, fmt::format("file type {}: no d3plot, d3eigv or d3ssd in single precision", type));
  }
}

Control read_control(WordReader& in, D3plotGeometry& g) {
  Control c;
  g.title = in.text(40);
  g.seconds_since_1970 = in.integer();
  g.family = family_of(in.file(), in.integer());
  in.skip(3);  // source version, release, format version
  if (const int dimensions = in.integer(); dimensions != 4)
    refuse(in.file(),
           fmt::format("NDIM = {}: only 4 is read (no rigid road, no rigid bodies' own states)", dimensions));
  c.nodes = in.count();
  in.skip(1);  // ICODE
  c.globals = in.integer();
  if (in.integer() != 0) refuse(in.file(), "temperatures (IT) are not read");
  if (in.integer() != 1) refuse(in.file(), "states without coordinates (IU) are not read");
  c.velocities = in.integer() != 0;
  c.accelerations = in.integer() != 0;
  c.solids = in.count();
  in.skip(3);
  c.of_solid = in.integer();
  c.beams = in.count();
  in.skip(1);
  c.of_beam = in.integer();
  c.shells = in.count();
  in.skip(1);
  c.of_shell = in.integer();
  g.solid_histories = in.integer();
  g.shell_histories = in.integer();
  g.layers = -in.integer() - 10000;  // MAXINT
  if (g.layers < 0) refuse(in.file(), "without a table of deleted elements (MAXINT above -10000): not read");
  if (in.integer() != 0) refuse(in.file(), "particles (NMSPH) are not read");
  in.skip(1);
  c.numbering = in.count();
  c.thick_shells = in.count();
  in.skip(1);
  c.of_thick_shell = in.integer();
  const std::array<int, 4> there{in.integer(), in.integer(), in.integer(), in.integer()};  // IOSHL
  g.shell_stresses = there[0] == 1000;
  if (there[1] != there[0] || there[2] != there[0] || there[3] != 1000)
    refuse(in.file(),
           "shells with a part of stresses, plastic strain and resultants, or without energy (IOSHL): not read");
  in.skip(4);
  c.parts = in.count();
  in.skip(12);
  return c;
}

template <std::size_t N>
void read_elements(WordReader& in, std::size_t count, const Control& c, std::size_t blanks,
                   std::vector<D3plotElement<N>>& elements) {
  elements.resize(count);
  for (auto& element : elements) {
    for (int& node : element.nodes) {
      node = in.integer() - 1;
      if (node < 0 || at(node) >= c.nodes) refuse(in.file(), "an element names a node that is not there");
    }
    in.skip(blanks);
    element.part = in.integer() - 1;
    if (element.part < 0 || at(element.part) >= c.parts) refuse(in.file(), "an element names a part that is not there");
  }
}

/// User numbers. Their head is longer where parts have arbitrary ids (NSORT below 0).
void read_numbering(WordReader& in, const Control& c, D3plotGeometry& g) {
  g.node_ids.resize(c.nodes);
  g.parts.resize(c.parts);
  for (std::size_t i = 0; i < c.parts; ++i) g.parts[i].id = static_cast<int>(i) + 1;
  const std::size_t end = in.words_left() - std::min(in.words_left(), c.numbering);
  const bool arbitrary = in.integer() < 0;
  in.skip(arbitrary ? 13 : 9);
  if (arbitrary) {
    g.nodal_rigid_bodies = in.integer();
    in.skip(1);
  }
  for (int& id : g.node_ids) id = in.integer();
  for (std::size_t e = 0; e < c.solids; ++e) g.solids[e].id = in.integer();
  for (auto& beam : g.beams) beam.id = in.integer();
  for (auto& shell : g.shells) shell.id = in.integer();
  for (std::size_t e = c.solids; e < g.solids.size(); ++e) g.solids[e].id = in.integer();
  if (in.words_left() < end + 3 * c.parts) return;
  in.skip(c.parts);  // in ascending order
  for (D3plotPart& part : g.parts) part.id = in.integer();
  in.skip(c.parts);
}

/// Bricks and thick shells, which the file has one after the other, by rising id.
void sort_solids(D3plotGeometry& g, std::size_t bricks) {
  std::vector<std::size_t> order(g.solids.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](auto i, auto j) { return g.solids[i].id < g.solids[j].id; });
  std::vector<D3plotElement<8>> sorted;
  for (const std::size_t i : order) {
    sorted.push_back(g.solids[i]);
    g.thick.push_back(i >= bricks);
  }
  g.solids = std::move(sorted);
}

void read_titles(WordReader& in, D3plotGeometry& g) {
  if (in.words_left() < 3 || in.real() != static_cast<double>(d3plot_end_of_states) || in.integer() != 90001) return;
  for (std::size_t count = in.count(); count > 0; --count) {
    const int id = in.integer();
    const std::string title = in.text(72);
    for (D3plotPart& part : g.parts)
      if (part.id == id) part.title = title;
  }
}

void read_stress(WordReader& in, StressRecord& record, int histories) {
  record.stress = in.six();
  record.plastic_strain = in.real();
  for (std::size_t i = 0; i < at(histories); ++i) {
    const double value = in.real();
    if (i < record.history.size()) record.history[i] = value;
  }
}

void read_globals(WordReader& in, const D3plotGeometry& g, D3plotState& s) {
  s.kinetic = in.real(), s.internal = in.real(), s.total = in.real();
  s.velocity = in.vector();
  s.parts.resize(g.parts.size() + at(g.nodal_rigid_bodies));
  for (D3plotPartState& part : s.parts) part.internal = in.real();
  for (D3plotPartState& part : s.parts) part.kinetic = in.real();
  for (D3plotPartState& part : s.parts) part.velocity = in.vector();
  for (D3plotPartState& part : s.parts) part.mass = in.real();
  for (D3plotPartState& part : s.parts) part.hourglass = in.real();
  s.wall_forces.resize(at(g.rigid_walls));
  for (double& force : s.wall_forces) force = in.real();
}

void read_vectors(WordReader& in, std::size_t count, std::vector<Vec3d>& vectors) {
  vectors.resize(count);
  for (Vec3d& v : vectors) v = in.vector();
}

void read_shells(WordReader& in, const D3plotGeometry& g, D3plotState& s) {
  s.shells.resize(g.shells.size());
  s.shell_layers.resize(g.shells.size() * at(g.layers_of_shells()));
  StressRecord* layer = s.shell_layers.data();
  for (ShellRecord& r : s.shells) {
    for (int i = 0; i < g.layers_of_shells(); ++i) read_stress(in, *layer++, g.shell_histories);
    if (g.shell_stresses)
      for (double* value : {&r.mx, &r.my, &r.mxy, &r.qx, &r.qy, &r.nx, &r.ny, &r.nxy}) *value = in.real();
    r.thickness = in.real();
    in.skip(2);
    if (g.shell_stresses && g.strains) {
      r.inner_strain = in.six();
      r.outer_strain = in.six();
    }
    r.internal_energy = in.real();
  }
}

/// Bricks, then thick shells.
void read_solids(WordReader& in, const D3plotGeometry& g, D3plotState& s) {
  s.solids.resize(g.solids.size());
  for (std::size_t e = 0; e < g.solids.size(); ++e) {
    if (g.is_thick(e)) continue;
    read_stress(in, s.solids[e], g.solid_histories);
    if (g.strains) s.solids[e].strain = in.six();
  }
  s.thick_shells.clear();
  s.thick_layers.clear();
  for (std::size_t e = 0; e < g.solids.size(); ++e) {
    if (!g.is_thick(e)) continue;
    const std::size_t first = s.thick_layers.size();
    for (int i = 0; i < g.layers; ++i) read_stress(in, s.thick_layers.emplace_back(), g.shell_histories);
    static_cast<StressRecord&>(s.solids[e]) = s.thick_layers[first];
    ThickShellRecord& r = s.thick_shells.emplace_back();
    if (g.strains) {
      r.inner_strain = in.six();
      r.outer_strain = in.six();
    }
    r.internal_energy = in.real();
    for (std::size_t i = 0; i < 6; ++i) s.solids[e].strain[i] = 0.5 * (r.inner_strain[i] + r.outer_strain[i]);
  }
}

/// `all`: of the bricks alone, then of all solids.
void merge_alive(const D3plotGeometry& g, const std::vector<char>& thick, std::vector<char>& all) {
  const std::vector<char> bricks = all;
  all.clear();
  std::array<std::size_t, 2> next{};
  for (std::size_t e = 0; e < g.solids.size(); ++e) all.push_back(g.is_thick(e) ? thick[next[1]++] : bricks[next[0]++]);
}

void read_beams(WordReader& in, const D3plotGeometry& g, D3plotState& s) {
  s.beams.resize(g.beams.size());
  s.beam_points.clear();
  for (BeamRecord& r : s.beams) {
    for (double* value : {&r.axial, &r.shear_s, &r.shear_t, &r.moment_s, &r.moment_t, &r.torsion}) *value = in.real();
    for (int i = 0; i < g.beam_points; ++i) {
      BeamPointRecord& p = s.beam_points.emplace_back();
      for (double* value : {&p.stress_rs, &p.stress_tr, &p.stress_axial, &p.plastic_strain, &p.axial_strain})
        *value = in.real();
    }
  }
}

void read_alive(WordReader& in, std::size_t count, std::vector<char>& alive) {
  alive.resize(count);
  for (char& flag : alive) flag = in.real() != 0.0;
}

}  // namespace

D3plotReader::D3plotReader(const fs::path& directory, D3plotGeometry::Family family) {
  geometry_.family = family;
  const fs::path file = directory / geometry_.stem();
  if (!fs::is_regular_file(file)) refuse(file, "there is no such file");
  WordReader in(file, read_bytes(file, 0, fs::file_size(file)));
  const Control c = read_control(in, geometry_);
  if (geometry_.family != family) refuse(file, "holds another kind of results than its name says");
  read_vectors(in, c.nodes, geometry_.x);
  read_elements(in, c.solids + c.thick_shells, c, 0, geometry_.solids);
  read_elements(in, c.beams, c, 3, geometry_.beams);
  read_elements(in, c.shells, c, 0, geometry_.shells);
  read_numbering(in, c, geometry_);
  read_titles(in, geometry_);
  if (c.thick_shells > 0) sort_solids(geometry_, c.solids);
  D3plotGeometry& g = geometry_;
  g.beam_points = c.beams == 0 ? 0 : (c.of_beam - 6) / 5;
  const int beyond_layers = c.of_shell - words_of_layers(g) - 12;
  g.strains = c.shells > 0 && g.shell_stresses ? beyond_layers == 12
              : c.thick_shells > 0             ? c.of_thick_shell - words_of_layers(g) >= 12
                                               : g.solid_histories >= 6;
  if (g.strains) g.solid_histories -= 6;  // NEIPH counts the strains
  g.rigid_walls = 0;
  g.rigid_walls = c.globals - global_words(g);
  if (g.rigid_walls < 0 || (c.solids > 0 && c.of_solid != solid_words(g)) ||
      (c.thick_shells > 0 && c.of_thick_shell != thick_shell_words(g)) || (c.beams > 0 && c.of_beam != beam_words(g)) ||
      (c.shells > 0 && c.of_shell != shell_words(g)))
    refuse(file, "words of a state that are not known here");
  velocities_ = c.velocities;
  accelerations_ = c.accelerations;
  state_words_ = state_words(g);
  if (!holds_modes(g)) state_words_ -= 3 * c.nodes * at(2 - velocities_ - accelerations_);
  find_states(directory);
}

void D3plotReader::find_states(const fs::path& directory) {
  const std::size_t size = state_words_ * d3plot_word;
  for (int number = 1;; ++number) {
    const fs::path member = directory / fmt::format("{}{:02}", geometry_.stem(), number);
    if (!fs::is_regular_file(member)) return;
    const std::uint64_t end = fs::file_size(member);
    for (std::uint64_t offset = 0; offset + size <= end; offset += size) {
      const double time = WordReader(member, read_bytes(member, offset, d3plot_word)).real();
      if (time == static_cast<double>(d3plot_end_of_states)) break;
      times_.push_back(time);
      places_.push_back({member, offset});
    }
  }
}

D3plotState D3plotReader::read(std::size_t state) const {
  D3plotState s;
  read(state, s);
  return s;
}

void D3plotReader::read(std::size_t state, D3plotState& s) const {
  const D3plotGeometry& g = geometry_;
  const Place& place = places_.at(state);
  WordReader in(place.member, read_bytes(place.member, place.offset, state_words_ * d3plot_word));
  s.time = in.real();
  read_globals(in, g, s);
  read_vectors(in, g.x.size(), s.x);
  if (velocities_) read_vectors(in, g.x.size(), s.v);
  if (accelerations_) read_vectors(in, g.x.size(), s.a);
  read_solids(in, g, s);
  read_beams(in, g, s);
  read_shells(in, g, s);
  std::vector<char> thick_alive;
  read_alive(in, g.solids.size() - s.thick_shells.size(), s.solid_alive);
  read_alive(in, s.thick_shells.size(), thick_alive);
  if (!thick_alive.empty()) merge_alive(g, thick_alive, s.solid_alive);
  read_alive(in, g.shells.size(), s.shell_alive);
  read_alive(in, g.beams.size(), s.beam_alive);
}

}  // namespace nugget::output
