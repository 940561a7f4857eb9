// SPDX-License-Identifier: Apache-2.0
#include "reading/build.hpp"

#include <fmt/format.h>

#include <string_view>
#include <unordered_map>

#include "reading/bodies/rigid_bodies.hpp"
#include "reading/bodies/weld_numbers.hpp"
#include "reading/builder/builder.hpp"
#include "reading/builder/mirrored_files.hpp"
#include "reading/builder/passes.hpp"
#include "reading/builder/repeated_cards.hpp"
#include "reading/cards/fabric_leakage.hpp"
#include "reading/describe.hpp"
#include "reading/mesh/brick_clusters.hpp"
#include "reading/mesh/interpolation_spotwelds.hpp"

namespace nugget::reading {

namespace {

/// The table of keywords while it is being written: one entry a keyword, in order of first appearance.
class KeywordSummary {
 public:
  explicit KeywordSummary(std::vector<KeywordUse>& entries) : entries_(entries) {}

  /// True for the first appearance.
  bool add(const std::string& keyword, KeywordStatus status, std::string_view why, const Place& place) {
    const auto [at, is_new] = index_.try_emplace(keyword, entries_.size());
    if (is_new) entries_.push_back({keyword, 0, status, std::string(why), place});
    ++entries_[at->second].count;
    return is_new;
  }

