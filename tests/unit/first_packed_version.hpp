// A packed environment as the first version of the program wrote it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>

#include "core/base/digest.hpp"
#include "core/io/packed/packed_description.hpp"
#include "core/io/packed/packed_format.hpp"

namespace footfall::detail {

/// Writes the check sum of the header into it.
inline void sealPacked(QByteArray& bytes) {
  const CheckSum sum = Digest().add(std::string_view(bytes.constData(), kSummedHeader)).value();
  std::memcpy(bytes.data() + kSummedHeader, sum.data(), sizeof sum);
}

/// The bytes of the present version without what the first one lacks: coarse faces, and the grid at the end of the
/// description.
inline QByteArray firstPackedVersion(QByteArray bytes) {
  PackedHeader header;
  std::memcpy(&header, bytes.constData(), sizeof header);
  bytes.chop(sizeof(PackedCoarse));  // The coarse section is last.
  header.version = 1;
  header.fileSize = static_cast<std::uint64_t>(bytes.size());
  const std::string_view all(bytes.constData(), header.fileSize);
  header.tableSum = Digest().add(all.substr(header.tableOffset)).value();
  const std::string_view description = all.substr(header.descriptionOffset, header.descriptionSize);
  const auto isWhole = [&](std::size_t size) {
    try {
      decodeDescription(description.substr(0, size), 1);
      return true;
    } catch (const std::runtime_error&) {
      return false;
    }
  };
  while (header.descriptionSize > 0 && !isWhole(header.descriptionSize)) --header.descriptionSize;
  header.descriptionSum = Digest().add(description.substr(0, header.descriptionSize)).value();
  std::memcpy(bytes.data(), &header, sizeof header);
  sealPacked(bytes);
  return bytes;
}

}  // namespace footfall::detail
