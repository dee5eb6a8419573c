// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/obj_text.hpp"

#include <algorithm>
#include <filesystem>

#include "footfall/up_axis.hpp"
#include "footfall/version.hpp"

namespace footfall::detail {
namespace {

/// Appends one comment line for each line of `content`. A text of the user must neither end the comment early nor, by a
/// backslash at its end, join the next line to it.
void appendComment(std::string& text, std::string_view label, std::string_view content) {
  while (!content.empty()) {
    const std::size_t stop = content.find('\n');
    text.append("# ").append(label);
    for (const char c : content.substr(0, stop)) text += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    if (text.back() == '\\') text += ' ';
    text += '\n';
    content.remove_prefix(stop == std::string_view::npos ? content.size() : stop + 1);
  }
}

}  // namespace

void appendHeader(std::string& text, std::string_view title, const SourceFrame& frame, const ExportHeader& header,
                  std::string_view content) {
  appendComment(text, "", std::string(title) + " by Footfall " FOOTFALL_VERSION);
  // Only the name is written, so that the same file gives the same bytes in every folder.
  std::filesystem::path source = frame.source;
  if (!source.has_filename()) source = source.parent_path();  // the source is a folder
  std::string name = source.filename().string();
  std::replace(name.begin(), name.end(), '\n', ' ');
  appendComment(text, "source: ", name);
  appendComment(text, "pipeline: ", header.pipeline);
  appendComment(text, "agent: ", header.agent);
  appendComment(text, "note: ", header.note);
  std::string units = shownName(frame.up) + " up, ";
  appendNumber(units, frame.metresPerUnit);
  appendComment(text, "frame: ", units + " metres per unit");
  appendComment(text, "content: ", content);
}

void appendVertex(std::string& text, const Vec3& p, UpAxis up) {
  const Vec3 place = inFileFrame(p, up);
  text += "v ";
  appendNumber(text, place.x);
  text += ' ';
  appendNumber(text, place.y);
  text += ' ';
  appendNumber(text, place.z);
  text += '\n';
}

}  // namespace footfall::detail
