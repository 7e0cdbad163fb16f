// SPDX-License-Identifier: Apache-2.0
#include "mjcf/write/mesh_scales.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "mjcf/read/feet.hpp"
#include "mjcf/read/stretch.hpp"
#include "mjcf/shape/mesh_assets.hpp"
#include "mjcf/text/compile.hpp"
#include "mjcf/text/mesh_copies.hpp"
#include "mjcf/text/refusals.hpp"
#include "mjcf/write/model_diff.hpp"
#include "mjcf/write/rewrite_robot.hpp"
#include "tests/mjcf/robots/construction_robots.hpp"
#include "tests/mjcf/robots/mesh_quadruped.hpp"
#include "tests/mjcf/robots/robots.hpp"
#include "tests/mjcf/robots/shifted_robot.hpp"
#include "tests/mjcf/robots/split_robot.hpp"
#include "tests/tools/files/temporary_folder.hpp"

namespace legwright {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using test::holds;

Matrix3d rotation(const mjtNum* q) {
  return Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix();
}

/// Corners of a geom's mesh, in the frame of its body.
Matrix3Xd corners(const mjModel& model, int geom) {
  const int mesh = model.geom_dataid[geom];
  const Eigen::Map<const Eigen::Matrix3Xf> own(model.mesh_vert + 3 * model.mesh_vertadr[mesh], 3,
                                               model.mesh_vertnum[mesh]);
  return (rotation(model.geom_quat + 4 * geom) * own.cast<double>()).colwise() +
         Vector3d::Map(model.geom_pos + 3 * geom);
}

/// Largest distance of a wanted corner to the nearest one that is there [m].
double distance(const Matrix3Xd& wanted, const Matrix3Xd& found) {
  double largest = 0.0;
  for (const auto& corner : wanted.colwise())
    largest = std::max(largest, (found.colwise() - corner).colwise().norm().minCoeff());
  return largest;
}

/// How far meshes of a text are from where a design wants them.
struct Misfit {
  double with_design = 0.0, without = 0.0;  // [m]: where the body's points go; where they were
  int rigid = 0;                            // feet and their pictures, which move as they are
};

Misfit misfit(const RobotModel& robot, const VectorXd& s, const std::string& text) {
  const ModelPointer before = compile_mjcf(robot.xml, "a"), after = compile_mjcf(text, "b");
  Refusals none;
  const StretchMap stretches = collect_stretches(robot.space, robot.bindings, robot.file, none);
  Misfit out;
  for (int g = 0; g < before->ngeom; ++g) {
    if (before->geom_type[g] != mjGEOM_MESH) continue;
    const auto found = stretches.find(name_of(*before, mjOBJ_BODY, before->geom_bodyid[g]));
    const Matrix3d map =
        found == stretches.end() ? Matrix3d::Identity() : stretch_matrix(found->second, s);
    const Matrix3Xd old = corners(*before, g), now = corners(*after, g);
    const Vector3d shift =
        found == stretches.end() ? Vector3d::Zero() : stretch_shift(found->second, s);
    Matrix3Xd wanted = (map * old).colwise() + shift;
    const std::string mesh = name_of(*before, mjOBJ_MESH, before->geom_dataid[g]);
    for (std::size_t f = 0; f < robot.structure.feet.size() && mesh.substr(0, 3) == "paw"; ++f) {
      const int foot = robot.structure.feet[f].geom;
      if (before->geom_bodyid[foot] != before->geom_bodyid[g]) continue;
      const Vector3d point = robot.morphology.feet[f].position.at(robot.space.initial());
      wanted = old.colwise() + (map * point - point);
      ++out.rigid;
    }
    out.with_design = std::max(out.with_design, distance(wanted, now));
    out.without = std::max(out.without, distance(old, now));
  }
  return out;
}

int meshes_in(const std::string& text) { return static_cast<int>(compile_mjcf(text, "x")->nmesh); }

/// Number of a parameter whose name holds this.
int index_of(const DesignSpace& space, const std::string& part) {
  for (int k = 0; k < space.size(); ++k)
    if (holds(space.parameters[k].name, part)) return k;
  ADD_FAILURE() << part;
  return 0;
}

VectorXd all_lengths(const RobotModel& robot, double share) {
  VectorXd s = robot.space.initial();
  for (int k = 0; k < robot.space.size(); ++k)
    if (robot.space.parameters[k].kind == ParameterKind::length)
      s[k] += share * (robot.space.upper()[k] - s[k]);
  return s;
}

std::string shifted_quadruped() { return test::shifted_robot(test::mesh_quadruped()); }

class MeshRobots : public testing::TestWithParam<std::string (*)()> {
 protected:
  RobotModel robot_ = parse_robot(test::declared(GetParam()()), "robot.xml");
};

TEST_P(MeshRobots, EveryMeshGoesWhereItsBodyGoes) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 10; ++trial) {
    const VectorXd s = test::random_design(robot_.space, random);
    const std::string text = rewrite_robot(robot_, s);
    const Misfit found = misfit(robot_, s, text);
    EXPECT_LT(found.with_design, 1e-7) << "trial " << trial;
    EXPECT_GT(found.without, 1e-3);  // twin
  }
}

