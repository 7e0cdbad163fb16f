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

using Products = Eigen::Matrix<double, 6, 1>;
using Curvature = Eigen::Matrix<double, 6, 6>;

/// Value and first two derivatives of a function of one number.
struct Bend {
  double f, f1, f2;
};

/// max(0, x), rounded between −kClamp and kClamp.
Bend ramp(double x) {
  const double z = x / kClamp;
  if (z <= -1.0) return {0.0, 0.0, 0.0};
  if (z >= 1.0) return {x, 1.0, 0.0};
  return {kClamp * (3.0 / 16 + z * (0.5 + z * (6.0 / 16 - z * z / 16))),
          0.5 + z * (0.75 - 0.25 * z * z), 0.75 * (1.0 - z * z) / kClamp};
}

/// x between zero and one, rounded at both.
Bend clamp(double x) {
  const Bend low = ramp(x), high = ramp(x - 1.0);
  return {low.f - high.f, low.f1 - high.f1, low.f2 - high.f2};
}

/// 1/x, continued below kParallel.
Bend finite_inverse(double x) {
  if (x >= kParallel) {
    const double i = 1.0 / x;
    return {i, -i * i, 2.0 * i * i * i};
  }
  const double i = 1.0 / kParallel, y = x * i - 1.0;
  return {i * (1.0 - y + y * y), i * i * (2.0 * y - 1.0), 2.0 * i * i * i};
}

/// √x, continued below the square of `rounding`.
Bend rounded_root(double x, double rounding) {
  const double edge = rounding * rounding;
  if (x >= edge) {
    const double root = std::sqrt(x);
    return {root, 0.5 / root, -0.25 / (root * x)};
  }
  const double y = x / edge - 1.0;
  return {rounding * (1.0 + y * (0.5 - 0.125 * y)), rounding / edge * (0.5 - 0.25 * y),
          -0.25 * rounding / (edge * edge)};
}

/// Adds weight (x yᵀ + y xᵀ).
void add_mixed(double weight, const Products& x, const Products& y, Curvature& out) {
  const Products wx = weight * x, wy = weight * y;
  for (int k = 0; k < 6; ++k) out.col(k) += wx * y[k] + wy * x[k];
}
/// The same where y is the k-th unit vector.
void add_mixed(double weight, const Products& x, int k, Curvature& out) {
  out.col(k) += weight * x;
  out.row(k) += weight * x.transpose();
}
void add_square(double weight, const Products& x, Curvature& out) {
  const Products wx = weight * x;
  for (int k = 0; k < 6; ++k) out.col(k) += wx * x[k];
}
/// The same for the k-th and l-th unit vectors, k ≠ l.
void add_entry(double weight, int k, int l, Curvature& out) {
  out(k, l) += weight;
  out(l, k) += weight;
}

/// The distance as a function of the products a = u·u, b = u·v, c = v·v, d = u·w, e = v·w, f = w·w
/// of u = q₁ − p₁, v = q₂ − p₂, w = p₁ − p₂, one stage after the other: where the lines are nearest
/// (x = ½ + h/S, clamped to `start`), t there (τ = (b start + e)/c, clamped), s there (σ = (b t −
/// d)/a, clamped), the squared distance, its root. Derivatives go back through the stages, so that
/// what a clamp holds fast costs nothing.
class Nearest {
 public:
  Nearest(const Products& products, double rounding) : p_(products) {
    has_s_ = p_[kA] >= kNoLength;
    has_t_ = p_[kC] >= kNoLength;
    if (has_s_ && has_t_) {
      area_ = p_[kA] * p_[kC];
      sine_squared_ = 1.0 - p_[kB] * p_[kB] / area_;
      half_ = (p_[kB] * p_[kE] - p_[kC] * p_[kD]) / area_ - 0.5 * sine_squared_;
      inverse_ = finite_inverse(sine_squared_);
      start_ = clamp(0.5 + half_ * inverse_.f);
    }
    if (has_t_) t_ = clamp(tau_ = (p_[kB] * start_.f + p_[kE]) / p_[kC]);
    if (has_s_) s_ = clamp(sigma_ = (p_[kB] * t_.f - p_[kD]) / p_[kA]);
    const double s = s_.f, t = t_.f;
    by_s_ = 2.0 * (p_[kA] * s - p_[kB] * t + p_[kD]);
    by_t_ = 2.0 * (p_[kC] * t - p_[kB] * s - p_[kE]);
    root_ = rounded_root(p_[kA] * s * s + p_[kC] * t * t - 2.0 * p_[kB] * s * t + 2.0 * p_[kD] * s -
                             2.0 * p_[kE] * t + p_[kF],
                         rounding);
  }
  double value() const { return root_.f; }

