// Any bytes as a packed environment: an environment in order that is packed and read as the same, or one line of error.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Check sums would turn all that a fuzzer changes away, so that those in the bytes are put right first, unless the
// first byte is not that of the magic word.
#include <cstring>

#include "core/base/digest.hpp"
#include "core/io/import.hpp"
#include "core/io/packed/pack.hpp"
#include "core/io/packed/packed_environment.hpp"
#include "tests/fuzz/fuzz_folder.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::fuzz;

namespace {

/// The bytes of a range that lies in them; else none.
std::string_view within(const std::string& bytes, std::uint64_t offset, std::uint64_t size) {
  if (offset > bytes.size() || size > bytes.size() - offset) return {};
  return std::string_view(bytes).substr(static_cast<std::size_t>(offset), static_cast<std::size_t>(size));
}

/// Writes the sum of the coarse faces, if all of them lie in the bytes.
void putCoarseSum(std::string& bytes, const PackedHeader& header) {
  const std::string_view table = within(bytes, header.tableOffset, tableSize(header.blocks, header.version));
  if (table.empty()) return;
  PackedCoarse coarse;
  const std::size_t at = header.tableOffset + header.blocks * sizeof(PackedBlock);
  std::memcpy(&coarse, bytes.data() + at, sizeof coarse);
  Digest sum;
  std::uint64_t offset = coarse.offset;
  for (std::uint64_t b = 0; b < header.blocks; ++b) {
    PackedBlock block;
    std::memcpy(&block, table.data() + b * sizeof block, sizeof block);
    const std::uint64_t size = block.coarse * sizeof(PackedCoarseFace);
    if (offset > bytes.size() || size > bytes.size() - offset) return;
    sum.add(within(bytes, offset, size));
    offset += size;
  }
  coarse.sum = sum.value();
  std::memcpy(bytes.data() + at, &coarse, sizeof coarse);
}

void putCheckSums(std::string& bytes) {
  PackedHeader header;
  std::memcpy(&header, bytes.data(), sizeof header);
  header.fileSize = bytes.size();
  if (header.blocks < bytes.size()) {
    const std::uint64_t size = header.blocks * sizeof(PackedBlock);
    for (std::uint64_t at = 0; !within(bytes, header.tableOffset, size).empty() && at < size;
         at += sizeof(PackedBlock)) {
      PackedBlock block;
      char* entry = bytes.data() + header.tableOffset + at;
      std::memcpy(&block, entry, sizeof block);
      block.sum = Digest().add(within(bytes, block.offset, block.size)).value();
      std::memcpy(entry, &block, sizeof block);
    }
    if (header.version > 1) putCoarseSum(bytes, header);
    header.tableSum = Digest().add(within(bytes, header.tableOffset, tableSize(header.blocks, header.version))).value();
  }
  header.descriptionSum = Digest().add(within(bytes, header.descriptionOffset, header.descriptionSize)).value();
  std::memcpy(bytes.data(), &header, sizeof header);
  header.ownSum = Digest().add(std::string_view(bytes).substr(0, kSummedHeader)).value();
  std::memcpy(bytes.data(), &header, sizeof header);
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const FuzzFolder folder;
  if (size == 0) return 0;
  std::string bytes(textOf(data, size));
  if (bytes.size() >= sizeof(PackedHeader) && bytes[0] == kPackedMagic[0]) putCheckSums(bytes);
  const std::string path = folder.write("fuzz.ffenv", bytes), again = folder.file("again.ffenv");
  try {
    const auto environment = importEnvironment(path);
    checkEnvironment(*environment);
    packEnvironment(path, again, {}, nullptr);
    const auto same = importEnvironment(again);
    require(same->vertices == environment->vertices && same->triangles == environment->triangles &&
                same->partOf == environment->partOf && same->parts == environment->parts &&
                same->storeys == environment->storeys && same->notes == environment->notes,
            "an environment changes when it is packed and read");
    const PackedEnvironment packed(path);
    const Box everything{{-1e308, -1e308, -1e308}, {1e308, 1e308, 1e308}};
    std::size_t coarse = 0;
    packed.forCoarseFaces([&](std::size_t block, const CoarseFace&) {
      ++coarse;
      require(block < packed.blocks().size(), "a coarse face of no block");
    });
    require(coarse <= bytes.size() / sizeof(PackedCoarseFace), "too many coarse faces");
    require(packed.facesTouching(everything).faceNumbers.size() <= environment->triangles.size(), "too many faces");
  } catch (const InputError& error) {
    requireGoodMessage(error.what(), path);
  }
  return 0;
}
