// footfall-samples FOLDER: writes FOLDER/<name>/<name>.obj for every sample.
// footfall-samples city TRIANGLES FILE.obj: writes a city of at least so many triangles, whole tiles of it.
// footfall-samples scene KIND TRIANGLES FILE.obj [SEED]: writes a scene with coordinates as files by others have them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <charconv>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <string_view>
#include <system_error>

#include "city.hpp"
#include "samples.hpp"
#include "scenes.hpp"

namespace {

constexpr std::string_view kUsage =
    "usage: footfall-samples FOLDER, or footfall-samples city TRIANGLES FILE.obj,\n"
    "or footfall-samples scene town|office|foliage|noise|ramps|stands TRIANGLES FILE.obj [SEED]\n";

/// A whole number above 0; 0 after a message with the expected values.
std::uint64_t numberOf(const std::string& text, std::string_view meaning) {
  std::uint64_t count = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
  if (error == std::errc() && end == text.data() + text.size() && count > 0) return count;
  std::cerr << text << ": is no " << meaning << "; give a whole number above 0\n";
  return 0;
}

bool isWritten(std::ofstream& file, const std::string& path) {
  file.close();
  if (!file) std::cerr << path << ": cannot be written; check the folder and free space\n";
  return static_cast<bool>(file);
}

int writeSceneFile(int count, char** texts) {
  using namespace footfall::samples;
  const std::string name = texts[0], path = texts[2];
  const auto* const kind =
      std::find_if(kScenes.begin(), kScenes.end(), [&](const SceneKind& scene) { return scene.name == name; });
  if (kind == kScenes.end()) {
    std::cerr << name << ": is no kind of scene\n" << kUsage;
    return 2;
  }
  const std::uint64_t triangles = numberOf(texts[1], "number of triangles");
  const std::uint64_t seed = count == 4 ? numberOf(texts[3], "seed") : 1;
  if (triangles == 0 || seed == 0) return 2;
  std::ofstream file(path, std::ios::binary);
  const SceneSize size = kind->write(file, triangles, seed);
  if (!isWritten(file, path)) return 1;
  std::cout << size.triangles << " triangles, " << size.vertices << " vertices\n";
  return 0;
}

int writeCityFile(const std::string& triangles, const std::string& path) {
  using namespace footfall::samples;
  const std::uint64_t count = numberOf(triangles, "number of triangles");
  if (count == 0) return 2;
  std::ofstream file(path, std::ios::binary);
  const CitySize size = writeCity(file, count);
  if (!isWritten(file, path)) return 1;
  std::cout << size.tiles << " tiles, " << size.triangles << " triangles, " << size.vertices << " vertices\n";
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace footfall::samples;
  if (argc == 4 && std::string(argv[1]) == "city") return writeCityFile(argv[2], argv[3]);
  if ((argc == 5 || argc == 6) && std::string(argv[1]) == "scene") return writeSceneFile(argc - 2, argv + 2);
  const std::string_view folder = argc == 2 ? argv[1] : "";
  if (folder.empty() || folder.starts_with('-')) {
    const bool isAsked = folder == "--help" || folder == "-h";
    (isAsked ? std::cout : std::cerr) << kUsage;
    return isAsked ? 0 : 2;
  }
  try {
    for (const Sample& sample : kSamples) {
      const Mesh mesh = sample.make();
      const std::filesystem::path own = std::filesystem::path(folder) / sample.name;
      std::filesystem::create_directories(own);
      const std::filesystem::path path = own / (std::string(sample.name) + ".obj");
      std::ofstream file(path, std::ios::binary);
      file << mesh.obj(sample.description);
      file.close();
      if (!file) {
        std::cerr << path.string() << ": cannot be written; check the folder and free space\n";
        return 1;
      }
      std::cout << sample.name << ": " << mesh.triangleCount() << " triangles, " << mesh.vertexCount() << " vertices\n";
    }
  } catch (const std::exception& error) {
    std::cerr << argv[1] << ": " << error.what() << "\n";
    return 1;
  }
  return 0;
}
