// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "deck/deck.hpp"
#include "model/model.hpp"
#include "reading/builder/beam_rule.hpp"
#include "reading/builder/body_cards.hpp"
#include "reading/builder/layer_stack.hpp"
#include "reading/builder/set_recipe.hpp"

// How a Deck becomes a Model. Keywords may come in any order, so reading has two halves: each keyword's reader takes
// its cards and, where ids have to be looked up, leaves a closure behind that runs in its phase, when all that it needs
// is known.
namespace nugget::reading {

using namespace model;  // which is what all this makes

/// The order in which closures run. Within a phase: in deck order.
enum class Phase {
  curves,      ///< curves, tables, coordinate systems that need no nodes
  mesh,        ///< nodes and elements sorted, ids known
  parts,       ///< sections, materials, hourglass linked to parts; element thickness
  systems,     ///< coordinate systems that need nodes
  sets,        ///< all sets resolved
  bodies,      ///< rigid bodies
  conditions,  ///< SPCs, motions, loads, initial velocities, walls, contacts, requests
  checks,      ///< what only the whole model shows
};

struct LeakageFields;
/// What gas leaks by through shells of a material, without their faces.
struct FabricLeakage {
  PorousFabric fabric;
  std::shared_ptr<const LeakageFields> fields;
  bool used = false;  ///< some gas asks for it
};

/// Ids of one name space: user id to index, and where it was defined (for duplicates).
class Ids {
 public:
  /// False (and a finding) if the id is taken.
  bool add(int id, Index index, const Place& place, std::string_view keyword, std::string_view what,
           Findings& findings);
  /// Takes over the ids of a whole array at once: `ascending[i]` has index i. For nodes and elements, which are many.
  void assign(const std::vector<int>& ascending);
  Index find(int id) const;  ///< none where absent
  /// Lets an id stand for another index than its own: of a node that is merged with another.
  void give(int id, Index index) { given_[id] = index; }

  /// Remembers an id whose definition was refused; `by` says which keyword that was.
  void mark_ignored(int id, const std::string& by) { ignored_.try_emplace(id, by); }
  const std::string* left_out(int id) const;  ///< the `by` of such an id; null for others

 private:
  struct Entry {
    Index index;
    Place place;
  };
  std::unordered_map<int, Entry> entries_;
  std::unordered_map<int, std::string> ignored_;
  std::unordered_map<int, Index> given_;
  std::vector<int> ascending_;  ///< of `assign`
  std::vector<Index> by_id_;    ///< index of id `ascending_.front() + i`, where the ids are dense enough for a table
};

/// *DEFINE_BOX: both corners included.
struct Box {
  Vec3d low, high;
  bool holds(const Vec3d& x) const {
    return x.x >= low.x && x.x <= high.x && x.y >= low.y && x.y <= high.y && x.z >= low.z && x.z <= high.z;
  }
};

/// *SECTION_SOLID: what its card says beside the section's own members.
struct SolidCard : SectionSolid {
  double cohoff = 0.0, gaskett = 0.0;
  // Of *SECTION_TSHELL.
  double shrf = 1.0, tshear = 0.0;
  int nip = 2, qr = 0;
};

/// *PART: the ids that its card names.
struct PartCard {
  int pid = 0, secid = 0, mid = 0, eosid = 0, hgid = 0;
};

/// *ELEMENT_DISCRETE.
struct DiscreteCard {
  int eid = 0, pid = 0, n1 = 0, n2 = 0, vid = 0;
  double s = 0.0;
  int pf = 0;
  double offset = 0.0;
};

/// *NODE_MERGE_SET.
struct NodeMergeCard {
  int nsid = 0;
};

/// *ELEMENT_MASS_PART.
struct PartMassCard {
  int pid = 0;
  double addmass = 0.0, finmass = 0.0;
  int lcid = 0;
};

class Builder {
 public:
  Builder(const deck::Deck& of_deck, Findings& into) : deck(of_deck), findings(into) {}

  const deck::Deck& deck;
  Findings& findings;
  Model model;

  // Cards as read, until their phase.
  deck::NodeTable node_table;
  deck::ElementTable shell_table, solid_table, beam_table;
  std::vector<deck::RowOf<DiscreteCard>> discrete_rows;
  std::vector<deck::RowOf<PartMassCard>> part_mass_rows;
  std::unordered_map<Index, RigidCard> rigid_cards;            ///< by material
  std::unordered_map<Index, RigidBody::Inertia> part_inertia;  ///< by part; known after Phase::sets
  std::vector<Box> box_list;                                   ///< by index of `boxes`
  std::vector<Vec3d> vector_list;                              ///< by index of `vectors`; not normalized
  std::vector<Vec3d> vector_tails;                             ///< of the same: points
  std::vector<SetRecipe> set_recipes;
  std::vector<deck::RowOf<NodeMergeCard>> merge_rows;
  std::map<int, std::optional<BlastLoad>> blasts;     ///< *LOAD_BLAST_ENHANCED by BID; nothing: refused
  double merge_tolerance = 0.0;                       ///< TOLR of *NODE_MERGE_TOLERANCE; 0: not given
  std::map<int, LayerStack> layer_rules;              ///< *INTEGRATION_SHELL by IRID
  std::map<int, std::optional<BeamRule>> beam_rules;  ///< *INTEGRATION_BEAM by IRID; nothing: refused
  std::map<Index, LayerStack> layer_stacks;  ///< by shell section: layers that cards give; known after Phase::curves
  BodyCards body_cards;

