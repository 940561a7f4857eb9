// SPDX-License-Identifier: Apache-2.0
#include "app/rank_team.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <exception>
#include <thread>

#include "base/parallel.hpp"

namespace nugget::app {
namespace {
RankTeam* the_team = nullptr;
}  // namespace

RankTeam* rank_team() {
  return the_team;
}

void set_rank_team(RankTeam* team) {
  the_team = team;
}

JoinedRun::JoinedRun(RankTeam* team, int load_case) : team_(team), exceptions_(std::uncaught_exceptions()) {
  if (team_ != nullptr && team_->ranks->rank() == 0) team_->call(load_case);
}

JoinedRun::~JoinedRun() {
  decline();
  if (team_ != nullptr && begun_ && std::uncaught_exceptions() > exceptions_) team_->broken = true;
}

std::string JoinedRun::use_threads(int asked) const {
  if (team_ == nullptr) return {};
  const int cores = std::max(1, static_cast<int>(sysconf(_SC_NPROCESSORS_ONLN))), here = team_->on_this_machine,
            own = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  set_threads(asked > 0 ? asked : std::min(own, std::max(1, cores / here)));
  if (here * threads() <= cores) return {};
  return fmt::format(
      "{} rank{} of {} thread{} on a machine of {} core{}: they wait for each other's cores [fewer ranks, or -j {}]",
      here, here == 1 ? "" : "s", threads(), threads() == 1 ? "" : "s", cores, cores == 1 ? "" : "s",
      std::max(1, cores / here));
}

void JoinedRun::decline() {
  std::string why;
  if (team_ != nullptr && !agreed_) agree({}, why);
}

void JoinedRun::work_together(const Ready& own, const std::function<void(Ranks*)>& work) {
  if (team_ == nullptr) return work(nullptr);
  refused_ = !agree(own, why_refused_);
  if (refused_) return work(nullptr);
  // Left by an exception in here, others wait for messages: no agreement would reach them.
  work(team_->ranks);
  agreed_ = begun_ = false;
}

bool JoinedRun::agree(const Ready& own, std::string& why) {
  if (refused_) {
    why = why_refused_;
    return false;
  }
  agreed_ = true;
  if (team_ == nullptr) return begun_ = own.willing;
  const std::vector<Ready> all = gather(*team_->ranks, own);
  begun_ = std::ranges::all_of(all, &Ready::willing);
  for (std::size_t r = 1; r < all.size(); ++r) {
    constexpr const char* where = "all ranks read it by the same name: it must stand in a folder that all machines see";
    const auto differ = [&](const char* what, const char* remedy) {
      why = fmt::format("rank {} has {} than the first one [{}]", r, what, remedy);
      begun_ = false;
    };
    // Without one that will do a rank is not willing.
    if (all[0].willing && all[r].restart_file != all[0].restart_file)
      why = fmt::format("rank {} does not have the restart file of the first one [{}]", r, where);
    if (!why.empty()) begun_ = false;
    if (!begun_) continue;
    if (all[r].program != all[0].program)
      differ("another build of nugget", "install the same on all machines");
    else if (all[r].deck != all[0].deck)
      differ("another deck", where);
    else if (all[r].lanes != all[0].lanes)
      differ("other lanes", "set NUGGET_LANES=4 for all");
  }
  return begun_;
}

}  // namespace nugget::app
