// Feeds any bytes as OBJ (the first byte is o), PLY (p) or STL to the packer, which must give a valid environment or
// one line of error. OBJ must give the result of importing the file. Assimp, which imports the others, rejects errors
// outside of the geometry (a letter in a normal) and accepts many malformed numbers; test_packed_streams compares valid
// files.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <new>

#include "core/io/import.hpp"
#include "core/io/packed/pack.hpp"
#include "tests/fuzz/fuzz_folder.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::fuzz;

namespace {

const char* nameFor(std::uint8_t kind) { return kind == 'o' ? "fuzz.obj" : kind == 'p' ? "fuzz.ply" : "fuzz.stl"; }

/// Null where it was refused.
std::shared_ptr<const Environment> importedOrRefused(const std::string& path) {
  try {
    return importEnvironment(path);
  } catch (const InputError& error) {
    requireGoodMessage(error.what(), path);
    return nullptr;
  }
}

bool packedOrRefused(const std::string& path, const std::string& target) {
  try {
    packEnvironment(path, target, {}, nullptr);
    return true;
  } catch (const InputError& error) {
    requireGoodMessage(error.what(), path);
    return false;
  }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const FuzzFolder folder;
  if (size == 0) return 0;
  const std::string path = folder.write(nameFor(data[0]), textOf(data + 1, size - 1)), target = folder.file("a.ffenv");
  try {
    const bool isPacked = packedOrRefused(path, target);
    const auto packed = isPacked ? importedOrRefused(target) : nullptr;
    require(!isPacked || packed != nullptr, "what was packed cannot be opened");
    if (packed) checkEnvironment(*packed);
    if (data[0] != 'o') return 0;
    const auto expected = importedOrRefused(path);
    require(isPacked == (expected != nullptr), "importing and packing accept different files");
    if (!expected) return 0;
    require(packed->vertices == expected->vertices && packed->triangles == expected->triangles &&
                packed->partOf == expected->partOf && packed->parts == expected->parts &&
                packed->notes == expected->notes && packed->skipped.polygons == expected->skipped.polygons,
            "an environment changes when it is packed");
  } catch (const std::bad_alloc&) {  // Assimp believes counts in files
  }
  return 0;
}
