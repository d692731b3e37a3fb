#version 330 core
// SPDX-License-Identifier: MIT
// Display coordinates, y down, to clip space.
uniform vec2 display_origin;
uniform vec2 display_size;
layout(location = 0) in vec2 position;
layout(location = 1) in vec2 uv;
layout(location = 2) in vec4 color;
out vec2 fragment_uv;
out vec4 fragment_color;

void main() {
  fragment_uv = uv;
  fragment_color = color;
  vec2 unit = (position - display_origin) / display_size;
  gl_Position = vec4(2.0 * unit.x - 1.0, 1.0 - 2.0 * unit.y, 0.0, 1.0);
}
