// SPDX-License-Identifier: Apache-2.0
#include "weld/placement/placement_deck.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>
#include <set>

#include "base/append.hpp"
#include "deck/text.hpp"
#include "model/history_files.hpp"
#include "model/units.hpp"
#include "model/weld_section.hpp"
#include "weld/placement/deck_text.hpp"
#include "weld/placement/interpolation_deck.hpp"
#include "weld/tie/welds.hpp"

namespace nugget::weld {
namespace {

constexpr int largest_id = 99999999;  // eight columns

template <class Things>
int largest(const Things& things) {
  int id = 0;
  for (const auto& thing : things) id = std::max(id, thing.id);
  return id;
}

int largest_of(const std::vector<int>& ids) {
  return ids.empty() ? 0 : *std::max_element(ids.begin(), ids.end());
}

/// A name in the title of a part, short enough for its line.
std::string title_of(const std::string& spot_class, double diameter) {
  return fmt::format("spot welds{}{:.40}, diameter {:.4g}", spot_class.empty() ? "" : " ", spot_class, diameter);
}

/// One weld part: all welds of a class and a diameter.
struct WeldPart {
  int id = 0;
  std::string spot_class, diameter;  // the diameter as it will stand in the card
};

/// The strengths among the fields, as they would stand in a sentence: `NRR = 8000, NRS = 6000`; empty: none above 0.
std::string name_strengths(const WeldFields& fields) {
  std::string text;
  for (const std::string& name : weld_fields(WeldForm::beam)) {
    const auto found = fields.find(name);
    if (strength_power(name) == 0 || found == fields.end() || found->second == 0.0) continue;
    text += text.empty() ? "" : ", ";
    for (const char c : name) text += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    text += fmt::format(" = {:.6g}", found->second);
  }
  return text;
}

class PlacementWriter {
 public:
  PlacementWriter(const model::Model& model, const Sheets& sheets, WeldForm form, const GivenMaterial& given,
                  Findings& findings)
      : model_(model),
        sheets_(sheets),
        form_(form),
        given_(given),
        findings_(findings),
        units_(model::units_of(model)) {
    node_ = largest_of(model.nodes.id);
    element_ = std::max({largest_of(model.shells.id), largest_of(model.solids.id), largest_of(model.beams.id)});
    part_ = std::max(largest(model.parts), largest(model.rigid_bodies));
    section_ = std::max({largest(model.shell_sections), largest(model.solid_sections), largest(model.beam_sections)});
    material_ = largest(model.materials);
    hourglass_ = largest(model.hourglass);
    set_ = std::max(largest(model.sets.parts), largest(model.sets.nodes));
    curve_ = std::max({largest(model.curves), largest(model.tables), largest(model.functions)});
    contact_ = largest(model.contacts);
  }

  PlacementDeck write(const std::vector<Spot>& spots, const std::string& included) {
    PlacementDeck deck;
    for (const Spot& spot : spots) {
      const std::size_t before = count_;
      form_ == WeldForm::beam            ? add_beams(spot)
      : form_ == WeldForm::interpolation ? add_locations(spot)
                                         : add_bricks(spot);
      if (count_ > before) ++deck.spots;
    }
    if (std::max({node_, element_, part_}) > largest_id)
      findings_.error({model_.deck, 0, 0}, {},
                      fmt::format("ids up to {} leave no room for welds in eight columns", element_),
                      "renumber the model");
    deck.elements = count_;
    // One after the other: each gives out ids that the next ones use.
    deck.text = head(included, deck.spots);
    if (form_ == WeldForm::interpolation) {
      deck.text += interpolation_cards();
    } else {
      deck.text += parts();
      deck.text += materials();
      deck.text += ties();
    }
    deck.text += request();
    deck.text += mesh();
    return deck;
  }

 private:
  int weld_part(const Spot& spot) {
    const std::string diameter = fmt::format("{:.5g}", spot.diameter);
    for (const WeldPart& p : weld_parts_)
      if (p.spot_class == spot.from->spot_class && p.diameter == diameter) return p.id;
    weld_parts_.push_back({++part_, spot.from->spot_class, diameter});
    return part_;
  }

  int add_node(const Vec3d& x) {
    append(nodes_, "{:8d}{:16.9g}{:16.9g}{:16.9g}\n", ++node_, x.x, x.y, x.z);
    return node_;
  }

