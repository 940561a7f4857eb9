// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <optional>

#include "base/index.hpp"
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
using deck::RowOf;

const CardOf<DiscreteCard> element_card{
    {&DiscreteCard::eid, wide(id("eid", IdSpace::element, required, "element id"), 8)},
    {&DiscreteCard::pid, wide(id("pid", IdSpace::part, required, "part id"), 8)},
    {&DiscreteCard::n1, wide(id("n1", IdSpace::node, required, "node 1"), 8)},
    {&DiscreteCard::n2, wide(id("n2", IdSpace::node, 0, "node 2; 0: the ground"), 8)},
    {&DiscreteCard::vid,
     wide(id("vid", IdSpace::define, 0, "*DEFINE_SD_ORIENTATION; 0: along the line of the nodes"), 8)},
    {&DiscreteCard::s, wide(real("s", dimension::number, 1, any_value, "factor on its forces"), 16)},
    {&DiscreteCard::pf, wide(integer("pf", 0, between(0, 1), "1: not in deforc"), 8)},
    {&DiscreteCard::offset, wide(real("offset", dimension::length, 0, any_value, "elongation or twist at time 0"), 16)},
};

struct DiscreteSectionCard {
  int secid = 0, dro = 0;
  double kd = 0, v0 = 0, cl = 0, fd = 0;
};
const CardOf<DiscreteSectionCard> discrete_section_card{
    {&DiscreteSectionCard::secid, id("secid", IdSpace::other, required, "section id")},
    {&DiscreteSectionCard::dro,
     integer("dro", 0, between(0, 1), "0 along its line (force, elongation), 1 about it (moment, twist)")},
    {&DiscreteSectionCard::kd,
     real("kd", dimension::number, 0, at_least(0), "the force is multiplied by 1 + KD |v|/V0")},
    {&DiscreteSectionCard::v0, real("v0", dimension::velocity, 0, at_least(0), "velocity that KD refers to")},
    {&DiscreteSectionCard::cl,
     real("cl", dimension::length, 0, at_least(0), "clearance: compression without force, and none in tension")},
    {&DiscreteSectionCard::fd,
     real("fd", dimension::length, 0, any_value, "fails at this elongation, or compression where negative; 0: never")},
};

struct LimitCard {
  double cdl = 0, tdl = 0;
};
const CardOf<LimitCard> limit_card{
    {&LimitCard::cdl, real("cdl", dimension::length, 0, any_value, "stop in compression; 0: none")},
    {&LimitCard::tdl, real("tdl", dimension::length, 0, any_value, "stop in tension; 0: none")},
};

struct OrientationCard {
  int vid = 0, iop = 0;
  double xt = 0, yt = 0, zt = 0;
  int nid1 = 0, nid2 = 0;
};
const CardOf<OrientationCard> orientation_card{
    {&OrientationCard::vid, id("vid", IdSpace::define, required, "id")},
    {&OrientationCard::iop,
     integer("iop", 0, between(0, 3),
             "0 along a vector, 1 along the nodes' line in the plane normal to it, 2 and 3 the same with the vector "
             "from nid1 to nid2")},
    {&OrientationCard::xt, real("xt", dimension::number, 0, any_value, "vector x (iop 0, 1)")},
    {&OrientationCard::yt, real("yt", dimension::number, 0, any_value, "vector y")},
    {&OrientationCard::zt, real("zt", dimension::number, 0, any_value, "vector z")},
    {&OrientationCard::nid1, id("nid1", IdSpace::node, 0, "node 1 (iop 2, 3)")},
    {&OrientationCard::nid2, id("nid2", IdSpace::node, 0, "node 2")},
};

struct SpringLawCard {
  int mid = 0;
};
constexpr IntegerField spring_material_id = id("mid", IdSpace::material, required, "material id");

