// SPDX-License-Identifier: MIT
#include "ui/surface/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <utility>

#include "ui/surface/input.h"

namespace svoscope::ui {
namespace {

// Our key numbers are GLFW's, so no table is needed; these hold that to be true.
static_assert(index(Key::space) == GLFW_KEY_SPACE && index(Key::a) == GLFW_KEY_A);
static_assert(index(Key::escape) == GLFW_KEY_ESCAPE && index(Key::up) == GLFW_KEY_UP);
static_assert(index(Key::end) == GLFW_KEY_END && index(Key::f1) == GLFW_KEY_F1);
static_assert(index(Key::keypad_enter) == GLFW_KEY_KP_ENTER &&
              index(Key::grave) == GLFW_KEY_GRAVE_ACCENT);

std::string lastGlfwError() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text ? text : "unknown reason";
}

class WindowSurface : public Surface {
 public:
  WindowSurface(GLFWwindow* window, float user_scale) : window_(window), user_scale_(user_scale) {
    glfwSetWindowUserPointer(window, this);
    installCallbacks();
    readScreenScale();
  }
  ~WindowSurface() override {
    for (GLFWcursor* cursor : cursors_) {
      if (cursor) glfwDestroyCursor(cursor);
    }
    glfwDestroyWindow(window_);
    glfwTerminate();
  }
  WindowSurface(const WindowSurface&) = delete;
  WindowSurface& operator=(const WindowSurface&) = delete;

  SurfaceKind kind() const override { return SurfaceKind::window; }
  SurfaceSize size() const override {
    SurfaceSize result;
    glfwGetFramebufferSize(window_, &result.width, &result.height);
    return result;
  }
  float scale() const override { return screen_scale_ * user_scale_; }
  void setScale(float scale) override { user_scale_ = scale / screen_scale_; }
  void resize(SurfaceSize size) override {
    const ImVec2 ratio = pixelsPerUnit();
    glfwSetWindowSize(window_, static_cast<int>(static_cast<float>(size.width) / ratio.x),
                      static_cast<int>(static_cast<float>(size.height) / ratio.y));
  }
  Status makeCurrent() override {
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(1);
    return Done{};
  }
  GlProc getProcAddress(const char* name) override { return glfwGetProcAddress(name); }

  void beginFrame(ImGuiIO& io) override;
  void present() override { glfwSwapBuffers(window_); }
  void waitForInput(double seconds) override {
    if (seconds > 0)
      glfwWaitEventsTimeout(seconds);
    else
      glfwPollEvents();
  }
  bool inputPending() const override { return input_pending_; }
  bool shouldClose() const override { return glfwWindowShouldClose(window_); }
  void setTitle(const std::string& title) override { glfwSetWindowTitle(window_, title.c_str()); }
  std::vector<std::string> takeDroppedFiles() override { return std::exchange(dropped_, {}); }
  std::string clipboard() override {
    const char* text = glfwGetClipboardString(window_);
    return text ? text : "";
  }
  void setClipboard(const std::string& text) override {
    glfwSetClipboardString(window_, text.c_str());
  }

 private:
  static WindowSurface& self(GLFWwindow* window) {
    auto& surface = *static_cast<WindowSurface*>(glfwGetWindowUserPointer(window));
    surface.input_pending_ = true;  // every callback is a reason to redraw
    return surface;
  }
  void installCallbacks();
  void readScreenScale();
  void setModifiers(int mods);
  void setCursor(ImGuiMouseCursor shape);
  /// Framebuffer pixels per window unit: 1 on X11, more where the system scales windows itself.
  ImVec2 pixelsPerUnit() const;

  GLFWwindow* window_;
  float user_scale_, screen_scale_ = 1;
  InputState input_;
  bool input_pending_ = true;
  std::vector<std::string> dropped_;
  std::array<GLFWcursor*, ImGuiMouseCursor_COUNT> cursors_{};
  ImGuiMouseCursor cursor_ = ImGuiMouseCursor_Arrow;
  std::chrono::steady_clock::time_point last_frame_ = std::chrono::steady_clock::now();
};

ImVec2 WindowSurface::pixelsPerUnit() const {
  int units_x = 0, units_y = 0;
  glfwGetWindowSize(window_, &units_x, &units_y);
  const SurfaceSize pixels = size();
  if (units_x <= 0 || units_y <= 0) return {1, 1};
  return {static_cast<float>(pixels.width) / static_cast<float>(units_x),
          static_cast<float>(pixels.height) / static_cast<float>(units_y)};
}

void WindowSurface::readScreenScale() {
  float x = 1, y = 1;
  glfwGetWindowContentScale(window_, &x, &y);
  screen_scale_ = std::clamp(std::max(x, y), 0.5f, 4.0f);
}

void WindowSurface::setModifiers(int mods) {
  input_.ctrl = mods & GLFW_MOD_CONTROL;
  input_.shift = mods & GLFW_MOD_SHIFT;
  input_.alt = mods & GLFW_MOD_ALT;
  input_.super = mods & GLFW_MOD_SUPER;
}

void WindowSurface::installCallbacks() {
  glfwSetKeyCallback(window_, [](GLFWwindow* w, int key, int, int action, int mods) {
    WindowSurface& s = self(w);
    s.input_.setKey(static_cast<Key>(key), action != GLFW_RELEASE);
    // X11 reports the modifiers from before the event: look at the keys themselves.
    if (key >= GLFW_KEY_LEFT_SHIFT && key <= GLFW_KEY_RIGHT_SUPER) {
      const int bit = 1 << ((key - GLFW_KEY_LEFT_SHIFT) % 4);
      mods = action == GLFW_RELEASE ? mods & ~bit : mods | bit;
    }
    s.setModifiers(mods);
  });
  glfwSetCharCallback(window_, [](GLFWwindow* w, unsigned int character) {
    self(w);
    ImGui::GetIO().AddInputCharacter(character);
  });
  glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int button, int action, int mods) {
    self(w).input_.setButton(button, action == GLFW_PRESS);
    self(w).setModifiers(mods);
  });
  glfwSetScrollCallback(window_, [](GLFWwindow* w, double x, double y) {
    ImVec2& wheel = self(w).input_.wheel;
    wheel = {wheel.x + static_cast<float>(x), wheel.y + static_cast<float>(y)};
  });
  glfwSetCursorPosCallback(window_, [](GLFWwindow* w, double x, double y) {
    WindowSurface& s = self(w);
    const ImVec2 ratio = s.pixelsPerUnit();
    s.input_.mouse = {static_cast<float>(x) * ratio.x, static_cast<float>(y) * ratio.y};
  });
  glfwSetCursorEnterCallback(window_, [](GLFWwindow* w, int entered) {
    if (!entered) self(w).input_.mouse = InputState::nowhere();
  });
  glfwSetWindowFocusCallback(window_, [](GLFWwindow* w, int focused) {
    // Releases are not reported while another window has the focus.
    if (!focused) self(w).input_.releaseAll();
  });
  glfwSetDropCallback(window_, [](GLFWwindow* w, int count, const char** paths) {
    self(w).dropped_.assign(paths, paths + count);
  });
  glfwSetWindowContentScaleCallback(window_,
                                    [](GLFWwindow* w, float, float) { self(w).readScreenScale(); });
  glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* w, int, int) { self(w); });
  glfwSetWindowRefreshCallback(window_, [](GLFWwindow* w) { self(w); });
  glfwSetWindowCloseCallback(window_, [](GLFWwindow* w) { self(w); });
}

