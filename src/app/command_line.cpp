// SPDX-License-Identifier: Apache-2.0
#include "app/command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/command.hpp"
#include "app/command_text.hpp"
#include "app/commands.hpp"
#include "app/weld_drop_runs.hpp"
#include "app/wrong_words.hpp"
#include "base/sae_filter.hpp"
#include "base/vec3.hpp"
#include "report/picture_file.hpp"

namespace {

using nugget::app::ExitCode;

/// LS-DYNA's spelling: `i=MODEL.k ncpu=2 jobid=...` becomes `MODEL.k -j 2`. What has no meaning here (memory=) is left
/// out, with a word.
std::vector<std::string> translated(int argc, char** argv) {
  std::vector<std::string> out;
  for (int a = 1; a < argc; ++a) {
    const std::string word = argv[a];
    const auto value = [&](const char* key) -> const char* {
      const std::size_t n = std::char_traits<char>::length(key);
      return word.compare(0, n, key) == 0 ? word.c_str() + n : nullptr;
    };
    if (const char* v = value("i=")) {
      out.emplace_back(v);
    } else if (const char* n = value("ncpu=")) {
      // A negative count asks for repeatable sums, which is always the case here.
      out.emplace_back("-j");
      out.emplace_back(*n == '-' ? n + 1 : n);
    } else if (const char* load_case = value("case=")) {
      out.emplace_back("--case");
      out.emplace_back(load_case);
    } else if (word == "-fmin" || word == "-fmax") {
      out.push_back('-' + word);
    } else if (value("memory=") || value("memory2=")) {
      fmt::print(stderr, "{}: not needed, memory is taken as the model asks for it\n", word);
    } else {
      out.push_back(word);
    }
  }
  return out;
}

/// Refuses what is not a number above zero, in words (CLI11's own check prints the largest double there is).
CLI::Validator number_above_zero(const char* expected, bool whole) {
  return CLI::Validator(
      [=](const std::string& text) {
        char* end = nullptr;
        const double value = std::strtod(text.c_str(), &end);
        const bool good = end != text.c_str() && *end == '\0' && value > 0.0 && std::isfinite(value);
        return good && (!whole || value == std::trunc(value)) ? std::string()
                                                              : fmt::format("'{}', expected {}", text, expected);
      },
      "");
}

CLI::Validator checkpoints() {
  return CLI::Validator(
      [](const std::string& text) {
        return nugget::app::says_checkpoints(text)
                   ? std::string()
                   : fmt::format("'{}', expected e.g. 500cycles, 10min or a model time above 0", text);
      },
      "");
}

/// --weld-tie of the commands that tie welds.
CLI::Option* add_weld_tie(CLI::App* command, std::string& form) {
  const auto known = [](const std::string& text) {
    return text == "area" || text == "joint" ? std::string() : fmt::format("'{}', expected area or joint", text);
  };
  return command
      ->add_option(
          "--weld-tie", form,
          "area: welds are tied to their sheets by the nugget's disc, wherever in the mesh; joint: so, and a joint "
          "carries what a coarse mesh lacks")
      ->check(CLI::Validator(known, "{area,joint}"));  // help and completion show them
}

/// --as of the commands that model welds.
template <class Form>
void add_weld_form(CLI::App* command, Form& form, std::span<const nugget::weld::NamedWeldForm> forms,
                   std::string_view what) {
  std::vector<std::string> names;
  for (const nugget::weld::NamedWeldForm& f : forms) names.emplace_back(f.name);
  command
      ->add_option_function<std::string>(
          "--as", [&form](const std::string& name) { form = *nugget::weld::weld_form(name); },
          fmt::format("{}: {}", nugget::weld::list_names(forms, " or "), what))
      ->check(CLI::IsMember(names));
}

void add_units(CLI::App* command, std::string& units) {
  command
      ->add_option("--units", units,
                   "of the deck: length, mass, time (default: recognised by density and Young's modulus of its sheets)")
      ->check(CLI::IsMember(nugget::app::unit_names()));
}

CLI::Option* add_case(CLI::App* command, int& load_case, const char* without) {
  return command->add_option("--case", load_case, fmt::format("the *CASE of the deck ({})", without))
      ->check(number_above_zero("the number of a *CASE", true));
}

CLI::Validator picture_name() {
  return CLI::Validator(
      [](const std::string& text) {
        return nugget::report::is_picture_name(text)
                   ? std::string()
                   : fmt::format("'{}', expected a name ending in .svg or .png", text);
      },
      "");
}

/// The direction that `-x` or `X,Y,Z` says; nothing where it says none.
std::optional<nugget::Vec3d> direction_of(const std::string& text) {
  constexpr std::string_view axes = "xyz";
  std::array<double, 3> d{};
  const std::size_t sign = text.starts_with('-') || text.starts_with('+') ? 1 : 0;
  if (text.size() == sign + 1 && axes.find(text[sign]) != axes.npos) {
    d[axes.find(text[sign])] = text.starts_with('-') ? -1.0 : 1.0;
  } else {
    int length = 0;
    if (std::sscanf(text.c_str(), "%lf,%lf,%lf%n", &d[0], &d[1], &d[2], &length) != 3 ||
        static_cast<std::size_t>(length) != text.size())
      return std::nullopt;
  }
  const nugget::Vec3d direction{d[0], d[1], d[2]};
  const double length = norm(direction);
  if (!(length > 0.0) || !std::isfinite(length)) return std::nullopt;
  return direction;
}

CLI::Validator direction(bool iso) {
  return CLI::Validator(
      [=](const std::string& text) {
        return (iso && text == "iso") || direction_of(text)
                   ? std::string()
                   : fmt::format("'{}', expected an axis (x, -x, y, ...) or three numbers X,Y,Z", text);
      },
      "");
}

int obey(int argc, char** argv) {
  CLI::App cli{
      "Nugget: spot-welded structures from one LS-DYNA keyword deck, impact by explicit dynamics, natural modes and "
      "frequency response.",
      "nugget"};
  cli.set_version_flag("--version", fmt::format("nugget {}", NUGGET_VERSION));
  cli.require_subcommand(1);

  const CLI::Validator count = number_above_zero("a whole number of 1 or more", true),
                       time = number_above_zero("a time above 0", false);
  nugget::app::RunArguments run;
  CLI::App* run_command = cli.add_subcommand("run", "read, check, tie and run a deck");
  run_command->add_option("model", run.deck, "the deck; also i=MODEL.k");
  CLI::Option* run_output =
      run_command->add_option("-o,--output", run.directory, "folder for the results (default: the current one)");
  run_command->add_option("-j,--threads", run.threads, "threads (default: all cores); also ncpu=N")->check(count);
  run_command->add_option("--until", run.until, "end time instead of the deck's")->check(time);
  run_command->add_option("--max-cycles", run.max_cycles, "stop after so many cycles")->check(count);
  CLI::Option* run_skip = run_command->add_flag("--skip-unsupported", run.skip_unsupported,
                                                "leave out what is not supported, with a warning each");
  const char* weld_law = "shared library with your own failure function of welds: OPT 2, 12, 22";
  run_command->add_option("--weld-law", run.weld_law, weld_law);
  CLI::Option* run_weld_tie = add_weld_tie(run_command, run.weld_tie);
  add_units(run_command, run.units);
  const auto known_precision = [](const std::string& text) {
    return text == "single" || text == "double" ? std::string() : fmt::format("'{}', expected single or double", text);
  };
  run_command
      ->add_option("--precision", run.precision,
                   "of the stresses, histories and forces of elements: double (default), or single, which is faster; "
                   "places, velocities, times, sums and contacts are of double precision in both")
      ->check(CLI::Validator(known_precision, "{single,double}"));
  run_command->add_flag("--subcycle", run.subcycle,
                        "elements with a long stable step have their forces every 2, 4, 8 or 16 cycles only, as with "
                        "*CONTROL_SUBCYCLE");
  CLI::Option* run_drop = run_command->add_option(
      "--drop-weld", run.drop_weld,
      "run without welds: ids separated by commas (together); all, or each:ID,ID (one run without each, ranked)");
  run_command
      ->add_option("--intrusion", run.intrusion,
                   "A,B: how far these two nodes come together or apart in each of those runs (both in nodout)")
      ->allow_extra_args(false)
      ->needs(run_drop)
      ->check(CLI::Validator([](const std::string& text) { return nugget::app::wrong_intrusion(text); }, ""));
  CLI::Option* run_case = add_case(run_command, run.load_case, "without: each, one after the other");
  run_command->add_flag("--vtk", run.vtk, "states, modes and welds as .vtu and .pvd for ParaView, too");
  run_command->add_flag("--quiet", run.quiet, "no progress on the terminal");
  run_command
      ->add_option("--checkpoint", run.checkpoint,
                   "a restart file every so often: 500cycles, 10min (of the clock), or a model time such as 1e-3; one "
                   "is written anyway when the run is interrupted")
      ->check(checkpoints());
  std::string stop_after;
  run_command
      ->add_option("--stop-after", stop_after,
                   "stop so long before a batch system would: 55min, 90s or 2h of the clock; a restart file is written")
      ->check(CLI::Validator(
          [](const std::string& text) {
            return nugget::app::clock_seconds(text)
                       ? std::string()
                       : fmt::format("'{}', expected a time of the clock such as 55min, 90s or 2h", text);
          },
          ""));
  run_command
      ->add_option("--resume", run.resume,
                   "go on in this folder from its newest restart file; the deck must be as it was, and is named only "
                   "if it stands elsewhere now")
      ->excludes(run_output)
      ->excludes(run_skip)
      ->excludes(run_weld_tie)
      ->excludes(run_case)
      ->excludes(run_drop);

  const CLI::Validator frequency = number_above_zero("a frequency above 0", false);
  nugget::app::ModesArguments modes;
  CLI::App* modes_command = cli.add_subcommand("modes", "natural modes of a deck");
  modes_command->add_option("model", modes.run.deck, "the deck; also i=MODEL.k")->required();
  modes_command->add_option("-o,--output", modes.run.directory, "folder for the results (default: the current one)");
  modes_command->add_option("-n,--number", modes.count, "number of modes (default: the deck's NEIG, or 20)")
      ->check(count);
  modes_command->add_option("--fmin", modes.low, "no modes below this frequency [cycles/time]; also -fmin")
      ->check(frequency);
  modes_command->add_option("--fmax", modes.high, "no modes above this frequency [cycles/time]; also -fmax")
      ->check(frequency);
  modes_command->add_option("--drop-weld", modes.drop,
                            "what the modes are without a weld: its id, ids separated by commas (together), or all "
                            "(each on its own, ranked)");
  modes_command
      ->add_option("--least-welds", modes.least_welds,
                   "which welds can go while the first elastic frequency keeps this share, e.g. 0.95")
      ->check(CLI::Validator(
          [](const std::string& text) {
            const double share = std::atof(text.c_str());
            return share > 0.0 && share < 1.0 ? std::string() : fmt::format("'{}', expected between 0 and 1", text);
          },
          ""));
  modes_command->add_option("--compare", modes.compare, "folder of another run: which modes are the same (MAC)");
  modes_command->add_option("-j,--threads", modes.run.threads, "threads (default: all cores); also ncpu=N")
      ->check(count);
  modes_command->add_flag("--skip-unsupported", modes.run.skip_unsupported,
                          "leave out what is not supported, with a warning each");
  add_weld_tie(modes_command, modes.run.weld_tie);
  add_units(modes_command, modes.run.units);
  add_case(modes_command, modes.run.load_case, "needed where it has several");
  modes_command->add_flag("--quiet", modes.run.quiet, "no progress on the terminal");

  nugget::app::RunArguments frf;
  CLI::App* frf_command = cli.add_subcommand("frf", "frequency response of a deck with *FREQUENCY_DOMAIN_FRF or _SSD");
  bool direct = false;
  frf_command->add_option("model", frf.deck, "the deck; also i=MODEL.k")->required();
  frf_command->add_option("-o,--output", frf.directory, "folder for the results (default: the current one)");
  frf_command->add_flag("--direct", direct, "no modes: solve the equations of motion at each frequency");
  frf_command->add_option("-j,--threads", frf.threads, "threads (default: all cores); also ncpu=N")->check(count);
  frf_command->add_flag("--skip-unsupported", frf.skip_unsupported,
                        "leave out what is not supported, with a warning each");
  add_weld_tie(frf_command, frf.weld_tie);
  add_units(frf_command, frf.units);
  add_case(frf_command, frf.load_case, "needed where it has several");
  frf_command->add_flag("--quiet", frf.quiet, "no progress on the terminal");

  nugget::app::CheckArguments check;
  CLI::App* check_command = cli.add_subcommand("check", "read, check, tie and audit a deck; run nothing");
  check_command->add_option("model", check.deck.deck, "the deck")->required();
  check_command->add_option("-o,--output", check.deck.directory, "folder for welds.csv, findings.json and check.log");
  check_command->add_option("--target-step", check.target_step, "mass or stiffness that each weld takes for this step")
      ->check(time);
  check_command
      ->add_option(
          "-n,--ranks", check.ranks,
          "how an explicit run over so many ranks (mpirun -n) would share out the elements; partition.vtu shows it")
      ->check(count);
  check_command->add_option("-j,--threads", check.deck.threads, "threads (default: all cores)")->check(count);
  check_command->add_option("--weld-law", check.deck.weld_law, weld_law);
  add_weld_tie(check_command, check.deck.weld_tie);
  add_units(check_command, check.deck.units);
  add_case(check_command, check.deck.load_case, "without: each, one after the other");
  check_command->add_flag("--skip-unsupported", check.deck.skip_unsupported, "unsupported keywords are warnings");

  nugget::app::WeldArguments weld;
  CLI::App* weld_command = cli.add_subcommand("weld", "place welds from a list of points");
  weld_command->add_option("points", weld.points, "table of x, y, z, diameter, parts, class, or xMCF");
  weld_command->add_option("model", weld.deck, "the deck with the sheets");
  weld_command->add_option("-o,--output", weld.output, "the deck to be written: it includes the model")->required();
  add_weld_form(weld_command, weld.form, nugget::weld::weld_forms(),
                "one beam or so many bricks a weld, or *CONSTRAINED_INTERPOLATION_SPOTWELD");
  const CLI::Validator length = number_above_zero("a length above 0", false);
  weld_command->add_option("--diameter", weld.diameter, "where the list gives none (default: 5 sqrt(t))")
      ->check(length);
  weld_command->add_option("--reach", weld.search_distance, "how far a sheet may be from a point (default: 3 t)")
      ->check(length);
  weld_command->add_option("--material", weld.material,
                           "[CLASS:]FIELD=VALUE,... of *MAT_SPOTWELD, e.g. nrr=8000,nrs=6000 (with --as interpolation "
                           "upf, upr, too); strengths hold for every "
                           "weld as given, whatever its diameter, unless --scale-strength is given");
  CLI::Option* scale_strength = weld_command
                                    ->add_option("--scale-strength", weld.strength_diameter,
                                                 "diameter D of the weld that the strengths of --material are of: a "
                                                 "weld of diameter d has nrr, nrs, nrt by (d/D)^2, mrr, mss, mtt by "
                                                 "(d/D)^3")
                                    ->check(length);
  weld_command->add_option("-j,--threads", weld.threads, "threads (default: all cores)")->check(count);
  weld_command
      ->add_option("--stack", weld.stack,
                   "no placement, but the card of a weld through these sheets: T:RM,T:RM,... thickness in mm, tensile "
                   "strength in MPa")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->excludes(scale_strength);
  weld_command->add_option("--rule", weld.rule, "of --stack: diameter over sqrt(t), 4 or 5 (default)")
      ->check(CLI::IsMember({4, 5}));
  weld_command->add_option("--units", weld.units, "of the card of --stack (default: \"mm, t, s\")")
      ->check(CLI::IsMember(nugget::app::unit_names()));
  weld_command
      ->add_flag("--adapt", weld.adapt,
                 "no placement, but MODEL.k with the sheets around its welds meshed so that each weld stands "
                 "over the centre of an element of its size")
      ->excludes(scale_strength);
  weld_command->add_flag("--divide", weld.divide,
                         "of --adapt: elements of more than 1.4 diameters are divided into five around the weld");
  weld_command
      ->add_option("--least-step", weld.least_step,
                   "of --adapt: share of the time step of the shells around a weld that must be left (default: 0.7)")
      ->check(CLI::Range(0.1, 1.0));
  weld_command->add_flag("--skip-unsupported", weld.skip_unsupported, "unsupported keywords are left out");

  nugget::app::WeldsArguments welds;
  CLI::App* welds_command = cli.add_subcommand("welds", "rank the welds of a finished run");
  welds_command->add_option("directory", welds.directory, "folder with summary.json and welds.csv")->required();
  welds_command
      ->add_option("--sort", welds.sort,
                   "energy (through the weld; of natural modes its share; default), margin (1 less the largest failure "
                   "value) or failure (time)")
      ->check(CLI::IsMember({"energy", "margin", "failure"}));
  welds_command->add_option("-n,--number", welds.lines, "lines of the table (default: 25; 0: all)")
      ->check(CLI::NonNegativeNumber);
  welds_command->add_flag("--csv", welds.csv, "all welds as comma-separated values");

  nugget::app::CouponArguments coupon;
  CLI::App* coupon_command =
      cli.add_subcommand("coupon", "lap shear, coach peel, cross tension and KS-2 tests of a weld's card");
  coupon_command
      ->add_option("card", coupon.card,
                   "a *MAT_SPOTWELD, an interpolation spot weld or a rivet, with what belongs to it; sections and "
                   "materials of sheets")
      ->required();
  coupon_command->add_option("-o,--output", coupon.directory, "folder for decks, runs, tables, pictures and page")
      ->required();
  coupon_command
      ->add_option("--thickness", coupon.thickness,
                   "of both sheets, or T1,T2 (default: the card's *SECTION_SHELL, or 1.5 mm)")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(length);
  coupon_command
      ->add_option("--diameter", coupon.diameter, "of the weld (default: the card's *SECTION_BEAM, or 5 sqrt(t))")
      ->check(length);
  add_weld_form(coupon_command, coupon.form, nugget::weld::forms_of_elements(), "one beam, or 1, 4, 8, 16 bricks");
  coupon_command
      ->add_option("--only", coupon.only, "names of coupons separated by commas, e.g. lap_shear,ks2_45 (default: all)")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember(nugget::app::coupon_names()));
  coupon_command->add_flag("--decks", coupon.only_decks, "write the decks and run nothing");
  coupon_command->add_option("-j,--threads", coupon.threads, "coupons at once (default: all cores)")->check(count);

