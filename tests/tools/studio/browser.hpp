// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "tests/support/paths.hpp"
#include "tests/tools/files/temporary_folder.hpp"
#include "tools/studio/server.hpp"
#include "tools/verbs/save_session.hpp"

// Behind Eigen: the resolver's headers, which it includes, define _res.
#include <httplib.h>

namespace legwright::test {

/// A browser that was let in, without a screen.
class Browser {
 public:
  explicit Browser(const std::string& url) {
    const std::size_t port = url.find(':', 7) + 1, slash = url.find('/', port);
    port_ = url.substr(port, slash - port);
    client_ = std::make_unique<httplib::Client>("127.0.0.1", std::stoi(port_));
    client_->set_read_timeout(120);
    const auto answer = client_->Get(url.substr(slash).c_str());
    if (!answer) return;  // tests of the studio find out
    const std::string cookie = answer->get_header_value("Set-Cookie");
    headers_ = {{"Cookie", cookie.substr(0, cookie.find(';'))}};
  }

  httplib::Client& client() { return *client_; }
  const httplib::Headers& headers() const { return headers_; }
  const std::string& port() const { return port_; }

  Json get(const std::string& path) {
    const auto answer = client_->Get(path.c_str(), headers_);
    return answer ? with_status(*answer) : Json{{"status", 0}};
  }
  Json post(const std::string& path, const Json& body) {
    const auto answer = client_->Post(path.c_str(), headers_, body.dump(), "application/json");
    if (!answer) return {{"status", 0}};
    Json told = with_status(*answer);
    revision_ = path == "/api/open" ? 0 : told.value("revision", revision_);
    return told;
  }
  Json remove(const std::string& path) {
    const auto answer = client_->Delete(path.c_str(), headers_);
    return answer ? with_status(*answer) : Json{{"status", 0}};
  }

  /// Follows events until one does. @return it, or null after `limit`
  Json follow(const std::function<bool(const std::string&, const Json&)>& enough,
              std::chrono::seconds limit = std::chrono::seconds(60),
              const std::string& path = "/api/events") {
    const auto end = std::chrono::steady_clock::now() + limit;
    std::string text;
    Json found = nullptr;
    httplib::Client stream("127.0.0.1", std::stoi(port_));
    stream.set_read_timeout(limit.count());
    stream.Get(path.c_str(), headers_, [&](const char* bytes, std::size_t count) {
      text.append(bytes, count);
      for (std::size_t stop; (stop = text.find("\n\n")) != std::string::npos;) {
        const std::string event = text.substr(0, stop);
        text.erase(0, stop + 2);
        const std::size_t line = event.find("\ndata: ");
        if (!event.starts_with("event: ") || line == std::string::npos) continue;
        Json data = Json::parse(event.substr(line + 7), nullptr, false);
        if (!enough(event.substr(7, line - 7), data)) continue;
        found = std::move(data);
        return false;
      }
      return std::chrono::steady_clock::now() < end;
    });
    return found;
  }
  Json next(const std::string& kind, const std::function<bool(const Json&)>& enough = nullptr) {
    return follow([&](const std::string& is, const Json& data) {
      return is == kind && (!enough || enough(data));
    });
  }
  /// The state once the last command is obeyed, nothing goes on and motions are solved.
  Json settled() {
    return next("state", [this](const Json& s) {
      return s["settled"] && s["phase"] == "idle" && s["revision"] >= revision_;
    });
  }

 private:
  static Json with_status(const httplib::Response& response) {
    Json json = Json::parse(response.body, nullptr, false);
    if (!json.is_object()) json = {{"body", response.body}};
    json["status"] = response.status;
    return json;
  }

  std::unique_ptr<httplib::Client> client_;
  httplib::Headers headers_;
  std::string port_;
  std::uint64_t revision_ = 0;  // that the last command was answered with
};

/// A studio with its server and a browser, in folders of its own.
struct OpenStudio {
  explicit OpenStudio(const std::string& path = {}, const std::string& program = {})
      : service({{folder.path()},
                 folder.path() / "state",
                 test::source_dir() + "/examples",
                 program,
                 [](const SessionRecord& record, const auto& run, bool force, const SavedFrom&) {
                   save_session(record, run, force);
                 }}) {
    if (!path.empty()) service.open(path);
    server = std::make_unique<StudioServer>(service, 0);
    browser = std::make_unique<Browser>(server->url());
  }

  TemporaryFolder folder;
  StudioService service;
  std::unique_ptr<StudioServer> server;
  std::unique_ptr<Browser> browser;
};

inline const std::string kSidewaysTask = test::source_dir() + "/examples/puppy/sideways.toml";

}  // namespace legwright::test
