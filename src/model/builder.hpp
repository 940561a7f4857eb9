// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "deck/deck.hpp"
#include "model/model.hpp"

// How a Deck becomes a Model. Keywords may come in any order, so reading has two halves: each keyword's reader takes its cards
// and, where ids have to be looked up, leaves a closure behind that runs in its phase, when all that it needs is known.
namespace nugget::model {

/// The order in which closures run. Within a phase: in deck order.
enum class Phase {
  curves,      ///< curves, tables, coordinate systems that need no nodes
  mesh,        ///< nodes and elements sorted, ids known
  parts,       ///< sections, materials, hourglass linked to parts; element thickness
  systems,     ///< coordinate systems that need nodes
  sets,        ///< all sets resolved
  bodies,      ///< rigid bodies
  conditions,  ///< SPCs, motions, loads, initial velocities, walls, contacts, requests
  checks,      ///< what only the whole model can tell
};

/// Ids of one name space: user id to index, and where it was defined (for duplicates).
class Ids {
 public:
  /// False (and a finding) if the id is taken.
  bool add(int id, Index index, const Place& place, std::string_view keyword, std::string_view what, Findings& findings);
  Index find(int id) const;  ///< none where absent

 private:
  struct Entry {
    Index index;
    Place place;
  };
  std::unordered_map<int, Entry> entries_;
};

class Builder {
 public:
  Builder(const deck::Deck& deck, Findings& findings) : deck(deck), findings(findings) {}

  const deck::Deck& deck;
  Findings& findings;
  Model model;

  Ids nodes, shells, solids, beams, parts, shell_sections, solid_sections, beam_sections, materials, hourglass, curves, tables,
      systems, vectors, boxes;
  Ids node_sets, part_sets, segment_sets, shell_sets, solid_sets, beam_sets;

  void later(Phase phase, std::function<void(Builder&)> work) { work_[static_cast<std::size_t>(phase)].push_back(std::move(work)); }
  void run(Phase phase);

  // Look-ups that make a finding ("... is not defined") at the row's field where the id is unknown. Id 0 gives none, silently.
  Index node(const deck::Row& row, std::string_view field);
  Index part(const deck::Row& row, std::string_view field);
  Index curve(const deck::Row& row, std::string_view field);
  const Set<Index>* node_set(const deck::Row& row, std::string_view field);
  const Set<Index>* part_set(const deck::Row& row, std::string_view field);

 private:
  std::array<std::vector<std::function<void(Builder&)>>, 8> work_;
};

/// The options found behind a keyword's base name, e.g. {"TITLE"} of MAT_SPOTWELD_TITLE.
using Options = std::set<std::string, std::less<>>;

/// One line of a keyword's layout for `nugget keywords`.
struct LayoutCard {
  std::string_view when;  ///< empty: always; else e.g. "with _ID", "if DMGOPT = -1"
  const Card* card;
};

/// A row of the list of keywords: all that this program knows of it.
struct Keyword {
  std::string_view name;                   ///< canonical, no star: MAT_PIECEWISE_LINEAR_PLASTICITY
  std::vector<std::string_view> aliases;   ///< MAT_024
  std::vector<std::string_view> options;   ///< suffixes it takes, each alone or with others: TITLE, ID, MPP
  Verdict verdict = Verdict::used;
  std::string_view why;                    ///< ignored: why that does no harm; refused: what is missing and what to do instead
  std::vector<LayoutCard> layout;
  void (*read)(Builder&, const deck::Block&, const Options&) = nullptr;
};

/// All keywords, in one explicit list (keywords.cpp), family by family.
std::span<const Keyword> keywords();
/// The row that a deck's keyword belongs to by longest match, and its options; null where unknown.
const Keyword* find_keyword(std::string_view written, Options& options);

/// Turns a deck into a model. Unknown and refused keywords are errors (with `skip_unsupported`: warnings, their cards left out);
/// unknown *DATABASE_ requests are warnings. All findings come at once; the model is usable only if there are no errors.
Model build(const deck::Deck& deck, Findings& findings, bool skip_unsupported = false);

}  // namespace nugget::model
