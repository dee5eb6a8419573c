// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/commands/fuzzy_match.hpp"

#include <algorithm>
#include <limits>
#include <vector>

namespace footfall::ui {
namespace {

constexpr int kLongest = 200;
constexpr int kLetter = 8;      // for each matched letter
constexpr int kWordStart = 10;  // more at the beginning of a word
constexpr int kFollows = 12;    // more directly behind the previous match
constexpr int kGap = 1;         // less for each letter in between
constexpr int kNone = std::numeric_limits<int>::min() / 2;

bool beginsWord(const QString& text, int at) {
  if (at == 0) return true;
  const QChar before = text[at - 1];
  return !before.isLetterOrNumber() || (before.isLower() && text[at].isUpper());
}

}  // namespace

// Finds the best of all ways to place the letters, letter by letter: best[i][j] is the best score of the first i + 1
// letters with the last of them at j.
std::optional<FuzzyMatch> fuzzyMatch(const QString& pattern, const QString& text) {
  QString letters;
  for (const QChar c : pattern.toCaseFolded()) {
    if (!c.isSpace()) letters += c;
  }
  const QString folded = text.left(kLongest).toCaseFolded();
  const auto count = static_cast<int>(letters.size());
  const auto length = static_cast<int>(std::min(folded.size(), text.size()));
  if (count == 0) return FuzzyMatch{};
  if (count > length) return std::nullopt;
  const auto places = static_cast<std::size_t>(count) * static_cast<std::size_t>(length);
  std::vector<int> best(places, kNone), from(places, -1);
  const auto placeOf = [length](int i, int j) { return static_cast<std::size_t>(i * length + j); };
  for (int i = 0; i < count; ++i) {
    int before = kNone;  // the best score that ends before j, gaps up to j included
    int beforeAt = -1;
    for (int j = 0; j < length; ++j) {
      if (i > 0 && j > 0) {
        before -= kGap;
        if (best[placeOf(i - 1, j - 1)] > before) {
          before = best[placeOf(i - 1, j - 1)];
          beforeAt = j - 1;
        }
      }
      if (folded[j] != letters[i]) continue;
      const int letter = kLetter + (beginsWord(text, j) ? kWordStart : 0);
      int& score = best[placeOf(i, j)];
      if (i == 0) {
        score = letter - std::min(j, 2 * kLetter) * kGap;
        continue;
      }
      if (before > kNone / 2) {
        score = before + letter;
        from[placeOf(i, j)] = beforeAt;
      }
      if (j > 0 && best[placeOf(i - 1, j - 1)] > kNone / 2 && best[placeOf(i - 1, j - 1)] + letter + kFollows > score) {
        score = best[placeOf(i - 1, j - 1)] + letter + kFollows;
        from[placeOf(i, j)] = j - 1;
      }
    }
  }
  int end = -1;
  for (int j = 0; j < length; ++j) {
    if (best[placeOf(count - 1, j)] > kNone / 2 &&
        (end < 0 || best[placeOf(count - 1, j)] > best[placeOf(count - 1, end)]))
      end = j;
  }
  if (end < 0) return std::nullopt;
  FuzzyMatch match;
  // The shorter of two texts matches better at the same places.
  match.score = std::max(1, 4 * best[placeOf(count - 1, end)] - length / 8);
  for (int i = count - 1, j = end; i >= 0; --i) {
    match.positions.prepend(j);
    j = from[placeOf(i, j)];
  }
  return match;
}

}  // namespace footfall::ui
