#version 330
// SPDX-License-Identifier: GPL-3.0-or-later

in float height;

uniform vec3 lower;
uniform vec3 upper;

out vec4 fragment;

void main() { fragment = vec4(mix(lower, upper, height), 1.0); }