TEST_P(MeshRobots, RewritingAWrittenFileAgainIsStable) {
  std::mt19937 random(4);
  EXPECT_TRUE(rewrite_robot(robot_, robot_.space.initial()) == robot_.xml);
  const VectorXd s = test::random_design(robot_.space, random);
  const std::string once = rewrite_robot(robot_, s);
  const RobotModel written = parse_robot(once, "robot.xml", &robot_.structure);
  EXPECT_TRUE(rewrite_robot(written, written.space.initial()) == once);
  EXPECT_TRUE(rewrite_robot(written, s) == once);
  EXPECT_TRUE(rewrite_robot(robot_, s) == once);
  // To another design, by either way, and from there back.
  const VectorXd other = test::random_design(robot_.space, random);
  const std::string again = rewrite_robot(written, other);
  EXPECT_LT(misfit(robot_, other, again).with_design, 1e-7);
  EXPECT_EQ(meshes_in(again), meshes_in(once));
  const std::string back =
      rewrite_robot(parse_robot(again, "robot.xml", &robot_.structure), robot_.space.initial());
  EXPECT_LT(misfit(robot_, robot_.space.initial(), back).with_design, 1e-7);
  EXPECT_GT(misfit(robot_, s, back).with_design, 1e-3);  // twin
}

INSTANTIATE_TEST_SUITE_P(Robots, MeshRobots,
                         testing::Values(test::mesh_quadruped, test::classed_quadruped,
                                         shifted_quadruped));

class MeshScales : public testing::Test {
 protected:
  RobotModel robot_ = parse_robot(test::declared(test::mesh_quadruped()), "robot.xml");

  std::string with_length(const std::string& name, double factor) const {
    VectorXd s = robot_.space.initial();
    s[index_of(robot_.space, name)] *= factor;
    return rewrite_robot(robot_, s);
  }
};

/// Front and hind thighs grow by their own numbers: only then is there a second asset.
TEST_F(MeshScales, OnlyWhatDiffersGetsItsOwnAsset) {
  const std::string xml = test::declared(test::classed_quadruped());
  const RobotModel robot = parse_robot(xml, "robot.xml");
  VectorXd s = robot.space.initial();
  const int front = index_of(robot.space, "front_thigh"),
            hind = index_of(robot.space, "hind_thigh");
  s[front] *= 1.125;
  const std::string one = rewrite_robot(robot, s);
  // The hind thighs keep the element, so that their geoms are untouched.
  EXPECT_TRUE(holds(one, "<mesh name=\"thigh\" scale=\"1 1 0.5\" vertex="));
  EXPECT_TRUE(holds(one, "\n    <mesh name=\"thigh_2\" scale=\"1 1 0.5625\" vertex=")) << one;
  EXPECT_EQ(meshes_in(one), meshes_in(xml) + 1);
  const auto shown = [&](const std::string& text, const std::string& leg) {
    const std::size_t body = text.find("<body name=\"" + leg + "_thigh\"");
    const std::size_t at = text.find("mesh=\"", body) + 6;
    return text.substr(at, text.find('"', at) - at);
  };
  EXPECT_EQ(shown(one, "FR"), "thigh_2");
  EXPECT_EQ(shown(one, "FL"), "thigh_2");
  EXPECT_EQ(shown(one, "RR"), "thigh");
  s[hind] *= 1.125;
  const std::string both = rewrite_robot(robot, s);  // by the same factor: one asset again
  EXPECT_TRUE(holds(both, "<mesh name=\"thigh\" scale=\"1 1 0.5625\" vertex="));
  EXPECT_EQ(meshes_in(both), meshes_in(xml));
  EXPECT_EQ(shown(both, "FR"), "thigh");
  s[hind] *= 0.9;
  const std::string two = rewrite_robot(robot, s);  // both change, each in its way
  EXPECT_EQ(meshes_in(two), meshes_in(xml) + 1);
  EXPECT_EQ(shown(two, "FR"), "thigh");  // as many: the first keep it
  EXPECT_EQ(shown(two, "RL"), "thigh_2");
}

