// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <sstream>
#include <tuple>

#include "app/command.hpp"
#include "base/index.hpp"
#include "deck/moved_nodes.hpp"
#include "model/units.hpp"
#include "reading/build.hpp"
#include "weld/placement/adapt.hpp"
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
    const auto id = [](model::Index i, auto of) { return i == model::none ? std::string("-") : fmt::to_string(of(i)); };
    text += fmt::format("{:>18} {:>8} {:>9} {:>6.2f} {:>6.2f} {:>9.4g} {:>8.4g} {:>8.4g} {:>6} {:>10.3g}  ",
                        weld::name_weld(ties.welds[end.weld]), id(end.part, [&](int p) { return model.parts[p].id; }),
                        id(end.shell, [&](int e) { return model.shells.id[e]; }), end.off_before, end.off_after,
                        end.edge_before, end.edge_after, end.diameter, end.moved.size(), end.farthest);
    const weld::ShellShape &a = end.before, &b = end.after;
    text += end.left.empty() ? fmt::format(
                                   "Jacobian {:.2f} -> {:.2f}, aspect {:.2f} -> {:.2f}, warp {:.1f} -> {:.1f}, "
                                   "time step x {:.2f}\n",
                                   a.jacobian, b.jacobian, a.aspect, b.aspect, a.warp, b.warp, b.length / a.length)
                             : "left: " + end.left + '\n';
  }
  return text;
}

std::string as_remarks(const std::string& text) {
  std::istringstream lines(text);
  std::string line, remarks;
  while (std::getline(lines, line)) remarks += "$ " + line + '\n';
  return remarks;
}

/// What of the model is another one than before, beside the places of nodes; empty: nothing.
std::string difference(const model::Model& a, const model::Model& b) {
  const auto mesh = [](const model::Model& m) {
    return std::tie(m.nodes.id, m.shells.id, m.shells.node, m.shells.part, m.solids.node, m.beams.node);
  };
  if (mesh(a) != mesh(b)) return "its elements are others";
  std::string text;
  const auto compare = [&](const auto& one, const auto& other, std::string_view what) {
    if (one.size() != other.size()) text = fmt::format("it has another number of {} sets", what);
    for (std::size_t i = 0; i < one.size() && text.empty(); ++i)
      if (one[i].id != other[i].id || one[i].members != other[i].members)
        text = fmt::format("{} set {} has other members, as it is chosen by place", what, one[i].id);
  };
  compare(a.sets.nodes, b.sets.nodes, "node");
  compare(a.sets.parts, b.sets.parts, "part");
  compare(a.sets.shells, b.sets.shells, "shell");
  compare(a.sets.solids, b.sets.solids, "solid");
  compare(a.sets.beams, b.sets.beams, "beam");
  compare(a.sets.segments, b.sets.segments, "segment");
  for (std::size_t i = 0; i < a.contacts.size() && text.empty(); ++i)
    if (a.contacts[i].a.nodes != b.contacts[i].a.nodes || a.contacts[i].b.nodes != b.contacts[i].b.nodes)
      text = fmt::format("contact {} has other nodes", a.contacts[i].id);
  return text;
}

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
std::string fault_of(const WeldArguments& arguments, const model::Model& model, const weld::Ties& ties,
                     const weld::Adapted& adapted) {
  Findings findings;
  const model::Model written =
      reading::build(deck::read(arguments.output, findings), findings, arguments.skip_unsupported);
  for (const Finding& f : findings.all())
    if (f.severity == Severity::error) return to_string(f);
  if (const std::string other = difference(model, written); !other.empty()) return other;
  double size = 0.0, off = 0.0;
  for (std::size_t n = 0; n < adapted.x.size(); ++n) {
    size = std::max(size, norm(adapted.x[n]));
    off = std::max(off, norm(adapted.x[n] - written.nodes.x[n]));
  }
  if (off > 1e-6 * size) return fmt::format("a node stands {:.3g} from where it should", off);
  if (other_ties(ties) != other_ties(weld::tie(written, findings))) return "another tie holds other segments";
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
  deck::EditedText text(deck);
  deck::MovedNodes nodes_of_text(deck, text);
  const std::vector<char> can_move = can_be_moved(deck, nodes_of_text, model);
  weld::AdaptLimits limits;
  limits.length = arguments.least_step;
  const weld::Adapted adapted = weld::adapt(
      model, ties, [&](model::Index n) { return can_move[n] != 0; }, limits);
  std::size_t nodes = 0;
  for (std::size_t n = 0; n < adapted.x.size(); ++n)
    if (norm(adapted.x[n] - model.nodes.x[n]) > 0.0) {
      nodes_of_text.move(model.nodes.id[n], adapted.x[n]);
      ++nodes;
    }
  const auto ends = std::ranges::count_if(adapted.ends, [](const weld::AdaptedEnd& end) { return end.left.empty(); });
  const std::string table = table_of(model, ties, adapted);
  const auto files = text.files(arguments.output, as_remarks("Nodes moved by nugget weld --adapt:\n" + table));
  if (overwrites(deck, files)) return ExitCode::wrong_command;
  for (const auto& file : files) output::write_whole_file(file.path, file.text);
  if (const std::string fault = fault_of(arguments, model, ties, adapted); !fault.empty()) {
    std::error_code error;
    for (const auto& file : files) fs::remove(file.path, error);
    findings.error({arguments.output, 0, 0}, {}, "the new deck does not say the same as the old one: " + fault,
                   "write it beside the old deck, and choose sets by ids or parts");
    return refuse_adapting(findings);
  }
  fmt::print(
      "{}{} of {} ends of welds stand over a new element; {} nodes moved; shortest shell for the time step {:.4g}, "
      "was {:.4g}\n",
      table, ends, adapted.ends.size(), nodes, shortest(model.shells, adapted.x),
      shortest(model.shells, model.nodes.x));
  for (const auto& file : files) fmt::print("{}\n", file.path.string());
  return ExitCode::normal;
}

}  // namespace nugget::app
