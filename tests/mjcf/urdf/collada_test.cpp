// SPDX-License-Identifier: Apache-2.0
// Collada as modellers write it: places, units, polygons, parts that are shown twice, and faults.
#include "mjcf/urdf/collada.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>
#include <string>

#include "mjcf/text/input_error.hpp"
#include "tests/mjcf/urdf/collada_box.hpp"

namespace legwright {
namespace {

using Eigen::Vector3d;

using test::collada;
using test::kPolygons;
using test::kPolylist;
using test::kShown;
using test::kTriangles;

DrawnMesh read_dae(const std::string& text) { return read_collada(text, "box.dae"); }

std::string fault_of_dae(const std::string& text) {
  try {
    read_dae(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

Eigen::AlignedBox3d box_of_dae(const DrawnMesh& mesh) {
  Eigen::AlignedBox3d out;
  for (std::size_t v = 0; v + 2 < mesh.vertices.size(); v += 3)
    out.extend(Vector3d(mesh.vertices[v], mesh.vertices[v + 1], mesh.vertices[v + 2]));
  return out;
}

/// Six times the sum of the tetrahedra to the origin: negative where faces look inwards.
double volume_of_dae(const DrawnMesh& mesh) {
  const auto at = [&](std::uint32_t v) {
    return Vector3d(mesh.vertices[3 * v], mesh.vertices[3 * v + 1], mesh.vertices[3 * v + 2]);
  };
  double out = 0.0;
  for (std::size_t f = 0; f + 2 < mesh.faces.size(); f += 3)
    out += at(mesh.faces[f]).dot(at(mesh.faces[f + 1]).cross(at(mesh.faces[f + 2]))) / 6.0;
  return out;
}

TEST(Collada, TrianglesPolylistsAndPolygonsAreOneBox) {
  for (const std::string& faces : {kTriangles, kPolylist, kPolygons}) {
    const DrawnMesh mesh = read_dae(collada(faces, kShown));
    EXPECT_EQ(mesh.triangles(), 12u);
    EXPECT_NEAR(volume_of_dae(mesh), 1.0, 1e-6) << faces;
  }
}

/// As RViz and Gazebo have it for a URDF.
TEST(Collada, UnitsCountAndTheUpAxisDoesNot) {
  const DrawnMesh mesh = read_dae(collada(
      kTriangles, kShown, "<unit name=\"centimeter\" meter=\"0.01\"/><up_axis>Y_UP</up_axis>"));
  EXPECT_NEAR(box_of_dae(mesh).max().maxCoeff(), 0.01, 1e-9);
  EXPECT_NEAR(box_of_dae(mesh).min().minCoeff(), 0.0, 1e-9);
}

TEST(Collada, NodesPlaceWhatTheyShow) {
  const DrawnMesh mesh = read_dae(collada(
      kPolylist,
      "<node><translate>10 0 0</translate><rotate>0 0 1 90</rotate><scale>2 1 1</scale>"
      "<instance_geometry url=\"#box\"/><node><matrix>1 0 0 0  0 1 0 0  0 0 -1 5  0 0 0 1</matrix>"
      "<instance_geometry url=\"#box\"/></node></node>"));
  EXPECT_EQ(mesh.triangles(), 24u);
  EXPECT_LT((box_of_dae(mesh).min() - Vector3d(9, 0, 0)).norm(), 1e-6) << box_of_dae(mesh).min();
  EXPECT_LT((box_of_dae(mesh).max() - Vector3d(10, 2, 5)).norm(), 1e-6) << box_of_dae(mesh).max();
  EXPECT_NEAR(volume_of_dae(mesh), 4.0, 1e-5) << "the mirrored one looks outwards, too";
}

TEST(Collada, WithoutASceneAllGeometriesAreShown) {
  std::string text = collada(kPolylist, "");
  EXPECT_EQ(read_dae(text).triangles(), 12u);
  const std::size_t from = text.find("<library_visual"), to = text.find("</COLLADA>");
  EXPECT_EQ(read_dae(text.erase(from, to - from)).triangles(), 12u);
}

TEST(Collada, FaultsHaveTheirPlace) {
  EXPECT_NE(fault_of_dae("<mujoco/>").find("is no <COLLADA>"), std::string::npos);
  EXPECT_NE(fault_of_dae(collada(kPolylist, "<node/>")).find("shows no triangles"),
            std::string::npos);
  const auto in = [](std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
  };
  EXPECT_NE(fault_of_dae(collada(in(kPolygons, "0 3 2 1", "0 3 2 8"), kShown))
                .find("box.dae:2: p: holds"),
            std::string::npos)
      << fault_of_dae(collada(in(kPolygons, "0 3 2 1", "0 3 2 8"), kShown));
  EXPECT_NE(
      fault_of_dae(collada(in(kPolygons, "0 3 2 1", "0 3 2 -1"), kShown)).find("no whole number"),
      std::string::npos);
  EXPECT_NE(
      fault_of_dae(collada(in(kPolylist, "4 4 4 4 4 4", "4 4 4 4 4 5"), kShown)).find("vcount"),
      std::string::npos);
  EXPECT_NE(fault_of_dae(in(collada(kPolygons, kShown), "1 1 0", "1 x 0")).find("float_array"),
            std::string::npos);
  EXPECT_NE(fault_of_dae(collada(kPolygons, kShown, "<unit meter=\"-1\"/>")).find("is no length"),
            std::string::npos);
}

/// Each node shows the one before twice.
TEST(Collada, NodesWithoutEndAreRefused) {
  std::string nodes = "<node id=\"n0\"><instance_geometry url=\"#box\"/></node>";
  for (int n = 1; n < 30; ++n)
    nodes += fmt::format(
        "<node id=\"n{0}\"><instance_node url=\"#n{1}\"/><instance_node url=\"#n{1}\"/></node>", n,
        n - 1);
  EXPECT_NE(fault_of_dae(collada(kPolygons, nodes)).find("parts within parts"), std::string::npos);
  EXPECT_NE(fault_of_dae(collada(kPolygons, "<node id=\"n\"><instance_node url=\"#n\"/></node>"))
                .find("without end"),
            std::string::npos);
}

/// A small file that would take gigabytes.
TEST(Collada, PartsShownAgainAndAgainAreRefused) {
  std::string corners, polygon;
  for (int k = 0; k < 30000; ++k) {
    corners += fmt::format("{} {} 3 ", k, k % 7);
    polygon += fmt::format("{} ", k);
  }
  const auto shown = [&](const std::string& indices, int times) {
    std::string nodes;
    for (int k = 0; k < times; ++k) nodes += kShown;
    std::string text =
        collada("<polygons><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/><p>" + indices +
                    "</p></polygons>",
                nodes);
    return text.replace(text.find(test::kCorners), std::string(test::kCorners).size(), corners);
  };
  EXPECT_EQ(read_dae(shown("0 1 29999", 1)).vertices.size(), 9u) << "what no face has is left out";
  EXPECT_EQ(read_dae(shown(polygon, 3)).triangles(), 3u * 29998u);
  EXPECT_NE(fault_of_dae(shown(polygon, 200)).find("parts within parts"), std::string::npos);
  EXPECT_NE(fault_of_dae(collada(kPolygons,
                                 "<node><scale>1e39 1 1</scale><instance_geometry "
                                 "url=\"#box\"/></node>"))
                .find("m away"),
            std::string::npos);
}

TEST(Collada, TheSceneThatTheFileNamesIsShown) {
  std::string text = collada(kPolygons, kShown);
  text.replace(text.find("</library_visual"), 16,
               std::string("<visual_scene id=\"two\">") + kShown + kShown +
                   "</visual_scene></library_visual");
  EXPECT_EQ(read_dae(text).triangles(), 12u);
  text.replace(text.find("</COLLADA>"), 10,
               "<scene><instance_visual_scene url=\"#two\"/></scene></COLLADA>");
  EXPECT_EQ(read_dae(text).triangles(), 24u);
}

TEST(Collada, MutantsAreReadOrRefused) {
  const std::string whole = collada(kTriangles + kPolylist, kShown);
  std::mt19937 random(3);
  const std::string signs = "<>/\"=0123456789.-e #";
  int read_ones = 0;
  for (int n = 0; n < 3000; ++n) {
    std::string text = whole;
    for (int k = 0; k < 1 + n % 3; ++k) {
      const std::size_t at = random() % text.size();
      if (random() % 2 == 0)
        text[at] = signs[random() % signs.size()];
      else
        text.erase(at, 1 + random() % 9);
    }
    read_ones += fault_of_dae(text) == "accepted";
  }
  EXPECT_GT(read_ones, 100);
  EXPECT_LT(read_ones, 2700);
}

}  // namespace
}  // namespace legwright
