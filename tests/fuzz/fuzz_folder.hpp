// Files of a fuzz target that a reader needs by name.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>

#include "tests/fuzz/fuzz_target.hpp"

namespace footfall::fuzz {

/// A folder of this process, in memory where there is one, gone at the end.
class FuzzFolder {
 public:
  FuzzFolder() {
    const std::filesystem::path memory = "/dev/shm";
    const auto parent = std::filesystem::is_directory(memory) ? memory : std::filesystem::temp_directory_path();
    folder_ = parent / ("footfall-fuzz-" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder_);
  }
  ~FuzzFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  FuzzFolder(const FuzzFolder&) = delete;
  FuzzFolder& operator=(const FuzzFolder&) = delete;

  [[nodiscard]] std::string file(const std::string& name) const { return (folder_ / name).string(); }

  /// Writes a file and returns its path.
  [[nodiscard]] std::string write(const std::string& name, std::string_view bytes) const {
    std::string path = file(name);
    std::FILE* target = std::fopen(path.c_str(), "wb");
    require(target != nullptr && std::fwrite(bytes.data(), 1, bytes.size(), target) == bytes.size() &&
                std::fclose(target) == 0,
            "cannot write " + path);
    return path;
  }

 private:
  std::filesystem::path folder_;
};

}  // namespace footfall::fuzz
