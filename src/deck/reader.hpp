// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "deck/deck.hpp"
#include "deck/impl.hpp"

namespace nugget::deck {

/// Reads a master file and all its includes into a Deck, in reading order: cuts files into blocks (reader.cpp), opens
/// includes (include.cpp), defines parameters (parameter_cards.cpp) and, when all is read, transformations
/// (transform.cpp).
class Reader {
 public:
  /// `folder`: where relative names start from (the current folder of a run). `load_case`: 0: none.
  Reader(Deck& deck, Findings& findings, std::filesystem::path folder, int load_case);

  void read_master(const std::filesystem::path& path);
  void read_master_text(std::string text);

 private:
  /// One passage through one file.
  struct Visit {
    std::size_t file = 0;
    Format format = Format::standard;  ///< of keywords without a suffix
    const Transform* transform = nullptr;
    int depth = 1;               ///< the master file: 1
    std::filesystem::path path;  ///< as opened
  };

  // reader.cpp
  void run(Visit master);
  void read_file(Visit visit);
  void report_stray_text(const Visit& visit, int line);
  bool is_text(const Visit& visit);
  void warn_of_tabs(const Visit& visit);
  void begin(Block& block, std::string_view line, int number, const Visit& visit) const;
  void finish(Block& block, Visit& visit);
  void take_keyword_options(const Block& block, Visit& visit);
  void choose_case();
  void enter_or_leave_subcase(const Block& block, const Visit& visit);
  bool is_of_chosen_case() const;

  // include.cpp
  void include(const Block& block, const Visit& visit);
  void include_files(const Block& block, const Visit& visit);
  void include_path(const Block& block, const Visit& visit);
  void include_transform(const Block& block, const Visit& visit);
  std::string file_name(Cursor& cursor, const Block& block);
  void open(const std::string& name, const Place& place, const Block& block, const Visit& visit,
            const Transform* transform);
  std::vector<std::filesystem::path> search_folders(const Visit& visit) const;
  void warn_of_namesake(const std::filesystem::path& taken, const std::string& name, const Place& place,
                        const Block& block, const Visit& visit);

  // parameter_cards.cpp
  void parameters(const Block& block, const Visit& visit);
  void parameter_pairs(const Block& block, const Line& line, int depth);
  void parameter_expressions(const Block& block, int depth);
  /// Where the value of a parameter stands, see Parameter.
  struct ParameterCell {
    std::string_view cell;
    std::size_t width = 0;
    int depth = 0;
  };
  void define(const Block& block, const Line& line, std::string_view head, int column, std::string_view value,
              const ParameterCell& at);
  bool may_define(const Block& block, std::string_view name, const Parameter& parameter);
  void duplication(const Block& block);

  // transform.cpp
  void define_transformations();
  void resolve_transforms();

  /// A transform whose matrix is known only when every *DEFINE_TRANSFORMATION is.
  struct Pending {
    Transform* target;
    const Transform* outer;  ///< of the including file; null: none
    Transform own;
    int id;  ///< TRANID; 0: none
    Place place;
  };

  Deck& deck_;
  Findings& findings_;
  std::filesystem::path folder_;
  std::vector<std::filesystem::path> include_folders_;
  std::vector<std::filesystem::path> open_;  ///< canonical paths of the files being read, the master first
  std::vector<Pending> pending_;
  std::vector<Block> transformations_;
  int duplication_ = 0;  ///< DFLAG of *PARAMETER_DUPLICATION; 0: not given
  int load_case_;
  std::vector<int> subcases_;                          ///< of the chosen case
  std::vector<std::pair<int, Place>> begun_subcases_;  ///< whose end has not come yet
};

}  // namespace nugget::deck
