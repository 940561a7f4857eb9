// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>
#include <map>
#include <sstream>
#include <type_traits>

#include "app/command.hpp"
#include "base/index.hpp"
#include "deck/divided_shells.hpp"
#include "deck/moved_nodes.hpp"
#include "model/segments.hpp"
#include "model/units.hpp"
#include "reading/build.hpp"
#include "weld/placement/adapt.hpp"
#include "weld/placement/divided_text.hpp"
#include "weld/tie/welds.hpp"

namespace nugget::app {
namespace {

namespace fs = std::filesystem;

/// By node of the model: its place can be changed in the text, and is what the text says (no later keyword moves it).
std::vector<char> can_be_moved(const deck::Deck& deck, const deck::MovedNodes& text, const model::Model& model) {
  deck::NodeTable table;
  Findings told;  // when the model was made
  for (const deck::Block& block : deck.blocks)
    if (block.keyword == "NODE") deck::read_nodes(deck, block, table, told);
  std::vector<char> can(model.nodes.size(), 0);
  for (std::size_t i = 0; i < table.id.size(); ++i) {
    const model::Index n = model.node_index(table.id[i]);
    can[n] = norm(model.nodes.x[n] - table.x[i]) == 0.0 && text.can_move(table.id[i]);
  }
  return can;
}

double shortest(const model::Shells& shells, const std::vector<Vec3d>& x) {
  double least = std::numeric_limits<double>::infinity();
  for (model::Index e = 0; at(e) < shells.size(); ++e) least = std::min(least, weld::shape_of(shells, e, x).length);
  return least;
}

/// A line for each end of a weld.
std::string table_of(const model::Model& model, const weld::Ties& ties, const weld::Adapted& adapted) {
  const std::string length = model::in_units(model::units_of(model), dimension::length);
  std::string text =
      fmt::format("{:>18} {:>8} {:>9} {:>6} {:>6} {:>9} {:>8} {:>8} {:>6} {:>10}  {}\n", "weld", "part", "shell", "off",
                  "now", "edge" + length, "now", "d" + length, "nodes", "moved" + length, "worst of the patch");
  for (const weld::AdaptedEnd& end : adapted.ends) {
    const std::string done = end.divided ? "divided, " : "";
    const auto id = [](model::Index i, auto of) { return i == model::none ? std::string("-") : fmt::to_string(of(i)); };
    text += fmt::format("{:>18} {:>8} {:>9} {:>6.2f} {:>6.2f} {:>9.4g} {:>8.4g} {:>8.4g} {:>6} {:>10.3g}  ",
                        weld::name_weld(ties.welds[end.weld]), id(end.part, [&](int p) { return model.parts[p].id; }),
                        id(end.shell, [&](int e) { return model.shells.id[e]; }), end.off_before, end.off_after,
                        end.edge_before, end.edge_after, end.diameter, end.moved.size(), end.farthest);
    const weld::ShellShape &a = end.before, &b = end.after;
    text += end.left.empty()
                ? done + fmt::format(
                             "Jacobian {:.2f} -> {:.2f}, aspect {:.2f} -> {:.2f}, warp {:.1f} -> {:.1f}, "
                             "time step x {:.2f}",
                             a.jacobian, b.jacobian, a.aspect, b.aspect, a.warp, b.warp, b.length / a.length)
                : "left: " + end.left;
    text += end.whole.empty() ? "\n" : "; not divided: " + end.whole + '\n';
  }
  return text;
}

std::string as_remarks(const std::string& text) {
  std::istringstream lines(text);
  std::string line, remarks;
  while (std::getline(lines, line)) remarks += "$ " + line + '\n';
  return remarks;
}

/// What dividing shells adds to a model: four nodes and four shells each, with ids behind all others.
struct Pieces {
  std::map<model::Index, std::size_t> of;  ///< of a divided shell its place in weld::Adapted::divided
  std::size_t nodes = 0, shells = 0;       ///< of the model before

