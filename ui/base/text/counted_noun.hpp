// Counts with their nouns.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <cstdint>

#include "ui/base/text/localized_numbers.hpp"

namespace footfall::ui {

/// A count with its noun: "1 layer", "12,345 layers".
inline QString countedText(std::uint64_t count, const QString& one, const QString& many) {
  return countText(count) + QLatin1Char(' ') + (count == 1 ? one : many);
}

}  // namespace footfall::ui
