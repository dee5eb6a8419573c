// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/export_settings.hpp"

#include <QCoreApplication>
#include <QFileInfo>
#include <QSettings>
#include <algorithm>
#include <array>

#include "ui/base/text/core_text.hpp"

namespace footfall::ui {
namespace {

/// The class is the context of the translations.
struct ExportTexts {
  Q_DECLARE_TR_FUNCTIONS(footfall::ui::ExportTexts)
};

constexpr std::array kTargets{
    ExportTarget{"obj", ExportKind::Obj},
    ExportTarget{"engines", ExportKind::Glb},
    ExportTarget{"godot-4", ExportKind::Godot},
    ExportTarget{"godot-3", ExportKind::Godot, 3},
    ExportTarget{"godot-scene", ExportKind::Glb, 4, true},
    ExportTarget{"detour", ExportKind::Detour},
    ExportTarget{"blender", ExportKind::Glb},
    ExportTarget{"gltf-text", ExportKind::Gltf},
    ExportTarget{"simulators", ExportKind::Wkt},
    ExportTarget{"maps", ExportKind::GeoJson},
    ExportTarget{"plan-pdf", ExportKind::PlanPdf},
    ExportTarget{"plan-svg", ExportKind::PlanSvg},
    ExportTarget{"picture", ExportKind::Png},
    ExportTarget{"report", ExportKind::Html},
};

QString useOf(const ExportTarget& target) {
  const std::string_view id = target.id;
  if (id == "obj") return ExportTexts::tr("Any program: OBJ, exact");
  if (id == "engines") return ExportTexts::tr("Unreal, Unity and other engines: glTF");
  if (id == "godot-4") return ExportTexts::tr("Godot 4: navigation mesh");
  if (id == "godot-3") return ExportTexts::tr("Godot 3: navigation mesh");
  if (id == "godot-scene") return ExportTexts::tr("Godot: glTF scene with a navigation region");
  if (id == "detour") return ExportTexts::tr("Recast and Detour: tile set");
  if (id == "blender") return ExportTexts::tr("Blender: glTF");
  if (id == "gltf-text") return ExportTexts::tr("Browsers and scripts: glTF as text");
  if (id == "simulators") return ExportTexts::tr("JuPedSim and other simulators: polygons");
  if (id == "maps") return ExportTexts::tr("Geographic programs: GeoJSON");
  if (id == "plan-pdf") return ExportTexts::tr("Printers: floor plan");
  if (id == "plan-svg") return ExportTexts::tr("Drawing programs: floor plan");
  if (id == "picture") return ExportTexts::tr("People: a picture of the view");
  return ExportTexts::tr("People: a report with figures and pictures");
}

PlanFormat planFormat(ExportKind kind) { return kind == ExportKind::PlanPdf ? PlanFormat::Pdf : PlanFormat::Svg; }

QString keyOf(const ExportTarget& target, const char* name) {
  return QStringLiteral("export/%1/%2").arg(QLatin1String(target.id), QLatin1String(name));
}

}  // namespace

std::span<const ExportTarget> exportTargets() { return kTargets; }

const ExportTarget& exportTarget(const QString& id) {
  const auto found =
      std::find_if(kTargets.begin(), kTargets.end(), [&](const ExportTarget& t) { return id == QLatin1String(t.id); });
  return found == kTargets.end() ? kTargets.front() : *found;
}

QString targetName(const ExportTarget& target) {
  return QStringLiteral("%1 (.%2)").arg(useOf(target), exportEnding(target.kind));
}

const FormatDescriptor* meshFormat(ExportKind kind) {
  switch (kind) {
    case ExportKind::Obj:
      return &descriptorOf(ExportFormat::Obj);
    case ExportKind::Gltf:
      return &descriptorOf(ExportFormat::Gltf);
    case ExportKind::Glb:
      return &descriptorOf(ExportFormat::Glb);
    case ExportKind::Detour:
      return &descriptorOf(ExportFormat::Detour);
    case ExportKind::Godot:
      return &descriptorOf(ExportFormat::Godot);
    case ExportKind::Wkt:
      return &descriptorOf(ExportFormat::Wkt);
    case ExportKind::GeoJson:
      return &descriptorOf(ExportFormat::GeoJson);
    case ExportKind::PlanPdf:
    case ExportKind::PlanSvg:
    case ExportKind::Png:
    case ExportKind::Html:
      break;
  }
  return nullptr;
}

bool isPlan(ExportKind kind) { return kind == ExportKind::PlanPdf || kind == ExportKind::PlanSvg; }

bool hasFilesBeside(ExportKind kind) {
  const FormatDescriptor* format = meshFormat(kind);
  return format ? format->hasFilesBeside : kind == ExportKind::PlanSvg;
}

QString exportEnding(ExportKind kind) {
  if (const FormatDescriptor* format = meshFormat(kind)) return QString::fromLatin1(format->ending).mid(1);
  switch (kind) {
    case ExportKind::PlanPdf:
      return QStringLiteral("pdf");
    case ExportKind::PlanSvg:
      return QStringLiteral("svg");
    case ExportKind::Png:
      return QStringLiteral("png");
    default:
      return QStringLiteral("html");
  }
}

QString keptBy(ExportKind kind) {
  if (const FormatDescriptor* format = meshFormat(kind)) return coreText(Text(format->keeps));
  return isPlan(kind) ? coreText(Text(planKeeps(planFormat(kind)))) : QString();
}

QString lostBy(ExportKind kind) {
  if (const FormatDescriptor* format = meshFormat(kind)) return coreText(Text(format->loses));
  return isPlan(kind) ? coreText(Text(planLoses(planFormat(kind)))) : QString();
}

const ExportTarget& exportTargetOf(const QString& path, const ExportTarget& usual) {
  const QString ending = QFileInfo(path).suffix().toLower();
  if (ending == exportEnding(usual.kind)) return usual;
  const auto found = std::find_if(kTargets.begin(), kTargets.end(),
                                  [&](const ExportTarget& target) { return ending == exportEnding(target.kind); });
  return found == kTargets.end() ? usual : *found;
}

QList<PictureSize> pictureSizes(const QSize& view, double devicePixelRatio) {
  QList<PictureSize> sizes;
  for (const int times : {1, 2, 4}) {
    const QSize pixels = (QSizeF(view) * devicePixelRatio * times).toSize();
    const QString name = times == 1   ? ExportTexts::tr("As on the screen")
                         : times == 2 ? ExportTexts::tr("Twice that")
                                      : ExportTexts::tr("Four times that");
    sizes << PictureSize{QStringLiteral("%1, %2 × %3").arg(name).arg(pixels.width()).arg(pixels.height()), pixels,
                         devicePixelRatio * times};
  }
  sizes << PictureSize{ExportTexts::tr("4K, 3840 × 2160"), QSize(3840, 2160), 2};
  return sizes;
}

const ExportTarget& rememberedTarget() {
  return exportTarget(QSettings().value(QStringLiteral("export/target")).toString());
}

ExportSettings rememberedExport(const ExportTarget& target) {
  const QSettings settings;
  const auto isOn = [&](const char* name, bool usual) { return settings.value(keyOf(target, name), usual).toBool(); };
  const auto number = [&](const char* name, int low, int high, int usual) {
    return std::clamp(settings.value(keyOf(target, name), usual).toInt(), low, high);
  };
  ExportSettings remembered;
  remembered.target = &target;
  ExportOptions& options = remembered.options;
  options.godot = target.godot;
  options.navmeshNode = target.navmeshNode;
  options.layers = isOn("layers", true);
  options.connections = isOn("connections", true);
  options.obstacleEdges = isOn("obstacleEdges", true);
  options.steps = isOn("steps", true);
  options.drops = isOn("drops", true);
  remembered.placed = isOn("placed", false);
  remembered.pictureSize = number("pictureSize", 0, 3, 0);
  remembered.pictures = isOn("pictures", true);
  remembered.bottlenecks = isOn("bottlenecks", false);
  PlanOptions& plan = remembered.plan;
  plan.pages = isOn("layerPages", false) ? PlanPages::Layers : PlanPages::Storeys;
  plan.colours = isOn("blackAndWhite", false) ? PlanColours::BlackAndWhite : PlanColours::Colour;
  plan.hasCorridors = isOn("corridors", false);
  if (const int paper = number("paper", -1, static_cast<int>(Paper::A0), -1); paper >= 0)
    plan.paper = static_cast<Paper>(paper);
  return remembered;
}

void rememberExport(const ExportSettings& chosen) {
  QSettings settings;
  const ExportTarget& target = *chosen.target;
  const auto keep = [&](const char* name, const QVariant& value) { settings.setValue(keyOf(target, name), value); };
  settings.setValue(QStringLiteral("export/target"), QLatin1String(target.id));
  keep("layers", chosen.options.layers);
  keep("connections", chosen.options.connections);
  keep("obstacleEdges", chosen.options.obstacleEdges);
  keep("steps", chosen.options.steps);
  keep("drops", chosen.options.drops);
  keep("placed", chosen.placed);
  keep("pictureSize", chosen.pictureSize);
  keep("pictures", chosen.pictures);
  keep("bottlenecks", chosen.bottlenecks);
  keep("layerPages", chosen.plan.pages == PlanPages::Layers);
  keep("blackAndWhite", chosen.plan.colours == PlanColours::BlackAndWhite);
  keep("corridors", chosen.plan.hasCorridors);
  keep("paper", chosen.plan.paper ? static_cast<int>(*chosen.plan.paper) : -1);
}

}  // namespace footfall::ui
