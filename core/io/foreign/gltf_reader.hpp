// Reading glTF 2.0, in doubles, compressed or not.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/io/file_frame.hpp"
#include "footfall/environment.hpp"

namespace footfall::detail {

/// Returns whether the content of the file is glTF 2.0; its name does not count.
bool isGltf2(const std::string& path);

/// Fills `vertices`, `triangles`, `skipped`, `parts`, `partOf` and `notes` with the meshes of the scene, as
/// readForeign() does. It reads triangles, strips and fans; sparse, quantized and packed accessors
/// (KHR_mesh_quantization, EXT_meshopt_compression, KHR_draco_mesh_compression); instances (EXT_mesh_gpu_instancing);
/// skins and morph targets in the pose of the file. Node transforms are multiplied and applied in doubles; a mirroring
/// one reverses the winding (glTF 2.0, 3.7.4). Throws OldGltf (gltf_buffers.hpp) for glTF 1.
FileFrame readGltf(const std::string& path, Environment& environment);

}  // namespace footfall::detail