struct ElasticSpringCard : SpringLawCard {
  double k = 0;
};
const CardOf<ElasticSpringCard> elastic_spring_card{
    {&SpringLawCard::mid, spring_material_id},
    {&ElasticSpringCard::k, real("k", dimension::force_per_length, required, above_zero(), "stiffness")},
};
struct ViscousCard : SpringLawCard {
  double dc = 0;
};
const CardOf<ViscousCard> viscous_card{
    {&SpringLawCard::mid, spring_material_id},
    {&ViscousCard::dc, real("dc", dimension::damping_constant, required, above_zero(), "damping constant")},
};
struct ElastoplasticCard : SpringLawCard {
  double k = 0, kt = 0, fy = 0;
};
const CardOf<ElastoplasticCard> elastoplastic_card{
    {&SpringLawCard::mid, spring_material_id},
    {&ElastoplasticCard::k, real("k", dimension::force_per_length, required, above_zero(), "stiffness up to yield")},
    {&ElastoplasticCard::kt, real("kt", dimension::force_per_length, 0, at_least(0), "tangent stiffness beyond it")},
    {&ElastoplasticCard::fy, real("fy", dimension::force, required, above_zero(), "yield force or moment")},
};
struct NonlinearCard : SpringLawCard {
  int lcd = 0, lcr = 0;
};
const CardOf<NonlinearCard> nonlinear_card{
    {&SpringLawCard::mid, spring_material_id},
    {&NonlinearCard::lcd,
     id("lcd", IdSpace::function, required, "force over elongation; one that starts at 0 holds for both signs")},
    {&NonlinearCard::lcr, id("lcr", IdSpace::function, 0, "factor on that force over its rate; 0: 1")},
};
struct NonlinearViscousCard : SpringLawCard {
  int lcdr = 0;
};
const CardOf<NonlinearViscousCard> nonlinear_viscous_card{
    {&SpringLawCard::mid, spring_material_id},
    {&NonlinearViscousCard::lcdr,
     id("lcdr", IdSpace::function, required, "force over rate of elongation; one that starts at 0: both signs")},
};
struct ReversingCard : SpringLawCard {
  int lcdl = 0, lcdu = 0;
  double beta = 0, tyi = 0, cyi = 0;
};
const CardOf<ReversingCard> reversing_card{
    {&SpringLawCard::mid, spring_material_id},
    {&ReversingCard::lcdl,
     id("lcdl", IdSpace::function, required, "force over elongation while loading, from compression to tension")},
    {&ReversingCard::lcdu, id("lcdu", IdSpace::function, required, "the same while unloading; it rises everywhere")},
    {&ReversingCard::beta,
     real("beta", dimension::number, 0, any_value, "0 each side hardens or softens for itself, 1 isotropic hardening")},
    {&ReversingCard::tyi, real("tyi", dimension::force, 0, at_least(0), "yield force in tension")},
    {&ReversingCard::cyi,
     real("cyi", dimension::force, 0, {-std::numeric_limits<double>::infinity(), 0.0}, "in compression, negative")},
};
struct MaxwellCard : SpringLawCard {
  double k0 = 0, ki = 0, beta = 0, tc = 0, fc = 0;
};
const CardOf<MaxwellCard> maxwell_card{
    {&SpringLawCard::mid, spring_material_id},
    {&MaxwellCard::k0, real("k0", dimension::force_per_length, required, above_zero(), "stiffness at once")},
    {&MaxwellCard::ki, real("ki", dimension::force_per_length, 0, at_least(0), "stiffness in the end")},
    {&MaxwellCard::beta, real("beta", dimension::rate, 0, at_least(0), "rate of relaxation")},
    {&MaxwellCard::tc, real("tc", dimension::time, 1e20, above_zero(), "after this time the force is fc")},
    {&MaxwellCard::fc, real("fc", dimension::force, 1e20, any_value, "force after tc")},
    real("copt", dimension::number, 0, only(0), "1: stiffness over the time of the run, also where nothing moves"),
};
struct InelasticCard : SpringLawCard {
  int lcfd = 0;
  double ku = 0, ctf = 0;
};
const CardOf<InelasticCard> inelastic_card{
    {&SpringLawCard::mid, spring_material_id},
    {&InelasticCard::lcfd,
     id("lcfd", IdSpace::function, required, "force over the amount of elongation, both positive")},
    {&InelasticCard::ku, real("ku", dimension::force_per_length, 0, at_least(0),
                              "stiffness of unloading; at least the steepest slope of lcfd")},
    {&InelasticCard::ctf,
     real("ctf", dimension::number, 1, between(-1, 1), "1 in compression only, -1 in tension only")},
};

