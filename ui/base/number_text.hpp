// Numbers as the editor shows and reads them: short, and in the notation of its language.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLocale>
#include <QString>
#include <cstdint>
#include <optional>

namespace footfall::ui {

/// The language's notation of numbers; English where the machine has none (the locale "C" knows no groups).
QLocale numberLocale();

/// A count in groups of thousands: "12,345".
QString countText(std::uint64_t count);

/// At most `digits` digits that count, without zeros at the end: "0.05", "2.5", "1,234.5". An exponent follows what is
/// below 1e-4 or from 1e9 on, so that no number is long; a zero has no sign.
QString shortText(double value, int digits = 6);

/// With so many decimals: "2.50", never "-0.00"; with an exponent from 1e15 on.
QString fixedText(double value, int decimals);

/// A length or a coordinate of a level for people, up to six digits without groups, such as parseNumber() reads.
QString measureText(double value);

/// Every digit: the shortest text that parseNumber() reads back to the same number, without groups.
QString numberText(double value);

/// A number as typed: decimals with a point or with the language's mark, exponents allowed, without groups; or nothing.
std::optional<double> parseNumber(const QString& text);

/// The parts of a list of numbers side by side; with a semicolon where a comma is the decimal mark.
QString listText(const QStringList& numbers);

}  // namespace footfall::ui
