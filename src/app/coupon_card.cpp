// SPDX-License-Identifier: Apache-2.0
#include "app/coupon_card.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <sstream>

#include "app/command.hpp"
#include "deck/deck.hpp"
#include "model/units.hpp"
#include "reading/build.hpp"
#include "reading/cards/sheet_joins.hpp"
#include "weld/placement/deck_text.hpp"

namespace nugget::app {
namespace {

namespace fs = std::filesystem;

/// The one weld of the card: a material, or a card of its own.
struct OneWeld {
  const model::Material* material = nullptr;
  std::optional<reading::SheetJoin> join;
};

OneWeld only_weld(const model::Model& model, const std::vector<reading::SheetJoin>& joins, const std::string& file) {
  std::vector<const model::Material*> materials;
  for (const model::Material& m : model.materials)
    if (m.weld != model::none) materials.push_back(&m);
  if (materials.size() + joins.size() == 1)
    return materials.empty() ? OneWeld{nullptr, joins.front()} : OneWeld{materials.front(), {}};
  std::string list;
  for (const model::Material* m : materials) list += fmt::format("{}{}", list.empty() ? "" : ", ", m->id);
  for (const reading::SheetJoin& join : joins)
    list += fmt::format("{}{} of line {}", list.empty() ? "" : ", ", join.keyword, join.place.line);
  throw CardFault(
      fmt::format("{}: {} *MAT_SPOTWELD{} in it{}{}, expected one [leave in the file the weld that is to be "
                  "tested]",
                  file, materials.size(),
                  joins.empty() ? "" : fmt::format(" and {} welds or rivets that are cards of their own", joins.size()),
                  list.empty() ? "" : ": ", list));
}

/// A weld that is a card of its own: of the parts that the coupons' sheets are, of the diameter that it has.
void take_join(const reading::SheetJoin& join, const CouponArguments& arguments, TakenCard& taken) {
  const auto fault = [&](const std::string& what) {
    throw CardFault(fmt::format("{}:{}: {} {}", join.place.file, join.place.line, join.keyword, what));
  };
  if (std::pair<int, int>(std::minmax(join.first_part, join.second_part)) !=
      std::pair(weld::coupon_lower, weld::coupon_upper))
    fault(fmt::format("joins parts {} and {}, expected {} and {} [the coupons' lower and upper sheet]", join.first_part,
                      join.second_part, weld::coupon_lower, weld::coupon_upper));
  if (join.node_set <= 0 || !(join.diameter > 0.0))
    fault("has no node set or no size [name a set, which the coupons bring, and give the size of the weld]");
  if (arguments.diameter > 0.0 || arguments.form)
    fault(fmt::format("is a weld with its own diameter, {:.4g}, and no elements [leave out --diameter and --as]",
                      join.diameter));
  taken.card.weld_nodes = join.node_set;
  taken.card.diameter = join.diameter;
  taken.place = join.place;
  taken.notes.push_back(fmt::format("weld: {} of the card, diameter {:.4g}", join.keyword, join.diameter));
}

void check_diameter(const weld::CouponCard& card) {
  const double d = card.diameter / card.units.millimetre;
  if (!(d >= 2.0 && d <= 16.0))
    throw CardFault(
        fmt::format("a weld of {:.4g} mm: coupons are 36 to 48 mm wide, expected 2 to 16 mm [give --diameter "
                    "in the units of the card, {}]",
                    d, card.units.name));
}

/// Materials of sheets in the order of the file: those that are neither welds nor rigid.
std::vector<int> sheet_materials(const model::Model& model) {
  std::vector<int> ids;
  for (const model::Material& m : model.materials)
    if (m.weld == model::none && !std::holds_alternative<kernel::Rigid>(m.law)) ids.push_back(m.id);
  return ids;
}

/// The first stands for the lower sheet, the second, or else the first, for the upper one.
template <class Things>
void take_two(const Things& things, const char* what, const std::string& file, std::array<std::size_t, 2>& of_sheet) {
  if (things.size() > 2)
    throw CardFault(fmt::format("{}: {} {}, expected two at most: the lower and the upper sheet's [remove the others]",
                                file, things.size(), what));
  of_sheet = {0, things.size() > 1 ? std::size_t{1} : std::size_t{0}};
}

void take_sheets(const model::Model& model, const CouponArguments& arguments, TakenCard& taken) {
  const model::Units& units = taken.card.units;
  const std::vector<int> materials = sheet_materials(model);
  std::array<std::size_t, 2> of_material{}, of_section{};
  take_two(materials, "sheet materials", arguments.card, of_material);
  take_two(model.shell_sections, "*SECTION_SHELL", arguments.card, of_section);
  for (std::size_t k = 0; k < 2; ++k) {
    weld::CouponCard::Sheet& sheet = taken.card.sheets[k];
    if (!materials.empty()) sheet.material = materials[of_material[k]];
    if (!arguments.thickness.empty()) {
      sheet.thickness = arguments.thickness[std::min(k, arguments.thickness.size() - 1)];
    } else if (!model.shell_sections.empty()) {
      const model::SectionShell& section = model.shell_sections[of_section[k]];
      sheet.section = section.id;
      sheet.thickness = section.thickness;
    } else {
      sheet.thickness = 1.5 * units.millimetre;
    }
    const char* const name = k == 0 ? "lower" : "upper";
    taken.notes.push_back(
        fmt::format("{} sheet: thickness {:.4g} ({}), {}", name, sheet.thickness,
                    !arguments.thickness.empty() ? "as asked for"
                    : sheet.section != 0         ? fmt::format("section {} of the card", sheet.section)
                                                 : "default: the card has no *SECTION_SHELL",
                    sheet.material != 0
                        ? fmt::format("material {} of the card", sheet.material)
                        : "default: a steel of 300 MPa yield stress and a plastic modulus of 1500 MPa, no failure"));
  }
}

double mean_diameter(const model::SectionBeam& section) {
  return 0.5 * (section.outer[0] + section.outer[1]);
}

/// The weld: section and diameter of the card, or what was asked for, or 5 sqrt(t) in mm of the thinner sheet.
void take_weld(const model::Model& model, const CouponArguments& arguments, TakenCard& taken) {
  weld::CouponCard& card = taken.card;
  std::vector<const model::SectionBeam*> sections;
  for (const model::SectionBeam& s : model.beam_sections)
    if (s.elform == 9) sections.push_back(&s);
  const double thinner = std::min(card.sheets[0].thickness, card.sheets[1].thickness);
  std::string from;
  if (arguments.diameter > 0.0) {
    card.diameter = arguments.diameter;
    from = "as asked for";
    if (!sections.empty() && mean_diameter(*sections.front()) != card.diameter)
      from += fmt::format("; {:.4g} in section {} of the card, whose strengths are taken as they stand",
                          mean_diameter(*sections.front()), sections.front()->id);
  } else if (!sections.empty()) {
    card.weld_section = sections.front()->id;
    card.diameter = mean_diameter(*sections.front());
    from = fmt::format("section {} of the card", card.weld_section);
  } else {
    card.diameter = 5.0 * std::sqrt(thinner / card.units.millimetre) * card.units.millimetre;
    from = "default: 5 sqrt(t) of the thinner sheet in mm";
  }
  taken.notes.push_back(fmt::format("weld: material {} of the card, diameter {:.4g} ({}), as {}", card.weld_material,
                                    card.diameter, from, weld::named(card.form).words));
}

std::vector<std::string> lines_of(const std::string& file) {
  std::ifstream in(file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    lines.push_back(line);
  }
  return lines;
}

/// Fields of a line of ten columns each, or between commas.
std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields;
  if (line.find(',') != std::string::npos) {
    std::istringstream in(line);
    for (std::string field; std::getline(in, field, ',');) fields.push_back(field);
  } else {
    for (std::size_t at = 0; at < line.size(); at += 10) fields.push_back(line.substr(at, 10));
  }
  for (std::string& field : fields) {
    field.erase(0, std::min(field.find_first_not_of(' '), field.size()));
    field.erase(field.find_last_not_of(' ') + 1);
  }
  fields.resize(std::max(fields.size(), std::size_t{8}));
  return fields;
}

/// The line of the second card of the *MAT_SPOTWELD that stands at `line` (from 1).
std::size_t second_card(const std::vector<std::string>& lines, std::size_t line, const std::string& file) {
  std::size_t at = std::min(line, lines.size());
  while (at > 0 && !lines[at - 1].starts_with('*')) --at;
  if (at == 0) throw CardFault(fmt::format("{}: the keyword of the weld's material is not found", file));
  std::string keyword = lines[at - 1];
  std::transform(keyword.begin(), keyword.end(), keyword.begin(), [](unsigned char c) { return std::toupper(c); });
  std::size_t left = keyword.find("_TITLE") != std::string::npos ? 3 : 2;
  for (; at < lines.size(); ++at) {
    if (lines[at].starts_with('$')) continue;
    if (--left == 0) return at;
  }
  throw CardFault(fmt::format("{}:{}: the second card of *MAT_SPOTWELD is missing", file, line));
}

/// The next line of data behind `at`.
std::size_t next_card(const std::vector<std::string>& lines, std::size_t at) {
  do ++at;
  while (at < lines.size() && lines[at].starts_with('$'));
  return at;
}

/// Writes a number into a field (from 0) of a line of ten columns each, or between commas.
void replace_field(std::string& line, std::size_t field, double value) {
  if (line.find(',') == std::string::npos) {
    line.resize(std::max(line.size(), 10 * (field + 1)), ' ');
    line.replace(10 * field, 10, weld::real_field(value));
    return;
  }
  std::size_t begin = 0;
  for (std::size_t i = 0; i < field; ++i) {
    begin = line.find(',', begin);
    if (begin == std::string::npos) {
      line += ',';
      begin = line.size() - 1;
    }
    ++begin;
  }
  line.replace(begin, std::min(line.find(',', begin), line.size()) - begin, weld::real_field(value));
}

void insert_remarks(std::vector<std::string>& lines, std::size_t at, const std::vector<std::string>& remarks) {
  for (const std::string& remark : remarks)
    lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(at++), "$ " + remark);
}

}  // namespace

