// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/path/passage_view.hpp"

#include <utility>

#include "ui/base/look/core_colours.hpp"
#include "ui/inspect/corridors/corridor_colours.hpp"
#include "ui/inspect/corridors/dimension_line.hpp"

namespace footfall::ui {
namespace {

const QString kPassageOverlay = QStringLiteral("passage");

}  // namespace

PassageView::PassageView(PathModel& model, LevelView& view, QWidget* parent)
    : QPushButton(parent), model_(model), view_(view) {
  setObjectName(QStringLiteral("pathShowPassage"));
  connect(this, &QPushButton::clicked, this, [this] {
    if (const auto box = bounds()) view_.cameraController().frame(box->lower, box->upper);
  });
  connect(&model_, &PathModel::resultChanged, this, &PassageView::update);
  hide();
}

void PassageView::setUnits(const LevelUnits& units) {
  units_ = units;
  update();
}

void PassageView::setShown(bool shown) {
  shown_ = shown;
  update();
}

std::optional<SceneBox> PassageView::bounds() const {
  const auto& path = model_.bodyPath();
  if (!path) return std::nullopt;
  if (path->narrowest) return boxAround(*path->narrowest, margin_);
  if (!path->admissible) return std::nullopt;
  const Vec3& given = path->status == BodyPathStatus::StartTooNear ? path->path.from : path->path.to;
  return boxAround({*path->admissible, *path->admissible, given}, margin_);
}

void PassageView::update() {
  const auto& path = model_.bodyPath();
  setVisible(bounds().has_value());
  if (path) {
    setText(path->narrowest ? tr("Show the &passage") : tr("Show the &place"));
    setToolTip(path->narrowest ? tr("Bring the narrowest passage of the way into sight")
                               : tr("Bring a place with enough room into sight"));
  }
  if (!shown_ || !bounds()) return view_.removeOverlay(kPassageOverlay);
  ViewOverlay overlay;
  overlay.throughWalls = true;
  if (path->narrowest) {
    const QString width = units_.length(path->narrowest->width);
    const bool isTooNarrow = path->status == BodyPathStatus::TooNarrow;
    addDimension(overlay, *path->narrowest, isTooNarrow ? widthColour(0) : toColour(kYellow),
                 isTooNarrow ? tr("%1, %2 too narrow").arg(width, units_.length(path->lacking)) : width);
  } else {
    overlay.marks.push_back({*path->admissible, toColour(kYellow), 12});
    overlay.labels.push_back({*path->admissible, tr("Enough room")});
  }
  view_.setOverlay(kPassageOverlay, std::move(overlay));
}

}  // namespace footfall::ui
