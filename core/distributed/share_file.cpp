// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/distributed/share_file.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace footfall::detail {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kBlock = 1 << 18;
constexpr std::string_view kMagic = "FFSHARE\n";

Digest::Value checkSum(std::string_view head, std::string_view bytes) { return Digest().add(head).add(bytes).value(); }

}  // namespace

std::string sealShare(const ShareName& name, std::string_view bytes) {
  ByteWriter out;
  out.bytes.reserve(bytes.size() + kShareHead);
  out.bytes = kMagic;
  out.fixed(kShareVersion);
  for (const std::uint64_t word : name.key) out.fixed(word);
  out.fixed(name.phase);
  out.fixed(name.cell);
  out.fixed(bytes.size());
  for (const std::uint64_t word : checkSum(out.bytes, bytes)) out.fixed(word);
  out.bytes.append(bytes);
  return std::move(out.bytes);
}

OpenedShare openShare(std::string_view sealed) {
  ByteReader in(sealed);
  if (in.rest().substr(0, kMagic.size()) != kMagic) throw BadBytes("is no share");
  in.take(kMagic.size());
  try {
    if (in.fixed() != kShareVersion) throw BadBytes("is of another version");
    OpenedShare opened;
    for (std::uint64_t& word : opened.name.key) word = in.fixed();
    opened.name.phase = in.fixed();
    opened.name.cell = in.fixed();
    const std::uint64_t size = in.fixed();
    const std::string_view head = sealed.substr(0, sealed.size() - in.rest().size());
    Digest::Value sum;
    for (std::uint64_t& word : sum) word = in.fixed();
    opened.bytes = in.rest();
    if (opened.bytes.size() < size) throw BadBytes("is cut off");
    if (opened.bytes.size() > size || checkSum(head, opened.bytes) != sum) throw BadBytes("is damaged");
    return opened;
  } catch (const BadBytes& error) {
    throw std::string_view(error.what()).substr(0, 3) == "is " ? error : BadBytes("is cut off");
  }
}

// Reads in blocks by read(), which keeps a disk error in the stream's state; an iterator of the stream lets the
// library's own exception through.
std::optional<std::string> contentOf(const std::string& path) {
  std::error_code error;
  if (!fs::exists(path, error) && !error) return std::nullopt;
  if (!fs::is_regular_file(path, error)) throw BadBytes("is no file");
  std::ifstream file(path, std::ios::binary);
  if (!file.is_open()) throw BadBytes("cannot be read");
  std::string content;
  while (file.good()) {
    const std::size_t size = content.size();
    content.resize(size + std::max(kBlock, size));
    file.read(content.data() + size, static_cast<std::streamsize>(content.size() - size));
    content.resize(size + static_cast<std::size_t>(file.gcount()));
  }
  if (file.bad()) throw BadBytes("cannot be read");
  return content;
}

}  // namespace footfall::detail
