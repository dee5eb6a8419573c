// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cells/cell_preview.hpp"

#include <utility>

#include "core/pipeline/runner.hpp"
#include "ui/base/core_text.hpp"
#include "ui/base/namespaces.hpp"

namespace footfall::ui {
namespace {

// The strategy, the local filters that follow it, and its end: what the cells depend on, and always a whole block.
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

CellPreview::~CellPreview() { cancel(); }

void CellPreview::cancel() {
  if (context_) context_->cancel();
  context_.reset();
}

void CellPreview::request(std::shared_ptr<const Environment> environment, const Pipeline& pipeline, std::size_t step,
                          int threads) {
  cancel();
  context_ = std::make_shared<RunContext>();
  queue_.post(
      [this, context = context_, environment = std::move(environment), block = blockOf(pipeline, step), threads] {
        auto partition = std::make_shared<Partition>();
        QString error;
        try {
          context->checkCancelled();
          *partition = make_(environment, block, *context, threads);
        } catch (const Cancelled&) {
          return;
        } catch (const std::exception& problem) {
          error = coreText(problem);
        }
        const auto tell = [this, context, partition, error] {
          if (context != context_) return;  // overtaken
          context_.reset();
          if (error.isEmpty()) {
            emit ready(*partition);
          } else {
            emit failed(error);
          }
        };
        QMetaObject::invokeMethod(this, tell, Qt::QueuedConnection);
      });
}

}  // namespace footfall::ui
