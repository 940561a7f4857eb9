// SPDX-License-Identifier: Apache-2.0
#include "report/packed_arrays.hpp"

#include <gmock/gmock.h>
#include <zlib.h>

#include <cstring>
#include <vector>

namespace nugget::report {
namespace {

/// RFC 4648, section 10.
TEST(Base64, IsThatOfTheStandard) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xff\xfe\xfd"), "//79");
}

std::string decoded(const std::string& text) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  for (std::size_t i = 0; i < text.size(); i += 4) {
    std::uint32_t group = 0;
    int count = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t digit = digits.find(text[i + k]);
      group = group << 6U | (digit == digits.npos ? 0U : static_cast<std::uint32_t>(digit));
      count += digit != digits.npos;
    }
    for (int k = 0; k + 1 < count; ++k) bytes += static_cast<char>(group >> (16 - 8 * k) & 255U);
  }
  return bytes;
}

TEST(PackedArrays, ListThenBytesByWeight) {
  PackedArrays arrays;
  arrays.about = {{"title", "two"}};
  arrays.add("ids", std::vector<std::uint16_t>{0x0102, 0x0304, 0x0100});
  arrays.add("values", std::vector<float>{1.0F, -2.0F});
  const std::string deflated = decoded(arrays.text());
  std::string plain(10000, '\0');
  uLongf size = plain.size();
  ASSERT_EQ(uncompress(reinterpret_cast<Bytef*>(plain.data()), &size, reinterpret_cast<const Bytef*>(deflated.data()),
                       deflated.size()),
            Z_OK);
  std::uint32_t length = 0;
  std::memcpy(&length, plain.data(), sizeof length);
  const auto list = nlohmann::json::parse(plain.substr(4, length));
  EXPECT_EQ(list["about"]["title"], "two");
  ASSERT_EQ(list["arrays"].size(), 2u);
  EXPECT_EQ(list["arrays"][0], nlohmann::json({{"name", "ids"}, {"type", "u16"}, {"count", 3}, {"differences", true}}));
  EXPECT_EQ(list["arrays"][1],
            nlohmann::json({{"name", "values"}, {"type", "f32"}, {"count", 2}, {"differences", false}}));
  // Differences 0x0102, 0x0202, -0x0204 = 0xfdfc: low bytes, high bytes. Then 1 and -2 as 3f800000 and c0000000.
  const std::string bytes = plain.substr(4 + length, size - 4 - length);
  EXPECT_EQ(bytes, std::string("\x02\x02\xfc\x01\x02\xfd\x00\x00\x00\x00\x80\x00\x3f\xc0", 14));
}

}  // namespace
}  // namespace nugget::report
