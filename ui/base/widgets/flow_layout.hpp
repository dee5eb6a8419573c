// A row of items that wraps into further lines.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLayout>
#include <QList>

namespace footfall::ui {

/// Places items from left to right, in as many lines as the width needs, for buttons whose texts are longer in other
/// languages. Items that may grow share the rest of their line.
class FlowLayout : public QLayout {
  Q_OBJECT

 public:
  explicit FlowLayout(int spacing, QWidget* parent = nullptr);
  ~FlowLayout() override;

  void addItem(QLayoutItem* item) override;
  [[nodiscard]] int count() const override { return static_cast<int>(items_.size()); }
  [[nodiscard]] QLayoutItem* itemAt(int index) const override { return items_.value(index); }
  QLayoutItem* takeAt(int index) override;
  [[nodiscard]] Qt::Orientations expandingDirections() const override { return {}; }
  [[nodiscard]] bool hasHeightForWidth() const override { return true; }
  [[nodiscard]] int heightForWidth(int width) const override;
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSize() const override;
  void setGeometry(const QRect& area) override;

 private:
  /// Places the items when `place` is true; returns the height of all lines.
  int arrange(const QRect& area, bool place) const;
  void placeLine(const QList<QLayoutItem*>& line, const QRect& area, int height) const;

  QList<QLayoutItem*> items_;
};

}  // namespace footfall::ui
