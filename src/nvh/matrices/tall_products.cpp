// SPDX-License-Identifier: Apache-2.0
#include "nvh/matrices/tall_products.hpp"

#include <algorithm>
#include <cstring>

#include "base/batch.hpp"
#include "base/parallel.hpp"

namespace nugget::nvh::tall {
namespace {

constexpr int width = native_width;
using Lanes = Batch<width>;
// Rows whose part of B and C stays in the first cache while columns of A pass by; rows that one thread takes at once.
constexpr std::size_t block = 256, chunk = 32 * block;

Lanes load(const double* from) {
  Lanes x;
  std::memcpy(&x.v, from, sizeof x.v);
  return x;
}
void store(double* to, const Lanes& x) {
  std::memcpy(to, &x.v, sizeof x.v);
}

/// Part of some columns of equal distance, from one row on.
template <class Number>
struct Part {
  Number* first;
  std::size_t distance;
  Number* operator[](int column) const { return first + static_cast<std::size_t>(column) * distance; }
};
using In = Part<const double>;
using Out = Part<double>;

/// A row of registers of A columns. The columns that come `next` are asked for meanwhile: each lies on other pages,
/// which processors do not guess.
template <int A>
void load_columns(const In& a, std::size_t r, bool next, Lanes (&x)[A]) {
  for (int i = 0; i < A; ++i) {
    if (next) __builtin_prefetch(a[A + i] + r);
    x[i] = load(a[i] + r);
  }
}

/// sum += a^t b over `rows` rows, of A and B columns; `next`: whether to ask for the A columns that follow.
template <int A, int B>
void add_inner(const In& a, const In& b, std::size_t rows, const Out& sum, bool next) {
  Lanes s[A][B];
  std::size_t r = 0;
  for (; r + width <= rows; r += width) {
    Lanes x[A];
    load_columns(a, r, next, x);
    for (int j = 0; j < B; ++j) {
      const Lanes y = load(b[j] + r);
      for (int i = 0; i < A; ++i) s[i][j] += x[i] * y;
    }
  }
  for (int j = 0; j < B; ++j)
    for (int i = 0; i < A; ++i) {
      double total = 0.0;
      for (int l = 0; l < width; ++l) total += s[i][j].v[l];
      for (std::size_t k = r; k < rows; ++k) total += a[i][k] * b[j][k];
      sum[j][i] += total;
    }
}

/// c += alpha a f over `rows` rows, of A columns of a and B of c.
template <int A, int B>
void add_columns(double alpha, const In& a, const In& f, std::size_t rows, const Out& c, bool next) {
  double share[A][B];
  for (int j = 0; j < B; ++j)
    for (int i = 0; i < A; ++i) share[i][j] = alpha * f[j][i];
  std::size_t r = 0;
  for (; r + width <= rows; r += width) {
    Lanes x[A];
    load_columns(a, r, next, x);
    for (int j = 0; j < B; ++j) {
      double* const to = c[j] + r;
      Lanes y = load(to);
      for (int i = 0; i < A; ++i) y += x[i] * Lanes(share[i][j]);
      store(to, y);
    }
  }
  for (; r < rows; ++r)
    for (int j = 0; j < B; ++j)
      for (int i = 0; i < A; ++i) c[j][r] += a[i][r] * share[i][j];
}

/// Calls tile<A, B>(i, j, next) for tiles of A of `many` and B of `few` columns, those of one i one after the other;
/// `next` in the first of them.
template <int A, int B, class Tile>
void each_tile(std::size_t many, std::size_t few, const Tile& tile) {
  std::size_t i = 0;
  for (; i + A <= many; i += A) {
    std::size_t j = 0;
    const bool more = i + 2 * A <= many;
    for (; j + B <= few; j += B) tile.template operator()<A, B>(i, j, more && j == 0);
    for (; j < few; ++j) tile.template operator()<A, 1>(i, j, more && j == 0);
  }
  for (; i < many; ++i)
    for (std::size_t j = 0; j < few; ++j) tile.template operator()<1, 1>(i, j, false);
}

/// Calls body(c, from, to) for chunks of rows, on all threads.
template <class Body>
void each_chunk(std::size_t rows, const Body& body) {
  parallel_for((rows + chunk - 1) / chunk, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) body(c, c * chunk, std::min(rows, (c + 1) * chunk));
  });
}

}  // namespace

void inner(const Columns& a, std::size_t a_first, const Columns& b, Columns& c) {
  const std::size_t n = a.rows;
  std::vector<Columns> sums((n + chunk - 1) / chunk);
  each_chunk(n, [&](std::size_t at, std::size_t from, std::size_t to) {
    Columns& sum = sums[at];
    sum = Columns(c.rows, c.count);
    for (std::size_t r = from; r < to; r += block) {
      const std::size_t rows = std::min(block, to - r);
      each_tile<3, 4>(c.rows, c.count, [&]<int A, int B>(std::size_t i, std::size_t j, bool next) {
        add_inner<A, B>({a[a_first + i].data() + r, n}, {b[j].data() + r, n}, rows, {sum[j].data() + i, c.rows}, next);
      });
    }
  });
  std::fill(c.value.begin(), c.value.end(), 0.0);
  for (const Columns& sum : sums)
    for (std::size_t k = 0; k < c.value.size(); ++k) c.value[k] += sum.value[k];
}

void add_product(double alpha, const Columns& a, std::size_t a_first, const Columns& b, double beta, Columns& c) {
  const std::size_t n = a.rows;
  each_chunk(n, [&](std::size_t, std::size_t from, std::size_t to) {
    for (std::size_t r = from; r < to; r += block) {
      const std::size_t rows = std::min(block, to - r);
      if (beta != 1.0)
        for (std::size_t j = 0; j < c.count; ++j)
          for (double& v : c[j].subspan(r, rows)) v = beta == 0.0 ? 0.0 : beta * v;
      each_tile<4, 2>(b.rows, c.count, [&]<int A, int B>(std::size_t i, std::size_t j, bool next) {
        add_columns<A, B>(alpha, {a[a_first + i].data() + r, n}, {b[j].data() + i, b.rows}, rows, {c[j].data() + r, n},
                          next);
      });
    }
  });
}

}  // namespace nugget::nvh::tall
