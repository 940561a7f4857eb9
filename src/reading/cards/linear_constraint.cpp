// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"

// *CONSTRAINED_LINEAR_GLOBAL, *CONSTRAINED_LINEAR_LOCAL, *CONSTRAINED_NODE_SET.
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;
using deck::RowOf;

struct EquationCard {
  int lcid = 0;
};
const CardOf<EquationCard> equation_card{
    {&EquationCard::lcid, id("lcid", IdSpace::other, required, "id of the equation")},
};

struct EquationTermCard {
  int nid = 0, dof = 0, cid = 0;
  double coef = 0.0;
};
constexpr IntegerField freedom_of_equation() {
  return integer("dof", required, between(1, 6), "1 to 3 displacement along x, y, z; 4 to 6 rotation about them");
}
const CardOf<EquationTermCard> global_term_card{
    {&EquationTermCard::nid, id("nid", IdSpace::node, required, "node")},
    {&EquationTermCard::dof, freedom_of_equation()},
    {&EquationTermCard::coef, real("coef", dimension::number, 0, any_value, "its factor, not 0")},
};
const CardOf<EquationTermCard> local_term_card{
    {&EquationTermCard::nid, id("nid", IdSpace::node, required, "node")},
    {&EquationTermCard::dof, freedom_of_equation()},
    {&EquationTermCard::cid,
     id("cid", IdSpace::define, 0, "coordinate system of x, y, z, as it is at time 0; 0: global")},
    {&EquationTermCard::coef, real("coef", dimension::number, 0, any_value, "its factor, not 0")},
};

void make_equation(Builder& b, const RowOf<EquationCard>& head, const std::vector<RowOf<EquationTermCard>>& rows) {
  LinearConstraint equation;
  equation.keyword = head.keyword();
  equation.id = head->lcid;
  equation.place = head.place();
  bool known = true;
  for (const auto& row : rows) {
    LinearConstraint::Term term;
    term.node = b.node(row[&EquationTermCard::nid]);
    term.rotation = row->dof > 3;
    term.factor = row->coef;
    Frame3d axes{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    if (row->cid != 0) {
      const Index system = b.system(row[&EquationTermCard::cid]);
      known = known && system != none;
      if (system != none) axes = b.model.systems[system].axes;
    }
    const int axis = (row->dof - 1) % 3;
    term.direction = axis == 0 ? axes.e1 : axis == 1 ? axes.e2 : axes.e3;
    known = known && term.node != none;
    equation.terms.push_back(term);
  }
  if (known) b.model.linear_constraints.push_back(std::move(equation));
}

template <bool local>
void read_equation(Builder& builder, const Block& block, const Options&) {
  Cursor cursor(builder.deck, block, builder.findings);
  const auto head = cursor.read(equation_card);
  std::vector<RowOf<EquationTermCard>> rows;
  const int errors = builder.findings.errors();
  while (!at_end(cursor)) {
    const auto row = cursor.read(local ? local_term_card : global_term_card);
    if (row->coef == 0.0)
      refuse(builder, row[&EquationTermCard::coef], "a factor of 0 takes the node out of the equation",
             "give its factor, or take the line out");
    if (row->cid == 0) warn_of_global_axis(builder, block, row[&EquationTermCard::dof]);
    rows.push_back(row);
  }
  if (rows.empty())
    return refuse(builder, head[&EquationCard::lcid], "an equation without nodes", "give a line for each node");
  if (builder.findings.errors() > errors) return;
  builder.defer(Phase::conditions, [head, rows](Builder& later) { make_equation(later, head, rows); });
}

// ---- nodes that share translations

struct SharedMotionCard {
  int nsid = 0, dof = 0;
  double tf = 0.0;
};
const CardOf<SharedMotionCard> shared_motion_card{
    {&SharedMotionCard::nsid, id("nsid", IdSpace::set, required, "nodes that move alike")},
    {&SharedMotionCard::dof,
     integer("dof", required, between(1, 7), "translations they share: 1 x, 2 y, 3 z, 4 x y, 5 y z, 6 z x, 7 x y z")},
    {&SharedMotionCard::tf, real("tf", dimension::time, forever, at_least(0), "time of failure: not built")},
};

/// An equation for each node but the first, and each direction.
void make_shared_motion(Builder& b, const RowOf<SharedMotionCard>& row, int id) {
  const auto* set = b.node_set(row[&SharedMotionCard::nsid]);
  if (set == nullptr) return;
  if (set->members.size() < 2)
    return row[&SharedMotionCard::nsid].report(b.findings, Severity::warning, "one node shares its motion with nobody",
                                               "take the card out");
  constexpr std::array<unsigned, 8> shared{0, 1, 2, 4, 3, 6, 5, 7};
  const std::array<Vec3d, 3> axis{Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}};
  for (std::size_t n = 1; n < set->members.size(); ++n)
    for (unsigned i = 0; i < 3; ++i) {
      if (!(shared[static_cast<std::size_t>(row->dof)] >> i & 1u)) continue;
      LinearConstraint equation;
      equation.keyword = row.keyword();
      equation.id = id;
      equation.place = row.place();
      equation.terms = {{set->members[n], false, axis[i], 1.0}, {set->members[0], false, axis[i], -1.0}};
      b.model.linear_constraints.push_back(std::move(equation));
    }
}

void read_shared_motion(Builder& builder, const Block& block, const Options& options) {
  Cursor cursor(builder.deck, block, builder.findings);
  while (!at_end(cursor)) {
    const int id = read_heading(cursor, options.contains("ID")).id;
    const auto row = cursor.read(shared_motion_card);
    if (row->dof < 1 || row->dof > 7) continue;  // refused by its range
    if (row->tf > 0.0 && row->tf < forever)
      refuse(builder, row[&SharedMotionCard::tf], "nodes that part at a time are not built", "leave it blank");
    if (row->dof != 7) warn_of_global_axis(builder, block, row[&SharedMotionCard::dof]);
    builder.defer(Phase::conditions, [row, id](Builder& later) { make_shared_motion(later, row, id); });
  }
}

}  // namespace

std::vector<Keyword> linear_constraint_keywords() {
  return {
      {.name = "CONSTRAINED_LINEAR_GLOBAL",
       .layout = {{"", &equation_card}, {"for each node", &global_term_card}},
       .read = read_equation<false>},
      {.name = "CONSTRAINED_LINEAR_LOCAL",
       .layout = {{"", &equation_card}, {"for each node", &local_term_card}},
       .read = read_equation<true>},
      {.name = "CONSTRAINED_NODE_SET",
       .options = {"ID"},
       .layout = {{"with _ID", &heading_card}, {{}, &shared_motion_card}},
       .read = read_shared_motion},
  };
}

}  // namespace nugget::reading
