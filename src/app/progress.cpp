// SPDX-License-Identifier: Apache-2.0
#include "app/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <string>

#include "base/index.hpp"

namespace nugget::app {
namespace {

constexpr double seconds_between_lines = 5.0;

std::string clock_time(double seconds) {
  const long s = static_cast<long>(seconds + 0.5);
  if (s >= 3600) return fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
  return fmt::format("{}:{:02}", s / 60, s % 60);
}

}  // namespace

ProgressDisplay::ProgressDisplay() : terminal_(isatty(STDERR_FILENO) == 1) {}

void ProgressDisplay::operator()(const impact::Progress& p) {
  if (p.kinetic_energy_ratio > 0.0) return print_relaxation(p);
  const double done = p.end_time > 0.0 ? std::clamp(p.time / p.end_time, 0.0, 1.0) : 1.0;
  const std::string left = done > 0.0 ? clock_time(p.seconds * (1.0 - done) / done) : "?";
  const std::string welds = p.welds > 0 ? fmt::format("  welds failed {}/{}", p.welds_failed, p.welds) : "";
  const std::string numbers = fmt::format("t {:.4e}  dt {:.3e}  cycle {}  energy {:.4f}{}  left {}", p.time, p.dt,
                                          p.cycle, p.energy_ratio, welds, left);
  if (terminal_) {
    constexpr int width = 20;
    const int full = static_cast<int>(done * width);
    fmt::print(stderr, "\r[{}{}] {:3.0f} %  {}   ", std::string(at(full), '#'), std::string(at(width - full), '.'),
               100.0 * done, numbers);
    std::fflush(stderr);
    drawn_ = true;
  } else if (p.seconds >= next_line_ || done >= 1.0) {
    fmt::print(stderr, "{:3.0f} %  {}\n", 100.0 * done, numbers);
    next_line_ = p.seconds + seconds_between_lines;
  }
}

void ProgressDisplay::print_relaxation(const impact::Progress& p) {
  if (!terminal_ && p.seconds < next_line_) return;
  fmt::print(stderr, "{}dynamic relaxation  t {:.4e}  dt {:.3e}  cycle {}  kinetic energy over the largest {:.2e}{}",
             terminal_ ? "\r" : "", p.time, p.dt, p.cycle, p.kinetic_energy_ratio, terminal_ ? "   " : "\n");
  std::fflush(stderr);
  drawn_ = terminal_;
  next_line_ = p.seconds + seconds_between_lines;
}

void ProgressDisplay::finish() {
  if (drawn_) fmt::print(stderr, "\n");
  drawn_ = false;
}

}  // namespace nugget::app
