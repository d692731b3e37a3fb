#version 330 core
// SPDX-License-Identifier: MIT
uniform float width;
in vec4 fragment_color;
in float across;
out vec4 pixel;

void main() {
  float coverage = clamp(0.5 * width + 0.5 - abs(across), 0.0, 1.0);
  if (coverage < 0.05) discard;  // leaves the depth buffer alone
  pixel = vec4(fragment_color.rgb, fragment_color.a * coverage);
}
