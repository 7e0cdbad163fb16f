// SPDX-License-Identifier: Apache-2.0
#include "tests/mjcf/robots/robots.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <regex>

#include "tests/mjcf/robots/mjcf_builder.hpp"
#include "tests/mjcf/robots/shifted_robot.hpp"
#include "tests/support/paths.hpp"

namespace legwright::test {

std::filesystem::path source_path(const std::string& relative) {
  return std::filesystem::path(test::source_dir()) / relative;
}

std::string read_file(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  EXPECT_TRUE(stream) << file;
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::filesystem::path puppy_file() { return source_path("examples/puppy/robot.xml"); }

std::string example_robot(const std::string& name) {
  return read_file(source_path("examples/" + name + "/robot.xml"));
}

std::string undeclared(std::string xml) {
  const std::size_t from = xml.find("  <custom>"), to = xml.find("</custom>\n", from);
  if (from != std::string::npos) xml.erase(from, to + 10 - from);
  return xml;
}

std::string with(std::string text, const std::string& old_part, const std::string& new_part) {
  const std::size_t at = text.find(old_part);
  EXPECT_NE(at, std::string::npos) << old_part;
  return at == std::string::npos ? text : text.replace(at, old_part.size(), new_part);
}

Eigen::VectorXd random_design(const DesignSpace& space, std::mt19937& random) {
  Eigen::VectorXd s(space.size());
  for (int k = 0; k < space.size(); ++k)
    s[k] = std::uniform_real_distribution<double>(space.parameters[k].lower,
                                                  space.parameters[k].upper)(random);
  return s;
}

std::string crooked_robot() {
  return R"(<mujoco model="crooked">
  <compiler angle="degree" autolimits="true" eulerseq="XYZ"/>
  <default>
    <geom contype="0" conaffinity="0"/>
    <default class="lamp"><site pos="0.01 0.02 -0.03" size="0.004"/></default>
  </default>
  <worldbody>
    <body name="trunk" pos="0 0 0.5" euler="0 0 30">
      <freejoint/>
      <inertial pos="0.01 0.02 -0.01" mass="2" euler="10 20 30" diaginertia="0.02 0.03 0.04"/>
      <geom type="box" size="0.1 0.08 0.02" euler="0 0 90"/>
      <body name="bracket" pos="0.1 0.05 0.01" euler="0 15 0">
        <inertial pos="0 0.01 0" mass="0.1" diaginertia="1e-5 1e-5 1e-5"/>
        <geom size="0.01"/>
        <body name="upper" pos="0.02 0 0" quat="0.9 0.1 0.2 0.3">
          <joint name="swing" axis="1 0 0.2" pos="0.006 -0.008 0"/>
          <joint name="lift" axis="0 2 0" pos="0.01 0 0.002" range="-120 120"/>
          <inertial pos="0.02 0.01 -0.1" mass="0.3"
                    fullinertia="0.002 0.0021 0.0003 0.0001 -0.0002 0.00005"/>
          <geom type="capsule" fromto="0.01 0 0.002 0.05 0.03 -0.198" size="0.01"/>
          <site name="lamp" class="lamp"/>
          <camera name="eye" pos="0.03 0 -0.05"/>
          <body name="lower" pos="0.05 0.03 -0.198" euler="0 0 20">
            <joint name="knee" axis="0 1 0"/>
            <inertial pos="0 0 -0.08" mass="0.2" diaginertia="0.001 0.001 0.0001"/>
            <geom type="box" pos="0 0 -0.1" size="0.01 0.01 0.1"/>
            <geom name="toe" type="sphere" size="0.02" pos="0.01 0 -0.2"
                  contype="1" conaffinity="1"/>
          </body>
        </body>
      </body>
      <body name="other" pos="-0.1 -0.07 0">
        <joint name="swing2" axis="1 0 0"/>
        <inertial pos="0 0 -0.1" mass="0.2" diaginertia="0.001 0.001 0.0001"/>
        <geom name="ball" type="sphere" size="0.02" pos="0 0 -0.3" contype="1" conaffinity="1"/>
      </body>
    </body>
  </worldbody>
  <actuator>
    <motor joint="swing" gear="2" ctrlrange="-1.5 1.5"/>
    <position joint="lift" kp="30" kv="0.5" forcerange="-4 5"/>
    <position joint="knee" kp="20" gear="-3"/>
    <general joint="swing2" forcerange="-6 6"/>
  </actuator>
  <custom>)" +
         declarations({
             {"upper_length", "0.2061552812808830 0.1 0.3",
              "m | stretch link: upper | Length of the upper link."},
             {"lower_length", "0.2 0.1 0.3", "m | stretch z: lower | Height of the lower link."},
             {"body_length", "0.2 0.1 0.3", "m | stretch x: trunk | Length of the body."},
             {"body_width", "0.12 0.1 0.3", "m | stretch y: trunk | Width of the body."},
             {"lift_yaw", "0.3 -1 1", "rad | axis z: lift ~swing2 | Yaw of two axes."},
             {"lift_roll", "-0.2 -1 1", "rad | axis x: lift knee | Roll of two axes."},
         }) +
         R"(
    <numeric name="other/number" data="1 2"/>
  </custom>
</mujoco>
)";
}

