// SPDX-License-Identifier: MIT
#include "ui/host.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "engine/io/png.h"
#include "engine/io/text_output.h"
#include "ui/render/fonts.h"
#include "ui/render/gl_graphics.h"
#include "ui/render/imgui_renderer.h"
#include "ui/render/null_graphics.h"
#include "ui/render/render_target.h"

namespace svoscope::ui {

struct Host::GlParts {
  explicit GlParts(const Gl& table) : gl(table), target(gl), renderer(gl), graphics(gl) {}
  Gl gl;
  RenderTarget target;
  ImGuiRenderer renderer;
  GlGraphics graphics;
};

Result<std::unique_ptr<Host>> Host::open(const HostOptions& options) {
  std::unique_ptr<Host> host(new Host());
  const Status status = host->initialize(options);
  if (!status) return status.error();
  return host;
}

Status Host::initialize(const HostOptions& options) {
  context_ = ImGui::CreateContext();
  ImGui::SetCurrentContext(context_);
  Result<std::unique_ptr<Surface>> surface =
      makeSurface(options.surface, options.size, options.scale);
  if (!surface) return surface.error();
  surface_ = std::move(surface).value();
  surface_->setTitle(options.title);
  configureImGui();
  if (surface_->kind() == SurfaceKind::null) {
    null_graphics_ = std::make_unique<NullGraphics>();
    graphics_ = null_graphics_.get();
    return Done{};
  }
  const Status current = surface_->makeCurrent();
  if (!current) return current;
  const Result<Gl> gl = loadGl([this](const char* name) { return surface_->getProcAddress(name); });
  if (!gl) return gl.error();
  try {
    gl_ = std::make_unique<GlParts>(gl.value());
  } catch (const std::exception& e) {
    return Error{ErrorKind::internal, e.what(), glDescription(gl.value()), "update the driver"};
  }
  graphics_ = &gl_->graphics;
  description_ = glDescription(gl_->gl);
  software_ = isSoftwareRenderer(gl_->gl);
  return Done{};
}

Host::~Host() {
  // GL objects need the context of the surface; the renderer and the callbacks need ImGui's.
  if (context_) ImGui::SetCurrentContext(context_);
  if (gl_ && surface_) (void)surface_->makeCurrent();
  gl_.reset();
  null_graphics_.reset();
  surface_.reset();
  if (context_) ImGui::DestroyContext(context_);
}

void Host::configureImGui() {
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;  // the layout is saved by the inspector, beside the data
  io.LogFilename = nullptr;
  io.KeyRepeatDelay = 0.3f;
  io.KeyRepeatRate = 0.04f;
  io.BackendPlatformName = "svoscope";
  installKeyMap(io);
  if (surface_->kind() == SurfaceKind::window) {
    io.BackendFlags |= ImGuiBackendFlags_HasMouseCursors;
  } else {
    io.ConfigInputTextCursorBlink = false;  // the same picture whenever it is taken
  }
  io.ClipboardUserData = this;
  io.GetClipboardTextFn = [](void* host) {
    Host& self = *static_cast<Host*>(host);
    self.clipboard_ = self.surface_->clipboard();
    return self.clipboard_.c_str();
  };
  io.SetClipboardTextFn = [](void* host, const char* text) {
    static_cast<Host*>(host)->surface_->setClipboard(text);
  };
}

void Host::prepareFonts() {
  if (surface_->scale() == font_scale_) return;
  font_scale_ = surface_->scale();
  const std::vector<std::string> warnings = buildFonts(font_scale_);
  warnings_.insert(warnings_.end(), warnings.begin(), warnings.end());
  if (gl_) gl_->renderer.uploadFonts();
}

void Host::prepareTheme(UiContent& content) {
  if (themed_ == &content && theme_scale_ == font_scale_) return;
  themed_ = &content;
  theme_scale_ = font_scale_;
  ImGui::GetStyle() = ImGuiStyle();  // sizes are multiplied: always from the original ones
  content.applyTheme(theme_scale_);
}

void Host::frame(UiContent& content, bool render) {
  ImGui::SetCurrentContext(context_);
  prepareFonts();
  prepareTheme(content);
  ImGuiIO& io = ImGui::GetIO();
  surface_->beginFrame(io);
  if (scripted_ || surface_->kind() != SurfaceKind::window) script_input_.apply(io);
  io.DeltaTime += std::exchange(skipped_time_, 0.0f);
  const std::vector<std::string> files = surface_->takeDroppedFiles();
  if (!files.empty()) content.filesDropped(files);

  ImGui::NewFrame();
  Probe::clear();
  content.draw();
  ImGui::Render();
  if (gl_ && render) renderDrawData();
}

void Host::renderDrawData() {
  const Gl& gl = gl_->gl;
  const SurfaceSize size = surface_->size();
  if (size.width <= 0 || size.height <= 0) return;  // minimised
  gl_->target.begin(size.width, size.height);
  const ImVec4 background = ImGui::GetStyleColorVec4(ImGuiCol_WindowBg);
  gl.Disable(GL_SCISSOR_TEST);
  gl.ClearColor(background.x, background.y, background.z, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl_->renderer.render(*ImGui::GetDrawData());
  gl_->target.end();
  if (surface_->kind() == SurfaceKind::window) {
    gl_->target.blitToWindow(size.width, size.height);
    surface_->present();
  }
}

std::vector<std::string> Host::takeWarnings() { return std::exchange(warnings_, {}); }

Result<cv::Mat> Host::pixels() const {
  if (!gl_) {
    return usageError("there are no pixels without rendering", "screenshot",
                      "use the osmesa surface or a window");
  }
  if (gl_->target.width() == 0) {
    return Error{ErrorKind::internal, "nothing was rendered yet", "screenshot", ""};
  }
  return gl_->target.readPixels();
}

Status Host::screenshot(const std::filesystem::path& file,
                        const std::optional<ProbeRect>& part) const {
  const Result<cv::Mat> picture = pixels();
  if (!picture) return picture.error();
  cv::Rect all(0, 0, picture.value().cols, picture.value().rows), wanted = all;
  if (part) {
    const cv::Point min(static_cast<int>(std::floor(part->min.x)),
                        static_cast<int>(std::floor(part->min.y)));
    const cv::Point max(static_cast<int>(std::ceil(part->max.x)),
                        static_cast<int>(std::ceil(part->max.y)));
    wanted = cv::Rect(min, max) & all;
  }
  if (wanted.empty()) {
    return usageError("the part asked for is outside the window", "screenshot",
                      "show the panel first, or make the window larger");
  }
  return writePng(file, picture.value()(wanted));
}

Status writePng(const std::filesystem::path& file, const cv::Mat& rgb) {
  if (file.has_parent_path()) {
    const Status made = makeFolder(file.parent_path());
    if (!made.ok()) return made;
  }
  cv::Mat bgr;
  cv::cvtColor(rgb, bgr, cv::COLOR_RGB2BGR);
  return svoscope::writePng(file, bgr);
}

}  // namespace svoscope::ui
