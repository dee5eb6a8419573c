#version 330
// Each instance is one segment, drawn as a screen-aligned strip of constant width: drivers need not offer wide lines.
// SPDX-License-Identifier: GPL-3.0-or-later

layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;

uniform mat4 modelViewProjection;
uniform float cut;  // what is higher is left out
uniform vec2 viewport;  // device pixels
uniform float width;    // device pixels
uniform float lift;     // towards the eye, in normalized depth

noperspective out float distance;  // device pixels from the middle of the line

// Moves the end `a` along the segment to just in front of the near plane.
vec4 clipNear(vec4 a, vec4 b) {
  float da = a.z + a.w, db = b.z + b.w;
  return da >= 0.0 || db <= 0.0 ? a : mix(a, b, (0.0001 * db - da) / (db - da));
}

void main() {
  vec4 a = modelViewProjection * vec4(from, 1.0);
  vec4 b = modelViewProjection * vec4(to, 1.0);
  if (a.z + a.w <= 0.0 && b.z + b.w <= 0.0) {
    gl_Position = vec4(0.0, 0.0, 2.0, 1.0);  // behind the eye: clipped
    return;
  }
  vec4 start = clipNear(a, b), end = clipNear(b, a);
  vec2 along = (end.xy / end.w - start.xy / start.w) * viewport;
  float size = length(along);
  along = size > 0.0 ? along / size : vec2(1.0, 0.0);
  vec2 across = vec2(-along.y, along.x);

  bool atEnd = (gl_VertexID & 2) != 0;
  gl_ClipDistance[0] = cut - (atEnd ? to.z : from.z);
  float side = (gl_VertexID & 1) != 0 ? 1.0 : -1.0;
  vec4 p = atEnd ? end : start;
  // One pixel more on each side for the soft edge; half a width beyond each end, so that segments that meet leave no
  // notch. The plane is two units wide.
  distance = side * (0.5 * width + 1.0);
  vec2 offset = (across * distance + along * (atEnd ? 0.5 : -0.5) * width) * 2.0 / viewport;
  p.xy += offset * p.w;
  p.z -= lift * p.w;
  gl_Position = p;
}