  void use_sheets(const Spot& spot) {
    for (const SpotSheet& s : spot.sheets) sheet_parts_.insert(model_.parts[s.part].id);
  }

  /// Across the axis of the spot, along the mesh of the first sheet.
  static Vec3d along_mesh(const Spot& spot) {
    const Vec3d& along = spot.sheets.front().along;
    const Vec3d s = along - dot(along, spot.axis) * spot.axis;
    const double length = norm(s);
    return length > 1e-6 * norm(along) ? (1.0 / length) * s : spot.sheets.front().normal;  // the axis lies in the sheet
  }

  /// Their sections lie along the mesh too: without a direction the global axes say where the points of a beam lie.
  void add_beams(const Spot& spot) {
    const int part = weld_part(spot);
    use_sheets(spot);
    const Vec3d s = along_mesh(spot);
    int below = add_node(spot.sheets.front().point);
    for (std::size_t i = 1; i < spot.sheets.size(); ++i) {
      const int above = add_node(spot.sheets[i].point);
      append(elements_, "{:8d}{:8d}{:8d}{:8d}{:8d}\n{}{}{}\n", ++element_, part, below, above, 0, real_field(s.x),
             real_field(s.y), real_field(s.z));
      ++count_;
      below = above;
    }
  }

  void add_locations(const Spot& spot) {
    const std::string diameter = fmt::format("{:.5g}", spot.diameter);
    const auto alike = [](const SpotSheet& a, const SpotSheet& b) { return a.part == b.part; };
    if (const auto layers = std::ranges::adjacent_find(spot.sheets, alike); layers != spot.sheets.end()) {
      findings_.warning(spot.from->place, {},
                        fmt::format("two layers of part {} are no two sheets for "
                                    "*CONSTRAINED_INTERPOLATION_SPOTWELD; not placed",
                                    model_.parts[layers->part].id),
                        "use --as beam, or give the layers parts of their own");
      return;
    }
    for (std::size_t i = 1; i < spot.sheets.size(); ++i) {
      const SpotSheet &below = spot.sheets[i - 1], &above = spot.sheets[i];
      const int first = model_.parts[below.part].id, second = model_.parts[above.part].id;
      const auto same = [&](const InterpolationWelds& w) {
        return w.spot_class == spot.from->spot_class && w.diameter == diameter && w.first_part == first &&
               w.second_part == second;
      };
      auto welds = std::ranges::find_if(interpolation_, same);
      if (welds == interpolation_.end())
        welds = interpolation_.insert(welds, {spot.from->spot_class, diameter, first, second, 0.0, {}});
      const double distance = norm(above.point - below.point), thick = 0.5 * (below.thickness + above.thickness);
      welds->reach = std::max(welds->reach, distance > 1e-3 * thick ? distance : thick);
      welds->nodes.push_back(add_node(0.5 * (below.point + above.point)));
      ++count_;
    }
    weld_part(spot);  // its class and diameter count for strengths
    use_sheets(spot);
  }

  /// The points of a section on one sheet, or nothing where the sheet ends before one of them. The section lies along
  /// the mesh of the first sheet, so that a model that is turned has the same welds.
  std::vector<Vec3d> on_sheet(const Spot& spot, const SpotSheet& sheet, const model::WeldSection& section) const {
    const Vec3d s = along_mesh(spot), t = cross(spot.axis, s);
    std::vector<Vec3d> points;
    for (const auto& [a, b] : section.point) {
      const auto foot = sheets_.closest(sheet.point + a * s + b * t, sheet.part, spot.diameter);
      if (!foot) return {};
      points.push_back(foot->point);
    }
    return points;
  }

