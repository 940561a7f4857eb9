// SPDX-License-Identifier: Apache-2.0
#include "app/child_runs.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <map>
#include <system_error>

namespace nugget::app {
namespace {

namespace fs = std::filesystem;

/// The process, or -1.
pid_t start_child(const ChildRun& run, const fs::path& program) {
  std::error_code error;
  fs::create_directories(run.folder, error);
  std::vector<std::string> words{program.string(), run.verb};
  if (run.resumed)
    words.insert(words.end(), {"--resume", run.folder.string()});
  else
    words.insert(words.end(), {run.deck.string(), "-o", run.folder.string()});
  words.insert(words.end(), {"-j", std::to_string(run.threads)});
  if (run.verb == "run") words.emplace_back("--quiet");
  words.insert(words.end(), run.options.begin(), run.options.end());
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const std::string log = (run.folder / "terminal.log").string();
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
  pid_t process = -1;
  const int failed = posix_spawn(&process, program.c_str(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  return failed == 0 ? process : -1;
}

/// Signals as bytes in a pipe, so that one that comes before the wait for it is not lost.
class Signals {
 public:
  Signals() {
    if (::pipe2(pipe_, O_CLOEXEC) != 0) return;
    ::fcntl(pipe_[1], F_SETFL, O_NONBLOCK);
    write_end = pipe_[1];
    struct sigaction action {};
    action.sa_handler = [](int signal) {
      const int before = errno;
      const auto byte = static_cast<unsigned char>(signal);
      [[maybe_unused]] const ssize_t written = ::write(write_end, &byte, 1);
      errno = before;
    };
    action.sa_flags = SA_RESTART;
    for (std::size_t i = 0; i < caught.size(); ++i) ::sigaction(caught[i], &action, &before_[i]);
  }
  ~Signals() {
    if (pipe_[0] < 0) return;
    for (std::size_t i = 0; i < caught.size(); ++i) ::sigaction(caught[i], &before_[i], nullptr);
    for (const int end : pipe_) ::close(end);
  }
  Signals(const Signals&) = delete;
  Signals& operator=(const Signals&) = delete;

  bool ready() const { return pipe_[0] >= 0; }
  /// Waits for one.
  int next() const {
    unsigned char byte = 0;
    while (::read(pipe_[0], &byte, 1) != 1)
      if (errno != EINTR) return SIGTERM;
    return byte;
  }

 private:
  static constexpr std::array<int, 4> caught{SIGCHLD, SIGINT, SIGTERM, SIGHUP};
  static inline int write_end = -1;
  int pipe_[2] = {-1, -1};
  std::array<struct sigaction, caught.size()> before_{};
};

class Children {
 public:
  Children(std::vector<ChildRun>& runs, const std::function<void(const ChildRun&)>& progress)
      : runs_(runs), progress_(progress) {}

  ChildrenEnd run(const fs::path& program, int at_once) {
    const Signals signals;
    if (!signals.ready()) return ChildrenEnd::not_started;
    ChildrenEnd end = ChildrenEnd::all_ended;
    for (std::size_t next = 0;;) {
      for (; end != ChildrenEnd::interrupted && next < runs_.size() && std::ssize(busy_) < at_once; ++next) {
        const pid_t process = start_child(runs_[next], program);
        if (process < 0)
          end = ChildrenEnd::not_started;
        else
          busy_[process] = next;
      }
      if (busy_.empty()) return end;
      if (signals.next() != SIGCHLD) {
        end = ChildrenEnd::interrupted;
        for (const auto& [process, run] : busy_) ::kill(process, SIGTERM);
      }
      take_ended();
    }
  }

 private:
  /// One SIGCHLD may stand for several.
  void take_ended() {
    int status = 0;
    for (pid_t process = 0; (process = ::waitpid(-1, &status, WNOHANG)) > 0;) {
      const auto ended = busy_.find(process);
      if (ended == busy_.end()) continue;
      // Of one that a signal ended 128 and its number, as shells have it.
      ChildRun& run = runs_[ended->second];
      run.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
      busy_.erase(ended);
      progress_(run);
    }
  }

  std::vector<ChildRun>& runs_;
  const std::function<void(const ChildRun&)>& progress_;
  std::map<pid_t, std::size_t> busy_;
};

}  // namespace

ChildrenEnd run_children(std::vector<ChildRun>& runs, int at_once,
                         const std::function<void(const ChildRun&)>& progress) {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (error) return ChildrenEnd::not_started;
  return Children(runs, progress).run(program, at_once);
}

}  // namespace nugget::app
