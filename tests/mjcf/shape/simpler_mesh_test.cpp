// SPDX-License-Identifier: Apache-2.0
#include "mjcf/shape/simpler_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace legwright {
namespace {

/// A ball of radius 1, of rings and sectors, with its two poles.
DrawnMesh ball(int rings, int sectors) {
  DrawnMesh mesh;
  const auto add = [&](double polar, double azimuth) {
    for (const double x : {std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth),
                           std::cos(polar)})
      mesh.vertices.push_back(static_cast<float>(x));
  };
  const auto at = [&](int ring, int sector) {
    return static_cast<std::uint32_t>(1 + ring * sectors + sector % sectors);
  };
  add(0.0, 0.0);
  for (int ring = 0; ring < rings; ++ring)
    for (int sector = 0; sector < sectors; ++sector)
      add(std::numbers::pi * (ring + 1) / (rings + 1), 2 * std::numbers::pi * sector / sectors);
  add(std::numbers::pi, 0.0);
  const auto last = static_cast<std::uint32_t>(1 + rings * sectors);
  for (int sector = 0; sector < sectors; ++sector) {
    const std::uint32_t caps[] = {0,
                                  at(0, sector),
                                  at(0, sector + 1),
                                  last,
                                  at(rings - 1, sector + 1),
                                  at(rings - 1, sector)};
    mesh.faces.insert(mesh.faces.end(), std::begin(caps), std::end(caps));
    for (int ring = 0; ring + 1 < rings; ++ring) {
      const std::uint32_t quad[] = {at(ring, sector),         at(ring + 1, sector),
                                    at(ring + 1, sector + 1), at(ring, sector),
                                    at(ring + 1, sector + 1), at(ring, sector + 1)};
      mesh.faces.insert(mesh.faces.end(), std::begin(quad), std::end(quad));
    }
  }
  return mesh;
}

TEST(SimplerMesh, KeepsAboutTheShareAndTheShape) {
  const DrawnMesh whole = ball(40, 60);
  const DrawnMesh less = simpler_mesh(whole, 0.1);
  EXPECT_LE(less.triangles(), whole.triangles() * 13 / 100);
  EXPECT_GE(less.triangles(), whole.triangles() / 25);
  EXPECT_LT(less.vertices.size(), whole.vertices.size() / 4);
  for (const std::uint32_t corner : less.faces) ASSERT_LT(3 * corner, less.vertices.size());
  for (std::size_t v = 0; v < less.vertices.size(); v += 3)
    EXPECT_NEAR(std::hypot(less.vertices[v], less.vertices[v + 1], less.vertices[v + 2]), 1.0,
                0.05);
}

TEST(SimplerMesh, AShareOfOneChangesNothing) {
  const DrawnMesh whole = ball(5, 7), same = simpler_mesh(whole, 1.0);
  EXPECT_EQ(same.vertices, whole.vertices);
  EXPECT_EQ(same.faces, whole.faces);
}

TEST(SimplerMesh, TheSameMeshGivesTheSame) {
  const DrawnMesh one = simpler_mesh(ball(20, 30), 0.3), other = simpler_mesh(ball(20, 30), 0.3);
  EXPECT_EQ(one.faces, other.faces);
  EXPECT_EQ(one.vertices, other.vertices);
}

TEST(SimplerMesh, NeverEndsWithoutAFaceAndTakesAnEmptyMesh) {
  EXPECT_GT(simpler_mesh(ball(20, 30), 1e-9).triangles(), 0U);
  EXPECT_EQ(simpler_mesh({}, 0.5).triangles(), 0U);
}

}  // namespace
}  // namespace legwright