  void add_bricks(const Spot& spot) {
    const model::WeldSection section =
        model::weld_section(named(form_).bricks, 0.25 * std::numbers::pi * spot.diameter * spot.diameter);
    std::vector<std::vector<Vec3d>> planes;
    for (const SpotSheet& sheet : spot.sheets) {
      planes.push_back(on_sheet(spot, sheet, section));
      if (!planes.back().empty()) continue;
      findings_.warning(spot.from->place, {},
                        fmt::format("bricks of diameter {:.4g} reach over the edge of part {} here; not placed",
                                    spot.diameter, model_.parts[sheet.part].id),
                        "move the point further in, give a smaller diameter, or use --as beam");
      return;
    }
    const int part = weld_part(spot);
    use_sheets(spot);
    int below = node_ + 1;
    for (const Vec3d& x : planes.front()) add_node(x);
    for (std::size_t i = 1; i < planes.size(); ++i) {
      const int above = node_ + 1;
      for (const Vec3d& x : planes[i]) add_node(x);
      elements_ += brick_lines(section, element_ + 1, part, below, above);
      element_ += static_cast<int>(section.quad.size());
      count_ += section.quad.size();
      below = above;
    }
  }

  std::string head(const std::string& included, std::size_t spots) const {
    return fmt::format(
        "*KEYWORD\n$ {} spots between {} sheets as {} {}, placed by nugget weld.\n$ Units: {}.\n"
        "*INCLUDE\n{}",
        spots, sheet_parts_.size(), count_, form_ == WeldForm::interpolation ? "welds" : "elements",
        units_ ? units_->name : "those of the model", deck::name_lines(included));
  }

  std::string parts() {
    std::string s;
    const bool beams = form_ == WeldForm::beam;
    if (!beams) s += brick_cards(++section_, ++hourglass_);
    for (const WeldPart& p : weld_parts_) {
      if (beams)
        s += fmt::format(
            "*SECTION_BEAM\n$#   secid    elform      shrf        qr       cst\n{:10d}{:10d}{:10.1f}{:10d}{:10d}\n"
            "$#     ts1       ts2       tt1       tt2\n{:>10}{:>10}{:10.1f}{:10.1f}\n",
            ++section_, 9, 1.0, 2, 1, p.diameter, p.diameter, 0.0, 0.0);
      int& material = material_of_[{p.spot_class, given_.strength_diameter > 0.0 ? p.diameter : std::string()}];
      if (material == 0) material = ++material_;
      s +=
          fmt::format("*PART\n{}\n$#     pid     secid       mid     eosid      hgid\n{:10d}{:10d}{:10d}{:10d}{:10d}\n",
                      title_of(p.spot_class, std::strtod(p.diameter.c_str(), nullptr)), p.id, section_, material, 0,
                      beams ? 0 : hourglass_);
    }
    return s;
  }

  const char* keyword() const {
    return form_ == WeldForm::interpolation ? "*CONSTRAINED_INTERPOLATION_SPOTWELD" : "*MAT_SPOTWELD";
  }

  /// What is given for a class.
  WeldFields given_of(const std::string& spot_class) const {
    WeldFields own;
    for (const std::string& name : {std::string(), spot_class})
      if (const auto found = given_.fields.find(name); found != given_.fields.end())
        for (const auto& [field, value] : found->second) own[field] = value;
    return own;
  }

  WeldFields default_fields() const {
    WeldFields usual{{"pr", 0.3}, {"dt", 0.0}, {"tfail", 0.0}};
    for (const std::string& name : weld_fields(form_)) usual.try_emplace(name, 0.0);
    for (const char* name : {"ro", "e", "sigy", "eh"}) usual.erase(name);
    if (units_) {
      const double megapascal = units_->steel_young / 210000.0;
      usual.insert({{"ro", units_->steel_density},
                    {"e", units_->steel_young},
                    {"sigy", 500.0 * megapascal},
                    {"eh", 1000.0 * megapascal}});
    }
    return usual;
  }

  /// What is given of a class, and what is usual of the rest.
  WeldFields completed(WeldFields own) {
    const WeldFields usual = default_fields();
    own.insert(usual.begin(), usual.end());
    for (const char* name : {"ro", "e", "sigy", "eh"})
      if (own.count(name) == 0) {
        findings_.error({model_.deck, 0, 0}, keyword(),
                        fmt::format("{} has no default, because the units of the model are not recognised", name),
                        fmt::format("give it: --material {}=...", name));
        own[name] = 0.0;
      }
    return own;
  }

