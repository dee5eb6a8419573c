// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/turntable/turntable.hpp"

#include <QBuffer>
#include <QDir>
#include <QFileInfo>
#include <QTimer>
#include <algorithm>
#include <utility>

#include "core/base/vector.hpp"
#include "core/io/export.hpp"
#include "footfall/errors.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/base/work/guarded_application.hpp"
#include "ui/window/file_dialogs.hpp"
#include "ui/window/turntable/turntable_poses.hpp"

namespace footfall::ui {
namespace {

constexpr double kUsualHeight = 720;  // pixels: lines grow with taller pictures

void writePicture(const QImage& image, const std::string& path) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  if (!image.save(&buffer, "PNG")) throw RunError(FOOTFALL_TEXT("the picture cannot be made; choose a smaller size"));
  writeFileSafely(path, bytes.toStdString());
}

}  // namespace

QString turntableFrame(const QString& folder, int number) {
  return QDir(folder).filePath(QStringLiteral("frame_%1.png").arg(number, 4, 10, QLatin1Char('0')));
}

Turntable::Turntable(LevelView& view, RunController& controller, BackgroundQueue& queue, QObject* parent)
    : QObject(parent), view_(view), controller_(controller), queue_(queue) {
  connect(&controller_, &RunController::started, this, [this] {
    if (isRunning())
      stop(tr("%1: %2 of %3 frames are written, as the filters run again; start the turntable anew after the run")
               .arg(settings_->folder)
               .arg(written_)
               .arg(settings_->frames));
  });
}

QString Turntable::problemOf(const TurntableSettings& settings) const {
  const QString& folder = settings.folder;
  if (!controller_.finishedRun() || !view_.environmentGeometry())
    return tr("there is no result to show yet; open an environment and wait for the run");
  const QFileInfo there(folder);
  if (folder.isEmpty()) return tr("the turntable needs a folder; name one");
  if (there.exists() && !there.isDir()) return tr("%1: is a file; name a folder").arg(folder);
  if (!QDir(folder).entryList({QStringLiteral("frame_*.png")}).isEmpty())
    return tr("%1: has frames of another sequence; name another folder, or remove them").arg(folder);
  if (!QDir().mkpath(folder))
    return tr("%1: the folder cannot be made; name one in a place that you may write to").arg(folder);
  return errorOf([&] { checkWritable(toPath(turntableFrame(folder, 1))); });
}

void Turntable::start(const TurntableSettings& settings) {
  if (isRunning()) return;
  const QString problem = problemOf(settings);
  if (!problem.isEmpty()) {
    emit stopped(problem);
    return;
  }
  settings_ = settings;
  written_ = 0;
  before_ = view_.cameraController().pose();
  const auto scene = view_.environmentGeometry();
  std::vector<Vec3> points;
  for (const Vec3& p : scene->detailExtremes) points.push_back(p + scene->centre);
  poses_ = turntablePoses(points, sightOf(before_), settings.frames, settings.pixels, view_.camera()->fieldOfView());
  emit progressed(0, settings.frames);
  drawNext();
}

void Turntable::drawNext() {
  if (!isRunning()) return;
  view_.cameraController().setPose(poses_[static_cast<std::size_t>(written_)]);
  const double ratio = std::max(1.0, settings_->pixels.height() / kUsualHeight);
  const QImage image = view_.picture(settings_->pixels, ratio);
  if (image.isNull()) {
    stop(tr("frames of %1 × %2 cannot be drawn here; choose a smaller size")
             .arg(settings_->pixels.width())
             .arg(settings_->pixels.height()));
    return;
  }
  queue_.post([this, image, path = toPath(turntableFrame(settings_->folder, written_ + 1))] {
    const QString error = errorOf([&] { writePicture(image, path); });
    QMetaObject::invokeMethod(
        this, [this, error] { takeWritten(error); }, Qt::QueuedConnection);
  });
}

void Turntable::takeWritten(const QString& error) {
  if (!isRunning()) return;  // it was stopped meanwhile
  if (!error.isEmpty()) {
    stop(written_ == 0 ? error : tr("%1. %2 of %3 frames are written").arg(error).arg(written_).arg(settings_->frames));
    return;
  }
  emit progressed(++written_, settings_->frames);
  if (written_ < settings_->frames) {
    QTimer::singleShot(0, this, &Turntable::drawNext);  // the window answers between two frames
    return;
  }
  const TurntableSettings done = *std::exchange(settings_, std::nullopt);
  view_.cameraController().setPose(before_);
  emit finished(done.folder, done.frames);
}

void Turntable::cancel() {
  if (!isRunning()) return;
  stop(tr("%1: %2 of %3 frames are written, as the turntable was cancelled")
           .arg(settings_->folder)
           .arg(written_)
           .arg(settings_->frames));
}

void Turntable::stop(const QString& message) {
  settings_.reset();
  view_.cameraController().setPose(before_);
  emit stopped(message);
}

}  // namespace footfall::ui
