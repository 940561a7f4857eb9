// SPDX-License-Identifier: Apache-2.0
#include "nvh/matrices/mumps_part.hpp"

#include <cstdint>
#include <stdexcept>
#include <utility>

#include "base/index.hpp"
#include "nvh/matrices/dense.hpp"
#include "nvh/matrices/elimination_order.hpp"
#include "nvh/matrices/ranks.hpp"

namespace nugget::nvh {
namespace {

bool within = false;

void call_mumps(DMUMPS_STRUC_C& data) {
  dmumps_c(&data);
}
void call_mumps(ZMUMPS_STRUC_C& data) {
  zmumps_c(&data);
}

/// std::complex<double> and MUMPS' complex number are two doubles each (C++ [complex.numbers]).
double* as_mumps(double* x) {
  return x;
}
ZMUMPS_COMPLEX* as_mumps(std::complex<double>* x) {
  return reinterpret_cast<ZMUMPS_COMPLEX*>(x);
}

}  // namespace

/// Rows, columns and values of the first columns of all terms; entries given twice are added up.
template <class Number>
struct MumpsPart<Number>::Entries {
  std::vector<MUMPS_INT> row, column;
  std::vector<Number> value;

  Entries(const std::vector<const Symmetric*>& terms, std::size_t columns, std::size_t first_column) {
    std::size_t entries = 0;
    for (const Symmetric* matrix : terms) entries += matrix->rows(0, columns).size();
    row.reserve(entries);
    column.reserve(entries);
    for (const Symmetric* matrix : terms)
      for (std::size_t j = 0; j < columns; ++j)
        for (const int i : matrix->rows(j)) {
          row.push_back(i + 1);
          column.push_back(static_cast<MUMPS_INT>(first_column + j) + 1);
        }
  }
  void fill(const std::vector<const Symmetric*>& terms, std::size_t columns, std::span<const Number> factors) {
    value.reserve(row.size());
    for (std::size_t t = 0; t < terms.size(); ++t)
      for (const double v : terms[t]->values(0, columns)) value.push_back(v * factors[t]);
  }
};

bool within_mumps() {
  return within;
}

template <class Number>
void MumpsPart<Number>::call(int job) {
  data_.job = job;
  within = true;
  call_mumps(data_);
  within = false;
}

template <class Number>
MumpsPart<Number>::MumpsPart(Ranks* ranks) : ranks_(ranks) {
  prepare_blas();
  data_.par = 1;
  data_.sym = 2;
  data_.comm_fortran = -987654;  // MUMPS' word for MPI_COMM_WORLD
  call(-1);
  for (const int i : {1, 2, 3}) option(i) = -1;  // silent
  option(4) = 0;
}

template <class Number>
MumpsPart<Number>::~MumpsPart() {
  if (!left_) call(-2);
}

template <class Number>
void MumpsPart<Number>::analyse(const Matrices& m, std::vector<const Symmetric*> terms) {
  terms_ = std::move(terms);
  if (ranks_ != nullptr) {
    shares_.emplace(m.size(), *ranks_);
    send_columns();
  }
  option(6) = 0;                           // no column permutation
  option(7) = 1;                           // the order given
  option(8) = 77;                          // scaling as MUMPS likes
  option(12) = 1;                          // no pairs of pivots in the analysis
  option(13) = 1;                          // the root is like any other front
  option(14) = 40;                         // room for pivoting [%]
  option(18) = ranks_ == nullptr ? 0 : 2;  // the first rank analyses; entries come from all
  option(24) = 0;                          // a null pivot is an error
  option(28) = 1;                          // the first rank analyses
  std::vector<int> order = elimination_order(m);
  Entries entries(terms_, m.size(), 0);
  data_.n = static_cast<MUMPS_INT>(m.size());
  data_.nnz = static_cast<MUMPS_INT8>(entries.row.size());
  data_.irn = entries.row.data();
  data_.jcn = entries.column.data();
  data_.perm_in = order.data();
  call(1);
}

template <class Number>
void MumpsPart<Number>::analyse() {
  receive_columns();
  call(1);
}

template <class Number>
void MumpsPart<Number>::send_columns() {
  std::uint64_t size[] = {shares_->rows(), terms_.size()};
  broadcast(*ranks_, size);
  std::vector<std::vector<int>> lengths;  // of columns; stays until the messages have gone
  std::vector<std::uint64_t> entries;
  entries.reserve(terms_.size() * at(ranks_->count()));
  for (int r = 1; r < ranks_->count(); ++r)
    for (const Symmetric* matrix : terms_) {
      const std::size_t begin = shares_->begin(r), end = shares_->end(r);
      std::vector<int>& length = lengths.emplace_back();
      for (std::size_t j = begin; j < end; ++j) length.push_back(static_cast<int>(matrix->rows(j).size()));
      ranks_->send(r, std::as_bytes(std::span(&entries.emplace_back(matrix->rows(begin, end).size()), 1)));
      ranks_->send(r, std::as_bytes(std::span(length)));
      ranks_->send(r, std::as_bytes(matrix->rows(begin, end)));
      ranks_->send(r, std::as_bytes(matrix->values(begin, end)));
    }
  ranks_->finish();
}

template <class Number>
void MumpsPart<Number>::receive_columns() {
  std::uint64_t size[2]{};
  broadcast(*ranks_, size);
  shares_.emplace(size[0], *ranks_);
  received_.reserve(size[1]);
  for (std::uint64_t t = 0; t < size[1]; ++t) {
    std::uint64_t entries = 0;
    ranks_->receive(0, std::as_writable_bytes(std::span(&entries, 1)));
    ranks_->finish();
    std::vector<int> length(shares_->own()), row(entries);
    std::vector<double> value(entries);
    ranks_->receive(0, std::as_writable_bytes(std::span(length)));
    ranks_->receive(0, std::as_writable_bytes(std::span(row)));
    ranks_->receive(0, std::as_writable_bytes(std::span(value)));
    ranks_->finish();
    terms_.push_back(&received_.emplace_back(length, std::move(row), std::move(value)));
  }
}

template <class Number>
void MumpsPart<Number>::factor(std::span<const Number> factors) {
  factors_.assign(factors.begin(), factors.end());
  factors_.resize(terms_.size());
  solution_.reset();
  if (ranks_ != nullptr) ranks_->broadcast(std::as_writable_bytes(std::span(factors_)));
  const std::size_t columns = shares_ ? shares_->own() : terms_.front()->size();
  Entries entries(terms_, columns, shares_ ? shares_->own_begin() : 0);
  entries.fill(terms_, columns, factors_);
  if (shares_) {
    data_.nnz_loc = static_cast<MUMPS_INT8>(entries.row.size());
    data_.irn_loc = entries.row.data();
    data_.jcn_loc = entries.column.data();
    data_.a_loc = as_mumps(entries.value.data());
  } else {
    data_.nnz = static_cast<MUMPS_INT8>(entries.row.size());
    data_.irn = entries.row.data();
    data_.jcn = entries.column.data();
    data_.a = as_mumps(entries.value.data());
  }
  call(2);
  for (int more = 0; error() == -9 && more < 4; ++more) {  // delayed pivots needed more room than was asked for
    option(14) *= 2;
    call(2);
  }
}

template <class Number>
void MumpsPart<Number>::solve(Number* x, std::size_t columns) {
  data_.rhs = as_mumps(x);
  data_.nrhs = static_cast<MUMPS_INT>(columns);
  data_.lrhs = data_.n;
  option(20) = option(21) = 0;                   // on the first rank
  option(27) = static_cast<MUMPS_INT>(columns);  // right-hand sides treated at a time
  call(3);
}

template <class Number>
void MumpsPart<Number>::solve_rows(Columns& x) {
  std::vector<MUMPS_INT> row(x.rows), row_of_solution(at(data_.info[22]));
  for (std::size_t i = 0; i < row.size(); ++i) row[i] = static_cast<MUMPS_INT>(shares_->own_begin() + i) + 1;
  Columns solution(row_of_solution.size(), x.count);
  if constexpr (std::is_same_v<Number, double>) {
    data_.rhs_loc = x.value.data();
    data_.sol_loc = solution.value.data();
  } else {
    throw std::logic_error("vectors of Columns are real");
  }
  data_.irhs_loc = row.data();
  data_.nloc_rhs = data_.lrhs_loc = static_cast<MUMPS_INT>(x.rows);
  data_.nrhs = static_cast<MUMPS_INT>(x.count);
  data_.isol_loc = row_of_solution.data();
  data_.lsol_loc = static_cast<MUMPS_INT>(solution.rows);
  option(20) = 10;  // right-hand sides and solutions: each rank its rows
  option(21) = 1;
  option(27) = static_cast<MUMPS_INT>(x.count);
  call(3);
  if (error() < 0) return;
  for (MUMPS_INT& i : row_of_solution) --i;
  if (!solution_) solution_.emplace(*ranks_, *shares_, row_of_solution);
  solution_->put(solution, x);
}

template class MumpsPart<double>;
template class MumpsPart<std::complex<double>>;

}  // namespace nugget::nvh
