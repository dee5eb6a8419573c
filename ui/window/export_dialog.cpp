// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/export_dialog.hpp"

#include <QDialogButtonBox>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "core/io/formats/save.hpp"
#include "footfall/report.hpp"
#include "footfall/up_axis.hpp"
#include "ui/base/core_text.hpp"
#include "ui/base/counted_text.hpp"
#include "ui/base/guarded_application.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/base/number_text.hpp"
#include "ui/base/positive_number.hpp"
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

/// ".obj, .gltf" and so on.
QString allEndings() {
  QStringList endings;
  for (const ExportKind kind : kExportKinds) endings << QLatin1Char('.') + exportEnding(kind);
  return endings.join(QStringLiteral(", "));
}

}  // namespace

ExportDialog::ExportDialog(ExportSource source, const ExportSettings& settings, const QString& path, QWidget* parent)
    : QDialog(parent), source_(std::move(source)) {
  setObjectName(QStringLiteral("exportDialog"));
  setWindowTitle(tr("Export"));
  createWidgets();
  takeSettings(settings);
  path_->setText(path);
  changeKind();
  path_->setFocus();
  path_->selectAll();
}

ExportDialog::~ExportDialog() {
  if (estimating_) estimating_->cancel();
}

void ExportDialog::createWidgets() {
  kind_ = new QComboBox(this);
  kind_->setObjectName(QStringLiteral("exportFormat"));
  kind_->setToolTip(tr("The format of the file"));
  for (const ExportKind kind : kExportKinds) kind_->addItem(exportName(kind));
  path_ = new QLineEdit(this);
  path_->setObjectName(QStringLiteral("fileNameEdit"));
  path_->setToolTip(tr("The file to write; its ending chooses the format"));
  path_->setMinimumWidth(360);
  browse_ = new QPushButton(tr("Browse..."), this);
  browse_->setObjectName(QStringLiteral("exportBrowse"));
  browse_->setToolTip(tr("Choose the file in a dialog"));
  browse_->setAutoDefault(false);
  auto* pathRow = new QHBoxLayout;
  pathRow->addWidget(path_, 1);
  pathRow->addWidget(browse_);

  meshOptions_ = new QWidget(this);
  auto* mesh = new QVBoxLayout(meshOptions_);
  mesh->setContentsMargins(0, 0, 0, 0);
  layers_ = addBox(mesh, QStringLiteral("exportLayers"), tr("A group for each layer"),
                   tr("Off: all walkable triangles in one group"));
  connections_ = addBox(mesh, QStringLiteral("exportConnections"), tr("Connections as lines"),
                        tr("The edges on which two layers meet"));
  obstacleEdges_ = addBox(mesh, QStringLiteral("exportObstacleEdges"), tr("Obstacle edges as lines"),
                          tr("Edges that agents cannot cross though both sides are walkable"));
  steps_ = addBox(mesh, QStringLiteral("exportSteps"), tr("Steps as faces"),
                  tr("Faces between the two borders of each step, over their vertices"));
  drops_ = addBox(mesh, QStringLiteral("exportDrops"), tr("Drops as lines"),
                  tr("Lines from where an agent drops to where it lands"));
  placed_ = addBox(mesh, QStringLiteral("exportPlaced"), tr("Placed obstacles"),
                   tr("Each obstacle that was placed in the editor, as a group of its own"));
  placed_->setEnabled(!source_.placed.empty());

  frameOptions_ = new QWidget(this);
  auto* frame = new QFormLayout(frameOptions_);
  frame->setContentsMargins(0, 0, 0, 0);
  up_ = new QComboBox(frameOptions_);
  up_->setObjectName(QStringLiteral("exportUp"));
  up_->addItem(tr("As in the file"));
  for (const UpAxis up : kUpAxes) up_->addItem(tr("%1 up").arg(QString::fromStdString(shownName(up))));
  up_->setToolTip(tr("Which axis points up in the export; all formats but OBJ are always Y up"));
  scale_ = new NumberField(positiveNumber("scale", "Scale", 1), frameOptions_);
  scale_->setObjectName(QStringLiteral("exportScale"));
  scale_->setFixedWidth(96);
  scale_->setToolTip(
      tr("Coordinates are multiplied with it. 1 keeps the file's units (metres in all formats but OBJ), and OBJ exact; "
         "other scales "
         "than powers of two round once more."));
  frame->addRow(tr("Up axis"), up_);
  frame->addRow(tr("Scale"), scale_);

  pictureOptions_ = new QWidget(this);
  auto* picture = new QFormLayout(pictureOptions_);
  picture->setContentsMargins(0, 0, 0, 0);
  pictureSize_ = new QComboBox(pictureOptions_);
  pictureSize_->setObjectName(QStringLiteral("exportPictureSize"));
  pictureSize_->setToolTip(tr("Larger pictures have thicker lines, so that they look the same"));
  for (const PictureSize& size : pictureSizes(source_.view, source_.devicePixelRatio)) pictureSize_->addItem(size.name);
  picture->addRow(tr("Size"), pictureSize_);

  reportOptions_ = new QWidget(this);
  auto* report = new QVBoxLayout(reportOptions_);
  report->setContentsMargins(0, 0, 0, 0);
  pictures_ = addBox(report, QStringLiteral("exportPictures"), tr("Pictures: as seen now, from the top, and oblique"),
                     tr("They are part of the file"));

  content_ = new QLabel(this);
  content_->setObjectName(QStringLiteral("exportContent"));
  content_->setWordWrap(true);
  size_ = new QLabel(this);
  size_->setObjectName(QStringLiteral("exportSize"));
  problem_ = new QLabel(this);
  problem_->setObjectName(QStringLiteral("rowError"));
  problem_->setWordWrap(true);

  auto* buttons = new QDialogButtonBox(this);
  export_ = buttons->addButton(tr("Export"), QDialogButtonBox::AcceptRole);
  export_->setObjectName(QStringLiteral("exportAccept"));
  export_->setDefault(true);
  QPushButton* cancel = buttons->addButton(QDialogButtonBox::Cancel);
  cancel->setObjectName(QStringLiteral("exportCancel"));

  auto* form = new QFormLayout;
  form->addRow(tr("File"), pathRow);
  form->addRow(tr("Format"), kind_);
  form->addRow(tr("Content"), meshOptions_);
  form->addRow(QString(), reportOptions_);
  form->addRow(QString(), frameOptions_);
  form->addRow(QString(), pictureOptions_);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(form);
  layout->addWidget(content_);
  layout->addWidget(size_);
  layout->addWidget(problem_);
  layout->addStretch(1);
  layout->addWidget(buttons);

  connect(kind_, &QComboBox::activated, this, &ExportDialog::changeKind);
  connect(path_, &QLineEdit::textEdited, this, &ExportDialog::readPath);
  connect(browse_, &QPushButton::clicked, this, &ExportDialog::browse);
  for (QCheckBox* box : {layers_, connections_, obstacleEdges_, steps_, drops_, placed_, pictures_})
    connect(box, &QCheckBox::toggled, this, &ExportDialog::refresh);
  for (QComboBox* box : {up_, pictureSize_})
    connect(box, &QComboBox::currentIndexChanged, this, &ExportDialog::refresh);
  connect(scale_, &NumberField::valueEdited, this, &ExportDialog::refresh);
  connect(scale_, &NumberField::problemChanged, this, &ExportDialog::refresh);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(buttons, &QDialogButtonBox::accepted, this, [this] {
    if (!problem().isEmpty()) return refresh();
    askReplacing(this, path(), [this] {
      emit exportRequested(path(), settings());
      accept();
    });
  });
}

