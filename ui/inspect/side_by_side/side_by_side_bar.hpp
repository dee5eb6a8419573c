// What two pipelines give, in numbers, and what can be done with them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QToolButton>
#include <array>
#include <optional>

#include "ui/agents/agent_results.hpp"
#include "ui/base/text/level_units.hpp"

namespace footfall::ui {

/// A table of area, layers and components of A, of B, and of their difference, with buttons.
class SideBySideBar : public QFrame {
  Q_OBJECT

 public:
  explicit SideBySideBar(QWidget* parent = nullptr);

  void setUnits(const LevelUnits& units);
  /// Where B comes from.
  void setOther(const QString& name);
  /// Nothing: not known yet.
  void setFigures(const std::optional<AgentFigures>& a, const std::optional<AgentFigures>& b);
  /// What stands in place of B's figures: an error, or that it is being computed; empty: nothing.
  void setNote(const QString& note);

  /// Filled by who knows what B can be.
  [[nodiscard]] QMenu* sources() const { return sources_; }
  /// The text of a cell: row 0 to 2 (A, B, B - A), column 0 to 2 (area, layers, components).
  [[nodiscard]] QString cell(std::size_t row, std::size_t column) const { return cells_[row][column]->text(); }
  [[nodiscard]] QString note() const { return note_->text(); }
  [[nodiscard]] QPushButton* swapButton() const { return swap_; }
  [[nodiscard]] QPushButton* keepAButton() const { return keepA_; }
  [[nodiscard]] QPushButton* keepBButton() const { return keepB_; }

 signals:
  void swapRequested();
  /// Side by side ends; B's pipeline is to stay, or A's.
  void keepRequested(bool b);

 private:
  void showFigures();

  LevelUnits units_;
  std::optional<AgentFigures> a_, b_;
  std::array<std::array<QLabel*, 3>, 3> cells_{};
  QLabel *nameB_, *note_;
  QPushButton *swap_, *keepA_, *keepB_;
  QMenu* sources_;
};

}  // namespace footfall::ui
