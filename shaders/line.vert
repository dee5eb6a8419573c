#version 330
// Each instance is one segment, drawn as a screen-aligned strip of constant width: drivers need not offer wide lines.
// SPDX-License-Identifier: GPL-3.0-or-later

layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;
layout(location = 2) in vec2 crowd;    // of the lines around, for each unit of area: their length, their number
layout(location = 3) in uvec2 layers;  // on either side; 0x7fffffff: none

out float gl_ClipDistance[3];

uniform mat4 modelViewProjection;
uniform vec4 clipPlanes[3];  // what is behind one of them is left out
uniform bool layered;        // some layers are hidden
uniform sampler2D shownLayers;
uniform vec2 viewport;  // device pixels
uniform float width;    // device pixels
uniform float lift;     // towards the eye, in normalized depth

noperspective out float strength;
noperspective out float distance;  // device pixels from the middle of the line

const float kCovered = 0.3;  // at most so much of a place is covered by lines of a kind

// Moves the end `a` along the segment to just in front of the near plane.
vec4 clipNear(vec4 a, vec4 b) {
  float da = a.z + a.w, db = b.z + b.w;
  return da >= 0.0 || db <= 0.0 ? a : mix(a, b, (0.0001 * db - da) / (db - da));
}

// Layers beyond the texture, the number for none among them, are shown.
bool isHidden(uint of) {
  ivec2 size = textureSize(shownLayers, 0);
  int row = int(of) / size.x;
  return row < size.y && texelFetch(shownLayers, ivec2(int(of) % size.x, row), 0).r == 0.0;
}

// Lines that are many for their width would make one surface of their colour: each is the fainter, however far away.
float strengthAt(float w) {
  // Of a pixel, in the scene: the plane is two units high, and the rows of the matrix have the scale of the projection.
  vec3 row = vec3(modelViewProjection[0].y, modelViewProjection[1].y, modelViewProjection[2].y);
  float broad = 2.0 * w * width / (viewport.y * length(row));
  // Each is longer by its width, half of it at each end.
  float covered = broad * (crowd.x + broad * crowd.y);
  return covered > kCovered ? kCovered / covered : 1.0;
}

void main() {
  vec4 a = modelViewProjection * vec4(from, 1.0);
  vec4 b = modelViewProjection * vec4(to, 1.0);
  bool hidden = layered && isHidden(layers.x) && isHidden(layers.y);
  if (hidden || (a.z + a.w <= 0.0 && b.z + b.w <= 0.0)) {
    strength = 0.0;
    gl_Position = vec4(0.0, 0.0, 2.0, 1.0);  // clipped, as what is behind the eye
    return;
  }
  vec4 start = clipNear(a, b), end = clipNear(b, a);
  vec2 along = (end.xy / end.w - start.xy / start.w) * viewport;
  float size = length(along);
  along = size > 0.0 ? along / size : vec2(1.0, 0.0);
  vec2 across = vec2(-along.y, along.x);

  bool atEnd = (gl_VertexID & 2) != 0;
  for (int i = 0; i < 3; ++i) gl_ClipDistance[i] = dot(clipPlanes[i], vec4(atEnd ? to : from, 1.0));
  float side = (gl_VertexID & 1) != 0 ? 1.0 : -1.0;
  vec4 p = atEnd ? end : start;
  strength = strengthAt(p.w);
  // One pixel more on each side for the soft edge; half a width beyond each end, so that segments that meet leave no
  // notch. The plane is two units wide.
  distance = side * (0.5 * width + 1.0);
  vec2 offset = (across * distance + along * (atEnd ? 0.5 : -0.5) * width) * 2.0 / viewport;
  p.xy += offset * p.w;
  p.z -= lift * p.w;
  gl_Position = p;
}