std::string crooked_piston_robot() {
  std::string xml = crooked_robot();
  // Over the knee, and from a fixed bracket to the other leg.
  xml = with(xml, "<camera name=\"eye\"",
             "<site name=\"knee_top\" pos=\"0.06 0.01 -0.08\"/><camera name=\"eye\"");
  xml = with(xml, "<geom type=\"box\" pos=\"0 0 -0.1\"",
             "<site name=\"knee_foot\" pos=\"0.03 -0.01 -0.05\"/>"
             "<geom type=\"box\" pos=\"0 0 -0.1\"");
  xml = with(xml, "<body name=\"other\"",
             "<body name=\"hook\" pos=\"-0.1 -0.02 0.02\" euler=\"10 0 40\">"
             "<geom size=\"0.005\" density=\"0\"/><site name=\"hook\" pos=\"0.01 0 0\"/></body>"
             "<body name=\"other\"");
  xml = with(xml, "<geom name=\"ball\"",
             "<site name=\"other_foot\" pos=\"0.01 0.02 -0.1\"/><geom name=\"ball\"");
  xml = with(xml, "<actuator>",
             "<tendon><spatial name=\"at_knee\" range=\"0.01 0.5\">"
             "<site site=\"knee_foot\"/><site site=\"knee_top\"/></spatial>"
             "<spatial name=\"at_other\"><site site=\"hook\"/><site site=\"other_foot\"/>"
             "</spatial></tendon>\n  <actuator>");
  xml = with(xml, "<position joint=\"knee\" kp=\"20\" gear=\"-3\"/>",
             "<position tendon=\"at_knee\" kp=\"20000\" kv=\"200\" gear=\"-3\"/>");
  xml = with(xml, "<general joint=\"swing2\" forcerange=\"-6 6\"/>",
             "<general tendon=\"at_other\" forcerange=\"-60 60\"/>");
  xml = with(xml, "| axis z: lift ~swing2 |", "| axis z: lift 0.5*~swing2 |");
  return with(xml, "<numeric name=\"other/number\"",
              "<numeric name=\"legwright/end_z\" data=\"-0.05 -0.07 -0.03\"/>"
              "<text name=\"legwright/end_z\" data=\"m | place z: knee_foot 2*other_foot | z\"/>"
              "<numeric name=\"legwright/end_y\" data=\"0.01 0.005 0.015\"/>"
              "<text name=\"legwright/end_y\" data=\"m | place y: ~knee_foot | y\"/>"
              "<numeric name=\"legwright/hook_x\" data=\"0.01 0.005 0.015\"/>"
              "<text name=\"legwright/hook_x\" data=\"m | place x: hook | x\"/>"
              "<numeric name=\"other/number\"");
}

