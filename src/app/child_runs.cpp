// SPDX-License-Identifier: Apache-2.0
#include "app/child_runs.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <map>
#include <system_error>

extern char** environ;

namespace nugget::app {
namespace {

namespace fs = std::filesystem;

/// The process, or -1.
pid_t start_child(const ChildRun& run, const fs::path& program) {
  std::error_code error;
  fs::create_directories(run.folder, error);
  std::vector<std::string> words{program.string(), run.verb, run.deck.string(), "-o", run.folder.string(), "-j", "1"};
  if (run.verb == "run") words.emplace_back("--quiet");
  words.insert(words.end(), run.options.begin(), run.options.end());
  std::vector<char*> arguments;
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

/// The exit code of the next process that ends; of one that a signal ended 128 and its number, as shells have it.
std::pair<pid_t, int> wait_for_one() {
  int status = 0;
  const pid_t process = waitpid(-1, &status, 0);
  return {process, WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status)};
}

}  // namespace

bool run_children(std::vector<ChildRun>& runs, int at_once, const std::function<void(const ChildRun&)>& progress) {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (error) return false;
  std::map<pid_t, std::size_t> busy;
  bool all = true;
  for (std::size_t next = 0; next < runs.size() || !busy.empty();) {
    if (next < runs.size() && static_cast<int>(busy.size()) < at_once) {
      const pid_t process = start_child(runs[next], program);
      if (process < 0)
        all = false;
      else
        busy[process] = next;
      ++next;
      continue;
    }
    const auto [process, code] = wait_for_one();
    const auto ended = busy.find(process);
    if (process < 0) return false;
    if (ended == busy.end()) continue;
    runs[ended->second].exit_code = code;
    progress(runs[ended->second]);
    busy.erase(ended);
  }
  return all;
}

}  // namespace nugget::app
