#version 330
// Patterns lie on the screen, not on the surface: they stay readable at every distance.
// SPDX-License-Identifier: GPL-3.0-or-later

flat in vec3 shade;
flat in int pattern;  // ui/appearance.hpp: 0 plain, 1 rising stripes, 2 falling stripes, 3 dots

uniform float patternScale;  // device pixels a logical pixel

out vec4 fragment;

void main() {
  float ink = 0.0;
  if (pattern != 0) {
    vec2 p = gl_FragCoord.xy / patternScale;
    if (pattern == 1) ink = step(mod(p.x - p.y, 8.0), 2.5);
    else if (pattern == 2) ink = step(mod(p.x + p.y, 8.0), 2.5);
    else ink = step(distance(mod(p, 6.0), vec2(3.0)), 1.6);
  }
  fragment = vec4(shade * (1.0 - 0.45 * ink), 1.0);
}