  Products gradient() {
    slope_of_start();
    if (t_.f1 != 0.0 || t_.f2 != 0.0) {
      tau_slope_ = p_[kB] * start_slope_;
      tau_slope_[kB] += start_.f;
      tau_slope_[kC] -= tau_;
      tau_slope_[kE] += 1.0;
      tau_slope_ /= p_[kC];
      t_slope_ = t_.f1 * tau_slope_;
    }
    if (s_.f1 != 0.0 || s_.f2 != 0.0) {
      sigma_slope_ = p_[kB] * t_slope_;
      sigma_slope_[kA] -= sigma_;
      sigma_slope_[kB] += t_.f;
      sigma_slope_[kD] -= 1.0;
      sigma_slope_ /= p_[kA];
      s_slope_ = s_.f1 * sigma_slope_;
    }
    const double s = s_.f, t = t_.f;
    squared_slope_ << s * s, -2.0 * s * t, t * t, 2.0 * s, -2.0 * t, 1.0;
    squared_slope_ += by_s_ * s_slope_ + by_t_ * t_slope_;
    return root_.f1 * squared_slope_;
  }

  /// After gradient().
  Curvature curvature() const {
    Curvature out = Curvature::Zero();
    add_square(root_.f2, squared_slope_, out);
    const double by_s = root_.f1 * by_s_, by_t = root_.f1 * by_t_;
    if (s_.f1 != 0.0) {
      Products beside = p_[kA] * s_slope_ - 2.0 * p_[kB] * t_slope_;
      beside[kA] += 2.0 * s_.f;
      beside[kB] -= 2.0 * t_.f;
      beside[kD] += 2.0;
      add_mixed(root_.f1, beside, s_slope_, out);
    }
    if (t_.f1 != 0.0) {
      Products beside = p_[kC] * t_slope_;
      beside[kB] -= 2.0 * s_.f;
      beside[kC] += 2.0 * t_.f;
      beside[kE] -= 2.0;
      add_mixed(root_.f1, beside, t_slope_, out);
    }
    // Of s: a ∇²σ = ∇t e_bᵀ + e_b ∇tᵀ − ∇σ e_aᵀ − e_a ∇σᵀ + b ∇²t; of t likewise.
    const double of_sigma = by_s * s_.f1 / (has_s_ ? p_[kA] : 1.0);
    if (s_.f2 != 0.0) add_square(by_s * s_.f2, sigma_slope_, out);
    if (of_sigma != 0.0) {
      add_mixed(-of_sigma, sigma_slope_, kA, out);
      add_mixed(of_sigma, t_slope_, kB, out);
    }
    const double of_t = by_t + of_sigma * p_[kB];
    const double of_tau = of_t * t_.f1 / (has_t_ ? p_[kC] : 1.0);
    if (t_.f2 != 0.0) add_square(of_t * t_.f2, tau_slope_, out);
    if (of_tau != 0.0) {
      add_mixed(-of_tau, tau_slope_, kC, out);
      add_mixed(of_tau, start_slope_, kB, out);
    }
    add_start(of_tau * p_[kB], out);
    return out;
  }

 private:
  enum { kA, kB, kC, kD, kE, kF };

