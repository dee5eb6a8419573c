// SPDX-License-Identifier: GPL-3.0-or-later
#version 330

uniform vec4 colour;

out vec4 fragment;

void main() { fragment = colour; }
