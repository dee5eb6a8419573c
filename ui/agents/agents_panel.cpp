// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/agents/agents_panel.hpp"

#include <QBoxLayout>
#include <QClipboard>
#include <QGuiApplication>
#include <QHeaderView>
#include <QItemSelectionModel>
#include <QStyledItemDelegate>
#include <algorithm>

#include "footfall/filter.hpp"
#include "ui/agents/agent_edits.hpp"
#include "ui/base/commands/keys_back.hpp"
#include "ui/base/look/icon.hpp"
#include "ui/base/text/core_text.hpp"
#include "ui/base/text/localized_numbers.hpp"
#include "ui/base/widgets/flow_layout.hpp"
#include "ui/base/widgets/number_field.hpp"
#include "ui/document/edit_text.hpp"

namespace footfall::ui {
namespace {

/// Edits numbers in the same fields as those of the filters.
class AgentDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    const auto size = AgentModel::sizeIn(index.column());
    if (!size) return QStyledItemDelegate::createEditor(parent, option, index);
    return new NumberField(parameterOf(*size), parent);
  }
  // The editor is filled once, because the table is updated by runs while the user types.
  void setEditorData(QWidget* editor, const QModelIndex& index) const override {
    if (editor->property("filled").toBool()) return;
    editor->setProperty("filled", true);
    if (auto* field = qobject_cast<NumberField*>(editor)) {
      field->setValue(parseNumber(index.data(Qt::EditRole).toString()).value_or(0));
    } else {
      QStyledItemDelegate::setEditorData(editor, index);
    }
  }
  void setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const override {
    const auto* field = qobject_cast<NumberField*>(editor);
    if (field) {
      model->setData(index, field->text());
    } else {
      QStyledItemDelegate::setModelData(editor, model, index);
    }
  }
};

}  // namespace

AgentsPanel::AgentsPanel(Document& document, RunController& controller, QWidget* parent)
    : QWidget(parent), document_(document), controller_(controller) {
  results_ = new AgentResults(document, controller, this);
  model_ = new AgentModel(document, controller, *results_, this);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  auto* buttons = new FlowLayout(4);
  createButtons(buttons);
  layout->addLayout(buttons);

  table_ = new QTableView(this);
  table_->setObjectName(QStringLiteral("agentTable"));
  table_->setAccessibleName(tr("Agents and their results"));
  table_->setModel(model_);
  table_->setItemDelegate(new AgentDelegate(table_));
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setTabKeyNavigation(false);
  table_->setAlternatingRowColors(true);
  table_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed |
                          QAbstractItemView::AnyKeyPressed);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setStretchLastSection(true);
  table_->horizontalHeader()->setMinimumSectionSize(48);
  table_->setMinimumHeight(90);
  layout->addWidget(table_, 1);

  hint_ = new QLabel(this);
  hint_->setObjectName(QStringLiteral("agentHint"));
  hint_->setWordWrap(true);
  hintButton_ = new QPushButton(tr("Add filters"), this);
  hintButton_->setObjectName(QStringLiteral("addAgentFilters"));
  hintButton_->setToolTip(
      tr("Add the filters that the agents drive, before all others; steps and drops behind the clearance"));
  auto* hints = new QHBoxLayout;
  hints->addWidget(hint_, 1);
  hints->addWidget(hintButton_);
  layout->addLayout(hints);

  giveKeysBackAfterClick(*hintButton_);
  connect(hintButton_, &QPushButton::clicked, this, &AgentsPanel::addMissingFilters);
  connect(model_, &AgentModel::failed, this, &AgentsPanel::failed);
  connect(&document_, &Document::agentsChanged, this, &AgentsPanel::follow);
  connect(&document_, &Document::filtersChanged, this, &AgentsPanel::follow);
  connect(&controller_, &RunController::aheadChanged, this, &AgentsPanel::showAhead);
  connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this](const QModelIndex& current) {
    if (!following_ && current.isValid()) activate(current.row());
  });
  follow();
}

QToolButton* AgentsPanel::button(const char* name, const QString& text, const QString& help, const QString& iconName) {
  auto* button = new QToolButton(this);
  button->setObjectName(QLatin1String(name));
  button->setText(text);
  button->setToolTip(help);
  button->setIcon(icon(iconName));
  button->setToolButtonStyle(button->icon().isNull() ? Qt::ToolButtonTextOnly : Qt::ToolButtonTextBesideIcon);
  button->setFocusPolicy(Qt::StrongFocus);
  return button;
}

