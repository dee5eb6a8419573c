// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/result_export.hpp"

#include <QBuffer>
#include <QFileInfo>
#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "core/base/worker_arena.hpp"
#include "core/io/formats/save.hpp"
#include "core/report/html_report.hpp"
#include "footfall/corridor_map.hpp"
#include "footfall/errors.hpp"
#include "footfall/report.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/window/export_dialog.hpp"
#include "ui/window/export_files.hpp"
#include "ui/window/file_dialogs.hpp"
#include "ui/window/report_legend.hpp"

namespace footfall::ui {
namespace {

constexpr QSize kReportPicture{1600, 1000};  // at most
constexpr double kReportRatio = 1.25;

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

/// The number of pages or layers is known once they are made; files that the user has not agreed to are not replaced.
void checkUnasked(const std::vector<OutputFile>& files, const std::set<std::string>* replaceable) {
  if (!replaceable) return;
  for (const OutputFile& file : files)
    if (!replaceable->contains(file.path) && QFileInfo::exists(fromPath(file.path)))
      throw InputError(FOOTFALL_TEXT("%1: already exists; export with the dialog, which asks whether to replace it"),
                       file.path);
}

}  // namespace

ResultExport::ResultExport(const Uses& uses) : QObject(&uses.window), uses_(uses) {
  // The connection is queued, so that the whole editor has the result: pictures show the updated view.
  connect(&uses_.controller, &RunController::finished, this, &ResultExport::writeWaiting, Qt::QueuedConnection);
  connect(&uses_.controller, &RunController::finished, this, &ResultExport::writeAfterRun, Qt::QueuedConnection);
  connect(&uses_.modes, &ViewModes::ready, this, &ResultExport::writeWaiting, Qt::QueuedConnection);
  connect(&uses_.controller, &RunController::cancelled, this, [this] {
    const QString files = takeWaiting();
    if (files.isEmpty()) return;
    uses_.messages.showErrorOf(MessageSubject::Writing,
                               tr("%1: not written, as the run was cancelled; export again").arg(files));
  });
  connect(&uses_.level, &LevelFile::opened, this, [this](Reading reading) {
    if (reading != Reading::Another) return;
    forgetLast();
    const QString files = takeWaiting();
    if (files.isEmpty()) return;
    uses_.messages.showErrorOf(
        MessageSubject::Writing,
        tr("%1: not written, as another environment was opened; open the one before and export again").arg(files));
  });
}

void ResultExport::showDialog() { showDialog(rememberedTarget()); }

void ResultExport::showDialog(const ExportTarget& target) {
  if (!uses_.level.environment()) return;
  ExportSource source;
  source.run = uses_.controller.finishedRun();
  source.isUpToDate = uses_.controller.upToDate();
  source.environment = uses_.level.environment();
  source.placed = placedExtras();
  source.view = uses_.view.size();
  source.devicePixelRatio = uses_.view.devicePixelRatioF();
  source.units = uses_.units.units();
  source.refusal = [this](const QString& path) { return uses_.writer.refusal(path, WrittenKind::Export); };
  const QString suffix = isPlan(target.kind)       ? QStringLiteral("-plan")
                         : meshFormat(target.kind) ? QStringLiteral("-walkable")
                                                   : QString();
  auto* dialog = new ExportDialog(std::move(source), rememberedExport(target),
                                  suggestedPath(uses_.level, suffix + QLatin1Char('.') + exportEnding(target.kind)),
                                  &uses_.window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &ExportDialog::exportRequested, this, [this](const QString& path, const ExportSettings& chosen) {
    if (remembering_) rememberExport(chosen);
    last_.emplace(path, chosen);
    emit lastChanged();
    write(path, chosen);
  });
  dialog->open();
}

void ResultExport::exportAgain() {
  if (last_)
    write(last_->first, last_->second);
  else
    showDialog();
}

void ResultExport::setAfterRuns(bool on) {
  if ((on && last_) == afterRuns_) return;
  afterRuns_ = !afterRuns_;
  written_.reset();
  emit lastChanged();
  writeAfterRun();
}

// The same result is not written twice: the file does not change after runs that change nothing.
void ResultExport::writeAfterRun() {
  if (!afterRuns_ || !uses_.controller.upToDate()) return;
  const auto run = uses_.controller.finishedRun();
  if (written_.lock() == run) return;
  written_ = run;
  write(last_->first, last_->second);
}

void ResultExport::forgetLast() {
  last_.reset();
  afterRuns_ = false;
  written_.reset();
  emit lastChanged();
}

void ResultExport::write(const QString& path) {
  ExportSettings settings;
  settings.target = &exportTargetOf(path, exportTargets().front());
  settings.options.godot = settings.target->godot;
  write(path, settings);
}

void ResultExport::write(const QString& path, const ExportSettings& settings) {
  if (!uses_.level.environment()) {
    uses_.messages.showErrorOf(MessageSubject::Writing, tr("nothing to export; open an environment first"));
    return;
  }
  if (uses_.writer.refuses(path, WrittenKind::Export)) return;
  if (hasFilesBeside(settings.kind()))
    for (const std::string& other : existingOutputs(toPath(path)))
      if (uses_.writer.refuses(fromPath(other), WrittenKind::Export)) return;
  const bool drawn = settings.kind() == ExportKind::Png || (settings.kind() == ExportKind::Html && settings.pictures);
  const bool computed = uses_.controller.upToDate();
  if (computed && (!drawn || uses_.modes.upToDate())) {
    writeNow(path, settings);
    return;
  }
  std::erase_if(pending_, [&](const auto& pending) { return pending.first == path; });
  pending_.emplace_back(path, settings);
  uses_.log.add(MessageLevel::Note, tr("%1 is written once the run has finished").arg(path));
  if (!computed && !uses_.controller.busy()) uses_.controller.runNow();
}

void ResultExport::writeNow(const QString& path, const ExportSettings& settings) {
  if (settings.kind() == ExportKind::Png) {
    writePicture(path, settings);
  } else if (settings.kind() == ExportKind::Html) {
    writeReport(path, settings);
  } else {
    writeFiles(path, settings);
  }
}

void ResultExport::writeWaiting() {
  if (pending_.empty()) return;
  if (!uses_.controller.upToDate()) {
    if (!uses_.controller.busy()) uses_.controller.runNow();
    return;
  }
  if (!uses_.modes.upToDate()) return;
  for (const auto& [path, settings] : std::exchange(pending_, {})) write(path, settings);
}

QString ResultExport::takeWaiting() {
  QStringList names;
  for (const auto& [path, settings] : std::exchange(pending_, {})) names << path;
  if (!names.isEmpty()) emit dropped();
  return names.join(QStringLiteral(", "));
}

void ResultExport::writeFiles(const QString& path, const ExportSettings& settings) {
  uses_.writer.writeLong(
      [run = uses_.controller.finishedRun(), target = toPath(path), settings,
       extras = settings.placed ? placedExtras() : std::vector<ExportExtra>()](const RunContext& context) {
        const std::vector<OutputFile> files = makeExport(settings, target, *run, extras, context).files;
        if (meshFormat(settings.kind())) checkReplaced(target);
        checkUnasked(files, settings.replaceable.get());
        writeFilesSafely(files, context);
        if (settings.replaceable)
          for (const OutputFile& file : files) settings.replaceable->insert(file.path);
      },
      path);
}

// Drawing needs the window's thread and its OpenGL; the file is made in the background.
void ResultExport::writePicture(const QString& path, const ExportSettings& settings) {
  const QList<PictureSize> sizes = pictureSizes(uses_.view.size(), uses_.view.devicePixelRatioF());
  const PictureSize& size = sizes[std::clamp(settings.pictureSize, 0, static_cast<int>(sizes.size()) - 1)];
  const QImage image = uses_.view.picture(size.pixels, size.ratio);
  if (image.isNull()) {
    uses_.messages.showErrorOf(MessageSubject::Writing,
                               tr("%1: a picture of %2 × %3 cannot be drawn here; choose a smaller size")
                                   .arg(path)
                                   .arg(size.pixels.width())
                                   .arg(size.pixels.height()));
    return;
  }
  uses_.writer.writeLong(
      [image, target = toPath(path)](const RunContext& context) {
        const std::string png = pngOf(image);
        context.checkCancelled();
        writeFileSafely(target, png);
      },
      path);
}

void ResultExport::writeReport(const QString& path, const ExportSettings& settings) {
  std::vector<CaptionedImage> images, colours;
  if (settings.pictures) {
    colours = reportLegend(uses_.view.content(), uses_.view.parts());
    if (isHeatMap(uses_.view.mode()))
      colours.emplace_back(uses_.view.mode() == ViewMode::Slope
                               ? "Slope of floors; hatched: steeper than the limit"
                               : "Free height above floors; hatched: less than the limit",
                           uses_.legend.scaleImage());
    const auto take = [&](const char* caption, const QSize& size, PictureCamera from) {
      images.emplace_back(caption, uses_.view.picture(size, kReportRatio, from));
    };
    // The first picture has the view's shape, so that it shows the same part.
    take("As seen in the editor", uses_.view.size().scaled(kReportPicture, Qt::KeepAspectRatio), PictureCamera::AsSeen);
    take("From the top", kReportPicture, PictureCamera::Top);
    take("From above at an angle", kReportPicture, PictureCamera::Oblique);
  }
  uses_.writer.writeLong(
      [run = uses_.controller.finishedRun(), environment = uses_.level.environment(), images, colours,
       isNarrow = settings.bottlenecks, target = toPath(path)](const RunContext& context) {
        const std::vector<ReportPicture> pictures = pngsOf(images), legend = pngsOf(colours);
        context.checkCancelled();
        std::optional<CorridorMap> corridors;
        if (isNarrow) corridors = onThreads(0, [&](int) { return makeCorridorMap(*run->result.mesh, {}, &context); });
        const ReportDetails details{reportDate(), pictures, legend, corridors ? &*corridors : nullptr};
        const std::string html = formatHtmlReport(*environment, run->pipeline, run->result, {}, details);
        context.checkCancelled();
        writeFileSafely(target, html);
      },
      path);
}

// The placed shapes, as the level has them.
std::vector<ExportExtra> ResultExport::placedExtras() const {
  std::vector<ExportExtra> extras;
  for (const PlacedObstacle& obstacle : uses_.document.state().obstacles)
    extras.push_back({obstacle.name, soupOf(obstacle)});
  return extras;
}

}  // namespace footfall::ui
