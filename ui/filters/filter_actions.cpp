// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/filters/filter_actions.hpp"

#include <QClipboard>
#include <QGuiApplication>
#include <QKeySequence>
#include <algorithm>

#include "core/pipeline/pipeline_fragment.hpp"
#include "footfall/errors.hpp"
#include "footfall/filter.hpp"
#include "ui/base/look/icon.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/base/text/core_text.hpp"
#include "ui/base/text/filter_text.hpp"
#include "ui/document/edit_text.hpp"
#include "ui/filters/filter_places.hpp"

namespace footfall::ui {
void FilterActions::fillFilterMenu(QMenu& menu, std::size_t index,
                                   const std::function<void(const FilterDescriptor&)>& use) const {
  menu.setToolTipsVisible(true);
  const Pipeline pipeline = document_.pipeline();
  FilterKind kind = FilterKind::Filter;
  for (const FilterDescriptor& filter : filterDescriptors()) {
    if (kind == FilterKind::Filter && filter.kind != kind) menu.addSection(tr("Parallel blocks"));
    kind = filter.kind;
    const QString reason = whyNotAt(pipeline, index, filter, metresPerUnit_);
    const QString label = filterText(filter.label);
    QAction* action = menu.addAction(reason.isEmpty() ? label : tr("%1: %2").arg(label, reason));
    action->setEnabled(reason.isEmpty());
    action->setToolTip(filterText(filter.help));
    action->setData(untranslated(filter.name));
    connect(action, &QAction::triggered, &menu, [use, &filter] { use(filter); });
  }
}

std::size_t FilterActions::placeBehind() const {
  const FilterIds ids = selection_.ids();
  return ids.empty() ? document_.filters().size() : placeOf(ids.back()) + 1;
}

FilterActions::FilterActions(Document& document, FilterSelection& selection, QWidget* list)
    : QObject(list), document_(document), selection_(selection), list_(list) {
  add("filters.cut", tr("Cu&t filters"), tr("Take the selected filters out, as text for the clipboard"),
      QKeySequence::Cut, QStringLiteral("cut"), &FilterActions::cut);
  add("filters.copy", tr("&Copy filters"), tr("Copy the selected filters, as lines of a pipeline file"),
      QKeySequence::Copy, QStringLiteral("copy"), &FilterActions::copy);
  add("filters.paste", tr("&Paste filters"), tr("Put filters from the clipboard behind the selected ones"),
      QKeySequence::Paste, QStringLiteral("paste"), &FilterActions::paste);
  add("filters.duplicate", tr("&Duplicate filters"), tr("Put copies behind the selected filters"),
      QKeySequence(Qt::CTRL | Qt::Key_D), QStringLiteral("duplicate"), &FilterActions::duplicate);
  add("filters.remove", tr("&Remove filters"), tr("Remove the selected filters"), QKeySequence(Qt::Key_Delete),
      QStringLiteral("remove"), &FilterActions::remove);
  add("filters.selectAll", tr("Select &all filters"), tr("Select all rows"), QKeySequence::SelectAll, {},
      &FilterActions::selectAll);
  add("filters.up", tr("Move filters &up"), tr("Move the selected filters up by one row"),
      QKeySequence(Qt::ALT | Qt::Key_Up), {}, &FilterActions::moveUp);
  add("filters.down", tr("Move filters do&wn"), tr("Move the selected filters down by one row"),
      QKeySequence(Qt::ALT | Qt::Key_Down), {}, &FilterActions::moveDown);
  add("filters.switch", tr("&Switch filters on or off"), tr("Switch the selected filters off, or on again"),
      QKeySequence(Qt::Key_Space), {}, &FilterActions::switchOver);
  add("filters.upTo", tr("Run &only up to here"), tr("Switch off all filters behind the selected one"),
      QKeySequence(Qt::CTRL | Qt::Key_Return), QStringLiteral("solo"), &FilterActions::runUpTo);
  add("filters.othersOff", tr("Switch all ot&hers off"), tr("Leave only the selected filters on"), {}, {},
      &FilterActions::othersOff);
  add("filters.allOn", tr("Switch all o&n"), tr("Switch all filters on"), {}, {}, &FilterActions::allOn);
  add("filters.defaults", tr("Use de&fault values"), tr("Give the selected filters the values of new ones"), {}, {},
      &FilterActions::resetValues);
  connect(QGuiApplication::clipboard(), &QClipboard::dataChanged, this, &FilterActions::update);
  update();
}

QAction* FilterActions::add(const char* id, const QString& text, const QString& help, const QKeySequence& keys,
                            const QString& iconName, void (FilterActions::*perform)()) {
  auto* action = new QAction(text, this);
  action->setShortcut(keys);
  action->setShortcutContext(Qt::WidgetShortcut);  // displayed only: handleKey() handles it
  if (!iconName.isEmpty()) action->setIcon(icon(iconName));
  connect(action, &QAction::triggered, this, perform);
  entries_.push_back({QLatin1String(id), help, action});
  return action;
}

QAction* FilterActions::find(const QString& id) const {
  const auto found = std::ranges::find(entries_, id, &Entry::id);
  return found == entries_.end() ? nullptr : found->action;
}

bool FilterActions::handleKey(const QKeyEvent& key, bool perform) {
  const QKeySequence pressed(key.keyCombination());
  for (const Entry& entry : entries_) {
    if (!entry.action->isEnabled() || entry.action->shortcut().isEmpty() || entry.action->shortcut() != pressed)
      continue;
    if (perform) entry.action->trigger();
    return true;
  }
  return false;
}

void FilterActions::update() {
  const bool some = !selection_.ids().empty();
  for (const Entry& entry : entries_) entry.action->setEnabled(some);
  find(QStringLiteral("filters.paste"))->setEnabled(!QGuiApplication::clipboard()->text().isEmpty());
  find(QStringLiteral("filters.selectAll"))->setEnabled(!document_.filters().empty());
  find(QStringLiteral("filters.allOn"))->setEnabled(std::ranges::any_of(document_.filters(), [](const auto& entry) {
    return !entry.step.enabled;
  }));
}

std::size_t FilterActions::placeOf(int id) const {
  const auto& filters = document_.filters();
  return static_cast<std::size_t>(std::ranges::find(filters, id, &FilterEntry::id) - filters.begin());
}

QMenu* FilterActions::makeMenu(QWidget* parent) {
  auto* menu = new QMenu(parent);
  const auto put = [&](std::initializer_list<const char*> ids) {
    for (const char* id : ids) menu->addAction(find(QLatin1String(id)));
    menu->addSeparator();
  };
  for (const bool behind : {false, true}) {
    QMenu* insertion = menu->addMenu(behind ? tr("&Insert behind") : tr("Insert &before"));
    insertion->setObjectName(behind ? QStringLiteral("insertBehind") : QStringLiteral("insertBefore"));
    const std::size_t index =
        selection_.current() < 0 ? document_.filters().size() : placeOf(selection_.current()) + (behind ? 1 : 0);
    fillFilterMenu(*insertion, index, [this, index](const FilterDescriptor& filter) {
      emit chosen(addFilterAt(document_, index, filter, metresPerUnit_, tr("Insert %1")));
    });
  }
  menu->addSeparator();
  put({"filters.cut", "filters.copy", "filters.paste", "filters.duplicate", "filters.remove"});
  put({"filters.up", "filters.down"});
  put({"filters.switch", "filters.upTo", "filters.othersOff", "filters.allOn"});
  menu->addAction(find(QStringLiteral("filters.defaults")));
  return menu;
}

void FilterActions::cut() {
  copy();
  remove();
}

void FilterActions::copy() {
  QGuiApplication::clipboard()->setText(QString::fromStdString(filtersAsText(document_, selection_.ids())));
}

void FilterActions::paste() {
  const std::string pasted = QGuiApplication::clipboard()->text().toStdString();
  try {
    const Pipeline part = parsePipelineFragment(pasted, tr("clipboard").toStdString());
    if (part.steps.empty())
      throw InputError(tr("clipboard: holds no filters; copy lines of a pipeline first").toStdString());
    emit chosen(insertFilters(document_, placeBehind(), part.steps, tr("Paste %1").arg(stepsText(part.steps))));
  } catch (const InputError& error) {
    emit failed(coreText(error));
  }
}

void FilterActions::duplicate() { emit chosen(duplicateFilters(document_, selection_.ids())); }

void FilterActions::remove() { removeFilters(document_, selection_.ids()); }

void FilterActions::selectAll() {
  FilterIds ids;
  for (const FilterEntry& entry : document_.filters()) ids.push_back(entry.id);
  emit chosen(ids);
}

// Switches all off when any of them is on.
void FilterActions::switchOver() {
  const FilterIds ids = selection_.ids();
  bool on = false;
  for (const int id : ids) on = on || document_.filters()[placeOf(id)].step.enabled;
  switchFilters(document_, ids, !on);
}

void FilterActions::runUpTo() {
  if (selection_.current() >= 0) runOnlyUpTo(document_, selection_.current());
}

void FilterActions::resetValues() {
  DocumentState next = document_.state();
  std::vector<PipelineStep> steps;
  for (FilterEntry& entry : next.filters) {
    if (!selection_.contains(entry.id)) continue;
    entry.step.values = defaultStep(*entry.step.filter, metresPerUnit_).values;
    steps.push_back(entry.step);
  }
  document_.edit(std::move(next), tr("Use default values of %1").arg(stepsText(steps)));
}

}  // namespace footfall::ui
