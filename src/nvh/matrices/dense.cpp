// SPDX-License-Identifier: Apache-2.0
#include "nvh/matrices/dense.hpp"

#include <cblas.h>
#define LAPACK_COMPLEX_CUSTOM  // std::complex in its interface
#define lapack_complex_float std::complex<float>
#define lapack_complex_double std::complex<double>
#include <lapacke.h>

#include <algorithm>
#include <limits>
#include <memory>

#include "nvh/matrices/tall_products.hpp"

namespace nugget::nvh {

void prepare_blas() {
  static const bool prepared = [] {
    openblas_set_num_threads(1);
    constexpr std::size_t taken = std::size_t{160} << 20;  // OpenBLAS's BUFFER_SIZE, at most
    {
      const auto probe = std::make_unique_for_overwrite<char[]>(taken);
      volatile char* used = probe.get();  // else compilers leave it out
      *used = 0;
    }
    const Columns large_enough(128, 128);
    inner(large_enough, 128, large_enough);
    return true;
  }();
  (void)prepared;
}

Columns inner(const Columns& a, std::size_t a_count, const Columns& b, std::size_t a_first) {
  Columns c(a_count, b.count);
  if (tall::pays(a.rows, b.count))
    tall::inner(a, a_first, b, c);
  else if (a_count > 0 && b.count > 0 && a.rows > 0)
    cblas_dgemm(CblasColMajor, CblasTrans, CblasNoTrans, static_cast<int>(a_count), static_cast<int>(b.count),
                static_cast<int>(a.rows), 1.0, a[a_first].data(), static_cast<int>(a.rows), b.value.data(),
                static_cast<int>(b.rows), 0.0, c.value.data(), static_cast<int>(a_count));
  return c;
}

void add_product(double alpha, const Columns& a, std::size_t a_count, const Columns& b, double beta, Columns& c,
                 std::size_t a_first) {
  if (tall::pays(a.rows, b.count))
    tall::add_product(alpha, a, a_first, b, beta, c);
  else if (a_count > 0 && b.count > 0 && a.rows > 0)
    cblas_dgemm(CblasColMajor, CblasNoTrans, CblasNoTrans, static_cast<int>(a.rows), static_cast<int>(b.count),
                static_cast<int>(a_count), alpha, a[a_first].data(), static_cast<int>(a.rows), b.value.data(),
                static_cast<int>(b.rows), beta, c.value.data(), static_cast<int>(c.rows));
}

void solve(std::vector<std::complex<double>>& a, std::vector<std::complex<double>>& b, std::size_t n) {
  if (n == 0) return;
  std::vector<lapack_int> pivot(n);
  const auto size = static_cast<lapack_int>(n), columns = static_cast<lapack_int>(b.size() / n);
  if (LAPACKE_zgesv(LAPACK_COL_MAJOR, size, columns, a.data(), size, pivot.data(), b.data(), size) != 0)
    std::fill(b.begin(), b.end(), std::numeric_limits<double>::quiet_NaN());
}

std::vector<double> diagonalize(Columns& a) {
  std::vector<double> value(a.count);
  LAPACKE_dsyevd(LAPACK_COL_MAJOR, 'V', 'L', static_cast<int>(a.count), a.value.data(), static_cast<int>(a.rows),
                 value.data());
  return value;
}

}  // namespace nugget::nvh
