// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

// Least squares of a few parameters.
namespace nugget::weld {

/// A matrix with few columns, column by column.
using Columns = std::vector<std::vector<double>>;

/// A = U S V^T of a matrix with at least as many rows as columns, the largest singular value first.
struct SingularParts {
  std::vector<double> value;
  Columns image;  ///< columns of A V = U S
  Columns right;  ///< columns of V
};
/// By rotations of pairs of columns until all are perpendicular (Hestenes 1958, J. SIAM 6, 51-90): digits of small
/// values are not lost to large ones.
SingularParts singular_parts(Columns matrix);

/// The x that makes |A x - b|^2 + damping |x|^2 smallest.
std::vector<double> least_squares(const SingularParts& of, const std::vector<double>& b, double damping = 0.0);

/// A sum of squares that is to become smallest.
struct SquareSum {
  std::function<std::vector<double>(const std::vector<double>& x)> residuals;
  /// A column for each parameter. `here`: the residuals at `x`.
  std::function<Columns(const std::vector<double>& x, const std::vector<double>& here)> derivatives;
  double least_change = 1e-12;  ///< of the sum, over the sum: steps end where there is no more to be had
  double least_step = 1e-12;    ///< likewise, of x over x
  int evaluations = 400;        ///< of the residuals, at most
};
/// By Gauss-Newton steps from `x`, damped where they would make the sum larger (Marquardt 1963, J. SIAM 11, 431-441).
std::vector<double> minimized(const SquareSum& sum, std::vector<double> x);

}  // namespace nugget::weld
