// The progress of a run, from the events of its threads.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <vector>

#include "ui/run/run_event_buffer.hpp"

namespace footfall::ui {

/// A step as part of a parallel block. The block's filters run at the same time, one cell after the other; Collapse
/// begins when all have ended.
struct BlockPlace {
  bool block = false;  ///< the step belongs to a running block
  bool waits = false;  ///< the step waits for the cells
  double fraction = 0;
  QString text;
};
BlockPlace placeInBlock(std::size_t step, const std::vector<RunEventBuffer::Step>& steps,
                        const std::vector<RunEventBuffer::Block>& blocks);

}  // namespace footfall::ui