  nugget::app::FitArguments fit;
  CLI::App* fit_command =
      cli.add_subcommand("fit", "strengths and damage of a weld's card from measured curves of coupons");
  fit_command->add_option("curves", fit.curves, "table of test, sample, displacement, force")->required();
  fit_command
      ->add_option("card", fit.card,
                   "the card to begin with, a *MAT_SPOTWELD or an interpolation spot weld: strengths of 0 are left out")
      ->required();
  fit_command->add_option("-o,--output", fit.output, "the card to be written")->required();
  fit_command
      ->add_option("--thickness", fit.thickness,
                   "of both sheets, or T1,T2 (default: the card's *SECTION_SHELL, or 1.5 mm)")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(length);
  fit_command->add_option("--diameter", fit.diameter, "of the weld (default: the card's *SECTION_BEAM, or 5 sqrt(t))")
      ->check(length);
  add_weld_form(fit_command, fit.form, nugget::weld::forms_of_elements(),
                "the weld as one beam, or as 1, 4, 8, 16 bricks");
  fit_command->add_option("-j,--threads", fit.threads, "coupons at once (default: all cores)")->check(count);

  nugget::app::StudyArguments study;
  CLI::App* study_command =
      cli.add_subcommand("study", "runs a deck for each line of a table of its parameters, one table of results");
  study_command->add_option("plan", study.plan, "a line deck: MODEL.k, lines result: CHANNEL, a table of parameters")
      ->required();
  study_command->add_option("-o,--output", study.directory, "folder for the runs and the table")->required();
  study_command->add_option("-j,--threads", study.threads, "threads in all (default: all cores)")->check(count);
  study_command->add_option("--threads-each", study.threads_of_each, "threads of each run (default: 1)")->check(count);
  study_command->add_flag("--decks", study.only_decks,
                          "write the decks and runs.txt with a command for each, and run nothing");
  study_command->add_flag("--skip-unsupported", study.skip_unsupported,
                          "leave out what is not supported, with a warning each");
  study_command->add_flag("--quiet", study.quiet, "no progress on the terminal");

