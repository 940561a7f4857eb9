// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/card.hpp"
#include "base/finding.hpp"
#include "base/vec3.hpp"
#include "deck/cases.hpp"

// LS-DYNA keyword text as blocks of data lines, and the means to read them by card tables. No physics in here.
namespace nugget::deck {

enum class Format { standard, i10, long_format };

/// What *INCLUDE_TRANSFORM does to the ids and values of an included file (composed over nested includes).
struct Transform {
  std::array<long, 9> id_offset{};                                    ///< by IdSpace
  double mass = 1.0, length = 1.0, time = 1.0;                        ///< unit factors
  std::array<double, 12> matrix{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};  ///< rows of [A | b]: x' = A x + b
  /// Columns of R of A = R S, S symmetric and positive: a rotation, of a matrix that mirrors a rotation and a mirror.
  Frame3d turn{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  bool mirrors_systems = false;           ///< A7 of MIRROR: coordinate systems become left-handed
  Vec3d point(const Vec3d& x) const;      ///< a position as written: scaled to the new unit, then moved
  Vec3d moved(const Vec3d& x) const;      ///< a position already in the new unit (read as a length by a Row): moved
  Vec3d written(const Vec3d& x) const;    ///< the position that `point` brings to `x`
  Vec3d direction(const Vec3d& d) const;  ///< a direction or a velocity: turned, neither moved nor scaled
  bool turns() const;                     ///< the matrix changes directions
  bool mirrors() const;                   ///< it turns right hands into left ones: elements are numbered the other way
  bool keeps_axes() const;                ///< each global axis stays along its own line, whatever its sense
  bool scales() const;                    ///< it is more than a turn and a shift
  bool changes_units() const { return mass != 1.0 || length != 1.0 || time != 1.0; }
  double factor(const Dimension& d) const;  ///< of a value with this dimension
};

/// One data line: comments are gone, blank lines stay (a blank line is a card of defaults).
struct Line {
  std::string_view text;  ///< without its line end; parameters are not yet replaced
  int number = 0;         ///< in its file, from 1
};

/// One keyword with its data lines, up to the next keyword.
struct Block {
  std::string keyword;  ///< upper case, no star, no format suffix, no text behind it: `MAT_SPOTWELD_TITLE`
  Place place;          ///< of the keyword line
  Format format = Format::standard;
  const Transform* transform = nullptr;  ///< null: none
  std::size_t file = 0;                  ///< which file; see Deck
  std::size_t scope = 0;                 ///< which parameters are visible; see Deck
  std::vector<Line> lines;  ///< bulk blocks (NODE, ELEMENT_...) leave this empty; their raw text is in `bulk`
  std::string_view bulk;    ///< raw text of a bulk block from the line after the keyword, comments included
  int bulk_line = 0;        ///< number of the first line of `bulk`

  /// `keyword` with its star, for messages.
  std::string starred() const { return '*' + keyword; }
};

/// A deck, read: every include opened, every parameter defined, nothing interpreted. Owns the text of all files.
class Deck {
 public:
  Deck();
  ~Deck();
  Deck(Deck&&) noexcept;
  Deck& operator=(Deck&&) noexcept;

  std::filesystem::path path;      ///< the master file
  std::vector<std::string> files;  ///< as they appear in findings, in reading order
  std::vector<Block>
      blocks;  ///< in reading order; KEYWORD, END, INCLUDE..., PARAMETER..., DEFINE_TRANSFORMATION are consumed
  std::vector<std::pair<std::string, Place>> consumed;  ///< those, for the table of keywords (keyword as in Block)
  std::size_t bytes = 0;                                ///< of all files
  /// A file opened by the line of an *INCLUDE...; once for each time that it is.
  struct Inclusion {
    std::size_t from = 0;  ///< the file of the line, in `files`
    int line = 0;          ///< the first one of the file's name
    std::size_t file = 0;  ///< that was opened
  };
  std::vector<Inclusion> inclusions;  ///< in reading order
  std::vector<Case> cases;            ///< *CASE, all of them

  /// Called for each data line as it is read by a card's table: its block, its index in Block::lines, the card. A line
  /// of a bulk table comes in a block of the reader's own. Empty: not called.
  std::function<void(const Block&, std::size_t, const Card&)> card_read;
  bool reports_bulk_lines = false;  ///< of lines of bulk tables too, which are read slowly then

  /// *DEFINE_TRANSFORMATION by its id (id_offset and unit factors of the result say nothing); null where there is none.
  const Transform* transformation(int id) const;

