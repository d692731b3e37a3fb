// SPDX-License-Identifier: MIT
#include "ui/surface/headless.h"

#include <dlfcn.h>

#include <array>

namespace svoscope::ui {
namespace {

// The few things we need of osmesa.h: the package with the header is then not needed to build.
using OsmesaContext = void*;
constexpr int kOsmesaFormat = 0x22, kOsmesaDepthBits = 0x30, kOsmesaProfile = 0x33;
constexpr int kOsmesaCoreProfile = 0x34, kOsmesaMajor = 0x36, kOsmesaMinor = 0x37;
constexpr const char* kLibrary = "libOSMesa.so.8";

struct Osmesa {
  OsmesaContext (*createContextAttribs)(const int* attributes, OsmesaContext share) = nullptr;
  void (*destroyContext)(OsmesaContext) = nullptr;
  GLboolean (*makeCurrent)(OsmesaContext, void*, GLenum, GLsizei, GLsizei) = nullptr;
  GlProc (*getProcAddress)(const char*) = nullptr;

  bool complete() const {
    return createContextAttribs && destroyContext && makeCurrent && getProcAddress;
  }
};

template <typename F>
void resolve(void* library, const char* name, F& function) {
  function = reinterpret_cast<F>(dlsym(library, name));
}

Result<Osmesa> loadOsmesa() {
  // RTLD_LOCAL: its gl* symbols must not meet those of a libGL in the same process. Never closed:
  // Mesa does not survive being unloaded.
  void* library = dlopen(kLibrary, RTLD_NOW | RTLD_LOCAL);
  if (!library) {
    const char* reason = dlerror();
    return Error{ErrorKind::internal, reason ? reason : "cannot be loaded", kLibrary,
                 "rendering without a display needs the package libosmesa6: "
                 "sudo apt-get install libosmesa6"};
  }
  Osmesa osmesa;
  resolve(library, "OSMesaCreateContextAttribs", osmesa.createContextAttribs);
  resolve(library, "OSMesaDestroyContext", osmesa.destroyContext);
  resolve(library, "OSMesaMakeCurrent", osmesa.makeCurrent);
  resolve(library, "OSMesaGetProcAddress", osmesa.getProcAddress);
  if (!osmesa.complete()) {
    return Error{ErrorKind::internal, "lacks a function", kLibrary,
                 "install Debian's libosmesa6 (Mesa 11.2 or later)"};
  }
  return osmesa;
}

class OsmesaSurface : public NullSurface {
 public:
  OsmesaSurface(SurfaceSize size, float scale, const Osmesa& osmesa, OsmesaContext context)
      : NullSurface(size, scale), osmesa_(osmesa), context_(context) {}
  ~OsmesaSurface() override { osmesa_.destroyContext(context_); }
  OsmesaSurface(const OsmesaSurface&) = delete;
  OsmesaSurface& operator=(const OsmesaSurface&) = delete;

  SurfaceKind kind() const override { return SurfaceKind::osmesa; }
  GlProc getProcAddress(const char* name) override { return osmesa_.getProcAddress(name); }
  Status makeCurrent() override {
    if (osmesa_.makeCurrent(context_, buffer_.data(), GL_UNSIGNED_BYTE, kSide, kSide))
      return Done{};
    return Error{ErrorKind::internal, "the context cannot be made current", kLibrary, ""};
  }

 private:
  // OSMesa insists on a buffer; we render into a framebuffer object of our own size.
  static constexpr int kSide = 16;
  std::array<unsigned char, kSide * kSide * 4> buffer_{};
  Osmesa osmesa_;
  OsmesaContext context_;
};

}  // namespace

void NullSurface::beginFrame(ImGuiIO& io) {
  io.DisplaySize = {static_cast<float>(size_.width), static_cast<float>(size_.height)};
  io.DisplayFramebufferScale = {1, 1};
  io.DeltaTime = 1.0f / 60;
}

Result<std::unique_ptr<Surface>> makeOsmesaSurface(SurfaceSize size, float scale) {
  const Result<Osmesa> osmesa = loadOsmesa();
  if (!osmesa) return osmesa.error();
  const int attributes[] = {kOsmesaFormat,
                            GL_RGBA,
                            kOsmesaDepthBits,
                            0,
                            kOsmesaProfile,
                            kOsmesaCoreProfile,
                            kOsmesaMajor,
                            3,
                            kOsmesaMinor,
                            3,
                            0,
                            0};
  OsmesaContext context = osmesa.value().createContextAttribs(attributes, nullptr);
  if (!context) {
    return Error{ErrorKind::internal, "no OpenGL 3.3 core context", kLibrary,
                 "install Debian's libosmesa6"};
  }
  return std::unique_ptr<Surface>(
      std::make_unique<OsmesaSurface>(size, scale, osmesa.value(), context));
}

}  // namespace svoscope::ui
