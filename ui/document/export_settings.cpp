// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/export_settings.hpp"

#include <QCoreApplication>
#include <QFileInfo>
#include <QSettings>
#include <algorithm>

#include "ui/base/core_text.hpp"

namespace footfall::ui {
namespace {

/// For the translations.
struct ExportTexts {
  Q_DECLARE_TR_FUNCTIONS(footfall::ui::ExportTexts)
};

}  // namespace

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
    case ExportKind::Png:
    case ExportKind::Html:
      break;
  }
  return nullptr;
}

QString exportEnding(ExportKind kind) {
  if (const FormatDescriptor* format = meshFormat(kind)) return QString::fromLatin1(format->ending).mid(1);
  return kind == ExportKind::Png ? QStringLiteral("png") : QStringLiteral("html");
}

QString exportName(ExportKind kind) {
  if (const FormatDescriptor* format = meshFormat(kind)) return coreText(Text(format->name));
  return kind == ExportKind::Png ? ExportTexts::tr("PNG: the view as a picture")
                                 : ExportTexts::tr("HTML: a report with figures and pictures");
}

ExportKind exportKindOf(const QString& path, ExportKind usual) {
  const QString ending = QFileInfo(path).suffix().toLower();
  for (const ExportKind kind : kExportKinds)
    if (ending == exportEnding(kind)) return kind;
  return usual;
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

ExportSettings rememberedExport() {
  const QSettings settings;
  const auto read = [&](const char* name, const QVariant& usual) {
    return settings.value(QStringLiteral("export/") + QLatin1String(name), usual);
  };
  ExportSettings export_;
  export_.kind = exportKindOf(QStringLiteral("a.") + read("format", QStringLiteral("obj")).toString(), ExportKind::Obj);
  export_.options.layers = read("layers", true).toBool();
  export_.options.connections = read("connections", true).toBool();
  export_.options.obstacleEdges = read("obstacleEdges", true).toBool();
  export_.options.steps = read("steps", true).toBool();
  export_.options.drops = read("drops", true).toBool();
  export_.placed = read("placed", false).toBool();
  export_.pictureSize = std::clamp(read("pictureSize", 0).toInt(), 0, 3);
  export_.pictures = read("pictures", true).toBool();
  return export_;
}

void rememberExport(const ExportSettings& export_) {
  QSettings settings;
  settings.setValue(QStringLiteral("export/format"), exportEnding(export_.kind));
  settings.setValue(QStringLiteral("export/layers"), export_.options.layers);
  settings.setValue(QStringLiteral("export/connections"), export_.options.connections);
  settings.setValue(QStringLiteral("export/obstacleEdges"), export_.options.obstacleEdges);
  settings.setValue(QStringLiteral("export/steps"), export_.options.steps);
  settings.setValue(QStringLiteral("export/drops"), export_.options.drops);
  settings.setValue(QStringLiteral("export/placed"), export_.placed);
  settings.setValue(QStringLiteral("export/pictureSize"), export_.pictureSize);
  settings.setValue(QStringLiteral("export/pictures"), export_.pictures);
}

}  // namespace footfall::ui
