// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/export_dialog.hpp"

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <limits>
#include <set>
#include <utility>

#include "core/io/formats/detour_export.hpp"
#include "core/io/formats/geojson_export.hpp"
#include "core/io/formats/save.hpp"
#include "footfall/up_axis.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/base/text/core_text.hpp"
#include "ui/base/text/counted_noun.hpp"
#include "ui/base/text/localized_numbers.hpp"
#include "ui/base/widgets/fitted_labels.hpp"
#include "ui/base/widgets/positive_number.hpp"
#include "ui/base/work/guarded_application.hpp"
#include "ui/window/export_files.hpp"
#include "ui/window/file_dialogs.hpp"
#include "ui/window/replace_question.hpp"

namespace footfall::ui {
namespace {

QCheckBox* addBox(QVBoxLayout* layout, const QString& id, const QString& text, const QString& help) {
  auto* box = new QCheckBox(text);
  box->setObjectName(id);
  box->setToolTip(help);
  layout->addWidget(box);
  return box;
}

/// The endings of all formats: ".obj, .gltf" and so on.
QString allEndings() {
  QStringList endings;
  for (const ExportTarget& target : exportTargets()) endings << QLatin1Char('.') + exportEnding(target.kind);
  endings.removeDuplicates();
  return endings.join(QStringLiteral(", "));
}

QLabel* addLabel(QWidget* parent, const char* id) {
  auto* label = new WrappedLabel(parent);
  label->setObjectName(QString::fromLatin1(id));
  return label;
}

QFormLayout* rowsOf(QWidget* widget) {
  auto* form = new QFormLayout(widget);
  form->setContentsMargins(0, 0, 0, 0);
  return form;
}

}  // namespace

ExportDialog::ExportDialog(ExportSource source, const ExportSettings& settings, const QString& path, QWidget* parent)
    : QDialog(parent), source_(std::move(source)), shown_(settings.target) {
  setObjectName(QStringLiteral("exportDialog"));
  setWindowTitle(tr("Export"));
  createWidgets();
  takeSettings(settings);
  path_->setText(path);
  takeName();
  path_->setFocus();
  path_->selectAll();
}

ExportDialog::~ExportDialog() {
  if (estimating_) estimating_->cancel();
}

void ExportDialog::createWidgets() {
  target_ = new QComboBox(this);
  target_->setObjectName(QStringLiteral("exportTarget"));
  target_->setToolTip(tr("What the file is for; options are remembered for each of them"));
  target_->setMaxVisibleItems(static_cast<int>(exportTargets().size()));
  for (const ExportTarget& target : exportTargets()) target_->addItem(targetName(target));
  keeps_ = addLabel(this, "exportKeeps");
  loses_ = addLabel(this, "exportLoses");
  path_ = new QLineEdit(this);
  path_->setObjectName(QStringLiteral("fileNameEdit"));
  path_->setToolTip(tr("The file to write; its ending chooses the format"));
  path_->setMinimumWidth(360);
  browse_ = new QPushButton(tr("Browse..."), this);
  browse_->setObjectName(QStringLiteral("exportBrowse"));
  browse_->setToolTip(tr("Choose the file in a dialog"));
  browse_->setAutoDefault(false);

  meshOptions_ = createMeshOptions();
  polygonOptions_ = createPolygonOptions();
  frameOptions_ = createFrameOptions();
  plan_ = new PlanChoices(this);
  plan_->setUnits(source_.units);
  pictureOptions_ = new QWidget(this);
  pictureSize_ = new QComboBox(pictureOptions_);
  pictureSize_->setObjectName(QStringLiteral("exportPictureSize"));
  pictureSize_->setToolTip(tr("Larger pictures have thicker lines, so that they look the same"));
  for (const PictureSize& size : pictureSizes(source_.view, source_.devicePixelRatio)) pictureSize_->addItem(size.name);
  rowsOf(pictureOptions_)->addRow(tr("Size"), pictureSize_);
  reportOptions_ = new QWidget(this);
  auto* report = new QVBoxLayout(reportOptions_);
  report->setContentsMargins(0, 0, 0, 0);
  pictures_ = addBox(report, QStringLiteral("exportPictures"), tr("Pictures: as seen now, from the top, and oblique"),
                     tr("They are part of the file"));
  bottlenecks_ = addBox(report, QStringLiteral("exportBottlenecks"), tr("Bottlenecks: the narrowest passages"),
                        tr("Their corridor map takes a while on large levels"));

  content_ = addLabel(this, "exportContent");
  size_ = addLabel(this, "exportSize");
  problem_ = addLabel(this, "rowError");
  createLayout();

  connect(target_, &QComboBox::activated, this, &ExportDialog::changeTarget);
  connect(path_, &QLineEdit::textEdited, this, &ExportDialog::readPath);
  connect(browse_, &QPushButton::clicked, this, &ExportDialog::browse);
  for (QCheckBox* box : {layers_, connections_, obstacleEdges_, steps_, drops_, placed_, pictures_, bottlenecks_})
    connect(box, &QCheckBox::toggled, this, &ExportDialog::refresh);
  for (QComboBox* box : {up_, pictureSize_})
    connect(box, &QComboBox::currentIndexChanged, this, &ExportDialog::refresh);
  connect(part_, &QSpinBox::valueChanged, this, &ExportDialog::refresh);
  connect(coordinateSystem_, &QLineEdit::textEdited, this, &ExportDialog::refresh);
  connect(plan_, &PlanChoices::changed, this, &ExportDialog::refresh);
  connect(scale_, &NumberField::valueEdited, this, &ExportDialog::refresh);
  connect(scale_, &NumberField::problemChanged, this, &ExportDialog::refresh);
}

QWidget* ExportDialog::createMeshOptions() {
  auto* options = new QWidget(this);
  auto* mesh = new QVBoxLayout(options);
  mesh->setContentsMargins(0, 0, 0, 0);
  layers_ = addBox(mesh, QStringLiteral("exportLayers"), {}, tr("Off: the whole walkable area as one"));
  connections_ = addBox(mesh, QStringLiteral("exportConnections"), tr("Connections as lines"),
                        tr("The edges on which two layers meet"));
  obstacleEdges_ = addBox(mesh, QStringLiteral("exportObstacleEdges"), tr("Obstacle edges as lines"),
                          tr("Edges that agents cannot cross though both sides are walkable"));
  steps_ = addBox(mesh, QStringLiteral("exportSteps"), {},
                  tr("Off: the file has no steps; floors that only steps join are separate"));
  drops_ = addBox(mesh, QStringLiteral("exportDrops"), tr("Drops as lines"),
                  tr("Lines from where an agent drops to where it lands"));
  placed_ = addBox(mesh, QStringLiteral("exportPlaced"), tr("Placed obstacles"),
                   tr("Each obstacle that was placed in the editor, as a group of its own"));
  placed_->setEnabled(!source_.placed.empty());
  return options;
}

QWidget* ExportDialog::createFrameOptions() {
  auto* options = new QWidget(this);
  QFormLayout* frame = rowsOf(options);
  up_ = new QComboBox(options);
  up_->setObjectName(QStringLiteral("exportUp"));
  up_->addItem(tr("As in the file"));
  for (const UpAxis up : kUpAxes) up_->addItem(tr("%1 up").arg(QString::fromStdString(shownName(up))));
  up_->setToolTip(tr("Which axis points up in an OBJ; other formats have one"));
  scale_ = new NumberField(positiveNumber("scale", "Scale", 1), options);
  scale_->setObjectName(QStringLiteral("exportScale"));
  scale_->setFixedWidth(96);
  scale_->setToolTip(
      tr("Coordinates are multiplied with it. 1 keeps the file's units (metres in all formats but OBJ), and OBJ exact; "
         "other scales "
         "than powers of two round once more."));
  frame->addRow(tr("Up axis"), up_);
  frame->addRow(tr("Scale"), scale_);
  return options;
}

QWidget* ExportDialog::createPolygonOptions() {
  auto* options = new QWidget(this);
  QFormLayout* form = rowsOf(options);
  part_ = new QSpinBox(options);
  part_->setObjectName(QStringLiteral("exportPart"));
  part_->setRange(0, std::numeric_limits<int>::max());
  part_->setSpecialValueText(tr("All"));
  part_->setToolTip(tr("One connected part alone, by its number in the panel Components; 1 is the largest"));
  coordinateSystem_ = new QLineEdit(options);
  coordinateSystem_->setObjectName(QStringLiteral("exportCoordinateSystem"));
  coordinateSystem_->setPlaceholderText(QStringLiteral("EPSG:25832"));
  coordinateSystem_->setToolTip(
      tr("The coordinate system that GeoJSON is to name, where the environment is in one; nothing is moved"));
  form->addRow(tr("Connected part"), part_);
  form->addRow(tr("Coordinate system"), coordinateSystem_);
  return options;
}

void ExportDialog::createLayout() {
  auto* buttons = new QDialogButtonBox(this);
  export_ = buttons->addButton(tr("Export"), QDialogButtonBox::AcceptRole);
  export_->setObjectName(QStringLiteral("exportAccept"));
  export_->setDefault(true);
  QPushButton* cancel = buttons->addButton(QDialogButtonBox::Cancel);
  cancel->setObjectName(QStringLiteral("exportCancel"));
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(buttons, &QDialogButtonBox::accepted, this, &ExportDialog::requestExport);

  auto* pathRow = new QHBoxLayout;
  pathRow->addWidget(path_, 1);
  pathRow->addWidget(browse_);
  form_ = new QFormLayout;
  form_->addRow(tr("For"), target_);
  form_->addRow(tr("Keeps"), keeps_);
  form_->addRow(tr("Loses"), loses_);
  form_->addRow(tr("File"), pathRow);
  form_->addRow(tr("Content"), meshOptions_);
  for (QWidget* options :
       {polygonOptions_, frameOptions_, static_cast<QWidget*>(plan_), pictureOptions_, reportOptions_})
    form_->addRow(QString(), options);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(form_);
  layout->addWidget(content_);
  layout->addWidget(size_);
  layout->addWidget(problem_);
  layout->addStretch(1);
  layout->addWidget(buttons);
  setTabOrder(target_, path_);
}

void ExportDialog::takeSettings(const ExportSettings& settings) {
  shown_ = settings.target;
  target_->setCurrentIndex(static_cast<int>(settings.target - exportTargets().data()));
  layers_->setChecked(settings.options.layers);
  connections_->setChecked(settings.options.connections);
  obstacleEdges_->setChecked(settings.options.obstacleEdges);
  steps_->setChecked(settings.options.steps);
  drops_->setChecked(settings.options.drops);
  placed_->setChecked(settings.placed && !source_.placed.empty());
  const auto& up = settings.options.up;
  up_->setCurrentIndex(up ? static_cast<int>(std::ranges::find(kUpAxes, *up) - kUpAxes.begin()) + 1 : 0);
  scale_->setValue(settings.options.scale);
  part_->setValue(settings.options.part ? static_cast<int>(*settings.options.part) + 1 : 0);
  coordinateSystem_->setText(QString::fromStdString(settings.options.coordinateSystem));
  plan_->setOptions(settings.plan);
  pictureSize_->setCurrentIndex(settings.pictureSize);
  pictures_->setChecked(settings.pictures);
  bottlenecks_->setChecked(settings.bottlenecks);
}

const ExportTarget& ExportDialog::target() const {
  return exportTargets()[static_cast<std::size_t>(target_->currentIndex())];
}

ExportSettings ExportDialog::settings() const {
  ExportSettings settings;
  settings.target = shown_;
  const FormatDescriptor* format = meshFormat(shown_->kind);
  ExportOptions& options = settings.options;
  options.layers = layers_->isChecked();
  options.connections = connections_->isChecked();
  options.obstacleEdges = obstacleEdges_->isChecked();
  options.steps = steps_->isChecked();
  options.drops = drops_->isChecked();
  options.scale = scale_->value();
  options.godot = shown_->godot;
  options.navmeshNode = shown_->navmeshNode;
  if (format && format->hasFrame && up_->currentIndex() > 0)
    options.up = kUpAxes[static_cast<std::size_t>(up_->currentIndex()) - 1];
  if (format && format->hasParts && part_->value() > 0) options.part = static_cast<std::uint32_t>(part_->value()) - 1;
  if (format && format->hasCoordinateSystem)
    options.coordinateSystem = coordinateSystem_->text().trimmed().toStdString();
  settings.placed = placed_->isChecked() && (!format || format->hasExtras);
  settings.plan = plan_->options();
  settings.pictureSize = pictureSize_->currentIndex();
  settings.pictures = pictures_->isChecked();
  settings.bottlenecks = bottlenecks_->isChecked();
  return settings;
}

QString ExportDialog::path() const {
  const QString text = path_->text().trimmed();
  if (text.isEmpty() || !QFileInfo(text).suffix().isEmpty()) return text;
  return text + QLatin1Char('.') + exportEnding(kind());
}

/// Restores the options that this target had last, and gives the name the target's ending.
void ExportDialog::changeTarget() {
  const ExportTarget& next = target();
  if (&next != shown_) {
    settings_[shown_] = settings();
    const auto known = settings_.find(&next);
    takeSettings(known == settings_.end() ? rememberedExport(next) : known->second);
  }
  takeName();
}

/// Updates the name for the target: its ending is replaced where it is one of an export format.
void ExportDialog::takeName() {
  const QString text = path_->text();
  const QString ending = QFileInfo(text).suffix();
  for (const ExportTarget& other : exportTargets())
    if (ending.toLower() == exportEnding(other.kind)) {
      path_->setText(text.left(text.size() - ending.size()) + exportEnding(kind()));
      break;
    }
  refresh();
}

/// Updates the target for the name.
void ExportDialog::readPath() {
  const ExportTarget& next = exportTargetOf(path_->text(), target());
  if (&next == shown_) return refresh();
  settings_[shown_] = settings();
  const auto known = settings_.find(&next);
  takeSettings(known == settings_.end() ? rememberedExport(next) : known->second);
  refresh();
}

void ExportDialog::browse() {
  const QString ending = exportEnding(kind());
  askForTarget(this, tr("Export"), QStringLiteral("%1 (*.%2)").arg(ending.toUpper(), ending), path(), ending,
               [this](const QString& file) {
                 path_->setText(file);
                 readPath();
               });
}

QStringList ExportDialog::existing() const {
  if (!hasFilesBeside(kind())) return {path()};
  QStringList files;
  for (const std::string& file : existingOutputs(toPath(path()))) files << fromPath(file);
  return files;
}

void ExportDialog::requestExport() {
  if (!problem().isEmpty()) return refresh();
  const QStringList files = existing();
  askReplacing(this, files, [this, files] {
    ExportSettings chosen = settings();
    chosen.replaceable = std::make_shared<std::set<std::string>>();
    for (const QString& file : files) chosen.replaceable->insert(toPath(file));
    emit exportRequested(path(), chosen);
    accept();
  });
}

QString ExportDialog::problem() const {
  const QString file = path();
  if (file.isEmpty()) return tr("Give a name for the file.");
  const QFileInfo info(file);
  for (const QString& name : {path_->text().trimmed(), file})
    if (QFileInfo(name).isDir()) return tr("%1 is a folder; give the name of a file in it.").arg(name);
  if (info.suffix().toLower() != exportEnding(kind()))
    return tr("\".%1\" is no format that can be written; the name must end in one of %2.")
        .arg(info.suffix(), allEndings());
  if (kind() == ExportKind::Detour && !hasDetour())
    return tr("This program was built without Detour and cannot write .bin; choose another target.");
  const QString refused = source_.refusal ? source_.refusal(file) : QString();
  if (!refused.isEmpty()) return refused;
  const QString unwritable = errorOf([&] {
    const std::string name = toPath(file);
    checkWritable(name);
    if (meshFormat(kind())) checkReplaced(name);
  });
  if (!unwritable.isEmpty()) return unwritable;
  if (!meshOptions_->isHidden() && !scale_->problem().isEmpty()) return tr("Scale: %1").arg(scale_->problem());
  if (isPlan(kind()) && !plan_->problem().isEmpty()) return plan_->problem();
  const FormatDescriptor* format = meshFormat(kind());
  return format ? errorOf([&] { checkOptions(format->format, settings().options); }) : QString();
}

QString ExportDialog::content() const {
  if (kind() == ExportKind::Png) return tr("The view as it is now, with what tools have drawn, without panels.");
  if (!source_.run) return tr("The result of the run under way.");
  QString text;
  if (kind() == ExportKind::Html) {
    QStringList parts{
        countedText(source_.run->result.mesh->triangles.size(), tr("triangle"), tr("triangles")),
        countedText(source_.run->result.steps.size(), tr("step with its times"), tr("steps with their times"))};
    if (pictures_->isChecked()) parts << tr("three pictures");
    if (bottlenecks_->isChecked()) parts << tr("bottlenecks");
    text = tr("Figures of a result with %1.").arg(parts.join(QStringLiteral(", ")));
  } else if (const FormatDescriptor* format = meshFormat(kind())) {
    text = meshContent(*format);
  }
  if (!source_.isUpToDate)
    text += (text.isEmpty() ? QString() : QStringLiteral("\n")) + tr("The export waits for the run under way.");
  return text;
}

QString ExportDialog::meshContent(const FormatDescriptor& format) const {
  const NavigationMesh& mesh = *source_.run->result.mesh;
  QStringList parts;
  if (!format.hasParts) parts << countedText(mesh.triangles.size(), tr("triangle"), tr("triangles"));
  if (format.hasLayers && layers_->isChecked() && !shown_->navmeshNode)
    parts << countedText(mesh.layerCount, tr("layer"), tr("layers"));
  if (format.hasLines && connections_->isChecked())
    parts << countedText(mesh.connections.size(), tr("connection"), tr("connections"));
  if (format.hasLines && obstacleEdges_->isChecked())
    parts << countedText(mesh.obstacleEdges.size(), tr("obstacle edge"), tr("obstacle edges"));
  const auto gaps = static_cast<std::size_t>(std::ranges::count(mesh.links, StepKind::Gap, &StepLink::kind));
  if (steps_->isChecked() && gaps < mesh.links.size())
    parts << countedText(mesh.links.size() - gaps, tr("step"), tr("steps"));
  if (steps_->isChecked() && gaps > 0) parts << countedText(gaps, tr("gap"), tr("gaps"));
  if (format.hasDrops && drops_->isChecked() && !mesh.drops.empty())
    parts << countedText(mesh.drops.size(), tr("drop"), tr("drops"));
  if (format.hasExtras && placed_->isChecked())
    parts << countedText(source_.placed.size(), tr("placed obstacle"), tr("placed obstacles"));
  return parts.isEmpty() ? tr("Polygons.") : parts.join(QStringLiteral(", ")) + QLatin1Char('.');
}

void ExportDialog::refresh() {
  const FormatDescriptor* format = meshFormat(kind());
  const bool isMesh = format != nullptr;
  if (format) {
    layers_->setText(coreText(Text(format->layersAs)));
    steps_->setText(coreText(Text(format->stepsAs)));
    layers_->setVisible(format->hasLayers && !shown_->navmeshNode);
    for (QCheckBox* box : {connections_, obstacleEdges_}) box->setVisible(format->hasLines);
    drops_->setVisible(format->hasDrops);
    placed_->setVisible(format->hasExtras);
    static_cast<QFormLayout*>(frameOptions_->layout())->setRowVisible(up_, format->hasFrame);
    static_cast<QFormLayout*>(polygonOptions_->layout())->setRowVisible(coordinateSystem_, format->hasCoordinateSystem);
  }
  keeps_->setText(keptBy(kind()));
  loses_->setText(lostBy(kind()));
  form_->setRowVisible(keeps_, !keeps_->text().isEmpty());
  form_->setRowVisible(loses_, !loses_->text().isEmpty());
  form_->setRowVisible(meshOptions_, isMesh);
  form_->setRowVisible(frameOptions_, isMesh);
  form_->setRowVisible(polygonOptions_, isMesh && format->hasParts);
  form_->setRowVisible(plan_, isPlan(kind()));
  form_->setRowVisible(pictureOptions_, kind() == ExportKind::Png);
  form_->setRowVisible(reportOptions_, kind() == ExportKind::Html);
  content_->setText(content());
  content_->setVisible(!content_->text().isEmpty());
  const QString why = problem();
  problem_->setText(why);
  problem_->setVisible(!why.isEmpty());
  export_->setEnabled(why.isEmpty());
  estimate();
  fitHeight();
}

void ExportDialog::showEvent(QShowEvent* event) {
  QDialog::showEvent(event);
  fitHeight();
}

void ExportDialog::fitHeight() {
  layout()->activate();
  resize(width(), std::max(height(), layout()->totalHeightForWidth(width())));
}

void ExportDialog::estimate() {
  if (estimating_) estimating_->cancel();
  estimating_.reset();
  const bool isMade = meshFormat(kind()) || isPlan(kind());
  const bool isWrong = !scale_->problem().isEmpty() || (isPlan(kind()) && !plan_->problem().isEmpty());
  if (!isMade || !source_.run || !source_.isUpToDate || isWrong) {
    size_->clear();
    return;
  }
  size_->setText(tr("Size: ..."));
  estimating_ = std::make_shared<RunContext>();
  queue_.post([this, context = estimating_, run = source_.run, all = settings(), name = toPath(path()),
               placed = source_.placed] {
    QString text;
    try {
      context->checkCancelled();
      const std::vector<ExportExtra> extras = all.placed ? placed : std::vector<ExportExtra>();
      const ExportFiles made = makeExport(all, name, *run, extras, *context);
      std::size_t bytes = 0;
      for (const OutputFile& file : made.files) bytes += file.bytes.size();
      text = tr("Size: %1").arg(numberLocale().formattedDataSize(static_cast<qint64>(bytes)));
      if (made.files.size() > 1)
        text += QStringLiteral("; ") + tr("%1 files, the first is %2")
                                           .arg(made.files.size())
                                           .arg(QFileInfo(fromPath(made.files.front().path)).fileName());
      if (made.largestError > 0)
        text += QStringLiteral("; ") +
                tr("The format has floats: coordinates move by up to %1 m").arg(shortText(made.largestError, 2));
    } catch (const Cancelled&) {
      return;
    } catch (const std::exception& problem) {
      text = coreText(problem);
    }
    QMetaObject::invokeMethod(
        this,
        [this, context, text] {
          if (context != estimating_) return;
          size_->setText(text);
          fitHeight();
        },
        Qt::QueuedConnection);
  });
}

}  // namespace footfall::ui