  model::Index node(std::size_t divided, std::size_t k) const {
    return static_cast<model::Index>(nodes + 4 * divided + k);
  }
  /// The first piece keeps the shell's id.
  model::Index shell(std::size_t divided, std::size_t k) const {
    return static_cast<model::Index>(shells + 4 * divided + k - 1);
  }
  bool is_new_node(model::Index n) const { return at(n) >= nodes; }
};

Pieces pieces_of(const model::Model& model, const weld::Adapted& adapted) {
  Pieces p{{}, model.nodes.size(), model.shells.size()};
  for (std::size_t d = 0; d < adapted.divided.size(); ++d) p.of[adapted.divided[d].shell] = d;
  return p;
}

/// Corners of piece k of a divided shell, as indices of the new model.
std::array<model::Index, 4> corners_of_piece(const model::Model& model, const Pieces& pieces, model::Index shell,
                                             std::size_t k) {
  std::array<model::Index, 4> corners{};
  for (std::size_t i = 0; i < 4; ++i) {
    const int c = weld::pieces[k][i];
    corners[i] = c < 4 ? model.shells.node[shell][at(c)] : pieces.node(pieces.of.at(shell), at(c) - 4);
  }
  return corners;
}

/// The mesh that the new deck is to have.
struct Mesh {
  std::vector<int> nodes, shells;
  std::vector<std::array<model::Index, 4>> corners;
  std::vector<model::Index> part;
};
Mesh expected_mesh(const model::Model& model, const Pieces& pieces) {
  Mesh mesh{model.nodes.id, model.shells.id, model.shells.node, model.shells.part};
  const weld::NewIds first = weld::first_new_ids(model);
  std::vector<model::Index> divided(pieces.of.size());
  for (const auto& [shell, d] : pieces.of) divided[d] = shell;
  for (std::size_t d = 0; d < divided.size(); ++d)
    for (int k = 0; k < 4; ++k) {
      mesh.nodes.push_back(first.node + 4 * static_cast<int>(d) + k);
      mesh.shells.push_back(first.shell + 4 * static_cast<int>(d) + k);
      mesh.corners.push_back(corners_of_piece(model, pieces, divided[d], at(k) + 1));
      mesh.part.push_back(model.shells.part[divided[d]]);
    }
  for (const model::Index shell : divided) mesh.corners[shell] = corners_of_piece(model, pieces, shell, 0);
  return mesh;
}

/// What of the model is another one than before, beside the places of nodes and what was divided; empty: nothing.
/// `shell`: the divided one whose pieces are missing somewhere, if it is that.
struct Difference {
  std::string text;
  model::Index shell = model::none;
};

class Comparison {
 public:
  Comparison(const model::Model& before, const model::Model& now, const Pieces& pieces)
      : a_(before), b_(now), pieces_(pieces) {}

  Difference run() {
    const Mesh mesh = expected_mesh(a_, pieces_);
    if (mesh.nodes != b_.nodes.id || mesh.shells != b_.shells.id || mesh.corners != b_.shells.node ||
        mesh.part != b_.shells.part || a_.solids.node != b_.solids.node || a_.beams.node != b_.beams.node)
      return {"its elements are others"};
    compare(a_.sets.nodes, b_.sets.nodes, "node", [this](auto& set) { return with_new_nodes(set); });
    compare(a_.sets.parts, b_.sets.parts, "part", as_it_is);
    compare(a_.sets.shells, b_.sets.shells, "shell", [this](auto& set) { return with_pieces(set); });
    compare(a_.sets.solids, b_.sets.solids, "solid", as_it_is);
    compare(a_.sets.beams, b_.sets.beams, "beam", as_it_is);
    compare(a_.sets.segments, b_.sets.segments, "segment", [this](auto& set) { return with_segments(set); });
    for (std::size_t i = 0; i < a_.contacts.size() && found_.text.empty(); ++i)
      for (const auto side : {&model::Contact::a, &model::Contact::b}) {
        const std::vector<model::Index> now = sorted((b_.contacts[i].*side).nodes);
        if (found_.text.empty() && sorted(with_new_nodes((a_.contacts[i].*side).nodes)) != now)
          missing_nodes((a_.contacts[i].*side).nodes, now,
                        fmt::format("contact {} has other nodes", a_.contacts[i].id));
      }
    return found_;
  }