  // p = a c, S = (p − b²)/p, h = (b e − c d − (p − b²)/2)/p, x = ½ + h/S.
  void slope_of_start() {
    if (start_.f1 == 0.0 && start_.f2 == 0.0) return;
    area_slope_[kA] = p_[kC];
    area_slope_[kC] = p_[kA];
    sine_slope_ = (1.0 - sine_squared_) * area_slope_;
    sine_slope_[kB] -= 2.0 * p_[kB];
    sine_slope_ /= area_;
    half_slope_ = (-half_ - 0.5) * area_slope_;
    half_slope_[kB] += p_[kE] + p_[kB];
    half_slope_[kC] -= p_[kD];
    half_slope_[kD] -= p_[kC];
    half_slope_[kE] += p_[kB];
    half_slope_ /= area_;
    x_slope_ = inverse_.f * half_slope_ + half_ * inverse_.f1 * sine_slope_;
    start_slope_ = start_.f1 * x_slope_;
  }

  /// Adds weight · ∇²start.
  void add_start(double weight, Curvature& out) const {
    if (weight == 0.0) return;
    if (start_.f2 != 0.0) add_square(weight * start_.f2, x_slope_, out);
    const double of_x = weight * start_.f1;
    if (of_x == 0.0) return;
    add_mixed(of_x * inverse_.f1, half_slope_, sine_slope_, out);
    add_square(of_x * half_ * inverse_.f2, sine_slope_, out);
    // p ∇²h = ∇²(b e − c d − (p − b²)/2) − h ∇²p − ∇h ∇pᵀ − ∇p ∇hᵀ
    const double of_h = of_x * inverse_.f / area_;
    add_entry(of_h, kB, kE, out);
    add_entry(-of_h, kC, kD, out);
    add_entry(of_h * (-0.5 - half_), kA, kC, out);
    out(kB, kB) += of_h;
    // p ∇²S = ∇²(p − b²) − S ∇²p − ∇S ∇pᵀ − ∇p ∇Sᵀ
    const double of_sine = of_x * half_ * inverse_.f1 / area_;
    add_entry(of_sine * (1.0 - sine_squared_), kA, kC, out);
    out(kB, kB) -= 2.0 * of_sine;
    add_mixed(-1.0, of_h * half_slope_ + of_sine * sine_slope_, area_slope_, out);
  }

  const Products& p_;
  bool has_s_, has_t_;
  double area_ = 1.0, sine_squared_ = 0.0, half_ = 0.0, tau_ = 0.0, sigma_ = 0.0, by_s_, by_t_;
  Bend inverse_{}, start_{}, t_{}, s_{}, root_;
  Products area_slope_ = Products::Zero(), sine_slope_ = Products::Zero(),
           half_slope_ = Products::Zero(), x_slope_ = Products::Zero(),
           start_slope_ = Products::Zero(), tau_slope_ = Products::Zero(),
           t_slope_ = Products::Zero(), sigma_slope_ = Products::Zero(),
           s_slope_ = Products::Zero(), squared_slope_;
};

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
void set_hessian(const std::array<Part, 3>& parts, const Products& g, const Curvature& h,
                 SegmentDistance& out) {
  Eigen::Matrix3d second;  // ∂²products, weighted; times the identity of the coordinates
  second << 2 * g[0], g[1], g[3], g[1], 2 * g[2], g[4], g[3], g[4], 2 * g[5];
  std::array<std::array<Eigen::Matrix3d, 3>, 3> blocks;
  for (std::size_t x = 0; x < 3; ++x)
    for (std::size_t y = 0; y <= x; ++y) {
      Eigen::Matrix3d& block = blocks[x][y];
      block = second(static_cast<int>(x), static_cast<int>(y)) * Eigen::Matrix3d::Identity();
      for (std::size_t k = 0; k < 3; ++k) {
        Vector3d bent = Vector3d::Zero();
        for (std::size_t l = 0; l < 3; ++l)
          bent += h(parts[x].product[k], parts[y].product[l]) * parts[y].slope[l];
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
  Nearest nearest(products, rounding);
  out.value = nearest.value();
  if (detail == DistanceDetail::value) return out;
  const std::array<Part, 3> parts = parts_of(u, v, w);
  const Products slope = nearest.gradient();
  set_gradient(parts, slope, out);
  if (detail == DistanceDetail::hessian) set_hessian(parts, slope, nearest.curvature(), out);
  return out;
}

}  // namespace legwright
