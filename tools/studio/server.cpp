// SPDX-License-Identifier: Apache-2.0
#include "tools/studio/server.hpp"
#include "tools/files/parse_json.hpp"

#include <fmt/format.h>
#include <httplib.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>

#include "tools/files/io_error.hpp"
#include "tools/studio/access.hpp"
#include "tools/studio/page/page_bundle.hpp"

namespace legwright {
namespace {

using namespace std::chrono_literals;

constexpr int kStreams = 4;   // that follow events
constexpr int kThreads = 48;  // each connection holds one: streams, and six of each browser
constexpr std::size_t kBody = std::size_t{1} << 20, kUpload = std::size_t{64} << 20;
constexpr std::size_t kDropped = kUpload / 4 * 3;  // of files as base64
constexpr const char* kJson = "application/json";

RequestOrigin origin_of(const httplib::Request& request) {
  return {request.method,
          request.get_header_value("Host"),
          request.get_header_value("Origin"),
          request.get_header_value("Sec-Fetch-Site"),
          request.get_header_value("Cookie"),
          request.get_header_value("Content-Type")};
}

/// Sends bytes as they are. What set_content() takes is compressed for every browser, an answer of
/// 90 kB for 0.1 s, the page's scripts for 1.6 s: longer than this machine takes to copy them.
void send(httplib::Response& response, std::string_view bytes, const char* type,
          std::shared_ptr<const std::string> owner = nullptr) {
  if (bytes.empty()) return response.set_content("", type);
  response.set_content_provider(bytes.size(), type,
                                [bytes, owner = std::move(owner)](
                                    std::size_t from, std::size_t count, httplib::DataSink& sink) {
                                  return sink.write(bytes.data() + from, count);
                                });
}

void send_json(httplib::Response& response, std::shared_ptr<const std::string> json) {
  const std::string_view bytes = *json;
  send(response, bytes, kJson, std::move(json));
}

/// ?heard=: what a page had heard when it left another stream, so that it misses no notice.
std::optional<std::uint64_t> heard_so_far(const httplib::Request& request) {
  const std::string text = request.get_param_value("heard");
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

void refuse(httplib::Response& response, int status, const std::string& words) {
  response.status = status;
  const Json json{{"error", {{"where", ""}, {"message", words}, {"line", 0}}}};
  send_json(response, std::make_shared<const std::string>(to_line(json)));
}

/// A body as far as it was read.
struct ReadBody {
  std::string text;      // of one of at most so many bytes
  std::size_t size = 0;  // [bytes]
  bool whole = false;
};

/// Reads a body to its end, also where it is refused: else the rest of it would be taken for the
/// next request. Of one that is larger than any may be, as what unfolds or comes in chunks, no more
/// is read. @param most bytes that are kept
ReadBody read_body(const httplib::ContentReader& reader, std::size_t most) {
  ReadBody out;
  out.whole = reader([&](const char* bytes, std::size_t count) {
    out.size += count;
    if (out.size <= most) out.text.append(bytes, count);
    return out.size <= kUpload;
  });
  return out;
}

std::string event_text(const StudioEvent& event) {
  return fmt::format("event: {}\ndata: {}\n\n", event.kind, *event.json);
}

}  // namespace

struct StudioServer::Parts {
  Parts(StudioService& of, int port, const std::string& token) : studio(of) {
    http.new_task_queue = [] { return new httplib::ThreadPool(kThreads); };
    http.set_payload_max_length(kUpload);
    http.set_tcp_nodelay(true);
    http.set_keep_alive_max_count(100000);
    bound = port == 0 ? http.bind_to_any_port("127.0.0.1")
                      : (http.bind_to_port("127.0.0.1", port) ? port : -1);
    if (bound < 0)
      throw IoError(
          fmt::format("port {} of 127.0.0.1 is taken; leave --port out, or name another", port));
    gate = std::make_unique<AccessGate>(bound, token);
    http.set_default_headers({{"Content-Security-Policy",
                               "default-src 'self'; img-src 'self' blob: data:; "
                               "frame-ancestors 'none'; base-uri 'none'; form-action 'none'"},
                              {"X-Content-Type-Options", "nosniff"},
                              {"Referrer-Policy", "no-referrer"},
                              {"Cache-Control", "no-store"}});
    route();
    thread = std::thread([this] { http.listen_after_bind(); });
    while (!http.is_running()) std::this_thread::sleep_for(1ms);
  }

  void route() {
    http.Get("/", [this](const auto& request, auto& response) { front(request, response); });
    http.Get("/api/events",
             [this](const auto& request, auto& response) { events(request, response); });
    http.Get("/api/room", [this](const auto& request, auto& response) { room(request, response); });
    http.Get(R"(/api/mesh/([0-9a-f]+))",
             [this](const auto& request, auto& response) { mesh(request, response); });
    http.Get(R"(/api/.*)",
             [this](const auto& request, auto& response) { plain(request, response); });
    http.Get(R"(/(.+))", [this](const auto& request, auto& response) { file(request, response); });
    http.Post(R"(/.*)",
              [this](const httplib::Request& request, httplib::Response& response,
                     const httplib::ContentReader& reader) { post(request, response, reader); });
    // Handlers that read bodies themselves keep none of whoever sends them.
    http.Delete(R"(/.*)", [this](const httplib::Request& request, httplib::Response& response,
                                 const httplib::ContentReader& reader) {
      plain(request, response);
      (void)read_body(reader, 0);
    });
    const auto no_method = [](const httplib::Request&, httplib::Response& response) {
      refuse(response, 405, "the studio knows GET, POST and DELETE");
    };
    const auto no_method_with_body = [no_method](const httplib::Request& request,
                                                 httplib::Response& response,
                                                 const httplib::ContentReader& reader) {
      no_method(request, response);
      (void)read_body(reader, 0);
    };
    http.Put(R"(/.*)", no_method_with_body);
    http.Patch(R"(/.*)", no_method_with_body);
    http.Options(R"(/.*)", no_method);
  }