// ---- elements

void add_element(Builder& b, const RowOf<DiscreteCard>& row) {
  Discrete d;
  d.id = row->eid;
  d.place = row.place();
  if (!b.discretes.add(d.id, static_cast<Index>(b.model.discretes.size()), d.place, row.keyword(), "discrete element",
                       b.findings))
    return;
  d.part = b.part(row[&DiscreteCard::pid]);
  d.node = {b.node(row[&DiscreteCard::n1]), b.node(row[&DiscreteCard::n2])};
  d.scale = row->s;
  d.offset = row->offset;
  d.in_deforc = row->pf == 0;
  if (d.part == none || d.node[0] == none || (d.node[1] == none && row->n2 != 0)) return;
  Part& part = b.model.parts[d.part];
  if (part.kind == ElementKind::nothing) part.kind = ElementKind::discrete;
  if (part.kind != ElementKind::discrete)
    return refuse(b, row[&DiscreteCard::pid], "the part already has elements of another kind",
                  "give them a part of their own");
  b.model.discretes.push_back(d);
}

/// A line to act along: that of the nodes, unless there is none.
void link_orientation(Builder& b, const RowOf<DiscreteCard>& row, double length, bool mirrored) {
  const Index e = b.discretes.find(row->eid);
  if (e == none || at(e) >= b.model.discretes.size()) return;
  Discrete& d = b.model.discretes[e];
  const Part& part = b.model.parts[d.part];
  if (part.section != none && b.model.discrete_sections[part.section].torsional) {
    d.offset /= length;  // an angle, which the table has for a length
    if (mirrored) refuse(b, row[&DiscreteCard::pid], turning_in_mirror, mirror_remedy);
  }
  d.orientation = b.find(b.spring_orientations, "orientation", row[&DiscreteCard::vid]);
  if (row->vid != 0) return;
  const auto at = [&](Index n) { return b.model.nodes.x[n]; };
  if (!d.grounded() && norm(at(d.node[1]) - at(d.node[0])) > 0.0) return;
  refuse(
      b, row[&DiscreteCard::vid],
      d.grounded() ? "a spring to the ground has no line of its own" : "both nodes are at one place: there is no line",
      "give a *DEFINE_SD_ORIENTATION");
}

void read_elements(Builder& b, const Block& block, const Options&) {
  for (Cursor cursor(b.deck, block, b.findings); !at_end(cursor);) {
    const auto row = cursor.read(element_card);
    b.discrete_rows.push_back(row);
    b.defer(Phase::systems,
            [row, length = block.transform ? block.transform->length : 1.0,
             mirrored = is_mirrored(block)](Builder& later) { link_orientation(later, row, length, mirrored); });
  }
}

void read_section(Builder& b, const Block& block, const Options& options) {
  for (Cursor cursor(b.deck, block, b.findings); !at_end(cursor);) {
    read_title(cursor, options);
    const auto row = cursor.read(discrete_section_card);
    const auto limits = cursor.read(limit_card);
    SectionDiscrete s;
    s.id = row->secid;
    s.place = row.place();
    s.torsional = row->dro == 1;
    // The table has lengths; of a torsional spring they are angles.
    const double lever = s.torsional && block.transform ? block.transform->length : 1.0;
    s.clearance = row->cl / lever;
    s.failure = row->fd / lever;
    s.most_compression = std::abs(limits->cdl);
    s.most_elongation = std::abs(limits->tdl);
    if (row->kd > 0.0) {
      if (row->v0 > 0.0)
        s.magnification = row->kd / (row->v0 / lever);
      else
        refuse(b, row[&DiscreteSectionCard::v0], "KD needs the velocity that it refers to", "give V0");
    }
    if (s.torsional && (s.most_compression > 0.0 || s.most_elongation > 0.0))
      refuse(b, limits[s.most_compression > 0.0 ? &LimitCard::cdl : &LimitCard::tdl],
             "stops of torsional springs are not built", "give a law whose moment rises steeply there");
    b.discrete_sections.add(s.id, static_cast<Index>(b.model.discrete_sections.size()), s.place, row.keyword(),
                            "discrete section", b.findings);
    b.model.discrete_sections.push_back(s);
  }
}

