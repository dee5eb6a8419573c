// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/text/core_text.hpp"

#include <QCoreApplication>
#include <string>
#include <string_view>

#include "footfall/errors.hpp"
#include "ui/base/text/filter_text.hpp"
#include "ui/base/text/localized_numbers.hpp"

namespace footfall::ui {
namespace {

// The pattern of a place in a text file; the text behind it uses the words of that file.
constexpr std::string_view kFilePlace = "%1:%2:%3: %4";

// A number as the core writes it: digits with a point among them.
bool isDecimal(std::string_view text) {
  if (text.starts_with('-')) text.remove_prefix(1);
  const std::size_t point = text.find('.');
  if (point == 0 || point == std::string_view::npos || point + 1 == text.size()) return false;
  text.remove_prefix(text.find_first_not_of("0123456789") == point ? point + 1 : 0);
  return text.find_first_not_of("0123456789") == std::string_view::npos;
}

// Files and the command line use the names of filters, with or without values, and decimal points; the editor shows
// their labels, and numbers in the user's language.
std::string argumentText(const Text& text, bool hasLabels) {
  if (!hasLabels) return text.pattern();
  if (!isDecimal(text.pattern())) return strategyText(text.pattern()).toStdString();
  return QString::fromStdString(text.pattern()).replace(QLatin1Char('.'), numberLocale().decimalPoint()).toStdString();
}

std::string translated(const Text& text, bool hasLabels = true) {
  if (text.isCount()) return countText(std::stoull(text.pattern())).toStdString();
  if (!text.isPattern()) return text.pattern();
  const char* const english = text.pattern().c_str();
  QString own = QCoreApplication::translate("Core", english);
  if (own == QLatin1String(english)) own = QCoreApplication::translate("Filter", english);  // labels of filters
  const std::string pattern = own.toStdString();
  if (text.pattern() == kFilePlace) hasLabels = false;
  return fillPlaces(pattern, text.arguments().size(), [&](std::size_t i) {
    const Text& argument = text.arguments()[i];
    return argument.isPattern() || argument.isCount() ? translated(argument, hasLabels)
                                                      : argumentText(argument, hasLabels);
  });
}

}  // namespace

QString coreText(const Text& text) { return QString::fromStdString(translated(text)); }

QString coreText(const std::exception& error) {
  const auto* own = dynamic_cast<const TextError*>(&error);
  return own ? coreText(own->text()) : QString::fromUtf8(error.what());
}

}  // namespace footfall::ui
