// The interface by which a run that several processes share divides the cells of its parallel blocks.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/digest.hpp"
#include "core/base/index_and_box.hpp"
#include "footfall/run_context.hpp"

namespace footfall::detail {

/// One pass of a clearance filter over the cells of a block.
struct CellPhase {
  std::size_t number = 0;     ///< number among all such passes of the run
  std::size_t count = 1;      ///< number of all such passes of the run
  Digest::Value key{};        ///< digest of all that its shares depend on
  std::vector<double> costs;  ///< estimated, of each cell
  double nowMs = 0;           ///< since the run of this process began
  /// Throws BadBytes where the bytes are no share of that cell. Called by any thread, during begin() only.
  std::function<void(Index cell, std::string_view bytes)> check = [](Index, std::string_view) {};

  /// Only one process goes on behind the last one.
  [[nodiscard]] bool isLast() const { return number + 1 == count; }
};

/// The share of a cell that another process ran, or that an earlier run left.
struct ArrivedShare {
  Index cell = -1;
  std::string bytes;      ///< encodeCellShare()
  bool hasTimes = false;  ///< its times are of this run
  double shiftMs = 0;     ///< added to its times
  int firstThread = 0;    ///< added to its numbers of threads
};

/// Assigns cells to processes and carries their shares. All processes prepare and partition alike; between two passes
/// each of them needs all shares, behind the last one only the process that goes on. give(), take() and ownFinished()
/// are called by any thread.
class CellExchange {
 public:
  virtual ~CellExchange() = default;

  /// One flag per cell: this process runs it; the shares of the others come by take(). May wait for other processes.
  /// Throws RunError when they do not work on the same, Cancelled.
  virtual std::vector<char> begin(const CellPhase& phase, RunContext& context) = 0;
  /// True when this process needs the shares of all cells of the pass that began last; before the first one, true when
  /// it is the process that goes on.
  [[nodiscard]] virtual bool merges() const = 0;
  /// True when the shares of its own cells are to be passed to give().
  [[nodiscard]] virtual bool wantsOwn() const = 0;
  virtual void give(Index cell, std::string bytes) = 0;
  /// A share that arrived, if there is one. Throws RunError when another process failed.
  virtual std::optional<ArrivedShare> take() = 0;
  /// All cells that this process runs are done.
  virtual void ownFinished() = 0;
  /// Throws RunError when another process failed.
  virtual void throwFailure() const = 0;
  /// Threads of all processes together; the first ones are those of the process that goes on.
  [[nodiscard]] virtual int threads() const = 0;
};

}  // namespace footfall::detail
