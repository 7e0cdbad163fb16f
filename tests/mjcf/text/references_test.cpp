// SPDX-License-Identifier: Apache-2.0
#include "mjcf/text/references.hpp"

#include <gtest/gtest.h>

namespace legwright {
namespace {

/// Attributes by which the child of the root refers to a kind.
std::string found(const std::string& element, const std::string& kind) {
  const auto xml = load_xml("<mujoco>" + element + "</mujoco>", "robot.xml");
  std::string out;
  for_each_reference(*xml->root().FirstChildElement(), kind,
                     [&](const char* attribute, const char* name) {
                       out += std::string(attribute) + "=" + name + " ";
                     });
  return out;
}

TEST(References, AreFoundByEveryAttributeOfAKind) {
  EXPECT_EQ(found("<general site=\"a\" refsite=\"b\" joint=\"c\"/>", "site"), "site=a refsite=b ");
  EXPECT_EQ(found("<general slidersite=\"a\" cranksite=\"b\"/>", "site"),
            "cranksite=b slidersite=a ");
  EXPECT_EQ(found("<geom geom=\"g\" sidesite=\"s\"/>", "site"), "sidesite=s ");
  EXPECT_EQ(found("<pair geom1=\"a\" geom2=\"b\"/>", "geom"), "geom1=a geom2=b ");
  EXPECT_EQ(found("<contact subtree1=\"a\" body2=\"b\"/>", "body"), "body2=b subtree1=a ");
  EXPECT_EQ(found("<general jointinparent=\"a\"/>", "joint"), "jointinparent=a ");
}

TEST(References, ByTypeAndNameAreOfThatTypeAlone) {
  const std::string sensor =
      "<framepos objtype=\"xbody\" objname=\"a\" reftype=\"site\" refname=\"b\"/>";
  EXPECT_EQ(found(sensor, "body"), "objname=a ");
  EXPECT_EQ(found(sensor, "site"), "refname=b ");
  EXPECT_EQ(found(sensor, "geom"), "");
}

}  // namespace
}  // namespace legwright
