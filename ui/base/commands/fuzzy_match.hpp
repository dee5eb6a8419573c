// Fuzzy matching by a few letters: "sf" matches "Slope filter".
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QString>
#include <optional>

namespace footfall::ui {

struct FuzzyMatch {
  int score = 0;           ///< larger is better; 0 for an empty pattern
  QList<int> positions{};  ///< places in the text of the pattern's letters
};

/// Matches the letters of `pattern` in `text` in their order, with any letters between them. Letters at the beginning
/// of words or directly behind each other score most; gaps and late beginnings cost. Case and blanks in the pattern are
/// ignored. Empty when a letter is missing. Only the first 200 letters of a text are searched.
std::optional<FuzzyMatch> fuzzyMatch(const QString& pattern, const QString& text);

}  // namespace footfall::ui
