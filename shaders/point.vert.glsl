#version 330 core
// SPDX-License-Identifier: MIT
uniform mat4 clip_from_world;
uniform float size;  // pixels
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 color;
out vec4 fragment_color;

void main() {
  fragment_color = color;
  vec4 clip = clip_from_world * vec4(position, 1.0);
  gl_Position = vec4(clip.x, -clip.y, clip.zw);  // row 0 of the texture is the top
  gl_PointSize = size + 1.0;                     // room for the soft edge
}
