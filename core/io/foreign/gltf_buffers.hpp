// The numbers of a glTF 2.0 file: buffers, packed or not, views of them, accessors.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace footfall::detail {

/// The elements of an accessor, each of `width` numbers.
struct GltfNumbers {
  std::size_t width = 0;
  std::vector<double> values;

  [[nodiscard]] std::size_t size() const { return width == 0 ? 0 : values.size() / width; }
  [[nodiscard]] double at(std::size_t element, std::size_t number) const { return values[element * width + number]; }
};

/// Thrown for a file of glTF 1, which is another format.
struct OldGltf {};

/// A file with all its buffers. Its functions throw BadGltf for invalid content, and InputError for a buffer that
/// cannot be read or is no regular file.
class GltfBuffers {
 public:
  /// Reads a file, JSON or binary. Throws OldGltf.
  explicit GltfBuffers(const std::string& path);

  [[nodiscard]] const nlohmann::json& json() const { return json_; }

  /// An accessor's numbers as doubles; normalized integers are divided.
  GltfNumbers numbers(std::uint64_t accessor);
  /// The numbers of an accessor of integers.
  std::vector<std::uint32_t> indices(std::uint64_t accessor);
  /// The bytes of a buffer view, unpacked.
  std::string_view view(std::uint64_t number);

 private:
  std::string_view buffer(std::uint64_t number);
  std::string_view within(std::uint64_t buffer, std::uint64_t offset, std::uint64_t length);

  std::string path_;
  std::string file_;
  std::string_view binary_;  ///< the second chunk of a binary file
  nlohmann::json json_;
  std::map<std::uint64_t, std::string> buffers_, unpacked_;
};

}  // namespace footfall::detail
