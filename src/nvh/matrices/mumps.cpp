// SPDX-License-Identifier: Apache-2.0
#include "nvh/matrices/mumps.hpp"

#include <utility>

#include "nvh/matrices/factorization.hpp"

namespace nugget::nvh {
namespace {

enum Job : int { end_instance = -2, make_instance = -1, analyse = 1, factor_numbers = 2, solve_columns = 3 };

/// The ranks that this one leads.
struct Led {
  Ranks* ranks = nullptr;
  int instances = 0;
  bool together = false;  ///< the others are in something that they do by themselves
  std::function<void(const SolverCall&)> send;
} led;

void announce(const SolverCall& call) {
  if (led.send) led.send(call);
}

/// The ranks that will have parts of a new instance, null alone.
Ranks* begin(SolverCall::Kind kind, int instance) {
  announce({kind, instance, make_instance});
  led.together = led.ranks != nullptr;
  return led.ranks;
}

template <class Number>
constexpr SolverCall::Kind kind_of =
    std::is_same_v<Number, double> ? SolverCall::Kind::real : SolverCall::Kind::complex;

}  // namespace

int ranks() {
  return led.ranks == nullptr ? 1 : led.ranks->count();
}

void lead_ranks(Ranks& ranks, std::function<void(const SolverCall&)> send) {
  led = {&ranks, 0, false, std::move(send)};
}

bool left_ranks_waiting() {
  return led.together;
}

template <class Number>
Mumps<Number>::Mumps(const Matrices& m, std::vector<const Symmetric*> terms)
    : instance_(led.instances++), part_(begin(kind_of<Number>, instance_)) {
  together(kind_of<Number>, Job::analyse, [&](MumpsPart<Number>& part) { part.analyse(m, std::move(terms)); });
}

template <class Number>
Mumps<Number>::~Mumps() {
  if (!led.together) announce({kind_of<Number>, instance_, end_instance});  // the part ends behind it
}

template <class Number>
void Mumps<Number>::factor(std::span<const Number> factors) {
  together(kind_of<Number>, factor_numbers, [&](MumpsPart<Number>& part) { part.factor(factors); });
}

template <class Number>
void Mumps<Number>::solve(Number* x, std::size_t columns) {
  together(kind_of<Number>, solve_columns, [&](MumpsPart<Number>& part) { part.solve(x, columns); });
}

template <class Number>
void Mumps<Number>::together(SolverCall::Kind kind, int job, const std::function<void(MumpsPart<Number>&)>& what) {
  announce({kind, instance_, job});
  led.together = led.ranks != nullptr;
  try {
    what(part_);
  } catch (const Factorization::SolverError&) {
    led.together = false;
    throw;
  } catch (...) {
    part_.leave();
    throw;
  }
  led.together = false;
}

template class Mumps<double>;
template class Mumps<std::complex<double>>;

template <class Number>
void MumpsParts::answer(const SolverCall& call, std::map<int, MumpsPart<Number>>& parts) {
  switch (call.job) {
    case make_instance: parts.try_emplace(call.instance, ranks_); break;
    case Job::analyse: parts.at(call.instance).analyse(); break;
    case factor_numbers: parts.at(call.instance).factor({}); break;
    case solve_columns: parts.at(call.instance).solve(nullptr, 0); break;
    case end_instance: parts.erase(call.instance); break;
    default: break;
  }
}

void MumpsParts::answer(const SolverCall& call) {
  if (call.kind == SolverCall::Kind::real)
    answer(call, real_);
  else
    answer(call, complex_);
}

}  // namespace nugget::nvh
