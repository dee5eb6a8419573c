// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cell_preview.hpp"

#include <utility>

#include "core/pipeline/runner.hpp"

namespace footfall {

CellPreview::CellPreview(QObject* parent, Make make) : QObject(parent), make_(std::move(make)) {
  if (make_) return;
  make_ = [](const std::shared_ptr<const Environment>& environment, const Pipeline& pipeline, std::size_t step,
             RunContext& context) { return previewPartition(environment, pipeline, step, context); };
}

CellPreview::~CellPreview() { cancel(); }

void CellPreview::cancel() {
  if (context_) context_->cancel();
  context_.reset();
}

void CellPreview::request(std::shared_ptr<const Environment> environment, Pipeline pipeline, std::size_t step) {
  cancel();
  pipeline.steps[step].enabled = true;
  context_ = std::make_shared<RunContext>();
  queue_.post([this, context = context_, environment = std::move(environment), pipeline = std::move(pipeline), step] {
    auto partition = std::make_shared<Partition>();
    QString error;
    try {
      context->checkCancelled();
      *partition = make_(environment, pipeline, step, *context);
    } catch (const Cancelled&) {
      return;
    } catch (const std::exception& problem) {
      error = QString::fromUtf8(problem.what());
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

}  // namespace footfall