 private:
  template <class T>
  static std::vector<T> sorted(std::vector<T> list) {
    std::sort(list.begin(), list.end());
    return list;
  }
  static constexpr auto as_it_is = [](const auto& list) { return list; };

  template <class Set, class Expected>
  void compare(const std::vector<Set>& one, const std::vector<Set>& other, std::string_view what, Expected expected) {
    if (!found_.text.empty()) return;
    if (one.size() != other.size()) found_.text = fmt::format("it has another number of {} sets", what);
    for (std::size_t i = 0; i < one.size() && found_.text.empty(); ++i) {
      if (one[i].id == other[i].id &&
          (pieces_.of.empty() ? one[i].members == other[i].members
                              : sorted(expected(one[i].members)) == sorted(other[i].members)))
        continue;
      found_.text = fmt::format("{} set {} has other members, as it is chosen by place or by numbers", what, one[i].id);
      if constexpr (std::is_same_v<std::decay_t<decltype(one[i].members[0])>, model::Index>) {
        if (what == "node") missing_nodes(one[i].members, sorted(other[i].members), found_.text);
        if (what == "shell") missing_shells(one[i].members, sorted(other[i].members));
      }
    }
  }
  /// Nodes of sheets whose shells have all corners in it, and so its pieces.
  std::vector<model::Index> with_new_nodes(std::vector<model::Index> list) const {
    const std::vector<model::Index> old = sorted(list);
    for (const auto& [shell, d] : pieces_.of)
      if (holds_all(old, a_.shells.node[shell]))
        for (std::size_t k = 0; k < 4; ++k) list.push_back(pieces_.node(d, k));
    return list;
  }
  std::vector<model::Index> with_pieces(std::vector<model::Index> list) const {
    const std::vector<model::Index> old = sorted(list);
    for (const auto& [shell, d] : pieces_.of)
      if (std::binary_search(old.begin(), old.end(), shell))
        for (std::size_t k = 1; k < 5; ++k) list.push_back(pieces_.shell(d, k));
    return list;
  }
  std::vector<model::Segment> with_segments(const std::vector<model::Segment>& list) const {
    std::map<model::Segment, model::Index> divided;
    for (const auto& [shell, d] : pieces_.of) divided[model::sorted_corners(a_.shells.node[shell])] = shell;
    std::vector<model::Segment> now;
    for (const model::Segment& s : list) {
      const auto found = divided.find(model::sorted_corners(s));
      if (found == divided.end())
        now.push_back(s);
      else
        for (std::size_t k = 0; k < 5; ++k) now.push_back(corners_of_piece(a_, pieces_, found->second, k));
    }
    return now;
  }
  template <class List, class Nodes>
  static bool holds_all(const List& list, const Nodes& nodes) {
    return std::ranges::all_of(nodes, [&](auto n) { return std::binary_search(list.begin(), list.end(), n); });
  }
  void missing_nodes(const std::vector<model::Index>& before, const std::vector<model::Index>& now, std::string text) {
    found_.text = std::move(text);
    const std::vector<model::Index> old = sorted(before);
    for (const auto& [shell, d] : pieces_.of) {
      std::size_t there = 0;
      for (std::size_t k = 0; k < 4; ++k) there += std::binary_search(now.begin(), now.end(), pieces_.node(d, k));
      if (there != (holds_all(old, a_.shells.node[shell]) ? 4u : 0u)) found_.shell = shell;
    }
  }
  void missing_shells(const std::vector<model::Index>& before, const std::vector<model::Index>& now) {
    const std::vector<model::Index> old = sorted(before);
    for (const auto& [shell, d] : pieces_.of)
      for (std::size_t k = 1; k < 5; ++k)
        if (std::binary_search(now.begin(), now.end(), pieces_.shell(d, k)) !=
            std::binary_search(old.begin(), old.end(), shell))
          found_.shell = shell;
  }