/// What the class says, mirrored scales, and a name that is taken.
TEST_F(MeshScales, ClassesMirrorsAndTakenNamesAreHonoured) {
  const std::string thighs = with_length("front_thigh", 1.2);
  EXPECT_TRUE(holds(thighs, "<mesh name=\"upper_2\" class=\"legs\"")) << thighs;
  EXPECT_TRUE(holds(thighs, "scale=\"0.001 0.001 0.0012\""));
  EXPECT_TRUE(holds(thighs,
                    "<mesh name=\"upper_mirrored_2\" class=\"legs\" "
                    "scale=\"0.001 -0.001 0.0012\""));
  EXPECT_FALSE(holds(thighs, "refquat"));
  const std::string shanks = with_length("front_shank", 1.2);
  EXPECT_TRUE(holds(shanks, "name=\"lower_2\""));
  EXPECT_TRUE(holds(shanks, "mesh=\"lower_2\""));  // instead of what the class says
  EXPECT_FALSE(holds(shanks, "paw_3"));
  EXPECT_TRUE(holds(shanks, "refquat"));  // oblique to every axis
}

/// The paw is a mesh that collides: what the planner takes for the foot is where the mesh is.
TEST_F(MeshScales, AFootThatIsAMeshStaysTheFoot) {
  VectorXd s = robot_.space.initial();
  const int front = index_of(robot_.space, "front_shank");
  s[front] *= 1.2;
  const RobotModel written = parse_robot(rewrite_robot(robot_, s), "robot.xml", &robot_.structure);
  for (std::size_t f = 0; f < robot_.morphology.feet.size(); ++f) {
    const auto& foot = robot_.morphology.feet[f];
    const Vector3d wanted = foot.position.at(s);
    EXPECT_LT((written.morphology.feet[f].position.at(s) - wanted).norm(), 1e-9) << foot.name;
    EXPECT_GT((foot.position.at(robot_.space.initial()) - wanted).norm() + (f > 1 ? 1 : 0), 0.03);
  }
  const Misfit found = misfit(robot_, s, written.xml);
  EXPECT_EQ(found.rigid, 8);  // each paw, and its picture
  EXPECT_LT(found.with_design, 1e-7);
  EXPECT_EQ(meshes_in(written.xml), meshes_in(robot_.xml) + 1);  // of the shank alone
}

/// One mesh that is shank and foot at once, as a converted robot has it.
TEST(MeshFeet, AShankThatIsOneMeshWithItsFootGrowsWithItsLength) {
  const std::string xml =
      test::with(test::hopper_with("<geom name=\"tip\" type=\"mesh\" mesh=\"leg\"/>"), "<asset>",
                 "<asset><mesh name=\"leg\" vertex=\"-0.01 -0.01 0.01 0.01 -0.01 0.01 -0.01 0.01 "
                 "0.01 0.01 0.01 0.01  0.0 -0.01 -0.2 0.02 -0.01 -0.2 0 0.01 -0.2 0.02 0.01 "
                 "-0.2\"/>");
  const RobotModel robot = parse_robot(test::declared(xml), "robot.xml");
  const int shank = index_of(robot.space, "shank");
  VectorXd s = robot.space.initial();
  s[shank] *= 1.2;
  const std::string text = rewrite_robot(robot, s);
  EXPECT_LT(misfit(robot, s, text).with_design, 1e-7);
  EXPECT_GT(misfit(robot, s, text).without, 0.03);
  const RobotModel written = parse_robot(text, "robot.xml", &robot.structure);
  EXPECT_NEAR(written.space.initial()[shank], s[shank], 1e-12);
  EXPECT_LT(
      (written.morphology.feet[0].position.at(s) - robot.morphology.feet[0].position.at(s)).norm(),
      1e-9);
}

