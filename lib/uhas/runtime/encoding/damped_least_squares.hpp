// Small linear least squares with damping: minimises sum of weight (a . x - b)^2 + damping |x|^2 over x.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace uhas {

/// The normal equations of at most `max_unknowns` unknowns; plain double, no allocation.
template <int max_unknowns>
class DampedLeastSquares {
 public:
  explicit DampedLeastSquares(int unknowns) : n_(unknowns) {
    std::fill_n(A_.begin(), n_ * n_, 0.0);
    std::fill_n(y_.begin(), n_, 0.0);
  }

  /// One equation a . x = b: adds its share to A = sum of weight a a^T and y = sum of weight a b.
  /// @param a  one coefficient an unknown
  void add(std::span<const double> a, double b, double weight) noexcept {
    for (int i = 0; i < n_; ++i) {
      for (int j = 0; j <= i; ++j) A_[i * n_ + j] += weight * a[i] * a[j];
      y_[i] += weight * a[i] * b;
    }
  }

  /// The minimum, where (A + damping I) x = y; `damping` > 0 makes it unique.
  std::array<double, max_unknowns> solve(double damping) const noexcept {
    std::array<double, max_unknowns * max_unknowns> L;
    std::array<double, max_unknowns> x;

    // Cholesky: A + damping I = L L^T, a row of L after the other, and L z = y solved along with it (x holds z)
    for (int i = 0; i < n_; ++i) {
      for (int j = 0; j <= i; ++j) {
        double sum = A_[i * n_ + j] + (i == j ? damping : 0.0);
        for (int k = 0; k < j; ++k) sum -= L[i * n_ + k] * L[j * n_ + k];
        L[i * n_ + j] = i == j ? std::sqrt(sum) : sum / L[j * n_ + j];
      }
      double sum = y_[i];
      for (int k = 0; k < i; ++k) sum -= L[i * n_ + k] * x[k];
      x[i] = sum / L[i * n_ + i];
    }

    // L^T x = z, from the last unknown back
    for (int i = n_; i-- > 0;) {
      for (int k = i + 1; k < n_; ++k) x[i] -= L[k * n_ + i] * x[k];
      x[i] /= L[i * n_ + i];
    }
    return x;
  }

 private:
  int n_;
  std::array<double, max_unknowns * max_unknowns> A_;  // lower triangle, [n][n]
  std::array<double, max_unknowns> y_;
};

}  // namespace uhas
