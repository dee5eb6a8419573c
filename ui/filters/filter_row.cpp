// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/filters/filter_row.hpp"

#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QVBoxLayout>
#include <algorithm>

#include "core/filters/descriptor_text.hpp"
#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/base/text/core_text.hpp"
#include "ui/base/text/filter_text.hpp"
#include "ui/base/text/localized_numbers.hpp"
#include "ui/base/widgets/fitted_labels.hpp"
#include "ui/document/edit_text.hpp"
#include "ui/view/cells/cell_colours.hpp"

namespace footfall::ui {
namespace {

constexpr int kMark = 16;          // pixels of the sign of a state
constexpr int kFieldLetters = 15;  // of the width of a field
constexpr int kUnitLetters = 9;    // and of the unit behind it, so that fields stand in a column
constexpr int kGroupLetters = 8;   // of the width of a field of a group, at least
constexpr int kNameLetters = 12;   // of a word in a name that is not broken
constexpr std::size_t kMostGroups = 24;

std::size_t fieldsFor(const FilterDescriptor& filter, std::size_t values) {
  const std::size_t once = filter.parameters.size() - filter.repeats;
  return std::min(values, once + kMostGroups * filter.repeats);
}

QString helpOf(const FilterDescriptor& filter) {
  QString help = QStringLiteral("<b>%1</b> (%2)<p>%3</p>")
                     .arg(filterText(filter.label), untranslated(filter.name), filterText(filter.help));
  if (!filter.precondition.empty())
    help += FilterRow::tr("<p><i>Needs:</i> %1</p>").arg(filterText(filter.precondition));
  return help + FilterRow::tr("<p><i>Effect:</i> %1</p>").arg(filterText(filter.effect));
}

QString helpOf(const ParameterDescriptor& parameter, bool hasDefault) {
  const QString drag = parameter.type == ParameterType::Boolean
                           ? QString()
                           : FilterRow::tr(
                                 "<p>Type it, drag sideways, or turn the wheel while the field has the focus; "
                                 "Shift: finer, Ctrl: coarser, Esc: back.</p>");
  // The unit stands behind the field.
  ParameterDescriptor range = parameter;
  if (range.unit != Unit::Degrees) range.unit = Unit::None;
  if (!hasDefault)
    return QStringLiteral("<p>%1</p><p>%2</p>%3")
        .arg(filterText(parameter.help), FilterRow::tr("Takes %1.").arg(coreText(describeRange(range))), drag);
  return QStringLiteral("<p>%1</p><p>%2</p>%3")
      .arg(filterText(parameter.help),
           FilterRow::tr("Takes %1. Default: %2%3.")
               .arg(coreText(describeRange(range)),
                    QString::fromStdString(formatValue(parameter, parameter.defaultValue)),
                    parameter.unit == Unit::Length ? QStringLiteral(" m")
                    : parameter.unit == Unit::Area ? QStringLiteral(" m²")
                                                   : QString()),
           drag);
}

/// A wrapped label that takes one line where there is room for it, and breaks long words only.
class NameLabel : public WrappedLabel {
 public:
  using WrappedLabel::WrappedLabel;

  [[nodiscard]] QSize sizeHint() const override { return {widthOf(text()), fontMetrics().height()}; }
  [[nodiscard]] QSize minimumSizeHint() const override {
    int width = 0;
    for (const QString& word : text().split(QLatin1Char(' '))) width = std::max(width, widthOf(word));
    return {std::min(width, kNameLetters * fontMetrics().averageCharWidth()), fontMetrics().height()};
  }

