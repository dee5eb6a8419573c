// Formats and parses the editor's numbers, in the notation of the user's language.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLocale>
#include <QString>
#include <cstdint>
#include <optional>

namespace footfall::ui {

/// The number format of the user's language; English where the machine has none (the locale "C" has no groups).
QLocale numberLocale();

/// A count in groups of thousands: "12,345".
QString countText(std::uint64_t count);

/// A number with at most `digits` significant digits, without zeros at the end: "0.05", "2.5", "1,234.5". Numbers below
/// 1e-4 or from 1e9 on have an exponent, so that no text is long; a zero has no sign.
QString shortText(double value, int digits = 6);

/// A number with this many decimals: "2.50", never "-0.00"; with an exponent from 1e15 on.
QString fixedText(double value, int decimals);

/// A length or a coordinate of a level for people, with up to six digits and without groups; parseNumber() reads it.
QString measureText(double value);

/// All digits of a number: the shortest text that parseNumber() reads back to the same number, without groups.
QString numberText(double value);

/// Parses a typed number: decimals with a point or with the language's mark, exponents allowed, without groups. Empty
/// for other texts.
std::optional<double> parseNumber(const QString& text);

/// Joins the parts of a list of numbers; the separator is a semicolon where a comma is the decimal mark.
QString listText(const QStringList& numbers);

}  // namespace footfall::ui
