// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <optional>

#include "reading/builder/common_cards.hpp"
#include "reading/builder/passes.hpp"
#include "reading/cards/families.hpp"

// Springs and dampers: *ELEMENT_DISCRETE, *SECTION_DISCRETE, *DEFINE_SD_ORIENTATION, *MAT_SPRING_..., *MAT_DAMPER_...
// Layouts: public keyword tables (PyDYNA).
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;
using deck::Row;

constexpr Dimension force_per_length{1, 0, -2}, viscosity{1, 0, -1};

const Card element_card{{
    wide(id("eid", IdSpace::element, required, "element id"), 8),
    wide(id("pid", IdSpace::part, required, "part id"), 8),
    wide(id("n1", IdSpace::node, required, "node 1"), 8),
    wide(id("n2", IdSpace::node, 0, "node 2; 0: the ground"), 8),
    wide(id("vid", IdSpace::define, 0, "*DEFINE_SD_ORIENTATION; 0: along the line of the nodes"), 8),
    wide(real("s", dimension::number, 1, any_value, "factor on its forces"), 16),
    wide(integer("pf", 0, between(0, 1), "1: not in deforc"), 8),
    wide(real("offset", dimension::length, 0, any_value, "elongation or twist at time 0"), 16),
}};

const Card section_card{{
    id("secid", IdSpace::other, required, "section id"),
    integer("dro", 0, between(0, 1), "0 along its line (force, elongation), 1 about it (moment, twist)"),
    real("kd", dimension::number, 0, at_least(0), "the force is multiplied by 1 + KD |v|/V0"),
    real("v0", dimension::velocity, 0, at_least(0), "velocity that KD refers to"),
    real("cl", dimension::length, 0, at_least(0), "clearance: compression without force, and none in tension"),
    real("fd", dimension::length, 0, any_value, "fails at this elongation, or compression where negative; 0: never"),
}};

const Card limit_card{{
    real("cdl", dimension::length, 0, any_value, "stop in compression; 0: none"),
    real("tdl", dimension::length, 0, any_value, "stop in tension; 0: none"),
}};

const Card orientation_card{{
    id("vid", IdSpace::define, required, "id"),
    integer("iop", 0, between(0, 3),
            "0 along a vector, 1 along the nodes' line in the plane normal to it, 2 and 3 the same with the vector "
            "from nid1 to nid2"),
    real("xt", dimension::number, 0, any_value, "vector x (iop 0, 1)"),
    real("yt", dimension::number, 0, any_value, "vector y"),
    real("zt", dimension::number, 0, any_value, "vector z"),
    id("nid1", IdSpace::node, 0, "node 1 (iop 2, 3)"),
    id("nid2", IdSpace::node, 0, "node 2"),
}};

constexpr Field material_id = id("mid", IdSpace::material, required, "material id");

const Card elastic_card{{material_id, real("k", force_per_length, required, above_zero(), "stiffness")}};
const Card viscous_card{{material_id, real("dc", viscosity, required, above_zero(), "damping constant")}};
const Card elastoplastic_card{{
    material_id,
    real("k", force_per_length, required, above_zero(), "stiffness up to yield"),
    real("kt", force_per_length, 0, at_least(0), "tangent stiffness beyond it"),
    real("fy", dimension::force, required, above_zero(), "yield force or moment"),
}};
const Card nonlinear_card{{
    material_id,
    id("lcd", IdSpace::function, required, "force over elongation; one that starts at 0 holds for both signs"),
    id("lcr", IdSpace::function, 0, "factor on that force over its rate; 0: 1"),
}};
const Card nonlinear_viscous_card{{
    material_id,
    id("lcdr", IdSpace::function, required, "force over rate of elongation; one that starts at 0: both signs"),
}};
const Card reversing_card{{
    material_id,
    id("lcdl", IdSpace::function, required, "force over elongation while loading, from compression to tension"),
    id("lcdu", IdSpace::function, required, "the same while unloading; it rises everywhere"),
    real("beta", dimension::number, 0, any_value, "0 each side hardens or softens for itself, 1 isotropic hardening"),
    real("tyi", dimension::force, 0, at_least(0), "yield force in tension"),
    real("cyi", dimension::force, 0, {-std::numeric_limits<double>::infinity(), 0.0}, "in compression, negative"),
}};
const Card maxwell_card{{
    material_id,
    real("k0", force_per_length, required, above_zero(), "stiffness at once"),
    real("ki", force_per_length, 0, at_least(0), "stiffness in the end"),
    real("beta", dimension::rate, 0, at_least(0), "rate of relaxation"),
    real("tc", dimension::time, 1e20, above_zero(), "after this time the force is fc"),
    real("fc", dimension::force, 1e20, any_value, "force after tc"),
    real("copt", dimension::number, 0, only(0), "1: stiffness over the time of the run, also where nothing moves"),
}};
const Card inelastic_card{{
    material_id,
    id("lcfd", IdSpace::function, required, "force over the amount of elongation, both positive"),
    real("ku", force_per_length, 0, at_least(0), "stiffness of unloading; at least the steepest slope of lcfd"),
    real("ctf", dimension::number, 1, between(-1, 1), "1 in compression only, -1 in tension only"),
}};