/// A foot that keeps its shape, in a frame which the stretch moves by itself. That the foot is
/// where it shall be is what rewrite_robot() looks at.
TEST(MeshFeet, AFootInAFrameMovesAsItsSoleDoes) {
  const RobotModel robot = parse_robot(
      test::declared(test::hopper_with(
          "<frame pos=\"0.01 0 -0.05\" euler=\"0 0.1 0\"><frame pos=\"0 0 -0.1\" euler=\"0 0 0.5\">"
          "<geom name=\"tip\" type=\"mesh\" mesh=\"shoe\" pos=\"0 0.01 -0.05\"/></frame></frame>")),
      "robot.xml");
  VectorXd s = robot.space.initial();
  s[index_of(robot.space, "shank")] *= 1.2;
  const std::string text = rewrite_robot(robot, s);
  const ModelPointer before = compile_mjcf(robot.xml, "a"), after = compile_mjcf(text, "b");
  const int tip = robot.structure.feet[0].geom;
  for (int k = 0; k < 6; ++k)
    EXPECT_EQ(after->geom_aabb[6 * tip + k], before->geom_aabb[6 * tip + k]);
  EXPECT_FALSE(holds(text, "scale="));
  const Vector3d moved = robot.morphology.feet[0].position.at(s) -
                         robot.morphology.feet[0].position.at(robot.space.initial());
  EXPECT_GT(moved.norm(), 0.04);
  EXPECT_LT(
      (Vector3d::Map(after->geom_pos + 3 * tip) - Vector3d::Map(before->geom_pos + 3 * tip) - moved)
          .norm(),
      1e-9);
}

/// Scales that differ along the axes of an oblique mesh, and an orientation that a class tells.
TEST(MeshTurns, AnyScaleAndAnyOrientationCanBeStretchedObliquely) {
  for (const char* const scale : {"1 1 1", "1 2 0.5", "1 -2 0.5", "-1 1 1", "-1 -1 -1"})
    for (const bool by_class : {false, true}) {
      std::string xml = test::hopper_with(
          "<geom name=\"tip\" size=\"0.02\" pos=\"0 0 -0.2\"/><geom class=\"oblique\" "
          "type=\"mesh\" mesh=\"shoe\" pos=\"0.01 0.02 -0.1\" contype=\"0\" conaffinity=\"0\"/>");
      xml = test::with(xml, "<mesh name=\"shoe\"",
                       "<mesh name=\"shoe\" refquat=\"0.8 0.1 0.2 -0.3\" refpos=\"0.01 0 0\" "
                       "scale=\"" +
                           std::string(scale) + "\"");
      xml = test::with(xml, "<asset>",
                       "<default><default class=\"oblique\"><geom " +
                           std::string(by_class ? "euler=\"0.3 0.4 0.5\"" : "") +
                           "/></default></default><asset>");
      if (!by_class)
        xml = test::with(xml, "<geom class=\"oblique\"",
                         "<geom class=\"oblique\" axisangle=\"1 2 3 0.4\"");
      const RobotModel robot = parse_robot(test::declared(xml), "robot.xml");
      VectorXd s = robot.space.initial();
      s[index_of(robot.space, "shank")] *= 1.2;
      const Misfit found = misfit(robot, s, rewrite_robot(robot, s));
      EXPECT_LT(found.with_design, 1e-7) << scale << by_class;
      EXPECT_GT(found.without, 1e-3);
    }
}

/// A body without <inertial> that weighs by its mesh keeps it: it would weigh more.
TEST(MeshWeights, AMeshThatGivesTheBodyItsWeightKeepsItsSize) {
  std::string xml = test::hopper_with(
      "<geom name=\"tip\" size=\"0.02\" pos=\"0 0 -0.2\"/><geom type=\"mesh\" mesh=\"shoe\" "
      "pos=\"0 0 -0.1\" contype=\"0\" conaffinity=\"0\"/>");
  const std::string inertial =
      "<joint name=\"knee\" axis=\"0 1 0\"/>\n          <inertial pos=\"0 0 -0.1\" mass=\"0.1\" "
      "diaginertia=\"1e-4 1e-4 1e-5\"/>";
  for (const bool weighs : {true, false}) {
    const std::string own =
        weighs ? test::with(xml, inertial, "<joint name=\"knee\" axis=\"0 1 0\"/>") : xml;
    const RobotModel robot = parse_robot(test::declared(own), "robot.xml");
    VectorXd s = robot.space.initial();
    s[index_of(robot.space, "shank")] *= 1.2;
    EXPECT_EQ(holds(rewrite_robot(robot, s), "scale="), !weighs);
  }
}

