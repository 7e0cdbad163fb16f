// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

namespace legwright {

/// What of a request says who sends it.
struct RequestOrigin {
  std::string method;        // "GET", …
  std::string host;          // header Host
  std::string origin;        // header Origin, empty where there is none
  std::string fetch_site;    // header Sec-Fetch-Site, likewise
  std::string cookie;        // header Cookie
  std::string content_type;  // header Content-Type
};

/// Why a request is not answered.
struct Refusal {
  int status = 403;
  std::string words;
};

/// Who may talk to the server: a browser on this machine that was given the token, and pages of the
/// server itself. Requests that other pages of that browser send are refused.
class AccessGate {
 public:
  /// @param token empty: 128 bits by the system's generator
  explicit AccessGate(int port, std::string token = {});

  const std::string& token() const { return token_; }
  /// What the program prints: http://127.0.0.1:PORT/?token=TOKEN
  std::string url() const;
  /// Host, origin and site alone: of the request that brings the token.
  std::optional<Refusal> check_origin(const RequestOrigin& request) const;
  /// The same, the cookie, and that a body is JSON.
  std::optional<Refusal> check(const RequestOrigin& request) const;
  bool token_fits(const std::string& token) const;
  /// The header Set-Cookie that answers the token. Cookies know no ports: its name has it.
  std::string cookie_header() const;

 private:
  std::string cookie_name() const;

  int port_;
  std::string token_;
};

}  // namespace legwright
