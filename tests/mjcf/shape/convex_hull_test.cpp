// SPDX-License-Identifier: Apache-2.0
// Hulls are closed, hold all points, and are what they are by their points alone.
#include "mjcf/shape/convex_hull.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <map>
#include <random>
#include <utility>

#include "mjcf/shape/polyhedron.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;

std::vector<Vector3d> points_of_a_box(const Vector3d& half) {
  std::vector<Vector3d> out;
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0})
      for (const double z : {-1.0, 1.0}) out.emplace_back(half.cwiseProduct(Vector3d(x, y, z)));
  return out;
}

std::vector<Vector3d> random_points(int count, unsigned seed, double scale) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  std::vector<Vector3d> out;
  for (int k = 0; k < count; ++k) {
    const double x = number(random), y = number(random), z = number(random);
    out.emplace_back(scale * Vector3d(x, 0.3 * y, z));
  }
  return out;
}

/// Each edge is that of two triangles, once each way; and Euler's count of a ball.
void expect_closed(const std::vector<Facet>& facets) {
  std::map<std::pair<int, int>, int> edges;
  for (const Facet& facet : facets)
    for (std::size_t k = 0; k < 3; ++k) ++edges[{facet[k], facet[(k + 1) % 3]}];
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    EXPECT_EQ(edges.count({edge.second, edge.first}), 1u);
  }
  EXPECT_EQ(corners_of(facets).size() + facets.size(), edges.size() / 2 + 2);
}

TEST(ConvexHull, OfABoxHasItsCornersAndVolume) {
  std::vector<Vector3d> points = points_of_a_box({0.01, 0.02, 0.03});
  points.insert(points.begin(), Vector3d(0.001, 0.002, 0.003));  // within
  points.emplace_back(0.01, 0.0, 0.0);                           // on a face
  points.emplace_back(0.01, 0.02, 0.01);                         // on an edge
  points.push_back(points[1]);                                   // a corner twice
  const std::vector<Facet> facets = convex_hull(points);
  expect_closed(facets);
  EXPECT_EQ(facets.size(), 12u);
  EXPECT_EQ(corners_of(facets), (std::vector<int>{1, 2, 3, 4, 5, 6, 7, 8}));
  EXPECT_NEAR(moments_of_solid(facets, points).volume, 8.0 * 0.01 * 0.02 * 0.03, 1e-18);
}

TEST(ConvexHull, HoldsAllPointsAtAnySize) {
  for (const double scale : {1e-3, 1.0, 1e3})
    for (unsigned seed = 0; seed < 20; ++seed) {
      const std::vector<Vector3d> points = random_points(60, seed, scale);
      const std::vector<Facet> facets = convex_hull(points);
      expect_closed(facets);
      EXPECT_TRUE(is_convex_hull(facets, points));
      EXPECT_EQ(facets, convex_hull(points));
    }
}

// Coplanar corners by the dozen, as of pads: rounding makes their planes many.
TEST(ConvexHull, OfRoundPlatesIsClosed) {
  for (int corners = 3; corners < 40; ++corners) {
    std::vector<Vector3d> points;
    for (int k = 0; k < corners; ++k) {
      const double turn = 2.0 * 3.14159265358979 * k / corners;
      for (const double high : {0.0, 0.003})
        for (const double aside : {0.0, 0.05})
          points.push_back(Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()) *
                           Vector3d(0.006 * std::cos(turn) + aside, 0.006 * std::sin(turn), high));
    }
    const std::vector<Facet> facets = convex_hull(points);
    expect_closed(facets);
    EXPECT_TRUE(is_convex_hull(facets, points));
  }
}

TEST(ConvexHull, OfFlatPointsIsEmpty) {
  EXPECT_TRUE(convex_hull({}).empty());
  EXPECT_TRUE(convex_hull({Vector3d::Zero(), Vector3d::UnitX(), Vector3d::UnitY()}).empty());
  std::vector<Vector3d> flat = points_of_a_box({0.1, 0.1, 0.0});
  EXPECT_TRUE(convex_hull(flat).empty());
  EXPECT_TRUE(convex_hull(std::vector<Vector3d>(9, Vector3d::Ones())).empty());
}

TEST(ConvexHull, IsNoneAnyMoreWhereACornerMovesIn) {
  std::vector<Vector3d> points = points_of_a_box({0.01, 0.02, 0.03});
  const std::vector<Facet> facets = convex_hull(points);
  points[7] *= 1.1;
  points[0] *= 0.2;
  EXPECT_FALSE(is_convex_hull(facets, points));
  EXPECT_TRUE(is_convex_hull(convex_hull(points), points));
}

}  // namespace
}  // namespace legwright
