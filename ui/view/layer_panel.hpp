// The dock "Layers": which layers there are, and which of them the view shows.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <QWidget>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>

#include "ui/base/level_units.hpp"
#include "ui/view/render_geometry.hpp"

namespace footfall::ui {

/// One row a layer, or one for all that is walkable where there are no layers: eye, colour and number, area,
/// triangles. The eye or Space hides and shows, a click or Enter on a row shows it alone, and again all. Layers stay
/// hidden by number over runs, as long as one is left to see.
class LayerPanel : public QWidget {
  Q_OBJECT

 public:
  explicit LayerPanel(QWidget* parent = nullptr);

  /// Lists the layers of a finished result; null: there is none.
  void setResult(std::shared_ptr<const NavigationMeshGeometry> result);
  void setUnits(const LevelUnits& units);
  /// Layers that the result does not have are kept: another one may.
  void setHidden(const std::set<std::uint32_t>& hidden);
  [[nodiscard]] const std::set<std::uint32_t>& hidden() const { return hidden_; }
  /// How many layers the result has.
  [[nodiscard]] std::uint32_t layers() const { return result_ ? result_->layers : 0; }
  /// The only layer that is shown; nothing when several are, or there are no layers.
  [[nodiscard]] std::optional<std::uint32_t> soloLayer() const;
  /// Null where the result has no such layer.
  [[nodiscard]] const LayerFigures* figuresOf(std::uint32_t layer) const {
    return result_ && layer < result_->figures.size() ? &result_->figures[layer] : nullptr;
  }
  void showOnly(std::uint32_t layer);
  void showAll() { setHidden({}); }
  /// Solo for the next layer up (1) or down (-1), around the ends.
  void stepSolo(int direction);
  [[nodiscard]] QTreeWidget& list() { return *list_; }

 signals:
  /// What the view is to leave out: hidden layers of this result.
  void hiddenChanged(const std::set<std::uint32_t>& hidden);
  /// Somebody wants to see where a layer is.
  void frameRequested(const footfall::ui::LayerFigures& layer);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  [[nodiscard]] std::set<std::uint32_t> hiddenHere() const;
  void fill();
  void showStates();
  void toggle(std::uint32_t layer);
  void solo(std::uint32_t layer);
  void act(QTreeWidgetItem* item, int column);

  std::shared_ptr<const NavigationMeshGeometry> result_;
  std::set<std::uint32_t> hidden_;
  LevelUnits units_;
  QTreeWidget* list_;
  QLabel* summary_;
  QPushButton* all_;
};

}  // namespace footfall::ui
