// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/vec3.hpp"
#include "output/result_file.hpp"

namespace nugget::output {

/// An element of `N` nodes in the d3plot.
template <std::size_t N>
struct D3plotElement {
  int id = 0;                  ///< user id
  std::array<int, N> nodes{};  ///< positions in D3plotGeometry::node_ids, from 0
  int part = 0;                ///< position in D3plotGeometry::parts, from 0
};

struct D3plotPart {
  int id = 0;  ///< user id
  std::string title;
};

/// What does not change during a run. Node and element ids ascend (LS-DYNA's readers rely on it).
struct D3plotGeometry {
  std::string title;
  std::int32_t seconds_since_1970 = 0;  ///< of the run; the same value gives the same bytes
  std::vector<int> node_ids;
  std::vector<Vec3d> x;                  ///< initial coordinates [length]
  std::vector<D3plotElement<8>> solids;  ///< wedge 1 2 3 4 5 5 6 6, tetrahedron 1 2 3 4 4 4 4 4
  std::vector<char> thick;  ///< by solid: 1 is a thick shell, which the file has in a block of its own; empty: none is
  std::vector<D3plotElement<2>> beams;
  std::vector<D3plotElement<4>> shells;  ///< a triangle repeats its third node
  std::vector<D3plotPart> parts;         ///< in deck order
  /// NUMRBS: nodal rigid bodies, which follow the parts in D3plotState::parts. LSTC's document and VTK count them, but
  /// lasso-python reads the parts' energies and masses from the wrong words unless it is 0.
  int nodal_rigid_bodies = 0;
  int rigid_walls = 0;
  int layers = 3;                 ///< MAXINT: records through the thickness of a shell, see shell_layers()
  bool shell_stresses = true;     ///< IOSHL(1) to (3); false: of shells there are thickness and energy only
  int beam_points = 0;            ///< BEAMIP: integration points of beams
  bool strains = false;           ///< STRFLG
  int solid_histories = 0;        ///< NEIPH: numbers of StressRecord::history, and zeros beyond them
  int shell_histories = 0;        ///< NEIPS: the same, of each layer
  bool one_state_a_file = false;  ///< IEVERP
  /// What the files hold, and are called. The time of a state of d3eigv and d3ssd is a frequency; modes have
  /// coordinates only (no velocities, accelerations).
  enum class Family { d3plot, d3eigv, d3ssd } family = Family::d3plot;
  std::string suffix;  ///< of their names, before the number
  std::string stem() const;
  /// Records through the thickness of a shell in a state.
  int layers_of_shells() const { return shell_stresses ? layers : 0; }
  bool is_thick(std::size_t solid) const { return !thick.empty() && thick[solid] != 0; }
};

/// Energies [force length], mass and velocity of one part.
struct D3plotPartState {
  double internal = 0.0, kinetic = 0.0, hourglass = 0.0, mass = 0.0;
  Vec3d velocity;  ///< of the centre of mass
};

/// Stress xx yy zz xy yz zx in global axes [force/length^2] and effective plastic strain.
struct StressRecord {
  std::array<double, 6> stress{};
  double plastic_strain = 0.0;
  std::array<double, 3> history{};  ///< as far as NEIPH or NEIPS ask for it
};

struct SolidRecord : StressRecord {
  std::array<double, 6> strain{};  ///< xx yy zz xy yz zx, global; written where D3plotGeometry::strains is set
};

/// Strains of a thick shell at its lowest and uppermost layer, as SolidRecord::strain, and in the last word, as of
/// shells, the internal energy per volume [force/length^2].
struct ThickShellRecord {
  std::array<double, 6> inner_strain{}, outer_strain{};
  double internal_energy = 0.0;
};

/// Resultants in the shell's local axes, per unit length.
struct ShellRecord {
  double mx = 0.0, my = 0.0, mxy = 0.0;                  ///< bending moments [force]
  double qx = 0.0, qy = 0.0;                             ///< transverse shear [force/length]
  double nx = 0.0, ny = 0.0, nxy = 0.0;                  ///< membrane forces [force/length]
  double thickness = 0.0;                                ///< now [length]
  double internal_energy = 0.0;                          ///< per volume [force/length^2]
  std::array<double, 6> inner_strain{}, outer_strain{};  ///< bottom and top, global; as SolidRecord::strain
};

struct BeamRecord {
  double axial = 0.0, shear_s = 0.0, shear_t = 0.0;      ///< [force]
  double moment_s = 0.0, moment_t = 0.0, torsion = 0.0;  ///< [force length]
};

/// One integration point of a beam.
struct BeamPointRecord {
  double stress_rs = 0.0, stress_tr = 0.0, stress_axial = 0.0;  ///< [force/length^2]
  double plastic_strain = 0.0, axial_strain = 0.0;
};

/// Time, and sums over the model: energies [force length], velocity, forces [force].
struct D3plotTotals {
  double time = 0.0;
  double kinetic = 0.0, internal = 0.0, total = 0.0;
  Vec3d velocity;                      ///< of the model's centre of mass
  std::vector<D3plotPartState> parts;  ///< in deck order, then the nodal rigid bodies
  std::vector<double> wall_forces;
};

/// The model at one time. The caller keeps it and fills it anew for each state; the sizes follow from the geometry.
struct D3plotState : D3plotTotals {
  std::vector<Vec3d> x, v, a;                  ///< current coordinates, velocities, accelerations
  std::vector<SolidRecord> solids;             ///< of thick shells the record of the first of their layers
  std::vector<ThickShellRecord> thick_shells;  ///< of the first thick shell among the solids, of the second, ...
  std::vector<StressRecord> thick_layers;      ///< the same, of each in the order of shell_layers()
  std::vector<BeamRecord> beams;
  std::vector<BeamPointRecord> beam_points;  ///< of the first beam, of the second, ...
  std::vector<StressRecord> shell_layers;    ///< of the first shell in the order of shell_layers(), of the second, ...
  std::vector<ShellRecord> shells;
  std::vector<char> solid_alive, beam_alive, shell_alive;  ///< 0: deleted; empty: all alive
};

/// The records of one shell from its integration points, which run from the bottom to the top; `layers` has room for
/// MAXINT. Three: middle, bottom, top, the middle of an even number of points being the mean of the two central ones.
/// Another number: the first MAXINT points in their order, and zeros beyond the last (manual vol. I,
/// *DATABASE_EXTENT_BINARY, MAXINT).
void shell_layers(std::span<const StressRecord> points, std::span<StressRecord> layers);

/// How a state stands in the file: its time and sums, then stretches of so many words of each node, or of each element
/// of a kind. It can be sent to other ranks.
class D3plotLayout {
 public:
  enum Stretch {
    coordinates,
    velocities,
    accelerations,
    solids,
    thick_shells,
    beams,
    shells,
    solid_deletion,
    thick_deletion,
    shell_deletion,
    beam_deletion,
    stretches
  };

