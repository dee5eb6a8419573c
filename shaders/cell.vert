#version 330
// Floors by cell: each takes its cell's colour out of a texture, so that colours can change without the geometry.
// SPDX-License-Identifier: GPL-3.0-or-later

layout(location = 0) in vec3 position;
layout(location = 1) in uint cell;  // the highest bit: on a cover; the next: of a hidden layer

out float gl_ClipDistance[3];

uniform mat4 modelViewProjection;
uniform vec4 clipPlanes[3];  // what is behind one of them is left out
uniform sampler2D colours;
uniform bool leaveCovers;  // floors that are covers fade
uniform vec4 onlyColour;  // for all cells, unless its alpha is 0

flat out vec4 paint;  // alpha 0: the cell has no colour yet
flat out int veiled;  // the floor fades

void main() {
  gl_Position = modelViewProjection * vec4(position, 1.0);
  for (int i = 0; i < 3; ++i) gl_ClipDistance[i] = dot(clipPlanes[i], vec4(position, 1.0));
  veiled = leaveCovers && (cell & 0x80000000u) != 0u ? 1 : 0;
  if ((cell & 0x40000000u) != 0u) gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
  int number = int(cell & 0x3fffffffu);
  if (onlyColour.a > 0.0) {
    paint = onlyColour;
    return;
  }
  int width = textureSize(colours, 0).x;
  paint = texelFetch(colours, ivec2(number % width, number / width), 0);
}
