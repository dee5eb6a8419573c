// A frame over the view that can be moved and folded, and is found again where it was left.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QLabel>
#include <QPoint>
#include <QPointF>
#include <QSize>
#include <QToolButton>
#include <QVBoxLayout>
#include <optional>

namespace footfall::ui {

/// A title, which folds the rest away and back, and a body. Dragged by whatever of it does nothing else; a double click
/// takes it back to its corner. In a view in which it would take much of the room it is folded, and stays so when it
/// shrinks, until the view is of another size or somebody says otherwise. The settings keep both under `setting`.
class OverlayFrame : public QFrame {
  Q_OBJECT

 public:
  OverlayFrame(const QString& title, const QString& setting, QWidget* parent);

  [[nodiscard]] bool folded() const;
  void setFolded(bool on);
  [[nodiscard]] QToolButton& foldButton() { return *fold_; }
  /// Takes the size that fits it in such a view, at the place where it was put, or nowhere: false is returned.
  bool fitInto(const QSize& view);

 signals:
  /// Moved, folded, or of another size.
  void changed();

 protected:
  /// The layout below the title, for subclasses to fill.
  [[nodiscard]] QVBoxLayout& body() { return *bodyLayout_; }
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;

 private:
  [[nodiscard]] QSize roomIn(const QSize& view) const;
  void showFold();

  QString setting_;
  QToolButton* fold_;
  QWidget* body_;
  QVBoxLayout* bodyLayout_;
  std::optional<bool> chosenFold_;  ///< by somebody
  bool crowded_ = false;            ///< the view is small
  QSize fittedInto_;                ///< the view's size, last time
  std::optional<QPointF> place_;    ///< in parts of the room that the view leaves it
  std::optional<QPoint> grip_;      ///< where the mouse holds it
  bool dragging_ = false;
};

}  // namespace footfall::ui
