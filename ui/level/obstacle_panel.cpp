// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/level/obstacle_panel.hpp"

#include <QGridLayout>
#include <QMenu>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <limits>

#include "footfall/up_axis.hpp"
#include "ui/base/commands/keys_back.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/base/widgets/flow_layout.hpp"

namespace footfall::ui {
namespace {

using Shape = PlacedObstacle::Shape;

ParameterDescriptor descriptor(const char* name, Unit unit, bool positive) {
  ParameterDescriptor parameter;
  parameter.name = name;
  parameter.label = name;
  parameter.unit = unit;
  parameter.minimum = positive ? 0 : std::numeric_limits<double>::lowest();
  parameter.minimumOpen = positive;
  parameter.maximum = std::numeric_limits<double>::max();
  return parameter;
}

// The base is along the file's axes.
double numberOf(const PlacedObstacle& o, std::size_t index, const LevelUnits& units) {
  LevelUnits file = units;
  file.wanted = LengthUnit::FileUnits;
  const Vec3 base = file.shownPlace(o.base);
  const double numbers[] = {base.x, base.y, base.z, o.size.x, o.size.y, o.size.z, o.turn};
  return numbers[index];
}

void setNumber(PlacedObstacle& o, std::size_t index, double value, const LevelUnits& units) {
  Vec3 base = inFileFrame(o.base, units.up);
  double* const numbers[] = {&base.x, &base.y, &base.z, &o.size.x, &o.size.y, &o.size.z, &o.turn};
  *numbers[index] = value;
  if (index < 3) o.base = fromFileFrame(base, units.up);
}

}  // namespace

QString ObstaclePanel::describe(const PlacedObstacle& o) const {
  return QStringLiteral("%1   (%2)").arg(QString::fromStdString(o.name), units_.size(o.size));
}

ObstaclePanel::ObstaclePanel(ObstacleEditor& editor, QWidget* parent) : QWidget(parent), editor_(editor) {
  list_ = new QListWidget(this);
  list_->setObjectName(QStringLiteral("obstacleList"));
  list_->setAccessibleName(tr("Obstacles"));
  list_->setToolTip(tr("What was placed into the level; a double click brings it into sight"));
  list_->setMinimumHeight(70);

  const auto button = [this](const char* name, const QString& text, const QString& help) {
    auto* made = new QToolButton(this);
    made->setObjectName(QLatin1String(name));
    made->setText(text);
    made->setToolTip(help);
    made->setFocusPolicy(Qt::StrongFocus);
    return made;
  };
  add_ = button("addObstacle", tr("Place"), tr("Choose a shape, then click in the view where it is to stand"));
  add_->setPopupMode(QToolButton::InstantPopup);
  auto* shapes = new QMenu(add_);
  for (const Shape shape : {Shape::Box, Shape::Cylinder, Shape::Ramp})
    connect(shapes->addAction(ObstacleEditor::nameOf(shape)), &QAction::triggered, this,
            [this, shape] { emit placeRequested(shape); });
  add_->setMenu(shapes);
  duplicate_ = button("duplicateObstacle", tr("Duplicate"), tr("A copy beside the selected obstacle (Ctrl+D)"));
  delete_ = button("deleteObstacle", tr("Delete"), tr("Take the selected obstacle out of the level (Del)"));
  auto* buttons = new FlowLayout(6);
  for (QToolButton* b : {add_, duplicate_, delete_}) buttons->addWidget(b);

  form_ = new QWidget(this);
  auto* grid = new QGridLayout(form_);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setVerticalSpacing(4);
  name_ = new QLineEdit(form_);
  name_->setObjectName(QStringLiteral("obstacleName"));
  name_->setAccessibleName(tr("Name of the obstacle"));
  name_->setToolTip(tr("Its name in this list, in undo and in exports"));
  grid->addWidget(new QLabel(tr("Name"), form_), 0, 0);
  grid->addWidget(name_, 0, 1, 1, 3);
  const std::array<QString, kFields> names{tr("Base x"), tr("Base y"), tr("Base z"), tr("Length"),
                                           tr("Width"),  tr("Height"), tr("Turn")};
  constexpr std::array<const char*, kFields> kNames{"base x", "base y", "base z", "length", "width", "height", "turn"};
  for (std::size_t i = 0; i < kFields; ++i) {
    const bool size = i >= 3 && i < 6;
    fields_[i] = new NumberField(descriptor(kNames[i], i == 6 ? Unit::Degrees : Unit::Length, size), form_);
    fields_[i]->setObjectName(QStringLiteral("obstacle") + names[i].simplified().remove(QLatin1Char(' ')));
    fields_[i]->setAccessibleName(names[i]);
    fields_[i]->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);  // the view needs the width
    fields_[i]->setMinimumWidth(52);
    connect(fields_[i], &NumberField::valueEdited, this, [this, i](double value) { editField(i, value); });
    connect(fields_[i], &NumberField::problemChanged, this, &ObstaclePanel::showProblem);
  }
  const auto row = [&](int at, const QString& text, std::size_t first, std::size_t count) {
    auto* label = new QLabel(text, form_);
    grid->addWidget(label, at, 0);
    for (std::size_t i = 0; i < count; ++i) grid->addWidget(fields_[first + i], at, 1 + static_cast<int>(i));
    return label;
  };
  row(1, tr("Base x, y, z"), 0, 3);
  row(2, tr("Size"), 3, 3)->setToolTip(tr("Length, width, height"));  // the whole text would make the panel wide
  row(3, tr("Turn"), 6, 1);
  grid->addWidget(new QLabel(tr("degrees"), form_), 3, 2);
  for (int column = 1; column < 4; ++column) grid->setColumnStretch(column, 1);
  problem_ = new QLabel(form_);
  problem_->setObjectName(QStringLiteral("rowError"));
  problem_->setWordWrap(true);
  problem_->hide();
  grid->addWidget(problem_, 4, 0, 1, 4);

