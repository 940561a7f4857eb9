// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <string>

namespace nugget::python {

/// While it lives, what the commands write for a terminal is kept as text: stdout and stderr of the C library stand for
/// it. Python's own output goes past them.
class TerminalText {
 public:
  TerminalText();
  ~TerminalText();
  TerminalText(const TerminalText&) = delete;
  TerminalText& operator=(const TerminalText&) = delete;

  /// What came so far, of both, in its order.
  const std::string& text() const { return text_; }

 private:
  std::string text_;
  std::FILE* file_;
  std::FILE* output_;
  std::FILE* errors_;
};

}  // namespace nugget::python
