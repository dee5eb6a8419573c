// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/filters/parameter_notes.hpp"

#include <algorithm>

#include "footfall/filter.hpp"
#include "ui/base/core_text.hpp"
#include "ui/base/filter_text.hpp"
#include "ui/base/localized_numbers.hpp"
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
        emit settled();
      },
      [this](const std::exception&) { emit settled(); });  // there are no hints without memory
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
    offer(text, note, pipeline);
    messages_.setSubject(MessageSubject::Filters);
    return;
  }
  if (isFine) told_.clear();
}

// One click does what the note advises.
void ParameterNotes::offer(const QString& text, const ParameterNote& note, const Pipeline& pipeline) {
  if (!note.mend) return messages_.showHint(text);
  const double to = note.mend->to;
  if (!note.mend->value)
    return messages_.showHint(text, tr("Set the scale to %1").arg(shortText(to, 6)),
                              [this, to] { emit scaleChosen(to); });
  const std::size_t step = *note.step, value = *note.mend->value;
  const ParameterDescriptor& parameter = pipeline.steps[step].filter->parameters[value];
  messages_.showHint(text, tr("Set %1 to %2").arg(filterText(parameter.label), shortText(to, 6)),
                     [this, id = document_.filters()[step].id, value, to] { setValue(id, value, to); });
}

// The row may be gone when the button is clicked.
void ParameterNotes::setValue(int id, std::size_t value, double to) {
  const auto& filters = document_.filters();
  if (std::ranges::find(filters, id, &FilterEntry::id) != filters.end()) document_.setValue(id, value, to, -1);
}

}  // namespace footfall::ui