  Ids bodies;  ///< rigid bodies by id of part (merged ones too) or nodal body; known after Phase::bodies
  std::vector<Index> body_of_node;  ///< by node: the rigid body that carries it, or none; known after Phase::bodies
  std::vector<deck::Entry> shell_formulations, beam_formulations;  ///< by section: its ELFORM
  std::vector<deck::RowOf<SolidCard>> solid_section_rows;          ///< by section
  std::vector<char> thick_solids;                                  ///< by solid: 1 of *ELEMENT_TSHELL; empty: none is
  std::vector<std::pair<Index, deck::RowOf<PartCard>>> part_rows;  ///< by part
  /// *PART_COMPOSITE: its section, and the fields of its id and its hourglass control.
  struct CompositePart {
    Index part = none, section = none;
    deck::Entry id, hourglass;
  };
  std::vector<CompositePart> composite_parts;
  /// By material: what its law asks of the parts that have it, and of their cards.
  std::map<Index, std::function<void(Builder&, const Part&, const deck::RowOf<PartCard>&)>> part_checks;
  std::map<Index, FabricLeakage> leakage;  ///< by material: what gas leaks by; known after Phase::parts

  Ids nodes, shells, solids, beams, discretes, parts, shell_sections, solid_sections, beam_sections, discrete_sections,
      materials, hourglass, curves, tables, systems, vectors, boxes, spring_orientations, part_friction;
  Ids sensors, sensor_switches;
  Ids belts, slip_rings, belt_sensors, retractors, pretensioners, belt_sections;
  std::map<Index, Index> belt_materials;  ///< by material: its place in Belts::materials
  std::vector<Index> nodes_of_rings;      ///< for which a slip ring or retractor stands in belts
  std::map<Index, std::pair<deck::Entry, std::string>> sensor_faults;  ///< by sensor: what of it is not built
  std::map<Index, std::function<void(Builder&)>> sensor_sources;       ///< by sensor: finds what it looks at
  std::set<int> supports_of_bodies;                                    ///< ids of SPCs that hold nodes of rigid bodies
  std::set<Index> motions_of_held_bodies;  ///< whose body is held in their direction; known after Phase::checks
  Ids pair_strengths, load_rate_strengths, connections, functions;  ///< of Model's arrays of these names
  Ids node_sets, part_sets, segment_sets, shell_sets, solid_sets, beam_sets, branches;

  void defer(Phase phase, std::function<void(Builder&)> work) {
    work_[static_cast<std::size_t>(phase)].push_back(std::move(work));
  }
  void run(Phase phase);

  // Look-ups that make a finding ("... is not defined") at the field where the id is unknown. Id 0 gives none,
  // silently.
  Index node(const deck::Entry& field);
  Index part(const deck::Entry& field);
  Index curve(const deck::Entry& field);
  const Set<Index>* node_set(const deck::Entry& field);
  const Set<Index>* part_set(const deck::Entry& field);
  const Set<Index>* shell_set(const deck::Entry& field);
  const Set<Index>* solid_set(const deck::Entry& field);
  const Set<Index>* beam_set(const deck::Entry& field);
  const Set<Segment>* segment_set(const deck::Entry& field);
  const Set<Index>* branch(const deck::Entry& field);
  /// A coordinate system with fixed axes; one that turns with its nodes is refused there.
  Index system(const deck::Entry& field);
  Index turning_or_fixed_system(const deck::Entry& field);
  /// The same as `system` for directions of motions and loads, which LS-DYNA takes along cylindrical or spherical axes
  /// (TYPE): such a system is refused.
  Index system_of_directions(const deck::Entry& field);
  const Vec3d* vector(const deck::Entry& field);
  const Vec3d* vector_tail(const deck::Entry& field);
  const Box* box(const deck::Entry& field);
  Index shell(const deck::Entry& field);
  Index solid(const deck::Entry& field);
  Index beam(const deck::Entry& field);

