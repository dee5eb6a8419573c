# SPDX-License-Identifier: GPL-3.0-or-later
# What Godot 3 finds in level.tres: prints "read back: JSON" with the vertices and polygons of the resource that it has loaded.
extends SceneTree

func _init():
	var mesh = load("res://level.tres")
	var vertices = []
	for v in mesh.get_vertices():
		vertices.append("%.9f %.9f %.9f" % [v.x, v.y, v.z])  # numbers of JSON have six digits here
	var polygons = []
	for i in range(mesh.get_polygon_count()):
		polygons.append(Array(mesh.get_polygon(i)))
	print("read back: " + to_json({"vertices": vertices, "polygons": polygons}))
	quit()
