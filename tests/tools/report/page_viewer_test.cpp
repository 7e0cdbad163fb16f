// SPDX-License-Identifier: Apache-2.0
#include "tools/report/page_viewer.hpp"

#include "tests/tools/report/run_fixture.hpp"
#include "tests/tools/simulate/tiny_scene.hpp"
#include "tools/files/base64.hpp"
#include "tools/files/checksum.hpp"

namespace legwright {
namespace {

class PageViewerTest : public RunFixture {
 protected:
  void add_scenes() {
    write_file(run_ / "iterations/0000/scene.xml", TinyScene{}.xml());
    write_file(run_ / "result/scene.xml", TinyScene{.wag = 0.4}.xml());
  }
};

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size())
    ++found;
  return found;
}

TEST_F(PageViewerTest, ARunWithScenesHasBothBodiesInOneWellFormedPage) {
  add_scenes();
  const std::string text = page();
  expect_well_formed(text);
  EXPECT_TRUE(has(text, "class=\"turned\""));
  const std::string head = "id=\"legwright-scenes\">";
  const std::size_t from = text.find(head) + head.size();
  const Json scenes = Json::parse(text.substr(from, text.find("</script>", from) - from));
  ASSERT_EQ(scenes.size(), 2U);
  EXPECT_EQ(scenes[0]["name"], "before");
  EXPECT_EQ(scenes[1]["name"], "after");
  EXPECT_LT(text.size(), 3'000'000U);
}

TEST_F(PageViewerTest, MeshFilesAreDrawnWithTheirDents) {
  // A cube whose top is four triangles down to its middle; physics has its hull of twelve.
  write_file(run_ / "result/dent.obj",
             "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
             "v 0.5 0.5 0.5\nf 1 3 2\nf 1 4 3\nf 1 2 6\nf 1 6 5\nf 2 3 7\nf 2 7 6\nf 3 4 8\n"
             "f 3 8 7\nf 4 1 5\nf 4 5 8\nf 5 6 9\nf 6 7 9\nf 7 8 9\nf 8 5 9\n");
  std::string xml = TinyScene{}.xml();
  xml.insert(xml.find("<worldbody>"), "<asset><mesh name='dent' file='dent.obj'/></asset>");
  xml.insert(xml.find("<worldbody>") + 11, "<geom type='mesh' mesh='dent' pos='0 0 9'/>");
  write_file(run_ / "result/scene.xml", xml);
  const std::string text = page();
  const std::size_t from = text.find("\"faces\":\"") + 9;
  const std::size_t bytes = std::size_t{14} * 3 * sizeof(std::uint32_t);
  EXPECT_EQ(text.find('"', from) - from, (bytes + 2) / 3 * 4);
}

TEST_F(PageViewerTest, OnlyItsOwnScriptsMayRun) {
  add_scenes();
  const std::string text = page();
  const std::string open = "<script>";
  EXPECT_EQ(count(text, open), 2U);
  for (std::size_t at = 0; (at = text.find(open, at)) != std::string::npos;) {
    at += open.size();
    const std::string script = text.substr(at, text.find("</script>", at) - at);
    EXPECT_TRUE(has(text, "&#39;sha256-" + base64_of(sha256_bytes(script)) + "&#39;") ||
                has(text, "'sha256-" + base64_of(sha256_bytes(script)) + "'"));
  }
  EXPECT_FALSE(has(text, "unsafe-eval"));
  EXPECT_EQ(count(text, "script-src"), 1U);
}

TEST_F(PageViewerTest, WithoutScenesThereIsNoScriptAndNoPlaceForIt) {
  const std::string text = page();
  EXPECT_FALSE(has(text, "<script>"));
  EXPECT_FALSE(has(text, "class=\"turned\""));
  EXPECT_TRUE(has(text, "script-src &#39;none&#39;") || has(text, "script-src 'none'"));
}

TEST_F(PageViewerTest, ABrokenSceneIsToldAndTheOtherShown) {
  add_scenes();
  write_file(run_ / "iterations/0000/scene.xml", "<mujoco><worldbody/></mujoco>");
  const std::string text = page();
  expect_well_formed(text);
  EXPECT_TRUE(has(text, "the 3-D view leaves out before"));
  EXPECT_TRUE(has(text, "class=\"turned\""));
}

TEST(HarmlessScript, EndsNoElementAndNoSection) {
  EXPECT_EQ(harmless_script("a[b[0]]>1; x = '</script>'; y = '<!--'"),
            "a[b[0]] >1; x = '<\\/script>'; y = '<\\!--'");
}

}  // namespace
}  // namespace legwright
