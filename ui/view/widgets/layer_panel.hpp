// The dock "Layers": lists the layers, and chooses which of them the view shows.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <QWidget>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>

#include "ui/base/text/level_units.hpp"
#include "ui/view/geometry/render_geometry.hpp"

namespace footfall::ui {

/// The connections of a result, and how many layers and connections it needs at least.
struct LayerCounts {
  std::size_t connections = 0;
  std::size_t leastLayers = 0, leastConnections = 0;
};

/// A row for each layer, or one for the whole walkable area where there are no layers: eye, colour and number, area,
/// triangles. The eye or Space hides and shows a layer; a click or Enter on a row shows it alone, and a second one
/// shows all. Layers stay hidden by number over runs, as long as one is left to show.
class LayerPanel : public QWidget {
  Q_OBJECT

 public:
  explicit LayerPanel(QWidget* parent = nullptr);

  /// Lists the layers of a finished result; null: there is none.
  void setResult(std::shared_ptr<const NavigationMeshGeometry> result);
  /// Shows the counts of the result until another one is set.
  void setCounts(const LayerCounts& counts);
  void setUnits(const LevelUnits& units);
  /// Layers that the result does not have are kept, because another result may have them.
  void setHidden(const std::set<std::uint32_t>& hidden);
  [[nodiscard]] const std::set<std::uint32_t>& hidden() const { return hidden_; }
  /// The number of layers of the result.
  [[nodiscard]] std::uint32_t layers() const { return result_ ? result_->layers : 0; }
  /// The only layer that is shown; empty when several are, or there are no layers.
  [[nodiscard]] std::optional<std::uint32_t> soloLayer() const;
  /// Null where the result has no such layer.
  [[nodiscard]] const LayerFigures* figuresOf(std::uint32_t layer) const {
    return result_ && layer < result_->figures.size() ? &result_->figures[layer] : nullptr;
  }
  void showOnly(std::uint32_t layer);
  void showAll() { setHidden({}); }
  /// Shows only the next layer up (1) or down (-1), wrapping around at the ends.
  void stepSolo(int direction);
  [[nodiscard]] QTreeWidget& list() { return *list_; }

 signals:
  /// Emitted with the layers of this result that the view should hide.
  void hiddenChanged(const std::set<std::uint32_t>& hidden);
  /// Emitted when the user chooses to see a layer.
  void frameRequested(const footfall::ui::LayerFigures& layer);
  /// Emitted when the list comes into sight.
  void appeared();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void changeEvent(QEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  [[nodiscard]] std::set<std::uint32_t> hiddenHere() const;
  void fill();
  void showStates();
  [[nodiscard]] QString countsText() const;
  void toggle(std::uint32_t layer);
  void solo(std::uint32_t layer);
  void act(QTreeWidgetItem* item, int column);

  std::shared_ptr<const NavigationMeshGeometry> result_;
  std::optional<LayerCounts> counts_;
  std::set<std::uint32_t> hidden_;
  LevelUnits units_;
  QTreeWidget* list_;
  QLabel* summary_;
  QPushButton* all_;
};

}  // namespace footfall::ui
