// SPDX-License-Identifier: Apache-2.0
#include "report/packed_arrays.hpp"

#include <zlib.h>

#include <cstring>
#include <stdexcept>
#include <vector>

namespace nugget::report {

template <class T>
void PackedArrays::append_planes(std::span<const T> values) {
  const std::size_t first = bytes_.size(), count = values.size();
  bytes_.resize(first + count * sizeof(T));
  for (std::size_t i = 0; i < count; ++i) {
    char bytes[sizeof(T)];
    std::memcpy(bytes, &values[i], sizeof(T));
    for (std::size_t plane = 0; plane < sizeof(T); ++plane) bytes_[first + plane * count + i] = bytes[plane];
  }
}

template <class T>
void PackedArrays::add_whole(std::string name, const char* type, std::span<const T> values) {
  arrays_.push_back({{"name", std::move(name)}, {"type", type}, {"count", values.size()}, {"differences", true}});
  std::vector<T> differences(values.begin(), values.end());
  for (std::size_t i = differences.size(); i-- > 1;)
    differences[i] = static_cast<T>(differences[i] - differences[i - 1]);
  append_planes(std::span<const T>(differences));
}
template void PackedArrays::add_whole(std::string, const char*, std::span<const std::uint8_t>);
template void PackedArrays::add_whole(std::string, const char*, std::span<const std::uint16_t>);
template void PackedArrays::add_whole(std::string, const char*, std::span<const std::uint32_t>);

void PackedArrays::add(std::string name, std::span<const float> values) {
  arrays_.push_back({{"name", std::move(name)}, {"type", "f32"}, {"count", values.size()}, {"differences", false}});
  append_planes(values);
}

std::string PackedArrays::text() const {
  const std::string list = nlohmann::json{{"about", about}, {"arrays", arrays_}}.dump();
  const auto length = static_cast<std::uint32_t>(list.size());
  std::string plain(sizeof length, '\0');
  std::memcpy(plain.data(), &length, sizeof length);
  plain += list + bytes_;
  uLongf size = compressBound(plain.size());
  std::string deflated(size, '\0');
  constexpr int level = 6;
  if (compress2(reinterpret_cast<Bytef*>(deflated.data()), &size, reinterpret_cast<const Bytef*>(plain.data()),
                plain.size(), level) != Z_OK)
    throw std::runtime_error("zlib cannot compress the page's data");
  deflated.resize(size);
  return base64(deflated);
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8U | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k) text += k <= count ? digits[group >> (18U - 6U * k) & 63U] : '=';
  }
  return text;
}

}  // namespace nugget::report
