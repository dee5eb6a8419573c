// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/collada_asset.hpp"

#include <charconv>
#include <cmath>

namespace footfall::detail {
namespace {

/// The text between the first `open` and the `close` after it; empty when there is none.
std::string_view between(std::string_view text, std::string_view open, std::string_view close) {
  const std::size_t start = text.find(open);
  if (start == std::string_view::npos) return {};
  text.remove_prefix(start + open.size());
  const std::size_t stop = text.find(close);
  return stop == std::string_view::npos ? std::string_view{} : text.substr(0, stop);
}

}  // namespace

ColladaAsset readColladaAsset(std::string_view text) {
  const std::string_view asset = between(text, "<asset", "</asset>");
  ColladaAsset result;
  const std::string_view axis = between(asset, "<up_axis>", "</up_axis>");
  const std::size_t letter = axis.find("_UP");
  if (letter != std::string_view::npos && letter > 0 && (axis[letter - 1] == 'X' || axis[letter - 1] == 'Z')) {
    result.upAxis = axis[letter - 1];
  }
  const std::string_view unit = between(asset, "<unit", ">");
  std::string_view metres = between(unit, "meter=\"", "\"");
  if (metres.empty()) metres = between(unit, "meter='", "'");
  double value = 0;
  std::from_chars(metres.data(), metres.data() + metres.size(), value);
  if (std::isfinite(value) && value > 0) result.metresPerUnit = value;
  return result;
}

}  // namespace footfall::detail
