// SPDX-License-Identifier: GPL-3.0-or-later
// The names that environments' files give to other files. Whether such a file exists decides, so a name that is found
// in vain does no harm.
#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <set>
#include <string_view>

#include "core/io/folder_reader.hpp"
#include "core/io/write_targets.hpp"

namespace footfall::detail {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kBlock = std::size_t{4} << 20;
constexpr std::size_t kLeastBlock = std::size_t{1} << 16;
constexpr std::size_t kLongestName = 4096;  // the limit of Linux; also the overlap of two blocks
constexpr std::size_t kHeader = 65536;      // PLY files name textures within these bytes
constexpr std::array<std::string_view, 16> kPictureEndings = {".png",  ".jpg",  ".jpeg", ".tga",  ".bmp", ".tif",
                                                              ".dds",  ".hdr",  ".exr",  ".gif",  ".psd", ".ktx",
                                                              ".tiff", ".webp", ".ktx2", ".basis"};
constexpr std::string_view kBlank = " \t\r";

std::string lowered(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char c) { return std::tolower(c); });
  return lower;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

/// Calls `visit` with the file piece by piece. Each piece begins with the last bytes of the previous one, so that no
/// name is cut.
void readPieces(const std::string& path, std::size_t most, const std::function<void(std::string_view)>& visit) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return;
  std::ifstream file(path, std::ios::binary);
  const std::size_t size = fs::file_size(path, error);
  const std::size_t block = error ? kBlock : std::clamp(size + 1, kLeastBlock, kBlock);  // + 1 to notice the end
  std::string piece;
  for (std::size_t done = 0; file && done < most;) {
    const std::size_t kept = std::min(piece.size(), kLongestName);
    piece.erase(0, piece.size() - kept);
    const std::size_t wanted = std::min(block, most - done);
    piece.resize(kept + wanted);
    file.read(piece.data() + kept, static_cast<std::streamsize>(wanted));
    const auto count = static_cast<std::size_t>(file.gcount());
    piece.resize(kept + count);
    done += count;
    visit(piece);
  }
}

/// The files that were found, without duplicates.
class Companions {
 public:
  explicit Companions(const std::string& environment) : folder_(fs::path(environment).parent_path()) {}

  /// Returns whether such a file exists, either under its name or under its last part beside the environment.
  bool add(std::string_view name) {
    if (name.empty() || name.size() > kLongestName || name.find('\0') != std::string_view::npos) return false;
    if (name.starts_with("file://")) name.remove_prefix(7);
    std::string text(name);
    std::replace(text.begin(), text.end(), '\\', '/');
    const fs::path given(text);
    std::error_code error;
    for (const fs::path& path : {folder_ / given, folder_ / given.filename()}) {
      if (!fs::is_regular_file(path, error)) continue;
      found_.insert(path.string());
      return true;
    }
    return false;
  }
  /// Names may hold blanks, and other text may precede them: everything that begins after one of `breaks` is tried.
  void addEndOf(std::string_view text, std::string_view breaks) {
    for (std::size_t at = 0; at < text.size();) {
      if (add(text.substr(at))) return;
      const std::size_t next = text.find_first_of(breaks, at);
      if (next == std::string_view::npos) return;
      at = std::min(text.find_first_not_of(breaks, next), text.size());
    }
  }

  [[nodiscard]] const std::set<std::string>& found() const { return found_; }

 private:
  fs::path folder_;
  std::set<std::string> found_;
};

template <class Visit>
void forLinesWith(std::string_view text, std::string_view word, Visit visit) {
  for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + word.size())) {
    const std::size_t stop = std::min(text.find('\n', at), text.size());
    visit(trimmed(text.substr(at + word.size(), stop - at - word.size())));
  }
}

void scanObj(const std::string& path, Companions& companions) {
  readPieces(path, std::numeric_limits<std::size_t>::max(), [&](std::string_view text) {
    forLinesWith(text, "mtllib", [&](std::string_view names) {
      if (companions.add(names)) return;
      while (!names.empty()) {  // several names
        const std::size_t end = std::min(names.find_first_of(kBlank), names.size());
        companions.add(names.substr(0, end));
        names = trimmed(names.substr(end));
      }
    });
  });
  const std::set<std::string> libraries = companions.found();
  for (const std::string& library : libraries) {
    readPieces(library, std::numeric_limits<std::size_t>::max(), [&](std::string_view text) {
      for (const std::string_view word : {"map_", "bump", "disp", "decal", "refl", "norm"})
        forLinesWith(text, word, [&](std::string_view rest) { companions.addEndOf(rest, kBlank); });
    });
  }
}