  explicit D3plotLayout(const D3plotGeometry& geometry);
  std::size_t count(Stretch s) const { return count_[s]; }  ///< of nodes or elements
  std::size_t words(Stretch s) const { return words_[s]; }  ///< of each; 0: not there
  std::size_t begin(Stretch s) const { return begin_[s]; }  ///< of the stretch, in words
  std::size_t all_words() const { return all_; }
  std::size_t layers() const { return layers_; }  ///< of shells and thick shells
  std::size_t beam_points() const { return beam_points_; }

  // The words of one node or element, or of time and sums, at `to`.
  static void put(char* to, const Vec3d& vector);
  void put(char* to, const SolidRecord& record) const;
  void put(char* to, const ThickShellRecord& record, std::span<const StressRecord> layers) const;
  void put(char* to, const BeamRecord& record, std::span<const BeamPointRecord> points) const;
  void put(char* to, const ShellRecord& record, std::span<const StressRecord> layers) const;
  static void put_deletion(char* to, int part, bool alive);
  /// Throws std::logic_error where there are not as many parts and walls as in the geometry.
  void put(char* to, const D3plotTotals& totals) const;

 private:
  std::array<std::size_t, stretches> count_{}, words_{}, begin_{};
  std::size_t all_ = 0, layers_ = 0, beam_points_ = 0, parts_ = 0, walls_ = 0;
  int solid_histories_ = 0, shell_histories_ = 0;
  bool strains_ = false, shell_stresses_ = true;
};

/// The d3plot family: `d3plot` with the geometry, then states in `d3plot01`, `d3plot02`, ... Single precision and the
/// subset that VTK, lasso-python and dynareadout all read. Each state reaches the disk whole, with the mark -999999.0
/// behind it, so a killed run leaves readable files. Source: LS-DYNA Database Binary Output Files (LSTC, 2020).
class D3plot {
 public:
  /// Writes `directory/d3plot`, or continues the file that is there. Throws WriteError, and std::logic_error where ids
  /// do not ascend or an index leads nowhere.
  D3plot(std::filesystem::path directory, D3plotGeometry geometry, OpenMode mode = OpenMode::create);

  /// Throws WriteError, and std::logic_error where an array does not fit the geometry.
  void write(const D3plotState& state);
  /// A state whose words come piece by piece, as `layout` has them: all of them between the two. Throw WriteError.
  const D3plotLayout& layout() const { return layout_; }
  void begin_state();
  void put_piece(std::string_view bytes);
  void end_state();
  /// From now on states come by pieces: what was asked for by the file's head alone is set free.
  void forget_mesh();
  /// Reading, states of later are taken away.
  void archive(Archive& a);

 private:
  std::filesystem::path member_path(int number) const;

  std::filesystem::path directory_;
  D3plotGeometry geometry_;
  D3plotLayout layout_;
  std::optional<ResultFile> member_;  ///< the file that takes states now
  int members_ = 0;
  std::uint64_t end_mark_ = 0;  ///< its place in member_
  std::uint64_t next_ = 0;      ///< where the next piece of a state goes
  std::string first_word_;      ///< of that state
};

}  // namespace nugget::output
