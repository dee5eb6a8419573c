// Things that stand in rooms and gardens. Each is placed by the middle of its foot, at the origin of the frame.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapes.hpp"

namespace footfall::samples {

// Furniture; fronts look towards -Y.
void table(Mesh& mesh, int width, int depth);
void chair(Mesh& mesh);
void bed(Mesh& mesh, int width);
void shelf(Mesh& mesh, int width, int boards);
void sofa(Mesh& mesh, int width);
void wardrobe(Mesh& mesh, int width);
void kitchen(Mesh& mesh, int units);

// Outdoors.
void conifer(Mesh& mesh, int height, int sides);
void broadleaf(Mesh& mesh, int height, int sides);
void bench(Mesh& mesh);
void car(Mesh& mesh);
/// A fence along +X from the origin: posts and two rails, each a closed box.
void railFence(Mesh& mesh, int length, int spacing);
/// A balustrade along +X from the origin, balusters with six sides.
void balustrade(Mesh& mesh, int length, int spacing);

// Harbour.
void barrel(Mesh& mesh, int sides);
void bollard(Mesh& mesh);
/// A rope of triangular section that sags between two points.
void rope(Mesh& mesh, Point from, Point to, int sag, int segments);

}  // namespace footfall::samples
