// A frame over the view that can be moved and folded, and keeps its place.
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

/// A title, which folds the body, and the body. It can be dragged by all parts without another function; a double click
/// returns it to its corner. The frame is folded where it would take much of the view, and stays so when it shrinks,
/// until the view's size changes, another kind of content comes or the user unfolds it. The settings keep both under
/// `setting`.
class OverlayFrame : public QFrame {
  Q_OBJECT

 public:
  OverlayFrame(const QString& title, const QString& setting, QWidget* parent);

  [[nodiscard]] bool folded() const;
  void setFolded(bool on);
  [[nodiscard]] QToolButton& foldButton() { return *fold_; }
  /// Resizes the frame for a view of this size and moves it to its saved place. Returns false when it has none.
  bool fitInto(const QSize& view);

 signals:
  /// Emitted when the frame was moved, folded or resized.
  void changed();

 protected:
  /// The layout below the title, which subclasses fill.
  [[nodiscard]] QVBoxLayout& body() { return *bodyLayout_; }
  /// Forgets that an earlier content took much of the view.
  void forgetCrowding() { crowded_ = false; }
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
  std::optional<bool> chosenFold_;  ///< chosen by the user
  bool crowded_ = false;            ///< the view is small
  QSize fittedInto_;                ///< last size of the view
  std::optional<QPointF> place_;    ///< as shares of the free room of the view
  std::optional<QPoint> grip_;      ///< place at which the mouse holds it
  bool dragging_ = false;
};

}  // namespace footfall::ui
