#version 330
// SPDX-License-Identifier: GPL-3.0-or-later

in float number;
flat in float light;
flat in int veiled;  // what lies behind shows through

uniform sampler2D scale;     // one row of colours
uniform vec2 range;          // what the first and the last of them stand for
uniform vec2 limit;          // x: the limit, y: 1 above it is rejected, -1 below it, 0 there is no limit
uniform float tolerance;     // what is beyond the limit by less is at it
uniform float patternScale;  // device pixels a logical pixel

out vec4 fragment;

void main() {
  // One pixel of four, in rows that are shifted: what lies behind stays readable, in any order of drawing.
  if (veiled != 0 && (int(gl_FragCoord.x) + 2 * int(gl_FragCoord.y)) % 4 != 0) discard;
  vec3 colour = texture(scale, vec2(clamp((number - range.x) / (range.y - range.x), 0.002, 0.998), 0.5)).rgb;
  if ((number - limit.x) * limit.y > tolerance) {
    vec2 p = gl_FragCoord.xy / patternScale;
    colour = mix(colour, vec3(0.0), 0.38 * step(mod(p.x - p.y, 8.0), 2.0));
  }
  fragment = vec4(colour * light, 1.0);
}
