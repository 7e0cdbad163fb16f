// SPDX-License-Identifier: Apache-2.0
#include "mjcf/propose/proposals.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>

#include "mjcf/propose/declare.hpp"
#include "mjcf/text/input_error.hpp"
#include "mjcf/write/rewrite_robot.hpp"
#include "tests/mjcf/robots/construction_robots.hpp"
#include "tests/mjcf/robots/robots.hpp"
#include "tests/mjcf/robots/shifted_robot.hpp"

namespace legwright {
namespace {

using test::example_robot;
using test::undeclared;

ProposedParameters study(const std::string& xml) { return propose_parameters(xml, "r.xml"); }

const Proposal& proposal_named(const ProposedParameters& found, const std::string& name) {
  for (const Proposal& proposal : found.proposals)
    if (proposal.name == name) return proposal;
  ADD_FAILURE() << "no proposal " << name;
  static const Proposal none;
  return none;
}

TEST(StudyRobot, ProposesForThePuppyWhatItsAuthorDeclared) {
  const std::string xml = example_robot("puppy");
  const ProposedParameters found = study(undeclared(xml));
  const RobotModel declared = parse_robot(xml, "r.xml");
  EXPECT_TRUE(found.left_out.empty()) << found.left_out.front();
  EXPECT_EQ(found.proposals.size(), declared.space.parameters.size());
  for (const DesignParameter& parameter : declared.space.parameters)
    EXPECT_NEAR(proposal_named(found, parameter.name).value, parameter.initial, 1e-9)
        << parameter.name;
}

TEST(StudyRobot, FindsRowsAndMirrorImagesByGeometry) {
  const ProposedParameters found = study(undeclared(example_robot("hexapod")));
  ASSERT_EQ(found.limbs.size(), 6u);
  for (std::size_t k = 0; k < 6; ++k) {
    EXPECT_EQ(found.limbs[k].row, static_cast<int>(k / 2));
    EXPECT_EQ(found.limbs[k].partner, static_cast<int>(k ^ 1));
    EXPECT_GT(found.limbs[k].home.y() * (k % 2 == 0 ? 1 : -1), 0.0);
  }
  EXPECT_EQ(proposal_named(found, "middle_femur_length").binding,
            "stretch link: ML_femur MR_femur");
  EXPECT_EQ(proposal_named(found, "hind_knee_axis_yaw").binding, "axis z: HL_knee ~HR_knee");
  for (const Proposal& proposal : found.proposals)  // MuJoCo writes those with one as CDATA
    EXPECT_EQ(proposal.sentence.find('\''), std::string::npos) << proposal.sentence;
}

TEST(StudyRobot, TiesTheLegsOfARobotThatFacesLeftAsThoseOfTheSameThatFacesAhead) {
  const std::string ahead_xml =
                        test::read_file(test::source_path("tests/robots/strider/robot.xml")),
                    left_xml = test::strider_to_the_left();
  const ProposedParameters ahead = study(ahead_xml), left = study(left_xml);
  ASSERT_EQ(left.proposals.size(), ahead.proposals.size());
  EXPECT_EQ(proposal_named(left, "front_femur_length").binding, "stretch link: LF_femur RF_femur");
  EXPECT_EQ(proposal_named(left, "hind_knee_axis_yaw").binding, "axis z: LH_knee ^RH_knee");
  EXPECT_EQ(proposal_named(left, "body_length").binding.substr(0, 10), "stretch y:");
  for (std::size_t k = 0; k < ahead.proposals.size(); ++k) {
    EXPECT_EQ(left.proposals[k].name, ahead.proposals[k].name);
    EXPECT_NEAR(left.proposals[k].value, ahead.proposals[k].value, 1e-9) << ahead.proposals[k].name;
  }
  const RobotModel straight =
                       parse_robot(with_declarations(ahead_xml, "r.xml", ahead.proposals), "r"),
                   turned = parse_robot(with_declarations(left_xml, "r.xml", left.proposals), "r");
  std::mt19937 random(5);
  for (int n = 0; n < 20; ++n) {
    const Eigen::VectorXd s = test::random_design(straight.space, random);
    const auto limbs = find_limbs(straight.morphology, s),
               others = find_limbs(turned.morphology, s, Eigen::Vector2d::UnitY());
    for (std::size_t k = 0; k < limbs.size(); ++k) {
      const Eigen::Vector3d& foot = limbs[k].home;
      EXPECT_LT((others[k].home - Eigen::Vector3d(-foot.y(), foot.x(), foot.z())).norm(), 1e-9)
          << k;
    }
  }
}

/// CAD programs put a robot's origin where its sketch began.
TEST(StudyRobot, PairsLegsWhereverTheFrameOfTheTrunkIs) {
  for (const char* name : {"puppy", "hexapod"}) {
    const std::string plain = undeclared(example_robot(name)),
                      moved = test::with_trunk_frame_at(plain, {0.21, -0.13, 0.0});
    const ProposedParameters here = study(plain), there = study(moved);
    ASSERT_EQ(there.proposals.size(), here.proposals.size()) << name;
    EXPECT_LT(std::abs(middle_of_sides(here.limbs, Across::y)), 1e-12);
    EXPECT_NEAR(middle_of_sides(there.limbs, Across::y), 0.13, 1e-6);
    for (std::size_t k = 0; k < here.proposals.size(); ++k) {
      EXPECT_EQ(there.proposals[k].name, here.proposals[k].name);
      EXPECT_EQ(there.proposals[k].binding, here.proposals[k].binding);
      EXPECT_NEAR(there.proposals[k].value, here.proposals[k].value, 1e-6);
    }
    const RobotModel a = parse_robot(with_declarations(plain, "r.xml", here.proposals), "r"),
                     b = parse_robot(with_declarations(moved, "r.xml", there.proposals), "r");
    std::mt19937 random(7);
    for (int n = 0; n < 10; ++n) {
      const Eigen::VectorXd s = test::random_design(a.space, random);
      const auto limbs = find_limbs(a.morphology, s), others = find_limbs(b.morphology, s);
      for (std::size_t k = 1; k < limbs.size(); ++k)
        EXPECT_LT((others[k].home - others[0].home - limbs[k].home + limbs[0].home).norm(), 1e-5)
            << name << " " << k;
    }
  }
}

TEST(StudyRobot, ALinkThatIsObliqueToItsRodByAHandsBreadthGrowsAlongTheRod) {
  const ProposedParameters found =
      study(test::read_file(test::source_path("tests/robots/wader/robot.xml")));
  const Proposal& shank = proposal_named(found, "front_shank_length");
  EXPECT_EQ(shank.binding, "stretch z: front_left_shank front_right_shank");
  EXPECT_NEAR(shank.value, 0.24, 1e-12);
  EXPECT_TRUE(shank.sentence.find("to the foot along z of its body") != std::string::npos)
      << shank.sentence;
}

TEST(StudyRobot, ProposesTheWidthOfBeamsThatCarryLegs) {
  const ProposedParameters found = study(undeclared(example_robot("hexapod")));
  EXPECT_EQ(proposal_named(found, "front_beam_width").binding, "stretch y: front_beam");
  EXPECT_NEAR(proposal_named(found, "middle_beam_width").value, 0.09, 1e-9);
  for (const Proposal& proposal : study(undeclared(example_robot("puppy"))).proposals)
    EXPECT_EQ(proposal.name.find("servo"), std::string::npos)
        << "no legs hang on a motor: " << proposal.name;
}

TEST(StudyRobot, TurnsAxesALittleWhereLegsReachToAllSides) {
  // The hexapod's legs swing and lift; all axes of the puppy's are lateral, so they must turn much
  // to leave their plane.
  EXPECT_LT(
      proposal_named(study(undeclared(example_robot("hexapod"))), "front_knee_axis_yaw").upper,
      0.5);
  EXPECT_GE(proposal_named(study(undeclared(example_robot("puppy"))), "front_knee_axis_yaw").upper,
            1.0);
}

TEST(StudyRobot, TiesNothingThatIsNoMirrorImage) {
  // One shank is longer than the other: no pair any more, so each leg speaks for itself.
  const std::string xml =
      test::with(undeclared(example_robot("quadruped")), "class=\"foot\" pos=\"0 0 -0.1\"",
                 "class=\"foot\" pos=\"0 0 -0.12\"");
  const ProposedParameters found = study(xml);
  for (const Proposal& proposal : found.proposals)
    EXPECT_TRUE(proposal.binding.find("FL_shank FR_shank") == std::string::npos)
        << proposal.binding;
  ASSERT_EQ(found.remarks.size(), 1u);  // that is rather a mistake
  EXPECT_TRUE(test::holds(found.remarks[0], "feet 'FL' and 'FR' would be mirror images"))
      << found.remarks[0];
  EXPECT_TRUE(study(undeclared(example_robot("quadruped"))).remarks.empty());
}

TEST(StudyRobot, TiesWhatTheFileDrawsAFewMillimetresApart) {
  const std::string xml =
      test::with(undeclared(example_robot("quadruped")), "class=\"foot\" pos=\"0 0 -0.1\"",
                 "class=\"foot\" pos=\"0 0 -0.103\"");
  const ProposedParameters found = study(xml);
  const Proposal& length = proposal_named(found, "front_shank_length");
  EXPECT_EQ(length.binding, "stretch link: FL_shank 0.970873786408*FR_shank");
  EXPECT_NEAR(length.value, 0.103, 1e-9);
  const RobotModel robot = parse_robot(with_declarations(xml, "r.xml", found.proposals), "r.xml");
  Eigen::VectorXd s = robot.space.initial();
  for (int k = 0; k < robot.space.size(); ++k)
    if (robot.space.parameters[static_cast<std::size_t>(k)].name == "front_shank_length")
      s[k] = 0.1236;  // a fifth longer, both
  const std::string text = rewrite_robot(robot, s);
  EXPECT_TRUE(test::holds(text, "-0.1236\"")) << text;
  EXPECT_TRUE(test::holds(text, "-0.12\"")) << text;
}

TEST(StudyRobot, ALengthOfAnUnnamedBodyNeedsItsName) {
  std::string xml = undeclared(example_robot("puppy"));
  for (const char* name : {" name=\"FL_thigh\"", " name=\"FR_thigh\""}) {
    const std::size_t at = xml.find(name);
    ASSERT_NE(at, std::string::npos);
    xml.erase(at, std::string(name).size());
  }
  const ProposedParameters found = study(xml);
  EXPECT_EQ(found.unnamed, (std::set<std::string>{"FL_hip", "FR_hip"}));
  const std::string named = with_named_bodies(xml, "r.xml", found.unnamed);
  const ProposedParameters again = study(named);
  EXPECT_TRUE(again.unnamed.empty());
  EXPECT_EQ(again.proposals.size(), study(undeclared(example_robot("puppy"))).proposals.size());
  EXPECT_TRUE(test::holds(named, "name=\"FL_hip\""));
}

/// A foot whose geom has no name takes one that can be said; bodies cannot.
TEST(StudyRobot, ABlankInTheNameOfABodyLeavesOutItsLengthAlone) {
  std::string xml = undeclared(example_robot("puppy"));
  for (const char* side : {"FL", "FR"})
    xml = test::with(xml, fmt::format("name=\"{}_thigh\"", side),
                     fmt::format("name=\"{} thigh &lt;1&gt;\"", side));
  const ProposedParameters found = study(xml);
  EXPECT_EQ(found.proposals.size() + 1, study(undeclared(example_robot("puppy"))).proposals.size());
  ASSERT_EQ(found.left_out.size(), study(undeclared(example_robot("puppy"))).left_out.size() + 1);
  const std::string all = fmt::format("{}", fmt::join(found.left_out, "\n"));
  EXPECT_TRUE(test::holds(all, "body 'FL thigh <1>': the name holds a blank")) << all;
}

TEST(StudyRobot, AnOffsetBetweenJointsIsNoLink) {
  const std::string xml =
      test::with(undeclared(example_robot("puppy")), "name=\"FL_shank\" pos=\"0 0 -0.06\"",
                 "name=\"FL_shank\" pos=\"0 0 -0.01\"");
  bool told = false;
  for (const std::string& line : study(xml).left_out)
    told = told || test::holds(line, "mm, an offset between two joints and no link") ||
           test::holds(line, "differ in length");
  EXPECT_TRUE(told);
}

TEST(StudyRobot, ProposesTheEndsOfPistons) {
  const ProposedParameters found = study(undeclared(example_robot("piston_puppy")));
  EXPECT_EQ(proposal_named(found, "front_piston_top_x").binding,
            "place x: FL_piston_top ~FR_piston_top");
  // Its links have the same frames where it is drawn to look along y.
  std::string turned = undeclared(example_robot("piston_puppy"));
  turned.insert(turned.find("/>", turned.find("<inertial")) + 2, "<frame quat=\"1 0 0 1\">");
  turned.insert(turned.rfind("</body>"), "</frame>");
  EXPECT_EQ(proposal_named(study(turned), "front_piston_top_x").binding,
            "place x: FL_piston_top ~FR_piston_top");
}

TEST(StudyRobot, EveryDesignWithinTheProposedBoundsCanBeWritten) {
  std::mt19937 random(7);
  for (const char* robot : {"puppy", "quadruped", "hexapod", "biped", "piston_puppy"}) {
    const std::string xml = undeclared(example_robot(robot));
    const std::string text = with_declarations(xml, "r.xml", study(xml).proposals);
    const RobotModel model = parse_robot(text, "r.xml");
    EXPECT_EQ(rewrite_robot(model, model.space.initial()), text) << robot;
    for (int k = 0; k < 5; ++k)
      EXPECT_NO_THROW(rewrite_robot(model, test::random_design(model.space, random))) << robot;
  }
}

TEST(StudyRobot, SaysWhyItLeavesOut) {
  const ProposedParameters biped = study(undeclared(example_robot("biped")));
  ASSERT_EQ(biped.left_out.size(), 1u);
  EXPECT_EQ(biped.left_out[0],
            "foot_length: the foot is a round sole, not the end of a leg of that length");
  // A general robot: whatever is proposed is accepted, whatever is not has a reason.
  for (const char* name : {"crooked", "crooked_piston", "crooked_printed"}) {
    const std::string xml = undeclared(test::named_robot(name));
    const ProposedParameters found = study(xml);
    EXPECT_NO_THROW(parse_robot(with_declarations(xml, "r.xml", found.proposals), "r.xml")) << name;
    for (const std::string& line : found.left_out) EXPECT_GT(line.size(), line.find(": ") + 10);
  }
}

/// A mesh that gives its body the weight keeps its size, and where it touches is no point of the
/// body.
TEST(StudyRobot, LeavesOutALengthThatAFootWithAWeightWouldNotFollow) {
  const auto lengths = [](bool weighs) {
    std::string xml = test::hopper_with(
        "<geom type=\"mesh\" mesh=\"shoe\" pos=\"0.03 0 -0.2\" euler=\"0 0.1 0\"/>");
    const std::size_t inertial = xml.rfind("<inertial");
    if (weighs) xml.erase(inertial, xml.find("/>", inertial) + 2 - inertial);
    const ProposedParameters found = study(xml);
    for (const std::string& line : found.left_out)
      EXPECT_NE(line.find("is a foot that gives its body"), std::string::npos) << line;
    return std::count_if(found.proposals.begin(), found.proposals.end(),
                         [](const Proposal& p) { return p.binding == "stretch link: shank"; });
  };
  EXPECT_EQ(lengths(true), 0);
  EXPECT_EQ(lengths(false), 1);
}

TEST(StudyRobot, ProposesNothingTwice) {
  const ProposedParameters found = study(example_robot("puppy"));
  EXPECT_TRUE(found.proposals.empty()) << found.proposals.front().name;
  EXPECT_EQ(found.model.space.size(), 20);
}

TEST(StudyRobot, RefusesWhatIsNoRobot) {
  EXPECT_THROW(study("<mujoco/>"), InputError);
  EXPECT_THROW(study("no xml"), InputError);
}

TEST(WithDeclarations, LeaveEveryOtherByte) {
  const std::string xml = undeclared(example_robot("puppy"));
  const ProposedParameters found = study(xml);
  std::string text = with_declarations(xml, "r.xml", found.proposals);
  EXPECT_EQ(undeclared(text), xml);
  EXPECT_NE(text, xml);
  EXPECT_EQ(with_declarations(xml, "r.xml", {}), xml);
}

TEST(WithDeclarations, UseTheSectionThatIsThere) {
  std::string xml = undeclared(example_robot("puppy"));
  xml.insert(xml.rfind("</mujoco>"),
             "  <custom>\n    <numeric name=\"own\" data=\"1\"/>\n  </custom>\n");
  const std::string text = with_declarations(xml, "r.xml", study(xml).proposals);
  EXPECT_EQ(text.find("<custom>"), text.rfind("<custom>"));
  EXPECT_NE(text.find("\n    <numeric name=\"own\""), std::string::npos);
  EXPECT_EQ(text.find("\n\n    <numeric"), std::string::npos);
  EXPECT_EQ(parse_robot(text, "r.xml").space.size(), 20);
}

TEST(WithDeclarations, KeepTheLineEndsOfTheFile) {
  std::string dos;
  for (const char c : undeclared(example_robot("puppy")))
    dos += c == '\n' ? "\r\n" : std::string(1, c);
  const std::string text = with_declarations(dos, "r.xml", study(dos).proposals);
  for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 1))
    ASSERT_EQ(text[at - 1], '\r') << text.substr(at > 60 ? at - 60 : 0, 60);
}