  /// Index of the id in a field, or none and a finding "... is not defined". Id 0 gives none, silently.
  Index find(const Ids& ids, std::string_view what, const deck::Entry& field);
  /// That finding. Where the definition stands in the deck and was refused, the refusal has been reported: nothing more
  /// is said, unless such cards are only left out; then what needs them cannot be.
  void report_missing(const Ids& ids, std::string_view what, const deck::Entry& field);
  /// A table with its curves; nothing for none and for one that is not whole (reported where it is defined).
  CurveTable table_with_curves(Index table) const;
  /// Remembers what a refused block would have defined, so that no finding says of its users that it is "not defined".
  void mark_ignored(const deck::Block& block);

  /// Mass of elements and point masses by node, worked out once. From Phase::bodies on.
  const std::vector<double>& nodal_mass();

  std::unordered_map<int, int> curved_systems;  ///< TYPE by id: 1 cylindrical, 2 spherical; others are Cartesian
  std::map<const void*, std::unordered_set<Index>> in_history;  ///< by list of Requests: what is in it

  // What stands in files that *INCLUDE_TRANSFORM mirrors, by index: 1. Shorter than what it is of where none does.
  std::vector<char> mirrored_materials, mirrored_shells, mirrored_solids;
  std::set<int> mirrored_systems;        ///< by id
  std::set<int> systems_without_origin;  ///< ids of *DEFINE_COORDINATE_VECTOR, whose origin is the global one

  bool skip_unsupported = false;           ///< refused keywords are left out with a warning
  const Coarsening* coarsening = nullptr;  ///< shells that are merged; null: none

 private:
  std::array<std::vector<std::function<void(Builder&)>>, 8> work_;
  std::vector<double> nodal_mass_;
};

/// The options found behind a keyword's base name, e.g. {"TITLE"} of MAT_SPOTWELD_TITLE.
using Options = std::set<std::string, std::less<>>;

/// True where nothing but blank lines is left: the end of a keyword that repeats its cards.
bool at_end(const deck::Cursor& cursor);
/// An error at the first line that is left over, if any, for keywords that take one set of cards.
void expect_end(Builder& builder, const deck::Cursor& cursor);
/// The title line if the option is there.
std::string read_title(deck::Cursor& cursor, const Options& options);
/// An error "... not supported" at a field whose value is not one of those this program computes.
void refuse(Builder& builder, const deck::Entry& field, std::string_view text, std::string_view remedy = {});
/// refuse(), if the field holds anything but blank or zero.
void refuse_nonzero(Builder& builder, const deck::Entry& field, std::string_view text, std::string_view remedy = {});

/// Findings of one kind, of which the first ones are written out and the rest counted: lists of findings sum up what is
/// alike, findings.json has each, but not millions of them.
class Tally {
 public:
  Tally(Findings& findings, Severity severity, std::string keyword, int limit = 10000)
      : findings_(findings), severity_(severity), keyword_(std::move(keyword)), limit_(limit) {}
  ~Tally() { finish(); }
  Tally(const Tally&) = delete;
  Tally& operator=(const Tally&) = delete;
  /// One more. `text()` is only called for those that are written out.
  template <class Text>
  void add(const Place& place, const Text& text, std::string remedy = {}) {
    if (++count_ <= limit_)
      findings_.add({severity_, place, keyword_, {}, {}, text(), std::move(remedy)});
    else
      last_ = place;
  }
  bool full() const { return count_ >= limit_; }
  int count() const { return count_; }

 private:
  void finish();
  Findings& findings_;
  Severity severity_;
  std::string keyword_;
  int limit_;
  int count_ = 0;
  Place last_;
};

/// One line of a keyword's layout for `nugget keywords`.
struct LayoutCard {
  std::string_view when;  ///< empty: always; else e.g. "with _ID", "if DMGOPT = -1"
  const Card* card;
};

/// A row of the list of keywords: all that this program knows of it.
struct Keyword {
  std::string_view name;  ///< canonical, no star: MAT_PIECEWISE_LINEAR_PLASTICITY; `AIRBAG_*`: all that begin so
  std::vector<std::string_view> aliases{};  ///< MAT_024
  std::vector<std::string_view> options{};  ///< suffixes it takes, each alone or with others: TITLE, ID, MPP
  KeywordStatus status = KeywordStatus::used;
  std::string_view why{};  ///< ignored: why that does no harm; refused: what is missing and what to do instead
  std::vector<LayoutCard> layout{};
  void (*read)(Builder&, const deck::Block&, const Options&) = nullptr;
};

/// All keywords, in one explicit list (keywords.cpp), family by family.
std::span<const Keyword> keywords();
/// The row that a deck's keyword belongs to by longest match, and its options; null where unknown.
const Keyword* find_keyword(std::string_view written, Options& options);
/// The row whose name is the longest beginning of an unknown keyword, to say which option is not known; may be null.
const Keyword* nearest_keyword(std::string_view written);

}  // namespace nugget::reading