 private:
  [[nodiscard]] int widthOf(const QString& words) const {
    return fontMetrics().horizontalAdvance(words) + 1 + contentsMargins().left() + contentsMargins().right();
  }
};

QString statusFigures(const StepStatus& status) {
  QStringList parts;
  if (status.wallMs) parts << durationText(*status.wallMs);
  if (status.trianglesIn && status.trianglesOut) {
    parts << (*status.trianglesOut == 1 ? FilterRow::tr("%1 → 1 triangle").arg(countText(*status.trianglesIn))
                                        : FilterRow::tr("%1 → %2 triangles")
                                              .arg(countText(*status.trianglesIn), countText(*status.trianglesOut)));
  } else if (status.trianglesOut) {
    parts << (*status.trianglesOut == 1 ? FilterRow::tr("1 triangle")
                                        : FilterRow::tr("%1 triangles").arg(countText(*status.trianglesOut)));
  }
  QString line = parts.join(QStringLiteral("  ·  "));
  if (!status.note.isEmpty()) line += (line.isEmpty() ? QString() : QStringLiteral("\n")) + status.note;
  return line;
}

}  // namespace

FilterRow::FilterRow(const FilterEntry& entry, QWidget* parent)
    : QFrame(parent), id_(entry.id), filter_(*entry.step.filter) {
  setObjectName(QStringLiteral("filterRow"));
  setFrameShape(QFrame::StyledPanel);
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(filterText(filter_.label));

  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 3, 5, 3);
  layout->setSpacing(3);
  addHead(layout);
  addParameters(layout);
  if (filter_.repeats > 0) addGroups(layout, entry.step.values.size());
  figures_ = new WrappedLabel(this);
  figures_->setObjectName(QStringLiteral("figures"));
  figures_->setContentsMargins(22, 0, 0, 0);
  error_ = new WrappedLabel(this);
  error_->setObjectName(QStringLiteral("rowError"));
  error_->setContentsMargins(22, 0, 0, 0);
  layout->addWidget(figures_);
  layout->addWidget(error_);
  error_->hide();
  mend_ = new QToolButton(this);
  mend_->setObjectName(QStringLiteral("mendRow"));
  mend_->hide();
  setClearanceOff(true);
  connect(mend_, &QToolButton::clicked, this, [this] { emit clearanceRequested(id_); });
  auto* mending = new QHBoxLayout;
  mending->setContentsMargins(22, 0, 0, 0);
  mending->addWidget(mend_, 0, Qt::AlignLeft);
  layout->addLayout(mending);
  share_ = new ShareBar(this);
  layout->addWidget(share_);

  connect(enabled_, &QCheckBox::clicked, this, [this](bool on) { emit enabledEdited(id_, on); });
  connect(remove_, &QToolButton::clicked, this, [this] { emit removeRequested(id_); });
  setEntry(entry);
  showUnits();
  setStatus({});
}

void FilterRow::addHead(QVBoxLayout* layout) {
  const QString label = filterText(filter_.label);
  handle_ = new QLabel(QStringLiteral("⋮⋮"), this);
  handle_->setObjectName(QStringLiteral("dragHandle"));
  handle_->setToolTip(tr("Drag to change the order (or Alt+Up, Alt+Down)"));
  handle_->setCursor(Qt::OpenHandCursor);
  enabled_ = new QCheckBox(this);
  enabled_->setToolTip(tr("Switch this filter off and on (Space)"));
  enabled_->setAccessibleName(label);
  name_ = new NameLabel(this);
  name_->setText(label);
  name_->setObjectName(QStringLiteral("filterName"));
  name_->setToolTip(helpOf(filter_));
  summary_ = new ElidedLabel(this);
  summary_->setObjectName(QStringLiteral("filterSummary"));
  summary_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // what the name leaves
  time_ = new QLabel(this);
  time_->setObjectName(QStringLiteral("filterSummary"));
  stateIcon_ = new QLabel(this);
  state_ = new QLabel(this);
  remove_ = new QToolButton(this);
  remove_->setText(QStringLiteral("✕"));
  remove_->setAutoRaise(true);
  remove_->setToolTip(tr("Remove this filter"));
  remove_->setAccessibleName(tr("Remove %1").arg(label));
  auto* head = new QHBoxLayout;
  head->setSpacing(4);
  head->addWidget(handle_);
  head->addWidget(enabled_);
  head->addWidget(name_);
  head->addWidget(summary_, 1);
  head->addWidget(time_);
  head->addWidget(stateIcon_);
  head->addWidget(state_);
  if (filter_.kind == FilterKind::Strategy) {
    preview_ = new QToolButton(this);
    preview_->setText(tr("Cells"));
    preview_->setObjectName(QStringLiteral("previewCells"));
    preview_->setToolTip(tr("Preview the cells that this strategy makes, without running the filters"));
    connect(preview_, &QToolButton::clicked, this, [this] { emit previewRequested(id_); });
    head->addWidget(preview_);
  }
  head->addWidget(remove_);
  layout->addLayout(head);
}

