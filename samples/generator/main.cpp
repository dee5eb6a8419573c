// footfall-samples FOLDER: writes FOLDER/<name>/<name>.obj for every sample.
// footfall-samples city TRIANGLES FILE.obj: writes a city of at least so many triangles, whole tiles of it.
// SPDX-License-Identifier: GPL-3.0-or-later
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

namespace {

int writeCityFile(const std::string& triangles, const std::string& path) {
  using namespace footfall::samples;
  std::uint64_t count = 0;
  const auto [end, error] = std::from_chars(triangles.data(), triangles.data() + triangles.size(), count);
  if (error != std::errc() || end != triangles.data() + triangles.size() || count == 0) {
    std::cerr << triangles << ": is no number of triangles; give a whole number above 0\n";
    return 2;
  }
  std::ofstream file(path, std::ios::binary);
  const CitySize size = writeCity(file, count);
  file.close();
  if (!file) {
    std::cerr << path << ": cannot be written; check the folder and free space\n";
    return 1;
  }
  std::cout << size.tiles << " tiles, " << size.triangles << " triangles, " << size.vertices << " vertices\n";
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace footfall::samples;
  if (argc == 4 && std::string(argv[1]) == "city") return writeCityFile(argv[2], argv[3]);
  const std::string_view folder = argc == 2 ? argv[1] : "";
  if (folder.empty() || folder.starts_with('-')) {
    const bool isAsked = folder == "--help" || folder == "-h";
    (isAsked ? std::cout : std::cerr)
        << "usage: footfall-samples FOLDER, or footfall-samples city TRIANGLES FILE.obj\n";
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
