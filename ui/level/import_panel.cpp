// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/level/import_panel.hpp"

#include <QClipboard>
#include <QFileInfo>
#include <QFormLayout>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QVBoxLayout>
#include <algorithm>
#include <array>

#include "core/io/ifc_reader.hpp"
#include "footfall/up_axis.hpp"
#include "ui/base/commands/keys_back.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/base/text/core_text.hpp"
#include "ui/base/text/counted_noun.hpp"
#include "ui/base/text/localized_numbers.hpp"
#include "ui/base/widgets/fitted_labels.hpp"
#include "ui/base/widgets/flow_layout.hpp"
#include "ui/base/widgets/positive_number.hpp"
#include "ui/level/scale_question.hpp"

namespace footfall::ui {
ImportPanel::ImportPanel(QWidget* parent) : QWidget(parent) {
  name_ = new ElidedLabel(tr("Nothing loaded"), this);
  name_->setObjectName(QStringLiteral("environmentName"));
  name_->setTextFormat(Qt::PlainText);
  figures_ = new WrappedLabel(this);
  figures_->setText(tr("Open a file (Ctrl+O), or drop one here."));
  figures_->setObjectName(QStringLiteral("environmentFigures"));
  copyCommand_ = new QPushButton(tr("Copy the command"), this);
  copyCommand_->setObjectName(QStringLiteral("copyIfcCommand"));
  copyCommand_->setToolTip(
      tr("Copy the command that installs the converter for IFC files. Paste it into a terminal, then open the file "
         "again"));
  giveKeysBackAfterClick(*copyCommand_);
  connect(copyCommand_, &QPushButton::clicked, this,
          [] { QGuiApplication::clipboard()->setText(QString::fromStdString(ifcInstallCommand().value_or(""))); });

  up_ = new QComboBox(this);
  up_->setObjectName(QStringLiteral("upAxis"));
  up_->addItem(tr("Guess"));
  for (const UpAxis up : kUpAxes) up_->addItem(upAxisText(up));
  up_->setToolTip(tr("Which axis of the file points up; places are shown along the axes of the file"));
  scale_ = new NumberField(positiveNumber("scale", "Metres per unit", 1), this);
  scale_->setObjectName(QStringLiteral("scale"));
  scale_->setFixedWidth(90);
  scale_->setToolTip(tr(
      "How many metres one unit of the file is. Coordinates are never scaled: lengths are shown and typed in metres, "
      "and filters that still have their defaults follow."));
  scaleNote_ = new QLabel(this);
  scaleError_ = new WrappedLabel(this);
  scaleError_->setObjectName(QStringLiteral("rowError"));
  scaleError_->hide();
  grid_ = new QComboBox(this);
  grid_->setObjectName(QStringLiteral("grid"));
  for (const QString& choice : {tr("Automatic"), tr("On"), tr("Off")}) grid_->addItem(choice);
  grid_->setToolTip(
      tr("Rounds coordinates to a fine grid. Automatic: for files that store floats, such as glTF and FBX; what should "
         "lie in one plane then does."));
  bothSides_ = new QCheckBox(tr("Both sides count as up"), this);
  bothSides_->setObjectName(QStringLiteral("bothSides"));
  bothSides_->setToolTip(
      tr("For files whose triangles face the wrong way: triangles that face down also count as facing up."));
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
  form->addRow(tr("Grid"), grid_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(10, 6, 8, 8);
  layout->setSpacing(4);
  layout->addWidget(name_);
  layout->addWidget(figures_);
  layout->addWidget(copyCommand_, 0, Qt::AlignLeft);
  layout->addLayout(form);
  layout->addWidget(scaleError_);
  layout->addWidget(makeQuestion());
  auto* boxes = new FlowLayout(6);
  boxes->addWidget(bothSides_);
  boxes->addWidget(watch_);
  layout->addLayout(boxes);

  connect(up_, &QComboBox::activated, this, [this](int index) {
    options_.up = index == 0 ? std::nullopt : std::optional(kUpAxes[static_cast<std::size_t>(index) - 1]);
    emit optionsEdited(options_);
  });
  connect(scale_, &NumberField::valueEdited, this, &ImportPanel::setScale);
  connect(scale_, &NumberField::problemChanged, this, [this] {
    scaleError_->setText(scale_->problem());
    scaleError_->setVisible(!scale_->problem().isEmpty());
  });
  connect(grid_, &QComboBox::activated, this, [this](int index) {
    options_.grid = static_cast<GridChoice>(index);
    emit optionsEdited(options_);
  });
  connect(bothSides_, &QCheckBox::clicked, this, [this](bool on) {
    options_.bothSides = on;
    emit optionsEdited(options_);
  });
  setEnvironment(nullptr, {}, false, false);
}

QWidget* ImportPanel::makeQuestion() {
  questionRow_ = new QWidget(this);
  question_ = new QLabel(questionRow_);
  question_->setObjectName(QStringLiteral("scaleQuestion"));
  question_->setWordWrap(true);
  question_->setToolTip(
      tr("The file does not state its unit. Once the scale is known, all lengths are shown and typed in metres (or in "
         "the unit of View > Lengths in)."));
  yes_ = new QPushButton(tr("Yes"), questionRow_);
  yes_->setObjectName(QStringLiteral("confirmScale"));
  no_ = new QPushButton(questionRow_);
  no_->setObjectName(QStringLiteral("keepScale"));
  auto* row = new QHBoxLayout(questionRow_);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(question_, 1);
  row->addWidget(yes_);
  row->addWidget(no_);
  for (QPushButton* button : {yes_, no_}) giveKeysBackAfterClick(*button);
  connect(yes_, &QPushButton::clicked, this, [this] { setScale(askAboutScale(size_, fileScale_, evidence_).scale); });
  connect(no_, &QPushButton::clicked, this, [this] { setScale(fileScale_); });
  return questionRow_;
}

void ImportPanel::setScale(double metresPerUnit) {
  options_.metresPerUnit = metresPerUnit;
  showGuesses();
  emit optionsEdited(options_);
}

void ImportPanel::addBelowFigures(QWidget* widget) {
  auto* rows = static_cast<QVBoxLayout*>(layout());
  rows->insertWidget(rows->indexOf(figures_) + 1, widget);
}

void ImportPanel::setOptions(const ImportOptions& options) {
  options_ = options;
  const auto place = options.up ? std::ranges::find(kUpAxes, *options.up) - kUpAxes.begin() + 1 : 0;
  up_->setCurrentIndex(static_cast<int>(place));
  // A step can be given on the command line only; it is listed while it is the choice.
  const int steps = static_cast<int>(GridChoice::Step);
  while (grid_->count() > steps) grid_->removeItem(steps);
  if (options.grid == GridChoice::Step) grid_->addItem(tr("Step %1").arg(numberText(options.gridStep)));
  grid_->setCurrentIndex(static_cast<int>(options.grid));
  bothSides_->setChecked(options.bothSides);
  showGuesses();
}

void ImportPanel::setEvidence(const std::optional<ScaleEvidence>& evidence) {
  evidence_ = evidence;
  showQuestion();
}

void ImportPanel::setPart(std::uint64_t triangles, std::uint64_t ofAll) {
  counts_ = tr("Part: %1 of %2 triangles").arg(countText(triangles), countText(ofAll));
  showFigures();
}

void ImportPanel::setEnvironment(const Environment* environment, const Vec3& size, bool upGiven, bool scaleGiven) {
  loaded_ = environment != nullptr;
  for (QWidget* widget : {static_cast<QWidget*>(up_), static_cast<QWidget*>(scale_), static_cast<QWidget*>(grid_),
                          static_cast<QWidget*>(bothSides_)}) {
    widget->setEnabled(loaded_);
  }
  const QString advice = coreText(adviceOnIfcConverter());
  copyCommand_->setVisible(
      environment && ifcInstallCommand() &&
      std::ranges::any_of(environment->notes, [&](const Text& note) { return coreText(note).endsWith(advice); }));
  if (environment) {
    const QString path = QString::fromStdString(environment->source);
    name_->setText(QFileInfo(path).fileName());
    name_->setToolTip(path);
    counts_ = countedText(environment->triangles.size(), tr("triangle"), tr("triangles")) + QStringLiteral(", ") +
              countedText(environment->vertices.size(), tr("vertex"), tr("vertices"));
    size_ = size;
    evidence_.reset();
    const SkippedElements& skipped = environment->skipped;
    QStringList left;
    // The button below the figures counts the polygons.
    if (skipped.lines > 0) left << countedText(skipped.lines, tr("line"), tr("lines"));
    if (skipped.points > 0) left << countedText(skipped.points, tr("point"), tr("points"));
    QStringList lines;
    if (!left.isEmpty()) lines << tr("Skipped: %1").arg(left.join(QStringLiteral(", ")));
    for (const Text& note : environment->notes) lines << coreText(note);
    notes_ = lines.join(QLatin1Char('\n'));
    showGrid(*environment);
    showFigures();
    // A value of the user is not kept as the guess to return to.
    if (!upGiven) {
      fileUp_ = environment->up;
      upGuessed_ = environment->upGuessed;
    }
    if (!scaleGiven) {
      fileScale_ = environment->metresPerUnit;
      scaleGuessed_ = environment->scaleGuessed;
    }
  }
  showGuesses();
}

void ImportPanel::showGuesses() {
  const QString fileUp = upGuessed_ ? tr("%1 (guessed)") : tr("%1 (from the file)");
  up_->setItemText(0, loaded_ && !options_.up ? fileUp.arg(upAxisText(fileUp_)) : tr("Guess"));
  scale_->setValue(options_.metresPerUnit.value_or(fileScale_));
  scaleNote_->setText(!loaded_ || options_.metresPerUnit ? QString()
                      : scaleGuessed_                    ? tr("(guessed)")
                                                         : tr("(from the file)"));
  showQuestion();
}

void ImportPanel::showGrid(const Environment& environment) {
  const CoordinateGrid& grid = environment.grid;
  gridText_ =
      grid.step == 0
          ? QString()
          : tr("Grid of %1, moved by at most %2").arg(shortText(grid.step, 3), shortText(grid.largestMovement, 2));
  if (grid.weldedVertices > 0)
    gridText_ += QStringLiteral("; ") + tr("welded vertices: %1").arg(countText(grid.weldedVertices));
}

void ImportPanel::showQuestion() {
  const bool asked = loaded_ && scaleGuessed_ && !options_.metresPerUnit;
  questionRow_->setVisible(asked);
  if (!asked) return;
  const ScaleQuestion question = askAboutScale(size_, fileScale_, evidence_);
  question_->setText(question.text);
  yes_->setToolTip(tr("1 unit of the file is %1").arg(unitLengthText(question.scale)));
  no_->setVisible(question.guess.has_value());
  no_->setText(tr("No, %1").arg(unitLengthText(fileScale_)));
  no_->setToolTip(tr("1 unit of the file is %1").arg(unitLengthText(fileScale_)));
}

void ImportPanel::setUnits(const LevelUnits& units) {
  units_ = units;
  if (loaded_) showFigures();
}

// The sizes are in the order of the file's axes.
void ImportPanel::showFigures() {
  const std::array<double, 3> sizes{size_.x, size_.y, size_.z};
  std::array<double, 3> shown{};
  for (int axis = 0; axis < 3; ++axis)
    shown[static_cast<std::size_t>(units_.fileAxis(axis).axis)] =
        sizes[static_cast<std::size_t>(axis)] * units_.factor();
  QString figures =
      counts_ + QLatin1Char('\n') +
      tr("%1 × %2 × %3 %4 (%5)")
          .arg(shortText(shown[0], 4), shortText(shown[1], 4), shortText(shown[2], 4), units_.name(), units_.upText());
  if (!gridText_.isEmpty()) figures += QLatin1Char('\n') + gridText_;
  if (!notes_.isEmpty()) figures += QLatin1Char('\n') + notes_;
  figures_->setText(figures);
}

}  // namespace footfall::ui
