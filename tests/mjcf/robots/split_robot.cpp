// SPDX-License-Identifier: Apache-2.0
#include "tests/mjcf/robots/split_robot.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <fstream>

#include "tests/mjcf/robots/robots.hpp"

namespace legwright::test {
namespace {

namespace fs = std::filesystem;

constexpr int kFaces[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};

/// Takes the bytes from the first `from` to behind the next `to` out and puts `instead` there.
std::string cut(std::string& text, const std::string& from, const std::string& to,
                const std::string& instead) {
  const std::size_t begin = text.find(from), end = text.find(to, begin);
  EXPECT_NE(begin, std::string::npos) << from;
  EXPECT_NE(end, std::string::npos) << to;
  const std::string out = text.substr(begin, end + to.size() - begin);
  text.replace(begin, out.size(), instead);
  return out;
}

std::string bytes_of(const std::string& hex) {
  std::string bytes;
  for (std::size_t k = 0; k < hex.size(); k += 2)
    bytes += static_cast<char>(std::stoi(hex.substr(k, 2), nullptr, 16));
  return bytes;
}

void append(std::string& bytes, float value) {
  char raw[4];
  std::memcpy(raw, &value, 4);
  bytes.append(raw, 4);
}

}  // namespace

void put(const fs::path& file, const std::string& bytes) {
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << bytes;
}

std::string tetrahedron_stl(float size) {
  std::string bytes(80, '\0');
  bytes += std::string("\4\0\0\0", 4);
  for (const auto& face : kFaces) {
    for (int k = 0; k < 3; ++k) append(bytes, 0.0f);
    for (const int corner : face)
      for (int k = 0; k < 3; ++k) append(bytes, corner == k + 1 ? size : 0.0f);
    bytes += std::string(2, '\0');
  }
  return bytes;
}

std::string tetrahedron_obj() {
  std::string text = "v 0 0 0\nv 0.02 0 0\nv 0 0.02 0\nv 0 0 0.02\n";
  for (const auto& face : kFaces) {
    text += "f";
    for (const int corner : face) text.append(" ").append(std::to_string(corner + 1));
    text += "\n";
  }
  return text;
}

std::string one_pixel_png() {
  return bytes_of(
      "89504e470d0a1a0a0000000d49484452000000010000000108060000001f15c4890000000d4944415478da63"
      "64f8cf500f00038601805a347d6b0000000049454e44ae426082");
}

std::string four_pixel_png() {
  return bytes_of(
      "89504e470d0a1a0a0000000d494844520000000200000002080000000057dd52f8000000114944415478010106"
      "00f9ff0000ff00ff00060001ff0ca335e40000000049454e44ae426082");
}

fs::path write_split_puppy(const fs::path& folder) {
  std::string dog = read_file(puppy_file());
  const std::string head = "<!-- SPDX-License-Identifier: Apache-2.0 -->\n";
  const auto included = [&](const std::string& content) {
    return head + "<mujocoinclude>\n" + content + "\n</mujocoinclude>\n<!-- the end -->\n";
  };
  put(folder / "parts/defaults.xml",
      included(cut(dog, "  <default>\n    <!-- The skin", "\n  </default>\n",
                   "  <include file=\"parts/defaults.xml\"/>\n")));
  std::string leg = cut(dog, "      <body name=\"FL_thigh\"", "\n      </body>",
                        "      <include file='parts/front_left.xml'></include><!-- FL -->");
  const std::string shank = cut(leg, "        <body name=\"FL_shank\"", "\n        </body>",
                                "<include file=\"parts/nowhere/../shank.xml\"/>");
  put(folder / "parts/front_left.xml", included(leg));
  put(folder / "parts/shank.xml", "<mujoco model=\"of no account\">" + shank + "</mujoco>");
  put(folder / "parts/drives.xml",
      included(cut(dog, "  <actuator>", "</keyframe>", "<include file=\"parts/drives.xml\"/>")));
  dog = with(dog, "autolimits=\"true\"/>",
             "autolimits=\"true\" meshdir=\"assets\" texturedir=\"assets/pictures/\"/>");
  dog = with(dog, "  <asset>\n",
             "  <asset>\n    <mesh name=\"ear\" file=\"ear.stl\"/>\n"
             "    <mesh file=\"./nose.obj\"/>\n"
             "    <texture name=\"fur\" type=\"2d\" file=\"fur.png\"/>\n"
             "    <material name=\"fur\" texture=\"fur\"/>\n");
  dog = with(dog, "<body name=\"eyes\" pos=\"0.095 0 0\">\n",
             "<body name=\"eyes\" pos=\"0.095 0 0\">\n"
             "        <geom type=\"mesh\" mesh=\"ear\" pos=\"0 0.02 0.02\"/>\n"
             "        <geom type=\"mesh\" mesh=\"nose\" pos=\"0.02 0 0\" material=\"fur\"/>\n");
  put(folder / "assets/ear.stl", tetrahedron_stl(0.03f));
  put(folder / "assets/nose.obj", tetrahedron_obj());
  put(folder / "assets/pictures/fur.png", one_pixel_png());
  put(folder / "dog.xml", dog);
  return folder / "dog.xml";
}

fs::path write_package_puppy(const fs::path& folder) {
  const fs::path home = folder / "mjcf";
  std::string dog = read_file(write_split_puppy(home));
  fs::rename(home / "assets/pictures", folder / "textures");
  fs::rename(home / "assets", folder / "meshes");
  fs::rename(home / "parts", folder / "common");
  fs::remove(home / "dog.xml");
  dog = with(dog, "meshdir=\"assets\" texturedir=\"assets/pictures/\"",
             "meshdir=\"../meshes\" texturedir=\"../textures\"");
  for (const char* part : {"defaults", "front_left", "drives"})
    dog = with(dog, std::string("parts/") + part, std::string("../common/") + part);
  const fs::path leg = folder / "common/front_left.xml";
  put(leg, with(read_file(leg), "parts/nowhere/../shank.xml", "shank.xml"));
  dog = with(dog, "    <mesh file=\"./nose.obj\"/>\n",
             "    <mesh file=\"nose.obj\"/>\n"
             "    <mesh name=\"muzzle\" file=\"../mjcf/meshes/nose.obj\"/>\n");
  dog = with(dog, "<geom type=\"mesh\" mesh=\"ear\"",
             "<geom type=\"mesh\" mesh=\"muzzle\" pos=\"0.01 0 0\"/>\n"
             "        <geom type=\"mesh\" mesh=\"ear\"");
  put(home / "meshes/nose.obj", with(tetrahedron_obj(), "v 0.02 0 0", "v 0.03 0 0"));
  put(home / "robot.xml", dog);
  return home / "robot.xml";
}

}  // namespace legwright::test
