// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/core_text.hpp"

#include <QCoreApplication>
#include <string>
#include <string_view>

#include "footfall/errors.hpp"
#include "ui/base/filter_text.hpp"
#include "ui/base/localized_numbers.hpp"

namespace footfall::ui {
namespace {

// The pattern of a place in a text file; the text behind it uses the words of that file.
constexpr std::string_view kFilePlace = "%1:%2:%3: %4";

// Files and the command line use the names of filters, with or without values; the editor shows their labels.
std::string argumentText(const Text& text, bool hasLabels) {
  return hasLabels ? strategyText(text.pattern()).toStdString() : std::string(text.pattern());
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
