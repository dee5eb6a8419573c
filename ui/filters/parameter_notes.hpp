// Hints about filter values that do not suit the level.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <optional>

#include "core/inspect/parameter_check.hpp"
#include "ui/base/messages/message_bar.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/base/work/latest_work.hpp"
#include "ui/document/document.hpp"
#include "ui/level/level_file.hpp"

namespace footfall::ui {

/// Measures each level that is opened in the background, and shows a hint where the filters do not suit it, then and
/// after edits; each hint once, and none where another message stands. Where the advice is a number, a button of the
/// hint sets it. A scale that is a guess is asked about elsewhere. The hint on a level that is smaller than its agents
/// is shown at once when it is opened, before anything is measured or run.
class ParameterNotes : public QObject {
  Q_OBJECT

 public:
  ParameterNotes(Document& document, LevelFile& file, MessageBar& messages, QObject* parent);

 signals:
  /// Emitted when a level has been measured.
  void measured(const footfall::detail::LevelMeasures& measures);
  /// Emitted once for each level that is opened: its hint is shown by now, or it has none.
  void settled();
  /// The button of a hint about the level's size was clicked.
  void scaleChosen(double metresPerUnit);

 private:
  void measure();
  void showTooSmall();
  void show();
  bool tell(const ParameterNote& note, const Pipeline& pipeline);
  void offer(const QString& text, const ParameterNote& note, const Pipeline& pipeline);
  void setValue(int id, std::size_t value, double to);

  Document& document_;
  LevelFile& file_;
  MessageBar& messages_;
  std::optional<LevelMeasures> measures_;  ///< measures of the level; empty until it is measured
  QString told_;
  bool isEarly_ = false;  ///< told_ is the hint of showTooSmall()
  LatestWork work_;       // declared last: its thread ends before the other members are destroyed
};

}  // namespace footfall::ui
