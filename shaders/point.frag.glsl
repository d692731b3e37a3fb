#version 330 core
// SPDX-License-Identifier: MIT
uniform float size;
in vec4 fragment_color;
out vec4 pixel;

void main() {
  float radius = length(gl_PointCoord - 0.5) * (size + 1.0);
  float coverage = clamp(0.5 * size + 0.5 - radius, 0.0, 1.0);
  if (coverage < 0.05) discard;  // leaves the depth buffer alone
  pixel = vec4(fragment_color.rgb, fragment_color.a * coverage);
}
