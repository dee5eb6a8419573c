// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/own_files.hpp"

#include <dlfcn.h>

#include <cstring>
#include <system_error>
#include <utility>

namespace footfall::detail {

std::vector<std::filesystem::path> ownFiles() {
  std::vector<std::filesystem::path> files;
  Dl_info info{};
  std::error_code error;
  if (::dladdr(reinterpret_cast<const void*>(&ownFiles), &info) != 0 && info.dli_fname != nullptr &&
      std::strchr(info.dli_fname, '/') != nullptr) {
    std::filesystem::path file = std::filesystem::canonical(info.dli_fname, error);
    if (!error) files.push_back(std::move(file));
  }
  std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  if (!error) files.push_back(std::move(program));
  return files;
}

}  // namespace footfall::detail