void ExportDialog::takeSettings(const ExportSettings& settings) {
  kind_->setCurrentIndex(static_cast<int>(settings.kind));
  layers_->setChecked(settings.options.layers);
  connections_->setChecked(settings.options.connections);
  obstacleEdges_->setChecked(settings.options.obstacleEdges);
  steps_->setChecked(settings.options.steps);
  drops_->setChecked(settings.options.drops);
  placed_->setChecked(settings.placed && !source_.placed.empty());
  const auto& up = settings.options.up;
  up_->setCurrentIndex(up ? static_cast<int>(std::ranges::find(kUpAxes, *up) - kUpAxes.begin()) + 1 : 0);
  scale_->setValue(settings.options.scale);
  pictureSize_->setCurrentIndex(settings.pictureSize);
  pictures_->setChecked(settings.pictures);
}

ExportKind ExportDialog::kind() const { return kExportKinds[static_cast<std::size_t>(kind_->currentIndex())]; }

ExportSettings ExportDialog::settings() const {
  ExportSettings settings;
  settings.kind = kind();
  settings.options.layers = layers_->isChecked();
  settings.options.connections = connections_->isChecked();
  settings.options.obstacleEdges = obstacleEdges_->isChecked();
  settings.options.steps = steps_->isChecked();
  settings.options.drops = drops_->isChecked();
  if (kind() == ExportKind::Obj && up_->currentIndex() > 0)
    settings.options.up = kUpAxes[static_cast<std::size_t>(up_->currentIndex()) - 1];
  settings.options.scale = scale_->value();
  settings.placed = placed_->isChecked() && (!meshFormat(kind()) || meshFormat(kind())->hasExtras);
  settings.pictureSize = pictureSize_->currentIndex();
  settings.pictures = pictures_->isChecked();
  return settings;
}

QString ExportDialog::path() const {
  const QString text = path_->text().trimmed();
  if (text.isEmpty() || !QFileInfo(text).suffix().isEmpty()) return text;
  return text + QLatin1Char('.') + exportEnding(kind());
}

/// The name follows the format: another ending, where it has one of ours.
void ExportDialog::changeKind() {
  const QString text = path_->text();
  const QString ending = QFileInfo(text).suffix();
  for (const ExportKind kind : kExportKinds)
    if (ending.toLower() == exportEnding(kind))
      path_->setText(text.left(text.size() - ending.size()) + exportEnding(this->kind()));
  refresh();
}

