// SPDX-License-Identifier: Apache-2.0
// A box of 1 m in Collada, in the ways that its faces may be written.
#pragma once

#include <fmt/format.h>

#include <string>

namespace legwright::test {

inline const char* const kCorners = "0 0 0 1 0 0 1 1 0 0 1 0 0 0 1 1 0 1 1 1 1 0 1 1";
/// Twelve triangles with a normal each, whose index comes second.
inline const std::string kTriangles =
    "<triangles count=\"12\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/>"
    "<input semantic=\"NORMAL\" source=\"#n\" offset=\"1\"/><p>0 9 2 9 1 9 0 9 3 9 2 9 "
    "4 9 5 9 6 9 4 9 6 9 7 9 0 9 1 9 5 9 0 9 5 9 4 9 1 9 2 9 6 9 1 9 6 9 5 9 "
    "2 9 3 9 7 9 2 9 7 9 6 9 3 9 0 9 4 9 3 9 4 9 7 9</p></triangles>";
inline const std::string kPolylist =
    "<polylist count=\"6\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/>"
    "<vcount>4 4 4 4 4 4</vcount><p>0 3 2 1 4 5 6 7 0 1 5 4 1 2 6 5 2 3 7 6 3 0 4 7</p></polylist>";
inline const std::string kPolygons =
    "<polygons count=\"6\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/>"
    "<p>0 3 2 1</p><p>4 5 6 7</p><p>0 1 5 4</p><p>1 2 6 5</p><p>2 3 7 6</p><p>3 0 4 7</p>"
    "</polygons>";
inline const char* const kShown = "<node><instance_geometry url=\"#box\"/></node>";

inline std::string collada(const std::string& faces, const std::string& nodes,
                           const std::string& asset = "") {
  return fmt::format(
      "<?xml version=\"1.0\"?>\n<COLLADA version=\"1.4.1\"><asset>{}</asset><library_geometries>"
      "<geometry id=\"box\"><mesh><source id=\"p\"><float_array id=\"a\" count=\"24\">{}"
      "</float_array><technique_common><accessor source=\"#a\" count=\"8\" stride=\"3\"/>"
      "</technique_common></source><vertices id=\"v\"><input semantic=\"POSITION\" source=\"#p\"/>"
      "</vertices>{}</mesh></geometry></library_geometries>"
      "<library_visual_scenes><visual_scene id=\"s\">{}</visual_scene></library_visual_scenes>"
      "</COLLADA>",
      asset, kCorners, faces, nodes);
}

}  // namespace legwright::test
