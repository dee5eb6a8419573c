// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspect/compare_feature.hpp"

#include <QFileDialog>
#include <QFileInfo>
#include <array>
#include <utility>

#include "ui/base/widgets/panel_dock.hpp"
#include "ui/view/overlays/box_edges.hpp"

namespace footfall::ui {
namespace {

const QString kDifferenceOverlay = QStringLiteral("difference");
constexpr int kAlpha = 215;
constexpr std::size_t kMostDrawn = 40'000;  // in triangles: overlays are sent to the graphics card with every frame

}  // namespace

CompareFeature::CompareFeature(const FeatureHost& host, LevelView& view, ViewLayout& layout, Document& document,
                               LevelFile& file, RunController& controller)
    : QObject(&host.window),
      window_(host.window),
      view_(view),
      layout_(layout),
      document_(document),
      file_(file),
      controller_(controller),
      units_(host.units),
      watch_(new CompareWatch(this)),
      panel_(new ComparePanel) {
  setObjectName(QStringLiteral("compare"));
  dock_ = host.panels.add(
      {QStringLiteral("panel.compare"),
       tr("Compare"),
       tr("Show what appeared and what disappeared since the last edit, or compared with a saved result"),
       {},
       {},
       Qt::RightDockWidgetArea,
       false},
      panel_);
  addCommands(host.commands);
  connect(panel_, &ComparePanel::chosen, this, &CompareFeature::choose);
  connect(panel_, &ComparePanel::distanceToggled, watch_, &CompareWatch::setDistancesWanted);
  connect(panel_, &ComparePanel::frameRequested, this, &CompareFeature::frame);
  connect(dock_->toggleViewAction(), &QAction::toggled, this, [this](bool on) {
    if (!on) watch_->compareWithNothing();
  });
  connect(watch_, &CompareWatch::changed, this, &CompareFeature::show);
  connect(watch_, &CompareWatch::failed, &host.messages, &MessageBar::showError);
  connect(&controller_, &RunController::finished, this, &CompareFeature::takeResult);
  connect(&controller_, &RunController::started, this, [this] {
    isComputed_ = true;
    watch_->stop();
    panel_->setWaiting(watch_->with() != CompareWith::Nothing);
  });
  const auto resume = [this] {
    watch_->resume();
    panel_->setWaiting(watch_->busy());
  };
  connect(&controller_, &RunController::cancelled, this, resume);
  connect(&controller_, &RunController::failed, this, resume);
  connect(&file_, &LevelFile::opened, watch_, &CompareWatch::forget);
  connect(&units_, &UnitChoice::changed, this, &CompareFeature::show);
  // While the window is destroyed, its docks are hidden when the view no longer exists.
  connect(&host.commands, &QObject::destroyed, this, [this] { dock_->toggleViewAction()->disconnect(this); });
  show();
}

void CompareFeature::addCommands(CommandRegistry& commands) {
  lastEdit_ = commands.add({QStringLiteral("view.compareEdit"),
                            CommandMenu::View,
                            QStringLiteral("compare"),
                            tr("Compare with the Last Edit"),
                            tr("Show in the view what the last edit made walkable, and what is no longer walkable"),
                            {},
                            {},
                            true},
                           [this](bool on) {
                             if (on) {
                               choose(ComparePanel::LastEdit);
                             } else if (watch_->with() == CompareWith::LastEdit) {
                               choose(ComparePanel::Nothing);
                             }
                           });
  commands.add({QStringLiteral("view.compareSaved"), CommandMenu::View, QStringLiteral("compare"),
                tr("Compare with a Saved Result…"),
                tr("Show in the view how an exported result, or another tool's mesh, differs")},
               [this](bool) { chooseFile(); });
}

void CompareFeature::choose(int choice) {
  if (choice == ComparePanel::SavedResult) {
    chooseFile();
    show();  // the box is reset until there is a file
    return;
  }
  if (choice == ComparePanel::LastEdit) {
    showPanel();
    watch_->compareWithLastEdit();
  } else {
    watch_->compareWithNothing();
  }
}

void CompareFeature::chooseFile() {
  auto* dialog = new QFileDialog(&window_, tr("Compare with a saved result"), QString(), tr("Results (*.obj)"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  if (const auto environment = file_.environment())
    dialog->setDirectory(QFileInfo(QString::fromStdString(environment->source)).path());
  connect(dialog, &QFileDialog::fileSelected, this, &CompareFeature::openSaved);
  dialog->open();
}

void CompareFeature::openSaved(const QString& path) {
  showPanel();
  watch_->compareWithSaved(path, file_.environment() ? file_.environment()->up : UpAxis::Y);
}

void CompareFeature::showPanel() {
  bringToFront(*dock_);
  dock_->raise();
}

void CompareFeature::takeResult() {
  const auto take = [this] {
    const auto run = controller_.finishedRun();
    if (run) watch_->takeResult(run->result.mesh, document_.undoStack()->index());
  };
  // A cached result arrives while the undo stack is still moving; its index is then the old one.
  if (std::exchange(isComputed_, false)) {
    take();
  } else {
    QMetaObject::invokeMethod(this, take, Qt::QueuedConnection);
  }
}

CompareWriter CompareFeature::writer() const {
  const LevelUnits units = units_.units();
  return {[units](double area) { return units.area(area); }, [units](const Vec3& place) { return units.place(place); }};
}

void CompareFeature::show() {
  const auto& difference = watch_->difference();
  const CompareWith with = watch_->with();
  panel_->setChoice(with == CompareWith::Nothing    ? ComparePanel::Nothing
                    : with == CompareWith::LastEdit ? ComparePanel::LastEdit
                                                    : ComparePanel::SavedResult,
                    QFileInfo(watch_->path()).fileName());
  lastEdit_->setChecked(with == CompareWith::LastEdit);
  chosenRegion_ = -1;
  if (difference && !watch_->busy()) {
    panel_->showDifference(*difference, writer());
    if (watch_->distances()) panel_->addLine(distanceLine(*watch_->distances()));
  } else if (watch_->busy()) {
    if (!difference) panel_->showNote(tr("Comparing …"));
    panel_->setWaiting(true);
    return;  // the last difference stays visible
  } else {
    panel_->showNote(with == CompareWith::Nothing ? tr("Choose what to compare the result with.")
                     : !controller_.finishedRun()
                         ? tr("There is no result yet; the comparison follows when a run has finished.")
                         : tr("There is no edit yet; the changes of the next edit will be shown here."));
  }
  draw();
}

QString CompareFeature::distanceLine(const DistanceBands& bands) const {
  const LevelUnits units = units_.units();
  return tr("Distances, taken at %n corners: at most %1, mean %2, root mean square %3", "",
            static_cast<int>(bands.samples))
      .arg(units.length(bands.largest), units.length(bands.mean), units.length(bands.rms));
}

void CompareFeature::draw() {
  const auto& difference = watch_->difference();
  const auto& distances = watch_->distances();
  if (!difference) {
    view_.removeOverlay(kDifferenceOverlay);
    view_.cameraController().setSelectionBounds(kDifferenceOverlay, std::nullopt);
    layout_.legend().setNotes({});
  } else if (distances && !distances->isEmpty()) {
    drawDistances(*distances);
  } else {
    drawDifference(*difference);
  }
  layout_.update();
}

void CompareFeature::drawDifference(const SurfaceDifference& difference) {
  ViewOverlay overlay;
  overlay.throughWalls = true;
  std::array<ViewOverlay::Surface, 2> surfaces;
  const std::array colours{wentColour(), appearedColour()};
  // The largest regions, as many as can be drawn with every frame.
  std::vector<std::size_t> triangles(difference.regions.size(), 0);
  for (const auto& regionOf : difference.regionOf)
    for (const std::uint32_t region : regionOf) ++triangles[region];
  std::size_t drawn = 0, count = 0;
  while (count < triangles.size() && drawn + triangles[count] <= kMostDrawn) drawn += triangles[count++];
  for (std::size_t m = 0; m < 2; ++m) {
    surfaces[m].colour = colours[m];
    surfaces[m].colour.setAlpha(kAlpha);
    for (std::size_t i = 0; i < difference.triangles[m].size(); ++i)
      if (difference.regionOf[m][i] < count) surfaces[m].triangles.push_back(difference.triangles[m][i]);
    overlay.surfaces.push_back(std::move(surfaces[m]));
  }
  if (chosenRegion_ >= 0) {
    const DifferentRegion& region = difference.regions[static_cast<std::size_t>(chosenRegion_)];
    overlay.lines.push_back({edgesOfBox(region.lower, region.upper), colours[region.mesh], 2, QColor(Qt::white)});
  }
  view_.setOverlay(kDifferenceOverlay, std::move(overlay));
  const CompareWriter write = writer();
  std::vector<Legend::Note> notes{{appearedColour(), appearedText(difference, write)},
                                  {wentColour(), wentText(difference, write)}};
  if (count < triangles.size())
    notes.push_back({QColor(), tr("Only the largest %n regions are drawn", "", static_cast<int>(count))});
  layout_.legend().setNotes(notes);
}

void CompareFeature::drawDistances(const DistanceBands& bands) {
  ViewOverlay overlay;
  const auto colourOf = [](std::size_t band) {
    const auto [red, green, blue] = colourOfBand(band);
    return QColor(red, green, blue);
  };
  for (std::size_t band = 0; band < DistanceBands::kCount; ++band) {
    if (bands.triangles[band].empty()) continue;
    overlay.surfaces.push_back({bands.triangles[band], colourOf(band)});
    overlay.surfaces.back().colour.setAlpha(kAlpha);
  }
  if (bands.largest > 0) overlay.marks.push_back({bands.farthest, QColor(Qt::black)});
  view_.setOverlay(kDifferenceOverlay, std::move(overlay));
  const LevelUnits units = units_.units();
  std::vector<Legend::Note> notes{{QColor(), tr("Distance to the other result")}};
  constexpr std::size_t kSteps = 4;
  for (std::size_t step = 0; step <= (bands.largest > 0 ? kSteps : 0); ++step)
    notes.push_back({colourOf(step * (DistanceBands::kCount - 1) / kSteps),
                     units.length(bands.largest * static_cast<double>(step) / kSteps)});
  if (bands.leftOut > 0)
    notes.push_back(
        {QColor(), tr("%n triangles with the smallest distances are not drawn", "", static_cast<int>(bands.leftOut))});
  layout_.legend().setNotes(notes);
}

void CompareFeature::frame(int region) {
  const auto& difference = watch_->difference();
  if (!difference || region < 0 || static_cast<std::size_t>(region) >= difference->regions.size()) return;
  chosenRegion_ = region;
  draw();
  const DifferentRegion& chosen = difference->regions[static_cast<std::size_t>(region)];
  view_.cameraController().setSelectionBounds(kDifferenceOverlay, SceneBox{chosen.lower, chosen.upper});
  view_.cameraController().frame(chosen.lower, chosen.upper);
}

}  // namespace footfall::ui