void FilterRow::addParameters(QVBoxLayout* layout) {
  if (filter_.parameters.size() == filter_.repeats) return;
  parameters_ = new QWidget(this);
  auto* grid = new QGridLayout(parameters_);
  grid->setContentsMargins(22, 0, 4, 0);
  grid->setVerticalSpacing(3);
  grid->setColumnStretch(0, 1);
  for (std::size_t i = 0; i + filter_.repeats < filter_.parameters.size(); ++i) {
    const ParameterDescriptor& parameter = filter_.parameters[i];
    const int row = static_cast<int>(i);
    auto* label = new WrappedLabel(parameters_);
    label->setText(filterText(parameter.label));
    label->setToolTip(helpOf(parameter, true));
    grid->addWidget(label, row, 0);
    names_.push_back(label);
    if (parameter.type == ParameterType::Boolean) {
      auto* box = new QCheckBox(parameters_);
      box->setToolTip(helpOf(parameter, true));
      box->setAccessibleName(filterText(parameter.label));
      connect(box, &QCheckBox::clicked, this, [this, i](bool on) { emit valueEdited(id_, i, on ? 1 : 0, -1); });
      grid->addWidget(box, row, 1);
      fields_.push_back(box);
      units_.push_back(nullptr);
      continue;
    }
    addNumber(parameter, i, grid, label);
  }
  layout->addWidget(parameters_);
}

NumberField* FilterRow::makeNumber(const ParameterDescriptor& parameter, std::size_t index, QWidget* parent) {
  auto* field = new NumberField(parameter, parent);
  field->setObjectName(untranslated(parameter.name));
  connect(field, &NumberField::valueEdited, this,
          [this, index, field](double value) { emit valueEdited(id_, index, value, field->editSession()); });
  connect(field, &NumberField::problemChanged, this, &FilterRow::showError);
  connect(field, &NumberField::draggingChanged, this, &FilterRow::draggingChanged);
  fields_.push_back(field);
  return field;
}

void FilterRow::addNumber(const ParameterDescriptor& parameter, std::size_t index, QGridLayout* grid, QLabel* label) {
  const int row = static_cast<int>(index);
  NumberField* field = makeNumber(parameter, index, parameters_);
  field->takeDragsOf(label);
  for (QWidget* widget : {static_cast<QWidget*>(field), static_cast<QWidget*>(label)}) widget->installEventFilter(this);
  field->setToolTip(helpOf(parameter, true));
  field->setAccessibleName(filterText(parameter.label));
  field->setFixedWidth(kFieldLetters * fontMetrics().averageCharWidth());
  label->setBuddy(field);
  grid->addWidget(field, row, 1);
  auto* unit = new QLabel(parameters_);
  unit->setMinimumWidth(kUnitLetters * fontMetrics().averageCharWidth());
  grid->addWidget(unit, row, 2);
  units_.push_back(unit);
}

