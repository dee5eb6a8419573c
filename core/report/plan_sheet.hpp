// A drawing on paper, before it is SVG or PDF: filled areas, lines and words in millimetres.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "core/base/palette.hpp"

namespace footfall::detail {

/// Millimetres from the lower left corner of the sheet, y upwards.
struct SheetPoint {
  double x = 0, y = 0;
  bool operator==(const SheetPoint&) const = default;
};

struct SheetRectangle {
  SheetPoint lower, upper;
};

struct SheetStroke {
  Rgb colour{0, 0, 0};
  double width = 0.2;               ///< millimetres
  std::vector<double> dashes = {};  ///< lengths of marks and spaces in turn, an even number of them; empty: solid
};

/// One or several lines that are filled together by the non-zero winding rule.
struct SheetPath {
  std::vector<std::vector<SheetPoint>> lines;
  bool isClosed = false;
  std::optional<Rgb> fill = {};
  std::optional<SheetStroke> stroke = {};
};

enum class SheetAnchor { Left, Middle, Right };

struct SheetText {
  SheetPoint at;     ///< left end of the base line
  std::string text;  ///< UTF-8; PDF has the letters of Western Europe and writes others as "?"
  double size = 3;   ///< height of the letters with the space above and below
  SheetAnchor anchor = SheetAnchor::Left;
  Rgb colour{0, 0, 0};
  bool isBold = false;
  bool hasHalo = false;  ///< a white rim, to be read on lines
};

using SheetShape = std::variant<SheetPath, SheetText>;

/// One page. Later shapes lie over earlier ones.
struct Sheet {
  double width = 210, height = 297;  ///< millimetres
  std::string title;
  SheetRectangle window;            ///< window of `drawing`, which is cut off there
  std::vector<SheetShape> drawing;  ///< drawn below `frame`
  std::vector<SheetShape> frame;    ///< everything around
};

/// SVG 1.1, in millimetres; words are text in a sans-serif font. Nothing but the sheet decides the bytes.
std::string formatSheetSvg(const Sheet& sheet);

/// PDF with a page for each sheet, by libharu; words are text in Helvetica, which every reader has. No date is in it:
/// nothing but the sheets (and libharu's version) decides the bytes. Throws RunError when libharu fails, InputError
/// where the library was built without it.
std::string formatSheetsPdf(std::span<const Sheet> sheets);

}  // namespace footfall::detail