void link_nodes(Builder& b, const RowOf<OrientationCard>& row, std::size_t index) {
  SpringOrientation& o = b.model.spring_orientations[index];
  o.node = {b.node(row[&OrientationCard::nid1]), b.node(row[&OrientationCard::nid2])};
  if (o.node[0] == none || o.node[1] == none) {
    if (row->nid1 == 0 || row->nid2 == 0)
      refuse(b, row[row->nid1 == 0 ? &OrientationCard::nid1 : &OrientationCard::nid2], "IOP 2 and 3 need two nodes",
             "give both");
    return;
  }
  const auto at = [&](Index n) { return b.model.nodes.x[n]; };
  if (!(norm(at(o.node[1]) - at(o.node[0])) > 0.0))
    refuse(b, row[&OrientationCard::nid2], "both nodes are at one place, so they give no direction",
           "take two nodes apart");
}

void read_orientation(Builder& b, const Block& block, const Options& options) {
  for (Cursor cursor(b.deck, block, b.findings); !at_end(cursor);) {
    read_title(cursor, options);
    const auto row = cursor.read(orientation_card);
    SpringOrientation o;
    o.id = row->vid;
    o.place = row.place();
    const int option = row->iop;
    o.in_plane = option == 1 || option == 3;
    const auto index = b.model.spring_orientations.size();
    if (option < 2) {
      const Vec3d v = direction(block, {row->xt, row->yt, row->zt});
      if (norm(v) > 0.0)
        o.direction = unit(v);
      else
        refuse(b, row[&OrientationCard::xt], "the vector has no length", "give its components");
    } else {
      b.defer(Phase::systems, [row, index](Builder& later) { link_nodes(later, row, index); });
    }
    b.spring_orientations.add(o.id, static_cast<Index>(index), o.place, block.starred(), "orientation", b.findings);
    b.model.spring_orientations.push_back(o);
  }
}

// ---- laws

// What fills a law from its row. The card's table gives the constants of a line, force and length; `lever` is the
// length by which those of a twist, moment and angle, are converted besides: FCTLEN where the spring is torsional.
// Curves stay, see *DEFINE_CURVE.

Curve spring_curve(Builder& b, const deck::Entry& field) {
  const Index c = b.curve(field);
  return c == none ? Curve{} : b.model.curves[c];
}

kernel::ForceCurve spring_force_curve(Builder& b, const deck::Entry& field) {
  const Curve c = spring_curve(b, field);
  return c.empty() ? kernel::ForceCurve{} : kernel::ForceCurve(c);
}

using SpringKind = kernel::DiscreteSpring::Kind;

void fill_elastic(Builder&, const RowOf<ElasticSpringCard>& row, double lever, kernel::Spring& spring) {
  kernel::DiscreteSpring law;
  law.kind = SpringKind::linear;
  law.stiffness = row->k * lever * lever;
  spring.law = law;
}

void fill_viscous(Builder&, const RowOf<ViscousCard>& row, double lever, kernel::Spring& spring) {
  kernel::DiscreteSpring law;
  law.damping = row->dc * lever * lever;
  spring.law = law;
}

void fill_elastoplastic(Builder& b, const RowOf<ElastoplasticCard>& row, double lever, kernel::Spring& spring) {
  const double k = row->k * lever * lever, tangent = row->kt * lever * lever;
  const double yield = row->fy * lever;
  if (!(tangent < k))
    return refuse(b, row[&ElastoplasticCard::kt], "the tangent stiffness must be less than the elastic one",
                  "*MAT_SPRING_ELASTIC needs none");
  kernel::DiscreteSpring law;
  law.kind = SpringKind::elastoplastic;
  law.stiffness = k;
  Curve hardening;
  hardening.x = {0.0, yield / k};
  hardening.y = {yield, yield * (1.0 + tangent / (k - tangent))};
  law.load = law.unload = kernel::ForceCurve(hardening);
  spring.law = law;
}

