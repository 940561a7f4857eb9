// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "deck/deck.hpp"

// Helpers of the deck's tests.
namespace nugget::deck {

inline std::string listed(const Findings& findings) {
  std::string s;
  for (const Finding& f : findings.all()) s += to_string(f) + '\n';
  return s;
}

/// A deck from text, with its findings.
struct Reading {
  explicit Reading(std::string text, const std::filesystem::path& directory = ".")
      : deck(read_text(std::move(text), findings, directory)) {}

  /// The block of that keyword, which must be there.
  const Block& block(std::string_view keyword) const {
    for (const Block& b : deck.blocks) {
      if (b.keyword == keyword) return b;
    }
    throw std::runtime_error("no block " + std::string(keyword));
  }
  Cursor cursor(std::string_view keyword) { return {deck, block(keyword), findings}; }
  Row row(std::string_view keyword, const Card& card) { return cursor(keyword).read(card); }

  Findings findings;
  Deck deck;
};

/// A folder of small files that goes with the test.
class Folder {
 public:
  Folder()
      : path(std::filesystem::temp_directory_path() /
             ("nugget_deck_" + std::to_string(::getpid()) + "_" + std::to_string(count_++))) {
    std::filesystem::create_directories(path);
  }
  ~Folder() { std::filesystem::remove_all(path); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  void write(const std::string& name, std::string_view text) const {
    std::filesystem::create_directories((path / name).parent_path());
    std::ofstream(path / name, std::ios::binary) << text;
  }

  const std::filesystem::path path;

 private:
  static inline int count_ = 0;
};

/// Exactly one finding, printed as given.
#define EXPECT_ONE_FINDING(findings, printed)                   \
  do {                                                          \
    ASSERT_EQ((findings).all().size(), 1u) << listed(findings); \
    EXPECT_EQ(to_string((findings).all()[0]), printed);         \
  } while (false)
#define EXPECT_CLEAN(findings) EXPECT_EQ(listed(findings), "")

}  // namespace nugget::deck
