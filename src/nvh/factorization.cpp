// SPDX-License-Identifier: Apache-2.0
#include "nvh/factorization.hpp"

#include <cblas.h>
#include <dmumps_c.h>
#include <fmt/format.h>
#include <metis.h>

#include <algorithm>
#include <chrono>

#include "base/index.hpp"

namespace nugget::nvh {
std::vector<int> elimination_order(const Matrices& m) {
  const Equations& equations = m.equations;
  const int size = equations.size();
  // Nodes that have unknowns, in the order of their equations.
  std::vector<int> block(at(size)), first;
  for (int i = 0; i < size; ++i) {
    if (i == 0 || equations.node_of(i) != equations.node_of(i - 1)) first.push_back(i);
    block[at(i)] = static_cast<int>(first.size()) - 1;
  }
  const auto blocks = static_cast<idx_t>(first.size());
  first.push_back(size);

  std::vector<std::vector<idx_t>> neighbours(first.size() - 1);
  for (const Symmetric* matrix : {&m.stiffness, &m.mass})
    for (std::size_t b = 0; b + 1 < first.size(); ++b)
      for (int j = first[b]; j < first[b + 1]; ++j) {
        int last = -1;
        for (const int row : matrix->rows(at(j))) {
          const int other = block[at(row)];
          if (other == last || other == static_cast<int>(b)) continue;
          last = other;
          neighbours[b].push_back(other);
          neighbours[at(other)].push_back(static_cast<idx_t>(b));
        }
      }
  std::vector<idx_t> start{0}, list, weight;
  for (std::size_t b = 0; b + 1 < first.size(); ++b) {
    std::vector<idx_t>& n = neighbours[b];
    std::sort(n.begin(), n.end());
    n.erase(std::unique(n.begin(), n.end()), n.end());
    list.insert(list.end(), n.begin(), n.end());
    start.push_back(static_cast<idx_t>(list.size()));
    weight.push_back(first[b + 1] - first[b]);
  }
  std::vector<idx_t> order(first.size() - 1), place(first.size() - 1);
  idx_t vertices = blocks;
  if (list.empty())
    for (std::size_t b = 0; b < order.size(); ++b) order[b] = static_cast<idx_t>(b);
  else
    METIS_NodeND(&vertices, start.data(), list.data(), weight.data(), nullptr, order.data(), place.data());

  std::vector<int> position(at(size));
  int next = 1;
  for (const idx_t b : order)
    for (int i = first[at(b)]; i < first[at(b) + 1]; ++i) position[at(i)] = next++;
  return position;
}

struct Factorization::Mumps {
  DMUMPS_STRUC_C data{};
  std::vector<MUMPS_INT> row, column, order;
  std::vector<double> value;

  void call(int job) {
    data.job = job;
    dmumps_c(&data);
  }
};

Factorization::Factorization(const Matrices& m, double shift) : mumps_(std::make_unique<Mumps>()), shift_(shift) {
  const auto begin = std::chrono::steady_clock::now();
  openblas_set_num_threads(1);  // so that sums do not depend on how many there are
  Mumps& mumps = *mumps_;
  const auto add = [&](const Symmetric& matrix, double factor) {
    for (std::size_t j = 0; j < matrix.size(); ++j)
      for (std::size_t k = 0; k < matrix.rows(j).size(); ++k) {
        mumps.row.push_back(matrix.rows(j)[k] + 1);
        mumps.column.push_back(static_cast<MUMPS_INT>(j) + 1);
        mumps.value.push_back(factor * matrix.values(j)[k]);
      }
  };
  const std::size_t entries = m.stiffness.entries() + (shift != 0.0 ? m.mass.entries() : 0);
  mumps.row.reserve(entries);
  mumps.column.reserve(entries);
  mumps.value.reserve(entries);
  add(m.stiffness, 1.0);
  if (shift != 0.0) add(m.mass, shift);  // entries given twice are added up
  mumps.order = elimination_order(m);

  DMUMPS_STRUC_C& d = mumps.data;
  d.par = 1;
  d.sym = 2;
  d.comm_fortran = -987654;  // MUMPS' word for MPI_COMM_WORLD
  mumps.call(-1);
  const auto option = [&](int i) -> MUMPS_INT& { return d.icntl[i - 1]; };  // numbers as in the user's guide
  for (const int i : {1, 2, 3, 4}) option(i) = i == 4 ? 0 : -1;             // silent
  option(6) = 0;                                                            // no column permutation
  option(7) = 1;                                                            // the order given
  option(8) = 77;                                                           // scaling as MUMPS likes
  option(13) = 1;                                                           // the root is like any other front
  option(14) = 40;                                                          // room for pivoting [%]
  option(24) = 0;                                                           // a null pivot is an error
  d.n = m.equations.size();
  d.nnz = static_cast<MUMPS_INT8>(mumps.value.size());
  d.irn = mumps.row.data();
  d.jcn = mumps.column.data();
  d.a = mumps.value.data();
  d.perm_in = mumps.order.data();
  mumps.call(4);
  for (int more = 0; d.infog[0] == -9 && more < 4; ++more) {  // delayed pivots needed more room than was asked for
    option(14) *= 2;
    mumps.call(2);
  }
  if (d.infog[0] < 0) {
    const int code = d.infog[0];
    mumps.call(-2);  // the destructor of an object that never was does not run
    throw SolverError{code == -10   ? "the matrix is singular: something can move without any stiffness"
                      : code == -13 ? "not enough memory to factor the matrix"
                                    : fmt::format("MUMPS gave up with INFOG(1) = {}", code)};
  }
  for (std::vector<MUMPS_INT>* v : {&mumps.row, &mumps.column, &mumps.order}) std::vector<MUMPS_INT>().swap(*v);
  std::vector<double>().swap(mumps.value);
  cost_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  cost_.entries = d.infog[8] < 0 ? -1e6 * d.infog[8] : d.infog[8];
  cost_.gflop = 1e-9 * d.rinfog[2];
}

Factorization::Factorization(Factorization&&) noexcept = default;

Factorization::~Factorization() {
  if (mumps_) mumps_->call(-2);
}

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
