// SPDX-License-Identifier: MIT
// svoscope camera: what a calibration file of any tool is understood as.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>

#include "app/command.h"
#include "engine/dataset/calibration/calibration.h"
#include "engine/dataset/camera_file.h"

namespace svoscope {

namespace {

constexpr const char* kFooter =
    "Kalibr, ASL, ROS camera_info, OpenCV, ORB-SLAM2/3, SVO (vikit), SVO Pro, VINS, basalt, DSO "
    "and\n"
    "COLMAP files are recognised (docs/sequences.md).\n"
    "\n"
    "Examples:\n"
    "  svoscope camera ost.yaml\n"
    "  svoscope camera camera.txt --out camera.yaml\n"
    "  svoscope camera settings.yaml --size 640x480";

struct Arguments {
  std::string file, out, size;
};

Result<ImageSize> sizeOf(const std::string& text) {
  ImageSize size;
  if (text.empty()) return size;
  char rest = 0;
  if (std::sscanf(text.c_str(), "%dx%d%c", &size.width, &size.height, &rest) != 2 ||
      size.width <= 0 || size.height <= 0)
    return usageError("'" + text + "' is not WIDTHxHEIGHT", "--size", "as in --size 640x480");
  return size;
}

void print(const Calibration& c) {
  const Pinhole& p = c.camera.pinhole;
  const double degree = 180 / M_PI;
  fmt::print("read as     {}\n", c.format);
  fmt::print("resolution  {} x {}\n", p.width, p.height);
  fmt::print("intrinsics  fx {:.10g}, fy {:.10g}, cx {:.10g}, cy {:.10g} px\n", p.fx, p.fy, p.cx,
             p.cy);
  fmt::print("            {:.1f} x {:.1f} degrees without distortion\n",
             2 * degree * std::atan(0.5 * p.width / p.fx),
             2 * degree * std::atan(0.5 * p.height / p.fy));
  fmt::print("distortion  {}{}{:.10g}\n", distortionName(c.camera.distortion),
             c.camera.coefficients.empty() ? "" : ": ", fmt::join(c.camera.coefficients, ", "));
  fmt::print("rate        {}\n", c.camera.rate_hz > 0 ? fmt::format("{:.6g} Hz", c.camera.rate_hz)
                                                      : std::string("not given"));
  if (c.has_body) {
    const Vec3& t = c.T_body_cam.translation();
    const Eigen::Quaterniond& q = c.T_body_cam.quaternion();
    fmt::print("T_body_cam  t {:.6g} {:.6g} {:.6g} m, q {:.6g} {:.6g} {:.6g} {:.6g} (x y z w)\n",
               t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w());
  }
}

int runCamera(const Arguments& arguments) {
  const auto size = sizeOf(arguments.size);
  if (!size.ok()) return reportError(size.error());
  const auto read = readCalibration(arguments.file, size.value());
  if (!read.ok()) return reportError(read.error());
  for (const std::string& text : read.value().notes) reportWarning(text);
  print(read.value());
  if (arguments.out.empty()) return kExitDone;
  const Status written = writeCameraFile(read.value().camera, arguments.out);
  if (!written.ok()) return reportError(written.error());
  fmt::print("written     {}\n", arguments.out);
  return kExitDone;
}

}  // namespace

void addCameraCommand(CLI::App& app, Action& action) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("camera", "Show how a calibration file is understood");
  command->footer(kFooter);
  command->add_option("FILE", arguments->file, "Calibration of any known tool")->required();
  command->add_option("--out", arguments->out, "Write it as camera.yaml")->type_name("FILE");
  command->add_option("--size", arguments->size, "Of the images, if the file does not say")
      ->type_name("WxH");
  command->callback(
      [arguments, &action] { action = [arguments] { return runCamera(*arguments); }; });
}

}  // namespace svoscope
