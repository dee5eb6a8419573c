// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/foreign/gltf_buffers.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>

#include "core/io/base64.hpp"
#include "core/io/foreign/gltf_decoders.hpp"
#include "core/io/gltf/gltf_scene.hpp"
#include "core/io/input_file.hpp"

namespace footfall::detail {
namespace {

using Json = nlohmann::json;

constexpr std::uint32_t kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;
constexpr std::uint64_t kMostElements = std::uint64_t{1} << 33;

[[noreturn]] void failShort() { failGltf(FOOTFALL_TEXT("it ends before the numbers that it announces")); }

std::uint32_t wordAt(std::string_view bytes, std::size_t at) {
  if (bytes.size() < 4 || at > bytes.size() - 4) failShort();
  std::uint32_t word = 0;
  std::memcpy(&word, bytes.data() + at, sizeof word);
  return word;
}

/// A URI with its %20 and the like decoded.
std::string decodedUri(std::string_view uri) {
  std::string name;
  const auto digit = [](char c) {
    return c >= '0' && c <= '9' ? c - '0' : (c | 32) >= 'a' && (c | 32) <= 'f' ? (c | 32) - 'a' + 10 : -1;
  };
  for (std::size_t i = 0; i < uri.size(); ++i) {
    if (uri[i] == '%' && i + 2 < uri.size() && digit(uri[i + 1]) >= 0 && digit(uri[i + 2]) >= 0) {
      name += static_cast<char>(digit(uri[i + 1]) * 16 + digit(uri[i + 2]));
      i += 2;
    } else {
      name += uri[i];
    }
  }
  return name;
}

std::size_t widthOf(const std::string& type) {
  constexpr std::array<std::string_view, 7> kTypes = {"SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"};
  constexpr std::array<std::size_t, 7> kWidths = {1, 2, 3, 4, 4, 9, 16};
  const auto found = std::ranges::find(kTypes, type);
  if (found == kTypes.end()) failGltf(Text(FOOTFALL_TEXT("an accessor has the unknown type '%1'"), type));
  return kWidths[static_cast<std::size_t>(found - kTypes.begin())];
}

std::size_t componentSize(std::uint64_t type) {
  switch (type) {
    case 5120:
    case 5121:
      return 1;
    case 5122:
    case 5123:
      return 2;
    case 5125:
    case 5126:
      return 4;
    default:
      failGltf(Text(FOOTFALL_TEXT("an accessor has the unknown component type %1"), type));
  }
}

template <class Number>
Number numberAt(const char* bytes) {
  Number number;
  std::memcpy(&number, bytes, sizeof number);
  return number;
}

double componentAt(const char* bytes, std::uint64_t type, bool normalized) {
  switch (type) {
    case 5120:
      return normalized ? std::max(numberAt<std::int8_t>(bytes) / 127.0, -1.0) : numberAt<std::int8_t>(bytes);
    case 5121:
      return numberAt<std::uint8_t>(bytes) / (normalized ? 255.0 : 1.0);
    case 5122:
      return normalized ? std::max(numberAt<std::int16_t>(bytes) / 32767.0, -1.0) : numberAt<std::int16_t>(bytes);
    case 5123:
      return numberAt<std::uint16_t>(bytes) / (normalized ? 65535.0 : 1.0);
    case 5125:
      return numberAt<std::uint32_t>(bytes);
    default:
      return static_cast<double>(numberAt<float>(bytes));
  }
}

struct Layout {
  std::uint64_t type = 0, count = 0;
  std::size_t component = 0, width = 0;
  bool normalized = false;
  [[nodiscard]] std::size_t elementBytes() const { return component * width; }
};

Layout layoutOf(const Json& accessor) {
  Layout layout;
  layout.type = gltfNumber(accessor, "componentType");
  layout.count = gltfNumber(accessor, "count");
  layout.component = componentSize(layout.type);
  layout.width = widthOf(gltfText(accessor, "type"));
  const auto normalized = accessor.find("normalized");
  layout.normalized = normalized != accessor.end() && normalized->is_boolean() && normalized->get<bool>();
  if (layout.count > kMostElements) failShort();
  return layout;
}

/// Calls take(number of the element, its first byte).
template <class Take>
void forElements(std::string_view bytes, std::uint64_t offset, std::uint64_t stride, const Layout& layout,
                 const Take& take) {
  if (layout.count == 0) return;
  const std::uint64_t size = layout.elementBytes();
  if (stride == 0) stride = size;
  if (offset > bytes.size() || size > bytes.size() - offset ||
      (layout.count - 1) > (bytes.size() - offset - size) / stride)
    failGltf(FOOTFALL_TEXT("an accessor is out of range of its buffer"));
  for (std::uint64_t i = 0; i < layout.count; ++i) take(i, bytes.data() + offset + i * stride);
}

}  // namespace

GltfBuffers::GltfBuffers(const std::string& path) : path_(path), file_(readInputFile(path, nullptr)) {
  std::string_view text = file_;
  if (text.starts_with("glTF")) {
    if (wordAt(text, 4) != 2) failGltf(FOOTFALL_TEXT("it is binary glTF of another version than 2"));
    const std::size_t size = wordAt(text, 12);
    if (wordAt(text, 16) != kJsonChunk || size > text.size() - 20) failShort();
    const std::string_view rest = text.substr(20 + size);
    text = text.substr(20, size);
    if (rest.size() >= 8 && wordAt(rest, 4) == kBinaryChunk) {
      const std::size_t length = wordAt(rest, 0);
      if (length > rest.size() - 8) failShort();
      binary_ = rest.substr(8, length);
    }
  }
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  json_ = Json::parse(text, nullptr, false);
  if (!json_.is_object()) failGltf(FOOTFALL_TEXT("it is not JSON, or is truncated"));
  if (gltfText(gltfObject(json_, "asset"), "version").starts_with("1")) throw OldGltf{};
}

std::string_view GltfBuffers::buffer(std::uint64_t number) {
  const Json& buffer = gltfItem(json_, "buffers", number);
  if (!buffer.contains("uri")) {
    if (number == 0 && binary_.data() != nullptr) return binary_;
    failGltf(Text(FOOTFALL_TEXT("buffer %1 has no content"), number));
  }
  const auto known = buffers_.find(number);
  if (known != buffers_.end()) return known->second;
  const std::string uri = gltfText(buffer, "uri");
  std::string bytes;
  if (uri.starts_with("data:")) {
    const std::size_t comma = uri.find(',');
    if (comma == std::string::npos || uri.substr(0, comma).find(";base64") == std::string::npos)
      failGltf(Text(FOOTFALL_TEXT("buffer %1 is packed in a way that is not known"), number));
    bytes = fromBase64(std::string_view(uri).substr(comma + 1));
  } else {
    const std::filesystem::path file = std::filesystem::path(path_).parent_path() / decodedUri(uri);
    try {
      bytes = readInputFile(file.string(), nullptr);
    } catch (const InputError& error) {
      failGltf(error.text());
    }
  }
  return buffers_.emplace(number, std::move(bytes)).first->second;
}

std::string_view GltfBuffers::within(std::uint64_t number, std::uint64_t offset, std::uint64_t length) {
  const std::string_view bytes = buffer(number);
  if (offset > bytes.size() || length > bytes.size() - offset) failShort();
  return bytes.substr(offset, length);
}

std::string_view GltfBuffers::view(std::uint64_t number) {
  const Json& view = gltfItem(json_, "bufferViews", number);
  const Json& extensions = gltfObject(view, "extensions");
  const auto packed = extensions.find("EXT_meshopt_compression");
  if (packed == extensions.end())
    return within(gltfNumber(view, "buffer"), gltfNumber(view, "byteOffset", 0), gltfNumber(view, "byteLength"));
  if (!packed->is_object()) failGltf(Text(FOOTFALL_TEXT("'%1' is not an object"), "EXT_meshopt_compression"));
  const auto known = unpacked_.find(number);
  if (known != unpacked_.end()) return known->second;
  const MeshoptView how{gltfText(*packed, "mode"), gltfText(*packed, "filter"), gltfNumber(*packed, "count"),
                        gltfNumber(*packed, "byteStride")};
  const std::string_view bytes =
      within(gltfNumber(*packed, "buffer"), gltfNumber(*packed, "byteOffset", 0), gltfNumber(*packed, "byteLength"));
  return unpacked_.emplace(number, decodeMeshopt(bytes, how)).first->second;
}

GltfNumbers GltfBuffers::numbers(std::uint64_t number) {
  const Json& accessor = gltfItem(json_, "accessors", number);
  const Layout layout = layoutOf(accessor);
  GltfNumbers result;
  result.width = layout.width;
  const auto put = [&](std::uint64_t element, const char* bytes) {
    for (std::size_t k = 0; k < layout.width; ++k)
      result.values[element * layout.width + k] =
          componentAt(bytes + k * layout.component, layout.type, layout.normalized);
  };
  if (accessor.contains("bufferView")) {
    const std::uint64_t from = gltfNumber(accessor, "bufferView");
    const std::string_view bytes = view(from);
    if (layout.count > bytes.size()) failGltf(FOOTFALL_TEXT("an accessor is out of range of its buffer"));
    result.values.resize(layout.count * layout.width);
    forElements(bytes, gltfNumber(accessor, "byteOffset", 0),
                gltfNumber(gltfItem(json_, "bufferViews", from), "byteStride", 0), layout, put);
  } else {
    result.values.resize(layout.count * layout.width);  // zeros, some of which a sparse accessor may replace
  }
  const auto sparse = accessor.find("sparse");
  if (sparse == accessor.end()) return result;
  if (!sparse->is_object()) failGltf(Text(FOOTFALL_TEXT("'%1' is not an object"), "sparse"));
  const Json &places = gltfObject(*sparse, "indices"), &values = gltfObject(*sparse, "values");
  Layout listed;
  listed.type = gltfNumber(places, "componentType");
  listed.component = componentSize(listed.type);
  listed.width = 1;
  listed.count = gltfNumber(*sparse, "count");
  const std::string_view placeBytes = view(gltfNumber(places, "bufferView"));
  if (listed.count > placeBytes.size()) failShort();
  std::vector<std::uint64_t> at(listed.count);
  forElements(placeBytes, gltfNumber(places, "byteOffset", 0), 0, listed, [&](std::uint64_t i, const char* bytes) {
    const double place = componentAt(bytes, listed.type, false);
    if (!(place >= 0 && place < static_cast<double>(layout.count)))
      failGltf(FOOTFALL_TEXT("a sparse accessor is out of range"));
    at[i] = static_cast<std::uint64_t>(place);
  });
  Layout replaced = layout;
  replaced.count = listed.count;
  forElements(view(gltfNumber(values, "bufferView")), gltfNumber(values, "byteOffset", 0), 0, replaced,
              [&](std::uint64_t i, const char* bytes) { put(at[i], bytes); });
  return result;
}

std::vector<std::uint32_t> GltfBuffers::indices(std::uint64_t number) {
  const GltfNumbers all = numbers(number);
  if (all.width != 1) failGltf(FOOTFALL_TEXT("a list of corners does not have single numbers"));
  std::vector<std::uint32_t> result;
  result.reserve(all.values.size());
  for (const double value : all.values) {
    if (!(value >= 0 && value <= 0xFFFFFFFFU && value == std::floor(value)))
      failGltf(FOOTFALL_TEXT("a list of corners has numbers that are no indices"));
    result.push_back(static_cast<std::uint32_t>(value));
  }
  return result;
}

}  // namespace footfall::detail