  /// Whether the request may be answered; if not, it is refused.
  bool let_in(const httplib::Request& request, httplib::Response& response) const {
    const auto refusal = gate->check(origin_of(request));
    if (refusal) refuse(response, refusal->status, refusal->words);
    return !refusal;
  }

  void front(const httplib::Request& request, httplib::Response& response) {
    if (request.has_param("token")) {
      const auto refusal = gate->check_origin(origin_of(request));
      if (refusal) return refuse(response, refusal->status, refusal->words);
      if (!gate->token_fits(request.get_param_value("token")))
        return refuse(response, 401, "this is no token of this studio; it has been started anew");
      response.set_header("Set-Cookie", gate->cookie_header());
      return response.set_redirect("/", 303);
    }
    send_file("index.html", request, response);
  }

  void file(const httplib::Request& request, httplib::Response& response) {
    send_file(request.matches[1], request, response);
  }

  void send_file(const std::string& name, const httplib::Request& request,
                 httplib::Response& response) {
    if (!let_in(request, response)) return;
    const auto found = page_file(name);
    if (!found) return refuse(response, 404, name + ": the studio has no such file");
    send(response, found->bytes, found->type);
  }

  void mesh(const httplib::Request& request, httplib::Response& response) {
    if (!let_in(request, response)) return;
    const auto found = studio.meshes().find(request.matches[1]);
    if (!found) return refuse(response, 404, "there is no such mesh");
    response.set_header("Cache-Control", "private, max-age=31536000, immutable");
    send_json(response, found);
  }

  void answer(const httplib::Request& request, httplib::Response& response, Json body) {
    StudioRequest asked{request.method, request.path, {}, std::move(body)};
    for (const auto& [key, value] : request.params) asked.query[key] = value;
    StudioReply reply = studio.answer(asked);
    response.status = reply.status;
    send_json(response, std::make_shared<const std::string>(std::move(reply.json)));
  }

  void plain(const httplib::Request& request, httplib::Response& response) {
    if (let_in(request, response)) answer(request, response, nullptr);
  }

  void post(const httplib::Request& request, httplib::Response& response,
            const httplib::ContentReader& reader) {
    const bool may = let_in(request, response);
    const std::size_t most = request.path == "/api/open" ? kUpload : kBody;
    const ReadBody body = read_body(reader, may ? most : 0);
    if (!may) return;
    if (!body.whole || body.size > most) {
      if (most == kBody)
        return refuse(response, 413, fmt::format("the body has more than {} bytes", most));
      return refuse(response, 413,
                    fmt::format("these files have more than {} MB in all; put them into a folder "
                                "below those of --roots, and open the robot there by its path",
                                kDropped >> 20));
    }
    Json json = parse_json(body.text);
    if (json.is_discarded()) return refuse(response, 400, "the body is no JSON");
    answer(request, response, std::move(json));
  }

  static void refuse_one_more(httplib::Response& response) {
    refuse(response, 429,
           fmt::format("{} pages follow this studio already: this one goes on once one of them is "
                       "closed",
                       kStreams));
  }

  /// Whether one more page could follow events. Browsers do not tell pages why a stream is refused.
  void room(const httplib::Request& request, httplib::Response& response) {
    if (!let_in(request, response)) return;
    if (streams.load() >= kStreams) return refuse_one_more(response);
    send_json(response, std::make_shared<const std::string>("{}"));
  }

  void events(const httplib::Request& request, httplib::Response& response) {
    if (!let_in(request, response)) return;
    if (streams.fetch_add(1) >= kStreams) {
      streams.fetch_sub(1);
      return refuse_one_more(response);
    }
    const std::uint64_t joined =
        std::min(heard_so_far(request).value_or(UINT64_MAX), studio.hub().now());
    response.set_chunked_content_provider(
        "text/event-stream",
        [this, joined, last = std::uint64_t{0}](std::size_t, httplib::DataSink& sink) mutable {
          if (studio.hub().closed()) return false;
          const auto told = studio.hub().after(last, joined, 2000ms);
          std::string text = told.empty() ? ": still here\n\n" : "";
          for (const StudioEvent& event : told) {
            text += event_text(event);
            last = event.number;
          }
          return sink.write(text.data(), text.size());
        },
        [this](bool) { streams.fetch_sub(1); });
  }

  StudioService& studio;
  httplib::Server http;
  std::unique_ptr<AccessGate> gate;
  std::atomic<int> streams = 0;
  int bound = -1;
  std::thread thread;
};

StudioServer::StudioServer(StudioService& studio, int port, const std::string& token)
    : parts_(std::make_unique<Parts>(studio, port, token)) {}

StudioServer::~StudioServer() { stop(); }

std::string StudioServer::url() const { return parts_->gate->url(); }

int StudioServer::port() const { return parts_->bound; }

void StudioServer::stop() {
  parts_->studio.hub().close();
  parts_->http.stop();
  if (parts_->thread.joinable()) parts_->thread.join();
}

}  // namespace legwright
