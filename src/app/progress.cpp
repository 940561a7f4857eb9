// SPDX-License-Identifier: Apache-2.0
#include "app/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

#include "base/index.hpp"

namespace nugget::app {
namespace {

constexpr double seconds_between_lines = 5.0;

}  // namespace

double share_done(const impact::Progress& p) {
  return p.end_time > 0.0 ? std::clamp(p.time / p.end_time, 0.0, 1.0) : 0.0;
}

std::optional<double> seconds_left(const impact::Progress& p) {
  const double done = share_done(p);
  if (!(done > 0.0)) return std::nullopt;
  return p.seconds * (1.0 - done) / done;
}

std::string progress_line(const impact::Progress& p) {
  if (p.kinetic_energy_ratio > 0.0)
    return fmt::format("dynamic relaxation  t {:.4e}  dt {:.3e}  cycle {}  kinetic energy over the largest {:.2e}",
                       p.time, p.dt, p.cycle, p.kinetic_energy_ratio);
  const std::optional<double> left = seconds_left(p);
  const std::string welds = p.welds > 0 ? fmt::format("  welds failed {}/{}", p.welds_failed, p.welds) : "";
  return fmt::format("t {:.4e}  dt {:.3e}  cycle {}  energy {:.4f}{}  left {}", p.time, p.dt, p.cycle, p.energy_ratio,
                     welds, left ? clock_time(*left) : "?");
}

std::string clock_time(double seconds) {
  const long s = static_cast<long>(seconds + 0.5);
  if (s >= 3600) return fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
  return fmt::format("{}:{:02}", s / 60, s % 60);
}

ProgressDisplay::ProgressDisplay() : terminal_(isatty(STDERR_FILENO) == 1) {}

void ProgressDisplay::operator()(const impact::Progress& p) {
  if (p.kinetic_energy_ratio > 0.0) return print_relaxation(p);
  const double done = p.end_time > 0.0 ? share_done(p) : 1.0;
  if (terminal_) {
    constexpr int width = 20;
    const int full = static_cast<int>(done * width);
    fmt::print(stderr, "\r[{}{}] {:3.0f} %  {}   ", std::string(at(full), '#'), std::string(at(width - full), '.'),
               100.0 * done, progress_line(p));
    std::fflush(stderr);
    drawn_ = true;
  } else if (p.seconds >= next_line_ || done >= 1.0) {
    fmt::print(stderr, "{:3.0f} %  {}\n", 100.0 * done, progress_line(p));
    next_line_ = p.seconds + seconds_between_lines;
  }
}

void ProgressDisplay::print_relaxation(const impact::Progress& p) {
  if (!terminal_ && p.seconds < next_line_) return;
  fmt::print(stderr, "{}{}{}", terminal_ ? "\r" : "", progress_line(p), terminal_ ? "   " : "\n");
  std::fflush(stderr);
  drawn_ = terminal_;
  next_line_ = p.seconds + seconds_between_lines;
}

void ProgressDisplay::finish() {
  if (drawn_) fmt::print(stderr, "\n");
  drawn_ = false;
}

}  // namespace nugget::app