  nugget::app::TidyArguments tidy;
  CLI::App* tidy_command =
      cli.add_subcommand("tidy", "the deck as it was understood: values between commas, names of fields above them");
  tidy_command->add_option("deck", tidy.deck, "LS-DYNA keyword file")->required();
  tidy_command->add_option("-o,--output", tidy.output, "deck to be written; its include files are written beside it")
      ->required();
  add_case(tidy_command, tidy.load_case, "needed where it has several");

  nugget::app::CoverageArguments coverage;
  CLI::App* coverage_command =
      cli.add_subcommand("coverage", "which decks of a folder are accepted, and what refuses the others");
  coverage_command->add_option("folder", coverage.folder, "folder with decks, at any depth")->required();
  coverage_command->add_option("-o,--output", coverage.directory,
                               "folder for coverage.json and the logs of each deck (default: coverage)");
  coverage_command->add_option("--cycles", coverage.cycles, "run each for so many cycles instead of checking it")
      ->check(count);
  coverage_command->add_option("-j,--threads", coverage.threads, "decks at once (default: all cores)")->check(count);

  std::string keyword;
  CLI::App* keywords_command = cli.add_subcommand("keywords", "what is supported, from the card tables");
  keywords_command->add_option("name", keyword, "one keyword: its fields, defaults, ranges, meaning");

