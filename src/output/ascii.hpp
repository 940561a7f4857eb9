// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/append.hpp"
#include "base/vec3.hpp"
#include "output/result_file.hpp"

namespace nugget::output {

/// What stands at the head of every history file. Without a date, equal runs give equal bytes.
struct Header {
  std::string title;    ///< of the deck; 72 characters are written
  std::string version;  ///< of this program, e.g. `nugget 0.1.0`
  std::string date;     ///< mm/dd/yyyy
  OpenMode mode = OpenMode::create;
};

/// A line of the legend: the heading of an entity in the history files.
struct LegendEntry {
  int id = 0;
  std::string heading;
};

/// Title and version lines as LS-DYNA writes them (seen in the real `glstat` of R14 and `swforc` of R13).
std::string title_lines(const Header& header);

/// `{BEGIN LEGEND}` ... `{END LEGEND}`; two empty lines where there is nothing to say.
std::string legend_lines(std::span<const LegendEntry> legend);

/// A number for a column of `%n.mE`: too small for two digits of exponent counts as zero, else columns would grow
/// together.
inline double column(double value) {
  return value > -1e-99 && value < 1e-99 ? 0.0 : value;
}

/// Text cut or filled with blanks to `width` characters.
std::string fixed_width(const std::string& text, std::size_t width);

/// An ASCII history file: title, what comes before the first state, then states that reach the disk whole.
class AsciiFile {
 public:
  AsciiFile(std::filesystem::path path, const Header& header, const std::string& rest_of_head = "")
      : file_(std::move(path), header.mode) {
    if (header.mode == OpenMode::append) return;
    file_.buffer() = title_lines(header) + rest_of_head;
    file_.commit();
  }

  template <class... Args>
  void print(fmt::format_string<Args...> format, Args&&... args) {
    append(file_.buffer(), format, std::forward<Args>(args)...);
  }
  void print_vector(const Vec3d& v) { print("{:12.4E}{:12.4E}{:12.4E}", column(v.x), column(v.y), column(v.z)); }
  void print_text(std::string_view text) { file_.buffer() += text; }
  void end_state() { file_.commit(); }
  /// Within a long state: what was printed goes to the disk, once it is much, and counts with the rest.
  void end_part() {
    if (file_.buffer().size() >= part_of_text) file_.flush();
  }
  void archive(Archive& a) { a(file_); }

 private:
  ResultFile file_;
};

}  // namespace nugget::output