  const model::Model &a_, &b_;
  const Pieces& pieces_;
  Difference found_;
};

/// Ties of other nodes than those of welds, with their segments.
std::vector<std::pair<int, model::Segment>> other_ties(const weld::Ties& ties) {
  std::vector<char> of_weld(ties.x.size(), 0);
  for (const weld::Weld& w : ties.welds)
    for (const weld::Projection& p : w.ends) of_weld[p.node] = 1;
  std::vector<std::pair<int, model::Segment>> others;
  for (const weld::Tie& t : ties.ties)
    if (of_weld[t.node] == 0) others.emplace_back(t.node, t.segment);
  return others;
}

/// Reads what was written and compares: what is wrong with it, or nothing.
Difference fault_of(const WeldArguments& arguments, const model::Model& model, const weld::Ties& ties,
                    const weld::Adapted& adapted) {
  Findings findings;
  const model::Model written =
      reading::build(deck::read(arguments.output, findings), findings, arguments.skip_unsupported);
  for (const Finding& f : findings.all())
    if (f.severity == Severity::error) return {to_string(f)};
  const Pieces pieces = pieces_of(model, adapted);
  if (Difference other = Comparison(model, written, pieces).run(); !other.text.empty()) return other;
  double size = 0.0, off = 0.0;
  const auto compare = [&](const Vec3d& x, std::size_t n) {
    size = std::max(size, norm(x));
    off = std::max(off, norm(x - written.nodes.x[n]));
  };
  for (std::size_t n = 0; n < adapted.x.size(); ++n) compare(adapted.x[n], n);
  for (std::size_t d = 0; d < adapted.divided.size(); ++d)
    for (std::size_t k = 0; k < 4; ++k) compare(adapted.divided[d].square[k], at(pieces.node(d, k)));
  if (off > 1e-6 * size) return {fmt::format("a node stands {:.3g} from where it should", off)};
  if (other_ties(ties) != other_ties(weld::tie(written, findings))) return {"another tie holds other segments"};
  return {};
}

bool overwrites(const deck::Deck& deck, const std::vector<deck::EditedText::File>& files) {
  std::error_code error;
  for (const auto& file : files)
    for (const std::string& input : deck.files)
      if (fs::equivalent(file.path, input, error)) {
        fmt::print(stderr, "nugget: {} would be overwritten; give another name after -o\n", input);
        return true;
      }
  return false;
}

ExitCode refuse_adapting(const Findings& findings) {
  print_findings(findings);
  fmt::print(stderr, "no node was moved; no file was written\n");
  return ExitCode::refused;
}

/// The new deck: what is moved and divided, its text, its files.
class Meshing {
 public:
  Meshing(const WeldArguments& arguments, const deck::Deck& deck, const model::Model& model, const weld::Ties& ties)
      : arguments_(arguments), deck_(deck), model_(model), ties_(ties), whole_(weld::whole_shells(model, ties)) {}

