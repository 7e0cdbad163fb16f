// SPDX-License-Identifier: Apache-2.0
#include "tools/studio/access.hpp"

#include <fmt/format.h>
#include <sys/random.h>

#include <array>
#include <cerrno>
#include <string_view>
#include <system_error>
#include <utility>

namespace legwright {
namespace {

std::string random_token() {
  std::array<unsigned char, 16> bytes{};
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t got = ::getrandom(bytes.data() + done, bytes.size() - done, 0);
    if (got < 0 && errno != EINTR)
      throw std::system_error(errno, std::generic_category(), "no random numbers for a token");
    if (got > 0) done += static_cast<std::size_t>(got);
  }
  std::string text;
  for (const unsigned char byte : bytes) text += fmt::format("{:02x}", byte);
  return text;
}

/// Takes as long wherever the two differ.
bool same(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  unsigned differs = 0;
  for (std::size_t k = 0; k < a.size(); ++k)
    differs |= static_cast<unsigned char>(a[k]) ^ static_cast<unsigned char>(b[k]);
  return differs == 0;
}

/// The value of a cookie in the header "a=1; b=2", or nothing.
std::optional<std::string_view> cookie_value(std::string_view header, std::string_view name) {
  while (!header.empty()) {
    const std::size_t end = header.find(';');
    std::string_view pair = header.substr(0, end);
    header = end == std::string_view::npos ? std::string_view() : header.substr(end + 1);
    while (!pair.empty() && pair.front() == ' ') pair.remove_prefix(1);
    const std::size_t equals = pair.find('=');
    if (equals != std::string_view::npos && pair.substr(0, equals) == name)
      return pair.substr(equals + 1);
  }
  return std::nullopt;
}

bool has_body(const std::string& method) { return method != "GET" && method != "HEAD"; }

}  // namespace

AccessGate::AccessGate(int port, std::string token)
    : port_(port), token_(token.empty() ? random_token() : std::move(token)) {}

std::string AccessGate::url() const {
  return fmt::format("http://127.0.0.1:{}/?token={}", port_, token_);
}

std::string AccessGate::cookie_name() const { return fmt::format("legwright_studio_{}", port_); }

std::string AccessGate::cookie_header() const {
  return fmt::format("{}={}; HttpOnly; SameSite=Strict; Path=/", cookie_name(), token_);
}

bool AccessGate::token_fits(const std::string& token) const { return same(token, token_); }

std::optional<Refusal> AccessGate::check_origin(const RequestOrigin& request) const {
  const std::string numbers = fmt::format("127.0.0.1:{}", port_),
                    name = fmt::format("localhost:{}", port_);
  if (request.host != numbers && request.host != name)
    return Refusal{421, "this is no host of the studio; open the URL that the program printed"};
  if (!request.origin.empty() && request.origin != "http://" + request.host)
    return Refusal{403, "a page of another origin asks; only the studio's own may"};
  const std::string& site = request.fetch_site;
  if (!site.empty() && site != "same-origin" && site != "none")
    return Refusal{403, "a page of another site asks; only the studio's own may"};
  return std::nullopt;
}

std::optional<Refusal> AccessGate::check(const RequestOrigin& request) const {
  if (auto refusal = check_origin(request)) return refusal;
  const auto cookie = cookie_value(request.cookie, cookie_name());
  if (!cookie || !same(*cookie, token_))
    return Refusal{401, "this browser has not been let in; open the URL that the program printed"};
  if (has_body(request.method) && request.method != "DELETE" &&
      std::string_view(request.content_type).substr(0, request.content_type.find(';')) !=
          "application/json")
    return Refusal{415, "the body is no JSON; expected Content-Type: application/json"};
  return std::nullopt;
}

}  // namespace legwright
