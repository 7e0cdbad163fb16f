// SPDX-License-Identifier: Apache-2.0
// What hulls weigh at each design, with derivatives, also where triangles change.
#include "optimizer/design/hull_moments.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "optimizer/design/growth.hpp"
#include "optimizer/design/inertia.hpp"
#include "optimizer/design/polyhedron.hpp"

namespace legwright {
namespace {

using Eigen::Matrix4d;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Two clouds of points: one that turns by parameter 2, and one that goes along with 0 and turns
/// by 1 and 3.
HullPart moving_hull(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-0.02, 0.02);
  HullPart out{1240.0, {}, {}};
  out.ends.push_back({{}, {{2, Vector3d(1, 2, -2) / 3.0, -0.5}}, {}});
  const Vector3d along = Vector3d(2, 1, 2) / 3.0;
  out.ends.push_back({{Vector3d(0.01, 0.0, 0.0), {{0, along}}},
                      {{3, Vector3d::UnitZ()}, {1, Vector3d::UnitX()}},
                      {}});
  for (HullPart::End& end : out.ends)
    for (int k = 0; k < 12; ++k) {
      const double x = number(random), y = number(random), z = number(random);
      end.points.emplace_back(x, y, z);
    }
  return out;
}

HullPart with_facets_at(HullPart hull, const VectorXd& s) {
  hull.facets = convex_hull(hull_points(hull, s));
  hull.mass = hull.density * moments_of_solid(hull.facets, hull_points(hull, s)).volume;
  return hull;
}

VectorXd design_of(double length, double a, double b, double c) {
  return Eigen::Vector4d(length, a, b, c);
}

Matrix4d expected_moments(const HullPart& hull, const VectorXd& s) {
  const std::vector<Vector3d> points = hull_points(hull, s);
  const SolidMoments solid = moments_of_solid(convex_hull(points), points);
  Matrix4d out;
  out.topLeftCorner<3, 3>() = solid.second + solid.volume * solid.centre * solid.centre.transpose();
  out.topRightCorner<3, 1>() = solid.volume * solid.centre;
  out.bottomLeftCorner<1, 3>() = solid.volume * solid.centre.transpose();
  out(3, 3) = solid.volume;
  return out;
}

/// Near or far from the design whose triangles it has, it weighs what its hull there does.
TEST(HullMoments, AreThoseOfTheHullAtEachDesign) {
  const VectorXd initial = design_of(0.08, 0.1, -0.2, 0.0);
  int changed = 0;
  for (unsigned seed = 0; seed < 10; ++seed) {
    const HullPart hull = with_facets_at(moving_hull(seed), initial);
    for (const VectorXd& s : {initial, design_of(0.0801, 0.101, -0.2, 0.001),
                              design_of(0.05, 0.4, 0.3, -0.2), design_of(0.01, -0.7, 0.2, 0.6)}) {
      const Matrix4d wanted = expected_moments(hull, s), found = hull_moments(hull, s).moments;
      EXPECT_NEAR(found(3, 3), wanted(3, 3), 1e-12 * wanted(3, 3));
      EXPECT_NEAR((found - wanted).norm(), 0.0, 1e-12 * wanted.norm());
      EXPECT_EQ(hull_volume(hull, s).moments(3, 3), found(3, 3));
      changed += hull_facets(hull, hull_points(hull, s)) != hull.facets;
    }
  }
  EXPECT_GE(changed, 15) << "else triangles were never made anew";
}

/// Derivatives by central differences; of second ones differences of the first.
void expect_derivatives(const HullPart& hull, const VectorXd& s, double step) {
  const HullMoments here = hull_moments(hull, s), volume = hull_volume(hull, s);
  ASSERT_EQ(here.parameters, (std::vector<int>{0, 1, 2, 3}));
  const double size = here.moments.norm();
  for (std::size_t k = 0; k < here.parameters.size(); ++k) {
    VectorXd before = s, after = s;
    before[here.parameters[k]] -= step;
    after[here.parameters[k]] += step;
    const HullMoments a = hull_moments(hull, before), b = hull_moments(hull, after);
    const Matrix4d first = (b.moments - a.moments) / (2.0 * step);
    EXPECT_NEAR((here.first[k] - first).norm(), 0.0, 1e-6 * (size + first.norm())) << k;
    EXPECT_EQ(volume.first[k](3, 3), here.first[k](3, 3));
    for (std::size_t l = 0; l < here.parameters.size(); ++l) {
      const Matrix4d second = (b.first[l] - a.first[l]) / (2.0 * step);
      EXPECT_NEAR((here.second[k][l] - second).norm(), 0.0, 1e-6 * (size + second.norm()))
          << k << " " << l;
      EXPECT_EQ(volume.second[k][l](3, 3), here.second[k][l](3, 3));
    }
  }
}

TEST(HullMoments, HaveTheirDerivatives) {
  const VectorXd initial = design_of(0.08, 0.1, -0.2, 0.0);
  for (unsigned seed = 0; seed < 10; ++seed) {
    const HullPart hull = with_facets_at(moving_hull(seed), initial);
    for (const VectorXd& s : {initial, design_of(0.05, 0.4, 0.3, -0.2)}) {
      SCOPED_TRACE(seed);
      expect_derivatives(hull, s, 1e-6);
    }
  }
}

/// Where triangles change on the way from one design to another, just before and just after.
struct FacetChange {
  VectorXd before, after;
};

FacetChange first_change(const HullPart& hull, const VectorXd& from, const VectorXd& to) {
  const auto at = [&](double share) -> VectorXd { return from + share * (to - from); };
  const std::vector<Facet> facets = convex_hull(hull_points(hull, from));
  double low = 0.0, high = 1.0;
  while (high - low > 1e-9) {
    const double middle = 0.5 * (low + high);
    (convex_hull(hull_points(hull, at(middle))) == facets ? low : high) = middle;
  }
  return {at(low), at(high)};
}

/// What a hull weighs goes on without a jump, with derivatives of its own on either side; and its
/// volume, the larger one of both sides', bends upwards.
TEST(HullMoments, GoOnWhereTrianglesChange) {
  const VectorXd initial = design_of(0.08, 0.1, -0.2, 0.0), other = design_of(0.05, 0.4, 0.3, -0.2);
  int kinks = 0;
  for (unsigned seed = 0; seed < 10; ++seed) {
    SCOPED_TRACE(seed);
    const HullPart hull = with_facets_at(moving_hull(seed), initial);
    const FacetChange change = first_change(hull, initial, other);
    const VectorXd way = other - initial;
    const HullMoments before = hull_moments(hull, change.before),
                      after = hull_moments(hull, change.after);
    EXPECT_NEAR((after.moments - before.moments).norm(), 0.0, 1e-7 * before.moments.norm());
    double rise = 0.0, slope = 0.0;  // of the volume along the way
    for (std::size_t k = 0; k < 4; ++k) {
      rise += (after.first[k] - before.first[k])(3, 3) * way[static_cast<Eigen::Index>(k)];
      slope += std::abs(before.first[k](3, 3) * way[static_cast<Eigen::Index>(k)]);
    }
    EXPECT_GE(rise, -1e-6 * slope);
    kinks += rise > 1e-4 * slope;
    expect_derivatives(hull, change.before - 1e-3 * way, 1e-6);
    expect_derivatives(hull, change.after + 1e-4 * way, 1e-6);
  }
  EXPECT_GE(kinks, 5) << "else nothing bends here";
}

/// In a robot: mass, centre and inertia of a link, and the printed volume.
TEST(HullMoments, AreWhatALinkWeighs) {
  const VectorXd s = design_of(0.07, 0.3, -0.1, 0.2);
  Morphology robot;
  robot.links.resize(2);
  robot.links[1].parent = 0;
  robot.links[0].masses.push_back({2.0, {}});
  robot.links[1].masses.push_back({0.1, {Vector3d(0.0, 0.01, 0.0), {}}});
  robot.links[1].hulls.push_back(with_facets_at(moving_hull(3), design_of(0.08, 0.1, -0.2, 0.0)));
  const HullMoments own = hull_moments(robot.links[1].hulls[0], s);
  Matrix4d point = 0.1 * Vector3d(0.0, 0.01, 0.0).homogeneous() *
                   Vector3d(0.0, 0.01, 0.0).homogeneous().transpose();
  const GeometryAtDesign geometry(robot, s);
  EXPECT_NEAR((geometry.links[1].moments - point - 1240.0 * own.moments).norm(), 0.0, 1e-15);
  EXPECT_TRUE(geometry.links[1].grows);
  EXPECT_FALSE(geometry.links[0].grows);
  ASSERT_EQ(geometry.links[1].inner.size(), 4u);
  for (std::size_t k = 0; k < 4; ++k) {
    const InnerMotion& motion = geometry.links[1].inner[k];
    const Matrix4d first = motion.moments + motion.moments.transpose();
    EXPECT_NEAR((first - 1240.0 * own.first[k]).norm(), 0.0, 1e-12 * first.norm());
    EXPECT_NEAR((motion.first - first.col(3)).norm(), 0.0, 1e-15);
  }
  EXPECT_EQ(growth_parameters(robot), own.parameters);
  const GrowthSum mass = growth_sum(robot, Amount::mass, s),
                  volume = growth_sum(robot, Amount::printed_volume, s);
  EXPECT_NEAR(mass.value, 2.1 + 1240.0 * own.moments(3, 3), 1e-14);
  EXPECT_NEAR(volume.value, own.moments(3, 3), 1e-18);
  for (Eigen::Index k = 0; k < 4; ++k) {
    EXPECT_NEAR(volume.gradient[k], own.first[static_cast<std::size_t>(k)](3, 3), 1e-18);
    EXPECT_NEAR(mass.gradient[k], 1240.0 * volume.gradient[k], 1e-14);
  }
  EXPECT_NEAR(robot.total_mass(), 2.1 + robot.links[1].hulls[0].mass, 1e-15);
  EXPECT_TRUE(robot.grows());
}

}  // namespace
}  // namespace legwright
