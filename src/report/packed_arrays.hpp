// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

namespace nugget::report {

/// Named arrays of numbers as text for a page: small, since neighbours that are alike become small differences and
/// bytes of equal weight stand together before they are deflated. web/src/packed_arrays.js reads them.
///
/// Layout before deflating: bytes of the list [uint32], the list as JSON `{"about": ..., "arrays": [{"name", "type",
/// "count", "differences"}]}`, then each array: its lowest bytes, ..., its highest bytes. Types: u8, u16, u32, f32.
class PackedArrays {
 public:
  /// What the page is told beside the arrays.
  nlohmann::json about;

  /// Whole numbers whose neighbours are alike: kept as differences of successive ones.
  void add(std::string name, std::span<const std::uint8_t> values) { add_whole(std::move(name), "u8", values); }
  void add(std::string name, std::span<const std::uint16_t> values) { add_whole(std::move(name), "u16", values); }
  void add(std::string name, std::span<const std::uint32_t> values) { add_whole(std::move(name), "u32", values); }
  void add(std::string name, std::span<const float> values);

  /// zlib's stream in base64.
  std::string text() const;

 private:
  template <class T>
  void add_whole(std::string name, const char* type, std::span<const T> values);
  template <class T>
  void append_planes(std::span<const T> values);

  nlohmann::json arrays_ = nlohmann::json::array();
  std::string bytes_;
};

/// RFC 4648, with padding.
std::string base64(std::string_view bytes);

}  // namespace nugget::report
