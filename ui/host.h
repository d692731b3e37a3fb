// SPDX-License-Identifier: MIT
// Owns the ImGui context, the surface and the graphics, in the order in which they must die.
#pragma once

#include <filesystem>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <vector>

#include "ui/content.h"
#include "ui/render/graphics.h"
#include "ui/surface/input.h"
#include "ui/surface/surface.h"
#include "ui/widgets/probe.h"

namespace svoscope::ui {

struct HostOptions {
  SurfaceKind surface = SurfaceKind::automatic;
  SurfaceSize size;
  float scale = 1;
  std::string title = "svoscope";
};

class Host {
 public:
  static Result<std::unique_ptr<Host>> open(const HostOptions& options);
  ~Host();
  Host(const Host&) = delete;
  Host& operator=(const Host&) = delete;

  /// Draws one frame. With `render` false, only the logic runs: layout, probe and clicks, at a
  /// fraction of the cost on a software renderer.
  void frame(UiContent& content, bool render = true);

  Surface& surface() { return *surface_; }
  Graphics& graphics() { return *graphics_; }
  bool hasPixels() const { return gl_ != nullptr; }
  /// Frames are drawn by the CPU: the engine should not have to share it.
  bool softwareRendering() const { return software_; }
  /// "llvmpipe (LLVM 15, 256 bits), OpenGL 4.5 ..." or "no rendering".
  const std::string& description() const { return description_; }
  /// Fonts that were not found, since the last call.
  std::vector<std::string> takeWarnings();

  void setScale(float scale) { surface_->setScale(scale); }
  void resize(SurfaceSize size) { surface_->resize(size); }

  /// Mouse and keyboard of a script. Without a window they are the only ones; with one, a script
  /// takes over from the user by driveByScript().
  InputState& scriptInput() { return script_input_; }
  void driveByScript() { scripted_ = true; }
  /// Lets that much time pass for ImGui in the next frame, e.g. to keep two clicks apart.
  void skipTime(float seconds) { skipped_time_ = seconds; }

  /// The last rendered frame, RGB, row 0 at the top.
  Result<cv::Mat> pixels() const;
  /// Writes it as PNG, or only the given part; makes the folder if needed.
  Status screenshot(const std::filesystem::path& file,
                    const std::optional<ProbeRect>& part = std::nullopt) const;

 private:
  struct GlParts;
  Host() = default;
  Status initialize(const HostOptions& options);
  void configureImGui();
  void prepareFonts();
  void prepareTheme(UiContent& content);
  void renderDrawData();

  ImGuiContext* context_ = nullptr;
  std::unique_ptr<Surface> surface_;
  std::unique_ptr<GlParts> gl_;
  std::unique_ptr<Graphics> null_graphics_;
  Graphics* graphics_ = nullptr;
  InputState script_input_;
  bool scripted_ = false, software_ = false;
  float skipped_time_ = 0;
  float font_scale_ = 0, theme_scale_ = 0;
  const UiContent* themed_ = nullptr;
  std::string description_ = "no rendering", clipboard_;
  std::vector<std::string> warnings_;
};

/// Writes an RGB picture as PNG; makes the folder if needed.
Status writePng(const std::filesystem::path& file, const cv::Mat& rgb);

}  // namespace svoscope::ui
