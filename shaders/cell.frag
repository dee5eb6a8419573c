#version 330
// SPDX-License-Identifier: GPL-3.0-or-later

flat in vec4 paint;
flat in int veiled;  // what lies behind shows through

uniform vec4 unfinished;     // hatched where a cell has no colour yet
uniform float opacity;
uniform float patternScale;  // device pixels a logical pixel

out vec4 fragment;

void main() {
  // One pixel of four, in rows that are shifted: what lies behind stays readable, in any order of drawing.
  if (veiled != 0 && (int(gl_FragCoord.x) + 2 * int(gl_FragCoord.y)) % 4 != 0) discard;
  vec3 colour = paint.rgb;
  if (paint.a == 0.0) {
    vec2 p = gl_FragCoord.xy / patternScale;
    colour = unfinished.rgb * (1.0 - 0.35 * step(mod(p.x - p.y, 10.0), 2.0));
  }
  fragment = vec4(colour, opacity);
}
