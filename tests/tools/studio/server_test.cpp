// SPDX-License-Identifier: Apache-2.0
#include "tools/studio/server.hpp"
#include "tests/support/paths.hpp"

#include <gtest/gtest.h>

#include <arpa/inet.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <thread>
#include <vector>

#include "tests/mjcf/robots/robots.hpp"
#include "tests/mjcf/robots/split_robot.hpp"
#include "tests/tools/studio/browser.hpp"

namespace legwright {
namespace {

using test::Browser;
using test::OpenStudio;

class ServerTest : public testing::Test {
 protected:
  int status(const std::string& path, httplib::Headers more, bool let_in = true) {
    if (let_in) more.insert(studio_.browser->headers().begin(), studio_.browser->headers().end());
    const auto answer = studio_.browser->client().Get(path.c_str(), more);
    return answer ? answer->status : 0;
  }
  std::string here() const { return "127.0.0.1:" + studio_.browser->port(); }

  OpenStudio studio_;
};

TEST_F(ServerTest, TheTokenIsExchangedForACookieThatNoScriptReads) {
  httplib::Client client("127.0.0.1", studio_.server->port());
  const std::string url = studio_.server->url();
  const auto answer = client.Get(url.substr(url.find("/?")).c_str());
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->status, 303);
  EXPECT_EQ(answer->get_header_value("Location"), "/");
  const std::string cookie = answer->get_header_value("Set-Cookie");
  EXPECT_NE(cookie.find("HttpOnly"), std::string::npos);
  EXPECT_NE(cookie.find("SameSite=Strict"), std::string::npos);
  EXPECT_NE(cookie.find(studio_.browser->port()), std::string::npos) << "cookies know no ports";
  EXPECT_EQ(client.Get("/?token=00000000000000000000000000000000")->status, 401);
}

TEST_F(ServerTest, ListensOnTheLoopbackInterfaceAlone) {
  const int probe = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in other{};
  other.sin_family = AF_INET;
  other.sin_port = htons(static_cast<std::uint16_t>(studio_.server->port()));
  ::inet_pton(AF_INET, "127.0.0.2", &other.sin_addr);  // reaches what listens on all interfaces
  EXPECT_NE(::connect(probe, reinterpret_cast<sockaddr*>(&other), sizeof other), 0);
  ::close(probe);
}

TEST_F(ServerTest, EverythingNeedsTheCookie) {
  for (const char* path : {"/", "/app.js", "/api/start", "/api/events", "/api/mesh/00"})
    EXPECT_EQ(status(path, {}, false), 401) << path;
  EXPECT_EQ(
      status("/", {{"Cookie", "legwright_studio_" + studio_.browser->port() + "=guess"}}, false),
      401);
  EXPECT_EQ(status("/api/start", {}), 200);
  httplib::Client stranger("127.0.0.1", studio_.server->port());
  EXPECT_EQ(stranger.Post("/api/open", "{}", "application/json")->status, 401);
  EXPECT_EQ(stranger.Delete("/api/judge")->status, 401);
}

TEST_F(ServerTest, ForeignHostsOriginsAndSitesAreRefused) {
  EXPECT_EQ(status("/api/start", {{"Host", "evil.example"}}), 421);
  EXPECT_EQ(status("/api/start", {{"Host", "127.0.0.1:1"}}), 421);
  EXPECT_EQ(status("/api/start", {{"Host", "localhost:" + studio_.browser->port()}}), 200);
  EXPECT_EQ(status("/api/start", {{"Origin", "http://evil.example"}}), 403);
  EXPECT_EQ(status("/api/start", {{"Origin", "null"}}), 403);
  EXPECT_EQ(status("/api/start", {{"Origin", "http://" + here()}}), 200);
  for (const char* site : {"cross-site", "same-site"})
    EXPECT_EQ(status("/api/start", {{"Sec-Fetch-Site", site}}), 403) << site;
  for (const char* site : {"same-origin", "none"})
    EXPECT_EQ(status("/api/start", {{"Sec-Fetch-Site", site}}), 200) << site;
  const std::string url = studio_.server->url();
  EXPECT_EQ(status(url.substr(url.find("/?")), {{"Host", "evil.example"}}, false), 421)
      << "the token is for the studio's own host";
}

TEST_F(ServerTest, BodiesAreJsonAndBounded) {
  auto& client = studio_.browser->client();
  const auto& headers = studio_.browser->headers();
  const auto post = [&](const std::string& path, const std::string& body, const char* type) {
    const auto answer = client.Post(path.c_str(), headers, body, type);
    return answer ? answer->status : 0;
  };
  EXPECT_EQ(post("/api/command", "do=start", "application/x-www-form-urlencoded"), 415);
  EXPECT_EQ(post("/api/command", "{}", "text/plain"), 415);
  EXPECT_EQ(post("/api/command", "{", "application/json"), 400);
  EXPECT_EQ(post("/api/command", std::string(std::size_t{2} << 20, ' '), "application/json"), 413);
  EXPECT_EQ(post("/api/open", std::string(std::size_t{2} << 20, ' ') + "{}", "application/json"),
            400)
      << "robots may be bigger";
  EXPECT_EQ(post("/api/open", std::string(std::size_t{65} << 20, ' '), "application/json"), 413);
  const auto large = client.Post("/api/open", headers, std::string(std::size_t{65} << 20, ' '),
                                 "application/json");
  EXPECT_NE(large->body.find("more than 48 MB"), std::string::npos) << large->body;
  EXPECT_NE(large->body.find("by its path"), std::string::npos) << large->body;
}

/// The most memory that this process has had [bytes].
std::size_t most_memory() {
  rusage used{};
  ::getrusage(RUSAGE_SELF, &used);
  return static_cast<std::size_t>(used.ru_maxrss) << 10;
}

TEST_F(ServerTest, NoBodyOfAStrangerIsKeptOrUnfolded) {
  constexpr std::size_t kLarge = std::size_t{250} << 20;
  const std::size_t before = most_memory();
  const std::string blanks(std::size_t{1} << 20, ' ');
  const auto some = [&](std::size_t, std::size_t left, httplib::DataSink& sink) {
    return sink.write(blanks.data(), std::min(left, blanks.size()));
  };
  httplib::Client folding("127.0.0.1", studio_.server->port());
  folding.set_compress(true);
  EXPECT_TRUE(folding.Put("/api/job", kLarge, some, "application/json"));
  std::size_t sent = 0;
  const auto chunks = [&](std::size_t, httplib::DataSink& sink) {
    if (sent >= kLarge) sink.done();
    sent += blanks.size();
    return sent > kLarge || sink.write(blanks.data(), blanks.size());
  };
  httplib::Client stranger("127.0.0.1", studio_.server->port());
  (void)stranger.Put("/api/job", chunks, "application/json");  // it may be cut off
  EXPECT_EQ(status("/api/start", {}), 200);
  EXPECT_LT(most_memory(), before + (std::size_t{100} << 20));
}

TEST_F(ServerTest, WhatIsLeftOfARefusedBodyIsNoRequest) {
  auto& client = studio_.browser->client();
  client.set_keep_alive(true);
  const std::string hidden = "GET /api/start HTTP/1.1\r\nHost: " + here() + "\r\n\r\n";
  EXPECT_EQ(client.Post("/api/command", hidden, "application/json")->status, 401);
  const auto after = client.Get("/api/nothing", studio_.browser->headers());
  EXPECT_EQ(after->status, 404) << "the answer to what was hidden in the body before";
}

TEST_F(ServerTest, OtherMethodsAreRefused) {
  auto& client = studio_.browser->client();
  EXPECT_EQ(client.Put("/api/command", "{}", "application/json")->status, 405);
  EXPECT_EQ(client.Patch("/api/command", "{}", "application/json")->status, 405);
  EXPECT_EQ(client.Options("/api/command")->status, 405);
  EXPECT_EQ(studio_.browser->get("/api/judge")["status"], 404);
  EXPECT_EQ(studio_.browser->post("/api/start", Json::object())["status"], 404);
}

TEST_F(ServerTest, NoMorePagesThanThreadsAreFollowed) {
  std::vector<std::thread> followers;
  std::atomic<int> refused = 0, followed = 0;
  std::atomic<bool> end = false;
  for (int k = 0; k < 8; ++k)
    followers.emplace_back([&] {
      httplib::Client client("127.0.0.1", studio_.server->port());
      client.set_read_timeout(30);
      const auto answer = client.Get(
          "/api/events", studio_.browser->headers(),
          [&](const httplib::Response& response) {
            if (response.status == 200) ++followed;
            if (response.status == 429) ++refused;
            return response.status == 200;
          },
          [&](const char*, std::size_t) { return !end.load(); });
      (void)answer;  // how it ends does not matter
    });
  while (refused + followed < 8) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_EQ(followed, 4);
  EXPECT_EQ(refused, 4);
  EXPECT_EQ(status("/api/start", {}), 200) << "streams leave threads for requests";
  EXPECT_EQ(status("/api/room", {}), 429) << "which tells a page why";
  end = true;
  studio_.service.hub().notice("info", "wakes those who wait");
  for (std::thread& follower : followers) follower.join();
  studio_.service.hub().publish("state", "{}");
  // The server notices somewhat later than its clients that their streams have ended.
  const auto latest = std::chrono::steady_clock::now() + std::chrono::seconds(10);
  Json state = studio_.browser->next("state");
  while (state.is_null() && std::chrono::steady_clock::now() < latest)
    state = studio_.browser->next("state");
  EXPECT_FALSE(state.is_null()) << "a place is free again";
  int room = status("/api/room", {});
  while (room != 200 && std::chrono::steady_clock::now() < latest) room = status("/api/room", {});
  EXPECT_EQ(room, 200);
}

TEST_F(ServerTest, PathsOutsideOfTheRootsAreRefused) {
  Browser& browser = *studio_.browser;
  for (const char* path : {"/etc/passwd", "../../etc/passwd", "/", ""})
    EXPECT_EQ(browser.post("/api/open", {{"path", path}})["status"], 400) << path;
  std::filesystem::create_symlink("/etc", studio_.folder.path() / "link");
  EXPECT_EQ(browser.post("/api/open", {{"path", "link/passwd"}})["status"], 400);
  EXPECT_EQ(browser.post("/api/open", {{"path", test::kSidewaysTask}})["status"], 200)
      << "examples may be read";
  const std::string examples = test::source_dir() + "/examples/run";
  for (const std::string path : {"/tmp/elsewhere", "../elsewhere", examples.c_str()})
    for (const char* verb : {"/api/save", "/api/report", "/api/export", "/api/optimize"}) {
      const Json answer = browser.post(verb, {{"path", path}});
      EXPECT_EQ(answer["status"], 400) << verb << path;
      EXPECT_NE(answer["error"]["message"].get<std::string>().find("--roots"), std::string::npos);
    }
  const Json files = Json::array({{{"name", "../../robot.xml"}, {"base64", "AAAA"}}});
  EXPECT_EQ(browser.post("/api/open", {{"files", files}})["status"], 400);
}

TEST_F(ServerTest, WhatARobotNamesOutsideOfTheRootsIsRefused) {
  namespace fs = std::filesystem;
  const fs::path robot = test::write_package_puppy(studio_.folder.path() / "pkg");
  const auto open = [&] { return studio_.browser->post("/api/open", {{"path", robot.string()}}); };
  EXPECT_EQ(open()["status"], 200) << "beside its folder, below a root";
  const test::TemporaryFolder elsewhere;
  const fs::path moved = fs::canonical(elsewhere.path()) / "defaults.xml",
                 named = studio_.folder.path() / "pkg/common/defaults.xml";
  const auto expect_refused = [&] {
    const Json answer = open();
    EXPECT_EQ(answer["status"], 400);
    const std::string message = answer["error"]["message"].get<std::string>();
    for (const std::string& part :
         {"lies at " + moved.string(), std::string("outside of the folders that the studio may "),
          std::string("name its folder with --roots")})
      EXPECT_NE(message.find(part), std::string::npos) << message;
  };
  fs::rename(named, moved);
  fs::create_symlink(moved, named);
  expect_refused();
  fs::remove(named);
  test::put(robot, test::with(test::read_file(robot), "../common/defaults.xml", moved.string()));
  expect_refused();
  // Nor may a robot that declares nothing, for which the page asks what may change.
  std::string text = test::read_file(robot);
  const std::size_t begin = text.find("  <custom>"), end = text.find("</custom>\n");
  test::put(robot, text.erase(begin, end + 10 - begin));
  expect_refused();
}

TEST_F(ServerTest, NothingIsCompressedForABrowserOnThisMachine) {
  studio_.browser->client().set_decompress(false);
  for (const char* path : {"/", "/app.js", "/app.css", "/api/start", "/nothing"}) {
    httplib::Headers asked = studio_.browser->headers();
    asked.insert({"Accept-Encoding", "gzip, deflate, br"});
    const auto answer = studio_.browser->client().Get(path, asked);
    ASSERT_TRUE(answer) << path;
    EXPECT_FALSE(answer->has_header("Content-Encoding")) << path;
    EXPECT_EQ(answer->get_header_value("Content-Length"), std::to_string(answer->body.size()))
        << path;
  }
}

TEST_F(ServerTest, PagesComeWithAPolicyThatLetsInNothingElse) {
  const auto answer = studio_.browser->client().Get("/", studio_.browser->headers());
  ASSERT_EQ(answer->status, 200);
  EXPECT_NE(answer->get_header_value("Content-Security-Policy").find("default-src 'self'"),
            std::string::npos);
  EXPECT_EQ(answer->get_header_value("X-Content-Type-Options"), "nosniff");
  EXPECT_EQ(studio_.browser->get("/../CMakeLists.txt")["status"], 404);
  EXPECT_EQ(studio_.browser->get("/index.html")["status"], 200);
}

}  // namespace
}  // namespace legwright
