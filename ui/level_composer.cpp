// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/level_composer.hpp"

#include <utility>

namespace footfall {

LevelComposer::LevelComposer(Document& document, QObject* parent) : QObject(parent), document_(document) {
  connect(&document_, &Document::levelChanged, this, [this] {
    parts_.setRules(document_.state().partRules);
    recompose();
  });
  connect(&parts_, &PartLevel::changed, this, &LevelComposer::recompose);
}

void LevelComposer::setLoaded(std::shared_ptr<const Environment> loaded,
                              std::shared_ptr<const EnvironmentGeometry> geometry) {
  parts_.setLoaded(std::move(loaded), std::move(geometry), document_.state().partRules);
  compose();
}

void LevelComposer::replaceLoaded(std::shared_ptr<const Environment> loaded) {
  parts_.replaceLoaded(std::move(loaded), document_.state().partRules);
}

void LevelComposer::recompose() {
  const std::shared_ptr<const Environment> before = level_;
  compose();
  if (level_ && level_ != before) emit edited(level_);
}

void LevelComposer::compose() { level_ = parts_.base(); }

}  // namespace footfall
