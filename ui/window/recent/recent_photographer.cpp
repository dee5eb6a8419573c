// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/recent/recent_photographer.hpp"

#include <QFileInfo>
#include <utility>

namespace footfall::ui {
namespace {

constexpr int kDelayMs = 1500;

}  // namespace

RecentPhotographer::RecentPhotographer(LevelView& view, RunController& controller, RecentFiles& recent,
                                       std::function<QString()> openFile, BackgroundQueue& writing, QObject* parent)
    : QObject(parent),
      view_(view),
      controller_(controller),
      recent_(recent),
      openFile_(std::move(openFile)),
      writing_(writing) {
  timer_.setSingleShot(true);
  timer_.setInterval(kDelayMs);
  connect(&timer_, &QTimer::timeout, this, &RecentPhotographer::take);
  connect(&controller_, &RunController::finished, &timer_, qOverload<>(&QTimer::start));
  const auto forget = [this] {
    writing_.post([files = recent_.paths()] { RecentPictures::ofUser().keepOnly(files); });
  };
  connect(&recent_, &RecentFiles::changed, this, forget);
}

void RecentPhotographer::take() {
  const QString file = openFile_();
  if (file.isEmpty() || !controller_.finishedRun() || !view_.isVisible()) return;
  if (!recent_.paths().contains(QFileInfo(file).absoluteFilePath())) return;
  if (controller_.busy() || !view_.isWhole()) {
    timer_.start();  // later
    return;
  }
  // All of it is drawn: this draws it once more from what is there.
  const QImage picture = view_.QOpenGLWidget::grabFramebuffer();
  writing_.post([this, file, picture] {
    if (!RecentPictures::ofUser().store(file, picture)) return;
    QMetaObject::invokeMethod(this, &RecentPhotographer::changed, Qt::QueuedConnection);
  });
}

}  // namespace footfall::ui