  struct Impl;
  std::unique_ptr<Impl> impl;  ///< file buffers, parameters, transforms
};

/// Reads the master file and all it includes. Bad input becomes findings; a deck with errors may still be looked at.
/// `load_case`: the *CASE that is read; 0: none, which is an error where the deck has some.
Deck read(const std::filesystem::path& master, Findings& findings, int load_case = 0);
/// The same from memory (tests, fuzzing). Includes are looked up relative to `directory`.
Deck read_text(std::string text, Findings& findings, const std::filesystem::path& directory = ".", int load_case = 0);
/// The cases of a master file; none where it cannot be read.
std::vector<Case> cases(const std::filesystem::path& master);

/// What stands in one field of a card, for what is looked up by it and for findings about it.
struct Entry {
  Entry();  // these are long, and made in many places: out of line
  Entry(const Entry&);
  Entry(Entry&&) noexcept;
  Entry& operator=(const Entry&);
  Entry& operator=(Entry&&) noexcept;
  ~Entry();

  std::string keyword;     ///< that the card belongs to, with its star
  std::string_view field;  ///< its name
  std::string text;        ///< as written, trimmed
  double value = 0.0;      ///< of a number
  bool blank = true;       ///< the field is blank (or the line ended before it, or the card is missing)
  bool refused = false;    ///< it could not be read, which was said: further errors about it are not
  Place place;             ///< with its column

  int integer() const { return static_cast<int>(value); }
  /// Writes a finding: `keyword` field = text: what is wrong [remedy]. Not where the field could not be read: the value
  /// that stands for it is none of the deck's.
  void report(Findings& findings, Severity severity, std::string_view what, std::string_view remedy = {}) const;
};

/// One card, read by its table: numbers checked, defaults filled in, ids and units transformed.
class Row {
 public:
  Row();  // likewise out of line
  Row(const Row&);
  Row(Row&&) noexcept;
  Row& operator=(const Row&);
  Row& operator=(Row&&) noexcept;
  ~Row();

  Place place() const { return place_; }                  ///< of the line
  std::string keyword() const { return '*' + keyword_; }  ///< that the card belongs to, for messages

  /// What stands in the field of that name, for tables that are bound to no members. Throws std::logic_error for a name
  /// that the card does not have: a fault of the program, not of the deck.
  Entry entry(std::string_view name) const;

 protected:
  /// Of the field that is bound to the member there; std::logic_error where none is.
  Entry entry_of(std::ptrdiff_t offset) const;
  bool has_field_of(std::ptrdiff_t offset) const;

 private:
  friend class Cursor;
  struct Cell {
    double value = 0.0;
    std::string text;
    bool blank = true, refused = false;
    int column = 1;
  };
  Entry entry_at(std::size_t field) const;
  void store(std::byte* object) const;
  const Card* card_ = nullptr;
  std::vector<Cell> cells_;
  Place place_;
  std::string keyword_;
};

/// A card read into the members that its fields are bound to: `row->type` is the value, `row[&Hourglass::type]` the
/// field as it stands in the deck.
template <class T>
class RowOf : public Row {
 public:
  const T& operator*() const { return values_; }
  const T* operator->() const { return &values_; }
  /// Whether the card has a field for the member.
  bool has(double T::*member) const { return has_field_of(offset_of(member)); }
  Entry operator[](double T::*member) const { return entry_of(offset_of(member)); }
  Entry operator[](int T::*member) const { return entry_of(offset_of(member)); }
  Entry operator[](bool T::*member) const { return entry_of(offset_of(member)); }
  Entry operator[](std::string T::*member) const { return entry_of(offset_of(member)); }
  template <class Choice, class Base>
  requires std::is_enum_v<Choice> && std::is_base_of_v<Base, T> Entry operator[](Choice Base::*member) const {
    return entry_of(offset_of<T, Choice>(member));
  }

 private:
  friend class Cursor;
  T values_{};
};

/// Goes through the data lines of a block, card by card.
class Cursor {
 public:
  Cursor(const Deck& deck, const Block& block, Findings& findings);

