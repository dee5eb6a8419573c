// The settings of an export, and those that the editor remembers.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSize>
#include <QString>
#include <QStringList>
#include <memory>
#include <set>
#include <span>
#include <string>

#include "core/io/export.hpp"
#include "core/io/formats/format_table.hpp"
#include "core/report/floor_plan.hpp"
#include "ui/base/namespaces.hpp"

namespace footfall::ui {

enum class ExportKind { Obj, Gltf, Glb, Detour, Godot, Wkt, GeoJson, PlanPdf, PlanSvg, Png, Html };

/// The engine, tool or use that an export is made for: a format with the options that the program needs.
struct ExportTarget {
  const char* id;  ///< name in the settings
  ExportKind kind;
  int godot = 4;             ///< ExportOptions::godot
  bool navmeshNode = false;  ///< ExportOptions::navmeshNode
};

/// All targets; the default one is first.
std::span<const ExportTarget> exportTargets();
/// The target with this name; the default one where there is none.
const ExportTarget& exportTarget(const QString& id);
/// The target's name with its format: "Godot 4: navigation mesh (.tres)".
QString targetName(const ExportTarget& target);

struct ExportSettings {
  const ExportTarget* target = exportTargets().data();
  ExportOptions options;
  bool placed = false;       ///< includes the placed obstacles
  PlanOptions plan;          ///< options of floor plans
  int pictureSize = 0;       ///< index of pictureSizes()
  bool pictures = true;      ///< pictures in the report
  bool bottlenecks = false;  ///< the narrowest passages in the report
  /// The files beside the first one that an export with several files may replace, and those written since. Null: all
  /// may be replaced.
  std::shared_ptr<std::set<std::string>> replaceable;

  [[nodiscard]] ExportKind kind() const { return target->kind; }
};

/// The format of the result itself; null for floor plans, pictures and reports.
const FormatDescriptor* meshFormat(ExportKind kind);
[[nodiscard]] bool isPlan(ExportKind kind);
/// Returns whether an export has files beside the chosen one: existingOutputs().
[[nodiscard]] bool hasFilesBeside(ExportKind kind);
/// The ending of a kind's files without its dot: "obj".
QString exportEnding(ExportKind kind);
/// Phrases of what the files of a kind keep and lose; empty for pictures and reports.
QString keptBy(ExportKind kind);
QString lostBy(ExportKind kind);
/// The target for a name's ending: `usual` where it has this ending or the ending is unknown, else the first that has
/// it.
const ExportTarget& exportTargetOf(const QString& path, const ExportTarget& usual);
/// The sizes of pictures ("The view (800 × 600)" and so on): pixels, and the factor on the width of lines.
struct PictureSize {
  QString name;
  QSize pixels;
  double ratio = 1;
};
QList<PictureSize> pictureSizes(const QSize& view, double devicePixelRatio);

/// The target of the last export.
const ExportTarget& rememberedTarget();
/// The settings of the last export for a target, except scale, frame, part, coordinate system and width of bottlenecks,
/// which would silently change the export of the next level.
ExportSettings rememberedExport(const ExportTarget& target);
void rememberExport(const ExportSettings& settings);

}  // namespace footfall::ui
