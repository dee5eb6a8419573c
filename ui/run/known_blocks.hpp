// The parallel blocks of earlier runs.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/pipeline/runner.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/run/finished_runs.hpp"
#include "ui/view/cells/cell_block.hpp"

namespace footfall::ui {

/// The figures of a run for its timeline.
RunFigures figuresOfRun(const RunResult& result, const ProcessorUse& processors);

/// Keeps the cells of blocks for later runs that take the blocks from the cache.
class KnownBlocks {
 public:
  /// Called when a run with these enabled steps has finished; prefixes[i] names the steps before step i.
  void follow(const FinishedRun& run, const std::vector<const PipelineStep*>& steps,
              const std::vector<std::string>& prefixes);
  /// The blocks of that run.
  [[nodiscard]] CellBlocks blocks() const;
  void clear() { known_.clear(); }

 private:
  std::map<std::string, CellBlock> known_;  ///< by the steps up to and including Collapse
  std::vector<std::string> names_;          ///< names of the last finished run's blocks
  std::shared_ptr<const RunFigures> last_;  ///< figures of the last finished run that ran a block
  bool ran_ = false;                        ///< the last finished run ran its blocks
};

}  // namespace footfall::ui
