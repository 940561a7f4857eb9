// SPDX-License-Identifier: Apache-2.0
#include "nvh/complex_factorization.hpp"

#include <cblas.h>
#include <fmt/format.h>
#include <zmumps_c.h>

#include "base/index.hpp"
#include "nvh/elimination_order.hpp"
#include "nvh/factorization.hpp"

namespace nugget::nvh {

struct ComplexFactorization::Mumps {
  ZMUMPS_STRUC_C data{};
  std::vector<MUMPS_INT> row, column, order;
  std::vector<ZMUMPS_COMPLEX> value;

  Mumps() {
    data.par = 1;
    data.sym = 2;
    data.comm_fortran = -987654;  // MUMPS' word for MPI_COMM_WORLD
    call(-1);
  }
  ~Mumps() {
    data.job = -2;
    zmumps_c(&data);
  }
  Mumps(const Mumps&) = delete;
  Mumps& operator=(const Mumps&) = delete;

  /// Throws where MUMPS reports an error.
  void call(int job) {
    data.job = job;
    zmumps_c(&data);
    const int code = data.infog[0];
    if (code < 0)
      throw Factorization::SolverError{
          code == -10   ? "the dynamic stiffness is singular: an undamped natural frequency, or something moves freely"
          : code == -13 ? "not enough memory to factor the dynamic stiffness"
                        : fmt::format("MUMPS gave up with INFOG(1) = {}", code)};
  }
  MUMPS_INT& option(int i) { return data.icntl[i - 1]; }  // numbers as in the user's guide
};

ComplexFactorization::ComplexFactorization(const Matrices& m, const Symmetric* damping)
    : matrices_(m), damping_(damping), mumps_(std::make_unique<Mumps>()) {
  openblas_set_num_threads(1);  // so that sums do not depend on how many there are
  for (const Symmetric* matrix : {&m.stiffness, &m.mass, damping}) {
    if (matrix == nullptr) continue;
    for (std::size_t j = 0; j < matrix->size(); ++j)
      for (const int row : matrix->rows(j)) {
        mumps_->row.push_back(row + 1);
        mumps_->column.push_back(static_cast<MUMPS_INT>(j) + 1);
      }
  }
  mumps_->value.resize(mumps_->row.size());
  mumps_->order = elimination_order(m);

  ZMUMPS_STRUC_C& d = mumps_->data;
  for (const int i : {1, 2, 3, 4}) mumps_->option(i) = i == 4 ? 0 : -1;  // silent
  mumps_->option(6) = 0;                                                 // no column permutation
  mumps_->option(7) = 1;                                                 // the order given
  mumps_->option(8) = 77;                                                // scaling as MUMPS likes
  mumps_->option(13) = 1;                                                // the root is like any other front
  mumps_->option(14) = 40;                                               // room for pivoting [%]
  d.n = m.equations.size();
  d.nnz = static_cast<MUMPS_INT8>(mumps_->value.size());
  d.irn = mumps_->row.data();
  d.jcn = mumps_->column.data();
  d.a = mumps_->value.data();
  d.perm_in = mumps_->order.data();
  mumps_->call(1);
}

ComplexFactorization::~ComplexFactorization() = default;

void ComplexFactorization::factor(std::complex<double> of_stiffness, std::complex<double> of_mass,
                                  std::complex<double> of_damping) {
  std::size_t k = 0;
  const auto put = [&](const Symmetric& matrix, std::complex<double> factor) {
    for (std::size_t j = 0; j < matrix.size(); ++j)
      for (const double v : matrix.values(j)) mumps_->value[k++] = {v * factor.real(), v * factor.imag()};
  };
  put(matrices_.stiffness, of_stiffness);
  put(matrices_.mass, of_mass);  // entries given twice are added up
  if (damping_ != nullptr) put(*damping_, of_damping);
  for (int more = 0;; ++more) {  // delayed pivots may need more room than was asked for
    try {
      mumps_->call(2);
      return;
    } catch (const Factorization::SolverError&) {
      if (mumps_->data.infog[0] != -9 || more == 4) throw;
      mumps_->option(14) *= 2;
    }
  }
}

void ComplexFactorization::solve(std::vector<std::complex<double>>& x, std::size_t columns) {
  ZMUMPS_STRUC_C& d = mumps_->data;
  d.rhs = reinterpret_cast<ZMUMPS_COMPLEX*>(x.data());  // both are two doubles (C++ [complex.numbers])
  d.nrhs = static_cast<MUMPS_INT>(columns);
  d.lrhs = d.n;
  mumps_->call(3);
}

}  // namespace nugget::nvh