  std::string results, other_results;
  CLI::App* report_command =
      cli.add_subcommand("report", "(re)make report.html from the results in a folder, or compare two runs");
  report_command->add_option("directory", results, "folder with summary.json")->required();
  report_command->add_option("other", other_results,
                             "folder of a second run: writes compare.html of both into the first");

  nugget::app::ConvertArguments convert;
  CLI::App* convert_command = cli.add_subcommand("convert", "writes the results in a folder in another format");
  convert_command->add_option("directory", convert.directory, "folder with summary.json")->required();
  convert_command
      ->add_option("--to", convert.to,
                   "vtk: states, modes and welds as .vtu and .pvd for ParaView; csv: all histories as one table; "
                   "hdf5: histories, welds and responses as results.h5")
      ->required()
      ->check(CLI::IsMember(nugget::app::conversion_names()));
  convert_command->add_option("-o,--output", convert.target, "folder for them (default: the results' own)");

  std::string watched;
  bool once = false;
  CLI::App* watch_command = cli.add_subcommand("watch", "follows a run of another process, with small plots");
  watch_command->add_option("directory", watched, "folder of the run")->required();
  watch_command->add_flag("--once", once, "only how far it is now");

  nugget::app::PlotArguments plot;
  CLI::App* plot_command = cli.add_subcommand("plot", "draws histories and responses, and prints their extremes");
  plot_command->add_option("directory", plot.directory, "folder with summary.json")->required();
  plot_command->add_option("channel", plot.channels,
                           "FILE/ENTITY/QUANTITY, FILE/QUANTITY or FILE, with wildcards, e.g. swforc/50002/axial, "
                           "glstat/*energy (default: the channels are listed)");
  plot_command->add_option("-o,--output", plot.picture, "the picture, .svg or .png (default: none, only the extremes)")
      ->check(picture_name());
  plot_command->add_option("--cfc", plot.channel_class, "filter of SAE J211-1: 60, 180, 600 or 1000")
      ->check(CLI::IsMember(std::vector<int>(nugget::channel_classes.begin(), nugget::channel_classes.end())));
  plot_command->add_option("--over", plot.over, "a channel in the place of time, e.g. nodout/17/x_displacement");
  plot_command->add_option("--with", plot.other, "folder of another run: the same channels of both");
  plot_command->add_option("--width", plot.width, "pixels of a .png (default: 1440)")->check(CLI::Range(100, 20000));

