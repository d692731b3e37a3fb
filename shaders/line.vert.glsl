#version 330 core
// SPDX-License-Identifier: MIT
// One instance per line: a quad of constant width on screen, since core profiles draw lines one
// pixel wide only. The four corners come from gl_VertexID.
uniform mat4 clip_from_world;
uniform vec2 viewport;  // pixels
uniform float width;    // pixels
layout(location = 0) in vec3 start;
layout(location = 1) in vec4 start_color;
layout(location = 2) in vec3 end;
layout(location = 3) in vec4 end_color;
out vec4 fragment_color;
out float across;  // pixels from the centre line

// Distance to the near plane, in clip space; negative in front of it.
float depth(vec4 p) { return p.z + p.w; }

// Ends behind the camera would be mirrored by the division: move them to the near plane.
vec4 clipped(vec4 p, vec4 other) {
  float inside = depth(other), outside = depth(p);
  return outside >= 0.0 ? p : mix(p, other, -outside / (inside - outside));
}

void main() {
  vec4 a = clip_from_world * vec4(start, 1.0);
  vec4 b = clip_from_world * vec4(end, 1.0);
  bool at_end = (gl_VertexID & 1) == 1;
  float side = (gl_VertexID & 2) == 2 ? 1.0 : -1.0;
  fragment_color = at_end ? end_color : start_color;
  if (depth(a) <= 0.0 && depth(b) <= 0.0) {
    across = 0.0;
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    return;
  }
  // Divided here, so that the width across is interpolated in pixels whatever the perspective.
  vec4 near_a = clipped(a, b), near_b = clipped(b, a);
  vec3 p = near_a.xyz / near_a.w, q = near_b.xyz / near_b.w;
  vec2 along = (q.xy - p.xy) * viewport;
  float length_px = length(along);
  along = length_px > 1e-6 ? along / length_px : vec2(1.0, 0.0);
  // Half a pixel more on each side for the soft edge.
  float reach = 0.5 * width + 0.5;
  across = side * reach;
  vec3 corner = at_end ? q : p;
  corner.xy += vec2(-along.y, along.x) * side * reach * 2.0 / viewport;
  gl_Position = vec4(corner.x, -corner.y, corner.z, 1.0);  // row 0 of the texture is the top
}