// Adds a line for each seed: its number, its coordinates, and the button that removes it.
void FilterRow::addGroups(QVBoxLayout* layout, std::size_t values) {
  const std::size_t once = filter_.parameters.size() - filter_.repeats, count = fieldsFor(filter_, values);
  groups_ = new QWidget(this);
  auto* grid = new QGridLayout(groups_);
  grid->setContentsMargins(22, 0, 4, 0);
  grid->setVerticalSpacing(2);
  grid->setHorizontalSpacing(4);
  const int last = static_cast<int>(filter_.repeats) + 1;
  if (count > once) {
    groupUnit_ = new QLabel(groups_);
    grid->addWidget(groupUnit_, 0, 0);
    for (int k = 1; k < last; ++k) {
      const ParameterDescriptor& parameter = filter_.parameters[once + static_cast<std::size_t>(k) - 1];
      auto* head = new QLabel(filterText(parameter.label), groups_);
      head->setToolTip(helpOf(parameter, false));
      grid->addWidget(head, 0, k, Qt::AlignRight);
      grid->setColumnStretch(k, 1);
    }
  }
  for (std::size_t i = once; i < count; ++i) {
    const std::size_t group = (i - once) / filter_.repeats, k = (i - once) % filter_.repeats;
    const int row = static_cast<int>(group) + 1;
    const QString number = QString::number(group + 1);
    if (k == 0) {
      grid->addWidget(new QLabel(number, groups_), row, 0);
      auto* remove = new QToolButton(groups_);
      remove->setText(QStringLiteral("✕"));
      remove->setAutoRaise(true);
      remove->setToolTip(tr("Remove seed %1").arg(number));
      remove->setAccessibleName(tr("Remove seed %1").arg(number));
      connect(remove, &QToolButton::clicked, this, [this, group] { emit groupRemoved(id_, group); });
      grid->addWidget(remove, row, last);
      removeGroup_.push_back(remove);
    }
    const ParameterDescriptor& parameter = filter_.parameterOf(i);
    NumberField* field = makeNumber(parameter, i, groups_);
    field->setToolTip(helpOf(parameter, false));
    field->setAccessibleName(tr("%1 of seed %2").arg(filterText(parameter.label), number));
    field->setMinimumWidth(kGroupLetters * fontMetrics().averageCharWidth());
    grid->addWidget(field, row, static_cast<int>(k) + 1);
    units_.push_back(nullptr);
  }
  const int end = grid->rowCount();
  moreGroups_ = new QLabel(groups_);
  moreGroups_->setObjectName(QStringLiteral("moreSeeds"));
  grid->addWidget(moreGroups_, end, 0, 1, last + 1);
  place_ = new QToolButton(groups_);
  place_->setObjectName(QStringLiteral("placeSeeds"));
  place_->setText(tr("Place seeds"));
  place_->setToolTip(
      tr("Click the places in the view where agents start; everything that they cannot reach is removed"));
  place_->setCheckable(true);
  connect(place_, &QToolButton::clicked, this, [this](bool on) { emit placingRequested(id_, on); });
  grid->addWidget(place_, end + 1, 0, 1, last + 1, Qt::AlignLeft);
  layout->addWidget(groups_);
}

void FilterRow::setUnits(const LevelUnits& units) {
  shown_ = units;
  for (QWidget* widget : fields_)
    if (auto* field = qobject_cast<NumberField*>(widget)) field->setUnits(units);
  showUnits();
  showSummary();
}

void FilterRow::showUnits() {
  for (std::size_t i = 0; i < units_.size(); ++i)
    if (units_[i]) units_[i]->setText(unitText(filter_.parameters[i].unit, shown_));
  if (groupUnit_) groupUnit_->setText(unitText(filter_.parameters.back().unit, shown_));
}

// Values that are words ("yes") have no meaning without their label.
void FilterRow::showSummary() {
  QStringList parts;
  const std::size_t once = filter_.parameters.size() - filter_.repeats;
  for (std::size_t i = 0; i < once && i < values_.size(); ++i) {
    const ParameterDescriptor& parameter = filter_.parameters[i];
    if (parameter.type == ParameterType::Boolean) continue;
    QString text = valueText(parameter, values_[i], shown_);
    const bool hasUnit = parameter.unit == Unit::Length || parameter.unit == Unit::Area;
    if (hasUnit && shown_.unit() != LengthUnit::FileUnits)  // "units" would say nothing
      text += QStringLiteral(" ") + unitText(parameter.unit, shown_);
    parts << text;
  }
  if (filter_.repeats > 0) parts << tr("%n seeds", "", static_cast<int>((values_.size() - once) / filter_.repeats));
  summary_->setText(parts.join(QStringLiteral("  ·  ")));
}

void FilterRow::setOpen(bool open) {
  if (open_ == open) return;
  open_ = open;
  showParts();
}

void FilterRow::setClearanceOff(bool off) {
  const QString clearance = filterText(filterDescriptor(FilterType::VerticalClearance).label);
  mend_->setText((off ? tr("Switch %1 on") : tr("Add %1")).arg(clearance));
}

// Properties are set only when they change, because each change lays out the whole list.
void FilterRow::showParts() {
  const auto show = [](QWidget* widget, bool visible) {
    if (widget && widget->isHidden() == visible) widget->setVisible(visible);
  };
  bool hasProblem = false;
  for (QWidget* widget : fields_) {
    const auto* field = qobject_cast<NumberField*>(widget);
    hasProblem = hasProblem || (field && !field->problem().isEmpty());
  }
  const bool open = open_ || hasProblem;
  const bool usual = status_.state == StepState::Done || status_.state == StepState::Cached;
  show(parameters_, open);
  show(groups_, open);
  show(figures_, open && !figures_->text().isEmpty() && status_.state != StepState::Off);
  show(summary_, !open);
  QSizePolicy policy = name_->sizePolicy();  // with its height for a width
  policy.setHorizontalPolicy(open ? QSizePolicy::Expanding : QSizePolicy::Preferred);
  name_->setSizePolicy(policy);
  show(time_, !open && usual && !time_->text().isEmpty());
  show(state_, open || !usual);
  show(error_, !error_->text().isEmpty());
  show(mend_, status_.state == StepState::Skipped);
}

