// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/distance_picture.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <limits>

#include "core/base/counted_text.hpp"
#include "footfall/errors.hpp"

namespace footfall::detail {
namespace {

constexpr double kWidth = 297, kHeight = 210, kMargin = 12;       // A4, millimetres
constexpr double kHead = 14, kFoot = 26;                          // above and below the drawing
constexpr double kBarWidth = 150, kBarHeight = 6, kBarBase = 22;  // the legend's scale
constexpr double kLetters = 3.2;
constexpr double kSeam = 0.05;  // drawn around pieces, so that no reader shows white lines between them

constexpr Rgb kInk{40, 40, 40};

/// Places of the plan on the paper.
struct Fit {
  SheetRectangle window;
  double middleX = 0, middleY = 0, unit = 1;

  [[nodiscard]] SheetPoint at(const Vec3& p) const {
    return {(window.lower.x + window.upper.x) / 2 + (p.x - middleX) * unit,
            (window.lower.y + window.upper.y) / 2 + (p.y - middleY) * unit};
  }
};

Fit fitTo(const DistanceBands& bands, const SheetRectangle& window) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  double x0 = kFar, x1 = -kFar, y0 = kFar, y1 = -kFar;
  for (const auto& band : bands.triangles)
    for (const DistanceBands::Corners& corners : band)
      for (const Vec3& p : corners) {
        x0 = std::min(x0, p.x), x1 = std::max(x1, p.x);
        y0 = std::min(y0, p.y), y1 = std::max(y1, p.y);
      }
  const double width = window.upper.x - window.lower.x, height = window.upper.y - window.lower.y;
  const double across = x1 / width - x0 / width, up = y1 / height - y0 / height;
  const double larger = std::max(across, up);
  return {window, x0 / 2 + x1 / 2, y0 / 2 + y1 / 2, larger > 0 ? 1 / larger : 1};
}

void addText(std::vector<SheetShape>& shapes, const SheetPoint& at, std::string text,
             SheetAnchor anchor = SheetAnchor::Left, bool isBold = false) {
  SheetText words{at, std::move(text)};
  words.size = kLetters;
  words.anchor = anchor;
  words.colour = kInk;
  words.isBold = isBold;
  shapes.emplace_back(std::move(words));
}

void addLine(std::vector<SheetShape>& shapes, const SheetPoint& a, const SheetPoint& b) {
  SheetPath line;
  line.lines = {{a, b}};
  line.stroke = SheetStroke{kInk, 0.3};
  shapes.emplace_back(std::move(line));
}

void addRectangle(std::vector<SheetShape>& shapes, const SheetPoint& a, const SheetPoint& b, const Rgb& fill) {
  SheetPath box;
  box.lines = {{a, {b.x, a.y}, b, {a.x, b.y}}};
  box.isClosed = true;
  box.fill = fill;
  shapes.emplace_back(std::move(box));
}

void addBand(std::vector<SheetShape>& shapes, const std::vector<DistanceBands::Corners>& triangles, const Rgb& colour,
             const Fit& fit) {
  if (triangles.empty()) return;
  SheetPath path;
  for (const DistanceBands::Corners& c : triangles) path.lines.push_back({fit.at(c[0]), fit.at(c[1]), fit.at(c[2])});
  path.isClosed = true;
  path.fill = colour;
  path.stroke = SheetStroke{colour, kSeam};
  shapes.emplace_back(std::move(path));
}

/// A cross where the distance is largest.
void addFarthest(std::vector<SheetShape>& shapes, const DistanceBands& bands, const Fit& fit) {
  if (bands.largest == 0) return;
  const SheetPoint p = fit.at(bands.farthest);
  constexpr double kArm = 2.5;
  addLine(shapes, {p.x - kArm, p.y}, {p.x + kArm, p.y});
  addLine(shapes, {p.x, p.y - kArm}, {p.x, p.y + kArm});
}

/// The ending of a file's name, in lower case and with its dot.
std::string endingOf(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return ending;
}

std::string distanceText(double value) { return formatted(value, "%.4g"); }

void addScale(std::vector<SheetShape>& shapes, const DistanceBands& bands) {
  constexpr auto kCount = DistanceBands::kCount;
  const double step = kBarWidth / static_cast<double>(kCount);
  for (std::size_t band = 0; band < kCount; ++band) {
    const double x = kMargin + static_cast<double>(band) * step;
    addRectangle(shapes, {x, kBarBase - kBarHeight}, {x + step, kBarBase}, colourOfBand(band));
  }
  constexpr int kParts = 4;
  for (int part = 0; part <= kParts; ++part) {
    const double x = kMargin + kBarWidth * part / kParts;
    addLine(shapes, {x, kBarBase - kBarHeight - 1}, {x, kBarBase - kBarHeight});
    const SheetAnchor anchor = part == 0        ? SheetAnchor::Left
                               : part == kParts ? SheetAnchor::Right
                                                : SheetAnchor::Middle;
    addText(shapes, {x, kBarBase - kBarHeight - 1.5 - kLetters}, distanceText(bands.largest * part / kParts), anchor);
  }
}

void addFigures(std::vector<SheetShape>& shapes, const DistanceBands& bands) {
  constexpr double kLeft = kMargin + kBarWidth + 10, kLineHeight = 1.4 * kLetters;
  const std::array<std::string, 3> lines{
      "d_max " + distanceText(bands.largest) + ", d_mean " + distanceText(bands.mean) + ", d_rms " +
          distanceText(bands.rms) + " (units of the files)",
      "taken at " + counted(bands.samples, "vertex", "vertices") + " of A; the cross is at d_max",
      bands.leftOut == 0 ? "larger distances are drawn over smaller ones"
                         : counted(bands.leftOut, "triangle", "triangles") + " with the smallest distances left out"};
  double y = kBarBase - kLetters;
  for (const std::string& line : lines) {
    addText(shapes, {kLeft, y}, line);
    y -= kLineHeight;
  }
}

}  // namespace

Sheet drawDistances(const DistanceBands& bands, const std::array<std::string, 2>& names) {
  Sheet sheet;
  sheet.width = kWidth;
  sheet.height = kHeight;
  sheet.title = "Distance from " + names[0] + " to " + names[1];
  sheet.window = {{kMargin, kFoot}, {kWidth - kMargin, kHeight - kHead}};
  const Fit fit = fitTo(bands, sheet.window);
  for (std::size_t band = 0; band < DistanceBands::kCount; ++band)
    addBand(sheet.drawing, bands.triangles[band], colourOfBand(band), fit);
  addFarthest(sheet.drawing, bands, fit);
  addText(sheet.frame, {kMargin, kHeight - kHead + kLetters}, "Distance from A, " + names[0] + ", to B, " + names[1],
          SheetAnchor::Left, true);
  addScale(sheet.frame, bands);
  addFigures(sheet.frame, bands);
  return sheet;
}

void checkPictureName(const std::string& path) {
  const std::string ending = endingOf(path);
  if (ending != ".svg" && ending != ".pdf")
    throw InputError("--picture " + path + ": no name of a picture; give one that ends in .svg or .pdf");
}

std::string formatDistancePicture(const std::string& path, const DistanceBands& bands,
                                  const std::array<std::string, 2>& files) {
  checkPictureName(path);
  const auto nameOf = [](const std::string& file) { return std::filesystem::path(file).filename().string(); };
  const Sheet sheet = drawDistances(bands, {nameOf(files[0]), nameOf(files[1])});
  return endingOf(path) == ".pdf" ? formatSheetsPdf({&sheet, 1}) : formatSheetSvg(sheet);
}

}  // namespace footfall::detail