TakenCard take_card(const CouponArguments& arguments, const fs::path& directory) {
  Findings findings;
  const deck::Deck deck = deck::read(arguments.card, findings);
  if (findings.errors() > 0) {
    print_findings(findings);
    throw CardFault(fmt::format("{} cannot be read as a deck", arguments.card));
  }
  // Alone the card is no model: what is wrong with its cards is said of the first coupon, which includes it.
  Findings alone;
  const model::Model model = reading::build(deck, alone, false);
  if (!model.nodes.id.empty() || !model.parts.empty())
    throw CardFault(
        fmt::format("{}: {} nodes and {} parts in it, expected materials, sections, curves and tables only "
                    "[coupons bring their own parts 1 to 5: lower sheet, upper sheet, weld, two grips]",
                    arguments.card, model.nodes.id.size(), model.parts.size()));
  TakenCard taken;
  weld::CouponCard& card = taken.card;
  const OneWeld weld = only_weld(model, reading::sheet_joins(deck), arguments.card);
  const auto units = model::units_of(model);
  if (!units)
    throw CardFault(fmt::format(
        "{}: the units are not recognised: density and Young's modulus of no material fit a "
        "metal in any system [correct RO and E of {}]",
        arguments.card, weld.join ? "the sheets' material, which is to be in the card" : "the weld's material"));
  card.units = *units;
  card.included = fs::proximate(fs::absolute(arguments.card), fs::absolute(directory)).generic_string();
  card.form = arguments.form.value_or(weld::WeldForm::beam);
  for (const model::Material& m : model.materials) card.used = std::max(card.used, m.id);
  for (const model::SectionShell& s : model.shell_sections) card.used = std::max(card.used, s.id);
  for (const model::SectionBeam& s : model.beam_sections) card.used = std::max(card.used, s.id);
  take_sheets(model, arguments, taken);
  if (weld.join) {
    take_join(*weld.join, arguments, taken);
  } else {
    card.weld_material = weld.material->id;
    taken.law = model.weld_laws[weld.material->weld];
    taken.place = weld.material->place;
    take_weld(model, arguments, taken);
  }
  check_diameter(card);
  return taken;
}