  std::string materials() {
    std::string s;
    for (const auto& [key, id] : material_of_) {
      const auto& [spot_class, diameter] = key;
      WeldFields own = given_of(spot_class);
      const bool failure =
          std::any_of(own.begin(), own.end(), [](const auto& f) { return strength_power(f.first) > 0; }) ||
          own.count("efail") + own.count("tfail") > 0;
      const std::string strengths =
          diameter.empty() ? tell_same_strengths(spot_class, own) : scale_strengths(spot_class, diameter, own);
      s += fmt::format(
          "$ {}{}{}\n", whose(spot_class), strengths,
          failure ? "." : ". No failure is given: efail, or the resultants nrr to mtt, would say when a weld breaks.");
      s += material_card(id, completed(std::move(own)));
    }
    return s;
  }

  static std::string whose(const std::string& spot_class) {
    return spot_class.empty() ? "All spots" : "Class " + spot_class;
  }

  std::string interpolation_cards() {
    std::string s;
    std::set<std::string> said;
    for (const InterpolationWelds& welds : interpolation_) {
      WeldFields own = given_of(welds.spot_class);
      std::string strengths;
      if (given_.strength_diameter > 0.0)
        strengths = scale_strengths(welds.spot_class, welds.diameter, own);
      else if (said.insert(welds.spot_class).second)
        tell_same_strengths(welds.spot_class, own);
      const WeldFields fields = completed(std::move(own));
      if (const std::string fault = interpolation_fault(fields); !fault.empty())
        findings_.error({model_.deck, 0, 0}, keyword(), fault, "change --material, or use --as beam");
      if (strengths.empty()) strengths = ", diameter " + welds.diameter;
      s += fmt::format("$ {}{}{}\n", whose(welds.spot_class), strengths,
                       fields.at("upr") > 0.0 ? "."
                                              : ". No failure is given: the plastic displacements upf, where damage "
                                                "begins, and upr would say when a weld breaks.");
      s += fmt::format("*SET_NODE_LIST\n$#     sid\n{:10d}\n{}", ++set_, id_lines(welds.nodes));
      s += interpolation_card(welds, set_, fields, curve_);
    }
    return s;
  }

  static std::string material_card(int id, const WeldFields& fields) {
    std::string s = "*MAT_SPOTWELD\n$#     mid        ro         e        pr      sigy        eh        dt     tfail\n";
    s += fmt::format("{:10d}", id);
    for (const std::string& name : weld_fields(WeldForm::beam)) {
      if (name == "efail") s += "\n$#   efail       nrr       nrs       nrt       mrr       mss       mtt        nf\n";
      s += real_field(fields.at(name));
    }
    return s + '\n';
  }

  /// Strengths as given, whatever the diameter: says so of the class. For the remark in the deck: nothing.
  std::string tell_same_strengths(const std::string& spot_class, const WeldFields& own) {
    const std::string strengths = name_strengths(own);
    if (strengths.empty()) return {};
    std::set<double> diameters;
    for (const WeldPart& p : weld_parts_)
      if (p.spot_class == spot_class) diameters.insert(std::strtod(p.diameter.c_str(), nullptr));
    const std::string whose = spot_class.empty() ? "welds" : fmt::format("welds of class {}", spot_class);
    if (diameters.size() == 1) {
      findings_.note(
          {model_.deck, 0, 0}, keyword(),
          fmt::format("{} of diameter {:.4g} have the strengths as given: {}", whose, *diameters.begin(), strengths),
          "if these are of a weld of another diameter, give that: --scale-strength DIAMETER");
      return {};
    }
    findings_.warning({model_.deck, 0, 0}, keyword(),
                      fmt::format("{} of diameters {:.4g} to {:.4g} have the same strengths, the smallest those of the "
                                  "largest: {}",
                                  whose, *diameters.begin(), *diameters.rbegin(), strengths),
                      "--scale-strength DIAMETER, that of the weld they are of: forces by the square, moments by the "
                      "cube of the diameter; or a class for each diameter with its own strengths");
    return {};
  }

  /// Brings the strengths of a class from their diameter to that of its welds, and says so; a remark for the deck.
  std::string scale_strengths(const std::string& spot_class, const std::string& diameter, WeldFields& own) {
    const std::string before = name_strengths(own);
    const double ratio = std::strtod(diameter.c_str(), nullptr) / given_.strength_diameter;
    for (auto& [field, value] : own)
      if (const int power = strength_power(field); power > 0) value *= std::pow(ratio, power);
    if (before.empty() || before == name_strengths(own)) return {};
    findings_.note({model_.deck, 0, 0}, keyword(),
                   fmt::format("welds{} of diameter {} have {}, scaled from diameter {:.4g}: {}",
                               spot_class.empty() ? "" : " of class " + spot_class, diameter, name_strengths(own),
                               given_.strength_diameter, before));
    return fmt::format(", diameter {}: {} of diameter {:.5g}, forces by (d/D)^2, moments by (d/D)^3", diameter, before,
                       given_.strength_diameter);
  }

