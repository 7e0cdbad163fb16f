// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tests/tools/files/temporary_folder.hpp"

struct _XDisplay;

/// A screen without a monitor, the programs on it, and what it shows.
namespace legwright::test {

using Colour = std::array<std::uint8_t, 3>;  // red, green, blue

struct Screenshot {
  int width = 0, height = 0;
  std::vector<Colour> pixels;  // row by row from the top
  /// How many pixels are of a colour that `matches`.
  int count(const std::function<bool(const Colour&)>& matches) const;
  /// How many pixels are not those of another of the same size.
  int differing(const Screenshot& other) const;
};

/// Waits until `done`, a minute at the longest: for events, never for a time. @return done()
bool wait_until(const std::function<bool()>& done);

/// An X server that draws into memory. Throws std::runtime_error where it cannot be started.
class VirtualDisplay {
 public:
  VirtualDisplay(int width, int height);
  ~VirtualDisplay();
  VirtualDisplay(const VirtualDisplay&) = delete;
  VirtualDisplay& operator=(const VirtualDisplay&) = delete;

  /// Whether Xvfb is installed.
  static bool available();

  std::string name() const { return ":" + number_; }
  /// What the server's frame buffer holds now.
  Screenshot screenshot() const;
  /// Titles of the windows that are open.
  std::vector<std::string> titles() const;
  /// Asks the first window whose title starts so to close, as its frame's button would.
  bool close_window(const std::string& title) const;
  /// Presses and lets go of a key there. @param key a name as in X11's keysymdef.h: "space"
  bool press(const std::string& title, const std::string& key) const;

 private:
  unsigned long find(const std::string& title) const;

  TemporaryFolder folder_;
  std::string number_;
  pid_t server_ = -1;
  ::_XDisplay* connection_ = nullptr;
};

/// A program that runs on a display, with what it prints in a file. `driver` is Mesa's: llvmpipe is
/// the quick one, softpipe compiles nothing and so has no caches that come and go.
class Program {
 public:
  Program(const VirtualDisplay& display, const std::vector<std::string>& words,
          const std::string& driver = "llvmpipe");
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  pid_t id() const { return child_; }
  /// All that it has printed so far, messages included.
  std::string output() const;
  bool running();
  /// Its exit code, once it has ended; −signal where one killed it.
  int wait();
  /// Resident memory [MiB].
  double memory() const;

 private:
  TemporaryFolder folder_;
  pid_t child_ = -1;
  std::optional<int> code_;
};

}  // namespace legwright::test
