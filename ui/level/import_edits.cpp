// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/level/import_edits.hpp"

#include "ui/document/agent_rules.hpp"

namespace footfall::ui {

ImportEdits::ImportEdits(Document& document, LevelFile& file, ImportPanel& panel, UnitChoice& units)
    : QObject(&panel), document_(document), file_(file), panel_(panel), units_(units) {
  connect(&panel_, &ImportPanel::optionsEdited, this, &ImportEdits::edit);
  connect(&document_, &Document::importChanged, this, [this] {
    panel_.setOptions(document_.state().import);
    file_.setOptions(document_.state().import);
  });
  connect(&file_, &LevelFile::arrived, this, &ImportEdits::showLevel);
  connect(&file_, &LevelFile::rescaled, this, [this] { units_.setLevel(*file_.environment()); });
}

void ImportEdits::showLevel() {
  const LoadedEnvironment& loaded = file_.loaded();
  const Vec3 &lower = loaded.geometry->lower, &upper = loaded.geometry->upper;
  panel_.setEnvironment(loaded.environment.get(), {upper.x - lower.x, upper.y - lower.y, upper.z - lower.z},
                        loaded.options.up.has_value(), loaded.options.metresPerUnit.has_value());
  if (loaded.part) panel_.setPart(loaded.environment->triangles.size(), loaded.part->environment->faceCount());
  units_.setLevel(*loaded.environment);
}

void ImportEdits::edit(const ImportOptions& options) {
  if (!file_.environment()) return;
  Pipeline pipeline = document_.pipeline();
  std::optional<std::vector<NamedAgent>> agents;
  QString mergeKey;
  if (options.metresPerUnit && options.metresPerUnit != document_.state().import.metresPerUnit) {
    if (panel_.scaleField()->hasFocus()) mergeKey = QStringLiteral("scale/%1").arg(panel_.scaleField()->editSession());
    // Typing passes through intermediate numbers: each of them converts from the state before typing.
    if (mergeKey.isEmpty() || !scaleEdit_ || scaleEdit_->key != mergeKey)
      scaleEdit_ = ScaleEdit{mergeKey, pipeline, document_.state().agents, file_.environment()->metresPerUnit,
                             file_.environment()->scaleGuessed};
    const double scale = *options.metresPerUnit;
    // Values that were entered while the unit was a guess are in the file's units, and stay.
    pipeline = scaleEdit_->guessed ? rescaleDefaults(scaleEdit_->pipeline, scaleEdit_->scale, scale)
                                   : rescaleLengths(scaleEdit_->pipeline, scaleEdit_->scale, scale);
    agents = rescaledAgents(scaleEdit_->agents, scaleEdit_->scale, scale);
  }
  document_.setImportAndPipeline(options, pipeline, tr("Change import options"), mergeKey, agents);
}

}  // namespace footfall::ui