  /// Writes it and reads it again; says what is wrong with it.
  Difference write() {
    deck::EditedText text(deck_);
    deck::MovedNodes nodes(deck_, text);
    deck::DividedShells shells(deck_, text);
    const std::vector<char> can_move = can_be_moved(deck_, nodes, model_);
    weld::AdaptLimits limits;
    limits.length = arguments_.least_step;
    limits.divides = arguments_.divide;
    adapted_ = weld::adapt(
        model_, ties_, [&](model::Index n) { return can_move[n] != 0; }, limits,
        [&](model::Index shell) { return why_whole(shells, shell); });
    moved_ = 0;
    for (std::size_t n = 0; n < adapted_.x.size(); ++n)
      if (norm(adapted_.x[n] - model_.nodes.x[n]) > 0.0) {
        nodes.move(model_.nodes.id[n], adapted_.x[n]);
        ++moved_;
      }
    weld::write_divided(shells, model_, adapted_);
    table_ = table_of(model_, ties_, adapted_);
    const char* what = adapted_.divided.empty() ? "Nodes moved by nugget weld --adapt:\n"
                                                : "Nodes moved and elements divided by nugget weld --adapt --divide:\n";
    const auto files = text.files(arguments_.output, as_remarks(what + table_));
    overwrote_ = overwrites(deck_, files);
    if (overwrote_) return {};
    files_.clear();
    for (const auto& file : files) {
      output::write_whole_file(file.path, file.text);
      files_.push_back(file.path);
    }
    return fault_of(arguments_, model_, ties_, adapted_);
  }
  bool overwrote() const { return overwrote_; }
  void remove_files() const {
    std::error_code error;
    for (const fs::path& file : files_) fs::remove(file, error);
  }
  /// False where it was to stay whole already.
  bool keep_whole(model::Index shell, const std::string& why) {
    if (!whole_[shell].empty()) return false;
    whole_[shell] = "with pieces of it " + why;
    return true;
  }
  void print() const {
    const auto ends =
        std::ranges::count_if(adapted_.ends, [](const weld::AdaptedEnd& end) { return end.left.empty(); });
    const std::string divided = adapted_.divided.empty()
                                    ? ""
                                    : fmt::format("; {} element{} divided into five", adapted_.divided.size(),
                                                  adapted_.divided.size() == 1 ? "" : "s");
    fmt::print(
        "{}{} of {} ends of welds stand over a new element; {} nodes moved{}; shortest shell for the time step {:.4g}, "
        "was {:.4g}\n",
        table_, ends, adapted_.ends.size(), moved_, divided,
        std::min(shortest(model_.shells, adapted_.x), shortest_piece()), shortest(model_.shells, model_.nodes.x));
    for (const fs::path& file : files_) fmt::print("{}\n", file.string());
  }

 private:
  std::string why_whole(const deck::DividedShells& shells, model::Index shell) const {
    if (!whole_[shell].empty()) return whole_[shell];
    const int id = model_.shells.id[shell], node = model_.nodes.id[model_.shells.node[shell][0]];
    const weld::NewIds first = weld::first_new_ids(model_);
    const int most = 4 * static_cast<int>(ties_.welds.size()) * 2;
    if (!shells.can_divide(id) || !shells.can_follow(node))
      return "its line or that of its first node is none that can become several";
    if (!shells.fits(id, first.shell + most, node, first.node + most)) return "the columns have no room for new ids";
    return {};
  }

  double shortest_piece() const {
    double least = std::numeric_limits<double>::infinity();
    for (const weld::AdaptedEnd& end : adapted_.ends)
      if (end.divided) least = std::min(least, end.after.length);
    return least;
  }

  const WeldArguments& arguments_;
  const deck::Deck& deck_;
  const model::Model& model_;
  const weld::Ties& ties_;
  std::vector<std::string> whole_;  ///< of each shell why it cannot be divided
  weld::Adapted adapted_;
  std::size_t moved_ = 0;
  std::string table_;
  bool overwrote_ = false;
  std::vector<fs::path> files_;
};

}  // namespace

ExitCode adapt_welds(const WeldArguments& arguments) {
  use_threads(arguments.threads);
  Findings findings;
  const deck::Deck deck = deck::read(arguments.deck, findings);
  if (findings.errors() > 0) return refuse_adapting(findings);
  const model::Model model = reading::build(deck, findings, arguments.skip_unsupported);
  if (findings.errors() > 0) return refuse_adapting(findings);
  Findings of_ties;  // `nugget check` lists them
  const weld::Ties ties = weld::tie(model, of_ties);
  if (ties.welds.empty()) {
    findings.error({arguments.deck, 0, 0}, {}, "the deck has no weld",
                   "place welds first: nugget weld POINTS MODEL.k -o WELDED.k");
    return refuse_adapting(findings);
  }
  Meshing meshing(arguments, deck, model, ties);
  for (;;) {
    const Difference fault = meshing.write();
    if (meshing.overwrote()) return ExitCode::wrong_command;
    if (fault.text.empty()) break;
    meshing.remove_files();
    if (fault.shell != model::none && meshing.keep_whole(fault.shell, fault.text)) continue;
    findings.error({arguments.output, 0, 0}, {}, "the new deck does not say the same as the old one: " + fault.text,
                   "write it beside the old deck, and choose sets by ids or parts");
    return refuse_adapting(findings);
  }
  meshing.print();
  return ExitCode::normal;
}

}  // namespace nugget::app
