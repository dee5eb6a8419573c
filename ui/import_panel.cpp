// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/import_panel.hpp"

#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLocale>
#include <QVBoxLayout>
#include <limits>

#include "ui/fitted_labels.hpp"
#include "ui/flow_layout.hpp"

namespace footfall {
namespace {

// A field like those of the filters; the scale is no filter's parameter.
ParameterDescriptor scaleDescriptor() {
  ParameterDescriptor scale;
  scale.name = "scale";
  scale.label = "Metres per unit";
  scale.minimum = 0;
  scale.minimumOpen = true;
  scale.maximum = std::numeric_limits<double>::max();
  scale.defaultValue = 1;
  return scale;
}

QString counted(std::uint64_t count, const QString& what) {
  return QLocale(QLocale::English).toString(static_cast<qulonglong>(count)) + QLatin1Char(' ') + what;
}

QString shortNumber(double value) { return QString::number(value, 'g', 4); }

}  // namespace

ImportPanel::ImportPanel(QWidget* parent) : QWidget(parent) {
  name_ = new ElidedLabel(tr("Nothing loaded"), this);
  name_->setObjectName(QStringLiteral("environmentName"));
  name_->setTextFormat(Qt::PlainText);
  figures_ = new WrappedLabel(this);
  figures_->setText(tr("Open a file (Ctrl+O), or drop one here."));

  up_ = new QComboBox(this);
  up_->setObjectName(QStringLiteral("upAxis"));
  up_->addItems({tr("Guess"), tr("Y up"), tr("Z up")});
  up_->setToolTip(tr("Which axis of the file points up. Z is up here; the export is turned back."));
  scale_ = new NumberField(scaleDescriptor(), this);
  scale_->setObjectName(QStringLiteral("scale"));
  scale_->setFixedWidth(90);
  scale_->setToolTip(
      tr("How many metres one unit of the file is. Coordinates are never scaled: this sets the default values of the "
         "filters. Filters that still have their defaults follow."));
  scaleNote_ = new QLabel(this);
  scaleError_ = new WrappedLabel(this);
  scaleError_->setObjectName(QStringLiteral("rowError"));
  scaleError_->hide();
  bothSides_ = new QCheckBox(tr("Both sides count as up"), this);
  bothSides_->setObjectName(QStringLiteral("bothSides"));
  bothSides_->setToolTip(
      tr("For files whose triangles face the wrong way: whatever faces down is taken as facing up."));
  watch_ = new QCheckBox(tr("Watch the file"), this);
  watch_->setObjectName(QStringLiteral("watchFile"));
  watch_->setToolTip(
      tr("Reads the file again when another program has saved it. Camera, filters, roles and obstacles stay, and only "
         "what "
         "differs is computed again."));

  auto* scaleRow = new QHBoxLayout;
  scaleRow->addWidget(scale_);
  scaleRow->addWidget(scaleNote_, 1);
  auto* form = new QFormLayout;
  form->setVerticalSpacing(4);
  form->addRow(tr("Up axis"), up_);
  form->addRow(tr("Metres per unit"), scaleRow);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(10, 6, 8, 8);
  layout->setSpacing(4);
  layout->addWidget(name_);
  layout->addWidget(figures_);
  layout->addLayout(form);
  layout->addWidget(scaleError_);
  auto* boxes = new FlowLayout(6);
  boxes->addWidget(bothSides_);
  boxes->addWidget(watch_);
  layout->addLayout(boxes);

  connect(up_, &QComboBox::activated, this, [this](int index) {
    options_.up = index == 0 ? std::nullopt : std::optional(index == 1 ? UpAxis::Y : UpAxis::Z);
    emit optionsEdited(options_);
  });
  connect(scale_, &NumberField::valueEdited, this, [this](double value) {
    options_.metresPerUnit = value;
    showGuesses();
    emit optionsEdited(options_);
  });
  connect(scale_, &NumberField::problemChanged, this, [this] {
    scaleError_->setText(scale_->problem());
    scaleError_->setVisible(!scale_->problem().isEmpty());
  });
  connect(bothSides_, &QCheckBox::clicked, this, [this](bool on) {
    options_.bothSides = on;
    emit optionsEdited(options_);
  });
  setEnvironment(nullptr, {});
}

void ImportPanel::addBelowFigures(QWidget* widget) {
  auto* rows = static_cast<QVBoxLayout*>(layout());
  rows->insertWidget(rows->indexOf(figures_) + 1, widget);
}

void ImportPanel::setOptions(const ImportOptions& options) {
  options_ = options;
  up_->setCurrentIndex(!options.up ? 0 : *options.up == UpAxis::Y ? 1 : 2);
  bothSides_->setChecked(options.bothSides);
  showGuesses();
}

void ImportPanel::setEnvironment(const Environment* environment, const Vec3& size) {
  loaded_ = environment != nullptr;
  for (QWidget* widget :
       {static_cast<QWidget*>(up_), static_cast<QWidget*>(scale_), static_cast<QWidget*>(bothSides_)}) {
    widget->setEnabled(loaded_);
  }
  if (environment) {
    const QString path = QString::fromStdString(environment->source);
    name_->setText(QFileInfo(path).fileName());
    name_->setToolTip(path);
    QString figures = counted(environment->triangles.size(), tr("triangles")) + QStringLiteral(", ") +
                      counted(environment->vertices.size(), tr("vertices"));
    figures += tr("\n%1 × %2 × %3 units").arg(shortNumber(size.x), shortNumber(size.y), shortNumber(size.z));
    const SkippedElements& skipped = environment->skipped;
    QStringList left;
    if (skipped.polygons > 0) left << counted(skipped.polygons, tr("polygons"));
    if (skipped.lines > 0) left << counted(skipped.lines, tr("lines"));
    if (skipped.points > 0) left << counted(skipped.points, tr("points"));
    if (!left.isEmpty()) figures += QLatin1Char('\n') + tr("Skipped: %1").arg(left.join(QStringLiteral(", ")));
    figures_->setText(figures);
    // What was given instead of guessed is no guess to fall back to.
    if (environment->upGuessed) guessedUp_ = environment->up;
    if (environment->scaleGuessed) guessedScale_ = environment->metresPerUnit;
  }
  showGuesses();
}

void ImportPanel::showGuesses() {
  const bool guessing = !options_.up.has_value();
  up_->setItemText(0,
                   loaded_ && guessing ? tr("%1 up (guessed)").arg(guessedUp_ == UpAxis::Y ? "Y" : "Z") : tr("Guess"));
  scale_->setValue(options_.metresPerUnit.value_or(guessedScale_));
  scaleNote_->setText(loaded_ && !options_.metresPerUnit ? tr("(guessed)") : QString());
}

}  // namespace footfall
