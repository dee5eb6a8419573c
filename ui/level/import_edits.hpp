// Edits of the import options.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <optional>
#include <vector>

#include "ui/base/text/unit_choice.hpp"
#include "ui/document/document.hpp"
#include "ui/level/import_panel.hpp"
#include "ui/level/level_file.hpp"

namespace footfall::ui {

/// Keeps the panel, the document's options, the file and the unit of lengths consistent. An edit in the panel becomes
/// an edit of the document, and the file is read with the document's options, also after undo.
class ImportEdits : public QObject {
  Q_OBJECT

 public:
  ImportEdits(Document& document, LevelFile& file, ImportPanel& panel, UnitChoice& units);

 private:
  void edit(const ImportOptions& options);
  void showLevel();

  /// The state that a scale being typed converts from.
  struct ScaleEdit {
    QString key;  ///< merge key of the edits that are one
    Pipeline pipeline;
    std::vector<NamedAgent> agents;
    double scale = 1;
    bool guessed = true;
  };

  Document& document_;
  LevelFile& file_;
  ImportPanel& panel_;
  UnitChoice& units_;
  std::optional<ScaleEdit> scaleEdit_;
};

}  // namespace footfall::ui
