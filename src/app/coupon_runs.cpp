// SPDX-License-Identifier: Apache-2.0
#include "app/coupon_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "app/command.hpp"
#include "app/node_histories.hpp"
#include "app/status.hpp"
#include "base/parallel.hpp"
#include "report/run_data.hpp"

namespace nugget::app {
namespace {

namespace fs = std::filesystem;

std::ifstream opened(const fs::path& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(fmt::format("{} cannot be read", path.string()));
  return file;
}

/// The number behind `label` in the line; nothing where the line has no such label.
bool number_behind(const std::string& line, const std::string& label, double& value) {
  const std::size_t at = line.find(label);
  if (at == std::string::npos) return false;
  value = std::strtod(line.c_str() + at + label.size(), nullptr);
  return true;
}

/// Force of the motion of the moving grip at each state.
std::vector<double> grip_forces(const fs::path& folder, int pull) {
  std::ifstream file = opened(folder / "bndout");
  const std::string head = fmt::format("mat#{:8}", weld::coupon_moving_grip), label = pull == 1 ? "xforce=" : "zforce=";
  std::vector<double> force;
  double value = 0.0;
  for (std::string line; std::getline(file, line);)
    if (line.starts_with(head) && number_behind(line, label, value)) force.push_back(value);
  return force;
}

/// Says which of the runs did not end normally.
ExitCode check_runs(const std::vector<ChildRun>& runs) {
  for (const ChildRun& run : runs) {
    if (run.exit_code == 0) continue;
    fmt::print(stderr, "nugget: {} ended with code {}; what it said: {}\n", fs::absolute(run.deck).string(),
               run.exit_code, fs::absolute(run.folder / "terminal.log").string());
    return run.exit_code == 130 ? ExitCode::interrupted
           : run.exit_code == 1 ? ExitCode::refused
           : run.exit_code == 4 ? ExitCode::cannot_write
                                : ExitCode::error_termination;
  }
  return ExitCode::normal;
}

double weld_number(const report::WeldRow& row, const char* column) {
  const auto cell = row.find(column);
  return cell == row.end() || cell->second.empty() ? 0.0 : std::strtod(cell->second.c_str(), nullptr);
}

void take_loads_at_peak(const LoadPath& path, report::CouponResult& r) {
  const auto peak = std::max_element(path.force.begin(), path.force.end()) - path.force.begin();
  const std::array<double, 4>& load = path.load[static_cast<std::size_t>(peak)];
  r.axial = load[0], r.shear = load[1], r.torsion = load[2], r.bending = load[3];
}

}  // namespace

std::vector<ChildRun> write_coupons(const weld::CouponCard& card, const std::vector<weld::CouponTest>& tests) {
  std::vector<ChildRun> runs;
  for (const weld::CouponTest& test : tests) {
    runs.push_back({test.name() + ".k", test.name()});
    output::write_whole_file(runs.back().deck, weld::write_coupon(card, test));
  }
  return runs;
}

std::optional<PreparedDeck> prepare_coupon(const ChildRun& run) {
  Findings findings;
  RunArguments arguments;
  arguments.deck = run.deck.string();
  PreparedDeck prepared = prepare(arguments, findings);
  if (findings.errors() == 0 && prepared.ties.welds.size() == 1) return prepared;
  print_findings(findings);
  fmt::print(stderr, "nugget: {} is refused with the card in it; nothing was run\n", fs::absolute(run.deck).string());
  return {};
}

ExitCode run_coupons(std::vector<ChildRun>& runs, int asked_threads) {
  use_threads(asked_threads);
  std::size_t ended = 0;
  Status status(false);
  status(fmt::format("{} coupons are running", runs.size()));
  const ChildrenEnd end = run_children(runs, threads(), [&](const ChildRun& run) {
    status(fmt::format("{} of {} coupons: {} has ended", ++ended, runs.size(), run.folder.filename().string()));
  });
  status.clear();
  if (end == ChildrenEnd::not_started) {
    fmt::print(stderr, "nugget: the coupons cannot be run: no process could be started\n");
    return ExitCode::error_termination;
  }
  if (end == ChildrenEnd::interrupted) {
    fmt::print(stderr, "nugget: interrupted, {} of {} coupons had ended\n", ended, runs.size());
    return ExitCode::interrupted;
  }
  return check_runs(runs);
}

report::CouponResult read_coupon(const fs::path& folder, const weld::CouponTest& test, CouponLoads loads) {
  const report::RunData run = report::read_run(folder);
  if (run.welds.size() != 1)
    throw std::runtime_error(fmt::format("{}: {} welds, expected one", folder.string(), run.welds.size()));
  const report::WeldRow& weld = run.welds.front();
  report::CouponResult r;
  r.name = test.name();
  r.title = test.title();
  r.angle = test.angle;
  r.failed = weld.at("failed") == "yes";
  r.failure_mode = weld.at("failure_mode");
  r.axial = weld_number(weld, "last_axial");
  r.shear = weld_number(weld, "last_shear");
  r.bending = weld_number(weld, "last_bending");
  r.torsion = weld_number(weld, "last_torsion");
  r.failure_value = weld_number(weld, "last_failure");
  const double end = r.failed ? weld_number(weld, "failure_time") : std::numeric_limits<double>::infinity();
  const std::vector<double> force = grip_forces(folder, test.pull());
  const std::map<int, NodeHistory> nodes = read_node_histories(folder);
  if (nodes.size() != 1)
    throw std::runtime_error(fmt::format("{}: {} nodes in nodout, expected the grip's", folder.string(), nodes.size()));
  const NodeHistory& grip = nodes.begin()->second;
  const auto along_pull = [&](std::size_t i) {
    return test.pull() == 1 ? grip.displacement[i].x : grip.displacement[i].z;
  };
  const std::size_t states = std::min(force.size(), grip.time.size());
  if (states == 0) throw std::runtime_error(fmt::format("{}: no states of the grip in bndout", folder.string()));
  for (std::size_t i = 0; i < states && grip.time[i] <= end; ++i) {
    if (i > 0) r.work += 0.5 * (force[i] + force[i - 1]) * (along_pull(i) - along_pull(i - 1));
    r.displacement.push_back(along_pull(i));
    r.force.push_back(force[i]);
  }
  if (r.force.empty()) throw std::runtime_error(fmt::format("{}: the weld failed at once", folder.string()));
  const auto peak = std::max_element(r.force.begin(), r.force.end());
  r.peak = *peak;
  if (loads == CouponLoads::at_the_peak) take_loads_at_peak(read_load_path(folder, test), r);
  r.at = r.displacement[static_cast<std::size_t>(peak - r.force.begin())];
  return r;
}

LoadPath read_load_path(const fs::path& folder, const weld::CouponTest& test) {
  LoadPath path;
  std::ifstream file = opened(folder / "swforc");
  for (std::string line; std::getline(file, line);) {
    // number, axial, shear, time, failure, what it is, ID, id, length, moment, torsion
    const std::size_t label = line.find(" ID ");
    if (label == std::string::npos) continue;
    if (line.find("failure time=") != std::string::npos) break;
    std::istringstream front(line), back(line.substr(label + 4));
    double number = 0.0, axial = 0.0, shear = 0.0, id = 0.0, length = 0.0, moment = 0.0, torsion = 0.0;
    if (front >> number >> axial >> shear && back >> id >> length >> moment >> torsion)
      path.load.push_back({std::max(axial, 0.0), shear, std::abs(torsion), moment});
  }
  path.force = grip_forces(folder, test.pull());
  const std::size_t states = std::min(path.force.size(), path.load.size());
  if (states == 0) throw std::runtime_error(fmt::format("{}: no states in swforc and bndout", folder.string()));
  path.force.resize(states);
  path.load.resize(states);
  return path;
}

}  // namespace nugget::app
