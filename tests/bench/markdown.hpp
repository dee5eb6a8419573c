// Numbers and tables in Markdown.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "tests/bench/isolated.hpp"

namespace footfall::bench {

/// A whole number, its thousands grouped: "1,234".
std::string grouped(double value);

/// Two or three significant digits, and whole numbers from 100 on.
std::string number(double value);

/// "1,234.500" with three decimals.
std::string groupedWithDecimals(double value, int decimals);

std::string megabytes(const Json& bytes);

/// "1 thread", "2 threads".
std::string threadText(int threads);

/// The first columns are aligned left, the others right.
class Table {
 public:
  explicit Table(const std::vector<std::string>& header, std::size_t leftColumns = 1);
  void addRow(const std::vector<std::string>& cells);
  /// Returns the text with an empty line behind it.
  [[nodiscard]] std::string text() const { return text_ + '\n'; }

 private:
  std::string text_;
};

}  // namespace footfall::bench
