// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <stdexcept>

#include "app/command.hpp"
#include "app/coupon_card.hpp"
#include "app/coupon_runs.hpp"
#include "app/measured_curves.hpp"
#include "model/units.hpp"
#include "output/column_units.hpp"
#include "weld/coupon/strength_fit.hpp"

namespace nugget::app {
namespace {

namespace fs = std::filesystem;

/// Tests of the curves, each once.
std::vector<weld::CouponTest> tests_of(const std::vector<MeasuredCurve>& curves) {
  std::vector<weld::CouponTest> tests;
  for (const MeasuredCurve& curve : curves)
    if (std::none_of(tests.begin(), tests.end(), [&](const auto& t) { return t.name() == curve.test.name(); }))
      tests.push_back(curve.test);
  return tests;
}

/// The strengths to begin with: NRR, NRS = NRT, MRR, MSS = MTT.
std::array<double, 4> strengths_of(const TakenCard& taken, const std::string& file) {
  const model::WeldLaw& law = taken.law;
  if (law.function != model::none)
    throw CardFault(fmt::format(
        "{}: FVAL names a failure function of its own, which has no strengths to be found [leave FVAL 0]", file));
  if (law.connection || law.option > 0)
    throw CardFault(
        fmt::format("{}: OPT {} (or _DA): strengths are found for OPT 0, -1 and -2 only [write the card with "
                    "NRR, NRS, NRT, MRR, MSS, MTT]",
                    file, law.option));
  std::array<double, 6> s{};
  for (std::size_t i = 0; i < 6; ++i) {
    if (!law.strength[i].factor.empty())
      throw CardFault(
          fmt::format("{}: a strength is a curve over the strain rate, expected numbers [give the static "
                      "value]",
                      file));
    s[i] = law.strength[i].value;
  }
  if (s[1] != s[2] || s[4] != s[5])
    throw CardFault(
        fmt::format("{}: NRS and NRT, MSS and MTT differ: a round weld has one strength for both directions "
                    "[write the same number in both]",
                    file));
  return {s[0], s[1], s[3], s[4]};
}

std::array<double, 6> on_card(const std::array<double, 4>& s) {
  return {s[0], s[1], s[1], s[2], s[3], s[3]};
}

/// What the weld bore when the grip first had that force, between two states.
std::array<double, 4> load_at(const LoadPath& path, double force, const std::string& test) {
  for (std::size_t i = 0; i < path.force.size(); ++i) {
    if (path.force[i] < force) continue;
    if (i == 0) return path.load[0];
    const double share = (force - path.force[i - 1]) / (path.force[i] - path.force[i - 1]);
    std::array<double, 4> load{};
    for (std::size_t k = 0; k < 4; ++k) load[k] = path.load[i - 1][k] + share * (path.load[i][k] - path.load[i - 1][k]);
    return load;
  }
  throw CardFault(
      fmt::format("{}: {:.4g} was measured, but the coupon carries no more than {:.4g} within its stroke even "
                  "with a weld that does not fail [give the sheets of the test: thickness and material]",
                  test, force, *std::max_element(path.force.begin(), path.force.end())));
}

std::string sample_name(const MeasuredCurve& curve) {
  return curve.sample.empty() ? curve.test.name() : curve.test.name() + ' ' + curve.sample;
}

/// The table of strengths, as remarks in the card and for the terminal.
std::vector<std::string> strength_lines(const weld::StrengthFit& fit, const std::array<double, 4>& start) {
  std::vector<std::string> lines;
  for (std::size_t k = 0; k < 4; ++k) {
    if (fit.strength[k] == 0.0) continue;
    const std::string interval = fit.high[k] > 0.0 ? fmt::format("95 %: {:.5g} to {:.5g}", fit.low[k], fit.high[k])
                                                   : std::string("no repeats, no confidence");
    lines.push_back(fmt::format("{:<10} {:>11.5g}  {} (began with {:.5g})", weld::strength_names[k], fit.strength[k],
                                interval, start[k]));
  }
  return lines;
}

class Fit {
 public:
  Fit(const FitArguments& arguments, const fs::path& directory) : arguments_(arguments), directory_(directory) {
    coupon_.card = arguments.card;
    coupon_.thickness = arguments.thickness;
    coupon_.diameter = arguments.diameter;
  }

  ExitCode run() {
    Findings findings;
    curves_ = read_curves(arguments_.curves, findings);
    if (findings.errors() > 0) {
      print_findings(findings);
      return ExitCode::refused;
    }
    tests_ = tests_of(curves_);
    const TakenCard taken = take_card(coupon_, directory_);
    if (!card_is_sound(taken)) return ExitCode::refused;
    units_ = taken.card.units;
    const std::array<double, 4> start = strengths_of(taken, arguments_.card);
    for (const std::string& note : taken.notes) fmt::print("{}\n", note);
    if (const ExitCode code = run_with({}, taken, "unbroken"); code != ExitCode::normal) return code;
    std::vector<weld::StrengthSample> samples;
    for (const MeasuredCurve& curve : curves_)
      samples.push_back(
          {sample_name(curve), load_at(read_load_path(directory_ / "unbroken" / curve.test.name(), curve.test),
                                       curve.peak, sample_name(curve))});
    const weld::StrengthFit fit = weld::fit_strengths(samples, start);
    if (!fit.fault.empty()) throw CardFault(fmt::format("{}: {}", arguments_.curves, fit.fault));
    write_card(taken, fit, start);
    if (const ExitCode code = run_with(fit.strength, taken, "fitted"); code != ExitCode::normal) return code;
    report(fit, start);
    return ExitCode::normal;
  }

