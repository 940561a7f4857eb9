// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace nugget::report {

/// An HDF5 file, put together in memory by libhdf5; the same content gives the same bytes. Groups of a path are made
/// as they are needed. Members throw std::runtime_error where libhdf5 refuses, which it does for a name that is there.
class Hdf5File {
 public:
  Hdf5File();
  ~Hdf5File();
  Hdf5File(const Hdf5File&) = delete;
  Hdf5File& operator=(const Hdf5File&) = delete;

  void group(const std::string& path);
  /// A text beside a group or dataset that is there, UTF-8.
  void attribute(const std::string& path, const std::string& name, const std::string& text);
  void numbers(const std::string& path, std::span<const double> values);
  /// Row by row.
  void table(const std::string& path, std::span<const double> values, std::size_t rows, std::size_t columns);
  void whole_numbers(const std::string& path, std::span<const std::int32_t> values);
  void texts(const std::string& path, const std::vector<std::string>& values);

  /// The file.
  std::string bytes() const;

 private:
  std::int64_t file_;  // libhdf5's hid_t
};

}  // namespace nugget::report