  bool more() const;         ///< a data line is left; blank lines at the end of a block do not count
  std::size_t left() const;  ///< how many, without the blank lines at the end
  /// The next line by `card`. At the end of the block: a row of defaults (an error where a field is required).
  Row read(const Card& card);
  template <class T>
  RowOf<T> read(const CardOf<T>& card) {
    RowOf<T> row;
    read_members(row, card, reinterpret_cast<std::byte*>(&row.values_));
    return row;
  }
  /// The same into an object that is there already: the members without a field keep their values.
  template <class T>
  RowOf<T> read(const CardOf<T>& card, T& into) {
    RowOf<T> row;
    row.values_ = into;
    read_members(row, card, reinterpret_cast<std::byte*>(&row.values_));
    into = row.values_;
    return row;
  }
  /// The next line whole, blanks trimmed, parameters replaced (titles, file names). A `&name` that is no parameter
  /// stays as it is and is listed in `unknown`.
  std::string read_text(std::vector<std::string>* unknown = nullptr);
  /// The next line as it stands, parameters replaced, without consuming it.
  std::string peek() const;
  /// One number of the next line without consuming it: field `index` of width-10 fields (to choose a card's form).
  double peek_number(std::size_t index) const;
  void skip();
  /// All remaining lines as lists of integers, `per_line` fields each (8 ids a line); blanks and zeros left out.
  std::vector<int> read_ids(IdSpace space, int per_line = 8);
  Place place() const;  ///< of the next line
  const Block& block() const { return block_; }

 private:
  void read_cells(Row& row, const Card& card);
  void read_members(Row& row, const Card& card, std::byte* object);
  void fill_missing(Row& row);
  void fill(Row& row, std::size_t field, std::string_view text);
  void fill_text(Row& row, std::size_t field, std::string_view text);
  double transformed_id(double id, IdSpace space) const;
  void report_surplus(std::string_view text, int column);

  const Deck& deck_;
  const Block& block_;
  Findings& findings_;
  std::size_t next_ = 0;
  bool surplus_reported_ = false;  // text behind the last field: one warning a keyword
};

// ---- bulk tables: the fast path. Rows are appended; `line` is the line number in the block's file.

struct NodeTable {
  std::vector<int> id;
  std::vector<Vec3d> x;
  std::vector<signed char> tc, rc;  ///< *NODE's own constraint codes 0..7
  std::vector<int> line;
  std::vector<int> file;  ///< index into Deck::files
};
/// *NODE (also the NODE_TRANSFORM'ed coordinates when the block has a transform).
void read_nodes(const Deck& deck, const Block& block, NodeTable& out, Findings& findings);

/// Element rows of all kinds. `node` has `nodes_per_element` entries a row, 0 where none is given.
struct ElementTable {
  int nodes_per_element = 0;
  std::vector<int> id, part;
  std::vector<int> node;
  std::vector<int> line, file;
  // By option; empty or as long as `id` (0 where a row has none, where nothing else is said).
  std::vector<std::array<double, 4>> thickness;    ///< shells: THIC1..4
  std::vector<double> angle;                       ///< shells: BETA in degrees, NaN where blank
  std::vector<int> system;                         ///< shells: MCID
  std::vector<double> offset;                      ///< shells: OFFSET, NaN where none is given
  std::vector<char> to_ten;                        ///< solids: of _TET4TOTET10
  std::vector<char> thick;                         ///< solids: 1 of *ELEMENT_TSHELL
  std::vector<char> mirrored;                      ///< 1: of a file that is mirrored; nodes stand renumbered here
  std::vector<std::array<int, 2>> tied_parts;      ///< beams: PID1, PID2 of _PID
  std::vector<std::array<double, 3>> orientation;  ///< beams: _ORIENTATION
  std::vector<std::array<double, 5>> section;      ///< beams: _THICKNESS PARM1..5
};
/// *ELEMENT_SHELL with THICKNESS, BETA, MCID, OFFSET, DOF; up to 8 nodes.
void read_shells(const Deck& deck, const Block& block, ElementTable& out, Findings& findings);
/// *ELEMENT_SOLID one-line and two-line, ORTHO, DOF, TET4TOTET10; up to 10 nodes.
void read_solids(const Deck& deck, const Block& block, ElementTable& out, Findings& findings);
/// *ELEMENT_TSHELL: eight nodes, those of wedges as 1 2 3 3 5 6 7 7; into the table of solids.
void read_thick_shells(const Deck& deck, const Block& block, ElementTable& out, Findings& findings);
/// *ELEMENT_BEAM with THICKNESS, PID, OFFSET, ORIENTATION; nodes N1 N2 N3.
void read_beams(const Deck& deck, const Block& block, ElementTable& out, Findings& findings);

// The tables by which the readers above read, for `nugget keywords`.
const Card& node_card();
const Card& shell_card();
const Card& shell_thickness_card();
const Card& shell_offset_card();
const Card& solid_card();
const Card& thick_shell_card();
const Card& beam_card();
const Card& beam_parts_card();
const Card& beam_orientation_card();

}  // namespace nugget::deck