std::string crooked_printed_robot() {
  std::string xml = crooked_robot();
  xml = with(xml,
             "<inertial pos=\"0.01 0.02 -0.01\" mass=\"2\" euler=\"10 20 30\" "
             "diaginertia=\"0.02 0.03 0.04\"/>\n",
             "<geom type=\"capsule\" fromto=\"-0.1 0.05 0 0.1 0.05 0\" size=\"0.012\" "
             "density=\"700\"/>\n"
             "<geom type=\"cylinder\" fromto=\"0.02 -0.06 0.01 0.02 0.04 0.01\" size=\"0.01\"/>\n"
             "<geom type=\"cylinder\" fromto=\"0.02 0.01 -0.05 0.02 0.01 0.01\" size=\"0.01\"/>\n"
             "<geom type=\"capsule\" pos=\"0.03 0.02 0\" euler=\"20 30 0\" size=\"0.01 0.03\"/>\n"
             "<geom type=\"ellipsoid\" pos=\"-0.04 0.02 0.03\" euler=\"0 30 10\" "
             "size=\"0.01 0.02 0.03\" mass=\"0.15\"/>\n"
             "<geom type=\"box\" pos=\"0.04 0 0.03\" euler=\"0 30 0\" size=\"0.01 0.02 0.03\"/>\n");
  xml = with(xml,
             "<inertial pos=\"0.02 0.01 -0.1\" mass=\"0.3\"\n                    "
             "fullinertia=\"0.002 0.0021 0.0003 0.0001 -0.0002 0.00005\"/>\n",
             "<geom size=\"0.013\" pos=\"0.02 0.01 -0.1\" density=\"2000\"/>\n");
  return with(xml,
              "<inertial pos=\"0 0 -0.08\" mass=\"0.2\" diaginertia=\"0.001 0.001 0.0001\"/>\n",
              "<geom type=\"box\" size=\"0.1 0.1 0.1\" density=\"0\"/>\n");
}

std::vector<std::filesystem::path> taken_robots() {
  std::vector<std::filesystem::path> out;
  for (const auto& entry : std::filesystem::directory_iterator(source_path("tests/robots")))
    if (entry.path().filename() != "tailor" && std::filesystem::exists(entry.path() / "robot.xml"))
      out.push_back(entry.path() / "robot.xml");
  std::sort(out.begin(), out.end());
  return out;
}

std::string strider_to_the_left() {
  const std::string xml = read_file(source_path("tests/robots/strider/robot.xml"));
  static const std::regex hip(R"re(_coxa" pos="(\S+) (\S+) (\S+)" euler="0 0 (\S+)">)re");
  std::string out;
  auto rest = xml.cbegin();
  for (std::sregex_iterator at(xml.begin(), xml.end(), hip), end; at != end; ++at) {
    out.append(rest, (*at)[0].first);
    out += fmt::format(R"(_coxa" pos="{} {} {}" euler="0 0 {}">)", -std::stod((*at)[2]),
                       (*at)[1].str(), (*at)[3].str(), std::stod((*at)[4]) + M_PI / 2);
    rest = (*at)[0].second;
  }
  return out.append(rest, xml.cend());
}

std::string strider_in_axes(const std::string& frame, const std::string& inertial) {
  std::string out =
      with(read_file(source_path("tests/robots/strider/robot.xml")),
           R"(<inertial pos="0 0 0.01" mass="2.4" diaginertia="0.00562 0.0185 0.02312"/>)",
           fmt::format("<inertial mass=\"2.4\" {}/><frame quat=\"{}\">", inertial, frame));
  return out.insert(out.rfind("</body>"), "</frame>");
}

std::string strider_with_y_up() {
  return strider_in_axes("1 -1 0 0", R"(pos="0 0.01 0" diaginertia="0.00562 0.02312 0.0185")");
}

std::string named_robot(const std::string& name) {
  if (name == "puppy" || name == "piston_puppy") return example_robot(name);
  if (name == "crooked_printed") return crooked_printed_robot();
  if (name == "crooked_weighed")  // its capsules' weight is told by `mass`
    return with(crooked_printed_robot(), "size=\"0.012\" density=\"700\"",
                "size=\"0.012\" mass=\"0.07\"");
  if (const std::string prefix = "shifted_"; name.starts_with(prefix))
    return shifted_robot(named_robot(name.substr(prefix.size())));
  return name == "crooked" ? crooked_robot() : crooked_piston_robot();
}

}  // namespace legwright::test
