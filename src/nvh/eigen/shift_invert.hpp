// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nvh/matrices/factorization.hpp"
#include "nvh/matrices/mumps_part.hpp"
#include "nvh/matrices/shared_matrix.hpp"

namespace nugget::nvh {

/// M, and A^-1 = (K + shift M)^-1, as they act on vectors of which this rank has some rows: all of them alone.
class ShiftInvert {
 public:
  virtual ~ShiftInvert() = default;
  ShiftInvert(const ShiftInvert&) = delete;
  ShiftInvert& operator=(const ShiftInvert&) = delete;

  virtual std::size_t size() const = 0;       ///< of the matrices
  virtual std::size_t first_row() const = 0;  ///< of this rank
  virtual std::size_t rows() const = 0;       ///< of this rank
  virtual double shift() const = 0;
  /// y := M x
  virtual void multiply_mass(const Columns& x, Columns& y) const = 0;
  /// x := A^-1 x. Throws Factorization::SolverError.
  virtual void solve(Columns& x) const = 0;
  /// Sums over the rows of this rank become those over all rows, the same bits on all ranks.
  virtual void add_up(Columns& sums) const = 0;
  /// The values of the first rank take the place of those here, which may differ by round-off.
  virtual void agree(std::span<double> values) const = 0;

 protected:
  ShiftInvert() = default;
};

/// All rows.
class WholeShiftInvert final : public ShiftInvert {
 public:
  /// Both must outlive it.
  WholeShiftInvert(const Matrices& matrices, const Factorization& factorization) : m_(matrices), a_(factorization) {}
  std::size_t size() const override { return m_.size(); }
  std::size_t first_row() const override { return 0; }
  std::size_t rows() const override { return m_.size(); }
  double shift() const override { return a_.shift(); }
  void multiply_mass(const Columns& x, Columns& y) const override { multiply(m_.mass, x, y); }
  void solve(Columns& x) const override { a_.solve(x); }
  void add_up(Columns&) const override {}
  void agree(std::span<double>) const override {}

 private:
  const Matrices& m_;
  const Factorization& a_;
};

/// The rows of one rank, whose part of the factorization it solves with. All ranks make one, and call each function,
/// together.
class SharedShiftInvert final : public ShiftInvert {
 public:
  /// The part must outlive it; its terms are K and M.
  explicit SharedShiftInvert(MumpsPart<double>& part);
  std::size_t size() const override { return part_.shares().rows(); }
  std::size_t first_row() const override { return part_.shares().own_begin(); }
  std::size_t rows() const override { return part_.shares().own(); }
  double shift() const override { return part_.factors()[1]; }
  void multiply_mass(const Columns& x, Columns& y) const override { mass_.multiply(x, y); }
  void solve(Columns& x) const override;
  void add_up(Columns& sums) const override;
  void agree(std::span<double> values) const override;

 private:
  MumpsPart<double>& part_;
  SharedMatrix mass_;
};

}  // namespace nugget::nvh
