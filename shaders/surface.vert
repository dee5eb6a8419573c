#version 330
// Surfaces with one normal and one paint a triangle. The light is computed once a triangle, not once a pixel.
// SPDX-License-Identifier: GPL-3.0-or-later

layout(location = 0) in vec3 position;
layout(location = 1) in vec4 normal;  // w: pattern, 0 to 127 / 127
layout(location = 2) in vec4 colour;  // alpha 0: takes the uniform paint

uniform mat4 modelViewProjection;
uniform float cut;  // what is higher is left out
uniform vec3 eye;          // in the scene's coordinates
uniform vec3 viewDirection;
uniform bool orthographic;
uniform float pale;        // from 0, the paint's own colour, to 1, hardly any: for what something is drawn over
uniform vec4 floorPaint;   // rgb and pattern for triangles with alpha 0

flat out vec3 shade;
flat out int pattern;

void main() {
  gl_Position = modelViewProjection * vec4(position, 1.0);
  gl_ClipDistance[0] = cut - position.z;
  vec3 n = normal.xyz;
  vec3 toEye = orthographic ? -viewDirection : normalize(eye - position);
  float facing = dot(n, toEye);
  vec3 seen = facing < 0.0 ? -n : n;
  float sky = 0.5 + 0.5 * seen.z;
  float sun = max(dot(seen, normalize(vec3(-0.45, -0.3, 0.84))), 0.0);
  float head = abs(facing);
  float light = 0.42 + 0.22 * sky + 0.24 * sun + 0.14 * head;
  if (facing < 0.0) light *= 0.8;

  bool floored = colour.a == 0.0;
  pattern = int((floored ? floorPaint.a : normal.w) * 127.0 + 0.5);
  shade = mix(floored ? floorPaint.rgb : colour.rgb, vec3(0.9), pale) * light;
}
