// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glfw_adapter.h>

#include <functional>
#include <string>

namespace legwright {

/// The window of MuJoCo's viewer, with a title of ours and a place where the thread that draws it
/// can be given things to do. Construction throws MujocoError where there is no display, as
/// MuJoCo's errors do while a MujocoMessages lives.
class Window : public mujoco::GlfwAdapter {
 public:
  /// @param on_frame called before each frame by the thread that draws, while it holds the viewer's
  /// lock
  explicit Window(std::function<void()> on_frame) : on_frame_(std::move(on_frame)) {}

  /// Of the model that is loaded next. To be called with the viewer's lock held.
  void name_next(std::string title) { title_ = std::move(title); }

  /// After a panel was switched on or off.
  void arrange_panels() {
    if (layout_callback_) layout_callback_(&state_);
  }

  void PollEvents() override {
    GlfwAdapter::PollEvents();
    on_frame_();
  }
  void SetWindowTitle(const char* title) override {
    GlfwAdapter::SetWindowTitle(title_.empty() ? title : title_.c_str());
  }

 private:
  std::function<void()> on_frame_;
  std::string title_;
};

}  // namespace legwright
