// Docks of panels: in front or behind a tab, their commands, and room for their content on small screens.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QDockWidget>
#include <QScrollArea>

namespace footfall::ui {

/// What a dock shows. It scrolls where the dock is smaller than its content, so that no content forces the dock, or the
/// window around it, to be larger.
class PanelArea : public QScrollArea {
  Q_OBJECT

 public:
  explicit PanelArea(QWidget* content, QWidget* parent = nullptr);

  /// The dock is as high as its content, and scrolls only where that takes much of the window, which it is in already.
  /// Makes it at most as high as its content, for small panels above large ones.
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

/// Whether the dock can be seen: it is neither hidden nor behind another tab.
[[nodiscard]] bool isInFront(const QDockWidget& dock);

/// Shows the dock, before the others that it shares its place with. The focus stays where it is.
void bringToFront(QDockWidget& dock);

/// Gives the focus to the list of the dock, or to its first control where it has no list.
void focusPanel(QDockWidget& dock);

/// A checkable action, owned by `parent` and checked while the dock is in front. Triggered, it brings the dock to the
/// front with the focus, or hides one that is there; the focus then goes to `home`, unless it was elsewhere.
QAction* makePanelAction(QDockWidget& dock, QWidget& home, QObject* parent);

}  // namespace footfall::ui
