// Stores the events of a run's threads until the window fetches them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "footfall/run_context.hpp"
#include "footfall/statistics.hpp"
#include "ui/view/cells/cell_block.hpp"
#include "ui/view/geometry/render_geometry.hpp"

namespace footfall::ui {

/// Thread-safe. However fast events arrive, the owner is notified once, and again only after it has fetched.
class RunEventBuffer {
 public:
  using Clock = std::chrono::steady_clock;

  struct Part {
    std::shared_ptr<const NavigationMesh> mesh;
    std::shared_ptr<const NavigationMeshGeometry>
        geometry;                    ///< geometry of the mesh, where the publishing thread has made it
    std::optional<CellBounds> cell;  ///< cell that the part belongs to, if any
  };
  struct Step {
    bool finished = false;
    Clock::time_point started, ended;
    double fraction = 0;
    Part whole;               ///< result of the step; empty for cached steps
    std::vector<Part> parts;  ///< intermediate pieces
  };

  struct Block {
    std::shared_ptr<const BlockReport> made;
    std::vector<std::shared_ptr<const CellReport>> cells;  ///< null while a cell has not finished
    CellRanks ranks = {};
  };

  /// The threads of the run call `notify`, which must be quick and thread-safe.
  explicit RunEventBuffer(std::function<void()> notify) : notify_(std::move(notify)) {}

  void add(const RunEvent& event, std::shared_ptr<const NavigationMeshGeometry> geometry = nullptr);
  /// Sets the ranks that run the cells from now on.
  void setRanks(CellRanks ranks);
  /// All steps so far, in order; the last one may be running.
  std::vector<Step> fetch();
  /// The parallel blocks so far, in order.
  std::vector<Block> blocks() const;

 private:
  void addCell(const RunEvent& event, std::shared_ptr<const NavigationMeshGeometry> geometry);
  std::function<void()> notify_;
  mutable std::mutex mutex_;
  std::vector<Step> steps_;
  std::vector<Block> blocks_;
  CellRanks ranks_;
  bool notified_ = false;
};

}  // namespace footfall::ui
