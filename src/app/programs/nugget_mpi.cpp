// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>
#include <fmt/format.h>
#include <mpi.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

#include "app/command_line.hpp"
#include "app/exit_code.hpp"
#include "app/programs/started_ranks.hpp"
#include "app/rank_team.hpp"
#include "app/terminal.hpp"
#include "nvh/eigen/followed_calls.hpp"
#include "nvh/matrices/ranks.hpp"
#include "output/restart_file.hpp"

// `nugget-mpi`, and `nugget-mpi-avx512` with eight lanes: the same program with MPI. The first rank does what the
// command line asks for. The others answer its calls of the solver, and compute their shares of explicit runs.
namespace {

using nugget::nvh::SolverCall;

/// Messages between the ranks, by MPI.
class MpiRanks final : public nugget::Ranks {
 public:
  explicit MpiRanks(MPI_Comm all) : all_(all) {
    MPI_Comm_size(all_, &count_);
    MPI_Comm_rank(all_, &rank_);
  }
  int count() const override { return count_; }
  int rank() const override { return rank_; }

  void send(int to, std::span<const std::byte> data) override {
    ++traffic_.messages;
    traffic_.bytes += data.size();
    in_pieces(data.size(), [&](std::size_t begin, int size) {
      MPI_Isend(data.data() + begin, size, MPI_BYTE, to, 0, all_, &requests_.emplace_back());
    });
  }
  void receive(int from, std::span<std::byte> data) override {
    in_pieces(data.size(), [&](std::size_t begin, int size) {
      MPI_Irecv(data.data() + begin, size, MPI_BYTE, from, 0, all_, &requests_.emplace_back());
    });
  }
  void finish() override {
    const Waiting waiting(traffic_);
    wait();
  }
  void gather(std::span<const std::byte> own, std::span<std::byte> all) override {
    const Waiting waiting(traffic_);
    ++traffic_.messages;
    traffic_.bytes += own.size();
    const auto size = static_cast<int>(own.size());
    MPI_Iallgather(own.data(), size, MPI_BYTE, all.data(), size, MPI_BYTE, all_, &requests_.emplace_back());
    wait();
  }
  void broadcast(std::span<std::byte> data) override {
    const Waiting waiting(traffic_);
    in_pieces(data.size(), [&](std::size_t begin, int size) {
      MPI_Ibcast(data.data() + begin, size, MPI_BYTE, 0, all_, &requests_.emplace_back());
    });
    wait();
  }
  Traffic traffic() const override { return traffic_; }

 private:
  /// Others may want the core, ranks among them where there are more than cores: who waits longer than messages take
  /// gives it away between two looks, and then sleeps.
  void wait() {
    constexpr int looks = 200, yields = 2000;
    for (int look = 0, done = 0;; ++look) {
      MPI_Testall(static_cast<int>(requests_.size()), requests_.data(), &done, MPI_STATUSES_IGNORE);
      if (done) break;
      if (look > yields)
        std::this_thread::sleep_for(std::chrono::microseconds(20));
      else if (look > looks)
        std::this_thread::yield();
    }
    requests_.clear();
  }
  /// Adds the time that it lives.
  class Waiting {
   public:
    explicit Waiting(Traffic& traffic) : traffic_(traffic), begin_(MPI_Wtime()) {}
    ~Waiting() { traffic_.waiting += MPI_Wtime() - begin_; }
    Waiting(const Waiting&) = delete;
    Waiting& operator=(const Waiting&) = delete;

   private:
    Traffic& traffic_;
    double begin_;
  };
  /// MPI counts in int.
  template <class Each>
  static void in_pieces(std::size_t size, const Each& each) {
    constexpr std::size_t most = std::size_t{1} << 30;
    for (std::size_t begin = 0; begin < size; begin += most)
      each(begin, static_cast<int>(std::min(most, size - begin)));
  }

