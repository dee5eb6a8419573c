// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/level/part_panel.hpp"

#include <QHeaderView>
#include <QItemSelectionModel>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "core/environment/part_names.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/base/text/core_text.hpp"
#include "ui/base/text/localized_numbers.hpp"
#include "ui/base/widgets/fitted_labels.hpp"
#include "ui/base/widgets/flow_layout.hpp"

namespace footfall::ui {
namespace {

constexpr int kCountWidth = 76, kRoleWidth = 96;

/// The filter is reset as a whole: adding thousands of rows one by one takes a tree seconds.
class FilteredParts : public QSortFilterProxyModel {
 public:
  using QSortFilterProxyModel::QSortFilterProxyModel;
  void setText(const QString& text) {
    beginResetModel();
    {
      const QSignalBlocker quiet(this);
      QAbstractItemModel* const source = sourceModel();
      setSourceModel(nullptr);  // drops the rows, which are mapped again on demand
      setFilterFixedString(text);
      setSourceModel(source);
    }
    endResetModel();
  }
};

}  // namespace

PartPanel::PartPanel(Document& document, QWidget* parent) : QWidget(parent), document_(document) {
  setObjectName(QStringLiteral("partPanel"));
  createWidgets();
  createActions();
  connect(model_, &PartModel::inclusionAsked, this, [this](const std::vector<std::uint32_t>& parts, bool on) {
    // A box among several selected rows changes all of them.
    const std::vector<std::uint32_t> selected = selectedParts();
    const bool isSelected = std::ranges::includes(selected, parts);
    include(isSelected ? selected : parts, on);
  });
  connect(filter_, &QLineEdit::textChanged, this, [this](const QString& text) {
    keepingSelection([&] { static_cast<FilteredParts*>(proxy_)->setText(text); });
    if (!text.isEmpty()) tree_->expandAll();
  });
  connect(tree_->selectionModel(), &QItemSelectionModel::selectionChanged, this, [this] {
    if (restoring_) return;
    const std::vector<std::uint32_t> parts = selectedParts();
    for (QAction* action : roleActions_) action->setEnabled(!parts.empty());
    showFigures();
    emit selectionChanged(parts);
  });
  connect(tree_, &QTreeView::doubleClicked, this, [this] { emit activated(selectedParts()); });
  connect(&document_, &Document::levelChanged, this, [this] {
    model_->setRules(document_.state().partRules);
    showFigures();
  });
  setEnvironment(nullptr);
}

void PartPanel::createWidgets() {
  model_ = new PartModel(this);
  proxy_ = new FilteredParts(this);
  proxy_->setSourceModel(model_);
  proxy_->setRecursiveFilteringEnabled(true);
  proxy_->setAutoAcceptChildRows(true);
  proxy_->setFilterCaseSensitivity(Qt::CaseInsensitive);
  proxy_->setSortCaseSensitivity(Qt::CaseInsensitive);
  proxy_->setSortRole(PartModel::kSortRole);
  filter_ = new QLineEdit(this);
  filter_->setObjectName(QStringLiteral("partFilter"));
  filter_->setPlaceholderText(tr("Filter by name"));
  filter_->setAccessibleName(tr("Filter meshes and materials by name"));
  filter_->setToolTip(tr("Shows only meshes and materials whose names contain this"));
  filter_->setClearButtonEnabled(true);
  tree_ = new QTreeView(this);
  tree_->setObjectName(QStringLiteral("partTree"));
  tree_->setAccessibleName(tr("Meshes and materials"));
  tree_->setModel(proxy_);
  tree_->setUniformRowHeights(true);  // otherwise thousands of rows are measured one by one
  tree_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  tree_->setAlternatingRowColors(true);
  tree_->setExpandsOnDoubleClick(false);
  tree_->setTextElideMode(Qt::ElideMiddle);
  tree_->setSortingEnabled(true);
  tree_->header()->setSortIndicatorClearable(true);
  tree_->sortByColumn(-1, Qt::AscendingOrder);  // in the order of the file
  tree_->header()->setStretchLastSection(false);
  tree_->header()->setSectionResizeMode(PartModel::Name, QHeaderView::Stretch);
  tree_->header()->resizeSection(PartModel::Triangles, kCountWidth);
  tree_->header()->resizeSection(PartModel::Role, kRoleWidth);
  tree_->setContextMenuPolicy(Qt::ActionsContextMenu);
  figures_ = new WrappedLabel(this);
  figures_->setObjectName(QStringLiteral("partFigures"));
  empty_ = new QLabel(tr("Open an environment to see its meshes and materials."), this);
  empty_->setWordWrap(true);
}

void PartPanel::createActions() {
  auto* buttons = new FlowLayout(4);
  const auto add = [&](const char* name, const QString& text, const QString& help, PartRole role, Qt::Key key) {
    auto* action = new QAction(text, this);
    action->setObjectName(QLatin1String(name));
    action->setShortcut(QKeySequence(Qt::ALT | Qt::SHIFT | key));
    action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    action->setToolTip(QStringLiteral("%1 (%2)").arg(help, action->shortcut().toString(QKeySequence::NativeText)));
    action->setEnabled(false);
    connect(action, &QAction::triggered, this, [this, role] { setRole(role); });
    tree_->addAction(action);
    auto* button = new QToolButton(this);
    button->setDefaultAction(action);
    button->setToolButtonStyle(Qt::ToolButtonTextOnly);
    button->setFocusPolicy(Qt::TabFocus);
    buttons->addWidget(button);
    roleActions_.push_back(action);
  };
  add("roleFloor", tr("As usual"), tr("Selected parts are walkable where the filters let them be"), PartRole::Floor,
      Qt::Key_1);
  add("roleObstacle", tr("Obstacle only"), tr("Nobody walks on selected parts, but they still stand in the way"),
      PartRole::ObstacleOnly, Qt::Key_2);
  add("roleIgnored", tr("Ignore"), tr("Selected parts are left out, as if the file did not have them"),
      PartRole::Ignored, Qt::Key_3);
  auto* separator = new QAction(this);
  separator->setSeparator(true);
  tree_->addAction(separator);
  auto* frame = new QAction(tr("Show in the View"), this);
  frame->setObjectName(QStringLiteral("framePart"));
  frame->setShortcut(Qt::Key_Return);
  frame->setShortcutContext(Qt::WidgetShortcut);
  frame->setToolTip(tr("Brings the selected parts into sight (double click, Return)"));
  connect(frame, &QAction::triggered, this, [this] { emit activated(selectedParts()); });
  tree_->addAction(frame);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 6, 8, 6);
  layout->setSpacing(4);
  layout->addWidget(filter_);
  layout->addWidget(tree_, 1);
  layout->addWidget(empty_);
  layout->addLayout(buttons);
  layout->addWidget(figures_);
}