// ---- elements
// --------------------------------------------------------------------------------------------------------

void add_element(Builder& b, const Row& row) {
  Discrete d;
  d.id = row.integer("eid");
  d.place = row.place();
  if (!b.discretes.add(d.id, static_cast<Index>(b.model.discretes.size()), d.place, row.keyword(), "discrete element",
                       b.findings))
    return;
  d.part = b.part(row, "pid");
  d.node = {b.node(row, "n1"), b.node(row, "n2")};
  d.scale = row.real("s");
  d.offset = row.real("offset");
  d.in_deforc = row.integer("pf") == 0;
  if (d.part == none || d.node[0] == none || (d.node[1] == none && row.integer("n2") != 0)) return;
  Part& part = b.model.parts[static_cast<std::size_t>(d.part)];
  if (part.kind == ElementKind::nothing) part.kind = ElementKind::discrete;
  if (part.kind != ElementKind::discrete)
    return refuse(b, row, "pid", "the part already has elements of another kind", "give them a part of their own");
  b.model.discretes.push_back(d);
}

/// A line to act along: that of the nodes, unless there is none.
void link_orientation(Builder& b, const Row& row, double length) {
  const Index e = b.discretes.find(row.integer("eid"));
  if (e == none || static_cast<std::size_t>(e) >= b.model.discretes.size()) return;
  Discrete& d = b.model.discretes[static_cast<std::size_t>(e)];
  const Part& part = b.model.parts[static_cast<std::size_t>(d.part)];
  if (part.section != none && b.model.discrete_sections[static_cast<std::size_t>(part.section)].torsional)
    d.offset /= length;  // an angle, which the table has for a length
  d.orientation = b.find(b.spring_orientations, "orientation", row, "vid");
  if (row.integer("vid") != 0) return;
  const auto at = [&](Index n) { return b.model.nodes.x[static_cast<std::size_t>(n)]; };
  if (!d.grounded() && norm(at(d.node[1]) - at(d.node[0])) > 0.0) return;
  refuse(
      b, row, "vid",
      d.grounded() ? "a spring to the ground has no line of its own" : "both nodes are at one place: there is no line",
      "give a *DEFINE_SD_ORIENTATION");
}

void read_elements(Builder& b, const Block& block, const Options&) {
  for (Cursor cursor(b.deck, block, b.findings); !at_end(cursor);) {
    const Row row = cursor.read(element_card);
    b.discrete_rows.push_back(row);
    b.defer(Phase::systems, [row, length = block.transform ? block.transform->length : 1.0](Builder& later) {
      link_orientation(later, row, length);
    });
  }
}

void read_section(Builder& b, const Block& block, const Options& options) {
  for (Cursor cursor(b.deck, block, b.findings); !at_end(cursor);) {
    read_title(cursor, options);
    const Row row = cursor.read(section_card), limits = cursor.read(limit_card);
    SectionDiscrete s;
    s.id = row.integer("secid");
    s.place = row.place();
    s.torsional = row.integer("dro") == 1;
    // The table has lengths; of a torsional spring they are angles.
    const double lever = s.torsional && block.transform ? block.transform->length : 1.0;
    s.clearance = row.real("cl") / lever;
    s.failure = row.real("fd") / lever;
    s.most_compression = std::abs(limits.real("cdl"));
    s.most_elongation = std::abs(limits.real("tdl"));
    if (row.real("kd") > 0.0) {
      if (row.real("v0") > 0.0)
        s.magnification = row.real("kd") / (row.real("v0") / lever);
      else
        refuse(b, row, "v0", "KD needs the velocity that it refers to", "give V0");
    }
    if (s.torsional && (s.most_compression > 0.0 || s.most_elongation > 0.0))
      refuse(b, limits, s.most_compression > 0.0 ? "cdl" : "tdl", "stops of torsional springs are not built",
             "give a law whose moment rises steeply there");
    b.discrete_sections.add(s.id, static_cast<Index>(b.model.discrete_sections.size()), s.place, row.keyword(),
                            "discrete section", b.findings);
    b.model.discrete_sections.push_back(s);
  }
}