  nugget::app::PictureArguments picture;
  nugget::report::PictureOptions& seen = picture.options;
  std::string view = "iso", up;
  CLI::App* picture_command = cli.add_subcommand("picture", "draws the model of a run at a state, or a natural mode");
  picture_command->add_option("directory", picture.directory, "folder with summary.json and d3plot")->required();
  picture_command->add_option("-o,--output", picture.picture, "the picture, .svg or .png")
      ->required()
      ->check(picture_name());
  CLI::Option* state = picture_command
                           ->add_option("--state", seen.state,
                                        "number of the state or mode (default: the last state, the first elastic mode)")
                           ->check(count);
  picture_command->add_option("--time", seen.time, "the state nearest to it")->excludes(state);
  picture_command
      ->add_option("--field", seen.field,
                   "what colours elements (default: plastic_strain where there is some, else part)")
      ->check(CLI::IsMember(nugget::report::picture_fields()));
  picture_command->add_option("--range", seen.range, "of its colours: LOW,HIGH (default: as the values are)")
      ->delimiter(',')
      ->allow_extra_args(false);
  picture_command
      ->add_option("--view", view, "where the eye is: iso, x, -x, y, -y, z, -z or X,Y,Z (--view=-x; default: iso)")
      ->check(direction(true));
  picture_command->add_option("--up", up, "what is up in the picture: an axis or X,Y,Z (default: z)")
      ->check(direction(false));
  picture_command->add_option("--scale", seen.scale, "of displacements (default: 1; of modes 6 % of the model's size)");
  picture_command->add_option("--part", seen.parts, "ids of parts that are shown, separated by commas (default: all)")
      ->delimiter(',')
      ->allow_extra_args(false);
  picture_command->add_option("--weld", seen.weld, "id of a weld to look at from near");
  picture_command->add_flag("!--no-edges", seen.edges, "without the edges of elements");
  picture_command->add_option("--width", seen.width, "pixels (default: 1440)")->check(CLI::Range(200, 8000));
  picture_command->add_option("--height", seen.height, "pixels (default: 960)")->check(CLI::Range(200, 8000));

