// What an export is asked for, and what the editor remembers of it.
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

/// The engine, tool or use that an export is for: a format, and what that program wants of it.
struct ExportTarget {
  const char* id;  ///< in settings
  ExportKind kind;
  int godot = 4;             ///< ExportOptions::godot
  bool navmeshNode = false;  ///< ExportOptions::navmeshNode
};

/// All of them, the usual one first.
std::span<const ExportTarget> exportTargets();
/// The usual one where there is no such name.
const ExportTarget& exportTarget(const QString& id);
/// "Godot 4: navigation mesh (.tres)".
QString targetName(const ExportTarget& target);

struct ExportSettings {
  const ExportTarget* target = exportTargets().data();
  ExportOptions options;
  bool placed = false;   ///< with the obstacles that were placed
  PlanOptions plan;      ///< of floor plans
  int pictureSize = 0;   ///< index of pictureSizes()
  bool pictures = true;  ///< in the report
  /// Of exports with several files: those beside the first that may be replaced, and what was written since. Null: all
  /// may be.
  std::shared_ptr<std::set<std::string>> replaceable;

  [[nodiscard]] ExportKind kind() const { return target->kind; }
};

/// The format of the result itself; null for floor plans, pictures and reports.
const FormatDescriptor* meshFormat(ExportKind kind);
[[nodiscard]] bool isPlan(ExportKind kind);
/// An export has files beside the one that was asked for: existingOutputs().
[[nodiscard]] bool hasFilesBeside(ExportKind kind);
/// The ending of a kind's files without its dot: "obj".
QString exportEnding(ExportKind kind);
/// What the files of a kind keep and lose, as phrases; empty for pictures and reports.
QString keptBy(ExportKind kind);
QString lostBy(ExportKind kind);
/// The target for a name's ending: `usual` where it has that one or none that is known, else the first.
const ExportTarget& exportTargetOf(const QString& path, const ExportTarget& usual);
/// "The view (800 × 600)" and so on; the sizes in pixels and how many times larger lines are.
struct PictureSize {
  QString name;
  QSize pixels;
  double ratio = 1;
};
QList<PictureSize> pictureSizes(const QSize& view, double devicePixelRatio);

/// The target of the last export.
const ExportTarget& rememberedTarget();
/// The settings of the last export for a target, but for scale, frame, part and coordinate system: they would silently
/// change the next level's.
ExportSettings rememberedExport(const ExportTarget& target);
void rememberExport(const ExportSettings& settings);

}  // namespace footfall::ui
