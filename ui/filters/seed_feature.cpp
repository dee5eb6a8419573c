// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/filters/seed_feature.hpp"

#include <algorithm>

#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"
#include "ui/filters/seed_edits.hpp"

namespace footfall::ui {

SeedFeature::SeedFeature(const FeatureHost& host, LevelView& view, Document& document, RunController& controller,
                         FilterList& list)
    : QObject(&host.window), document_(document), view_(view), list_(list), tool_(document, view, nullptr) {
  place_ = host.tools.add({QStringLiteral("tools.seeds"),
                           CommandMenu::Tools,
                           QStringLiteral("tools"),
                           tr("&Place seeds"),
                           tr("Click the places where agents start; everything that they cannot reach is removed"),
                           {QKeySequence(Qt::SHIFT | Qt::Key_S)},
                           QStringLiteral("seeds")},
                          &tool_);
  connect(&list_, &FilterList::placingRequested, this, [this](int id, bool on) {
    list_.choose({id});
    if (place_->isChecked() != on) place_->trigger();
    follow();
  });
  connect(&list_, &FilterList::selectionChanged, this, &SeedFeature::follow);
  connect(&document_, &Document::filtersChanged, this, &SeedFeature::follow);
  connect(&view_, &LevelView::toolChanged, this, &SeedFeature::follow);
  connect(&tool_, &SeedTool::filterAdded, this, [this](int id) {
    list_.choose({id});
    view_.setFocus();
  });
  connect(&tool_, &SeedTool::draggingChanged, &controller, &RunController::setDragging);
  connect(&tool_, &SeedTool::hintChanged, this, [this, &status = host.status](const QString& hint) {
    if (view_.tool() == &tool_) status.say(StatusSubject::Tool, hint);
  });
  const auto takeUnits = [this, &choice = host.units] { tool_.setUnits(choice.units()); };
  connect(&host.units, &UnitChoice::changed, this, takeUnits);
  takeUnits();
  follow();
}

void SeedFeature::follow() {
  const int current = list_.selection().current();
  const auto entry = std::ranges::find(document_.filters(), current, &FilterEntry::id);
  const bool isCurrent = entry != document_.filters().end() && entry->step.filter->type == FilterType::Reachable;
  tool_.setFilter(isCurrent ? current : filterOfSeeds(document_));
  const bool isPlacing = view_.tool() == &tool_;
  tool_.setShown(isPlacing || isCurrent);
  list_.setPlacing(isPlacing ? tool_.filter() : -1);
  if (const auto geometry = view_.environmentGeometry(); isPlacing && geometry)
    tool_.setExtent(std::max({geometry->upper.x - geometry->lower.x, geometry->upper.y - geometry->lower.y,
                              geometry->upper.z - geometry->lower.z}));
}

}  // namespace footfall::ui
