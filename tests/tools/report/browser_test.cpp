// SPDX-License-Identifier: Apache-2.0
// The pages in a real browser: headless Chromium, whose console stays empty, and nothing wider than
// a phone. Skipped, and said so, where there is no Chromium.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/tools/report/run_fixture.hpp"
#include "tests/tools/simulate/tiny_scene.hpp"
#include "tools/report/pair_report.hpp"

namespace legwright {
namespace {

namespace fs = std::filesystem;

/// Opens each page in frames as wide as a phone and a desk, unfolds everything, and writes down
/// what reaches beyond the frame and has no scroll bar of its own.
constexpr const char* kHarness = R"(<!DOCTYPE html><html><body><pre id="said"></pre><script>
const said = document.getElementById('said');
let left = 0;
function look(frame) {
  const page = frame.contentDocument;
  for (const fold of page.querySelectorAll('details')) fold.open = true;
  for (const one of page.body.querySelectorAll('*')) {
    const box = one.getBoundingClientRect();
    if (box.right <= frame.clientWidth + 1 || box.width === 0 || one.closest('.scroll')) continue;
    said.textContent += `WIDE ${frame.dataset.page} ${frame.clientWidth} ${one.tagName}.${one.className}\n`;
  }
  const turned = page.querySelector('.turned');
  if (turned) said.textContent += `TURNED ${frame.dataset.page} ${turned.querySelectorAll('canvas').length} ${turned.hidden}\n`;
  said.textContent += `LOOKED ${frame.dataset.page} ${frame.clientWidth} ${page.title.length > 0}\n`;
  if (--left === 0) said.textContent += 'DONE\n';
}
for (const page of PAGES) for (const width of [390, 1100]) {
  ++left;
  const frame = document.createElement('iframe');
  frame.dataset.page = page;
  frame.style.cssText = `border: 0; width: ${width}px; height: 900px`;
  frame.onload = () => look(frame);
  frame.src = page;
  document.body.appendChild(frame);
}
</script></body></html>
)";

class BrowserTest : public RunFixture {
 protected:
  void SetUp() override {
    RunFixture::SetUp();
    for (const char* name : {"chromium", "chromium-browser", "google-chrome"})
      if (browser_.empty() &&
          std::system(fmt::format("command -v {} >/dev/null 2>&1", name).c_str()) == 0)
        browser_ = name;
    if (browser_.empty())
      GTEST_SKIP()
          << "NOT LOOKED AT: no chromium on this machine, so no page was opened in a browser";
  }

  /// What the browser's page says in the end, and its console.
  struct Seen {
    std::string said, console;
  };
  Seen open(const std::vector<std::string>& pages) {
    std::string list;
    for (const std::string& page : pages) list += fmt::format("'{}',", page);
    std::string harness = kHarness;
    harness.replace(harness.find("PAGES"), 5, "[" + list + "]");
    write_file(run_ / "harness.html", harness);
    const std::string command = fmt::format(
        "timeout 120 {} --headless --no-sandbox --disable-dev-shm-usage "
        "--use-angle=swiftshader --enable-unsafe-swiftshader "
        "--allow-file-access-from-files --enable-logging=stderr --v=0 "
        "--host-resolver-rules='MAP * ~NOTFOUND' --user-data-dir='{}' --virtual-time-budget=20000 "
        "--dump-dom 'file://{}' >'{}' 2>'{}'",
        browser_, (run_ / "profile").string(), fs::absolute(run_ / "harness.html").string(),
        (run_ / "dom").string(), (run_ / "log").string());
    [[maybe_unused]] const int code = std::system(command.c_str());
    const std::string dom = read_file(run_ / "dom"), head = "<pre id=\"said\">";
    const std::size_t from = dom.find(head), to = dom.find("</pre>");
    started_ = from != std::string::npos && to != std::string::npos;
    Seen seen;
    if (started_) seen.said = dom.substr(from + head.size(), to - from - head.size());
    const std::string log = read_file(run_ / "log");
    for (std::size_t begin = 0; begin < log.size();) {
      const std::size_t end = std::min(log.find('\n', begin), log.size());
      const std::string line = log.substr(begin, end - begin);
      if (has(line, "CONSOLE")) seen.console += line + "\n";
      begin = end + 1;
    }
    return seen;
  }

  std::string browser_;
  bool started_ = false;
};

TEST_F(BrowserTest, ConsoleStaysEmptyAndNothingIsWiderThanAPhone) {
  add_pictures();
  edit("result/comparison.json", [](Json& file) { file["initial"] = file["result"]; });
  edit("result/verdict.json", [](Json& file) {
    file["result"]["limits"][0]["where"] = std::string(60, 'x');
    file["result"]["limits"][0]["what"] = std::string(120, 'y');
  });
  edit_run([](Json& run) {
    run["robot"] = std::string(80, 'x');
    run["parameters"][0]["name"] = run["task"]["gait"] = std::string(80, 'x');
  });
  write_report(run_);
  write_file(run_ / "pair.html", pair_page(read_pair(run_, run_)));
  write_file(run_ / "iterations/0000/scene.xml", TinyScene{}.xml());
  write_file(run_ / "result/scene.xml", TinyScene{}.xml());
  write_file(run_ / "turned.html", page());
  fs::remove_all(run_ / "result");
  fs::remove(run_ / "iterations/0000/scene.xml");
  write_file(run_ / "bare.html", page());
  const Seen seen = open({"report.html", "pair.html", "turned.html", "bare.html"});
  if (!started_) GTEST_SKIP() << "NOT LOOKED AT: " << browser_ << " does not start here";
  EXPECT_TRUE(has(seen.said, "DONE")) << seen.said;
  EXPECT_FALSE(has(seen.said, "WIDE")) << seen.said;
  for (const char* page : {"report.html 390 true", "pair.html 1100 true", "bare.html 390 true"})
    EXPECT_TRUE(has(seen.said, std::string("LOOKED ") + page)) << page;
  EXPECT_TRUE(has(seen.said, "TURNED turned.html 1 false")) << seen.said;
  EXPECT_FALSE(has(seen.said, "TURNED report.html"));
  EXPECT_EQ(seen.console, "");
}

TEST_F(BrowserTest, APageThatDoesNotKeepTheRulesIsSeen) {
  std::string page = this->page();
  page.insert(page.find("</main>"),
              "<p style=\"width: 900px\">wide</p><script>alert(1)</script>"
              "<img src=\"https://example.org/x.png\" alt=\"\"/>");
  write_file(run_ / "poisoned.html", page);
  const Seen seen = open({"poisoned.html"});
  if (!started_) GTEST_SKIP() << "NOT LOOKED AT: " << browser_ << " does not start here";
  EXPECT_TRUE(has(seen.said, "WIDE poisoned.html 390 P."));
  EXPECT_FALSE(has(seen.said, "WIDE poisoned.html 1100"));
  EXPECT_TRUE(has(seen.console, "Content Security Policy")) << seen.console;
}

}  // namespace
}  // namespace legwright