  static std::string id_lines(const std::vector<int>& ids) {
    std::string s;
    for (std::size_t i = 0; i < ids.size(); ++i)
      s += fmt::format("{:10d}{}", ids[i], i % 8 == 7 || i + 1 == ids.size() ? "\n" : "");
    return s;
  }

  std::string ties() {
    std::vector<int> welds;
    for (const WeldPart& p : weld_parts_) welds.push_back(p.id);
    const int weld_set = ++set_, sheet_set = ++set_;
    std::string s = fmt::format(
        "*SET_PART_LIST_TITLE\nspot welds\n{:10d}\n{}*SET_PART_LIST_TITLE\nwelded sheets\n{:10d}\n{}"
        "$ Each weld node is tied to the closest sheet; the weld follows it.\n*CONTACT_SPOTWELD_ID\n{:10d}welds to "
        "sheets\n"
        "$#   surfa     surfb  surfatyp  surfbtyp\n{:10d}{:10d}{:10d}{:10d}\n$#      fs\n\n$#    sfsa\n\n",
        weld_set, id_lines(welds), sheet_set, id_lines({sheet_parts_.begin(), sheet_parts_.end()}), ++contact_,
        weld_set, sheet_set, 2, 2);
    return s;
  }

  /// Of a deck that does not say when it ends, as one that others include, those say what is written.
  std::string request() const {
    if (model_.requests["swforc"].asked() || !(model_.control.end_time > 0.0)) return {};
    return fmt::format("*DATABASE_SWFORC\n$#      dt\n{}\n", real_field(1e-3 * model_.control.end_time));
  }

  std::string mesh() const {
    return "*NODE\n$#   nid               x               y               z\n" + nodes_ +
           (elements_.empty()         ? ""
            : form_ == WeldForm::beam ? "*ELEMENT_BEAM_ORIENTATION\n$#   eid     pid      n1      n2      n3\n"
                                        "$#      vx        vy        vz\n"
                                      : brick_header) +
           elements_ + "*END\n";
  }

  const model::Model& model_;
  const Sheets& sheets_;
  WeldForm form_;
  const GivenMaterial& given_;
  Findings& findings_;
  std::optional<model::Units> units_;
  int node_ = 0, element_ = 0, part_ = 0, section_ = 0, material_ = 0, hourglass_ = 0, set_ = 0, contact_ = 0,
      curve_ = 0;
  std::size_t count_ = 0;  // of elements
  std::string nodes_, elements_;
  std::vector<WeldPart> weld_parts_;
  std::vector<InterpolationWelds> interpolation_;
  std::set<int> sheet_parts_;
  std::map<std::pair<std::string, std::string>, int> material_of_;  // by class, and diameter where strengths scale
};

}  // namespace

const std::vector<std::string>& weld_fields(WeldForm form) {
  static const std::vector<std::string> names{"ro",  "e",   "pr",  "sigy", "eh",  "dt",  "tfail", "efail",
                                              "nrr", "nrs", "nrt", "mrr",  "mss", "mtt", "nf"};
  static const std::vector<std::string> interpolation{"ro",  "e",   "pr",  "sigy", "eh", "nrr",
                                                      "nrs", "mrr", "mss", "upf",  "upr"};
  return form == WeldForm::interpolation ? interpolation : names;
}

int strength_power(const std::string& field) {
  static const std::set<std::string> forces{"nrr", "nrs", "nrt"}, moments{"mrr", "mss", "mtt"};
  return forces.count(field) > 0 ? 2 : moments.count(field) > 0 ? 3 : 0;
}

PlacementDeck write_placement(const model::Model& model, const Sheets& sheets, const std::vector<Spot>& spots,
                              WeldForm form, const GivenMaterial& given, const std::string& included,
                              Findings& findings) {
  return PlacementWriter(model, sheets, form, given, findings).write(spots, included);
}

}  // namespace nugget::weld
