// Any bytes as a PLY file (the first byte is p) or an STL file: an environment in order, or one line of error. Through
// Assimp, whose own mistakes show as its library on top of the stack; what it has for other formats hangs or writes
// where it must not within seconds, and is left out (README.md).
// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <cmath>
#include <filesystem>

#include "core/io/import.hpp"
#include "tests/fuzz/fuzz_target.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::fuzz;

namespace {

/// A folder of this process in memory where there is one, gone at the end.
class Folder {
 public:
  Folder() {
    const std::filesystem::path memory = "/dev/shm";
    const auto parent = std::filesystem::is_directory(memory) ? memory : std::filesystem::temp_directory_path();
    folder_ = parent / ("footfall-fuzz-" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder_);
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  [[nodiscard]] std::string file(const std::string& extension) const {
    return (folder_ / "fuzz.").string() + extension;
  }

 private:
  std::filesystem::path folder_;
};

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Folder folder;
  if (size == 0) return 0;
  const std::string path = folder.file(data[0] == 'p' ? "ply" : "stl");
  std::FILE* file = std::fopen(path.c_str(), "wb");
  require(file != nullptr && std::fwrite(data + 1, 1, size - 1, file) == size - 1 && std::fclose(file) == 0,
          "cannot write " + path);
  try {
    const auto environment = importEnvironment(path);
    require(!environment->triangles.empty(), "an environment without triangles was accepted");
    for (const Vec3& v : environment->vertices)
      require(std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z), "a coordinate is not finite");
    for (const Triangle& t : environment->triangles)
      for (const std::uint32_t v : t) require(v < environment->vertices.size(), "an index is out of range");
  } catch (const InputError& error) {
    requireGoodMessage(error.what(), path);
  } catch (const std::bad_alloc&) {  // Assimp believes counts in files
  }
  return 0;
}
