// SPDX-License-Identifier: Apache-2.0
#include "app/terminal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>

#include "app/commands.hpp"

namespace nugget::app {
namespace {

struct Stream {
  int descriptor;
  const char* name;
  int fault = 0;  ///< errno of the first write that failed
};
Stream output{STDOUT_FILENO, "standard output"}, errors{STDERR_FILENO, "standard error"};

/// Says that all was written: fmt throws where it was not, and the run is worth more than its progress line.
ssize_t write_or_drop(void* cookie, const char* text, size_t size) {
  auto& stream = *static_cast<Stream*>(cookie);
  for (size_t done = 0; done < size && stream.fault == 0;) {
    const ssize_t written = ::write(stream.descriptor, text + done, size - done);
    if (written > 0)
      done += static_cast<size_t>(written);
    else if (written == 0 || errno != EINTR)
      stream.fault = written == 0 ? EIO : errno;
  }
  return static_cast<ssize_t>(size);
}

FILE* guarded(Stream& stream, FILE* plain, int buffering) {
  FILE* const file = fopencookie(&stream, "w", {nullptr, write_or_drop, nullptr, nullptr});
  if (file == nullptr) return plain;
  std::setvbuf(file, nullptr, buffering, BUFSIZ);
  return file;
}

}  // namespace

void guard_terminal() {
  // A closed one would be given to the next file that is opened, and take what was meant for the terminal.
  while (true) {
    const int free = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
    if (free > STDERR_FILENO) ::close(free);
    if (free < 0 || free > STDERR_FILENO) break;
  }
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  stdout = guarded(output, stdout, isatty(STDOUT_FILENO) != 0 ? _IOLBF : _IOFBF);
  stderr = guarded(errors, stderr, _IONBF);
}

int code_after_terminal(int code) {
  std::fflush(stdout);
  bool lost = false;
  for (const Stream& stream : {output, errors}) {
    if (stream.fault == 0 || stream.fault == EPIPE) continue;
    lost = true;
    fmt::print(stderr, "nugget: cannot write to {}: {}\n", stream.name, std::strerror(stream.fault));
  }
  return lost && code == 0 ? static_cast<int>(ExitCode::cannot_write) : code;
}

}  // namespace nugget::app
