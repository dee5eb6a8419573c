// SPDX-License-Identifier: GPL-3.0-or-later
#include "footfall/text.hpp"

namespace footfall {

std::string Text::str() const {
  if (!isPattern_) return pattern_;
  return fillPlaces(pattern_, arguments_.size(), [this](std::size_t i) { return arguments_[i].str(); });
}

Text Text::inOneLine() const {
  Text text = *this;
  for (char& c : text.pattern_) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  }
  for (Text& argument : text.arguments_) argument = argument.inOneLine();
  return text;
}

bool Text::operator==(const Text& other) const {
  return isPattern_ == other.isPattern_ && pattern_ == other.pattern_ && arguments_ == other.arguments_;
}

}  // namespace footfall