void link_nodes(Builder& b, const Row& row, std::size_t index) {
  SpringOrientation& o = b.model.spring_orientations[index];
  o.node = {b.node(row, "nid1"), b.node(row, "nid2")};
  if (o.node[0] == none || o.node[1] == none) {
    if (row.integer("nid1") == 0 || row.integer("nid2") == 0)
      refuse(b, row, row.integer("nid1") == 0 ? "nid1" : "nid2", "IOP 2 and 3 need two nodes", "give both");
    return;
  }
  const auto at = [&](Index n) { return b.model.nodes.x[static_cast<std::size_t>(n)]; };
  if (!(norm(at(o.node[1]) - at(o.node[0])) > 0.0))
    refuse(b, row, "nid2", "both nodes are at one place, so they give no direction", "take two nodes apart");
}

void read_orientation(Builder& b, const Block& block, const Options& options) {
  for (Cursor cursor(b.deck, block, b.findings); !at_end(cursor);) {
    read_title(cursor, options);
    const Row row = cursor.read(orientation_card);
    SpringOrientation o;
    o.id = row.integer("vid");
    o.place = row.place();
    const int option = row.integer("iop");
    o.in_plane = option == 1 || option == 3;
    const auto index = b.model.spring_orientations.size();
    if (option < 2) {
      const Vec3d v = direction(block, row, "xt", "yt", "zt");
      if (norm(v) > 0.0)
        o.direction = unit(v);
      else
        refuse(b, row, "xt", "the vector has no length", "give its components");
    } else {
      b.defer(Phase::systems, [row, index](Builder& later) { link_nodes(later, row, index); });
    }
    b.spring_orientations.add(o.id, static_cast<Index>(index), o.place, block.starred(), "orientation", b.findings);
    b.model.spring_orientations.push_back(o);
  }
}

// ---- laws
// ------------------------------------------------------------------------------------------------------------

/// What fills a law from its row. The card's table gives the constants of a line, force and length; `lever` is the
/// length by which those of a twist, moment and angle, are converted besides: FCTLEN where the spring is torsional.
/// Curves stay, see *DEFINE_CURVE.
using Fill = void (*)(Builder&, const Row&, double lever, kernel::Spring&);

Curve curve_of(Builder& b, const Row& row, std::string_view field) {
  const Index c = b.curve(row, field);
  return c == none ? Curve{} : b.model.curves[static_cast<std::size_t>(c)];
}

kernel::ForceCurve force_curve(Builder& b, const Row& row, std::string_view field) {
  const Curve c = curve_of(b, row, field);
  return c.empty() ? kernel::ForceCurve{} : kernel::ForceCurve(c);
}

using Kind = kernel::DiscreteSpring::Kind;

void fill_elastic(Builder&, const Row& row, double lever, kernel::Spring& spring) {
  kernel::DiscreteSpring law;
  law.kind = Kind::linear;
  law.stiffness = row.real("k") * lever * lever;
  spring.law = law;
}

void fill_viscous(Builder&, const Row& row, double lever, kernel::Spring& spring) {
  kernel::DiscreteSpring law;
  law.damping = row.real("dc") * lever * lever;
  spring.law = law;
}

void fill_elastoplastic(Builder& b, const Row& row, double lever, kernel::Spring& spring) {
  const double k = row.real("k") * lever * lever, tangent = row.real("kt") * lever * lever;
  const double yield = row.real("fy") * lever;
  if (!(tangent < k))
    return refuse(b, row, "kt", "the tangent stiffness must be less than the elastic one",
                  "*MAT_SPRING_ELASTIC needs none");
  kernel::DiscreteSpring law;
  law.kind = Kind::elastoplastic;
  law.stiffness = k;
  Curve hardening;
  hardening.x = {0.0, yield / k};
  hardening.y = {yield, yield * (1.0 + tangent / (k - tangent))};
  law.load = law.unload = kernel::ForceCurve(hardening);
  spring.law = law;
}

/// Warns of a curve for both signs that does not go through 0, 0.
void report_leap(Builder& b, const Row& row, std::string_view field, const kernel::ForceCurve& force) {
  const double leap = force(1e-300);
  if (force.empty() || force(-1e-300) != -leap || std::abs(leap) <= 1e-9 * force.largest()) return;
  row.report(b.findings, Severity::warning, field,
             fmt::format("the curve holds for both signs: at 0 the force leaps from {:g} to {:g}", -leap, leap),
             "let the curve begin at 0, 0, or give both sides");
}

