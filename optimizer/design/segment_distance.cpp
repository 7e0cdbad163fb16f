// SPDX-License-Identifier: Apache-2.0
#include "optimizer/design/segment_distance.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace legwright {
namespace {

using Eigen::Vector3d;

constexpr double kClamp = 0.05;      // half width of a rounded clamp edge, share of the length
constexpr double kParallel = 0.03;   // sin² below which 1/sin² is continued
constexpr double kNoLength = 1e-20;  // squared length of a point [m²]

/// A number with its first derivatives in the six products of the segments' vectors, and the lower
/// triangle of its second ones, column by column, if kSecond.
template <bool kSecond>
struct ProductJet {
  static constexpr int kSize = 6;
  using Gradient = Eigen::Matrix<double, kSize, 1>;
  using Hessian = Eigen::Matrix<double, kSecond ? kSize*(kSize + 1) / 2 : 0, 1>;

  double v;
  Gradient g = Gradient::Zero();
  Hessian h = Hessian::Zero();

  ProductJet(double value) : v(value) {}
  ProductJet(double value, int variable) : v(value) { g[variable] = 1.0; }

  double second(int i, int j) const {
    const int row = std::max(i, j), column = std::min(i, j);
    return h[column * (2 * kSize - 1 - column) / 2 + row];
  }
  /// f(this), given f, f′ and f″ there.
  ProductJet through(double f, double f1, double f2) const {
    ProductJet out(f);
    out.g = f1 * g;
    if constexpr (kSecond) {
      for (int j = 0, k = 0; j < kSize; ++j)
        for (int i = j; i < kSize; ++i, ++k) out.h[k] = f1 * h[k] + f2 * g[i] * g[j];
    }
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
ProductJet<kSecond> operator-(const ProductJet<kSecond>& a, const ProductJet<kSecond>& b) {
  ProductJet<kSecond> out(a.v - b.v);
  out.g = a.g - b.g;
  if constexpr (kSecond) out.h = a.h - b.h;
  return out;
}
template <bool kSecond>
ProductJet<kSecond> operator*(double a, const ProductJet<kSecond>& b) {
  ProductJet<kSecond> out(a * b.v);
  out.g = a * b.g;
  if constexpr (kSecond) out.h = a * b.h;
  return out;
}
template <bool kSecond>
ProductJet<kSecond> operator*(const ProductJet<kSecond>& a, const ProductJet<kSecond>& b) {
  constexpr int kSize = ProductJet<kSecond>::kSize;
  ProductJet<kSecond> out(a.v * b.v);
  out.g = a.v * b.g + b.v * a.g;
  if constexpr (kSecond) {
    for (int j = 0, k = 0; j < kSize; ++j)
      for (int i = j; i < kSize; ++i, ++k)
        out.h[k] = a.v * b.h[k] + b.v * a.h[k] + a.g[i] * b.g[j] + a.g[j] * b.g[i];
  }
  return out;
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
  const Number half(0.5), none(0.0);
  const bool first_point = value_of(a) < kNoLength, second_point = value_of(c) < kNoLength;
  Number s = none, t = none;
  if (first_point && !second_point) {
    t = clamp(Number(e * inverse(c)));
  } else if (!first_point && second_point) {
    s = clamp(Number(-1.0 * (d * inverse(a))));
  } else if (!first_point) {
    const Number per_square = inverse(Number(a * c));
    const Number sine_squared = Number(1.0) - b * b * per_square;
    s = clamp(Number(half + ((b * e - c * d) * per_square - 0.5 * sine_squared) *
                                finite_inverse(sine_squared)));
    t = clamp(Number((b * s + e) * inverse(c)));
    s = clamp(Number((b * t - d) * inverse(a)));
  }
  const Number squared = a * s * s + c * t * t - 2.0 * b * s * t + 2.0 * d * s - 2.0 * e * t + f;
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

/// What one of the vectors u, v, w moves: three of the six products, each with its slope.
struct Part {
  std::array<int, 3> product;
  std::array<Vector3d, 3> slope;
};

std::array<Part, 3> parts_of(const Vector3d& u, const Vector3d& v, const Vector3d& w) {
  return {Part{{0, 1, 3}, {2 * u, v, w}}, Part{{1, 2, 4}, {u, 2 * v, w}},
          Part{{3, 4, 5}, {u, v, 2 * w}}};
}

/// Hands what belongs to u = q₁ − p₁, v = q₂ − p₂, w = p₁ − p₂ on to the four ends.
template <class Put>
void to_ends(const Eigen::Matrix3d& of_u, const Eigen::Matrix3d& of_v, const Eigen::Matrix3d& of_w,
             Put put) {
  put(0, of_w - of_u);
  put(3, of_u);
  put(6, -of_v - of_w);
  put(9, of_v);
}

void set_gradient(const std::array<Part, 3>& parts, const Products& g, SegmentDistance& out) {
  std::array<Vector3d, 3> along;
  for (std::size_t x = 0; x < 3; ++x) {
    const Part& part = parts[x];
    along[x] = g[part.product[0]] * part.slope[0] + g[part.product[1]] * part.slope[1] +
               g[part.product[2]] * part.slope[2];
  }
  out.gradient << along[2] - along[0], along[0], -along[1] - along[2], along[1];
}

/// Chain rule: products → (u, v, w) → ends.
void set_hessian(const std::array<Part, 3>& parts, const ProductJet<true>& at,
                 SegmentDistance& out) {
  Eigen::Matrix3d second;  // ∂²products, weighted; times the identity of the coordinates
  second << 2 * at.g[0], at.g[1], at.g[3], at.g[1], 2 * at.g[2], at.g[4], at.g[3], at.g[4],
      2 * at.g[5];
  std::array<std::array<Eigen::Matrix3d, 3>, 3> blocks;
  for (std::size_t x = 0; x < 3; ++x)
    for (std::size_t y = 0; y <= x; ++y) {
      Eigen::Matrix3d& block = blocks[x][y];
      block = second(static_cast<int>(x), static_cast<int>(y)) * Eigen::Matrix3d::Identity();
      for (std::size_t k = 0; k < 3; ++k) {
        Vector3d bent = Vector3d::Zero();
        for (std::size_t l = 0; l < 3; ++l)
          bent += at.second(parts[x].product[k], parts[y].product[l]) * parts[y].slope[l];
        block += parts[x].slope[k] * bent.transpose();
      }
      if (x != y) blocks[y][x] = block.transpose();
    }
  std::array<std::array<Eigen::Matrix3d, 4>, 3> half;  // (u, v, w) × ends
  for (std::size_t x = 0; x < 3; ++x)
    to_ends(blocks[x][0], blocks[x][1], blocks[x][2],
            [&](int end, const Eigen::Matrix3d& block) { half[x][end / 3] = block; });
  for (std::size_t end = 0; end < 4; ++end)
    to_ends(half[0][end], half[1][end], half[2][end], [&](int row, const Eigen::Matrix3d& block) {
      out.hessian.block<3, 3>(row, 3 * static_cast<Eigen::Index>(end)) = block;
    });
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
  const std::array<Part, 3> parts = parts_of(u, v, w);
  if (detail == DistanceDetail::gradient) {
    const ProductJet<false> at = distance_of<false>(products, rounding);
    out.value = at.v;
    set_gradient(parts, at.g, out);
    return out;
  }
  const ProductJet<true> at = distance_of<true>(products, rounding);
  out.value = at.v;
  set_gradient(parts, at.g, out);
  set_hessian(parts, at, out);
  return out;
}

}  // namespace legwright
