#version 330
// SPDX-License-Identifier: GPL-3.0-or-later

uniform vec4 colour;

out vec4 fragment;

void main() { fragment = colour; }