void fill_nonlinear(Builder& b, const Row& row, double, kernel::Spring& spring) {
  kernel::DiscreteSpring law;
  law.kind = Kind::elastic;
  law.load = force_curve(b, row, "lcd");
  report_leap(b, row, "lcd", law.load);
  law.rate_scale = force_curve(b, row, "lcr");
  spring.law = law;
}

/// A rate at which the force has the other sign: a point of the curve, or one beyond, where its end slopes go on.
std::optional<double> driving_rate(const Curve& curve, const kernel::ForceCurve& force) {
  if (curve.empty()) return std::nullopt;
  for (const double v : curve.x)
    if (v * force(v) < 0.0) return v;
  for (const double end : {curve.x.front(), curve.x.back()}) {
    const double slope = force.slope(end), least = end - force(end) / slope;
    if (end != 0.0 && slope < 0.0) return least + 0.01 * end;
  }
  return std::nullopt;
}

void fill_nonlinear_viscous(Builder& b, const Row& row, double, kernel::Spring& spring) {
  kernel::DiscreteSpring law;
  law.damper = force_curve(b, row, "lcdr");
  report_leap(b, row, "lcdr", law.damper);
  if (const std::optional<double> rate = driving_rate(curve_of(b, row, "lcdr"), law.damper); rate)
    row.report(b.findings, Severity::warning, "lcdr",
               fmt::format("at a rate of {:g} the force drives the motion: the damper makes energy", *rate),
               "give forces of the sign of their rate, and end slopes that do not lead to the other sign");
  spring.law = law;
}

/// A yield force from which the way back along the unloading curve is longer than the way there was.
std::optional<double> too_soft_unloading(const kernel::ReversingSpring& law) {
  std::vector<double> forces = law.load.y;
  forces.insert(forces.end(), {law.tension_yield, law.compression_yield});
  for (const double force : forces) {
    if (force == 0.0 || (force < law.tension_yield && force > law.compression_yield)) continue;
    const auto way = [&](const Curve& curve) { return kernel::ReversingSpring::reach(curve, 0.0, force, force > 0.0); };
    if (std::abs(way(law.unload)) > (1.0 + 1e-9) * std::abs(way(law.load))) return force;
  }
  return std::nullopt;
}

void fill_reversing(Builder& b, const Row& row, double lever, kernel::Spring& spring) {
  kernel::ReversingSpring law;
  law.load = curve_of(b, row, "lcdl");
  law.unload = curve_of(b, row, "lcdu");
  law.tension_yield = row.real("tyi") * lever;
  law.compression_yield = row.real("cyi") * lever;
  law.isotropic = row.real("beta") == 1.0;
  spring.law = law;
  if (law.load.empty() || law.unload.empty()) return;
  if (row.real("beta") != 0.0 && row.real("beta") != 1.0)
    refuse(b, row, "beta", "kinematic hardening is not built: which curve the reversed load follows is not documented",
           "write 0 or 1");
  const auto rises = [](const Curve& c) {
    for (std::size_t i = 0; i + 1 < c.x.size(); ++i)
      if (!(c.y[i + 1] > c.y[i])) return false;
    return c.x.size() > 1;
  };
  if (!rises(law.unload))
    refuse(b, row, "lcdu", "the unloading curve must rise from each point to the next", "give two points or more");
  if (law.load.x.size() < 2) refuse(b, row, "lcdl", "the curve needs two points or more", "add points");
  if (law.isotropic && !rises(law.load))
    refuse(b, row, "lcdl", "with isotropic hardening the loading curve must rise from each point to the next",
           "write BETA 0 for a curve that softens");
  if (const std::optional<double> force = too_soft_unloading(law); force)
    row.report(b.findings, Severity::warning, "lcdu",
               fmt::format("unloaded from {:g} the spring gives back more energy than loading took", *force),
               "make the unloading curve at least as steep as the loading curve");
}

void fill_maxwell(Builder& b, const Row& row, double lever, kernel::Spring& spring) {
  kernel::MaxwellSpring law;
  law.instantaneous_stiffness = row.real("k0") * lever * lever;
  law.long_term_stiffness = row.real("ki") * lever * lever;
  law.decay = row.real("beta");
  law.cut_off = row.real("tc");
  law.last_force = row.real("fc") * lever;
  spring.law = law;
  if (law.cut_off < 1e20 && law.last_force >= 1e20) refuse(b, row, "fc", "TC needs the force that follows", "give FC");
}

