// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/finding.hpp"
#include "base/vec3.hpp"

namespace nugget::output {

/// Where one node of a weld was tied to a sheet.
struct WeldProjection {
  int node = 0;                ///< user id
  std::vector<int> segment;    ///< user ids of the segment's nodes; empty: not tied
  double xi = 0.0, eta = 0.0;  ///< place on the segment, -1 to 1
  double moved = 0.0;          ///< how far the node was moved onto the sheet [length]
  int case_number = 0;         ///< which of the eight projection cases
  std::string reason;          ///< why not tied, or why the case is not plain
};

/// Largest magnitudes over the run.
struct WeldPeak {
  double axial = 0.0, shear = 0.0;      ///< [force]
  double bending = 0.0, torsion = 0.0;  ///< [force length]
  double force = 0.0;                   ///< resultant of axial and shear force [force]
};

/// How a weld was loaded in the cycle in which it failed; of one that holds, at the end of the run.
struct WeldLoad {
  double axial = 0.0, shear = 0.0;      ///< [force]
  double bending = 0.0, torsion = 0.0;  ///< [force length]
  double strain_rate = 0.0;             ///< effective [1/time]
  double failure = 0.0;                 ///< value of the failure function; 1 is failure
  std::string terms;                    ///< what it is made of, e.g. `axial force 0.81, shear force 0.19`
  /// Bending moment at the first and the second sheet; `bending` is that at mid-length [force length].
  std::array<double, 2> bending_at{std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
  /// Resultant of axial and shear force; of what has no shear force that is known, none [force].
  double force() const { return std::hypot(axial, shear); }
};

/// One weld: the audit before the run, the history after it. A line of welds.csv, an entry of `weld` in summary.json.
struct WeldReport {
  int id = 0;               ///< user id of the element, assembly or constraint
  std::string kind;         ///< beam, solid, assembly, rigid
  int part = 0;             ///< of the weld itself
  std::vector<int> sheets;  ///< parts that it joins
  Vec3d middle;             ///< between its end faces, after the projection onto the sheets
  double diameter = 0.0, length = 0.0;
  bool tied = false;
  std::vector<WeldProjection> projections;
  double added_mass = 0.0;
  bool failed = false;
  std::optional<double> failure_time;
  std::string failure_mode;
  WeldPeak peak;
  double peak_failure = 0.0, peak_failure_time = 0.0;  ///< largest failure value and when it was
  WeldLoad last;
  /// 0 undamaged to 1 failed; of damage that goes point by point the mean. NaN: its law has no damage, or none that is
  /// known.
  double damage = std::numeric_limits<double>::quiet_NaN();
  double energy = 0.0;  ///< work that was done on it; of a failed weld all of it is dissipated [energy]
  /// Energy that passed from its first sheet to its second, in the end and where its magnitude was largest; NaN: not
  /// known [energy].
  double passed = std::numeric_limits<double>::quiet_NaN(), most_passed = std::numeric_limits<double>::quiet_NaN();
  double course_interval = 0.0;                            ///< of `failure_course` [time]
  std::vector<double> failure_course;                      ///< largest failure value in each interval from the start on
  std::vector<std::pair<std::string_view, double>> audit;  ///< column of welds.csv and number; the same for all welds
  std::vector<std::string> remarks;                        ///< of the audit
};

/// One line of the modes of a modal run.
struct ModeReport {
  int mode = 0;
  double frequency_hz = 0.0;
  std::array<double, 6> participation{}, effective_mass{};
};

/// One response over frequency: where it is largest.
struct ResponseReport {
  std::string kind;  ///< frf, ssd
  int node = 0;
  std::string direction, response;                       ///< e.g. `x`, `acceleration`
  double frequency = 0.0, amplitude = 0.0, phase = 0.0;  ///< phase in degrees
  int load_case = 0;                                     ///< of several, counted from 1; else 0
};

/// What becomes of the mode that suffers most when welds are taken out (`nugget modes --drop-weld`).
struct WeldDropReport {
  std::vector<int> welds;  ///< user ids
  int mode = 0;
  double frequency = 0.0, first_order = 0.0, without = 0.0;  ///< with them; without them by perturbation, by estimate
  std::optional<double> solved;                              ///< without them, solved anew
};

/// What summary.json says of a run; keys as docs/reference/contract.md has them. Quantities in the deck's units,
/// seconds of the clock.
struct Summary {
  std::string version, deck;
  std::string title, date;             ///< of the deck; of the run
  int load_case = 0;                   ///< *CASE of the deck; 0: none
  std::vector<std::string> files;      ///< of the deck, by their whole paths
  std::string units;                   ///< as recognised: `mm, t, s`; empty where they are not
  std::string termination = "normal";  ///< normal, error, interrupted
  std::string message;
  struct Counts {
    long nodes = 0, shells = 0, solids = 0, beams = 0, discretes = 0, parts = 0, welds = 0;
  } count;
  long cycles = 0;
  double time = 0.0;
  struct TimeStep {
    double first = 0.0, smallest = 0.0;
    std::string controlling;  ///< e.g. `beam 17 of part 5`
  } time_step;
  struct Relaxation {
    long cycles = 0;
    double time = 0.0, kinetic_energy_ratio = 0.0;  ///< kinetic energy over the largest, at the last check
    bool at_rest = false;
  };
  std::optional<Relaxation> relaxation;  ///< the dynamic relaxation before the run
  struct Mass {
    double physical = 0.0, added = 0.0, added_to_welds = 0.0;
  } mass;
  struct Energies {
    double kinetic = 0.0, internal = 0.0, hourglass = 0.0, contact = 0.0, damping = 0.0, external = 0.0, eroded = 0.0,
           step_change = 0.0, initial = 0.0, ratio = 1.0, ratio_without_step_change = 1.0;
    double bulk_viscosity = 0.0;  ///< of `internal` and `eroded` what went against it
    double contact_springs = 0.0, contact_friction = 0.0, contact_damping = 0.0, contact_lost = 0.0;  ///< of `contact`
  } energy;
  struct Seconds {
    double read = 0.0, setup = 0.0, solve = 0.0, output = 0.0;
    std::vector<std::pair<std::string, double>> phases;  ///< of the time loop, in its order
  } seconds;
  struct Hourglass {
    int part = 0;          ///< with the most of the hourglass energy
    double energy = 0.0;   ///< of that part
    std::string elements;  ///< `shells of ELFORM 2`
    std::string remedy;    ///< what keeps such elements from it
  };
  std::optional<Hourglass> hourglass;  ///< nothing where there is none of that energy
  double ns_per_element_cycle = 0.0;
  double peak_memory = 0.0;  ///< of this process [MB]
  int threads = 0, ranks = 1;
  /// A rank of an explicit run over several.
  struct Rank {
    long elements = 0;  ///< that it computed
    long states = 0;    ///< elements whose states it held at the end
    long segments = 0;  ///< of contact surfaces, that it held at the end
    long nodes = 0, shared_nodes = 0, neighbours = 0;
    double expected_load = 0.0;          ///< of elements, over the mean of all
    double expected_contact_load = 0.0;  ///< of contact, likewise; 0 where there is none
    double messages = 0.0, bytes = 0.0;  ///< sent, a cycle
    double busy = 0.0, waiting = 0.0;    ///< seconds
    double peak_memory = 0.0;            ///< MB
  };
  std::vector<Rank> rank;
  int lanes = 1;                     ///< elements of double precision that the kernels took at a time
  std::string precision = "double";  ///< that was asked for
  struct ElementsByPrecision {
    long single = 0, of_double = 0;
  } elements_by_precision;
  /// In sub-cycling: how many elements of each kind had their forces every so many cycles, at the end.
  struct Period {
    int cycles = 1;
    std::map<std::string, std::size_t> elements;  ///< by kind: shell, solid, beam, spring
  };
  std::vector<Period> periods;
  std::vector<WeldReport> welds;
  std::vector<ModeReport> modes;
  std::vector<ResponseReport> responses;
  std::vector<WeldDropReport> weld_drops;  ///< those that matter most first
};

/// Shares beyond which a run is doubted, on the terminal and in the report.
struct EnergyLimits {
  static constexpr double hourglass = 0.1;          ///< hourglass energy over internal energy
  static constexpr double error_of_internal = 0.1;  ///< energy made or lost over internal energy
  static constexpr double lost_in_contact = 0.01;   ///< held by springs dropped under load, over internal energy
  static constexpr double given_by_contact = 0.01;  ///< by contact beyond what it got, over internal energy
};

/// Each writes one file into `directory`, all at once. NaN and infinity become null in JSON and an empty cell in CSV;
/// bytes that are not UTF-8 (old decks) are replaced. Throws WriteError.
void write_summary(const std::filesystem::path& directory, const Summary& summary);                 ///< summary.json
void write_findings(const std::filesystem::path& directory, const std::vector<Finding>& findings);  ///< findings.json
void write_welds(const std::filesystem::path& directory, const std::vector<WeldReport>& welds);     ///< welds.csv

/// The text of welds.csv.
std::string weld_table(const std::vector<WeldReport>& welds);

}  // namespace nugget::output
