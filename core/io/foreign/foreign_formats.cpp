// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/foreign/foreign_formats.hpp"

#include "core/io/foreign/assimp_reader.hpp"
#include "core/io/foreign/gltf_buffers.hpp"
#include "core/io/foreign/gltf_reader.hpp"

namespace footfall::detail {

FileFrame readForeignFile(const std::string& path, Environment& environment) {
  if (isGltf2(path)) {
    try {
      return readGltf(path, environment);
    } catch (const OldGltf&) {  // Assimp reads glTF 1
    }
  }
  return readWithAssimp(path, environment, nullptr);
}

}  // namespace footfall::detail