 private:
  /// Reads a coupon with the card as it is given; tells what is wrong.
  bool card_is_sound(const TakenCard& taken) const {
    const InFolder here(directory_);
    return prepare_coupon(write_coupons(taken.card, {tests_.front()}).front()).has_value();
  }

  /// The tests with these strengths, in a folder of that name.
  ExitCode run_with(const std::array<double, 4>& strength, const TakenCard& taken, const char* name) {
    const fs::path folder = directory_ / name;
    fs::create_directories(folder);
    const std::string text = with_strengths(taken, on_card(strength), {});
    const InFolder here(folder);
    output::write_whole_file("card.k", text);
    weld::CouponCard card = taken.card;
    card.included = "card.k";
    std::vector<ChildRun> runs = write_coupons(card, tests_);
    if (!prepare_coupon(runs.front())) return ExitCode::refused;
    return run_coupons(runs, arguments_.threads);
  }

  void write_card(const TakenCard& taken, const weld::StrengthFit& fit, const std::array<double, 4>& start) {
    std::vector<std::string> remarks{fmt::format("Strengths by nugget fit from {} ({} specimens; scatter {:.2g} %).",
                                                 fs::path(arguments_.curves).filename().string(), curves_.size(),
                                                 100.0 * fit.scatter)};
    for (const std::string& line : strength_lines(fit, start)) remarks.push_back(line);
    output::write_whole_file(arguments_.output, with_strengths(taken, on_card(fit.strength), remarks));
    CouponArguments again = coupon_;
    again.card = arguments_.output;
    const std::array<double, 4> read = strengths_of(take_card(again, directory_), arguments_.output);
    for (std::size_t k = 0; k < 4; ++k)
      if (std::abs(read[k] - fit.strength[k]) > 1e-4 * fit.strength[k])
        throw CardFault(
            fmt::format("{}: its second card does not read back as it was written [write the weld's card in "
                        "columns of ten]",
                        arguments_.output));
  }

  void report(const weld::StrengthFit& fit, const std::array<double, 4>& start) const {
    std::string csv =
        "test,sample,measured_force,measured_displacement,force_by_strengths,simulated_force,"
        "simulated_displacement\n";
    fmt::print("\n");
    for (const std::string& line : strength_lines(fit, start)) fmt::print(" {}\n", line);
    fmt::print("\n {:<22} {:>11} {:>13} {:>8} {:>11} {:>8}\n", "specimen", "measured", "by strengths", "ratio",
               "simulated", "ratio");
    for (std::size_t i = 0; i < curves_.size(); ++i) {
      const MeasuredCurve& curve = curves_[i];
      const report::CouponResult now = read_coupon(directory_ / "fitted" / curve.test.name(), curve.test);
      const double predicted = fit.ratio[i] * curve.peak;
      fmt::print(" {:<22} {:>11.5g} {:>13.5g} {:>8.4f} {:>11.5g} {:>8.4f}\n", sample_name(curve), curve.peak, predicted,
                 fit.ratio[i], now.peak, now.peak / curve.peak);
      csv += fmt::format("{},{},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g}\n", curve.test.name(), curve.sample, curve.peak,
                         curve.at, predicted, now.peak, now.at);
    }
    output::write_whole_file(directory_ / "fit.csv", csv);
    output::write_column_units(directory_, units_);
    fmt::print("\n scatter of a force about its strength: {:.2g} %\n", 100.0 * fit.scatter);
    if (units_)
      fmt::print(" forces in {}, moments in {}\n", model::symbol(*units_, dimension::force),
                 model::symbol(*units_, dimension::moment));
    fmt::print(" {}; runs and fit.csv in {}\n", arguments_.output, directory_.string());
  }

  const FitArguments& arguments_;
  fs::path directory_;
  CouponArguments coupon_;
  std::vector<MeasuredCurve> curves_;
  std::optional<model::Units> units_;
  std::vector<weld::CouponTest> tests_;
};

/// What is wrong with the command line; empty: nothing.
std::string wrong_fit_command(const FitArguments& arguments) {
  if (arguments.thickness.size() > 2)
    return fmt::format("--thickness: {} numbers, expected that of both sheets, or T1,T2", arguments.thickness.size());
  std::error_code error;
  for (const std::string& input : {arguments.curves, arguments.card})
    if (fs::equivalent(arguments.output, input, error))
      return fmt::format("{} would be overwritten; give another name after -o", input);
  return {};
}

}  // namespace

ExitCode fit(const FitArguments& arguments) {
  if (const std::string wrong = wrong_fit_command(arguments); !wrong.empty()) {
    fmt::print(stderr, "nugget: {}\n", wrong);
    return ExitCode::wrong_command;
  }
  fs::path directory = arguments.output;
  directory.replace_extension();
  directory += "_runs";
  return study_card(directory.string(), [&](const fs::path& folder) { return Fit(arguments, folder).run(); });
}

}  // namespace nugget::app
