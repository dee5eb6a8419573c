#version 330
// Surfaces of one colour, for what tools draw over the scene.
// SPDX-License-Identifier: GPL-3.0-or-later

layout(location = 0) in vec3 position;

uniform mat4 modelViewProjection;

void main() { gl_Position = modelViewProjection * vec4(position, 1.0); }
