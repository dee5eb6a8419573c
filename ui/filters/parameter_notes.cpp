// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/filters/parameter_notes.hpp"

#include "ui/base/core_text.hpp"
#include "ui/document/edit_text.hpp"

namespace footfall::ui {

ParameterNotes::ParameterNotes(Document& document, LevelFile& file, MessageBar& messages, QObject* parent)
    : QObject(parent), document_(document), file_(file), messages_(messages) {
  connect(&file_, &LevelFile::opened, this, &ParameterNotes::measure);
  connect(&file_, &LevelFile::rereadDone, this, &ParameterNotes::measure);
  // The hint is shown after the window's handler, which removes messages about the filters.
  connect(&document_, &Document::filtersChanged, this, &ParameterNotes::show, Qt::QueuedConnection);
}

void ParameterNotes::measure() {
  measures_.reset();
  told_.clear();
  work_.start(
      *this, [level = file_.environment()](RunContext& context) { return measureLevel(*level, context); },
      [this](const LevelMeasures& measures) {
        measures_ = measures;
        emit measured(measures);
        show();
      },
      [](const std::exception&) {});  // there are no hints without memory
}

void ParameterNotes::show() {
  if (!measures_) return;
  const Pipeline pipeline = document_.pipeline();
  bool isFine = true;
  for (const ParameterNote& note : checkParameters(*measures_, pipeline)) {
    if (!note.step) continue;
    isFine = false;
    const QString text = QStringLiteral("%1: %2").arg(labelOf(pipeline.steps[*note.step]), coreText(note.text));
    if (text == told_ || !messages_.text().isEmpty()) continue;
    told_ = text;
    messages_.showHint(text);
    messages_.setSubject(MessageSubject::Filters);
    return;
  }
  if (isFine) told_.clear();
}

}  // namespace footfall::ui