 private:
  std::vector<KeywordUse>& entries_;
  std::unordered_map<std::string, std::size_t> index_;
};

/// The status of one block, and its reader and options where it is used.
struct KeywordLookup {
  KeywordStatus status = KeywordStatus::refused;
  std::string why;
  bool harmless = false;  ///< refused, but only an output is missing
  const Keyword* row = nullptr;
  Options options;
};

KeywordLookup classify(const std::string& keyword) {
  KeywordLookup lookup;
  lookup.row = find_keyword(keyword, lookup.options);
  lookup.harmless = keyword.starts_with("DATABASE_");
  if (lookup.row) {
    lookup.status = lookup.row->status;
    lookup.why = lookup.row->why;
    const std::string_view name = lookup.row->name;
    const bool advises = lookup.why.find(';') != std::string::npos;
    if (lookup.status == KeywordStatus::refused && name.ends_with("_*") && !advises)
      if (const std::string built = built_of_family(name.substr(0, name.size() - 1)); !built.empty())
        lookup.why += "; " + built;
  } else if (const Keyword* base = nearest_keyword(keyword)) {
    lookup.why =
        keyword.starts_with("MAT_")  // *MAT_ELASTIC_PLASTIC_HYDRO is no form of *MAT_ELASTIC
            ? fmt::format(
                  "this material, or this form of *{}, is not built; `nugget keywords MAT_` lists what is built",
                  base->name)
            : fmt::format("this form of *{} is not supported", base->name);
  } else {
    lookup.why = lookup.harmless ? "this output is not written" : "not a keyword that this program knows";
  }
  return lookup;
}

/// A slip of the pen is likely only where no row names the keyword, or one for a whole family does (`CONTROL_*`).
std::string correction(const deck::Block& block, const KeywordLookup& lookup) {
  if (lookup.row && !lookup.row->name.ends_with("_*")) return {};
  const std::string similar = similar_keyword(block.keyword);
  return similar.empty() ? std::string{} : fmt::format("is it *{}?", similar);
}

/// The options of a keyword of which an unknown one is written: `its options are _ID, _BIRTH_DEATH; `.
std::string forms_of_nearest(const deck::Block& block, const KeywordLookup& lookup) {
  const Keyword* base = lookup.row ? nullptr : nearest_keyword(block.keyword);
  if (base == nullptr || base->name.starts_with("MAT_") || base->status != KeywordStatus::used || base->options.empty())
    return {};
  std::string text;
  for (const auto option : base->options) text += fmt::format("{} _{}", text.empty() ? "" : ",", option);
  return fmt::format("its options are{}; ", text);
}

void report_refusal(Findings& findings, const deck::Block& block, const KeywordLookup& lookup, bool skip_unsupported) {
  const std::string meant = correction(block, lookup);
  if (lookup.harmless || skip_unsupported)
    findings.warning(block.place, block.starred(), lookup.why + "; the cards are left out", meant);
  else
    findings.error(block.place, block.starred(), lookup.why,
                   meant.empty() ? fmt::format("{}remove it, or run with --skip-unsupported to leave such cards out at "
                                               "your own risk",
                                               forms_of_nearest(block, lookup))
                                 : meant);
}

void read_block(Builder& b, const deck::Block& block, KeywordSummary& summary, RepeatedCards& repeated) {
  const KeywordLookup lookup = classify(block.keyword);
  const bool is_first = summary.add(block.keyword, lookup.status, lookup.why, block.place);
  if (lookup.status == KeywordStatus::refused) {
    if (is_first) report_refusal(b.findings, block, lookup, b.skip_unsupported);
    b.mark_ignored(block);
  }
  if (lookup.status == KeywordStatus::refused || lookup.row->read == nullptr) return;
  const bool mirrored = block.transform != nullptr && block.transform->mirrors();
  if (mirrored && !can_be_mirrored(block.keyword)) {
    b.findings.error(block.place, block.starred(), "is not built in a file that *INCLUDE_TRANSFORM mirrors",
                     "write it in a file that is not mirrored");
    return b.mark_ignored(block);
  }
  const std::size_t said = b.findings.all().size();
  repeated.look_at(block, *lookup.row, b.findings);
  lookup.row->read(b, block, lookup.options);
  if (b.findings.all().size() == said) warn_of_nothing(block, *lookup.row, b.findings);
  if (mirrored || !b.mirrored_materials.empty()) b.mirrored_materials.resize(b.model.materials.size(), mirrored);
}

}  // namespace

model::Model build(const deck::Deck& deck, Findings& findings, bool skip_unsupported,
                   std::shared_ptr<const model::WeldLibrary> weld_library, const model::Coarsening* coarsening) {
  Builder b(deck, findings);
  b.coarsening = coarsening;
  b.model.weld_library = std::move(weld_library);
  b.skip_unsupported = skip_unsupported;
  b.model.deck = deck.path.string();
  KeywordSummary summary(b.model.keyword_uses);
  for (const auto& [keyword, place] : deck.consumed) summary.add(keyword, KeywordStatus::used, {}, place);

  b.defer(Phase::mesh, make_mesh);
  b.defer(Phase::sets, make_layers);
  b.defer(Phase::sets, resolve_sets);
  b.defer(Phase::bodies, weigh_belts);
  b.defer(Phase::bodies, make_rigid_bodies);
  // Behind what the conditions leave for that phase.
  b.defer(Phase::checks, [](Builder& late) { late.defer(Phase::checks, check_inertia); });
  b.defer(Phase::checks, number_rivets);
  b.defer(Phase::checks, check_mesh);
  b.defer(Phase::checks, check_thick_shells);
  b.defer(Phase::checks, check_parts);
  b.defer(Phase::checks, release_driven_bodies);
  b.defer(Phase::checks, check_tied_nodes);
  b.defer(Phase::checks, check_relaxation);
  b.defer(Phase::checks, check_initial_stresses);
  b.defer(Phase::checks, check_units);
  b.defer(Phase::checks, report_unused_leakage);
  b.defer(Phase::checks, check_initial_velocities);
  RepeatedCards repeated;
  for (const deck::Block& block : deck.blocks) read_block(b, block, summary, repeated);

  for (const Phase phase : {Phase::curves, Phase::mesh, Phase::parts, Phase::systems, Phase::sets, Phase::bodies,
                            Phase::conditions, Phase::checks})
    b.run(phase);
  if (findings.errors() > 0) return std::move(b.model);
  return with_interpolation_spotwelds(with_brick_clusters(std::move(b.model), findings), findings);
}

}  // namespace nugget::reading
