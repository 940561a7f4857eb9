// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <variant>

#include "app/command.hpp"
#include "app/coupon_card.hpp"
#include "app/coupon_runs.hpp"
#include "app/measured_curves.hpp"
#include "model/units.hpp"
#include "output/column_units.hpp"
#include "weld/coupon/damage_fit.hpp"
#include "weld/coupon/strength_fit.hpp"
#include "weld/failure/force_at_failure.hpp"

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

/// The joint of a coupon that was read; nothing: its weld is one of a *MAT_SPOTWELD.
std::optional<kernel::Spr3> joint_of(const PreparedDeck& coupon, const std::string& file) {
  if (coupon.model.interpolation_spotwelds.empty()) return {};
  const auto* joint = std::get_if<kernel::Spr3>(&coupon.model.interpolation_spotwelds.front().law);
  if (joint == nullptr)
    throw CardFault(
        fmt::format("{}: strengths are found for a *MAT_SPOTWELD or an interpolation spot weld, not for a "
                    "rivet of *CONSTRAINED_SPR2 [its FN and FT are the largest forces in tension and shear]",
                    file));
  return *joint;
}

/// What an interpolation spot weld carries in pure tension, shear, torsion and bending; 0: it does not count.
std::array<double, 4> strengths_of(const kernel::Spr3& joint) {
  const double tension = weld::failure::force_at_failure(joint, 90.0),
               shear = weld::failure::force_at_failure(joint, 0.0);
  return {tension, shear, joint.torsion_share > 0.0 ? shear / joint.torsion_share : 0.0,
          joint.bending_share > 0.0 ? tension / joint.bending_share : 0.0};
}

