// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/text/localized_numbers.hpp"

#include <QStringList>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

#include "core/base/number_text.hpp"
#include "ui/base/namespaces.hpp"

namespace footfall::ui {
namespace {

constexpr double kLeastPlain = 1e-4, kMostPlain = 1e9;
constexpr double kMostFixed = 1e15;  // doubles have no further decimals

QString infiniteText(double value) {
  return std::isnan(value) ? QStringLiteral("–") : value > 0 ? QStringLiteral("∞") : QStringLiteral("-∞");
}

/// The number of decimals in a text of the C locale, without zeros at its end.
int decimalsOf(const QString& plain) {
  const qsizetype point = plain.indexOf(QLatin1Char('.'));
  if (point < 0) return 0;
  qsizetype end = plain.size();
  while (plain[end - 1] == QLatin1Char('0')) --end;
  return static_cast<int>(end - point - 1);
}

QString plainText(double value, int decimals, QLocale::NumberOptions options) {
  // A number that is rounded to zero has no sign.
  const QString digits = QString::number(value, 'f', decimals);
  const bool zero =
      std::ranges::none_of(digits, [](QChar c) { return c >= QLatin1Char('1') && c <= QLatin1Char('9'); });
  QLocale locale = numberLocale();
  locale.setNumberOptions(options);
  return locale.toString(zero ? 0.0 : value, 'f', decimals);
}

// Formats with an "e", which every language and parseNumber() read.
QString exponentText(double value, int digits) {
  return QString::number(value, 'g', digits).replace(QLatin1Char('.'), numberLocale().decimalPoint());
}

}  // namespace

QLocale numberLocale() {
  const QLocale locale;
  return locale.language() == QLocale::C ? QLocale(QLocale::English) : locale;
}

QString countText(std::uint64_t count) { return numberLocale().toString(static_cast<qulonglong>(count)); }

QString shortText(double value, int digits) {
  if (!std::isfinite(value)) return infiniteText(value);
  const double size = std::abs(value);
  if (size != 0 && (size < kLeastPlain || size >= kMostPlain)) return exponentText(value, digits);
  const int before = size == 0 ? 1 : static_cast<int>(std::floor(std::log10(size))) + 1;
  const int decimals = std::max(0, digits - before);
  return plainText(value, decimalsOf(QString::number(value, 'f', decimals)), QLocale::DefaultNumberOptions);
}

QString fixedText(double value, int decimals) {
  if (!std::isfinite(value)) return infiniteText(value);
  if (std::abs(value) >= kMostFixed) return exponentText(value, 6);
  return plainText(value, decimals, QLocale::DefaultNumberOptions);
}

QString measureText(double value) {
  if (!std::isfinite(value)) return infiniteText(value);
  const double size = std::fabs(value);
  if (size != 0 && (size < kLeastPlain || size >= 1e7)) return exponentText(value, 6);
  const int decimals = size >= 1000 ? 1 : size >= 10 ? 2 : size < 0.1 ? 5 : 3;
  return plainText(value, decimalsOf(QString::number(value, 'f', decimals)), QLocale::OmitGroupSeparator);
}

QString numberText(double value) {
  std::string digits;
  appendNumber(digits, value);
  return QString::fromStdString(digits).replace(QLatin1Char('.'), numberLocale().decimalPoint());
}

std::optional<double> parseNumber(const QString& text) {
  const QLocale locale = numberLocale();
  QString plain = text.trimmed();
  plain.replace(locale.decimalPoint(), QLatin1String(".")).replace(locale.negativeSign(), QLatin1String("-"));
  std::string digits = plain.toStdString();
  if (digits.size() > 1 && digits[0] == '+' && digits[1] != '-') digits.erase(0, 1);
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
  return value;
}

QString listText(const QStringList& numbers) {
  return numbers.join(numberLocale().decimalPoint() == QLatin1String(",") ? QStringLiteral("; ")
                                                                          : QStringLiteral(", "));
}

}  // namespace footfall::ui