bool FilterRow::fits(const FilterEntry& entry) const {
  return fieldsFor(filter_, entry.step.values.size()) == fields_.size();
}

void FilterRow::setEntry(const FilterEntry& entry) {
  values_ = entry.step.values;
  showSummary();
  name_->setEnabled(entry.step.enabled);
  summary_->setEnabled(entry.step.enabled);
  enabled_->setChecked(entry.step.enabled);
  if (parameters_) parameters_->setEnabled(entry.step.enabled);
  if (groups_) {
    groups_->setEnabled(entry.step.enabled);
    const std::size_t more = (entry.step.values.size() - fields_.size()) / filter_.repeats;
    moreGroups_->setText(tr("and %1 more").arg(countText(more)));
    moreGroups_->setVisible(more > 0);
  }
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    if (auto* field = qobject_cast<NumberField*>(fields_[i])) {
      if (field->value() != entry.step.values[i] || field->text().isEmpty()) field->setValue(entry.step.values[i]);
    } else if (auto* box = qobject_cast<QCheckBox*>(fields_[i])) {
      box->setChecked(entry.step.values[i] != 0);
    }
  }
}

void FilterRow::setInBlock(bool inBlock) {
  if (property("inBlock").toBool() == inBlock) return;
  setProperty("inBlock", inBlock);
  style()->unpolish(this);
  style()->polish(this);
}

void FilterRow::setSelected(bool selected) {
  if (property("selected").toBool() == selected) return;
  setProperty("selected", selected);
  style()->unpolish(this);
  style()->polish(this);
}

void FilterRow::setShare(std::optional<double> share, const QColor& colour) { share_->setShare(share, colour); }

void FilterRow::setStatus(const StepStatus& status) {
  status_ = status;
  showState();
  const QString figures = statusFigures(status);
  if (figures != figures_->text()) figures_->setText(figures);
  const bool old = status.state == StepState::Stale || status.state == StepState::Cancelled;
  figures_->setEnabled(!old);
  time_->setText(status.wallMs ? durationText(*status.wallMs) : QString());
  time_->setToolTip(figures);
  showError();
}

void FilterRow::showState() {
  QString word = stateWord(status_.state);
  if (status_.state == StepState::Running && status_.fraction > 0) {
    word += QStringLiteral(" %1 %").arg(static_cast<int>(status_.fraction * 100));
  }
  const QColor colour = stateColour(status_.state, palette());
  if (word == state_->text() && colour == stateColour_) return;
  stateColour_ = colour;
  state_->setText(word);
  state_->setStyleSheet(QStringLiteral("color: %1; font-weight: 600;").arg(colour.name()));
  stateIcon_->setPixmap(stateMark(status_.state, palette(), kMark, devicePixelRatioF()));
  setAccessibleDescription(word);
}

void FilterRow::changeEvent(QEvent* event) {
  QFrame::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && state_) showState();
}

bool FilterRow::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Enter || event->type() == QEvent::Leave) {
    for (std::size_t i = 0; i < names_.size(); ++i)
      if (watched == fields_[i] || watched == names_[i]) emit parameterPointed(id_, i, event->type() == QEvent::Enter);
  }
  return QFrame::eventFilter(watched, event);
}

void FilterRow::showError() {
  QStringList lines;
  for (QWidget* widget : fields_) {
    const auto* field = qobject_cast<NumberField*>(widget);
    if (field && !field->problem().isEmpty()) lines << field->problem();
  }
  if (status_.state == StepState::Skipped)
    lines << tr("needs %1").arg(filterText(filterDescriptor(FilterType::VerticalClearance).label));
  if (!status_.error.isEmpty()) lines << status_.error;
  const QString text = lines.join(QLatin1Char('\n'));
  if (text != error_->text()) error_->setText(text);
  showParts();
}

}  // namespace footfall::ui
