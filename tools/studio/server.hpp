// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "tools/studio/studio_service.hpp"

namespace legwright {

/// The studio over HTTP, on the loopback interface alone.
class StudioServer {
 public:
  /// Begins to listen. @param port 0: one that is free. Throws IoError where it is taken.
  /// @param token for tests; empty: a random one
  StudioServer(StudioService& studio, int port, const std::string& token = {});
  ~StudioServer();
  StudioServer(const StudioServer&) = delete;
  StudioServer& operator=(const StudioServer&) = delete;

  /// http://127.0.0.1:PORT/?token=…: what lets a browser in.
  std::string url() const;
  int port() const;
  /// Ends streams and listens no more.
  void stop();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace legwright