void PartPanel::setEnvironment(const std::shared_ptr<const Environment>& environment) {
  keepingSelection([&] {
    model_->setEnvironment(environment);
    model_->setRules(document_.state().partRules);
  });
  const bool any = environment != nullptr;
  bool isTree = false;
  for (int row = 0; row < model_->rowCount() && !isTree; ++row) isTree = model_->rowCount(model_->index(row, 0)) > 0;
  tree_->setRootIsDecorated(isTree);
  empty_->setVisible(!any);
  tree_->setVisible(any);
  filter_->setEnabled(any);
}

void PartPanel::keepingSelection(const std::function<void()>& change) {
  using Names = std::pair<std::string, std::string>;
  std::set<Names> selected;
  std::set<QString> open;
  for (const std::uint32_t part : selectedParts())
    selected.insert({model_->part(part).mesh, model_->part(part).material});
  for (int row = 0; row < proxy_->rowCount(); ++row) {
    const QModelIndex index = proxy_->index(row, 0);
    if (tree_->isExpanded(index)) open.insert(index.data().toString());
  }
  restoring_ = true;
  change();
  for (int row = 0; row < proxy_->rowCount() && !open.empty(); ++row) {
    const QModelIndex index = proxy_->index(row, 0);
    if (open.contains(index.data().toString())) tree_->setExpanded(index, true);
  }
  QItemSelection again;
  for (std::uint32_t part = 0; part < model_->partCount() && !selected.empty(); ++part) {
    if (!selected.contains({model_->part(part).mesh, model_->part(part).material})) continue;
    const QModelIndex row = rowOf(part);
    if (!row.isValid()) continue;
    // Neighbours are selected together, because a selection of thousands of single rows is slow.
    if (!again.isEmpty() && again.back().parent() == row.parent() && again.back().bottom() + 1 == row.row())
      again.back() = QItemSelectionRange(again.back().topLeft(), row);
    else
      again.append(QItemSelectionRange(row));
  }
  tree_->selectionModel()->select(again, QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
  restoring_ = false;
  const std::vector<std::uint32_t> parts = selectedParts();
  for (QAction* action : roleActions_) action->setEnabled(!parts.empty());
  showFigures();
  emit selectionChanged(parts);
}

std::vector<std::uint32_t> PartPanel::selectedParts() const {
  std::set<std::uint32_t> parts;
  for (const QModelIndex& index : tree_->selectionModel()->selectedRows())
    for (const std::uint32_t part : model_->partsOf(proxy_->mapToSource(index))) parts.insert(part);
  return {parts.begin(), parts.end()};
}

QModelIndex PartPanel::rowOf(std::uint32_t part) const { return proxy_->mapFromSource(model_->indexOf(part)); }

QString PartPanel::nameOf(const std::vector<std::uint32_t>& parts) const {
  if (parts.size() != 1) return tr("%1 parts").arg(parts.size());
  return coreText(partLabel(model_->part(parts.front())));
}

void PartPanel::setRole(PartRole role) {
  const std::vector<std::uint32_t> parts = selectedParts();
  if (parts.empty()) return;
  const QString text = role == PartRole::Ignored        ? tr("Ignore %1")
                       : role == PartRole::ObstacleOnly ? tr("Make %1 an obstacle only")
                                                        : tr("Make %1 walkable as usual");
  apply(parts, std::vector<PartRole>(parts.size(), role), text.arg(nameOf(parts)));
}

// A part that a box includes again gets the role that it had before.
void PartPanel::include(const std::vector<std::uint32_t>& parts, bool on) {
  std::vector<PartRole> roles;
  for (const std::uint32_t part : parts) {
    const PartRole now = model_->roleOf(part);
    const std::pair names(model_->part(part).mesh, model_->part(part).material);
    if (!on) {
      if (now != PartRole::Ignored) before_[names] = now;
      roles.push_back(PartRole::Ignored);
    } else {
      const auto before = before_.find(names);
      roles.push_back(now != PartRole::Ignored ? now : before == before_.end() ? PartRole::Floor : before->second);
    }
  }
  apply(parts, roles, (on ? tr("Include %1") : tr("Ignore %1")).arg(nameOf(parts)));
}

void PartPanel::apply(const std::vector<std::uint32_t>& parts, const std::vector<PartRole>& roles,
                      const QString& text) {
  struct Asked {
    PartRole role, usual;
  };
  std::map<std::pair<std::string, std::string>, Asked> asked;
  for (std::size_t i = 0; i < parts.size(); ++i)
    asked[{model_->part(parts[i]).mesh, model_->part(parts[i]).material}] = {roles[i], model_->usualRoleOf(parts[i])};
  DocumentState next = document_.state();
  std::erase_if(next.partRules, [&](const PartRule& rule) { return asked.contains({rule.mesh, rule.material}); });
  for (const auto& [names, one] : asked)
    if (one.role != one.usual) next.partRules.push_back({names.first, names.second, one.role});
  document_.edit(std::move(next), text);
}

void PartPanel::showFigures() {
  std::uint64_t triangles = 0, ignored = 0, obstacles = 0;
  for (std::uint32_t part = 0; part < model_->partCount(); ++part) {
    triangles += model_->trianglesOf(part);
    if (model_->roleOf(part) == PartRole::Ignored) ignored += model_->trianglesOf(part);
    if (model_->roleOf(part) == PartRole::ObstacleOnly) obstacles += model_->trianglesOf(part);
  }
  QStringList lines;
  if (const std::vector<std::uint32_t> selected = selectedParts(); !selected.empty()) {
    std::uint64_t count = 0;
    for (const std::uint32_t part : selected) count += model_->trianglesOf(part);
    lines << (count == 1 ? tr("Selected: %1, 1 triangle").arg(nameOf(selected))
                         : tr("Selected: %1, %2 triangles").arg(nameOf(selected), countText(count)));
  }
  if (ignored + obstacles > 0)
    lines << tr("Of %1 triangles, %2 ignored and %3 obstacles only")
                 .arg(countText(triangles), countText(ignored), countText(obstacles));
  else if (model_->partCount() > 0)
    lines << (model_->partCount() == 1
                  ? (triangles == 1 ? tr("1 triangle in one part")
                                    : tr("%1 triangles in one part").arg(countText(triangles)))
                  : tr("%1 triangles in %2 parts").arg(countText(triangles)).arg(countText(model_->partCount())));
  figures_->setText(lines.join(QLatin1Char('\n')));
}

}  // namespace footfall::ui
