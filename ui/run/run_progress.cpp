// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/run/run_progress.hpp"

#include <QCoreApplication>
#include <algorithm>

namespace footfall::ui {
namespace {

// The share of the cells' cost that is done, in [0, 1]; a cell without cost counts as well.
double shareDone(const RunEventBuffer::Block& block) {
  double done = 0;
  double all = 0;
  for (std::size_t i = 0; i < block.cells.size(); ++i) {
    const double cost = block.made->cells[i].cost + 1;
    all += cost;
    if (block.cells[i]) done += cost;
  }
  return all > 0 ? done / all : 0;
}

}  // namespace

BlockPlace placeInBlock(std::size_t step, const std::vector<RunEventBuffer::Step>& steps,
                        const std::vector<RunEventBuffer::Block>& blocks) {
  for (const RunEventBuffer::Block& block : blocks) {
    const BlockReport& made = *block.made;
    if (step < made.firstStep || step > made.lastStep) continue;
    const auto finished = std::ranges::count_if(block.cells, [](const auto& cell) { return cell != nullptr; });
    const auto all = static_cast<std::ptrdiff_t>(block.cells.size());
    BlockPlace place{true, step == made.lastStep && finished < all, shareDone(block), {}};
    // The progress of cells is reported for the block's last filter only.
    if (made.lastStep - 1 < steps.size()) place.fraction = std::max(place.fraction, steps[made.lastStep - 1].fraction);
    if (step == made.firstStep) place.fraction = 1;
    if (step == made.lastStep) place.fraction = 0;
    place.text =
        finished == all ? QCoreApplication::translate("footfall::ui::RunController", "Putting the cells together")
        : all == 1 ? QCoreApplication::translate("footfall::ui::RunController", "%1 of 1 cell finished").arg(finished)
                   : QCoreApplication::translate("footfall::ui::RunController", "%1 of %2 cells finished")
                         .arg(finished)
                         .arg(all);
    return place;
  }
  return {};
}

}  // namespace footfall::ui
