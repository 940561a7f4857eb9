// SPDX-License-Identifier: Apache-2.0
#include "python/terminal_text.hpp"

#include <sys/types.h>

#include <cerrno>
#include <system_error>

namespace nugget::python {
namespace {

ssize_t append(void* cookie, const char* text, size_t size) {
  static_cast<std::string*>(cookie)->append(text, size);
  return static_cast<ssize_t>(size);
}

}  // namespace

TerminalText::TerminalText()
    : file_(fopencookie(&text_, "w", {nullptr, append, nullptr, nullptr})), output_(stdout), errors_(stderr) {
  if (file_ == nullptr) throw std::system_error(errno, std::generic_category(), "what a run prints cannot be kept");
  std::setvbuf(file_, nullptr, _IONBF, 0);
  stdout = stderr = file_;
}

TerminalText::~TerminalText() {
  stdout = output_;
  stderr = errors_;
  std::fclose(file_);
}

}  // namespace nugget::python
