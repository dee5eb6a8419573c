// The window's exports: the walkable area, pictures and reports.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QBuffer>
#include <QFile>
#include <QFileInfo>
#include <algorithm>
#include <utility>

#include "core/io/gltf_export.hpp"
#include "core/report/html_report.hpp"
#include "footfall/errors.hpp"
#include "footfall/report.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/view/level_look.hpp"
#include "ui/window/editor_window.hpp"
#include "ui/window/export_dialog.hpp"
#include "ui/window/report_legend.hpp"

namespace footfall::ui {
namespace {

constexpr QSize kReportPicture{1600, 1000};  // at most
constexpr double kReportRatio = 1.25;

std::string toPath(const QString& path) { return QFile::encodeName(path).toStdString(); }

std::string pngOf(const QImage& image) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  if (!image.save(&buffer, "PNG")) throw RunError(FOOTFALL_TEXT("the picture cannot be made; choose a smaller size"));
  return bytes.toStdString();
}

std::vector<ReportPicture> pngsOf(const std::vector<CaptionedImage>& images) {
  std::vector<ReportPicture> pictures;
  for (const auto& [caption, image] : images)
    if (!image.isNull()) pictures.push_back({caption, pngOf(image)});
  return pictures;
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
  source.refusal = [this](const QString& path) { return refusal(path, WrittenKind::Export); };
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
    messages_->showErrorOf(MessageSubject::Writing, tr("nothing to export; open an environment first"));
    return;
  }
  const QString why = refusal(path, WrittenKind::Export);
  if (!why.isEmpty()) {
    messages_->showErrorOf(MessageSubject::Writing, why);
    return;
  }
  const bool drawn = settings.kind == ExportKind::Png || (settings.kind == ExportKind::Html && settings.pictures);
  const bool computed = controller_.upToDate();
  if (!computed || (drawn && !findChild<LevelLook*>()->modes().upToDate())) {
    std::erase_if(pendingExports_, [&](const auto& pending) { return pending.first == path; });
    pendingExports_.emplace_back(path, settings);
    log_.add(MessageLevel::Note, tr("%1 is written once the run has finished").arg(path));
    if (!computed && !controller_.busy()) controller_.runNow();
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

void EditorWindow::writePendingExports() {
  if (pendingExports_.empty()) return;
  if (!controller_.upToDate()) {
    if (!controller_.busy()) controller_.runNow();
    return;
  }
  if (!findChild<LevelLook*>()->modes().upToDate()) return;
  for (const auto& [path, settings] : std::exchange(pendingExports_, {})) exportResult(path, settings);
}

QString EditorWindow::dropPendingExports() {
  QStringList names;
  for (const auto& [path, settings] : std::exchange(pendingExports_, {})) names << path;
  if (!names.isEmpty()) closeIfWritten(false);
  return names.join(QStringLiteral(", "));
}

// The loaded environment: its scale may have changed since the run, its coordinates have not.
void EditorWindow::writeResult(const QString& path, const ExportSettings& settings) {
  writeInBackground(
      [run = controller_.finishedRun(), environment = loaded_.environment, target = toPath(path), settings,
       extras = settings.placed ? placedExtras() : std::vector<ExportExtra>()] {
        const ExportHeader header = makeExportHeader(run->pipeline);
        const NavigationMesh& mesh = *run->result.mesh;
        if (settings.kind == ExportKind::Obj) {
          writeFileSafely(target, formatObj(mesh, header, settings.options, extras));
        } else {
          const GltfKind kind = settings.kind == ExportKind::Gltf ? GltfKind::Text : GltfKind::Binary;
          writeFileSafely(target, formatGltf(kind, mesh, header, settings.options, extras).bytes);
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
    messages_->showErrorOf(MessageSubject::Writing,
                           tr("%1: a picture of %2 × %3 cannot be drawn here; choose a smaller size")
                               .arg(path)
                               .arg(size.pixels.width())
                               .arg(size.pixels.height()));
    return;
  }
  writeInBackground([image, target = toPath(path)] { writeFileSafely(target, pngOf(image)); }, path);
}

void EditorWindow::writeReport(const QString& path, bool pictures) {
  std::vector<CaptionedImage> images, colours;
  if (pictures) {
    colours = reportLegend(view_->content(), view_->parts());
    if (isHeatMap(view_->mode()))
      colours.emplace_back(view_->mode() == ViewMode::Slope ? "Slope of floors; hatched: steeper than the limit"
                                                            : "Free height above floors; hatched: less than the limit",
                           legend_->scaleImage());
    const auto take = [&](const char* caption, const QSize& size, PictureCamera from) {
      images.emplace_back(caption, view_->picture(size, kReportRatio, from));
    };
    // The first has the view's shape, so that it shows neither more nor less.
    take("As seen in the editor", view_->size().scaled(kReportPicture, Qt::KeepAspectRatio), PictureCamera::AsSeen);
    take("From the top", kReportPicture, PictureCamera::Top);
    take("From above at an angle", kReportPicture, PictureCamera::Oblique);
  }
  writeInBackground(
      [run = controller_.finishedRun(), environment = loaded_.environment, images, colours, target = toPath(path)] {
        const std::vector<ReportPicture> pictures = pngsOf(images), legend = pngsOf(colours);
        const ReportDetails details{reportDate(), pictures, legend};
        writeFileSafely(target, formatHtmlReport(*environment, run->pipeline, run->result, {}, details));
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

}  // namespace footfall::ui