/// A JSON string up to its closing quote. %20 and the like are decoded, as in URIs.
std::string uriAt(std::string_view text) {
  const auto hex = [&](std::size_t at, std::size_t count) {
    unsigned value = 0;
    for (std::size_t i = at; i < at + count; ++i) {
      if (i >= text.size() || std::isxdigit(static_cast<unsigned char>(text[i])) == 0) return 0U;
      const int digit = std::tolower(text[i]);
      value = value * 16 + static_cast<unsigned>(digit <= '9' ? digit - '0' : digit - 'a' + 10);
    }
    return value;
  };
  std::string name;
  for (std::size_t i = 0; i < text.size() && text[i] != '"' && name.size() <= kLongestName; ++i) {
    if (text[i] == '%' && hex(i + 1, 2) > 0) {
      name += static_cast<char>(hex(i + 1, 2));
      i += 2;
    } else if (text[i] == '\\' && i + 1 < text.size()) {
      ++i;
      const unsigned code = text[i] == 'u' ? hex(i + 1, 4) : 0;
      if (code > 0 && code < 0x80) name += static_cast<char>(code);
      if (text[i] == 'u') {
        i += 4;
      } else {
        name += text[i];
      }
    } else {
      name += text[i];
    }
  }
  return name;
}

void scanGltf(const std::string& path, Companions& companions) {
  constexpr std::string_view kKey = "\"uri\"";
  readPieces(path, std::numeric_limits<std::size_t>::max(), [&](std::string_view text) {
    for (std::size_t at = text.find(kKey); at != std::string_view::npos; at = text.find(kKey, at + kKey.size())) {
      std::string_view rest = text.substr(at + kKey.size());
      const std::size_t quote = rest.find_first_not_of(" \t\r\n:");
      if (quote == std::string_view::npos || rest[quote] != '"') continue;
      rest.remove_prefix(quote + 1);
      if (!rest.starts_with("data:")) companions.add(uriAt(rest));
    }
  });
}

/// Searches a file of any format for texts that end like the names of pictures.
void scanPictures(const std::string& path, std::size_t most, Companions& companions) {
  readPieces(path, most, [&](std::string_view text) {
    for (std::size_t dot = text.find('.'); dot != std::string_view::npos; dot = text.find('.', dot + 1)) {
      for (const std::string_view ending : kPictureEndings) {
        if (lowered(text.substr(dot, ending.size())) != ending) continue;
        std::size_t first = dot;
        const auto isPart = [](unsigned char c) {
          return c >= ' ' && std::string_view("\"<>|*?").find(static_cast<char>(c)) == std::string_view::npos;
        };
        while (first > 0 && dot - first < kLongestName && isPart(static_cast<unsigned char>(text[first - 1]))) --first;
        companions.addEndOf(uriAt(text.substr(first, dot + ending.size() - first)), " =,;()'");
      }
    }
  });
}

}  // namespace

std::vector<std::string> companionFiles(const std::string& environment) {
  std::error_code error;
  if (fs::is_directory(environment, error)) {
    std::vector<std::string> files = meshesInFolder(environment);
    for (std::size_t i = 0, count = files.size(); i < count; ++i) {
      const std::vector<std::string> named = companionFiles(files[i]);
      files.insert(files.end(), named.begin(), named.end());
    }
    return files;
  }
  Companions companions(environment);
  const std::string ending = lowered(fs::path(environment).extension().string());
  if (ending == ".obj") {
    scanObj(environment, companions);
  } else if (ending == ".gltf" || ending == ".glb") {
    scanGltf(environment, companions);
  } else if (ending != ".stl" && ending != ".off" && ending != ".ffenv") {  // these formats name no other files
    scanPictures(environment, ending == ".ply" ? kHeader : std::numeric_limits<std::size_t>::max(), companions);
  }
  return {companions.found().begin(), companions.found().end()};
}

}  // namespace footfall::detail
