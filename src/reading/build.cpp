// SPDX-License-Identifier: Apache-2.0
#include "reading/build.hpp"

#include <fmt/format.h>

#include <unordered_map>

#include "reading/bodies/rigid_bodies.hpp"
#include "reading/builder/builder.hpp"
#include "reading/builder/passes.hpp"
#include "reading/describe.hpp"
#include "reading/mesh/brick_clusters.hpp"

namespace nugget::reading {

namespace {

/// The ledger while it is being written: one entry a keyword, in order of first appearance.
class Ledger {
 public:
  explicit Ledger(std::vector<LedgerEntry>& entries) : entries_(entries) {}

  /// True for the first appearance.
  bool add(const std::string& keyword, Verdict verdict, std::string_view why, const Place& place) {
    const auto [at, is_new] = index_.try_emplace(keyword, entries_.size());
    if (is_new) entries_.push_back({keyword, 0, verdict, std::string(why), place});
    ++entries_[at->second].count;
    return is_new;
  }

 private:
  std::vector<LedgerEntry>& entries_;
  std::unordered_map<std::string, std::size_t> index_;
};

/// The verdict on one block, and its reader and options where it is used.
struct Ruling {
  Verdict verdict = Verdict::refused;
  std::string why;
  bool harmless = false;  ///< refused, but only an output is missing
  const Keyword* row = nullptr;
  Options options;
};

Ruling judge(const std::string& keyword) {
  Ruling ruling;
  ruling.row = find_keyword(keyword, ruling.options);
  ruling.harmless = keyword.starts_with("DATABASE_");
  if (ruling.row) {
    ruling.verdict = ruling.row->verdict;
    ruling.why = ruling.row->why;
  } else if (const Keyword* base = nearest_keyword(keyword)) {
    ruling.why =
        keyword.starts_with("MAT_")  // *MAT_ELASTIC_PLASTIC_HYDRO is no form of *MAT_ELASTIC
            ? fmt::format("this material, or this form of *{}, is not built; `nugget keywords` lists those that are",
                          base->name)
            : fmt::format("this form of *{} is not supported", base->name);
  } else {
    ruling.why = ruling.harmless ? "this output is not written" : "not a keyword that this program knows";
  }
  return ruling;
}

/// A slip of the pen is likely only where no row names the keyword, or one for a whole family does (`CONTROL_*`).
std::string correction(const deck::Block& block, const Ruling& ruling) {
  if (ruling.row && !ruling.row->name.ends_with("_*")) return {};
  const std::string_view similar = similar_keyword(block.keyword);
  return similar.empty() ? std::string{} : fmt::format("is it *{}?", similar);
}

void report_refusal(Findings& findings, const deck::Block& block, const Ruling& ruling, bool skip_unsupported) {
  const std::string meant = correction(block, ruling);
  if (ruling.harmless || skip_unsupported)
    findings.warning(block.place, block.starred(), ruling.why + "; the cards are left out", meant);
  else
    findings.error(
        block.place, block.starred(), ruling.why,
        meant.empty() ? "remove it, or run with --skip-unsupported to leave such cards out at your own risk" : meant);
}

void read_block(Builder& b, const deck::Block& block, Ledger& ledger) {
  const Ruling ruling = judge(block.keyword);
  const bool is_first = ledger.add(block.keyword, ruling.verdict, ruling.why, block.place);
  if (ruling.verdict == Verdict::refused) {
    if (is_first) report_refusal(b.findings, block, ruling, b.skip_unsupported);
    b.leave_out(block);
  }
  if (ruling.verdict != Verdict::refused && ruling.row->read) ruling.row->read(b, block, ruling.options);
}

}  // namespace

model::Model build(const deck::Deck& deck, Findings& findings, bool skip_unsupported) {
  Builder b(deck, findings);
  b.skip_unsupported = skip_unsupported;
  b.model.deck = deck.path.string();
  Ledger ledger(b.model.ledger);
  for (const auto& [keyword, place] : deck.consumed) ledger.add(keyword, Verdict::used, {}, place);

  b.later(Phase::mesh, make_mesh);
  b.later(Phase::sets, make_layers);
  b.later(Phase::sets, resolve_sets);
  b.later(Phase::bodies, make_rigid_bodies);
  // Behind what the conditions leave for that phase.
  b.later(Phase::checks, [](Builder& late) { late.later(Phase::checks, check_inertia); });
  b.later(Phase::checks, check_mesh);
  b.later(Phase::checks, check_parts);
  b.later(Phase::checks, release_driven_bodies);
  b.later(Phase::checks, check_relaxation);
  b.later(Phase::checks, check_units);
  b.later(Phase::checks, check_initial_velocities);
  for (const deck::Block& block : deck.blocks) read_block(b, block, ledger);

  for (const Phase phase : {Phase::curves, Phase::mesh, Phase::parts, Phase::systems, Phase::sets, Phase::bodies,
                            Phase::conditions, Phase::checks})
    b.run(phase);
  if (findings.errors() > 0) return std::move(b.model);
  return with_brick_clusters(std::move(b.model), findings);
}

}  // namespace nugget::reading
