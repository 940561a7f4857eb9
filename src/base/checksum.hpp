// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>

namespace nugget {

/// FNV-1a of 64 bits: distinguishes texts and files that differ by accident, not by intent. `before`: of what stands
/// before. Source: G. Fowler, L. C. Noll, K.-P. Vo, http://www.isthe.com/chongo/tech/comp/fnv.
inline constexpr std::uint64_t checksum_of_nothing = 0xcbf29ce484222325;
inline std::uint64_t checksum(std::string_view bytes, std::uint64_t before = checksum_of_nothing) {
  std::uint64_t sum = before;
  for (const char c : bytes) sum = (sum ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return sum;
}

}  // namespace nugget
