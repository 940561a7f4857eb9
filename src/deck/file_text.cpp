// SPDX-License-Identifier: Apache-2.0
#include "deck/file_text.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <new>

namespace nugget::deck {
namespace {

class Descriptor {
 public:
  explicit Descriptor(const std::filesystem::path& path) : number(::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {}
  ~Descriptor() {
    if (number >= 0) ::close(number);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  const int number;
};

}  // namespace

FileText::~FileText() {
  if (mapped_ != nullptr) ::munmap(const_cast<char*>(mapped_), size_);
}

std::string FileText::open(const std::filesystem::path& path) {
  const Descriptor file(path);
  struct stat status {};
  if (file.number < 0 || ::fstat(file.number, &status) != 0) return std::strerror(errno);
  if (S_ISDIR(status.st_mode)) return "it is a folder";
  if (S_ISREG(status.st_mode)) {
    if (status.st_size == 0) return {};
    const auto size = static_cast<std::size_t>(status.st_size);
    void* const address = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE | MAP_POPULATE, file.number, 0);
    if (address == MAP_FAILED && errno == ENOMEM) throw std::bad_alloc();
    if (address == MAP_FAILED) return std::strerror(errno);
    mapped_ = static_cast<const char*>(address);
    size_ = size;
    return {};
  }
  std::array<char, 65536> piece;
  for (;;) {
    const ssize_t n = ::read(file.number, piece.data(), piece.size());
    if (n < 0) return std::strerror(errno);
    if (n == 0) return {};
    held_.append(piece.data(), static_cast<std::size_t>(n));
  }
}

}  // namespace nugget::deck
