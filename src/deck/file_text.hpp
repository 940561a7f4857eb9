// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace nugget::deck {

/// The text of one file: memory-mapped, or held in a string. Its address does not change while it lives.
class FileText {
 public:
  FileText() = default;
  explicit FileText(std::string text) : held_(std::move(text)) {}
  ~FileText();
  FileText(const FileText&) = delete;
  FileText& operator=(const FileText&) = delete;

  /// Opens a regular file, or reads a pipe to its end. Returns what went wrong, or nothing; throws std::bad_alloc.
  std::string open(const std::filesystem::path& path);

  std::string_view view() const {
    return mapped_ != nullptr ? std::string_view(mapped_, size_) : std::string_view(held_);
  }

 private:
  const char* mapped_ = nullptr;
  std::size_t size_ = 0;
  std::string held_;
};

}  // namespace nugget::deck