void WindowSurface::setCursor(ImGuiMouseCursor shape) {
  if (shape == cursor_ || shape < 0) return;
  cursor_ = shape;
  const auto glfw_shape = [shape] {
    switch (shape) {
      case ImGuiMouseCursor_TextInput:
        return GLFW_IBEAM_CURSOR;
      case ImGuiMouseCursor_ResizeNS:
        return GLFW_VRESIZE_CURSOR;
      case ImGuiMouseCursor_ResizeEW:
        return GLFW_HRESIZE_CURSOR;
      case ImGuiMouseCursor_ResizeAll:
        return GLFW_CROSSHAIR_CURSOR;
      case ImGuiMouseCursor_Hand:
        return GLFW_HAND_CURSOR;
      default:
        return GLFW_ARROW_CURSOR;
    }
  };
  GLFWcursor*& cursor = cursors_[static_cast<std::size_t>(shape)];
  if (!cursor) cursor = glfwCreateStandardCursor(glfw_shape());
  glfwSetCursor(window_, cursor);
}

void WindowSurface::beginFrame(ImGuiIO& io) {
  input_pending_ = false;
  const SurfaceSize pixels = size();
  // Display units are framebuffer pixels everywhere; the scale is in fonts and style.
  io.DisplaySize = {static_cast<float>(pixels.width), static_cast<float>(pixels.height)};
  io.DisplayFramebufferScale = {1, 1};
  const auto now = std::chrono::steady_clock::now();
  // Idle windows pause for long: no animation should jump by more than a tenth of a second.
  io.DeltaTime = std::clamp(std::chrono::duration<float>(now - last_frame_).count(), 1e-4f, 0.1f);
  last_frame_ = now;
  input_.apply(io);
  setCursor(ImGui::GetMouseCursor());
}

/// Sizes asked for are at scale 1 and must fit the screen.
SurfaceSize fitToScreen(SurfaceSize size) {
  GLFWmonitor* monitor = glfwGetPrimaryMonitor();
  if (!monitor) return size;
  float scale_x = 1, scale_y = 1;
  int x = 0, y = 0, width = 0, height = 0;
  glfwGetMonitorContentScale(monitor, &scale_x, &scale_y);
  glfwGetMonitorWorkarea(monitor, &x, &y, &width, &height);
  size.width = static_cast<int>(static_cast<float>(size.width) * scale_x);
  size.height = static_cast<int>(static_cast<float>(size.height) * scale_y);
  if (width > 0 && height > 0) {
    size = {std::min(size.width, width), std::min(size.height, height)};
  }
  return size;
}

}  // namespace

Result<std::unique_ptr<Surface>> makeWindowSurface(SurfaceSize size, float scale) {
  // A software renderer then draws in our own thread, which yields to the engine, instead of in one
  // per core, which would not. GPU drivers ignore this.
  setenv("LP_NUM_THREADS", "0", 0);
  if (!glfwInit()) return displayError("the display " + displayName() + " cannot be opened");
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_DEPTH_BITS, 0);  // we blit into it, nothing else
  glfwWindowHint(GLFW_STENCIL_BITS, 0);
  const SurfaceSize fitted = fitToScreen(size);
  GLFWwindow* window = glfwCreateWindow(fitted.width, fitted.height, "svoscope", nullptr, nullptr);
  if (!window) {
    const Error e = displayError("the display " + displayName() +
                                 " has no window with OpenGL 3.3: " + lastGlfwError());
    glfwTerminate();
    return e;
  }
  return std::unique_ptr<Surface>(std::make_unique<WindowSurface>(window, scale));
}

}  // namespace svoscope::ui
