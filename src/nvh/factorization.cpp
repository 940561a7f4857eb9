// SPDX-License-Identifier: Apache-2.0
#include "nvh/factorization.hpp"

#include <cblas.h>
#include <dmumps_c.h>
#include <fmt/format.h>

#include <chrono>
#include <utility>
#include <vector>

#include "nvh/elimination_order.hpp"

namespace nugget::nvh {

/// An instance of MUMPS with the order and the tree of eliminations of one pattern.
struct Factorization::Mumps {
  explicit Mumps(const Matrices& m);
  ~Mumps() { call(-2); }
  Mumps(const Mumps&) = delete;
  Mumps& operator=(const Mumps&) = delete;

  void factor(double shift);
  void call(int job) {
    data.job = job;
    dmumps_c(&data);
  }
  MUMPS_INT& option(int i) { return data.icntl[i - 1]; }  // numbers as in the user's guide

  const Matrices& matrices;
  DMUMPS_STRUC_C data{};

 private:
  struct Pattern {
    std::vector<MUMPS_INT> row, column;
  };
  Pattern pattern() const;
};

Factorization::Mumps::Pattern Factorization::Mumps::pattern() const {
  Pattern p;
  const std::size_t entries = matrices.stiffness.entries() + matrices.mass.entries();
  p.row.reserve(entries);
  p.column.reserve(entries);
  for (const Symmetric* matrix : {&matrices.stiffness, &matrices.mass})  // entries given twice are added up
    for (std::size_t j = 0; j < matrix->size(); ++j)
      for (const int row : matrix->rows(j)) {
        p.row.push_back(row + 1);
        p.column.push_back(static_cast<MUMPS_INT>(j) + 1);
      }
  return p;
}

Factorization::Mumps::Mumps(const Matrices& m) : matrices(m) {
  openblas_set_num_threads(1);  // so that sums do not depend on how many there are
  data.par = 1;
  data.sym = 2;
  data.comm_fortran = -987654;  // MUMPS' word for MPI_COMM_WORLD
  call(-1);
  for (const int i : {1, 2, 3, 4}) option(i) = i == 4 ? 0 : -1;  // silent
  option(6) = 0;                                                 // no column permutation
  option(7) = 1;                                                 // the order given
  option(8) = 77;                                                // scaling as MUMPS likes
  option(12) = 1;                                                // no pairs of pivots in the analysis
  option(13) = 1;                                                // the root is like any other front
  option(14) = 40;                                               // room for pivoting [%]
  option(24) = 0;                                                // a null pivot is an error
  Pattern p = pattern();
  std::vector<int> order = elimination_order(m);
  data.n = m.equations.size();
  data.nnz = static_cast<MUMPS_INT8>(p.row.size());
  data.irn = p.row.data();
  data.jcn = p.column.data();
  data.perm_in = order.data();
  call(1);
}

void Factorization::Mumps::factor(double shift) {
  Pattern p = pattern();
  std::vector<double> value;
  value.reserve(p.row.size());
  for (const auto& [matrix, scale] : {std::pair{&matrices.stiffness, 1.0}, std::pair{&matrices.mass, shift}})
    for (std::size_t j = 0; j < matrix->size(); ++j)
      for (const double v : matrix->values(j)) value.push_back(scale * v);
  data.irn = p.row.data();
  data.jcn = p.column.data();
  data.a = value.data();
  call(2);
  for (int more = 0; data.infog[0] == -9 && more < 4; ++more) {  // delayed pivots needed more room than was asked for
    option(14) *= 2;
    call(2);
  }
}

Factorization::Factorization(const Matrices& m, double shift) : shift_(shift) {
  const auto begin = std::chrono::steady_clock::now();
  mumps_ = std::make_unique<Mumps>(m);
  if (mumps_->data.infog[0] >= 0) shift_to(shift);
  check();
  cost_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

void Factorization::shift_to(double shift) {
  const auto begin = std::chrono::steady_clock::now();
  shift_ = shift;
  mumps_->factor(shift);
  check();
  const DMUMPS_STRUC_C& d = mumps_->data;
  cost_ = {std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(),
           d.infog[8] < 0 ? -1e6 * d.infog[8] : d.infog[8], 1e-9 * d.rinfog[2]};
}

void Factorization::check() const {
  const int code = mumps_->data.infog[0];
  if (code < 0)
    throw SolverError{code == -10   ? "the matrix is singular: something can move without any stiffness"
                      : code == -13 ? "not enough memory to factor the matrix"
                                    : fmt::format("MUMPS gave up with INFOG(1) = {}", code)};
}

Factorization::Factorization(Factorization&&) noexcept = default;
Factorization::~Factorization() = default;

int Factorization::negative() const {
  return mumps_->data.infog[11];
}

void Factorization::solve(Columns& x) const {
  DMUMPS_STRUC_C& d = mumps_->data;
  d.rhs = x.value.data();
  d.nrhs = static_cast<MUMPS_INT>(x.count);
  d.lrhs = static_cast<MUMPS_INT>(x.rows);
  d.icntl[26] = static_cast<MUMPS_INT>(x.count);  // right-hand sides treated at a time
  mumps_->call(3);
  if (d.infog[0] < 0) throw SolverError{fmt::format("MUMPS could not solve: INFOG(1) = {}", d.infog[0])};
}

}  // namespace nugget::nvh
