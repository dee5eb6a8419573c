#version 330
// Patterns lie on the screen, not on the surface: they stay readable at every distance.
// SPDX-License-Identifier: GPL-3.0-or-later

flat in vec3 shade;
flat in int pattern;  // ui/appearance.hpp: 0 plain, 1 rising stripes, 2 falling stripes, 3 dots, 4 grid,
                      // 5 level stripes, 6 upright stripes
flat in int veiled;   // what lies behind shows through

uniform float patternScale;  // device pixels a logical pixel
uniform bool asBackground;   // what is there is not to be seen, nor what lies under it
uniform vec3 lower, upper;   // colours of the background
uniform float viewHeight;    // device pixels
uniform bool hatchBacks;     // so that a cut reads: what is seen from behind is hatched

out vec4 fragment;

void main() {
  // One pixel of four, in rows that are shifted: what lies behind stays readable, in any order of drawing.
  if (veiled != 0 && (int(gl_FragCoord.x) + 2 * int(gl_FragCoord.y)) % 4 != 0) discard;
  if (asBackground) {
    fragment = vec4(mix(lower, upper, gl_FragCoord.y / viewHeight), 1.0);
    return;
  }
  vec2 p = gl_FragCoord.xy / patternScale;
  if (hatchBacks && !gl_FrontFacing) {
    float hatch = step(mod(p.x + p.y, 6.0), 1.5);
    fragment = vec4(mix(shade * 0.55, vec3(0.16), 0.55 * hatch), 1.0);
    return;
  }
  float ink = 0.0;
  if (pattern != 0) {
    if (pattern == 1) ink = step(mod(p.x - p.y, 8.0), 2.5);
    else if (pattern == 2) ink = step(mod(p.x + p.y, 8.0), 2.5);
    else if (pattern == 3) ink = step(distance(mod(p, 6.0), vec2(3.0)), 1.6);
    else if (pattern == 4) ink = max(step(mod(p.x, 8.0), 2.0), step(mod(p.y, 8.0), 2.0));
    else if (pattern == 5) ink = step(mod(p.y, 8.0), 2.5);
    else ink = step(mod(p.x, 8.0), 2.5);
  }
  fragment = vec4(shade * (1.0 - 0.45 * ink), 1.0);
}
