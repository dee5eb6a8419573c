// Finding by a few letters, as in "sf" for "Slope filter".
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QString>
#include <optional>

namespace footfall::ui {

struct FuzzyMatch {
  int score = 0;           ///< larger is better; 0 for an empty pattern
  QList<int> positions{};  ///< in the text, of the pattern's letters
};

/// Whether the letters of `pattern` stand in `text` in their order, whatever is between, and how well: letters that
/// begin words or follow each other count most, gaps and late beginnings cost. Upper and lower case, and blanks in the
/// pattern, make no difference. Nothing when a letter is missing. Of texts up to 200 letters; more of them are not
/// looked at.
std::optional<FuzzyMatch> fuzzyMatch(const QString& pattern, const QString& text);

}  // namespace footfall::ui
