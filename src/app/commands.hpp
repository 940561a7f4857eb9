// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/exit_code.hpp"
#include "impact/simulation/options.hpp"
#include "report/model_picture.hpp"
#include "weld/placement/placement_deck.hpp"

// The verbs of the `nugget` command. Findings and progress go to standard error, results to files.
namespace nugget::app {

struct RunArguments {
  std::string deck;
  std::string directory = ".";
  int threads = 0;  ///< 0: all cores
  double until = 0.0;
  long max_cycles = 0;
  std::string checkpoint;   ///< when restart files are written, see read_checkpoints(); empty: as the deck says
  double stop_after = 0.0;  ///< seconds of the clock after which the run is interrupted; 0: never
  std::string weld_law;     ///< shared library with the user's own failure function of welds; empty: none
  std::string resume;       ///< folder of a run that is resumed; empty: a new run
  std::string weld_tie;     ///< `area` or `joint`: form of tie of welds, whatever the deck says; empty: as it says
  std::string units;        ///< of the deck, by name (model/units.hpp); empty: recognised
  bool subcycle = false;    ///< --subcycle: as *CONTROL_SUBCYCLE_16_1, unless the deck has that card
  std::string precision;    ///< `single` or `double`; empty: double, of a run that is resumed its own
  std::string drop_weld;    ///< welds that are not there: ids separated by commas; `all` or `each:` ids: one run each
  std::vector<std::string> intrusion;  ///< of those runs: pairs of nodes `A,B`
  int load_case = 0;                   ///< *CASE of the deck; 0: all of them, one after the other
  bool skip_unsupported = false;
  bool over_ranks = false;  ///< an explicit run may be shared out among the ranks of mpirun
  bool vtk = false;         ///< states, modes and welds as .vtu and .pvd, too
  bool quiet = false;
  impact::ProgressCallback progress;  ///< of an explicit run, instead of its display; empty: that, unless quiet
};

struct ModesArguments {
  RunArguments run;  ///< of these: deck, directory, threads, weld_tie, units, load_case, skip_unsupported, quiet
  int count = 0;     ///< 0: the deck's NEIG, or 20
  double low = 0.0, high = 0.0;  ///< frequencies [cycles/time]; 0: the deck's
  bool response = false;         ///< the frequency response that the deck asks for as well
  std::string drop;              ///< welds to be taken out: ids separated by commas, or `all`; empty: none
  double least_welds = 0.0;      ///< share of the first frequency that the least welds are to keep; 0: not asked
  std::string compare;           ///< folder of another run whose modes are compared; empty: none
};

struct CheckArguments {
  RunArguments deck;  ///< of these: deck, directory, threads, weld_tie, units, load_case, skip_unsupported, weld_law
  int ranks = 0;      ///< for so many the elements are shared out; 0: not asked
  double target_step = 0.0;  ///< what each weld would take to allow it; 0: not asked [time]
};

struct ConvertArguments {
  std::string directory;  ///< with the results
  std::string to;         ///< vtk: states, modes and welds as .vtu and .pvd; csv: all histories as one tidy table
  std::string target;     ///< folder for what is written; empty: beside the results
};

struct PlotArguments {
  std::string directory;              ///< with the results
  std::vector<std::string> channels;  ///< see report::matching(); none: they are listed
  std::string picture;                ///< .svg or .png; empty: only a table of extremes
  std::string over;                   ///< channel that takes the place of time; empty: time
  std::string other;                  ///< folder of another run, whose curves are drawn too; empty: none
  int channel_class = 0;              ///< CFC of the filter; 0: none
  int width = 1440;                   ///< pixels of a .png
};

struct PictureArguments {
  std::string directory, picture;  ///< with the results; .svg or .png
  report::PictureOptions options;
};

struct WeldArguments {
  std::string points, deck, output;
  weld::WeldForm form = weld::WeldForm::beam;
  double search_distance = 0.0, diameter = 0.0;  ///< see weld::PlacementOptions
  std::vector<std::string> material;             ///< `[CLASS:]FIELD=VALUE,...` of *MAT_SPOTWELD
  double strength_diameter = 0.0;                ///< see weld::GivenMaterial
  std::vector<std::string> stack;                ///< `T:RM` of each sheet, in mm and MPa: a card and no placement
  std::string units = "mm, t, s";                ///< of that card
  double rule = 5.0;                             ///< diameter over sqrt(t)
  bool adapt = false;       ///< no placement: the sheets around the welds of `deck` are meshed anew
  bool divide = false;      ///< of that: elements far larger than the weld are divided
  double least_step = 0.7;  ///< of that: what must be left of the time step of the shells there
  int threads = 0;
  bool skip_unsupported = false;
};

struct WeldsArguments {
  std::string directory;
  std::string sort = "energy";  ///< or margin, failure
  int lines = 25;               ///< of the table; 0: all
  bool csv = false;
};

struct CouponArguments {
  std::string card, directory;
  std::vector<double> thickness;       ///< of the lower and the upper sheet; empty: the card's, or 1.5 mm
  double diameter = 0.0;               ///< 0: the card's, or 5 sqrt(t)
  std::optional<weld::WeldForm> form;  ///< nothing: a beam
  std::vector<std::string> only;       ///< names of coupons; empty: all
  bool only_decks = false;
  int threads = 0;
};

struct FitArguments {
  std::string curves, card, output;
  std::vector<double> thickness;  ///< as of CouponArguments
  double diameter = 0.0;
  std::optional<weld::WeldForm> form;
  int threads = 0;
};

struct StudyArguments {
  std::string plan, directory;  ///< see read_study_plan()
  int threads = 0;              ///< in all; 0: all cores
  int threads_of_each = 1;
  bool only_decks = false, skip_unsupported = false, quiet = false;
};

struct TidyArguments {
  std::string deck, output;
  int load_case = 0;  ///< *CASE of the deck; cards of other cases stay as they are
};

struct CoverageArguments {
  std::string folder;                  ///< with the decks
  std::string directory = "coverage";  ///< for coverage.json and what each check leaves
  long cycles = 0;                     ///< run each for so many; 0: only checked
  int threads = 0;
};

ExitCode run(const RunArguments& arguments);
/// Seconds of `90s`, `55min`, `2h`; nothing where the text is none of these.
std::optional<double> clock_seconds(const std::string& text);
/// True where the text says when restart files are written.
bool says_checkpoints(const std::string& text);
ExitCode modes(const ModesArguments& arguments);
/// `direct`: no modes, one solution for each frequency.
ExitCode frf(const RunArguments& arguments, bool direct);
ExitCode check(const CheckArguments& arguments);
ExitCode weld(const WeldArguments& arguments);
/// Moves the nodes around the welds of a deck; see weld::adapt().
ExitCode adapt_welds(const WeldArguments& arguments);
/// Names of the systems of units.
const std::vector<std::string>& unit_names();
/// (Re)makes report.html of the results in a folder; with `other`, compare.html of both, in the first.
ExitCode report(const std::string& directory, const std::string& other);
/// Writes the results of a folder in another format.
ExitCode convert(const ConvertArguments& arguments);
/// Names of these formats.
const std::vector<std::string>& conversion_names();
/// Draws channels of a run's histories and responses, and prints their extremes.
ExitCode plot(const PlotArguments& arguments);
/// Follows a run of another process on standard output, until it ends; `once`: only how far it is.
ExitCode watch(const std::string& directory, bool once);
/// Draws the model of a run.
ExitCode picture(const PictureArguments& arguments);
/// Ranks the welds of a finished run on standard output.
ExitCode welds(const WeldsArguments& arguments);
/// Makes and runs the coupons of a weld's card.
ExitCode coupon(const CouponArguments& arguments);
/// Their names.
const std::vector<std::string>& coupon_names();
/// Finds the strengths of a weld's card from measured curves.
ExitCode fit(const FitArguments& arguments);
/// Runs a deck once for each line of a table of its parameters, and gathers results of the runs in one table.
ExitCode study(const StudyArguments& arguments);
/// Checks or runs the decks of a folder: which are accepted, and what refuses the others.
ExitCode coverage(const CoverageArguments& arguments);
/// Writes a deck as it was understood.
ExitCode tidy(const TidyArguments& arguments);
ExitCode keywords(const std::string& name);
/// Runs the main example, found beside the program or where it is installed, and says where its results are.
ExitCode demo(const std::string& directory);

}  // namespace nugget::app