std::string with_strengths(const TakenCard& taken, const std::array<double, 6>& strength, double rupture,
                           const std::vector<std::string>& remarks) {
  std::vector<std::string> lines = lines_of(taken.place.file);
  const std::size_t at = second_card(lines, static_cast<std::size_t>(taken.place.line), taken.place.file);
  const std::vector<std::string> old = fields_of(lines[at]);
  for (const std::size_t kept : {std::size_t{0}, std::size_t{7}})
    if (old[kept].size() > 10 || old[kept].find('&') != std::string::npos)
      throw CardFault(
          fmt::format("{}:{}: the field '{}' beside the strengths cannot be kept in ten columns [write it as "
                      "a number of ten columns]",
                      taken.place.file, at + 1, old[kept]));
  std::string line = fmt::format("{:>10}", old[0]);
  for (const double value : strength) line += weld::real_field(value);
  lines[at] = line + fmt::format("{:>10}", old[7]);
  if (rupture > 0.0) replace_field(lines.at(next_card(lines, at)), 0, rupture);  // RS stands behind the strengths
  insert_remarks(lines, at, remarks);
  return fmt::format("{}\n", fmt::join(lines, "\n"));
}

std::string with_joint_strengths(const TakenCard& taken, const kernel::Spr3& joint,
                                 const std::vector<std::string>& remarks) {
  std::vector<std::string> lines = lines_of(taken.place.file);
  const std::size_t first = static_cast<std::size_t>(taken.place.line) - 1, second = next_card(lines, first),
                    third = next_card(lines, second);
  if (second >= lines.size())
    throw CardFault(fmt::format("{}:{}: the second card is missing", taken.place.file, taken.place.line));
  constexpr std::size_t alpha1 = 6, rn = 0, rs = 1, gamma = 4;
  replace_field(lines[first], alpha1, joint.bending_share);
  replace_field(lines[second], rn, joint.normal_strength);
  replace_field(lines[second], rs, joint.shear_strength);
  if (joint.torsion_share > 0.0) replace_field(lines.at(third), gamma, joint.torsion_share);
  insert_remarks(lines, first, remarks);
  return fmt::format("{}\n", fmt::join(lines, "\n"));
}

}  // namespace nugget::app
