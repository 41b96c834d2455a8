// Vectors and rotations of three dimensions as plain aggregates, so that they can cross a compiled boundary whatever
// the flags of the two sides. Rotations are row-major.
#pragma once

#include <array>
#include <cmath>

namespace uhas {

template <class Real>
struct Vector3 {
  Real x{}, y{}, z{};

  friend constexpr Vector3 operator+(Vector3 a, Vector3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend constexpr Vector3 operator-(Vector3 a, Vector3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend constexpr Vector3 operator-(Vector3 a) { return {-a.x, -a.y, -a.z}; }
  friend constexpr Vector3 operator*(Real s, Vector3 a) { return {s * a.x, s * a.y, s * a.z}; }
  friend constexpr Vector3 operator*(Vector3 a, Real s) { return s * a; }
  friend constexpr Vector3 operator/(Vector3 a, Real s) { return {a.x / s, a.y / s, a.z / s}; }
  constexpr Vector3& operator+=(Vector3 b) { return *this = *this + b; }
  constexpr Vector3& operator-=(Vector3 b) { return *this = *this - b; }
  friend constexpr bool operator==(Vector3 a, Vector3 b) = default;

  /// The same numbers in another type.
  template <class To>
  constexpr Vector3<To> cast() const {
    return {static_cast<To>(x), static_cast<To>(y), static_cast<To>(z)};
  }
};

template <class Real>
constexpr Real dot(Vector3<Real> a, Vector3<Real> b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class Real>
constexpr Vector3<Real> cross(Vector3<Real> a, Vector3<Real> b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class Real>
Real norm(Vector3<Real> a) {
  return std::sqrt(dot(a, a));
}

/// `a` divided by its length; the zero vector stays zero.
template <class Real>
Vector3<Real> normalized(Vector3<Real> a) {
  const Real length = norm(a);
  return length > Real(0) ? a / length : a;
}

/// The part of `a` orthogonal to the unit vector `axis`.
template <class Real>
constexpr Vector3<Real> orthogonal_part(Vector3<Real> a, Vector3<Real> axis) {
  return a - dot(a, axis) * axis;
}

/// Any unit vector orthogonal to the unit vector `a`.
template <class Real>
Vector3<Real> any_orthogonal(Vector3<Real> a) {
  const Vector3<Real> seed = std::abs(a.x) < Real(0.6) ? Vector3<Real>{1, 0, 0} : Vector3<Real>{0, 1, 0};
  return normalized(cross(a, seed));
}

template <class Real>
bool is_finite(Vector3<Real> a) {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

/// A rotation matrix, row-major: element (i, j) is `m[3 * i + j]`.
template <class Real>
struct Rotation {
  std::array<Real, 9> m{1, 0, 0, 0, 1, 0, 0, 0, 1};

  friend constexpr Vector3<Real> operator*(const Rotation& R, Vector3<Real> a) {
    return {R.m[0] * a.x + R.m[1] * a.y + R.m[2] * a.z, R.m[3] * a.x + R.m[4] * a.y + R.m[5] * a.z,
            R.m[6] * a.x + R.m[7] * a.y + R.m[8] * a.z};
  }
  friend constexpr Rotation operator*(const Rotation& A, const Rotation& B) {
    const auto& a = A.m;
    const auto& b = B.m;
    return {{a[0] * b[0] + a[1] * b[3] + a[2] * b[6], a[0] * b[1] + a[1] * b[4] + a[2] * b[7],
             a[0] * b[2] + a[1] * b[5] + a[2] * b[8],  //
             a[3] * b[0] + a[4] * b[3] + a[5] * b[6], a[3] * b[1] + a[4] * b[4] + a[5] * b[7],
             a[3] * b[2] + a[4] * b[5] + a[5] * b[8],  //
             a[6] * b[0] + a[7] * b[3] + a[8] * b[6], a[6] * b[1] + a[7] * b[4] + a[8] * b[7],
             a[6] * b[2] + a[7] * b[5] + a[8] * b[8]}};
  }
  friend constexpr bool operator==(const Rotation& A, const Rotation& B) = default;

  template <class To>
  constexpr Rotation<To> cast() const {
    Rotation<To> R;
    for (int i = 0; i < 9; ++i) R.m[i] = static_cast<To>(m[i]);
    return R;
  }
  constexpr Rotation transposed() const { return {{m[0], m[3], m[6], m[1], m[4], m[7], m[2], m[5], m[8]}}; }
  constexpr Vector3<Real> column(int j) const { return {m[j], m[3 + j], m[6 + j]}; }

  static constexpr Rotation from_columns(Vector3<Real> x, Vector3<Real> y, Vector3<Real> z) {
    return {{x.x, y.x, z.x, x.y, y.y, z.y, x.z, y.z, z.z}};
  }

  /// Rodrigues' formula from the cosine and sine of the angle about the unit vector `a`.
  static constexpr Rotation about(Vector3<Real> a, Real c, Real s) {
    const Real v = Real(1) - c;
    return {{a.x * a.x * v + c, a.x * a.y * v - a.z * s, a.x * a.z * v + a.y * s,  //
             a.y * a.x * v + a.z * s, a.y * a.y * v + c, a.y * a.z * v - a.x * s,  //
             a.z * a.x * v - a.y * s, a.z * a.y * v + a.x * s, a.z * a.z * v + c}};
  }
  static Rotation about(Vector3<Real> a, Real angle) { return about(a, std::cos(angle), std::sin(angle)); }
};

using Vector3d = Vector3<double>;
using Rotationd = Rotation<double>;

}  // namespace uhas
