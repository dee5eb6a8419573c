// What an export is asked for, and what the editor remembers of it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSize>
#include <QString>
#include <QStringList>
#include <array>

#include "core/io/export.hpp"
#include "core/io/formats/format_table.hpp"
#include "ui/base/namespaces.hpp"

namespace footfall::ui {

enum class ExportKind { Obj, Gltf, Glb, Detour, Godot, Png, Html };
inline constexpr std::array kExportKinds{ExportKind::Obj,   ExportKind::Gltf, ExportKind::Glb, ExportKind::Detour,
                                         ExportKind::Godot, ExportKind::Png,  ExportKind::Html};

struct ExportSettings {
  ExportKind kind = ExportKind::Obj;
  ExportOptions options;
  bool placed = false;   ///< with the obstacles that were placed
  int pictureSize = 0;   ///< index of pictureSizes()
  bool pictures = true;  ///< in the report
};

/// The format of the result itself; null for pictures and reports.
const FormatDescriptor* meshFormat(ExportKind kind);
/// The ending of a kind's files without its dot: "obj".
QString exportEnding(ExportKind kind);
QString exportName(ExportKind kind);
/// The format that a name's ending asks for; `usual` where it has none that is known.
ExportKind exportKindOf(const QString& path, ExportKind usual);
/// "The view (800 × 600)" and so on; the sizes in pixels and how many times larger lines are.
struct PictureSize {
  QString name;
  QSize pixels;
  double ratio = 1;
};
QList<PictureSize> pictureSizes(const QSize& view, double devicePixelRatio);

/// The settings of the last export, but for scale and frame: they would silently change the next level's.
ExportSettings rememberedExport();
void rememberExport(const ExportSettings& settings);

}  // namespace footfall::ui
