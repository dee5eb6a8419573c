// The window's exports: the walkable area, pictures and reports.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QBuffer>
#include <QFile>
#include <QFileInfo>
#include <algorithm>
#include <utility>

#include "core/environment/gltf_export.hpp"
#include "core/errors.hpp"
#include "core/metrics/html_report.hpp"
#include "core/pipeline/export_header.hpp"
#include "ui/editor_window.hpp"
#include "ui/export_dialog.hpp"

namespace footfall {
namespace {

constexpr QSize kReportPicture{1600, 1000};
constexpr double kReportRatio = 1.25;

std::string toPath(const QString& path) { return QFile::encodeName(path).toStdString(); }

std::string pngOf(const QImage& image) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  if (!image.save(&buffer, "PNG")) throw RunError(FOOTFALL_TEXT("the picture cannot be made; choose a smaller size"));
  return bytes.toStdString();
}

}  // namespace

void EditorWindow::exportDialog() {
  if (!loaded_.environment) return;
  ExportSource source;
  source.run = controller_.finishedRun();
  source.isUpToDate = controller_.upToDate();
  source.environment = loaded_.environment;
  source.placed = placedExtras();
  source.view = view_->size();
  source.devicePixelRatio = view_->devicePixelRatioF();
  const ExportSettings settings = rememberedExport();
  const QString suffix =
      settings.kind == ExportKind::Png || settings.kind == ExportKind::Html ? QString() : QStringLiteral("-walkable");
  auto* dialog = new ExportDialog(std::move(source), settings,
                                  suggestedPath(suffix + QLatin1Char('.') + exportEnding(settings.kind)), this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &ExportDialog::exportRequested, this, [this](const QString& path, const ExportSettings& chosen) {
    if (remembering_) rememberExport(chosen);
    exportResult(path, chosen);
  });
  dialog->open();
}

void EditorWindow::exportResult(const QString& path) {
  ExportSettings settings;
  settings.kind = exportKindOf(path, ExportKind::Obj);
  exportResult(path, settings);
}

void EditorWindow::exportResult(const QString& path, const ExportSettings& settings) {
  if (!loaded_.environment) {
    messages_->showError(tr("nothing to export; open an environment first"));
    return;
  }
  if (!controller_.upToDate()) {
    pendingExport_.emplace(path, settings);
    if (!controller_.busy()) controller_.runNow();
    return;
  }
  if (settings.kind == ExportKind::Png) {
    writePicture(path, settings);
  } else if (settings.kind == ExportKind::Html) {
    writeReport(path, settings.pictures);
  } else {
    writeResult(path, settings);
  }
}

// The loaded environment: its scale may have changed since the run, its coordinates have not.
void EditorWindow::writeResult(const QString& path, const ExportSettings& settings) {
  writeInBackground(
      [run = controller_.finishedRun(), environment = loaded_.environment, target = toPath(path), settings,
       extras = settings.placed ? placedExtras() : std::vector<ExportExtra>()] {
        const ExportHeader header = makeExportHeader(run->pipeline);
        const NavigationMesh& mesh = *run->result.mesh;
        if (settings.kind == ExportKind::Obj) {
          writeObj(target, mesh, *environment, header, settings.options, extras);
        } else {
          const GltfKind kind = settings.kind == ExportKind::Gltf ? GltfKind::Text : GltfKind::Binary;
          writeFileSafely(target, formatGltf(kind, mesh, *environment, header, settings.options, extras).bytes);
        }
      },
      path);
}

// Drawing needs the window's thread and its OpenGL; the file is made in the background.
void EditorWindow::writePicture(const QString& path, const ExportSettings& settings) {
  const QList<PictureSize> sizes = pictureSizes(view_->size(), view_->devicePixelRatioF());
  const PictureSize& size = sizes[std::clamp(settings.pictureSize, 0, static_cast<int>(sizes.size()) - 1)];
  const QImage image = view_->picture(size.pixels, size.ratio);
  if (image.isNull()) {
    messages_->showError(tr("%1: a picture of %2 × %3 cannot be drawn here; choose a smaller size")
                             .arg(path)
                             .arg(size.pixels.width())
                             .arg(size.pixels.height()));
    return;
  }
  writeInBackground([image, target = toPath(path)] { writeFileSafely(target, pngOf(image)); }, path);
}

void EditorWindow::writeReport(const QString& path, bool pictures) {
  std::vector<std::pair<std::string, QImage>> images;
  if (pictures) {
    const CameraPose pose = view_->cameraPose();
    const auto take = [&](const char* caption) {
      images.emplace_back(caption, view_->picture(kReportPicture, kReportRatio));
    };
    take("As seen in the editor");
    view_->viewFromTop();
    take("From the top");
    view_->viewOblique();
    take("From above at an angle");
    view_->setCameraPose(pose);
  }
  writeInBackground(
      [run = controller_.finishedRun(), environment = loaded_.environment, images, target = toPath(path)] {
        std::vector<ReportPicture> embedded;
        for (const auto& [caption, image] : images)
          if (!image.isNull()) embedded.push_back({caption, pngOf(image)});
        writeFileSafely(target, formatHtmlReport(*environment, run->pipeline, run->result, {}, embedded));
      },
      path);
}

// The shapes that were placed, as the level has them.
std::vector<ExportExtra> EditorWindow::placedExtras() const {
  std::vector<ExportExtra> extras;
  for (const PlacedObstacle& obstacle : document_.state().obstacles)
    extras.push_back({obstacle.name, soupOf(obstacle)});
  return extras;
}

}  // namespace footfall