  std::string demo_directory = "nugget_demo";
  CLI::App* demo_command = cli.add_subcommand("demo", "run the main example that comes with the program");
  demo_command->add_option("-o,--output", demo_directory, "folder for the results (default: nugget_demo)");

  std::vector<std::string> words = translated(argc, argv);
  nugget::app::name_values(cli);
  if (const std::optional<int> code = nugget::app::write_descriptions(cli, words)) return *code;
  if (const std::string message = nugget::app::unknown_command(cli, words); !message.empty()) {
    fmt::print(stderr, "{}", message);
    return static_cast<int>(ExitCode::wrong_command);
  }
  std::reverse(words.begin(), words.end());  // CLI11 takes them from the back
  try {
    cli.parse(words);
    if (run_command->parsed() && run.deck.empty() && run.resume.empty()) throw CLI::RequiredError("model");
    if (weld.adapt && !weld.deck.empty()) throw CLI::ExcludesError("--adapt", "points");
    if (weld.adapt && !weld.stack.empty()) throw CLI::ExcludesError("--adapt", "--stack");
    if (weld.divide && !weld.adapt) throw CLI::RequiresError("--divide", "--adapt");
    if (weld.adapt) std::swap(weld.points, weld.deck);  // its one file is the model
    if (weld_command->parsed() && weld.stack.empty() && weld.deck.empty())
      throw CLI::RequiredError(weld.points.empty() && !weld.adapt ? "points" : "model");
    if (weld_command->parsed() && !weld.stack.empty() && !weld.points.empty())
      throw CLI::ExcludesError("--stack", "points");
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return cli.exit(error);  // help
    fmt::print(stderr, "{}", nugget::app::wrong_words(cli, error));
    return static_cast<int>(ExitCode::wrong_command);
  }
  if (!stop_after.empty()) run.stop_after = *nugget::app::clock_seconds(stop_after);
  run.over_ranks = true;
  if (run_command->parsed()) return static_cast<int>(nugget::app::run(run));
  if (modes_command->parsed()) return static_cast<int>(nugget::app::modes(modes));
  if (frf_command->parsed()) return static_cast<int>(nugget::app::frf(frf, direct));
  if (check_command->parsed()) return static_cast<int>(nugget::app::check(check));
  if (weld_command->parsed()) return static_cast<int>(nugget::app::weld(weld));
  if (coupon_command->parsed()) return static_cast<int>(nugget::app::coupon(coupon));
  if (fit_command->parsed()) return static_cast<int>(nugget::app::fit(fit));
  if (welds_command->parsed()) return static_cast<int>(nugget::app::welds(welds));
  if (study_command->parsed()) return static_cast<int>(nugget::app::study(study));
  if (tidy_command->parsed()) return static_cast<int>(nugget::app::tidy(tidy));
  if (coverage_command->parsed()) return static_cast<int>(nugget::app::coverage(coverage));
  if (convert_command->parsed()) return static_cast<int>(nugget::app::convert(convert));
  if (picture_command->parsed()) {
    if (view != "iso") seen.towards = *direction_of(view);
    if (!up.empty()) seen.up = *direction_of(up);
    return static_cast<int>(nugget::app::picture(picture));
  }
  if (watch_command->parsed()) return static_cast<int>(nugget::app::watch(watched, once));
  if (plot_command->parsed()) return static_cast<int>(nugget::app::plot(plot));

  if (demo_command->parsed()) return static_cast<int>(nugget::app::demo(demo_directory));
  if (report_command->parsed()) return static_cast<int>(nugget::app::report(results, other_results));
  return static_cast<int>(nugget::app::keywords(keyword));
}

}  // namespace

int nugget::app::command_line(int argc, char** argv) {
  try {
    return obey(argc, argv);
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "nugget: {}\n", no_memory);
    return static_cast<int>(ExitCode::error_termination);
  }
}
