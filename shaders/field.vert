#version 330
// Floors coloured by a number at each corner.
// SPDX-License-Identifier: GPL-3.0-or-later

layout(location = 0) in vec3 position;
layout(location = 1) in float value;
layout(location = 2) in vec4 normal;
layout(location = 3) in uint layer;

out float gl_ClipDistance[3];

uniform mat4 modelViewProjection;
uniform vec4 clipPlanes[3];  // what is behind one of them is left out
uniform bool layered;        // some layers are hidden
uniform bool leaveCovers;    // walls are left out, and floors fade
uniform sampler2D shownLayers;

out float number;
flat out float light;
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
  bool covers = (int(normal.w * 127.0 + 0.5) & 64) != 0;
  veiled = leaveCovers && covers && normal.z > kFloorNormal ? 1 : 0;
  bool leftOut = leaveCovers && covers && veiled == 0;
  if ((layered && isHidden(layer)) || leftOut) gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
  // Little of it: the colours are to be read.
  light = 0.86 + 0.14 * max(dot(normal.xyz, normalize(vec3(-0.45, -0.3, 0.84))), 0.0);
  number = value;
}
