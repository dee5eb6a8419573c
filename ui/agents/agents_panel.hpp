// The dock "Agents": the agents of the level, and the areas that each of them can reach.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <QMenu>
#include <QProgressBar>
#include <QPushButton>
#include <QTableView>
#include <QToolButton>

#include "ui/agents/agent_model.hpp"

namespace footfall::ui {

/// The current row is the active agent. A double click, F2 or typing edits an entry.
class AgentsPanel : public QWidget {
  Q_OBJECT

 public:
  AgentsPanel(Document& document, RunController& controller, QWidget* parent = nullptr);

  void setUnits(const LevelUnits& units);
  void computeAll() { results_->computeAll(); }
  /// Activates an agent, counting from 0; does nothing where there is no such agent.
  void activate(int row);
  void letGo();

  [[nodiscard]] QTableView* table() const { return table_; }
  [[nodiscard]] AgentModel& model() const { return *model_; }
  [[nodiscard]] const AgentResults& results() const { return *results_; }
  [[nodiscard]] QToolButton* addButton() const { return add_; }
  [[nodiscard]] QString hintText() const { return hint_->text(); }
  [[nodiscard]] QPushButton* hintButton() const { return hintButton_; }

 signals:
  void failed(const QString& message);

 private:
  QToolButton* button(const char* name, const QString& text, const QString& help, const QString& icon);
  void createButtons(class QLayout* layout);
  void fillAddMenu();
  void follow();
  void showAhead(int done, int all);
  void copy(bool csv);
  void addMissingFilters();

  Document& document_;
  RunController& controller_;
  AgentResults* results_;
  AgentModel* model_;
  double metresPerUnit_ = 1;
  QMenu* addMenu_;
  QToolButton* add_;
  QToolButton* duplicate_;
  QToolButton* remove_;
  QToolButton* letGo_;
  QToolButton* compute_;
  QToolButton* copy_;
  QProgressBar* ahead_;
  QTableView* table_;
  QLabel* hint_;
  QPushButton* hintButton_;
  bool following_ = false;  // the table is being updated from the document and must not edit it
};

}  // namespace footfall::ui
