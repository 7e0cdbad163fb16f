// SPDX-License-Identifier: Apache-2.0
#include "tests/tools/viewer/display.hpp"

#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <stdexcept>
#include <thread>
#include <utility>

#include "tools/files/atomic_file.hpp"

namespace legwright::test {
namespace {

namespace fs = std::filesystem;

constexpr auto kPatience = std::chrono::seconds(60);

using Environment = std::vector<std::pair<std::string, std::string>>;

pid_t spawn(const std::vector<std::string>& words, const fs::path& output,
            const Environment& environment, int keep = -1) {
  const pid_t child = ::fork();
  if (child != 0) return child;
  for (const auto& [name, value] : environment) ::setenv(name.c_str(), value.c_str(), 1);
  const int out = ::open(output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  ::dup2(out, STDOUT_FILENO);
  ::dup2(out, STDERR_FILENO);
  if (keep >= 0) ::fcntl(keep, F_SETFD, 0);
  std::vector<char*> argv;
  for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  ::execvp(argv[0], argv.data());
  ::_exit(127);
}

std::uint32_t big_endian(const std::string& bytes, std::size_t word) {
  std::uint32_t value = 0;
  for (std::size_t i = 4 * word; i < 4 * word + 4; ++i)
    value = value << 8 | static_cast<std::uint8_t>(bytes.at(i));
  return value;
}

}  // namespace

int Screenshot::count(const std::function<bool(const Colour&)>& matches) const {
  return static_cast<int>(std::count_if(pixels.begin(), pixels.end(), matches));
}

int Screenshot::differing(const Screenshot& other) const {
  int count = 0;
  for (std::size_t i = 0; i < pixels.size(); ++i) count += pixels[i] != other.pixels.at(i) ? 1 : 0;
  return count;
}

bool wait_until(const std::function<bool()>& done) {
  const auto limit = std::chrono::steady_clock::now() + kPatience;
  while (!done()) {
    if (std::chrono::steady_clock::now() > limit) return done();
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return true;
}

bool VirtualDisplay::available() {
  const char* path = std::getenv("PATH");
  std::string folders = path ? path : "";
  for (std::size_t start = 0; start <= folders.size();) {
    const std::size_t end = std::min(folders.find(':', start), folders.size());
    if (::access((folders.substr(start, end - start) + "/Xvfb").c_str(), X_OK) == 0) return true;
    start = end + 1;
  }
  return false;
}

VirtualDisplay::VirtualDisplay(int width, int height) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  const std::string size = std::to_string(width) + "x" + std::to_string(height) + "x24";
  server_ = spawn({"Xvfb", "-displayfd", std::to_string(ends[1]), "-screen", "0", size, "-fbdir",
                   folder_.path().string(), "-nolisten", "tcp"},
                  folder_.path() / "log", {}, ends[1]);
  ::close(ends[1]);
  for (char c; ::read(ends[0], &c, 1) == 1 && c != '\n';) number_ += c;  // it is ready then
  ::close(ends[0]);
  connection_ = number_.empty() ? nullptr : XOpenDisplay(name().c_str());
  if (!connection_) throw std::runtime_error("no X server: " + read_file(folder_.path() / "log"));
  XSetErrorHandler([](Display*, XErrorEvent*) { return 0; });  // windows close while we ask them
}

VirtualDisplay::~VirtualDisplay() {
  XCloseDisplay(connection_);
  ::kill(server_, SIGTERM);
  ::waitpid(server_, nullptr, 0);
}

Screenshot VirtualDisplay::screenshot() const {
  // X11/XWDFile.h: words of four bytes, highest first; then colours of 12 bytes; then the rows.
  const std::string file = read_file(folder_.path() / "Xvfb_screen0");
  Screenshot shot;
  shot.width = static_cast<int>(big_endian(file, 4));
  shot.height = static_cast<int>(big_endian(file, 5));
  const std::size_t bytes_per_line = big_endian(file, 12);
  const std::size_t start = big_endian(file, 0) + 12 * big_endian(file, 19);
  if (big_endian(file, 11) != 32 || big_endian(file, 7) != 0)
    throw std::runtime_error("expected pixels of 32 bits, lowest byte first");
  for (int row = 0; row < shot.height; ++row)
    for (int column = 0; column < shot.width; ++column) {
      const char* blue = &file.at(start + row * bytes_per_line + 4 * column);
      shot.pixels.push_back({static_cast<std::uint8_t>(blue[2]), static_cast<std::uint8_t>(blue[1]),
                             static_cast<std::uint8_t>(blue[0])});
    }
  return shot;
}

namespace {

std::vector<Window> windows(Display* display) {
  Window root = 0, parent = 0, *children = nullptr;
  unsigned int count = 0;
  std::vector<Window> found;
  if (XQueryTree(display, DefaultRootWindow(display), &root, &parent, &children, &count))
    found.assign(children, children + count);
  if (children) XFree(children);
  return found;
}

std::string title_of(Display* display, Window window) {
  char* name = nullptr;
  std::string title;
  if (XFetchName(display, window, &name) && name) title = name;
  if (name) XFree(name);
  return title;
}

}  // namespace

std::vector<std::string> VirtualDisplay::titles() const {
  std::vector<std::string> found;
  for (const Window window : windows(connection_))
    if (std::string title = title_of(connection_, window); !title.empty())
      found.push_back(std::move(title));
  return found;
}

unsigned long VirtualDisplay::find(const std::string& title) const {
  for (const Window window : windows(connection_))
    if (title_of(connection_, window).rfind(title, 0) == 0) return window;
  return 0;
}

bool VirtualDisplay::close_window(const std::string& title) const {
  const Window window = find(title);
  if (!window) return false;
  XEvent event{};
  event.xclient.type = ClientMessage;
  event.xclient.window = window;
  event.xclient.message_type = XInternAtom(connection_, "WM_PROTOCOLS", False);
  event.xclient.format = 32;
  event.xclient.data.l[0] = static_cast<long>(XInternAtom(connection_, "WM_DELETE_WINDOW", False));
  XSendEvent(connection_, window, False, NoEventMask, &event);
  XFlush(connection_);
  return true;
}

bool VirtualDisplay::press(const std::string& title, const std::string& key) const {
  const Window window = find(title);
  if (!window) return false;
  XEvent event{};
  event.xkey.display = connection_;
  event.xkey.window = window;
  event.xkey.root = DefaultRootWindow(connection_);
  event.xkey.same_screen = True;
  event.xkey.keycode = XKeysymToKeycode(connection_, XStringToKeysym(key.c_str()));
  for (const int type : {KeyPress, KeyRelease}) {
    event.type = type;
    XSendEvent(connection_, window, True, type == KeyPress ? KeyPressMask : KeyReleaseMask, &event);
  }
  XFlush(connection_);
  return true;
}

Program::Program(const VirtualDisplay& display, const std::vector<std::string>& words,
                 const std::string& driver)
    : child_(spawn(words, folder_.path() / "output",
                   {{"DISPLAY", display.name()},
                    {"WAYLAND_DISPLAY", ""},
                    {"LIBGL_ALWAYS_SOFTWARE", "1"},
                    {"GALLIUM_DRIVER", driver},
                    {"ASAN_OPTIONS", "detect_leaks=0"}})) {}  // drivers leak a few bytes

Program::~Program() {
  if (!running()) return;
  ::kill(child_, SIGKILL);
  wait();
}

std::string Program::output() const {
  const fs::path file = folder_.path() / "output";
  return fs::exists(file) ? read_file(file) : "";
}

bool Program::running() {
  if (code_) return false;
  int status = 0;
  if (::waitpid(child_, &status, WNOHANG) != child_) return true;
  code_ = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  return false;
}

int Program::wait() {
  wait_until([this] { return !running(); });
  if (!code_) {
    ::kill(child_, SIGKILL);
    ::waitpid(child_, nullptr, 0);
    code_ = -SIGKILL;
  }
  return *code_;
}

double Program::memory() const {
  const std::string text = read_file("/proc/" + std::to_string(child_) + "/statm");
  const std::size_t start = text.find(' ') + 1;
  double pages = 0.0;
  for (std::size_t i = start; i < text.size() && text[i] >= '0' && text[i] <= '9'; ++i)
    pages = 10.0 * pages + (text[i] - '0');
  return pages * static_cast<double>(::sysconf(_SC_PAGESIZE)) / (1024.0 * 1024.0);
}

}  // namespace legwright::test
