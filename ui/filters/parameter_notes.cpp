// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/filters/parameter_notes.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "footfall/filter.hpp"
#include "ui/base/text/core_text.hpp"
#include "ui/base/text/filter_text.hpp"
#include "ui/base/text/localized_numbers.hpp"
#include "ui/document/edit_text.hpp"

namespace footfall::ui {
namespace {

/// The measures that need no look at any triangle.
LevelMeasures measureSize(const Environment& environment) {
  LevelMeasures measures;
  measures.metresPerUnit = environment.metresPerUnit;
  measures.scaleGuessed = environment.scaleGuessed;
  if (environment.vertices.empty()) return measures;
  Vec3 low = environment.vertices.front(), high = low;
  for (const Vec3& p : environment.vertices) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  measures.size = {high.x - low.x, high.y - low.y, high.z - low.z};
  return measures;
}

}  // namespace

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
  showTooSmall();
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

// The run of such a level may take long, and nothing of its result is of use.
void ParameterNotes::showTooSmall() {
  isEarly_ = false;
  const LevelMeasures measures = measureSize(*file_.environment());
  const double longest = std::max({measures.size.x, measures.size.y, measures.size.z});
  const Pipeline pipeline = document_.pipeline();
  for (const ParameterNote& note : checkParameters(measures, pipeline)) {
    const bool isOnScale = note.step && note.mend && !note.mend->value;
    if (!isOnScale || longest > pipeline.steps[*note.step].values[0]) continue;
    isEarly_ = tell(note, pipeline);
    return;
  }
}

void ParameterNotes::show() {
  if (!measures_) return;
  const Pipeline pipeline = document_.pipeline();
  const std::vector<ParameterNote> notes = checkParameters(*measures_, pipeline);
  // The measures may say more than the size did, such as another scale.
  if (std::exchange(isEarly_, false)) {
    messages_.finish(MessageSubject::Filters);
    told_.clear();
  }
  bool isFine = true;
  for (const ParameterNote& note : notes) {
    if (!note.step && !note.isOnGrid) continue;
    isFine = false;
    if (tell(note, pipeline)) return;
  }
  if (isFine) told_.clear();
}

/// Returns whether the note was shown: it is not the last one again, and no message stands.
bool ParameterNotes::tell(const ParameterNote& note, const Pipeline& pipeline) {
  const QString advice = coreText(note.text);
  const QString text = note.step ? QStringLiteral("%1: %2").arg(labelOf(pipeline.steps[*note.step]), advice) : advice;
  if (text == told_ || !messages_.text().isEmpty()) return false;
  told_ = text;
  offer(text, note, pipeline);
  messages_.setSubject(MessageSubject::Filters);
  return true;
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
