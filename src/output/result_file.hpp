// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "base/archive.hpp"

namespace nugget::output {

/// A result that cannot be written: disk full, no permission, no such folder. The program ends with exit code 4; what
/// was committed before stays readable.
struct WriteError : std::runtime_error {
  WriteError(std::filesystem::path where, const std::string& why)
      : std::runtime_error("cannot write " + where.string() + ": " + why), path(std::move(where)), reason(why) {}
  std::filesystem::path path;
  std::string reason;  ///< the operating system's words
};

/// Whether a result is begun, or one that an interrupted run has left is continued.
enum class OpenMode {
  create,
  draft,  ///< begun anew, whatever stood there; a link there is not followed
  append
};

/// A file that grows by whole states. What is put into `buffer()` reaches the disk at `commit()`, at once, so that a
/// killed run leaves complete states; a commit that fails cuts the file back to the last good one and throws
/// WriteError; so does one whose file was removed meanwhile, since nobody would find what goes into it.
class ResultFile {
 public:
  /// Creates the file, or empties the one that is there; throws WriteError. To append, takes it as it is, and `archive`
  /// has to say how much of it counts; throws ArchiveError where there is none.
  explicit ResultFile(std::filesystem::path path, OpenMode mode = OpenMode::create);
  ~ResultFile();
  ResultFile(ResultFile&& other) noexcept;
  ResultFile& operator=(ResultFile&& other) noexcept;
  ResultFile(const ResultFile&) = delete;
  ResultFile& operator=(const ResultFile&) = delete;

  /// Text or bytes that the next commit() appends.
  std::string& buffer() { return buffer_; }
  void commit();

  /// A long state goes to the disk in parts: `flush` writes the buffer behind the parts before it, `leave_room` leaves
  /// room there for `write_ahead`. Nothing of it counts before the next commit(), and is cut off if anything fails.
  void flush();
  /// Where the next byte of the buffer will stand.
  std::uint64_t end() const { return size_ + ahead_ + buffer_.size(); }
  /// Writes what the buffer holds, and leaves room for so many bytes; returns where it begins.
  std::uint64_t leave_room(std::uint64_t bytes);
  /// Writes bytes at a place of their own that do not count yet.
  void write_ahead(std::uint64_t offset, std::string_view bytes);
  /// What was written ahead up to there counts from now on.
  void count_up_to(std::uint64_t size) { size_ = size; }

  /// Writes bytes at a place of their own, at once; past the end of the file it grows. Throws WriteError.
  void write_at(std::uint64_t offset, std::string_view bytes);

  /// Waits until the disk has it all, so that a restart file that counts on it survives a power failure.
  void sync();
  /// Keeps the size; reading, what was written later is cut off. Throws ArchiveError where the file is shorter.
  void archive(Archive& a);

  /// Bytes on the disk.
  std::uint64_t size() const { return size_; }
  const std::filesystem::path& path() const { return path_; }

 private:
  void close() noexcept;
  void expect_in_place() const;
  /// Returns where the bytes end.
  std::uint64_t put(std::uint64_t offset, std::string_view bytes);

  std::filesystem::path path_;
  std::string buffer_;
  std::uint64_t size_ = 0;
  std::uint64_t ahead_ = 0;  ///< bytes of the state that is being written, behind those that count
  int descriptor_ = -1;
};

/// Replaces a whole file by `text`: a reader sees the old content or the new, never a half. Throws WriteError.
void write_whole_file(const std::filesystem::path& path, std::string_view text);
/// Bytes of a long text that are put together before they are committed.
inline constexpr std::size_t part_of_text = std::size_t{1} << 20;
/// The same of a long text: `write` puts it into the buffer and commits it, part by part.
void write_whole_file(const std::filesystem::path& path, const std::function<void(ResultFile&)>& write);

}  // namespace nugget::output
