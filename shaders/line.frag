#version 330
// SPDX-License-Identifier: GPL-3.0-or-later

noperspective in float strength;
noperspective in float distance;

uniform vec4 colour;
uniform float width;  // device pixels

out vec4 fragment;

void main() {
  // Smooth by coverage: multisampling would cost software OpenGL more than everything else.
  float coverage = clamp(0.5 * width + 0.5 - abs(distance), 0.0, 1.0);
  fragment = vec4(colour.rgb, colour.a * coverage * strength);
}
