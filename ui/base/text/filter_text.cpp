// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/text/filter_text.hpp"

#include <QCoreApplication>

#include "core/filters/descriptor_text.hpp"
#include "footfall/filter.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/base/text/localized_numbers.hpp"

namespace footfall::ui {
namespace {

struct FilterHelp {
  Q_DECLARE_TR_FUNCTIONS(footfall::ui::FilterHelp)
};

QString escaped(std::string_view view) { return filterText(view).toHtmlEscaped(); }

QString unitName(Unit unit) {
  switch (unit) {
    case Unit::Degrees:
      return FilterHelp::tr("degrees");
    case Unit::Length:
      return FilterHelp::tr("a length in the environment's units");
    case Unit::Area:
      return FilterHelp::tr("an area in the environment's units");
    case Unit::Count:
    case Unit::None:
      break;
  }
  return {};
}

// A number in the notation of the fields.
QString valueText(const ParameterDescriptor& parameter, double value) {
  return QString::fromStdString(formatValue(parameter, value));
}

QString rangeText(const ParameterDescriptor& parameter) {
  if (parameter.type == ParameterType::Boolean) return FilterHelp::tr("on or off");
  const bool whole = parameter.type == ParameterType::Integer;
  const QString low = valueText(parameter, parameter.minimum);
  QString text;
  if (parameter.minimumOpen) {
    text = whole ? FilterHelp::tr("a whole number above %1") : FilterHelp::tr("a number above %1");
  } else {
    text = whole ? FilterHelp::tr("a whole number from %1") : FilterHelp::tr("a number from %1");
  }
  text = text.arg(low);
  // Limits at the end of the type's range have no meaning for users.
  if (parameter.maximum < 1e9) {
    const QString high = valueText(parameter, parameter.maximum);
    text +=
        QLatin1Char(' ') + (parameter.maximumOpen ? FilterHelp::tr("to below %1") : FilterHelp::tr("to %1")).arg(high);
  }
  const QString unit = unitName(parameter.unit);
  return unit.isEmpty() ? text : QStringLiteral("%1 (%2)").arg(text, unit);
}

QString defaultText(const ParameterDescriptor& parameter) {
  if (parameter.type == ParameterType::Boolean)
    return parameter.defaultValue != 0 ? FilterHelp::tr("on") : FilterHelp::tr("off");
  QString text = valueText(parameter, parameter.defaultValue);
  if (parameter.defaultValue != 0 && parameter.unit == Unit::Length) text += QStringLiteral(" m");
  if (parameter.defaultValue != 0 && parameter.unit == Unit::Area) text += QStringLiteral(" m²");
  return text;
}

QString section(const QString& title, const QString& text) {
  return text.isEmpty() ? QString() : QStringLiteral("<p><b>%1</b><br>%2</p>").arg(title, text);
}

}  // namespace

QString filterText(std::string_view text) {
  // Translators see these texts under one heading.
  return QCoreApplication::translate("Filter", std::string(text).c_str());
}

QString filterName(std::string_view name) {
  const FilterDescriptor* filter = findFilter(name);
  return filter ? filterText(filter->label) : QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size()));
}

QString strategyText(std::string_view line) {
  const QString whole = QString::fromUtf8(line.data(), static_cast<qsizetype>(line.size()));
  const FilterDescriptor* filter = findFilter(line.substr(0, line.find(' ')));
  if (!filter) return whole;
  // Words ("false") have no meaning without the label of their value.
  QStringList numbers;
  for (const QString& value : whole.split(QLatin1Char(' ')).mid(1)) {
    bool isNumber = false;
    const double number = value.toDouble(&isNumber);
    if (isNumber) numbers << numberText(number);
  }
  const QString label = filterText(filter->label);
  return numbers.isEmpty() ? label : label + QLatin1Char(' ') + numbers.join(QStringLiteral(" · "));
}

QString filterHelp(const FilterDescriptor& filter, int emphasised) {
  QString text = QStringLiteral("<h3>%1</h3><p>%2</p>").arg(escaped(filter.label), escaped(filter.help));
  for (std::size_t i = 0; i < filter.parameters.size(); ++i) {
    const ParameterDescriptor& parameter = filter.parameters[i];
    const QString body =
        QStringLiteral("%1<br>%2")
            .arg(escaped(parameter.help),
                 filter.repeats > 0
                     ? FilterHelp::tr("Takes %1.").arg(rangeText(parameter))
                     : FilterHelp::tr("Takes %1. Default: %2.").arg(rangeText(parameter), defaultText(parameter)));
    const bool marked = static_cast<int>(i) == emphasised;
    text += QStringLiteral("<p><a name='parameter%1'></a><b>%2%3</b><br>%4</p>")
                .arg(i)
                .arg(marked ? QStringLiteral("▶ ") : QString(), escaped(parameter.label), body);
  }
  text += section(FilterHelp::tr("Needs"), escaped(filter.precondition));
  text += section(FilterHelp::tr("Effect"), escaped(filter.effect));
  QString scope = FilterHelp::tr("Partitioning");
  if (filter.kind == FilterKind::Filter) {
    scope = filter.scope == Scope::Local ? FilterHelp::tr("Local: may stand inside a parallel block")
                                         : FilterHelp::tr("Global: may not stand inside a parallel block");
  }
  text += section(FilterHelp::tr("Where"), scope);
  text += section(FilterHelp::tr("In pipeline files"),
                  QStringLiteral("<code>%1</code>").arg(QString::fromStdString(describeUsage(filter)).toHtmlEscaped()));
  return text + section(FilterHelp::tr("Source"), escaped(filter.source));
}

}  // namespace footfall::ui
