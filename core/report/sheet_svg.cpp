// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "core/base/number_text.hpp"
#include "core/report/html_report.hpp"
#include "core/report/plan_sheet.hpp"

namespace footfall::detail {
namespace {

constexpr double kHalo = 0.5;

/// Formats millimetres to a thousandth; smaller differences are invisible.
std::string number(double value) {
  std::string text;
  appendNumber(text, std::round(value * 1000) / 1000);
  return text;
}

std::string colourText(const Rgb& colour) {
  std::string text = "#";
  for (const int part : colour)
    for (const int digit : {part / 16, part % 16}) text += "0123456789abcdef"[digit];
  return text;
}

class SvgWriter {
 public:
  explicit SvgWriter(const Sheet& sheet) : sheet_(sheet) {}

  std::string write() {
    const auto& [lower, upper] = sheet_.window;
    const std::string width = number(sheet_.width), height = number(sheet_.height);
    text_ = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width +
            "mm\" height=\"" + height + "mm\" viewBox=\"0 0 " + width + ' ' + height +
            "\" font-family=\"Helvetica, Arial, sans-serif\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n" +
            "<title>" + escapeHtml(sheet_.title) + "</title>\n<clipPath id=\"window\"><rect x=\"" + number(lower.x) +
            "\" y=\"" + number(sheet_.height - upper.y) + "\" width=\"" + number(upper.x - lower.x) + "\" height=\"" +
            number(upper.y - lower.y) + "\"/></clipPath>\n<rect width=\"" + width + "\" height=\"" + height +
            "\" fill=\"#ffffff\"/>\n<g clip-path=\"url(#window)\">\n";
    for (const SheetShape& shape : sheet_.drawing) add(shape);
    text_ += "</g>\n";
    for (const SheetShape& shape : sheet_.frame) add(shape);
    text_ += "</svg>\n";
    return std::move(text_);
  }

 private:
  [[nodiscard]] std::string place(const SheetPoint& p) const { return number(p.x) + ' ' + number(sheet_.height - p.y); }

  void add(const SheetShape& shape) {
    if (const auto* path = std::get_if<SheetPath>(&shape))
      addPath(*path);
    else
      addText(std::get<SheetText>(shape));
  }

  void addPath(const SheetPath& path) {
    if (path.lines.empty()) return;
    text_ += "<path d=\"";
    for (const std::vector<SheetPoint>& line : path.lines) {
      for (std::size_t i = 0; i < line.size(); ++i) {
        text_ += i == 0 ? 'M' : 'L';
        text_ += place(line[i]);
      }
      if (path.isClosed) text_ += 'Z';
    }
    text_ += "\" fill=\"" + (path.fill ? colourText(*path.fill) : std::string("none")) + '"';
    if (path.stroke) {
      text_ += " stroke=\"" + colourText(path.stroke->colour) + "\" stroke-width=\"" + number(path.stroke->width) + '"';
      std::string dashes;
      for (const double dash : path.stroke->dashes) dashes.append(number(dash)).append(" ");
      if (!dashes.empty()) dashes.pop_back();
      if (!dashes.empty()) text_ += " stroke-dasharray=\"" + dashes + "\" stroke-linecap=\"butt\"";
    }
    text_ += "/>\n";
  }

  void addText(const SheetText& text) {
    std::string start = "<text x=\"" + number(text.at.x) + "\" y=\"" + number(sheet_.height - text.at.y) +
                        "\" font-size=\"" + number(text.size) + '"';
    if (text.anchor != SheetAnchor::Left)
      start += text.anchor == SheetAnchor::Middle ? " text-anchor=\"middle\"" : " text-anchor=\"end\"";
    if (text.isBold) start += " font-weight=\"bold\"";
    const std::string words = " fill=\"" + colourText(text.colour) + "\">" + escapeHtml(text.text) + "</text>\n";
    // Drawn twice, because not every reader paints a rim first.
    if (text.hasHalo) text_ += start + " stroke=\"#ffffff\" stroke-width=\"" + number(kHalo) + '"' + words;
    text_ += start + words;
  }

  const Sheet& sheet_;
  std::string text_;
};

}  // namespace

std::string formatSheetSvg(const Sheet& sheet) { return SvgWriter(sheet).write(); }

}  // namespace footfall::detail
