// SPDX-License-Identifier: Apache-2.0
// Faults of a URDF are told with their line, joint or link, what was found and how to mend it, all
// at once; what MuJoCo's reader takes, and what others write into URDFs, passes.
#include "mjcf/urdf/check_urdf.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "mjcf/text/input_error.hpp"
#include "tests/mjcf/robots/robots.hpp"
#include "tests/mjcf/urdf/hopper.hpp"

namespace legwright {
namespace {

using test::kHopper;
using test::tells;

/// What the reader says of a URDF; empty: it takes it.
std::string refusal_of(const std::string& urdf) {
  try {
    test::made(urdf);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string of_changed(const std::string& from, const std::string& to) {
  return refusal_of(test::with(kHopper, from, to));
}

struct UrdfFault {
  std::string from, to, told;
};

void expect_told(const std::vector<UrdfFault>& faults) {
  for (const UrdfFault& each : faults)
    EXPECT_EQ(of_changed(each.from, each.to), "hopper.urdf:" + each.told) << each.to;
}

const std::string kTypes =
    "expected one of revolute, continuous, prismatic, fixed, floating, planar, spherical";
const std::string kComma = "is not a number; write a decimal point, and blanks between numbers";

TEST(CheckUrdf, NumbersThatAreNoneAreToldWithTheirLine) {
  expect_told({
      {"xyz=\"0.01 0 -0.12\"", "xyz=\"0.01 0 -0,12\"",
       "28: joint 'knee': attribute xyz of <origin>: '-0,12' " + kComma},
      {"mass value=\"0.3\"", "mass value=\"0,3\"",
       "15: link 'thigh': attribute value of <mass>: '0,3' " + kComma},
      {"upper=\"1.5\"", "upper=\"1,5\"",
       "20: joint 'hip': attribute upper of <limit>: '1,5' " + kComma},
      {"effort=\"4\" velocity=\"20\"", "effort=\"4\" velocity=\"2,5\"",
       "30: joint 'knee': attribute velocity of <limit>: '2,5' " + kComma},
      {"rgba=\"0.8 0.1 0.1 1\"", "rgba=\"0,8 0.1 0.1 1\"",
       "4: material 'red': attribute rgba of <color>: '0,8' " + kComma},
      {"size=\"0.2 0.1 0.04\"/></geometry><material", "size=\"0.2 0.1\"/></geometry><material",
       "10: link 'trunk': attribute size of <box>: '0.2 0.1' has 2 numbers, expected 3 with blanks "
       "between"},
      {"radius=\"0.02\"", "radius=\"0 1\"",
       "31: link 'toe': attribute radius of <sphere>: '0 1' has 2 numbers, expected 1"},
      {"radius=\"0.02\"", "radius=\"-1\"",
       "31: link 'toe': attribute radius of <sphere>: '-1' is below 0; write the length in "
       "metres"},
      {"<axis xyz=\"0 1 0\"/>\n    <limit lower", "<axis xyz=\"0 0 0\"/>\n    <limit lower",
       "19: joint 'hip': attribute xyz of <axis>: '0 0 0' has no direction; write the one in which "
       "the joint turns or slides, as 0 1 0"},
  });
}

/// CAD exporters write each attribute into a line of its own.
TEST(CheckUrdf, TheLineIsThatOfTheAttribute) {
  EXPECT_TRUE(tells(of_changed("<origin xyz=\"0.01 0 -0.12\"/>",
                               "\n<origin\n  rpy=\"0 0 0\"\n  xyz=\"0,01 0 -0.12\"/>"),
                    "hopper.urdf:31: joint 'knee': attribute xyz"));
}

TEST(CheckUrdf, SlipsInWordsAreToldWithTheWordThatWasMeant) {
  expect_told({
      {"rpy=\"0 0.1 0\"", "ryp=\"0 0.1 0\"",
       "18: joint 'hip': unknown attribute 'ryp' of <origin>; did you mean 'rpy'?"},
      {"<limit effort=\"4\"", "<limt effort=\"4\"",
       "30: joint 'knee': unknown element <limt> in <joint>; did you mean <limit>?"},
      {"<axis xyz=\"0 1 0\"/>\n    <limit lower", "<axs xyz=\"0 1 0\"/>\n    <limit lower",
       "19: joint 'hip': unknown element <axs> in <joint>; did you mean <axis>?"},
      {"<mass value=\"0.3\"/>", "<mas value=\"0.3\"/>",
       "15: link 'thigh': unknown element <mas> in <inertial>; did you mean <mass>?"},
      {"<mass value=\"0.3\"/>", "<mass Value=\"0.3\"/>",
       "15: link 'thigh': unknown attribute 'Value' of <mass>; did you mean 'value'?"},
      {"<sphere radius", "<shpere radius",
       "31: link 'toe': unknown element <shpere> in <geometry>; did you mean <sphere>?"},
      {"<collision><geometry><sphere", "<colision/><collision><geometry><sphere",
       "31: link 'toe': unknown element <colision> in <link>; did you mean <collision>?"},
      {"type=\"continuous\"", "type=\"continous\"",
       "28: joint 'knee': attribute type: 'continous' is no type of joint; did you mean "
       "'continuous'? " +
           kTypes},
      {"type=\"continuous\"", "type=\"screw\"",
       "28: joint 'knee': attribute type: 'screw' is no type of joint; " + kTypes},
  });
}

TEST(CheckUrdf, WhatIsMissingOrThereTwiceIsTold) {
  expect_told({
      {"<mass value=\"0.3\"/>", "",
       "15: link 'thigh': <inertial> has no <mass>; add <mass value=\"…\"/>"},
      {"<mass value=\"0.3\"/>", "<mass/>",
       "15: link 'thigh': <mass> has no attribute value; write <mass value=\"…\"/>"},
      {"<mass value=\"0.3\"/>", "<mass value=\" \"/>",
       "15: link 'thigh': <mass> has nothing in its attribute value; write <mass value=\"…\"/>"},
      {"<sphere radius=\"0.02\"/>", "",
       "31: link 'toe': <geometry> has no shape; write one of <box>, <cylinder>, <sphere>, "
       "<capsule>, <mesh>"},
      {"<sphere radius=\"0.02\"/>", "<plane normal=\"0 0 1\"/>",
       "31: link 'toe': <geometry> has <plane>, of which no shape is made; write one of <box>, "
       "<cylinder>, <sphere>, <capsule>, <mesh>"},
      {"<limit effort=\"4\"", "<limit/><limit effort=\"4\"",
       "30: joint 'knee': a second <limit> in one <joint>, which has one; remove one of them"},
      {"<parent link=\"thigh_plate\"/>", "",
       "28: joint 'knee': <joint> has no <parent>; add <parent link=\"…\"/>"},
  });
}

TEST(CheckUrdf, LinksHangTogether) {
  expect_told({
      {"<link name=\"shank\">", "<link name=\"shankk\">",
       "29: joint 'knee': child 'shank' is no <link> of this file; did you mean 'shankk', which no "
       "joint names?\n"
       "hopper.urdf:32: joint 'tip': parent 'shank' is no <link> of this file; did you mean "
       "'shankk', which no joint names?"},
      {"<child link=\"toe\"/>", "<child link=\"too\"/>",
       "32: joint 'tip': child 'too' is no <link> of this file; did you mean 'toe', which no joint "
       "names?"},
      {"<child link=\"toe\"/>", "<child link=\"wheel_of_steel\"/>",
       "32: joint 'tip': child 'wheel_of_steel' is no <link> of this file; mend the name, or write "
       "the link"},
      {"<child link=\"toe\"/>", "<child link=\"shank\"/>",
       "32: joint 'tip': child 'shank' hangs on joint 'knee' of line 28 already; a link hangs on "
       "one joint, mend the name or remove one of the joints"},
      {"<link name=\"toe\">", "<link name=\"toe\"/><link name=\"toe\">",
       "31: link 'toe': attribute name: the link in line 31 has it, too; give each its own"},
      {"<parent link=\"mount\"/>", "<parent link=\"toe\"/>",
       "29: joint 'knee': its links hang on each other in a circle (shank > toe > trunk > thigh > "
       "thigh_plate > shank); mend <parent> or <child> of one of their joints"},
  });
}

TEST(CheckUrdf, AllFaultsAreToldAtOnceInTheOrderOfTheFile) {
  std::string urdf = test::with(kHopper, "rpy=\"0 0.1 0\"", "ryp=\"0 0.1 0\"");
  urdf = test::with(urdf, "mass value=\"2\"", "mass value=\"2,0\"");
  urdf = test::with(urdf, "<child link=\"toe\"/>", "<child link=\"too\"/>");
  urdf = test::with(urdf, "<sphere radius=\"0.02\"/>", "<mesh filename=\"nowhere.stl\"/>");
  const std::string told = refusal_of(urdf);
  std::size_t at = 0;
  for (const char* each :
       {"hopper.urdf:8: link 'trunk': attribute value", "\nhopper.urdf:18: joint 'hip': unknown",
        "\nhopper.urdf:31: link 'toe': the mesh 'nowhere.stl'", "\nhopper.urdf:32: joint 'tip'",
        "\nhopper.urdf: note: "}) {
    const std::size_t found = told.find(each);
    ASSERT_NE(found, std::string::npos) << each << "\n" << told;
    EXPECT_GE(found, at) << told;
    at = found;
  }
}

/// What MuJoCo's reader takes today, and words of simulators and tools.
TEST(CheckUrdf, ExtensionsAndEmptyWordsPass) {
  const std::vector<std::pair<std::string, std::string>> kPassing{
      {"<dynamics damping=\"0.1\"", "<dynamics stiction=\"1\" damping=\"0.1\""},
      {"<axis xyz=\"0 1 0\"/>\n    <limit lower",
       "<axis xyz=\"0 1 0\"/><axis2 xyz=\"0 0 1\"/><calibration rising=\"0,0\"/>"
       "<safety_controller k_position=\"1\"/><drake:rotor_inertia value=\"1\"/><limit lower"},
      {"<link name=\"toe\">",
       "<gazebo reference=\"toe\"><lnk/><mu1>0,2</mu1></gazebo><transmission name=\"t\">"
       "<joint name=\"hip\"><hardwareInterface/></joint></transmission><sensor/><link name=\"toe\">"
       "<contact><lateral_friction value=\"1,0\"/></contact><verbose value=\"1\"/>"},
      {"<collision name=\"shell\">",
       "<collision name=\"shell\" group=\"1\"><contact_coefficients mu=\"0\"/><verbose/>"},
      {"<material name=\"red\"/></visual>",
       "<material name=\"red\"><texture filename=\"a.png\"/></material></visual>"},
      {"rpy=\"0 0.1 0\"", "rpy=\"\" quat_xyzw=\"0 0 0 1\""},
      {"xyz=\"0 0 -0.02\"", "xyz=\"+.0 0. -2E-2 \""},
      {"xyz=\"0 0 -0.02\"", "xyz=\"1e-400 0 -0.02\""},
      {"type=\"fixed\"><origin xyz=\"0 0 -0.13\"/>",
       "type=\"fixed\"><origin xyz=\"0 0 -0.13\"/><limit lower=\"a\"/><limit/><dynamics damping="
       "\"1,0\"/>"},
      {"<limit effort=\"4\"", "<limit lower=\"-inf\" upper=\"INF\" effort=\"4\""},
      {"<sphere radius=\"0.02\"/>", "<sphere radius=\"0.02\"/><mesh/><plane/>"},
  };
  for (const auto& [from, to] : kPassing) EXPECT_EQ(of_changed(from, to), "") << to;
}

TEST(CheckUrdf, AMimicOfANameThatIsNearlyThereIsRefused) {
  const std::string told =
      of_changed("<limit effort=\"4\"", "<mimic joint=\"hpi\"/><limit effort=\"4\"");
  EXPECT_EQ(told,
            "hopper.urdf:30: joint 'knee': attribute joint of <mimic>: 'hpi' is no joint of this "
            "file; did you mean 'hip'?");
}

}  // namespace
}  // namespace legwright