void fill_inelastic(Builder& b, const Row& row, double lever, kernel::Spring& spring) {
  kernel::InelasticSpring law;
  law.load = force_curve(b, row, "lcfd");
  law.unloading = std::max(row.real("ku") * lever * lever, law.load.steepest());
  law.tension = row.real("ctf") == -1.0;
  if (std::abs(row.real("ctf")) != 1.0) refuse(b, row, "ctf", "expected -1 or 1");
  spring.law = law;
  const Curve c = curve_of(b, row, "lcfd");
  if (!c.empty() && (c.x.front() < 0.0 || law.load.lowest() < 0.0))
    refuse(b, row, "lcfd", "the curve must lie in the positive quadrant, also for compression", "turn its signs");
  if (!c.empty() && !(law.unloading > 0.0))
    refuse(b, row, "ku", "a curve of constant force needs a stiffness of unloading", "give KU");
}

double length_factor(const Block& block) {
  return block.transform ? block.transform->length : 1.0;
}

/// The length factor where the springs of this law turn, 1 where they act along a line.
double lever_of(Builder& b, const Row& row, std::size_t material, double length) {
  if (length == 1.0) return 1.0;
  std::array<bool, 2> used{};
  for (const Part& part : b.model.parts)
    if (part.kind == ElementKind::discrete && part.material == static_cast<Index>(material) && part.section != none)
      used[b.model.discrete_sections[static_cast<std::size_t>(part.section)].torsional] = true;
  if (used[0] && used[1])
    refuse(b, row, "mid", "springs along a line and torsional ones share this law, which FCTLEN makes two of",
           "give the torsional springs a law of their own");
  return used[1] ? length : 1.0;
}

template <const Card& card, Fill fill>
void read_law(Builder& b, const Block& block, const Options& options) {
  for (Cursor cursor(b.deck, block, b.findings); !at_end(cursor);) {
    std::string title = read_title(cursor, options);
    const Row row = cursor.read(card);
    const auto index = b.model.materials.size();
    std::string name =
        block.keyword.ends_with("_TITLE") ? block.keyword.substr(0, block.keyword.size() - 6) : block.keyword;
    Material m{row.integer("mid"), std::move(title), std::move(name), 0.0, kernel::Spring{}, row.place()};
    b.materials.add(m.id, static_cast<Index>(index), m.place, row.keyword(), "material", b.findings);
    b.model.materials.push_back(std::move(m));
    // Curves may be defined later in the deck, and which springs turn is known when parts have their sections.
    b.defer(Phase::systems, [row, index, length = length_factor(block)](Builder& later) {
      const double lever = lever_of(later, row, index, length);
      fill(later, row, lever, std::get<kernel::Spring>(later.model.materials[index].law));
    });
  }
}

template <const Card& card, Fill fill>
Keyword law(std::string_view name, std::string_view number) {
  return {
      .name = name, .aliases = {number}, .options = {"TITLE"}, .layout = {{"", &card}}, .read = read_law<card, fill>};
}

}  // namespace

void make_discretes(Builder& b) {
  for (const Row& row : b.discrete_rows) add_element(b, row);
}

std::vector<Keyword> spring_keywords() {
  return {
      {.name = "ELEMENT_DISCRETE", .layout = {{"", &element_card}}, .read = read_elements},
      {.name = "SECTION_DISCRETE",
       .options = {"TITLE"},
       .layout = {{"", &section_card}, {"", &limit_card}},
       .read = read_section},
      {.name = "DEFINE_SD_ORIENTATION",
       .options = {"TITLE"},
       .layout = {{"", &orientation_card}},
       .read = read_orientation},
      law<elastic_card, fill_elastic>("MAT_SPRING_ELASTIC", "MAT_S01"),
      law<viscous_card, fill_viscous>("MAT_DAMPER_VISCOUS", "MAT_S02"),
      law<elastoplastic_card, fill_elastoplastic>("MAT_SPRING_ELASTOPLASTIC", "MAT_S03"),
      law<nonlinear_card, fill_nonlinear>("MAT_SPRING_NONLINEAR_ELASTIC", "MAT_S04"),
      law<nonlinear_viscous_card, fill_nonlinear_viscous>("MAT_DAMPER_NONLINEAR_VISCOUS", "MAT_S05"),
      law<reversing_card, fill_reversing>("MAT_SPRING_GENERAL_NONLINEAR", "MAT_S06"),
      law<maxwell_card, fill_maxwell>("MAT_SPRING_MAXWELL", "MAT_S07"),
      law<inelastic_card, fill_inelastic>("MAT_SPRING_INELASTIC", "MAT_S08"),
  };
}

}  // namespace nugget::reading
