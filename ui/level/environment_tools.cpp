// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/level/environment_tools.hpp"

#include <QFileInfo>
#include <QSettings>
#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <utility>

#include "ui/view/overlays/box_edges.hpp"
#include "ui/view/scene/appearance.hpp"

namespace footfall::ui {
namespace {

constexpr const char* kWatchSetting = "watchFile";
constexpr const char* kPartsOverlay = "parts";
// Overlays are sent to the graphics card with every frame, so larger parts are shown by their box alone.
constexpr std::size_t kMostHighlighted = 20'000;
constexpr int kHighlightAlpha = 110;

struct Bounds {
  Vec3 lower{std::numeric_limits<double>::max(), std::numeric_limits<double>::max(),
             std::numeric_limits<double>::max()};
  Vec3 upper{std::numeric_limits<double>::lowest(), std::numeric_limits<double>::lowest(),
             std::numeric_limits<double>::lowest()};
  void include(const Vec3& p) {
    lower = {std::min(lower.x, p.x), std::min(lower.y, p.y), std::min(lower.z, p.z)};
    upper = {std::max(upper.x, p.x), std::max(upper.y, p.y), std::max(upper.z, p.z)};
  }
};

/// Calls visit(triangle) for each triangle of the parts.
template <class Visit>
void forTriangles(const Environment& environment, const std::vector<std::uint32_t>& parts, Visit visit) {
  std::vector<char> wanted(std::max<std::size_t>(environment.parts.size(), 1), 0);
  for (const std::uint32_t part : parts) wanted[part] = 1;
  for (std::size_t t = 0; t < environment.triangles.size(); ++t)
    if (wanted[environment.partOf.empty() ? 0 : environment.partOf[t]] != 0) visit(environment.triangles[t]);
}

std::optional<Bounds> boundsOf(const Environment& environment, const std::vector<std::uint32_t>& parts) {
  std::optional<Bounds> bounds;
  forTriangles(environment, parts, [&](const Triangle& t) {
    if (!bounds) bounds.emplace();
    for (const std::uint32_t v : t) bounds->include(environment.vertices[v]);
  });
  return bounds;
}

}  // namespace

EnvironmentTools::EnvironmentTools(const FeatureHost& host, LevelView& view, Document& document, LevelFile& file,
                                   LevelComposer& composer, ImportPanel& import)
    : QObject(&host.window),
      view_(view),
      document_(document),
      file_(file),
      composer_(composer),
      messages_(host.messages) {
  createPanel(host);
  createWatch(import);
  connect(&file_, &LevelFile::opened, this, &EnvironmentTools::follow);
  connect(&file_, &LevelFile::rereadDone, this, [this] { panel_->setEnvironment(file_.environment()); });
  PartLevel& parts = composer_.parts();
  connect(&parts, &PartLevel::geometryChanged, this, [this, &parts] {
    // With obstacles the base is a part of the level, which LevelGeometry shows.
    if (composer_.level() == parts.base()) view_.replaceEnvironment(parts.geometry());
  });
}

void EnvironmentTools::createPanel(const FeatureHost& host) {
  panel_ = new PartPanel(document_, &host.window);
  // The dock lies beside the filters, which stay in front, because both need the height.
  dock_ = host.panels.add({QStringLiteral("view.parts"),
                           tr("Meshes and Materials"),
                           tr("Leave parts of the environment out, or make them obstacles that nobody walks on"),
                           {Qt::CTRL | Qt::SHIFT | Qt::Key_M},
                           {},
                           Qt::LeftDockWidgetArea,
                           true,
                           QStringLiteral("filterDock")},
                          panel_);
  connect(panel_, &PartPanel::selectionChanged, this, &EnvironmentTools::highlight);
  connect(panel_, &PartPanel::activated, this, &EnvironmentTools::frame);
}

void EnvironmentTools::createWatch(ImportPanel& import) {
  QCheckBox* box = import.watchBox();
  box->setChecked(QSettings().value(QLatin1String(kWatchSetting), true).toBool());
  watch_.setEnabled(box->isChecked());
  connect(box, &QCheckBox::toggled, this, [this](bool on) {
    QSettings().setValue(QLatin1String(kWatchSetting), on);
    watch_.setEnabled(on);
  });
  connect(&watch_, &FileWatch::changed, this, &EnvironmentTools::reread);
  connect(&watch_, &FileWatch::vanished, this, [this] {
    messages_.showHint(
        tr("%1 was deleted; the result stays, and the file is read again once it exists").arg(fileName()));
  });
  connect(&watch_, &FileWatch::givenUp, this, [this](const QString& message) {
    if (message.isEmpty()) return;
    messages_.showError(tr("%1 changed on disk, but %2; the earlier version stays loaded").arg(fileName(), message));
  });
  connect(&file_, &LevelFile::rereadDone, this, [this] {
    rereading_ = false;
    watch_.readSucceeded();
    messages_.showHint(tr("%1 changed on disk; read again").arg(fileName()));
    rereadIfPending();
  });
  connect(&file_, &LevelFile::rereadFailed, this, [this](const QString& message) {
    rereading_ = false;
    watch_.readFailed(message);
    rereadIfPending();
  });
  connect(&file_, &LevelFile::failed, this, &EnvironmentTools::rereadIfPending);
  connect(&file_, &LevelFile::cancelled, this, [this] {
    // the reread is under way: not again before the next change
    if (std::exchange(rereading_, false)) watch_.acknowledge();
    pending_ = false;
  });
}

void EnvironmentTools::acknowledge(const QString& path) {
  if (QFileInfo(path) == QFileInfo(watch_.path())) watch_.acknowledge();
}

// The file being read may be the old version, or another file that fails to load.
void EnvironmentTools::reread() {
  pending_ = file_.busy();
  if (pending_) return;
  rereading_ = true;
  file_.reread(document_.state().import);
}

void EnvironmentTools::rereadIfPending() {
  if (std::exchange(pending_, false)) reread();
}

void EnvironmentTools::follow() {
  rereading_ = false;
  panel_->setEnvironment(file_.environment());
  const QString path = file_.path();
  const bool same = path == watch_.path();
  watch_.watch(path);
  if (same)
    rereadIfPending();
  else
    pending_ = false;
}

QString EnvironmentTools::fileName() const { return QFileInfo(watch_.path()).fileName(); }

void EnvironmentTools::highlight(const std::vector<std::uint32_t>& parts) {
  const auto environment = file_.environment();
  const auto bounds = environment && !parts.empty() ? boundsOf(*environment, parts) : std::nullopt;
  if (!bounds) {
    if (std::exchange(highlighted_, false))
      view_.cameraController().setSelectionBounds(QLatin1String(kPartsOverlay), std::nullopt);
    view_.removeOverlay(QLatin1String(kPartsOverlay));
    return;
  }
  highlighted_ = true;
  view_.cameraController().setSelectionBounds(QLatin1String(kPartsOverlay), SceneBox{bounds->lower, bounds->upper});
  ViewOverlay overlay;
  overlay.throughWalls = true;
  std::size_t triangles = 0;
  forTriangles(*environment, parts, [&](const Triangle&) { ++triangles; });
  QColor colour = selectedCellColour();
  overlay.lines.push_back({edgesOfBox(bounds->lower, bounds->upper), colour, 2, outlineColour()});
  if (triangles <= kMostHighlighted) {
    colour.setAlpha(kHighlightAlpha);
    ViewOverlay::Surface surface{{}, colour};
    surface.triangles.reserve(triangles);
    forTriangles(*environment, parts, [&](const Triangle& t) {
      surface.triangles.push_back(
          {environment->vertices[t[0]], environment->vertices[t[1]], environment->vertices[t[2]]});
    });
    overlay.surfaces.push_back(std::move(surface));
  }
  view_.setOverlay(QLatin1String(kPartsOverlay), std::move(overlay));
}

void EnvironmentTools::frame(const std::vector<std::uint32_t>& parts) {
  const auto environment = file_.environment();
  if (!environment || parts.empty()) return;
  if (const auto bounds = boundsOf(*environment, parts)) view_.cameraController().frame(bounds->lower, bounds->upper);
}

}  // namespace footfall::ui
