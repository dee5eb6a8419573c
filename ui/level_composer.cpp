// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/level_composer.hpp"

#include <utility>

namespace footfall {

LevelComposer::LevelComposer(Document& document, QObject* parent) : QObject(parent), document_(document) {
  connect(&document_, &Document::levelChanged, this, [this] {
    const std::shared_ptr<const Environment> before = level_;
    compose();
    if (level_ && level_ != before) emit edited(level_);
  });
}

void LevelComposer::setLoaded(std::shared_ptr<const Environment> loaded) {
  loaded_ = std::move(loaded);
  compose();
}

void LevelComposer::compose() { level_ = loaded_; }

}  // namespace footfall
