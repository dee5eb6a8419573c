// Parallel blocks as they were when they ran.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/pipeline/runner.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/run/finished_runs.hpp"
#include "ui/view/cell_block.hpp"

namespace footfall::ui {

/// The figures of a run for its timeline.
RunFigures figuresOfRun(const RunResult& result, const ProcessorUse& processors);

/// A later run takes blocks from the cache: its cells are those of the run in which they ran.
class KnownBlocks {
 public:
  /// A run with these enabled steps has finished; prefixes[i] names the steps before step i.
  void follow(const FinishedRun& run, const std::vector<const PipelineStep*>& steps,
              const std::vector<std::string>& prefixes);
  /// The blocks of that run.
  [[nodiscard]] CellBlocks blocks() const;
  void clear() { known_.clear(); }

 private:
  std::map<std::string, CellBlock> known_;  ///< by the steps so far, Collapse included
  std::vector<std::string> names_;          ///< of the last finished run's blocks
  std::shared_ptr<const RunFigures> last_;  ///< of the last finished run that ran a block
  bool ran_ = false;                        ///< the last finished run ran its blocks
};

}  // namespace footfall::ui
