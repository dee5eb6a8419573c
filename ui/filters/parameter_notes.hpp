// Hints about filter values that do not suit the level.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <optional>

#include "core/inspect/parameter_check.hpp"
#include "ui/base/latest_work.hpp"
#include "ui/base/message_bar.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/document/document.hpp"
#include "ui/level/level_file.hpp"

namespace footfall::ui {

/// Measures each opened level in the background, and shows a hint where the filters do not suit it, then and after
/// edits. Each hint appears once, and never replaces another message. ScaleQuestion handles a guessed scale.
class ParameterNotes : public QObject {
  Q_OBJECT

 public:
  ParameterNotes(Document& document, LevelFile& file, MessageBar& messages, QObject* parent);

 signals:
  /// Emitted when a level has been measured.
  void measured(const footfall::detail::LevelMeasures& measures);

 private:
  void measure();
  void show();

  Document& document_;
  LevelFile& file_;
  MessageBar& messages_;
  std::optional<LevelMeasures> measures_;  ///< measures of the level; empty until it is measured
  QString told_;
  LatestWork work_;  // declared last: its thread ends before the other members are destroyed
};

}  // namespace footfall::ui
