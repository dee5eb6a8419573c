// SPDX-License-Identifier: GPL-3.0-or-later
#include <hpdf.h>

#include <algorithm>
#include <array>

#include "core/report/plan_sheet.hpp"
#include "footfall/errors.hpp"
#include "footfall/version.hpp"

namespace footfall::detail {
namespace {

constexpr double kPoint = 72 / 25.4;  // points in a millimetre
constexpr double kHalo = 0.5;

HPDF_REAL points(double millimetres) { return static_cast<HPDF_REAL>(millimetres * kPoint); }

/// Letters of Latin-1, which PDF's standard fonts have; "?" for others.
std::string inLatin1(const std::string& utf8) {
  std::string text;
  for (std::size_t i = 0; i < utf8.size(); ++i) {
    const auto byte = static_cast<unsigned char>(utf8[i]);
    if (byte < 0x80) {
      text += byte < 0x20 ? ' ' : utf8[i];
      continue;
    }
    const auto following = i + 1 < utf8.size() ? static_cast<unsigned char>(utf8[i + 1]) : 0U;
    if ((byte == 0xC2 || byte == 0xC3) && following >= 0xA0U - (byte == 0xC3 ? 0x20U : 0U) && following < 0xC0U) {
      text += static_cast<char>((byte == 0xC3 ? 0x40U : 0U) + following);
      ++i;
    } else if ((byte & 0xC0U) != 0x80U) {
      text += '?';
    }
  }
  return text;
}

/// A document that frees itself. libharu keeps its first error and ignores later calls.
class PdfDocument {
 public:
  PdfDocument() : document_(HPDF_New(nullptr, nullptr)) {
    if (document_ == nullptr) throw RunError(FOOTFALL_TEXT("the PDF file cannot be made: not enough memory"));
    HPDF_SetCompressionMode(document_, HPDF_COMP_TEXT);
    plain_ = HPDF_GetFont(document_, "Helvetica", "WinAnsiEncoding");
    bold_ = HPDF_GetFont(document_, "Helvetica-Bold", "WinAnsiEncoding");
    check();
  }
  ~PdfDocument() { HPDF_Free(document_); }
  PdfDocument(const PdfDocument&) = delete;
  PdfDocument& operator=(const PdfDocument&) = delete;

  void setTitle(const std::string& title) {
    HPDF_SetInfoAttr(document_, HPDF_INFO_TITLE, inLatin1(title).c_str());
    HPDF_SetInfoAttr(document_, HPDF_INFO_CREATOR, (std::string("Footfall ") + FOOTFALL_VERSION).c_str());
  }

  void addPage(const Sheet& sheet) {
    page_ = HPDF_AddPage(document_);
    check();
    HPDF_Page_SetWidth(page_, points(sheet.width));
    HPDF_Page_SetHeight(page_, points(sheet.height));
    HPDF_Page_SetLineJoin(page_, HPDF_ROUND_JOIN);
    HPDF_Page_GSave(page_);
    const auto& [lower, upper] = sheet.window;
    HPDF_Page_Rectangle(page_, points(lower.x), points(lower.y), points(upper.x - lower.x), points(upper.y - lower.y));
    HPDF_Page_Clip(page_);
    HPDF_Page_EndPath(page_);
    for (const SheetShape& shape : sheet.drawing) add(shape);
    HPDF_Page_GRestore(page_);
    for (const SheetShape& shape : sheet.frame) add(shape);
    check();
  }

  [[nodiscard]] std::string bytes() const {
    HPDF_SaveToStream(document_);
    check();
    std::string bytes;
    std::array<HPDF_BYTE, 1 << 14> block;
    for (HPDF_UINT32 count = block.size(); count == block.size();) {
      if (HPDF_ReadFromStream(document_, block.data(), &count) == HPDF_STREAM_EOF && count == 0) break;
      bytes.append(block.begin(), block.begin() + count);
    }
    return bytes;
  }

