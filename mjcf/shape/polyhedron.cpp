// SPDX-License-Identifier: Apache-2.0
#include "mjcf/shape/polyhedron.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace legwright {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kParallelMoves = 1e-9;  // sine

/// ∫ z zᵀ over a tetrahedron of volume one, of what is affine in place: of its corners and their
/// mean.
template <class Vector>
auto mean_square(const std::array<Vector, 4>& corners) {
  const Vector sum = corners[0] + corners[1] + corners[2] + corners[3];
  auto out = (sum * sum.transpose()).eval();
  for (const Vector& corner : corners) out += corner * corner.transpose();
  return (out / 20.0).eval();
}

double volume_within(const std::array<Vector3d, 4>& corners) {
  return (corners[1] - corners[0]).cross(corners[2] - corners[0]).dot(corners[3] - corners[0]) /
         6.0;
}

/// Points that move along a fixed direction with each parameter: p + Σ tₖ θₖ dₖ at s = t s₀.
class MovingPoints {
 public:
  MovingPoints(const std::vector<AffineVector>& points, const VectorXd& initial) {
    for (const AffineVector& point : points)
      for (const AffineVector::Slope& slope : point.slopes) note(slope);
    for (const AffineVector& point : points) {
      VectorXd place = VectorXd::Zero(3 + static_cast<Eigen::Index>(parameters_.size()));
      place.head<3>() = point.constant;
      for (const AffineVector::Slope& slope : point.slopes) {
        if (slope.slope.isZero(0.0)) continue;  // of a parameter that may move no corner
        const std::size_t k = index_of(slope.parameter);
        const double along = slope.slope.dot(directions_[k]);
        if ((slope.slope - along * directions_[k]).norm() > kParallelMoves * slope.slope.norm())
          throw std::logic_error("one parameter moves the corners of a solid along two directions");
        place[3 + static_cast<Eigen::Index>(k)] = along * initial[slope.parameter];
      }
      places_.push_back(std::move(place));
    }
  }

  const std::vector<int>& parameters() const { return parameters_; }
  const VectorXd& place(int point) const { return places_[static_cast<std::size_t>(point)]; }

  /// @param moved bit k: tₖ is one, else zero
  Vector3d at(int point, unsigned moved) const {
    const VectorXd& place = places_[static_cast<std::size_t>(point)];
    Vector3d out = place.head<3>();
    for (std::size_t k = 0; k < parameters_.size(); ++k)
      if (moved >> k & 1U) out += place[3 + static_cast<Eigen::Index>(k)] * directions_[k];
    return out;
  }

  /// The affine vector of a place among those of the points.
  AffineVector vector(const VectorXd& place, const VectorXd& initial) const {
    AffineVector out{place.head<3>(), {}};
    for (std::size_t k = 0; k < parameters_.size(); ++k) {
      const double along = place[3 + static_cast<Eigen::Index>(k)] / initial[parameters_[k]];
      if (along != 0.0) out.slopes.push_back({parameters_[k], along * directions_[k]});
    }
    return out;
  }

 private:
  void note(const AffineVector::Slope& slope) {
    if (slope.slope.isZero(0.0)) return;
    if (std::find(parameters_.begin(), parameters_.end(), slope.parameter) != parameters_.end())
      return;
    parameters_.push_back(slope.parameter);
    directions_.push_back(slope.slope.normalized());
  }

  std::size_t index_of(int parameter) const {
    return static_cast<std::size_t>(std::find(parameters_.begin(), parameters_.end(), parameter) -
                                    parameters_.begin());
  }

  std::vector<int> parameters_;
  std::vector<Vector3d> directions_;  // of each of them, unit vectors
  std::vector<VectorXd> places_;      // p and θ [m]
};

/// Volume of a tetrahedron as Σ over sets of parameters of a coefficient times Π tₖ: it is affine
/// in each tₖ, as all that tₖ moves goes along one direction.
std::vector<double> volume_terms(const MovingPoints& points, const std::array<int, 4>& corners) {
  std::vector<double> terms(std::size_t{1} << points.parameters().size());
  for (unsigned moved = 0; moved < terms.size(); ++moved)
    terms[moved] = volume_within({points.at(corners[0], moved), points.at(corners[1], moved),
                                  points.at(corners[2], moved), points.at(corners[3], moved)});
  for (unsigned bit = 1; bit < terms.size(); bit <<= 1U)
    for (unsigned set = 0; set < terms.size(); ++set)
      if (set & bit) terms[set] -= terms[set ^ bit];
  return terms;
}

