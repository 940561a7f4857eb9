// SPDX-License-Identifier: Apache-2.0
#include "output/result_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

namespace nugget::output {
namespace {

std::string last_error() {
  return std::generic_category().message(errno);
}

}  // namespace

ResultFile::ResultFile(std::filesystem::path path, OpenMode mode) : path_(std::move(path)) {
  if (mode == OpenMode::draft) ::unlink(path_.c_str());
  const int how = mode == OpenMode::create ? O_CREAT | O_TRUNC : mode == OpenMode::draft ? O_CREAT | O_EXCL : 0;
  descriptor_ = ::open(path_.c_str(), O_WRONLY | how | O_CLOEXEC, 0666);
  if (descriptor_ >= 0) return;
  if (mode == OpenMode::append && errno == ENOENT)
    throw ArchiveError(path_.string() + " is gone, which the interrupted run had begun");
  throw WriteError(path_, last_error());
}

ResultFile::~ResultFile() {
  close();
}

ResultFile::ResultFile(ResultFile&& other) noexcept
    : path_(std::move(other.path_)),
      buffer_(std::move(other.buffer_)),
      size_(other.size_),
      ahead_(other.ahead_),
      descriptor_(std::exchange(other.descriptor_, -1)) {}

ResultFile& ResultFile::operator=(ResultFile&& other) noexcept {
  if (this == &other) return *this;
  close();
  path_ = std::move(other.path_);
  buffer_ = std::move(other.buffer_);
  size_ = other.size_;
  ahead_ = other.ahead_;
  descriptor_ = std::exchange(other.descriptor_, -1);
  return *this;
}

void ResultFile::close() noexcept {
  if (descriptor_ >= 0) ::close(descriptor_);
  descriptor_ = -1;
}

void ResultFile::commit() {
  flush();
  size_ += ahead_;
  ahead_ = 0;
  expect_in_place();
}

void ResultFile::flush() {
  write_ahead(size_ + ahead_, buffer_);
  ahead_ += buffer_.size();
  buffer_.clear();
}

std::uint64_t ResultFile::leave_room(std::uint64_t bytes) {
  flush();
  const std::uint64_t begin = size_ + ahead_;
  ahead_ += bytes;
  return begin;
}

void ResultFile::write_at(std::uint64_t offset, std::string_view bytes) {
  size_ = std::max(size_, put(offset, bytes));
}

void ResultFile::write_ahead(std::uint64_t offset, std::string_view bytes) {
  put(offset, bytes);
}

std::uint64_t ResultFile::put(std::uint64_t offset, std::string_view bytes) {
  std::uint64_t position = offset;
  for (std::string_view rest = bytes; !rest.empty();) {
    const ssize_t written = ::pwrite(descriptor_, rest.data(), rest.size(), static_cast<off_t>(position));
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) {
      const std::string reason = written < 0 ? last_error() : "nothing was written";
      ahead_ = 0;
      // Best effort: the error that counts is the one above.
      if (::ftruncate(descriptor_, static_cast<off_t>(size_)) != 0) errno = 0;
      throw WriteError(path_, reason);
    }
    rest.remove_prefix(static_cast<std::size_t>(written));
    position += static_cast<std::uint64_t>(written);
  }
  return position;
}

void ResultFile::expect_in_place() const {
  struct stat now {};
  if (::fstat(descriptor_, &now) != 0) throw WriteError(path_, last_error());
  if (now.st_nlink == 0) throw WriteError(path_, "the file was removed while the run wrote to it");
}

void ResultFile::sync() {
  if (::fdatasync(descriptor_) != 0) throw WriteError(path_, last_error());
}

void ResultFile::archive(Archive& a) {
  if (!a.reading()) sync();
  a(size_);
  a.built(path_, buffer_, ahead_, descriptor_);
  if (!a.reading()) return;
  struct stat now {};
  if (::fstat(descriptor_, &now) != 0) throw WriteError(path_, last_error());
  if (static_cast<std::uint64_t>(now.st_size) < size_)
    throw ArchiveError(path_.string() + " has " + std::to_string(now.st_size) + " bytes, fewer than the " +
                       std::to_string(size_) + " that it had when the restart file was written");
  if (::ftruncate(descriptor_, static_cast<off_t>(size_)) != 0) throw WriteError(path_, last_error());
}

void write_whole_file(const std::filesystem::path& path, std::string_view text) {
  write_whole_file(path, [text](ResultFile& file) {
    file.buffer() = text;
    file.commit();
  });
}

void write_whole_file(const std::filesystem::path& path, const std::function<void(ResultFile&)>& write) {
  const std::filesystem::path draft = path.string() + ".part";
  std::error_code ignored;
  try {
    ResultFile file(draft, OpenMode::draft);
    write(file);
  } catch (const WriteError& error) {
    std::filesystem::remove(draft, ignored);
    throw WriteError(path, error.reason);
  }
  std::error_code error;
  std::filesystem::rename(draft, path, error);
  if (error) {
    std::filesystem::remove(draft, ignored);
    throw WriteError(path, error.message());
  }
}

}  // namespace nugget::output
