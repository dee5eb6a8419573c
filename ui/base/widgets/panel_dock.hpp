// Docks of panels: bringing them to the front, their commands, and scrolling their content on small screens.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QDockWidget>
#include <QScrollArea>

namespace footfall::ui {

/// The content of a dock. It scrolls where the dock is smaller than the content, so that no content forces the dock or
/// the window to be larger.
class PanelArea : public QScrollArea {
  Q_OBJECT

 public:
  explicit PanelArea(QWidget* content, QWidget* parent = nullptr);

  /// Makes the dock as high as its content at most, for small panels above large ones. The content scrolls only where
  /// it needs much of the window, which must already hold the dock.
  void setFitsContent();

  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fit();
  [[nodiscard]] int contentHeight() const;

  bool fitsContent_ = false;
};

/// Returns whether the dock is visible: neither hidden nor behind another tab.
[[nodiscard]] bool isInFront(const QDockWidget& dock);

/// Shows the dock in front of the others that share its place. The focus does not move.
void bringToFront(QDockWidget& dock);

/// Moves the focus to the list of the dock, or to its first control where it has no list.
void focusPanel(QDockWidget& dock);

/// Makes a checkable action, owned by `parent` and checked while the dock is in front. Triggering it brings the dock to
/// the front and focuses it, or hides a dock that is in front. The focus then moves to `home`, unless it was elsewhere.
QAction* makePanelAction(QDockWidget& dock, QWidget& home, QObject* parent);

}  // namespace footfall::ui