TEST(WithDeclarations, AreNotPutIntoAComment) {
  const std::string xml = undeclared(example_robot("puppy")) + "<!-- old: </mujoco> -->\n";
  const std::string text = with_declarations(xml, "r.xml", study(xml).proposals);
  EXPECT_EQ(parse_robot(text, "r.xml").space.size(), 20);
}

TEST(StudyRobot, FeetThatAreAHairApartShareARow) {
  const std::string xml =
      test::with(undeclared(example_robot("biped")), "name=\"L_thigh\" pos=\"0 0.04",
                 "name=\"L_thigh\" pos=\"1e-9 0.04");
  const ProposedParameters found = study(xml);
  EXPECT_EQ(found.limbs.back().row, 0);
  EXPECT_EQ(proposal_named(found, "thigh_length").unit, "m");
}

TEST(WithDeclarations, EscapeHostileNames) {
  const Proposal hostile{"a", 1, 0, 2, "m", "stretch x: <&\"", "Says <b>&\"."};
  const std::string text = with_declarations("<mujoco>\n</mujoco>\n", "r.xml", {hostile});
  EXPECT_NE(text.find("data=\"m | stretch x: &lt;&amp;&quot; | Says &lt;b>&amp;&quot;.\""),
            std::string::npos)
      << text;
}

}  // namespace
}  // namespace legwright
