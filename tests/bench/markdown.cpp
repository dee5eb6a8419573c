// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/markdown.hpp"

#include <array>
#include <cmath>
#include <cstdio>

namespace footfall::bench {

std::string grouped(double value) {
  std::string digits = std::to_string(std::llround(value));
  for (std::size_t from = digits.size(); from > 3 + (digits[0] == '-' ? 1U : 0U);) digits.insert(from -= 3, 1, ',');
  return digits;
}

std::string number(double value) {
  if (std::abs(value) >= 99.95) return grouped(value);
  std::array<char, 32> text;
  const int decimals = std::abs(value) >= 9.995 ? 1 : std::abs(value) >= 0.0995 || value == 0 ? 2 : 3;
  std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
  return text.data();
}

std::string groupedWithDecimals(double value, int decimals) {
  std::array<char, 64> text;
  std::snprintf(text.data(), text.size(), "%.*f", decimals, std::abs(value));
  const std::string digits = text.data();
  const std::size_t point = digits.find('.');
  const bool isNegative = value < 0 && digits.find_first_not_of("0.") != std::string::npos;
  return (isNegative ? "-" : "") + grouped(std::stod(digits.substr(0, point))) +
         (point == std::string::npos ? "" : digits.substr(point));
}

std::string megabytes(const Json& bytes) { return number(bytes.get<double>() / 1e6); }

std::string threadText(int threads) { return std::to_string(threads) + (threads == 1 ? " thread" : " threads"); }

Table::Table(const std::vector<std::string>& header, std::size_t leftColumns) {
  addRow(header);
  text_ += '|';
  for (std::size_t i = 0; i < header.size(); ++i) text_ += i < leftColumns ? "---|" : "---:|";
  text_ += '\n';
}

void Table::addRow(const std::vector<std::string>& cells) {
  text_ += '|';
  for (const std::string& cell : cells) text_ += ' ' + cell + " |";
  text_ += '\n';
}

}  // namespace footfall::bench