  MPI_Comm all_;
  int count_ = 1, rank_ = 0;
  std::vector<MPI_Request> requests_;
  Traffic traffic_;
};

/// What the first rank asks of the others: a call of the solver, or their part in an explicit run.
struct Call {
  static constexpr int to_a_run = -1;
  std::array<int, 3> words{};  ///< of a run: to_a_run, case
  bool is_run() const { return words[0] == to_a_run; }
};

/// Passes on a call of the first rank. Who waits for one sleeps between two checks: the cores belong to the first rank
/// meanwhile.
void pass_on(Call& call, MPI_Comm ranks) {
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Ibcast(call.words.data(), static_cast<int>(call.words.size()), MPI_INT, 0, ranks, &request);
  for (int done = 0;;) {
    MPI_Test(&request, &done, MPI_STATUS_IGNORE);
    if (done) break;
    std::this_thread::sleep_for(std::chrono::microseconds(50));
  }
}

[[noreturn]] void abandon(int code, MPI_Comm ranks) {
  std::fflush(nullptr);
  MPI_Abort(ranks, code);
  std::_Exit(code);
}

int lead(int argc, char** argv, nugget::app::RankTeam& team, MPI_Comm ranks) {
  const auto send = [&](SolverCall call) {
    Call words{{static_cast<int>(call.kind), call.instance, call.job}};
    pass_on(words, ranks);
  };
  team.call = [&](int load_case) {
    Call words{{Call::to_a_run, load_case, 0}};
    pass_on(words, ranks);
  };
  nugget::nvh::lead_ranks(*team.ranks, send);
  const int code = nugget::app::command_line(argc, argv);
  if (team.broken || nugget::nvh::left_ranks_waiting()) abandon(code, ranks);
  send({SolverCall::Kind::end});
  return code;
}

void report_failure(int rank, const std::string& why) {
  fmt::print(stderr, "nugget: rank {}: {}\n", rank, why);
}

/// Takes part in a run; what there is to say the first rank says.
void join_run(int argc, char** argv, nugget::app::RankTeam& team, MPI_Comm ranks) {
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  const std::array<int, 2> kept{dup(STDOUT_FILENO), dup(STDERR_FILENO)};
  const auto restore = [&] {
    std::fflush(nullptr);
    dup2(kept[0], STDOUT_FILENO);
    dup2(kept[1], STDERR_FILENO);
  };
  std::fflush(nullptr);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  team.called = true;
  std::string failure;
  try {
    nugget::app::command_line(argc, argv);
    if (team.broken) failure = "it left the run";
  } catch (const std::exception& error) {
    failure = error.what();
  }
  team.called = false;
  restore();
  for (const int file : {nowhere, kept[0], kept[1]}) close(file);
  if (failure.empty()) return;
  report_failure(team.ranks->rank(), failure);
  abandon(static_cast<int>(nugget::app::ExitCode::error_termination), ranks);
}

/// Exits that are not the program's own.
void end_within_solver() {
  if (!nugget::nvh::within_mumps()) return;
  fmt::print(stderr, "nugget: the solver ended the program: most likely there was not enough memory\n");
  std::_Exit(static_cast<int>(nugget::app::ExitCode::error_termination));
}

int run(int argc, char** argv) {
  std::atexit(end_within_solver);
  MPI_Comm ranks = MPI_COMM_NULL, of_runs = MPI_COMM_NULL;
  MPI_Comm_dup(MPI_COMM_WORLD, &ranks);  // calls do not meet the solver's own messages
  MPI_Comm_dup(MPI_COMM_WORLD, &of_runs);
  MpiRanks all(of_runs);
  if (all.count() != nugget::app::started_ranks()) {
    fmt::print(stderr, "nugget: the mpirun that started this is not that of the MPI with which nugget-mpi was built\n");
    return static_cast<int>(nugget::app::ExitCode::wrong_command);
  }
  // Restart files go by the build, which is that of the program for one process.
  std::error_code unknown;
  nugget::output::take_for_program(std::filesystem::read_symlink("/proc/self/exe", unknown).replace_filename("nugget"));
  nugget::app::RankTeam team;
  team.ranks = &all;
  MPI_Comm here = MPI_COMM_NULL;
  MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &here);
  MPI_Comm_size(here, &team.on_this_machine);
  nugget::app::set_rank_team(&team);
  if (all.rank() == 0) {
    nugget::app::guard_terminal();
    return nugget::app::code_after_terminal(lead(argc, argv, team, ranks));
  }
  const auto next = [&] {
    for (;;) {
      Call call;
      pass_on(call, ranks);
      if (!call.is_run()) return SolverCall{static_cast<SolverCall::Kind>(call.words[0]), call.words[1], call.words[2]};
      team.load_case = call.words[1];
      join_run(argc, argv, team, ranks);
    }
  };
  try {
    nugget::nvh::follow_calls(all, next);
  } catch (const std::bad_alloc&) {
    report_failure(all.rank(), "not enough memory for its share [more ranks on more machines; fewer modes]");
    abandon(static_cast<int>(nugget::app::ExitCode::error_termination), ranks);
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  std::set_new_handler(nullptr);  // see processor_check.cpp
  int given = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &given);
  const int code = run(argc, argv);
  MPI_Finalize();
  return code;
}
