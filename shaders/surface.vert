#version 330
// Surfaces with one normal and one paint a triangle. The light is computed once a triangle, not once a pixel.
// SPDX-License-Identifier: GPL-3.0-or-later

layout(location = 0) in vec3 position;
layout(location = 1) in vec4 normal;  // w: pattern, and 64 for covers, / 127
layout(location = 2) in vec4 colour;  // alpha 0: takes the uniform paint
layout(location = 3) in uint layer;   // 0x7fffffff: none; the highest bit: plain floor in place of it when it is hidden

out float gl_ClipDistance[3];

uniform mat4 modelViewProjection;
uniform vec4 clipPlanes[3];  // what is behind one of them is left out
uniform bool layered;        // some layers are hidden
uniform sampler2D shownLayers;
uniform vec3 eye;            // in the scene's coordinates
uniform vec3 viewDirection;
uniform bool orthographic;
uniform float pale;        // from 0, the paint's own colour, to 1, hardly any: for what something is drawn over
uniform vec4 floorPaint;   // rgb and pattern for triangles with alpha 0
uniform vec4 plainFloor;   // of hidden layers
uniform int unseenLayers;  // what stays of hidden layers is left out (0), plain floor (1), or all that is drawn (2)
uniform bool floorsOnly;   // of an environment
uniform bool leaveCovers;   // walls are left out, and floors fade
uniform vec4 onlyPaint;    // for everything, where `only` is set
uniform bool only;
uniform bool unlit;

flat out vec3 shade;
flat out int pattern;
flat out int veiled;  // the floor fades

const float kFloorNormal = 0.7;  // a cover that faces up by more may be walked on: it fades, and never goes

// Layers beyond the texture, the number for none among them, are shown.
bool isHidden(uint of) {
  ivec2 size = textureSize(shownLayers, 0);
  int row = int(of) / size.x;
  return row < size.y && texelFetch(shownLayers, ivec2(int(of) % size.x, row), 0).r == 0.0;
}

void main() {
  gl_Position = modelViewProjection * vec4(position, 1.0);
  for (int i = 0; i < 3; ++i) gl_ClipDistance[i] = dot(clipPlanes[i], vec4(position, 1.0));
  bool hidden = layered && isHidden(layer & 0x7fffffffu);
  bool stays = (layer & 0x80000000u) != 0u;
  bool isOut = unseenLayers == 2 ? !(hidden && stays) : hidden && !(stays && unseenLayers == 1);
  int kind = int(normal.w * 127.0 + 0.5);
  bool covers = (kind & 64) != 0;
  veiled = leaveCovers && covers && normal.z > kFloorNormal ? 1 : 0;
  bool leftOut = leaveCovers && covers && veiled == 0;
  if (isOut || (floorsOnly && colour.a != 0.0) || leftOut) gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
  vec3 n = normal.xyz;
  vec3 toEye = orthographic ? -viewDirection : normalize(eye - position);
  float facing = dot(n, toEye);
  vec3 seen = facing < 0.0 ? -n : n;
  float sky = 0.5 + 0.5 * seen.z;
  float sun = max(dot(seen, normalize(vec3(-0.45, -0.3, 0.84))), 0.0);
  float head = abs(facing);
  float light = 0.42 + 0.22 * sky + 0.24 * sun + 0.14 * head;
  if (facing < 0.0) light *= 0.8;

  vec4 paint = colour.a == 0.0 ? floorPaint : vec4(colour.rgb, float(kind & 63) / 127.0);
  if (only) paint = onlyPaint;
  if (hidden) paint = plainFloor;
  pattern = int(paint.a * 127.0 + 0.5);
  shade = mix(paint.rgb, vec3(0.9), pale) * (unlit ? 1.0 : light);
}
