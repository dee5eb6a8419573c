// footfall-samples FOLDER: writes FOLDER/<name>/<name>.obj for every sample.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>

#include "samples.hpp"

int main(int argc, char** argv) {
  using namespace footfall::samples;
  if (argc != 2) {
    std::cerr << "usage: footfall-samples FOLDER\n";
    return 2;
  }
  try {
    for (const Sample& sample : kSamples) {
      const Mesh mesh = sample.make();
      const std::filesystem::path folder = std::filesystem::path(argv[1]) / sample.name;
      std::filesystem::create_directories(folder);
      const std::filesystem::path path = folder / (std::string(sample.name) + ".obj");
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
