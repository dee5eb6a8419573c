// Shares of cells as files, so that a run that was killed goes on where it was.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/base/digest.hpp"
#include "core/base/index_and_box.hpp"
#include "core/distributed/cell_exchange.hpp"
#include "core/distributed/share_file.hpp"
#include "footfall/text.hpp"

namespace footfall::detail {

/// Files of several environments and pipelines can lie in one folder: their names begin with the key. All processes of
/// a run see the same folder. Each file is written beside its name and then renamed.
class WorkFolder {
 public:
  enum class Making : std::uint8_t {
    Folder,  ///< but not those above it
    Nothing  ///< the folder is another process's, which may have removed it
  };
  /// Throws RunError where the folder cannot be made.
  explicit WorkFolder(std::string path, Making making = Making::Folder);

  struct Stored {
    Index cell = -1;
    std::string sealed;
  };
  /// The sound shares of a pass, ascending by cell. Shares that are not sound, or do not belong to their cell
  /// (CellPhase::check), are reported in `notes` (a sentence each) and left to be written anew. Uses the threads of the
  /// present arena.
  std::vector<Stored> load(const CellPhase& phase, std::vector<Text>& notes);
  /// The cells of a pass whose shares are there, in any order. None when the folder cannot be read.
  [[nodiscard]] std::vector<Index> cellsOf(const CellPhase& phase) const;
  /// The bytes of a share, without head. Throws BadBytes.
  [[nodiscard]] std::string read(const ShareName& name) const;
  /// Throws RunError, for example when the disk is full; there is no half of a file then.
  void store(const ShareName& name, const std::string& sealed);
  /// Removes the shares of a pass, and what killed processes left of files they were writing. Never throws.
  void remove(const Digest::Value& key) noexcept;

 private:
  [[nodiscard]] std::string fileOf(const ShareName& name) const;

  std::string path_;
};

}  // namespace footfall::detail
