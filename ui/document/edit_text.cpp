// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/edit_text.hpp"

#include <algorithm>

#include "core/filters/descriptor_text.hpp"
#include "footfall/filter.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/base/text/filter_text.hpp"
#include "ui/base/text/localized_numbers.hpp"
#include "ui/base/text/translated.hpp"

namespace footfall::ui {
namespace {

// A label in the middle of a sentence.
QString inside(std::string_view label) {
  QString text = filterText(label);
  const bool english = text == QString::fromUtf8(label.data(), static_cast<qsizetype>(label.size()));
  if (english && !text.isEmpty()) text[0] = text[0].toLower();  // other languages have rules of their own
  return text;
}

}  // namespace

QString labelOf(const PipelineStep& step) { return filterText(step.filter->label); }

QString valueText(const ParameterDescriptor& parameter, double value, const LevelUnits& units) {
  if (parameter.type == ParameterType::Boolean) return value != 0 ? tr("yes") : tr("no");
  const QString text = parameter.type == ParameterType::Real ? numberText(units.shown(value, parameter.unit))
                                                             : QString::fromStdString(formatValue(parameter, value));
  return parameter.unit == Unit::Degrees ? text + QStringLiteral("°") : text;
}

QString valueEditText(const DocumentState& before, const DocumentState& after, const LevelUnits& units) {
  for (const FilterEntry& now : after.filters) {
    const auto was = std::ranges::find(before.filters, now.id, &FilterEntry::id);
    if (was == before.filters.end() || was->step.filter != now.step.filter ||
        was->step.values.size() != now.step.values.size())
      continue;
    for (std::size_t i = 0; i < now.step.values.size(); ++i) {
      if (was->step.values[i] == now.step.values[i]) continue;
      const ParameterDescriptor& parameter = now.step.filter->parameterOf(i);
      return tr("Change %1 %2 → %3")
          .arg(inside(parameter.label), valueText(parameter, was->step.values[i], units),
               valueText(parameter, now.step.values[i], units));
    }
  }
  return {};
}

QString stepsText(const std::vector<PipelineStep>& steps) {
  return steps.size() == 1 ? labelOf(steps[0]) : tr("%1 filters").arg(steps.size());
}

}  // namespace footfall::ui
