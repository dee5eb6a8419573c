// Notes on what the numbers of the filters will do to the level that is hardly meant.
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

/// Measures each level that is opened in the background, and shows a hint where the filters do not suit it, then and
/// after edits; each hint once, and none where another message stands. A scale that is a guess is asked about
/// elsewhere.
class ParameterNotes : public QObject {
  Q_OBJECT

 public:
  ParameterNotes(Document& document, LevelFile& file, MessageBar& messages, QObject* parent);

 signals:
  /// A level has been measured.
  void measured(const footfall::detail::LevelMeasures& measures);

 private:
  void measure();
  void show();

  Document& document_;
  LevelFile& file_;
  MessageBar& messages_;
  std::optional<LevelMeasures> measures_;  ///< of the level; empty until it is measured
  QString told_;
  LatestWork work_;  // last: its thread ends before the rest goes
};

}  // namespace footfall::ui