  frame_ = new QLabel(form_);
  frame_->setObjectName(QStringLiteral("obstacleFrame"));
  frame_->setWordWrap(true);
  frame_->setEnabled(false);
  grid->addWidget(frame_, 5, 0, 1, 4);
  giveKeysBackAfterTyping(*name_);

  stick_ = new QCheckBox(tr("Stick to the ground"), this);
  stick_->setObjectName(QStringLiteral("stickObstacles"));
  stick_->setChecked(true);
  stick_->setToolTip(
      tr("Obstacles that are moved sideways follow the ground: up to a metre up, and down to any depth"));

  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(10, 6, 8, 8);
  layout->setSpacing(6);
  layout->addLayout(buttons);
  layout->addWidget(list_, 1);
  layout->addWidget(form_);
  layout->addWidget(stick_);

  connect(&editor_, &ObstacleEditor::changed, this, &ObstaclePanel::showObstacles);
  connect(list_, &QListWidget::currentItemChanged, this, [this](QListWidgetItem* item) {
    editor_.select(item ? std::optional(item->data(Qt::UserRole).toUInt()) : std::nullopt);
  });
  connect(list_, &QListWidget::itemDoubleClicked, this,
          [this](QListWidgetItem* item) { emit frameRequested(item->data(Qt::UserRole).toUInt()); });
  connect(duplicate_, &QToolButton::clicked, this, &ObstaclePanel::duplicateRequested);
  connect(delete_, &QToolButton::clicked, this, [this] {
    if (const PlacedObstacle* o = editor_.selected()) editor_.remove(o->id);
  });
  connect(name_, &QLineEdit::editingFinished, this, [this] {
    const PlacedObstacle* o = editor_.selected();
    const std::string name = name_->text().trimmed().toStdString();
    if (!o || name == o->name) return;
    if (name.empty()) {
      name_->setText(QString::fromStdString(o->name));
      return;
    }
    PlacedObstacle next = *o;
    next.name = name;
    editor_.change(next, tr("Rename to %1"));
  });
  connect(stick_, &QCheckBox::toggled, this, &ObstaclePanel::stickingChanged);
  showUnits();
  showObstacles();
}

void ObstaclePanel::setPlacing(bool possible) { add_->setEnabled(possible); }

void ObstaclePanel::setUnits(const LevelUnits& units) {
  units_ = units;
  for (NumberField* field : fields_) field->setUnits(units);
  showUnits();
  showObstacles();
}

void ObstaclePanel::showUnits() {
  frame_->setText(units_.frameText());
  const QString unit = units_.name();
  for (int i = 0; i < 3; ++i)
    fields_[static_cast<std::size_t>(i)]->setToolTip(
        i == units_.fileAxis(2).axis ? tr("Height of its bottom, along the file's %1, in %2").arg(axisName(i), unit)
                                     : tr("Middle of its bottom, along the file's %1, in %2").arg(axisName(i), unit));
  fields_[3]->setToolTip(tr("Extent along its own length, in %1; a ramp rises along it").arg(unit));
  fields_[4]->setToolTip(tr("Extent across its length, in %1").arg(unit));
  fields_[5]->setToolTip(tr("Extent upward, in %1").arg(unit));
  fields_[6]->setToolTip(tr("About the vertical, in degrees, counter-clockwise from above"));
}

void ObstaclePanel::showObstacles() {
  const QSignalBlocker quiet(list_);
  const auto& obstacles = editor_.obstacles();
  while (list_->count() > static_cast<int>(obstacles.size())) delete list_->takeItem(list_->count() - 1);
  const PlacedObstacle* selected = editor_.selected();
  int current = -1;
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    const int row = static_cast<int>(i);
    if (row == list_->count()) list_->addItem(QString());
    const PlacedObstacle* shown = editor_.find(obstacles[i].id);
    list_->item(row)->setText(describe(*shown));
    list_->item(row)->setData(Qt::UserRole, shown->id);
    if (selected && selected->id == shown->id) current = row;
  }
  list_->setCurrentRow(current);
  showSelected();
}

void ObstaclePanel::showSelected() {
  const PlacedObstacle* selected = editor_.selected();
  form_->setEnabled(selected != nullptr);
  duplicate_->setEnabled(selected != nullptr);
  delete_->setEnabled(selected != nullptr);
  if (!selected) {
    name_->clear();
    for (NumberField* field : fields_) field->clear();
    return;
  }
  const QString name = QString::fromStdString(selected->name);
  if (!name_->hasFocus() || !name_->isModified()) name_->setText(name);
  for (std::size_t i = 0; i < kFields; ++i) fields_[i]->setValue(numberOf(*selected, i, units_));
  showProblem();
}

void ObstaclePanel::editField(std::size_t index, double value) {
  const PlacedObstacle* selected = editor_.selected();
  if (!selected) return;
  PlacedObstacle next = *selected;
  setNumber(next, index, value, units_);
  const QString text = index < 3 ? tr("Move %1") : index < 6 ? tr("Resize %1") : tr("Turn %1");
  editor_.changeSoon(next, text,
                     QStringLiteral("obstacle/%1/%2/%3").arg(next.id).arg(index).arg(fields_[index]->editSession()));
}

void ObstaclePanel::showProblem() {
  QString problem;
  for (const NumberField* field : fields_) {
    if (problem.isEmpty() && !field->problem().isEmpty())
      problem = field->accessibleName() + QStringLiteral(": ") + field->problem();
  }
  problem_->setText(problem);
  problem_->setVisible(!problem.isEmpty());
}

}  // namespace footfall::ui
