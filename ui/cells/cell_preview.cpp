// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cells/cell_preview.hpp"

#include <utility>

#include "core/pipeline/runner.hpp"
#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/base/text/core_text.hpp"

namespace footfall::ui {
namespace {

// The strategy, the local filters that follow it, and its end. The cells depend on these alone, and they are a complete
// block.
Pipeline blockOf(const Pipeline& pipeline, std::size_t step) {
  Pipeline block;
  block.steps.push_back(pipeline.steps[step]);
  block.steps.back().enabled = true;
  for (std::size_t i = step + 1; i < pipeline.steps.size(); ++i) {
    const PipelineStep& next = pipeline.steps[i];
    if (!next.enabled) continue;
    if (next.filter->kind != FilterKind::Filter || next.filter->scope == Scope::Global) break;
    block.steps.push_back(next);
  }
  block.steps.push_back(defaultStep(filterDescriptor(FilterType::Collapse), 1));
  return block;
}

}  // namespace

CellPreview::CellPreview(QObject* parent, Make make) : QObject(parent), make_(std::move(make)) {
  if (make_) return;
  make_ = [](const std::shared_ptr<const Environment>& environment, const Pipeline& block, RunContext& context,
             int threads) { return previewPartition(environment, block, 0, context, threads); };
}

void CellPreview::request(std::shared_ptr<const Environment> environment, const Pipeline& pipeline, std::size_t step,
                          int threads) {
  work_.start(
      *this,
      [make = make_, environment = std::move(environment), block = blockOf(pipeline, step),
       threads](RunContext& context) { return make(environment, block, context, threads); },
      [this](const Partition& partition) { emit ready(partition); },
      [this](const std::exception& error) { emit failed(coreText(error)); });
}

}  // namespace footfall::ui