/// The joint with other such strengths; with none (0) it carries whatever comes.
kernel::Spr3 with(kernel::Spr3 joint, const std::array<double, 4>& strength) {
  constexpr double unbroken = 1e3;
  const std::array<double, 4> old = strengths_of(joint);
  joint.normal_strength *= strength[0] > 0.0 ? strength[0] / old[0] : unbroken;
  joint.shear_strength *= strength[1] > 0.0 ? strength[1] / old[1] : unbroken;
  if (strength[2] > 0.0) joint.torsion_share = strength[1] / strength[2];
  if (strength[3] > 0.0) joint.bending_share = strength[0] / strength[3];
  return joint;
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
std::vector<std::string> strength_lines(const weld::StrengthFit& fit, const std::array<double, 4>& start,
                                        const weld::StrengthForm& form) {
  std::size_t widest = 10;
  for (const char* name : form.name) widest = std::max(widest, std::string_view(name).size());
  std::vector<std::string> lines;
  for (std::size_t k = 0; k < 4; ++k) {
    if (fit.strength[k] == 0.0) continue;
    const std::string interval = fit.high[k] > 0.0 ? fmt::format("95 %: {:.5g} to {:.5g}", fit.low[k], fit.high[k])
                                                   : std::string("no repeats, no confidence");
    lines.push_back(fmt::format("{:<{}} {:>11.5g}  {} (began with {:.5g})", form.name[k], widest, fit.strength[k],
                                interval, start[k]));
  }
  return lines;
}

/// Whether a test was measured until the force was gone.
bool to_the_end(const MeasuredCurve& curve) {
  return curve.force.back() <= 0.1 * curve.peak;
}

/// Runs of a search that did not end well.
struct RunsFailed {
  ExitCode code;
};

class Fit {
 public:
  Fit(const FitArguments& arguments, const fs::path& directory) : arguments_(arguments), directory_(directory) {
    coupon_.card = arguments.card;
    coupon_.thickness = arguments.thickness;
    coupon_.diameter = arguments.diameter;
    coupon_.form = arguments.form;
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
    const std::optional<PreparedDeck> first = prepare_first(taken);
    if (!first) return ExitCode::refused;
    units_ = taken.card.units;
    joint_ = joint_of(*first, arguments_.card);
    if (joint_) form_ = weld::form_of_interpolation(joint_->exponent);
    const std::array<double, 4> start = joint_ ? strengths_of(*joint_) : strengths_of(taken, arguments_.card);
    for (const std::string& note : taken.notes) fmt::print("{}\n", note);
    if (const ExitCode code = run_with({}, 0.0, taken, "unbroken"); code != ExitCode::normal) return code;
    std::vector<weld::StrengthSample> samples;
    for (const MeasuredCurve& curve : curves_)
      samples.push_back(
          {sample_name(curve), load_at(read_load_path(directory_ / "unbroken" / curve.test.name(), curve.test),
                                       curve.peak, sample_name(curve))});
    const weld::StrengthFit fit = weld::fit_strengths(samples, start, form_);
    if (!fit.fault.empty()) throw CardFault(fmt::format("{}: {}", arguments_.curves, fit.fault));
    try {
      find_damage(fit.strength, taken);
    } catch (const RunsFailed& failed) {
      return failed.code;
    }
    write_card(taken, fit, start);
    if (const ExitCode code = run_with(fit.strength, damage_.rupture, taken, "fitted"); code != ExitCode::normal)
      return code;
    report(fit, start);
    return ExitCode::normal;
  }

 private:
  /// A coupon with the card as it is given, read and tied; nothing where it is refused, which is reported.
  std::optional<PreparedDeck> prepare_first(const TakenCard& taken) const {
    const InFolder here(directory_);
    return prepare_coupon(write_coupons(taken.card, {tests_.front()}).front());
  }

  /// The card with these strengths and RS (0: that of the card).
  std::string card_text(const TakenCard& taken, const std::array<double, 4>& strength, double rupture,
                        const std::vector<std::string>& remarks) const {
    return joint_ ? with_joint_strengths(taken, with(*joint_, strength), remarks)
                  : with_strengths(taken, on_card(strength), rupture, remarks);
  }

  /// RS with which the works behind the peaks are met, where the card has one and some curves have such a work.
  void find_damage(const std::array<double, 4>& strength, const TakenCard& taken) {
    const model::WeldDamage& of_card = taken.law.damage;
    if ((of_card.option != 10 && of_card.option != 11) || of_card.rupture == 0.0) return;
    for (const MeasuredCurve& curve : curves_)
      if (to_the_end(curve)) faded_.push_back(&curve);
    if (faded_.empty()) {
      fmt::print("RS {:.4g} of the card is kept: no curve goes on until less than a tenth of its peak is left\n",
                 of_card.rupture);
      return;
    }
    std::vector<double> measured;
    for (const MeasuredCurve* curve : faded_) {
      measured.push_back(weld::work_after_peak(curve->displacement, curve->force));
      if (!(measured.back() > 0.0))
        throw CardFault(
            fmt::format("{}: the force falls at once, without any work behind its peak: such a weld has "
                        "no RS [leave RS and DMGOPT of the card 0]",
                        sample_name(*curve)));
    }
    begin_rupture_ = of_card.rupture;
    damage_ = weld::fit_damage(measured, of_card.rupture, [&](double rupture) {
      if (const ExitCode code = run_with(strength, rupture, taken, "damage"); code != ExitCode::normal)
        throw RunsFailed{code};
      std::vector<double> work;
      for (const MeasuredCurve* curve : faded_) {
        const report::CouponResult now = read_coupon(directory_ / "damage" / curve->test.name(), curve->test);
        work.push_back(weld::work_after_peak(now.displacement, now.force));
      }
      return work;
    });
    if (!damage_.fault.empty()) throw CardFault(fmt::format("{}: {}", arguments_.curves, damage_.fault));
  }

  /// What was found of RS; nothing where it was not sought.
  std::string damage_line() const {
    if (damage_.rupture == 0.0) return {};
    const std::string interval = damage_.high > 0.0 ? fmt::format("95 %: {:.5g} to {:.5g}", damage_.low, damage_.high)
                                                    : std::string("no repeats, no confidence");
    return fmt::format("{:<10} {:>11.5g}  {} (began with {:.5g})", "RS", damage_.rupture, interval, begin_rupture_);
  }

  /// The tests with these strengths and RS (0: that of the card), in a folder of that name.
  ExitCode run_with(const std::array<double, 4>& strength, double rupture, const TakenCard& taken, const char* name) {
    const fs::path folder = directory_ / name;
    fs::create_directories(folder);
    const std::string text = card_text(taken, strength, rupture, {});
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
    for (const std::string& line : strength_lines(fit, start, form_)) remarks.push_back(line);
    if (const std::string line = damage_line(); !line.empty()) remarks.push_back(line);
    output::write_whole_file(arguments_.output, card_text(taken, fit.strength, damage_.rupture, remarks));
    CouponArguments again = coupon_;
    again.card = arguments_.output;
    const TakenCard written = take_card(again, directory_);
    const std::array<double, 4> read = read_back(written);
    bool as_written =
        std::abs(written.law.damage.rupture - damage_.rupture) <= 1e-4 * damage_.rupture || damage_.rupture == 0.0;
    for (std::size_t k = 0; k < 4; ++k)
      as_written = as_written && std::abs(read[k] - fit.strength[k]) <= 1e-4 * fit.strength[k];
    if (!as_written)
      throw CardFault(
          fmt::format("{}: strengths or RS do not read back as they were written [write the weld's card in "
                      "columns of ten]",
                      arguments_.output));
  }

  std::array<double, 4> read_back(const TakenCard& written) const {
    if (!joint_) return strengths_of(written, arguments_.output);
    const std::optional<PreparedDeck> coupon = prepare_first(written);
    if (!coupon) throw CardFault(fmt::format("{}: is refused as it was written", arguments_.output));
    return strengths_of(*joint_of(*coupon, arguments_.output));
  }

  void report(const weld::StrengthFit& fit, const std::array<double, 4>& start) const {
    std::string csv =
        "test,sample,measured_force,measured_displacement,force_by_strengths,simulated_force,"
        "simulated_displacement,measured_work_after_peak,simulated_work_after_peak\n";
    std::vector<std::string> apart;
    fmt::print("\n");
    for (const std::string& line : strength_lines(fit, start, form_)) fmt::print(" {}\n", line);
    if (const std::string line = damage_line(); !line.empty()) fmt::print(" {}\n", line);
    fmt::print("\n {:<22} {:>11} {:>13} {:>8} {:>11} {:>8}\n", "specimen", "measured", "by strengths", "ratio",
               "simulated", "ratio");
    for (std::size_t i = 0; i < curves_.size(); ++i) {
      const MeasuredCurve& curve = curves_[i];
      const report::CouponResult now = read_coupon(directory_ / "fitted" / curve.test.name(), curve.test);
      const double predicted = fit.ratio[i] * curve.peak;
      if (std::abs(now.peak / curve.peak - 1.0) > 0.1) apart.push_back(sample_name(curve));
      fmt::print(" {:<22} {:>11.5g} {:>13.5g} {:>8.4f} {:>11.5g} {:>8.4f}\n", sample_name(curve), curve.peak, predicted,
                 fit.ratio[i], now.peak, now.peak / curve.peak);
      csv += fmt::format("{},{},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g}\n", curve.test.name(), curve.sample,
                         curve.peak, curve.at, predicted, now.peak, now.at,
                         weld::work_after_peak(curve.displacement, curve.force),
                         weld::work_after_peak(now.displacement, now.force));
    }
    report_damage();
    warn_of(apart);
    output::write_whole_file(directory_ / "fit.csv", csv);
    output::write_column_units(directory_, units_);
    fmt::print("\n scatter of a force about its strength: {:.2g} %\n", 100.0 * fit.scatter);
    if (units_)
      fmt::print(" forces in {}, moments in {}\n", model::symbol(*units_, dimension::force),
                 model::symbol(*units_, dimension::moment));
    fmt::print(" {}; runs and fit.csv in {}\n", arguments_.output, directory_.string());
  }

  /// Of specimens that fail elsewhere in the simulation than the strengths say.
  static void warn_of(const std::vector<std::string>& apart) {
    if (apart.empty()) return;
    fmt::print(
        "\n warning: simulated and measured peaks are more than 10 % apart for {}: with this card the weld does "
        "not fail there as it did in the test [bricks that are to fade in tension need E below 0, which leaves "
        "them the stresses of a beam; DMGOPT 10 needs a weld that yields before]\n",
        fmt::join(apart, ", "));
  }

  void report_damage() const {
    if (damage_.rupture == 0.0) return;
    fmt::print("\n {:<22} {:>24} {:>11} {:>8}\n", "specimen", "work behind the peak", "simulated", "ratio");
    for (std::size_t i = 0; i < faded_.size(); ++i) {
      const double work = weld::work_after_peak(faded_[i]->displacement, faded_[i]->force);
      fmt::print(" {:<22} {:>24.5g} {:>11.5g} {:>8.4f}\n", sample_name(*faded_[i]), work, damage_.ratio[i] * work,
                 damage_.ratio[i]);
    }
  }

  const FitArguments& arguments_;
  fs::path directory_;
  CouponArguments coupon_;
  std::vector<MeasuredCurve> curves_;
  std::optional<model::Units> units_;
  std::vector<weld::CouponTest> tests_;
  std::vector<const MeasuredCurve*> faded_;  ///< those that tell of RS
  std::optional<kernel::Spr3> joint_;        ///< of the card; nothing: a *MAT_SPOTWELD
  weld::StrengthForm form_ = weld::form_of_resultants;
  weld::DamageFit damage_;  ///< RS 0: not sought
  double begin_rupture_ = 0.0;
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
