// SPDX-License-Identifier: Apache-2.0
#include "optimizer/design/segment_distance.hpp"

#include <cmath>

namespace legwright {
namespace {

using Eigen::Vector3d;

constexpr double kClamp = 0.05;      // half width of a rounded clamp edge, share of the length
constexpr double kParallel = 0.03;   // sin² below which 1/sin² is continued
constexpr double kNoLength = 1e-20;  // squared length of a point [m²]

/// A number with its first derivatives in the six products of the segments' vectors, and its second
/// ones if kSecond.
template <bool kSecond>
struct ProductJet {
  using Gradient = Eigen::Matrix<double, 6, 1>;
  using Hessian = Eigen::Matrix<double, kSecond ? 6 : 0, kSecond ? 6 : 0>;

  double v;
  Gradient g = Gradient::Zero();
  Hessian h = Hessian::Zero();

  ProductJet(double value) : v(value) {}
  ProductJet(double value, int variable) : v(value) { g[variable] = 1.0; }

  /// f(this), given f, f′ and f″ there.
  ProductJet through(double f, double f1, double f2) const {
    ProductJet out(f);
    out.g = f1 * g;
    if constexpr (kSecond) out.h = f1 * h + f2 * g * g.transpose();
    return out;
  }
};

template <bool kSecond>
ProductJet<kSecond> operator+(const ProductJet<kSecond>& a, const ProductJet<kSecond>& b) {
  ProductJet<kSecond> out(a.v + b.v);
  out.g = a.g + b.g;
  if constexpr (kSecond) out.h = a.h + b.h;
  return out;
}
template <bool kSecond>
ProductJet<kSecond> operator*(const ProductJet<kSecond>& a, const ProductJet<kSecond>& b) {
  ProductJet<kSecond> out(a.v * b.v);
  out.g = a.v * b.g + b.v * a.g;
  if constexpr (kSecond) {
    const typename ProductJet<kSecond>::Hessian mixed = a.g * b.g.transpose();
    out.h = a.v * b.h + b.v * a.h + mixed + mixed.transpose();
  }
  return out;
}
template <bool kSecond>
ProductJet<kSecond> operator-(const ProductJet<kSecond>& a, const ProductJet<kSecond>& b) {
  return a + ProductJet<kSecond>(-1.0) * b;
}
template <bool kSecond>
ProductJet<kSecond> inverse(const ProductJet<kSecond>& a) {
  const double i = 1.0 / a.v;
  return a.through(i, -i * i, 2.0 * i * i * i);
}

// The same in plain numbers, where no derivatives are wanted.
double inverse(double a) { return 1.0 / a; }
double through(double, double f, double, double) { return f; }
template <bool kSecond>
ProductJet<kSecond> through(const ProductJet<kSecond>& x, double f, double f1, double f2) {
  return x.through(f, f1, f2);
}
double value_of(double x) { return x; }
template <bool kSecond>
double value_of(const ProductJet<kSecond>& x) {
  return x.v;
}

/// max(0, x), rounded between −kClamp and kClamp.
template <class Number>
Number ramp(const Number& x) {
  const double z = value_of(x) / kClamp;
  if (z <= -1.0) return Number(0.0);
  if (z >= 1.0) return x;
  return through(x, kClamp * (3.0 / 16 + z * (0.5 + z * (6.0 / 16 - z * z / 16))),
                 0.5 + z * (0.75 - 0.25 * z * z), 0.75 * (1.0 - z * z) / kClamp);
}

template <class Number>
Number clamp(const Number& x) {
  return ramp(x) - ramp(x - Number(1.0));
}

/// 1/x, continued below kParallel.
template <class Number>
Number finite_inverse(const Number& x) {
  if (value_of(x) >= kParallel) return inverse(x);
  const double i = 1.0 / kParallel, y = value_of(x) * i - 1.0;
  return through(x, i * (1.0 - y + y * y), i * i * (2.0 * y - 1.0), 2.0 * i * i * i);
}

/// The distance as a function of a = u·u, b = u·v, c = v·v, d = u·w, e = v·w, f = w·w,
/// u = q₁ − p₁, v = q₂ − p₂, w = p₁ − p₂.
template <class Number>
Number distance(const Number& a, const Number& b, const Number& c, const Number& d, const Number& e,
                const Number& f, double rounding) {
  const Number two(2.0), half(0.5), none(0.0);
  const bool first_point = value_of(a) < kNoLength, second_point = value_of(c) < kNoLength;
  Number s = none, t = none;
  if (first_point && !second_point) {
    t = clamp(Number(e * inverse(c)));
  } else if (!first_point && second_point) {
    s = clamp(Number(none - d * inverse(a)));
  } else if (!first_point) {
    const Number per_square = inverse(Number(a * c));
    const Number sine_squared = Number(1.0) - b * b * per_square;
    s = clamp(Number(half + ((b * e - c * d) * per_square - half * sine_squared) *
                                finite_inverse(sine_squared)));
    t = clamp(Number((b * s + e) * inverse(c)));
    s = clamp(Number((b * t - d) * inverse(a)));
  }
  const Number squared = a * s * s + c * t * t - two * b * s * t + two * d * s - two * e * t + f;
  const double square = value_of(squared), edge = rounding * rounding;
  if (square >= edge) {
    const double root = std::sqrt(square);
    return through(squared, root, 0.5 / root, -0.25 / (root * square));
  }
  const double y = square / edge - 1.0;
  return through(squared, rounding * (1.0 + y * (0.5 - 0.125 * y)),
                 rounding / edge * (0.5 - 0.25 * y), -0.25 * rounding / (edge * edge));
}

using Products = Eigen::Matrix<double, 6, 1>;

template <bool kSecond>
ProductJet<kSecond> distance_of(const Products& p, double rounding) {
  using J = ProductJet<kSecond>;
  return distance(J(p[0], 0), J(p[1], 1), J(p[2], 2), J(p[3], 3), J(p[4], 4), J(p[5], 5), rounding);
}

}  // namespace

SegmentDistance segment_distance(const Vector3d& p1, const Vector3d& q1, const Vector3d& p2,
                                 const Vector3d& q2, double rounding, DistanceDetail detail) {
  const Vector3d u = q1 - p1, v = q2 - p2, w = p1 - p2;
  Products products;
  products << u.dot(u), u.dot(v), v.dot(v), u.dot(w), v.dot(w), w.dot(w);
  SegmentDistance out;
  if (detail == DistanceDetail::value) {
    out.value = distance(products[0], products[1], products[2], products[3], products[4],
                         products[5], rounding);
    return out;
  }
  // Chain rule: products → (u, v, w) → ends.
  Eigen::Matrix<double, 9, 6> slopes;
  slopes << 2 * u, v, Vector3d::Zero(), w, Vector3d::Zero(), Vector3d::Zero(),  //
      Vector3d::Zero(), u, 2 * v, Vector3d::Zero(), w, Vector3d::Zero(),        //
      Vector3d::Zero(), Vector3d::Zero(), Vector3d::Zero(), u, v, 2 * w;
  // u = q₁ − p₁, v = q₂ − p₂, w = p₁ − p₂.
  const auto to_ends = [](const auto& of_u, const auto& of_v, const auto& of_w, auto&& put) {
    put(0, of_w - of_u);
    put(3, of_u);
    put(6, -of_v - of_w);
    put(9, of_v);
  };
  const auto set_gradient = [&](const Products& g) {
    const Eigen::Matrix<double, 9, 1> along = slopes * g;
    to_ends(along.segment<3>(0), along.segment<3>(3), along.segment<3>(6),
            [&](int row, const auto& part) { out.gradient.segment<3>(row) = part; });
  };
  if (detail == DistanceDetail::gradient) {
    const ProductJet<false> at = distance_of<false>(products, rounding);
    out.value = at.v;
    set_gradient(at.g);
    return out;
  }
  const ProductJet<true> at = distance_of<true>(products, rounding);
  out.value = at.v;
  set_gradient(at.g);
  Eigen::Matrix3d second;  // ∂²products, weighted; times the identity of the coordinates
  second << 2 * at.g[0], at.g[1], at.g[3], at.g[1], 2 * at.g[2], at.g[4], at.g[3], at.g[4],
      2 * at.g[5];
  Eigen::Matrix<double, 9, 9> hessian = slopes * at.h * slopes.transpose();
  for (int k = 0; k < 3; ++k)
    for (int l = 0; l < 3; ++l)
      for (int x = 0; x < 3; ++x) hessian(3 * k + x, 3 * l + x) += second(k, l);
  Eigen::Matrix<double, 12, 9> half;
  to_ends(hessian.middleRows<3>(0), hessian.middleRows<3>(3), hessian.middleRows<3>(6),
          [&](int row, const auto& part) { half.middleRows<3>(row) = part; });
  to_ends(half.middleCols<3>(0), half.middleCols<3>(3), half.middleCols<3>(6),
          [&](int column, const auto& part) { out.hessian.middleCols<3>(column) = part; });
  return out;
}

}  // namespace legwright