/// Assets in an included file: the copy stands in that file, behind its original, even where this
/// is the last thing in it.
TEST(MeshCopies, StandInTheFileOfTheirOriginal) {
  const test::TemporaryFolder folder;
  std::string xml = test::declared(test::mesh_quadruped());
  const std::size_t begin = xml.find("<mesh name=\"upper\""), end = xml.find("</asset>", begin);
  std::string assets = xml.substr(begin, end - begin);
  assets.erase(assets.find_last_not_of(" \n") + 1);
  xml.replace(begin, end - begin, "<include file=\"parts/meshes.xml\"/>");
  const std::size_t leg = xml.find("<body name=\"fl_hip\""),
                    next = xml.find("<body name=\"fr_hip\"");
  const std::string front_left = xml.substr(leg, next - leg);
  xml.replace(leg, next - leg, "<include file=\"parts/fl.xml\"/>\n      ");
  test::put(folder.path() / "robot_main.xml", xml);
  test::put(folder.path() / "parts/meshes.xml",
            "<mujocoinclude><!-- m -->" + assets + "</mujocoinclude>");
  test::put(folder.path() / "parts/fl.xml", "<mujocoinclude>" + front_left + "</mujocoinclude>");
  const RobotModel robot = read_robot(folder.path() / "robot_main.xml");
  const VectorXd s = all_lengths(robot, 0.5);
  VectorXd uneven = s;
  uneven[index_of(robot.space, "front_shank")] =
      robot.space.initial()[index_of(robot.space, "front_shank")];
  uneven[index_of(robot.space, "front_thigh")] *= 0.97;
  const std::string text = rewrite_robot(robot, uneven);
  const RobotFiles files = robot.files.with_text(text);
  EXPECT_EQ(files.text(), text);
  ASSERT_EQ(files.includes().size(), 2u);
  const std::string meshes = files.includes()[0].text;
  for (const char* const name : {"\"upper_2\"", "\"lower_2\""}) {
    EXPECT_TRUE(holds(meshes, name)) << name << meshes;
    EXPECT_FALSE(holds(files.main_text(), "name=" + std::string(name))) << name;
  }
  // Read from the disk again it is the same robot, byte for byte, and stock MuJoCo opens it.
  test::put(folder.path() / "robot_main.xml", files.main_text());
  for (const IncludedFile& part : files.includes()) test::put(folder.path() / part.path, part.text);
  const RobotModel written =
      parse_robot(RobotFiles::read(folder.path() / "robot_main.xml"), &robot.structure);
  EXPECT_TRUE(written.files.text() == text);
  char error[1000] = "";
  const ModelPointer stock(
      mj_loadXML((folder.path() / "robot_main.xml").c_str(), nullptr, error, sizeof error));
  ASSERT_TRUE(stock) << error;
  EXPECT_TRUE(model_differences(*stock, *compile_mjcf(text, robot.file), 0.0).empty());
  // Places in the text are led back to lines that exist.
  const std::string back = rewrite_robot(written, robot.space.initial());
  EXPECT_LT(misfit(robot, robot.space.initial(), back).with_design, 1e-7);
  EXPECT_EQ(written.files.with_text(back).text(), back);
}

TEST(MeshCopies, AreTakenOutAndPutBack) {
  const RobotModel robot = parse_robot(test::declared(test::mesh_quadruped()), "robot.xml");
  VectorXd s = robot.space.initial();
  s[index_of(robot.space, "front_thigh")] *= 1.2;
  const std::string text = rewrite_robot(robot, s);
  const std::vector<TextRange> added = find_added_meshes(robot.xml, text);
  EXPECT_EQ(added.size(), 2u);
  const std::string rest = without(text, added);
  const std::string shown_again =
      test::with(test::with(rest, "mesh=\"upper_2\"", "mesh=\"upper\""),
                 "mesh=\"upper_mirrored_2\"", "mesh=\"upper_mirrored\"");
  EXPECT_EQ(meshes_in(shown_again), meshes_in(robot.xml));
  EXPECT_TRUE(find_added_meshes(text, text).empty());
  // Other new elements than meshes are still refused.
  const test::TemporaryFolder folder;
  const RobotFiles files = RobotFiles::read(test::write_split_puppy(folder.path()));
  const std::string changed =
      test::with(files.text(), "</worldbody>", "<body><geom size=\"1\"/></body></worldbody>");
  EXPECT_THROW(files.with_text(changed), std::logic_error);
}

/// A camera that follows the robot looks at it from outside; one that is fixed is a part of it.
TEST_F(MeshScales, ViewsFromOutsideStayWhereTheyAre) {
  const std::string text = with_length("body_length", 1.04);
  EXPECT_TRUE(holds(text, "<camera name=\"outside\" mode=\"trackcom\" pos=\"0.3 -1.2 0.5\"/>"));
  EXPECT_TRUE(holds(text, "mode=\"targetbody\" target=\"trunk\" pos=\"0.1 0 2\"/>"));
  EXPECT_TRUE(holds(text, "<camera name=\"eye\" pos=\"0.208 0 0.05\"/>")) << text;
}

}  // namespace
}  // namespace legwright