void AgentsPanel::createButtons(QLayout* layout) {
  addMenu_ = new QMenu(this);
  addMenu_->setObjectName(QStringLiteral("addAgentMenu"));
  addMenu_->setToolTipsVisible(true);
  add_ = button("addAgent", tr("Add"), tr("Add an agent; it becomes the active one"), QStringLiteral("add"));
  add_->setPopupMode(QToolButton::InstantPopup);
  add_->setMenu(addMenu_);
  fillAddMenu();
  duplicate_ = button("duplicateAgent", tr("Duplicate"), tr("Copy the active agent"), QStringLiteral("duplicate"));
  remove_ = button("removeAgent", tr("Remove"), tr("Remove the active agent; the filters stay as they are"),
                   QStringLiteral("remove"));
  letGo_ = button("noAgent", tr("None"), tr("Deactivate the agent; the filters keep their values (Alt+0)"),
                  QStringLiteral("cancel"));
  compute_ = button("computeAgents", tr("Compute all"),
                    tr("Compute the results of all agents in the background, to switch and to compare at once"),
                    QStringLiteral("run"));
  copy_ = button("copyAgents", tr("Copy"), tr("Copy the table"), QStringLiteral("copy"));
  copy_->setPopupMode(QToolButton::InstantPopup);
  auto* copies = new QMenu(copy_);
  copies->addAction(tr("As &text"), this, [this] { copy(false); })->setObjectName(QStringLiteral("copyText"));
  copies->addAction(tr("As &CSV"), this, [this] { copy(true); })->setObjectName(QStringLiteral("copyCsv"));
  copy_->setMenu(copies);
  ahead_ = new QProgressBar(this);
  ahead_->setObjectName(QStringLiteral("agentProgress"));
  ahead_->setAccessibleName(tr("Agents computed"));
  ahead_->setMaximumWidth(140);
  ahead_->hide();
  for (QToolButton* each : {add_, duplicate_, remove_, letGo_, compute_, copy_}) layout->addWidget(each);
  layout->addWidget(ahead_);
  connect(duplicate_, &QToolButton::clicked, this, [this] { duplicateAgent(document_, document_.state().agent); });
  connect(remove_, &QToolButton::clicked, this, [this] { removeAgent(document_, document_.state().agent); });
  connect(letGo_, &QToolButton::clicked, this, &AgentsPanel::letGo);
  connect(compute_, &QToolButton::clicked, this, &AgentsPanel::computeAll);
}

void AgentsPanel::fillAddMenu() {
  addMenu_->clear();
  for (const AgentPreset& preset : agentPresets(metresPerUnit_)) {
    QAction* action = addMenu_->addAction(QString::fromStdString(preset.agent.name), this,
                                          [this, agent = preset.agent] { addAgent(document_, agent); });
    action->setToolTip(preset.help);
    action->setData(QString::fromStdString(preset.agent.name));
  }
  addMenu_->addSeparator();
  addMenu_
      ->addAction(tr("Sizes of the &filters"), this,
                  [this] { addAgent(document_, agentOfFilters(document_.state(), metresPerUnit_)); })
      ->setObjectName(QStringLiteral("agentOfFilters"));
}

void AgentsPanel::setUnits(const LevelUnits& units) {
  metresPerUnit_ = units.metresPerUnit;
  model_->setUnits(units);
  fillAddMenu();
}

void AgentsPanel::activate(int row) {
  const int agent = model_->agentAt(row);
  if (agent != 0) activateAgent(document_, agent);
}

void AgentsPanel::letGo() { activateAgent(document_, 0); }

// Updates the table from the document.
void AgentsPanel::follow() {
  const DocumentState& state = document_.state();
  following_ = true;
  const int row = model_->rowOf(state.agent);
  if (row < 0) {
    table_->setCurrentIndex({});
    table_->clearSelection();
  } else if (table_->currentIndex().row() != row || !table_->selectionModel()->isRowSelected(row)) {
    table_->setCurrentIndex(model_->index(row, std::max(0, table_->currentIndex().column())));
  }
  following_ = false;
  for (QToolButton* each : {duplicate_, remove_, letGo_}) each->setEnabled(row >= 0);
  compute_->setEnabled(!state.agents.empty());
  copy_->setEnabled(!state.agents.empty());

  QStringList names, without;
  for (const AgentSize size : sizesWithoutEffect(state)) {
    const QString name = labelOf(PipelineStep{&filterOf(size), {}, true, 0});
    if (const Text why = whyNoPlace(state, size); !why.empty())
      without << tr("The filter '%1' has no place in the list: %2").arg(name, coreText(why));
    else
      names << name;
  }
  const bool tell = !state.agents.empty() && !names.empty();
  QString hint;
  if (state.agents.empty()) {
    hint = tr(
        "An agent has the sizes that the filters follow: height, slope, step, gap, radius and drop. Add one to compare "
        "what each can reach.");
  } else {
    if (tell) {
      without.prepend(tr("No filter '%1' is on: that size of the agents has no effect.")
                          .arg(names.join(tr("' and no filter '", "between two names of filters"))));
    }
    hint = without.join('\n');
  }
  hint_->setText(hint);
  hint_->setVisible(!hint.isEmpty());
  hintButton_->setVisible(tell);
}

// Adds missing filters at their places of the default pipeline, and steps where they may be; filters that are off are
// switched on.
void AgentsPanel::addMissingFilters() {
  DocumentState next = document_.state();
  std::vector<FilterEntry> added;
  for (const AgentSize size : sizesWithoutEffect(next)) {
    const auto off = std::ranges::find_if(
        next.filters, [size](const FilterEntry& entry) { return agentSizeOf(*entry.step.filter) == size; });
    if (off != next.filters.end()) {
      off->step.enabled = true;
    } else if (!mayBeNone(size)) {  // steps, radii and drops have places of their own
      added.push_back({document_.newFilterId(), defaultStep(filterOf(size), metresPerUnit_)});
    }
  }
  next.filters.insert(next.filters.begin(), added.begin(), added.end());
  applyAgent(next, [this] { return document_.newFilterId(); });
  document_.edit(std::move(next), tr("Add the filters of agents"));
}

void AgentsPanel::showAhead(int done, int all) {
  ahead_->setVisible(done < all);
  ahead_->setRange(0, all);
  ahead_->setValue(done);
  ahead_->setFormat(tr("%1 of %2").arg(done).arg(all));
}

void AgentsPanel::copy(bool csv) {
  const std::vector<QStringList> rows = model_->rows();
  QGuiApplication::clipboard()->setText(csv ? tableCsv(rows) : tableText(rows));
}

}  // namespace footfall::ui