/// Warns of a curve for both signs that does not go through 0, 0.
void report_leap(Builder& b, const deck::Entry& field, const kernel::ForceCurve& force) {
  const double leap = force(1e-300);
  if (force.empty() || force(-1e-300) != -leap || std::abs(leap) <= 1e-9 * force.largest()) return;
  field.report(b.findings, Severity::warning,
               fmt::format("the curve holds for both signs: at 0 the force leaps from {:g} to {:g}", -leap, leap),
               "let the curve begin at 0, 0, or give both sides");
}

void fill_nonlinear(Builder& b, const RowOf<NonlinearCard>& row, double, kernel::Spring& spring) {
  kernel::DiscreteSpring law;
  law.kind = SpringKind::elastic;
  law.load = spring_force_curve(b, row[&NonlinearCard::lcd]);
  report_leap(b, row[&NonlinearCard::lcd], law.load);
  law.rate_scale = spring_force_curve(b, row[&NonlinearCard::lcr]);
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

void fill_nonlinear_viscous(Builder& b, const RowOf<NonlinearViscousCard>& row, double, kernel::Spring& spring) {
  kernel::DiscreteSpring law;
  law.damper = spring_force_curve(b, row[&NonlinearViscousCard::lcdr]);
  report_leap(b, row[&NonlinearViscousCard::lcdr], law.damper);
  if (const std::optional<double> rate = driving_rate(spring_curve(b, row[&NonlinearViscousCard::lcdr]), law.damper);
      rate)
    row[&NonlinearViscousCard::lcdr].report(
        b.findings, Severity::warning,
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

void fill_reversing(Builder& b, const RowOf<ReversingCard>& row, double lever, kernel::Spring& spring) {
  kernel::ReversingSpring law;
  law.load = spring_curve(b, row[&ReversingCard::lcdl]);
  law.unload = spring_curve(b, row[&ReversingCard::lcdu]);
  law.tension_yield = row->tyi * lever;
  law.compression_yield = row->cyi * lever;
  law.isotropic = row->beta == 1.0;
  spring.law = law;
  if (law.load.empty() || law.unload.empty()) return;
  if (row->beta != 0.0 && row->beta != 1.0)
    refuse(b, row[&ReversingCard::beta],
           "kinematic hardening is not built: which curve the reversed load follows is not documented", "write 0 or 1");
  const auto rises = [](const Curve& c) {
    for (std::size_t i = 0; i + 1 < c.x.size(); ++i)
      if (!(c.y[i + 1] > c.y[i])) return false;
    return c.x.size() > 1;
  };
  if (!rises(law.unload))
    refuse(b, row[&ReversingCard::lcdu], "the unloading curve must rise from each point to the next",
           "give two points or more");
  if (law.load.x.size() < 2) refuse(b, row[&ReversingCard::lcdl], "the curve needs two points or more", "add points");
  if (law.isotropic && !rises(law.load))
    refuse(b, row[&ReversingCard::lcdl],
           "with isotropic hardening the loading curve must rise from each point to the next",
           "write BETA 0 for a curve that softens");
  if (const std::optional<double> force = too_soft_unloading(law); force)
    row[&ReversingCard::lcdu].report(
        b.findings, Severity::warning,
        fmt::format("unloaded from {:g} the spring gives back more energy than loading took", *force),
        "make the unloading curve at least as steep as the loading curve");
}

void fill_maxwell(Builder& b, const RowOf<MaxwellCard>& row, double lever, kernel::Spring& spring) {
  kernel::MaxwellSpring law;
  law.instantaneous_stiffness = row->k0 * lever * lever;
  law.long_term_stiffness = row->ki * lever * lever;
  law.decay = row->beta;
  law.cut_off = row->tc;
  law.last_force = row->fc * lever;
  spring.law = law;
  if (law.cut_off < 1e20 && law.last_force >= 1e20)
    refuse(b, row[&MaxwellCard::fc], "TC needs the force that follows", "give FC");
}

void fill_inelastic(Builder& b, const RowOf<InelasticCard>& row, double lever, kernel::Spring& spring) {
  kernel::InelasticSpring law;
  law.load = spring_force_curve(b, row[&InelasticCard::lcfd]);
  law.unloading = std::max(row->ku * lever * lever, law.load.steepest());
  law.tension = row->ctf == -1.0;
  if (std::abs(row->ctf) != 1.0) refuse(b, row[&InelasticCard::ctf], "expected -1 or 1");
  spring.law = law;
  const Curve c = spring_curve(b, row[&InelasticCard::lcfd]);
  if (!c.empty() && (c.x.front() < 0.0 || law.load.lowest() < 0.0))
    refuse(b, row[&InelasticCard::lcfd], "the curve must lie in the positive quadrant, also for compression",
           "turn its signs");
  if (!c.empty() && !(law.unloading > 0.0))
    refuse(b, row[&InelasticCard::ku], "a curve of constant force needs a stiffness of unloading", "give KU");
}

double length_factor(const Block& block) {
  return block.transform ? block.transform->length : 1.0;
}

/// The length factor where the springs of this law turn, 1 where they act along a line.
double lever_of(Builder& b, const deck::Entry& mid, std::size_t material, double length) {
  if (length == 1.0) return 1.0;
  std::array<bool, 2> used{};
  for (const Part& part : b.model.parts)
    if (part.kind == ElementKind::discrete && part.material == static_cast<Index>(material) && part.section != none)
      used[b.model.discrete_sections[part.section].torsional] = true;
  if (used[0] && used[1])
    refuse(b, mid, "springs along a line and torsional ones share this law, which FCTLEN makes two of",
           "give the torsional springs a law of their own");
  return used[1] ? length : 1.0;
}

/// A material whose law is filled later; its index.
std::size_t add_material(Builder& b, const Block& block, const Row& row, int id, std::string title) {
  const auto index = b.model.materials.size();
  std::string name =
      block.keyword.ends_with("_TITLE") ? block.keyword.substr(0, block.keyword.size() - 6) : block.keyword;
  Material m{id, std::move(title), std::move(name), 0.0, kernel::Spring{}, row.place()};
  b.materials.add(m.id, static_cast<Index>(index), m.place, row.keyword(), "material", b.findings);
  b.model.materials.push_back(std::move(m));
  return index;
}

template <const auto& card, auto fill>
void read_spring_law(Builder& b, const Block& block, const Options& options) {
  for (Cursor cursor(b.deck, block, b.findings); !at_end(cursor);) {
    std::string title = read_title(cursor, options);
    const auto row = cursor.read(card);
    const std::size_t index = add_material(b, block, row, row->mid, std::move(title));
    // Curves may be defined later in the deck, and which springs turn is known when parts have their sections.
    b.defer(Phase::systems, [row, index, length = length_factor(block)](Builder& later) {
      const double lever = lever_of(later, row[&SpringLawCard::mid], index, length);
      fill(later, row, lever, std::get<kernel::Spring>(later.model.materials[index].law));
    });
  }
}

template <const auto& card, auto fill>
Keyword law(std::string_view name, std::string_view number) {
  return {.name = name,
          .aliases = {number},
          .options = {"TITLE"},
          .layout = {{"", &card}},
          .read = read_spring_law<card, fill>};
}

}  // namespace

void make_discretes(Builder& b) {
  for (const auto& row : b.discrete_rows) add_element(b, row);
}

std::vector<Keyword> spring_keywords() {
  return {
      {.name = "ELEMENT_DISCRETE", .layout = {{"", &element_card}}, .read = read_elements},
      {.name = "SECTION_DISCRETE",
       .options = {"TITLE"},
       .layout = {{"", &discrete_section_card}, {"", &limit_card}},
       .read = read_section},
      {.name = "DEFINE_SD_ORIENTATION",
       .options = {"TITLE"},
       .layout = {{"", &orientation_card}},
       .read = read_orientation},
      law<elastic_spring_card, fill_elastic>("MAT_SPRING_ELASTIC", "MAT_S01"),
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