/// The format follows the name.
void ExportDialog::readPath() {
  kind_->setCurrentIndex(static_cast<int>(exportKindOf(path_->text(), kind())));
  refresh();
}

void ExportDialog::browse() {
  auto* dialog = new QFileDialog(this, tr("Export"), QFileInfo(path()).path());
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setOption(QFileDialog::DontConfirmOverwrite);
  dialog->setNameFilter(
      QStringLiteral("%1 (*.%2)").arg(exportName(kind()).section(QLatin1Char(':'), 0, 0), exportEnding(kind())));
  dialog->setDefaultSuffix(exportEnding(kind()));
  dialog->selectFile(QFileInfo(path()).fileName());
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& file) {
    path_->setText(file);
    readPath();
  });
  dialog->open();
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
  const QString refused = source_.refusal ? source_.refusal(file) : QString();
  if (!refused.isEmpty()) return refused;
  const QString unwritable = errorOf([&] {
    const std::string name = QFile::encodeName(file).toStdString();
    checkWritable(name);
    if (meshFormat(kind())) checkReplaced(name);
  });
  if (!unwritable.isEmpty()) return unwritable;
  if (!meshOptions_->isHidden() && !scale_->problem().isEmpty()) return tr("Scale: %1").arg(scale_->problem());
  return {};
}

QString ExportDialog::content() const {
  if (kind() == ExportKind::Png) return tr("The view as it is now, with what tools have drawn, without panels.");
  if (!source_.run) return tr("The result of the run under way.");
  const NavigationMesh& mesh = *source_.run->result.mesh;
  QStringList parts{countedText(mesh.triangles.size(), tr("triangle"), tr("triangles"))};
  if (kind() == ExportKind::Html) {
    parts << countedText(source_.run->result.steps.size(), tr("step with its times"), tr("steps with their times"));
    if (pictures_->isChecked()) parts << tr("three pictures");
    return tr("Figures of a result with %1.").arg(parts.join(QStringLiteral(", ")));
  }
  const FormatDescriptor& format = *meshFormat(kind());
  if (format.hasLayers && layers_->isChecked()) parts << countedText(mesh.layerCount, tr("layer"), tr("layers"));
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
  return parts.join(QStringLiteral(", ")) + QLatin1Char('.') + QLatin1Char('\n') +
         tr("The format loses: %1.").arg(coreText(Text(format.loses))) +
         (source_.isUpToDate ? QString() : QLatin1Char('\n') + tr("The export waits for the run under way."));
}

void ExportDialog::refresh() {
  const FormatDescriptor* format = meshFormat(kind());
  const bool isMesh = format != nullptr;
  if (format) {
    layers_->setVisible(format->hasLayers);
    for (QCheckBox* box : {connections_, obstacleEdges_}) box->setVisible(format->hasLines);
    drops_->setVisible(format->hasDrops);
    placed_->setVisible(format->hasExtras);
  }
  auto* form = static_cast<QFormLayout*>(layout()->itemAt(0)->layout());
  form->setRowVisible(meshOptions_, isMesh);
  form->setRowVisible(frameOptions_, isMesh);
  form->setRowVisible(pictureOptions_, kind() == ExportKind::Png);
  form->setRowVisible(reportOptions_, kind() == ExportKind::Html);
  up_->setEnabled(format && format->hasFrame);
  content_->setText(content());
  const QString why = problem();
  problem_->setText(why);
  problem_->setVisible(!why.isEmpty());
  export_->setEnabled(why.isEmpty());
  estimate();
}

void ExportDialog::estimate() {
  if (estimating_) estimating_->cancel();
  estimating_.reset();
  if (!meshFormat(kind()) || !source_.run || !source_.isUpToDate || !scale_->problem().isEmpty()) {
    size_->clear();
    return;
  }
  size_->setText(tr("Size: ..."));
  estimating_ = std::make_shared<RunContext>();
  queue_.post([this, context = estimating_, run = source_.run, environment = source_.environment, all = settings(),
               placed = source_.placed] {
    if (context->cancelled()) return;
    QString text;
    try {
      const ExportHeader header = makeExportHeader(run->pipeline);
      const std::vector<ExportExtra> extras = all.placed ? placed : std::vector<ExportExtra>();
      const ExportBytes file =
          formatExport(meshFormat(all.kind)->format, *run->result.mesh, header, all.options, extras);
      text = tr("Size: %1").arg(numberLocale().formattedDataSize(static_cast<qint64>(file.bytes.size())));
      if (file.largestError > 0)
        text += QStringLiteral("; ") +
                tr("The format has floats: coordinates move by up to %1 m").arg(shortText(file.largestError, 2));
    } catch (const std::exception& problem) {
      text = coreText(problem);
    }
    QMetaObject::invokeMethod(
        this,
        [this, context, text] {
          if (context == estimating_) size_->setText(text);
        },
        Qt::QueuedConnection);
  });
}

}  // namespace footfall::ui
