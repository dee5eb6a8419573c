// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/environment/collada_asset.hpp"

#include <charconv>
#include <cmath>

namespace footfall {
namespace {

/// What stands between the first `open` and the `close` after it; empty when there is none.
std::string_view between(std::string_view text, std::string_view open, std::string_view close) {
  const std::size_t start = text.find(open);
  if (start == std::string_view::npos) return {};
  text.remove_prefix(start + open.size());
  const std::size_t stop = text.find(close);
  return stop == std::string_view::npos ? std::string_view{} : text.substr(0, stop);
}

}  // namespace

FileFrame readColladaAsset(std::string_view text) {
  // The document's own <asset> comes first; libraries may have further ones.
  const std::string_view asset = between(text, "<asset", "</asset>");
  FileFrame frame;
  const std::string_view axis = between(asset, "<up_axis>", "</up_axis>");
  if (axis.find("X_UP") == std::string_view::npos) {
    frame.up = axis.find("Z_UP") == std::string_view::npos ? UpAxis::Y : UpAxis::Z;
  }
  const std::string_view unit = between(asset, "<unit", ">");
  std::string_view metres = between(unit, "meter=\"", "\"");
  if (metres.empty()) metres = between(unit, "meter='", "'");
  double value = 0;
  std::from_chars(metres.data(), metres.data() + metres.size(), value);
  if (std::isfinite(value) && value > 0) frame.metresPerUnit = value;
  return frame;
}

}  // namespace footfall
