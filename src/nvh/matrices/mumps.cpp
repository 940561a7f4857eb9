// SPDX-License-Identifier: Apache-2.0
#include "nvh/matrices/mumps.hpp"

#include <cblas.h>

#include <map>
#include <utility>
#include <vector>

#include "nvh/matrices/elimination_order.hpp"
#include "nvh/matrices/ranks.hpp"

namespace nugget::nvh {
namespace {

/// The ranks that this one leads.
struct Led {
  int count = 1, instances = 0;
  std::function<void(const SolverCall&)> send;
} led;

void call_mumps(DMUMPS_STRUC_C& data) {
  dmumps_c(&data);
}
void call_mumps(ZMUMPS_STRUC_C& data) {
  zmumps_c(&data);
}

/// One rank's part of a collective call.
template <class Data>
void take_part(Data& data, int job) {
  data.job = job;
  if (job == -1) {
    data.par = 1;
    data.sym = 2;
    data.comm_fortran = -987654;  // MUMPS' word for MPI_COMM_WORLD
  }
  call_mumps(data);
  if (job == -1)
    for (const int i : {0, 1, 2, 3}) data.icntl[i] = i == 3 ? 0 : -1;  // silent
}

template <class Data>
void response(const SolverCall& call, std::map<int, Data>& instances) {
  take_part(instances[call.instance], call.job);
  if (call.job == -2) instances.erase(call.instance);
}

struct Pattern {
  std::vector<MUMPS_INT> row, column;

  explicit Pattern(const std::vector<const Symmetric*>& terms) {
    std::size_t entries = 0;
    for (const Symmetric* matrix : terms) entries += matrix->entries();
    row.reserve(entries);
    column.reserve(entries);
    for (const Symmetric* matrix : terms)  // entries given twice are added up
      for (std::size_t j = 0; j < matrix->size(); ++j)
        for (const int i : matrix->rows(j)) {
          row.push_back(i + 1);
          column.push_back(static_cast<MUMPS_INT>(j) + 1);
        }
  }
  template <class Data>
  void give(Data& data) {
    data.nnz = static_cast<MUMPS_INT8>(row.size());
    data.irn = row.data();
    data.jcn = column.data();
  }
};

/// std::complex<double> and MUMPS' complex number are two doubles each (C++ [complex.numbers]).
double* as_mumps(double* x) {
  return x;
}
ZMUMPS_COMPLEX* as_mumps(std::complex<double>* x) {
  return reinterpret_cast<ZMUMPS_COMPLEX*>(x);
}

}  // namespace

int ranks() {
  return led.count;
}

void lead_ranks(int count, std::function<void(const SolverCall&)> send) {
  led = {count, 0, std::move(send)};
}

void follow_calls(const std::function<SolverCall()>& next) {
  openblas_set_num_threads(1);
  std::map<int, DMUMPS_STRUC_C> real;
  std::map<int, ZMUMPS_STRUC_C> complex;
  for (;;) {
    const SolverCall call = next();
    switch (call.kind) {
      case SolverCall::Kind::real: response(call, real); break;
      case SolverCall::Kind::complex: response(call, complex); break;
      case SolverCall::Kind::end: return;
    }
  }
}

template <class Number>
void Mumps<Number>::call(int job) {
  constexpr bool real = std::is_same_v<Number, double>;
  if (led.send) led.send({real ? SolverCall::Kind::real : SolverCall::Kind::complex, instance_, job});
  take_part(data_, job);
}

template <class Number>
Mumps<Number>::Mumps(const Matrices& m, std::vector<const Symmetric*> terms)
    : terms_(std::move(terms)), instance_(led.instances++) {
  openblas_set_num_threads(1);
  call(-1);
  option(6) = 0;    // no column permutation
  option(7) = 1;    // the order given
  option(8) = 77;   // scaling as MUMPS likes
  option(12) = 1;   // no pairs of pivots in the analysis
  option(13) = 1;   // the root is like any other front
  option(14) = 40;  // room for pivoting [%]
  option(24) = 0;   // a null pivot is an error
  option(28) = 1;   // the first rank analyses
  Pattern pattern(terms_);
  pattern.give(data_);
  std::vector<int> order = elimination_order(m);
  data_.n = m.equations.size();
  data_.perm_in = order.data();
  call(1);
}

template <class Number>
void Mumps<Number>::factor(std::span<const Number> factors) {
  Pattern pattern(terms_);
  pattern.give(data_);
  std::vector<Number> value;
  value.reserve(pattern.row.size());
  for (std::size_t t = 0; t < terms_.size(); ++t)
    for (std::size_t j = 0; j < terms_[t]->size(); ++j)
      for (const double v : terms_[t]->values(j)) value.push_back(v * factors[t]);
  data_.a = as_mumps(value.data());
  call(2);
  for (int more = 0; error() == -9 && more < 4; ++more) {  // delayed pivots needed more room than was asked for
    option(14) *= 2;
    call(2);
  }
}

template <class Number>
void Mumps<Number>::solve(Number* x, std::size_t columns) {
  data_.rhs = as_mumps(x);
  data_.nrhs = static_cast<MUMPS_INT>(columns);
  data_.lrhs = data_.n;
  option(27) = static_cast<MUMPS_INT>(columns);  // right-hand sides treated at a time
  call(3);
}

template class Mumps<double>;
template class Mumps<std::complex<double>>;

}  // namespace nugget::nvh
