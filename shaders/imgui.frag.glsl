#version 330 core
// SPDX-License-Identifier: MIT
uniform sampler2D image;
in vec2 fragment_uv;
in vec4 fragment_color;
out vec4 pixel;

void main() {
  pixel = fragment_color * texture(image, fragment_uv);
}