/// Masses at places whose Σ m ẑ ẑᵀ with ẑ = (z, 1) is what is wanted: one in the middle and pairs
/// about it along the principal axes.
std::vector<std::pair<double, VectorXd>> points_with(const MatrixXd& moments,
                                                     const VectorXd& middle, double arm) {
  const Eigen::Index n = middle.size();
  const double mass = moments(n, n);
  const VectorXd first = moments.topRightCorner(n, 1) - mass * middle;
  MatrixXd second = moments.topLeftCorner(n, n);
  second -= middle * moments.topRightCorner(n, 1).transpose();
  second -= moments.topRightCorner(n, 1) * middle.transpose();
  second += mass * middle * middle.transpose();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> principal(second);
  std::vector<std::pair<double, VectorXd>> out{{mass, middle}};
  for (Eigen::Index k = 0; k < n; ++k) {
    const VectorXd axis = principal.eigenvectors().col(k);
    const double both = principal.eigenvalues()[k] / (arm * arm), apart = axis.dot(first) / arm;
    out.front().first -= both;
    for (const double sign : {1.0, -1.0})
      out.emplace_back((both + sign * apart) / 2.0, middle + sign * arm * axis);
  }
  return out;
}

}  // namespace

SolidMoments moments_of_solid(const std::vector<Facet>& facets,
                              const std::vector<Vector3d>& points) {
  SolidMoments out;
  if (facets.empty()) return out;
  const Vector3d& base = points[static_cast<std::size_t>(facets.front()[0])];
  Vector3d first = Vector3d::Zero();
  Matrix3d second = Matrix3d::Zero();
  for (const Facet& facet : facets) {
    std::array<Vector3d, 4> corners{Vector3d::Zero()};
    for (std::size_t k = 0; k < 3; ++k)
      corners[k + 1] = points[static_cast<std::size_t>(facet[k])] - base;
    const double volume = volume_within(corners);
    out.volume += volume;
    first += volume / 4.0 * (corners[1] + corners[2] + corners[3]);
    second += volume * mean_square(corners);
  }
  const Vector3d centre = first / out.volume;
  out.centre = base + centre;
  out.second = second - out.volume * centre * centre.transpose();
  return out;
}

std::vector<PointMass> masses_of_solid(const std::vector<Facet>& facets,
                                       const std::vector<AffineVector>& points, double density,
                                       const VectorXd& initial) {
  const MovingPoints moving(points, initial);
  const std::vector<int>& parameters = moving.parameters();
  const Eigen::Index n = 3 + static_cast<Eigen::Index>(parameters.size());
  std::vector<MatrixXd> moments(std::size_t{1} << parameters.size(), MatrixXd::Zero(n + 1, n + 1));
  VectorXd middle = VectorXd::Zero(n);
  const std::vector<int> corners = corners_of(facets);
  for (const int corner : corners)
    middle += moving.place(corner) / static_cast<double>(corners.size());
  double arm = 0.0;  // [m], about as long as the solid
  for (const int corner : corners) arm = std::max(arm, (moving.place(corner) - middle).norm());
  for (const Facet& facet : facets) {
    const std::array<int, 4> of{corners.front(), facet[0], facet[1], facet[2]};
    std::array<VectorXd, 4> places;
    for (std::size_t k = 0; k < 4; ++k) {
      places[k] = VectorXd::Ones(n + 1);
      places[k].head(n) = moving.place(of[k]) - middle;
    }
    const MatrixXd square = mean_square(places);
    const std::vector<double> terms = volume_terms(moving, of);
    for (std::size_t set = 0; set < terms.size(); ++set) moments[set] += terms[set] * square;
  }
  std::vector<PointMass> out;
  for (std::size_t set = 0; set < moments.size(); ++set) {
    std::vector<PointMass::Growth> growth;
    for (std::size_t k = 0; k < parameters.size(); ++k)
      if (set >> k & 1U) growth.push_back({parameters[k], initial[parameters[k]]});
    for (const auto& [volume, place] : points_with(moments[set], VectorXd::Zero(n), arm))
      out.push_back({density * volume, moving.vector(middle + place, initial), growth, volume});
  }
  return out;
}

}  // namespace legwright