 private:
  void check() const {
    if (HPDF_GetError(document_) != HPDF_OK)
      throw RunError(FOOTFALL_TEXT("the PDF file cannot be made: error %1 of libharu"), HPDF_GetError(document_));
  }

  void add(const SheetShape& shape) {
    if (const auto* path = std::get_if<SheetPath>(&shape))
      addPath(*path);
    else
      addText(std::get<SheetText>(shape));
  }

  void setStroke(const Rgb& colour, double width) {
    HPDF_Page_SetRGBStroke(page_, part(colour[0]), part(colour[1]), part(colour[2]));
    HPDF_Page_SetLineWidth(page_, points(width));
  }
  void setFill(const Rgb& colour) { HPDF_Page_SetRGBFill(page_, part(colour[0]), part(colour[1]), part(colour[2])); }
  static HPDF_REAL part(int value) { return static_cast<HPDF_REAL>(value) / 255.0F; }

  void setDashes(const std::vector<double>& dashes) {
    std::array<HPDF_UINT16, 4> lengths{};
    // This version of libharu accepts whole points only.
    const std::size_t count = std::min(dashes.size(), lengths.size());
    for (std::size_t i = 0; i < count; ++i) lengths[i] = static_cast<HPDF_UINT16>(std::max(1.0, dashes[i] * kPoint));
    HPDF_Page_SetDash(page_, count > 0 ? lengths.data() : nullptr, static_cast<HPDF_UINT>(count), 0);
    HPDF_Page_SetLineCap(page_, count > 0 ? HPDF_BUTT_END : HPDF_ROUND_END);
  }

  void addPath(const SheetPath& path) {
    if (path.lines.empty() || (!path.fill && !path.stroke)) return;
    if (path.fill) setFill(*path.fill);
    if (path.stroke) {
      setStroke(path.stroke->colour, path.stroke->width);
      setDashes(path.stroke->dashes);
    }
    for (const std::vector<SheetPoint>& line : path.lines) {
      for (std::size_t i = 0; i < line.size(); ++i)
        (i == 0 ? HPDF_Page_MoveTo : HPDF_Page_LineTo)(page_, points(line[i].x), points(line[i].y));
      if (path.isClosed) HPDF_Page_ClosePath(page_);
    }
    (!path.stroke ? HPDF_Page_Fill : path.fill ? HPDF_Page_FillStroke : HPDF_Page_Stroke)(page_);
  }

  void addText(const SheetText& text) {
    const std::string words = inLatin1(text.text);
    HPDF_Page_SetFontAndSize(page_, text.isBold ? bold_ : plain_, points(text.size));
    const HPDF_REAL width = HPDF_Page_TextWidth(page_, words.c_str());
    const HPDF_REAL x = points(text.at.x) - (text.anchor == SheetAnchor::Left     ? 0.0F
                                             : text.anchor == SheetAnchor::Middle ? width / 2
                                                                                  : width);
    const auto show = [&](HPDF_TextRenderingMode mode) {
      HPDF_Page_BeginText(page_);
      HPDF_Page_SetTextRenderingMode(page_, mode);
      HPDF_Page_TextOut(page_, x, points(text.at.y), words.c_str());
      HPDF_Page_EndText(page_);
    };
    if (text.hasHalo) {
      setStroke({255, 255, 255}, kHalo);
      setDashes({});
      show(HPDF_STROKE);
    }
    setFill(text.colour);
    show(HPDF_FILL);
  }

  HPDF_Doc document_;
  HPDF_Page page_ = nullptr;
  HPDF_Font plain_ = nullptr, bold_ = nullptr;
};

}  // namespace

std::string formatSheetsPdf(std::span<const Sheet> sheets) {
  PdfDocument document;
  if (!sheets.empty()) document.setTitle(sheets.front().title);
  for (const Sheet& sheet : sheets) document.addPage(sheet);
  return document.bytes();
}

}  // namespace footfall::detail
