// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/level/part_level.hpp"

#include <QMetaObject>
#include <algorithm>
#include <exception>
#include <utility>

#include "core/environment/environment_diff.hpp"
#include "footfall/errors.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/base/text/core_text.hpp"

namespace footfall::ui {
namespace {

constexpr std::size_t kVersions = 4;

}  // namespace

PartLevel::PartLevel(QObject* parent) : QObject(parent) {}

void PartLevel::setLoaded(EnvironmentPtr loaded, GeometryPtr geometry, const std::vector<PartRule>& rules) {
  work_.stop();
  loaded_ = std::move(loaded);
  geometry_ = std::move(geometry);
  whole_ = geometry_ ? geometry_->whole : nullptr;
  rules_ = rules;
  versions_.clear();
  computed_ = nullptr;
  base_ = loaded_ ? applyPartRules(loaded_, rules_) : nullptr;
  if (base_ != loaded_)
    work(base_);
  else if (base_)
    versions_.push_front({loaded_, rules_, base_, geometry_});
}

void PartLevel::replaceLoaded(EnvironmentPtr loaded, std::shared_ptr<const WholeBounds> whole,
                              const std::vector<PartRule>& rules) {
  loaded_ = std::move(loaded);
  whole_ = std::move(whole);
  rules_ = rules;
  update();
}

void PartLevel::setRules(const std::vector<PartRule>& rules) {
  if (rules == rules_) return;
  rules_ = rules;
  if (loaded_) update();
}

void PartLevel::setComputed() {
  if (!busy()) computed_ = base_;
}

void PartLevel::update() {
  work_.stop();
  const auto known = std::ranges::find_if(
      versions_, [&](const Version& version) { return version.loaded == loaded_ && version.rules == rules_; });
  if (known != versions_.end()) {
    const Version version = *known;
    take(version.base, version.geometry);
    return;
  }
  work(nullptr);
}

// With `base`, only its geometry is missing.
void PartLevel::work(EnvironmentPtr base) {
  work_.start(
      *this,
      [loaded = loaded_, rules = rules_, before = computed_ ? computed_ : base_, given = std::move(base),
       centre = geometry_->centre, whole = whole_](RunContext& context) {
        const EnvironmentPtr made = given ? given : diffEnvironments(before, applyPartRules(loaded, rules), &context);
        context.checkCancelled();
        return std::pair<EnvironmentPtr, GeometryPtr>(made, makeEnvironmentGeometry(*made, centre, true, whole));
      },
      [this](const auto& made) { take(made.first, made.second); },
      [this](const std::exception& error) {
        emit failed(tr("the roles of parts cannot be applied (%1); close other programs or use a smaller environment")
                        .arg(coreText(error)));
      });
}

void PartLevel::take(const EnvironmentPtr& base, const GeometryPtr& geometry) {
  versions_.remove_if([&](const Version& version) { return version.base == base; });
  versions_.push_front({loaded_, rules_, base, geometry});
  if (versions_.size() > kVersions) versions_.pop_back();
  geometry_ = geometry;
  if (base != base_) {
    base_ = base;
    emit changed();
  }
  emit geometryChanged();
}

}  // namespace footfall::ui
