// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"

// *CONTROL_IMPLICIT_...: natural modes and linear statics. What tunes LS-DYNA's own solvers has no effect here, and its
// meaning says so.
namespace nugget::reading {
namespace {

using deck::Block;
using deck::Cursor;
using deck::RowOf;

constexpr IntegerField choice(std::string_view name, int fallback, std::string_view meaning) {
  return integer(name, fallback, any_value, meaning);
}
constexpr RealField tuning(std::string_view name, double fallback) {
  return real(name, dimension::number, fallback, any_value, "of LS-DYNA's own solver, no effect");
}

struct ImplicitGeneralCard {
  int imflag = 0, igs = 0;
};
const CardOf<ImplicitGeneralCard> implicit_general_card{
    {&ImplicitGeneralCard::imflag,
     integer("imflag", 0, any_value,
             "0: explicit run, 1: implicit (modes or linear statics), 6: explicit, then modes; others are refused")},
    real("dt0", dimension::time, 0, any_value, "time step; a linear solution has none, no effect"),
    choice("imform", 2, "springback formulation, no effect"),
    choice("nsbs", 1, "springback steps, no effect"),
    {&ImplicitGeneralCard::igs,
     integer("igs", 2, between(0, 2), "geometric stiffness of initial stress in modes: 1 on, 2 off")},
    choice("cnstn", 0, "consistent tangent of plasticity, no effect"),
    choice("form", 0, "formulation of fully integrated elements, no effect"),
    choice("zero_v", 0, "velocities at a switch to implicit, no effect"),
};

struct EigenvalueCard {
  int neig = 0;
  double center = 0;
  int lflag = 0;
  double lftend = 0;
  int rflag = 0;
  double rhtend = 0;
  int eigmth = 0;
};
const CardOf<EigenvalueCard> eigenvalue_card{
    {&EigenvalueCard::neig,
     or_negative(
         integer(
             "neig", 0, any_value,
             "at most so many modes; below 0: -neig is a curve, number of modes over time, and modes are those of the "
             "structure under its static loads at ENDTIM"),
         IdSpace::function)},
    {&EigenvalueCard::center,
     real("center", dimension::rate, 0, at_least(0), "modes nearest to this frequency [cycles/time]; 0: the lowest")},
    {&EigenvalueCard::lflag,
     integer("lflag", 0, between(0, 1), "1: no modes below lftend; without rflag and center the first above it")},
    {&EigenvalueCard::lftend,
     real("lftend", dimension::rate, -1e29, any_value, "lower end of the interval [cycles/time]")},
    {&EigenvalueCard::rflag, integer("rflag", 0, between(0, 1), "1: no modes above rhtend")},
    {&EigenvalueCard::rhtend,
     real("rhtend", dimension::rate, 1e29, any_value, "upper end of the interval [cycles/time]")},
    {&EigenvalueCard::eigmth, integer("eigmth", 2, any_value, "method; block shift-invert Lanczos in any case")},
    tuning("shfscl", 0),
};

struct EigenvalueCard2 {
  int isolid = 0, ishell = 0, mstres = 0, evdump = 0;
};
const CardOf<EigenvalueCard2> eigenvalue_card_2{
    {&EigenvalueCard2::isolid,
     integer("isolid", 0, between(-2, 18),
             "formulation of bricks in this analysis, welds excepted: 1, 2, 18, -1, -2; 0: that of their sections")},
    integer("ibeam", 0, only(0), "formulation of beams in this analysis; their sections' in any case"),
    {&EigenvalueCard2::ishell,
     integer("ishell", 0, between(-16, 21),
             "formulation of shells in this analysis; all values mean 16, as which quads run in any case")},
    integer("itshell", 0, any_value, "formulation of thick shells, no effect"),
    {&EigenvalueCard2::mstres, integer("mstres", 0, any_value, "1: stresses of the modes in d3eigv")},
    {&EigenvalueCard2::evdump, integer("evdump", 0, any_value, "vectors in a file Eigen_Vectors")},
    tuning("mstrscl", 0.001),
};

struct SolverCard {
  int autospc = 0;
};
const CardOf<SolverCard> solver_card{
    choice("lsolvr", 7, "linear solver; MUMPS in any case"),
    choice("lprint", 0, "listing, no effect"),
    choice("negev", 2, "negative eigenvalues are an error in any case"),
    choice("order", 0, "order of elimination; METIS in any case"),
    choice("drcm", 4, "drilling stiffness of shells; that of the element in any case"),
    tuning("drcprm", 0),
    {&SolverCard::autospc,
     choice("autospc", 1,
            "1: directions of nodes whose row of the stiffness matrix is zero are held, and counted in a note")},
    tuning("autotol", 0),
};

struct SolutionCard {
  int nsolvr = 0;
};
const CardOf<SolutionCard> implicit_solution_card{
    {&SolutionCard::nsolvr,
     choice("nsolvr", 12, "1: linear statics at the end time; others are refused unless modes are asked for")},
    choice("ilimit", 11, "nonlinear solver, no effect"),
    choice("maxref", 15, "nonlinear solver, no effect"),
    tuning("dctol", 0.001),
    tuning("ectol", 0.01),
    tuning("rctol", 1e10),
    tuning("lstol", 0.9),
    tuning("abstol", 1e-10),
};

struct DynamicsCard {
  int imass = 0;
};
const CardOf<DynamicsCard> dynamics_card{
    {&DynamicsCard::imass, integer("imass", 0, any_value, "0: statics, 1: Newmark's rule")},
    tuning("gamma", 0.5),
    tuning("beta", 0.25),
    real("tdybir", dimension::time, 0, any_value, "birth of the dynamic terms, no effect"),
    real("tdydth", dimension::time, 1e28, any_value, "death of the dynamic terms, no effect"),
    real("tdybur", dimension::time, 1e28, any_value, "burial of the dynamic terms, no effect"),
    choice("irate", 0, "strain rates, no effect"),
    tuning("alpha", 0),
};

/// False, and why, for runs that go from one kind of analysis to another.
bool single_analysis(Builder& b, const RowOf<ImplicitGeneralCard>& row) {
  const int flag = row->imflag;
  if (flag == 0 || flag == 1 || flag == 6) return true;
  const char* const what = flag < 0 ? "a switch between implicit and explicit over time (a curve) is not built"
                           : flag == 2
                               ? "springback after an explicit run is a nonlinear implicit step, which is not built"
                               : "a run that switches between implicit and explicit is not built";
  refuse(b, row[&ImplicitGeneralCard::imflag], what,
         "write 0 for an explicit run, 1 for modes or linear statics, 6 for modes after an explicit run");
  return false;
}

void read_implicit_general(Builder& b, const Block& block, const Options&) {
  Cursor cursor(b.deck, block, b.findings);
  const auto row = cursor.read(implicit_general_card);
  expect_end(b, cursor);
  if (!single_analysis(b, row)) return;
  b.model.implicit.active = row->imflag == 1;
  b.model.implicit.after_run = row->imflag == 6;
  b.model.implicit.geometric = row->igs == 1;
  if (b.model.implicit.after_run)
    b.defer(Phase::checks, [row](Builder& later) {
      if (later.model.implicit.modes < 0) return;
      refuse(later, row[&ImplicitGeneralCard::imflag],
             "modes in the course of a run are those at its end, and the deck does not ask for any",
             "give a curve, (0, 0) (ENDTIM, 20), as NEIG = -LCID of *CONTROL_IMPLICIT_EIGENVALUE, or write IMFLAG 0");
    });
  if (!b.model.implicit.active) return;
  b.defer(Phase::checks, [row](Builder& later) {
    const bool response = later.model.frequency_response || later.model.steady_state;
    if (later.model.implicit.geometric && later.model.implicit.modes == 0 && !response)
      refuse(later, row[&ImplicitGeneralCard::igs],
             "geometric stiffness is built in modes and responses over frequency, not in statics",
             "write IGS 2, or ask for modes by NEIG in *CONTROL_IMPLICIT_EIGENVALUE");
    const bool has_solution =
        std::any_of(later.model.keyword_uses.begin(), later.model.keyword_uses.end(),
                    [](const KeywordUse& entry) { return entry.keyword == "CONTROL_IMPLICIT_SOLUTION"; });
    const bool direct = later.model.steady_state && later.model.steady_state->direct;
    if (later.model.implicit.modes > 0 || has_solution || direct) return;
    refuse(later, row[&ImplicitGeneralCard::imflag],
           "without further cards this is a nonlinear implicit run, which is not built",
           "give NSOLVR 1 in *CONTROL_IMPLICIT_SOLUTION for linear statics, NEIG in *CONTROL_IMPLICIT_EIGENVALUE for "
           "natural modes, or run explicitly with IMFLAG 0");
  });
}

/// Modes at one time: that of the linear solution, or of the end of the explicit run.
void read_modes_under_load(Builder& b, const RowOf<EigenvalueCard>& row) {
  const Index id = b.curves.find(-row->neig);
  const auto remedy = "give a curve with one point of modes, at ENDTIM, e.g. (0, 0) (ENDTIM, 20)";
  b.model.implicit.modes = -1;
  if (id == none) return refuse(b, row[&EigenvalueCard::neig], fmt::format("there is no curve {}", -row->neig), remedy);
  const Curve& curve = b.model.curves[id];
  int extractions = 0;
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    if (curve.y[i] == 0.0) continue;
    ++extractions;
    b.model.implicit.modes = -static_cast<int>(std::lround(curve.y[i]));
    const double end = b.model.control.end_time;
    if (!(end > 0.0) || std::abs(curve.x[i] - end) > 1e-6 * end || !(curve.y[i] >= 1.0))
      refuse(b, row[&EigenvalueCard::neig],
             fmt::format("{:g} modes at time {:g}: they are built at ENDTIM", curve.y[i], curve.x[i]), remedy);
  }
  if (extractions != 1)
    refuse(b, row[&EigenvalueCard::neig],
           fmt::format("the curve asks {} times for modes: they are built at one time", extractions), remedy);
}

/// ISOLID and ISHELL.
void read_formulations(Builder& b, const RowOf<EigenvalueCard2>& row) {
  constexpr int solids[] = {0, 1, 2, 18, -1, -2}, shells[] = {0, 2, 10, 16, -16, 18, 20, 21};
  const int solid = row->isolid, shell = row->ishell;
  if (std::ranges::find(solids, solid) == std::end(solids))
    refuse(b, row[&EigenvalueCard2::isolid], fmt::format("bricks of formulation {} are not built", solid),
           "write 1, 2, 18, -1, -2 or 0");
  b.model.implicit.solid_form = solid;
  if (std::ranges::find(shells, shell) == std::end(shells))
    refuse(b, row[&EigenvalueCard2::ishell], fmt::format("shells of formulation {} are not built", shell),
           "write 16 or 0");
  else if (shell != 0 && shell != 16)
    row[&EigenvalueCard2::ishell].report(b.findings, Severity::warning,
                                         "computed as 16, like all quads in linear analyses", "write 16");
}

void read_eigenvalue(Builder& b, const Block& block, const Options&) {
  Cursor cursor(b.deck, block, b.findings);
  const auto row = cursor.read(eigenvalue_card);
  const auto more = cursor.read(eigenvalue_card_2);  // further cards tune other methods
  Implicit& i = b.model.implicit;
  i.modes = row->neig;
  i.centre = row->center;
  if (row->lflag == 1) i.low = row->lftend;
  if (row->rflag == 1) i.high = row->rhtend;
  i.modal_stresses = more->mstres == 1;
  read_formulations(b, more);
  expect(b, Severity::warning,
         {{row[&EigenvalueCard::eigmth], 2, "not obeyed: modes come from block Lanczos, as with 2"}});
  expect(b, Severity::warning,
         {{more[&EigenvalueCard2::evdump], 0, "not obeyed: no Eigen_Vectors; d3eigv holds the shapes"}});
  if (i.low && i.high && *i.low >= *i.high)
    refuse(b, row[&EigenvalueCard::rhtend], "the interval is empty", "give an RHTEND above LFTEND");
  if (i.high && !(*i.high > 0.0))
    refuse(b, row[&EigenvalueCard::rhtend], "there are no modes below frequency 0", "give an RHTEND above 0");
  if (i.modes < 0) b.defer(Phase::conditions, [row](Builder& later) { read_modes_under_load(later, row); });
  b.defer(Phase::checks, [row](Builder& later) {
    if (later.model.implicit.active || later.model.implicit.after_run || later.model.implicit.modes == 0) return;
    // Whatever command reads the deck, this is true.
    row[&EigenvalueCard::neig].report(
        later.findings, Severity::warning,
        "`nugget run` computes no modes, but runs explicitly: IMFLAG of *CONTROL_IMPLICIT_GENERAL is 0",
        "write IMFLAG 1, or use `nugget modes`");
  });
}

void read_solver(Builder& b, const Block& block, const Options&) {
  Cursor cursor(b.deck, block, b.findings);
  const auto row = cursor.read(solver_card);  // its further cards tune solvers that this program has not
  expect(b, Severity::warning,
         {{row[&SolverCard::autospc], 1, "not obeyed: zero rows of the stiffness matrix are held, as with 1"}});
}

void read_implicit_solution(Builder& b, const Block& block, const Options&) {
  Cursor cursor(b.deck, block, b.findings);
  const auto row = cursor.read(implicit_solution_card);  // its further cards tune nonlinear solvers
  b.defer(Phase::checks, [row](Builder& later) {
    if (later.model.implicit.active && later.model.implicit.modes <= 0 && row->nsolvr != 1)
      refuse(later, row[&SolutionCard::nsolvr], "nonlinear implicit solutions are not built",
             "write 1 (linear statics), or run explicitly with IMFLAG 0");
  });
}

void read_dynamics(Builder& b, const Block& block, const Options&) {
  Cursor cursor(b.deck, block, b.findings);
  const auto row = cursor.read(dynamics_card);
  expect_end(b, cursor);
  b.defer(Phase::checks, [row](Builder& later) {
    if (later.model.implicit.active && later.model.implicit.modes == 0 && row->imass != 0)
      refuse(later, row[&DynamicsCard::imass], "implicit dynamics is not built", "run explicitly, with IMFLAG 0");
  });
}

}  // namespace

std::vector<Keyword> implicit_keywords() {
  return {
      {.name = "CONTROL_IMPLICIT_GENERAL", .layout = {{"", &implicit_general_card}}, .read = read_implicit_general},
      {.name = "CONTROL_IMPLICIT_EIGENVALUE",
       .layout = {{"", &eigenvalue_card}, {"optional", &eigenvalue_card_2}},
       .read = read_eigenvalue},
      {.name = "CONTROL_IMPLICIT_SOLVER", .layout = {{"", &solver_card}}, .read = read_solver},
      {.name = "CONTROL_IMPLICIT_SOLUTION", .layout = {{"", &implicit_solution_card}}, .read = read_implicit_solution},
      {.name = "CONTROL_IMPLICIT_DYNAMICS", .layout = {{"", &dynamics_card}}, .read = read_dynamics},
      {.name = "CONTROL_IMPLICIT_AUTO",
       .status = KeywordStatus::ignored,
       .why = "steps of nonlinear implicit runs; a linear solution has none"},
  };
}

}  // namespace nugget::reading
