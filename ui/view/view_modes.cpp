// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/view_modes.hpp"

#include <QSignalBlocker>
#include <QStandardItemModel>
#include <algorithm>
#include <cmath>
#include <new>
#include <utility>

#include "core/base/poll.hpp"
#include "core/base/worker_arena.hpp"
#include "ui/base/core_text.hpp"
#include "ui/base/namespaces.hpp"

namespace footfall::ui {
namespace {

constexpr std::size_t kClearancePieces = 150000;
constexpr double kUsualClearance = 2;  // metres, where no filter says another
constexpr double kSteepest = 90;       // degrees

// Pieces in the colours of their triangles, and the lines between different ones.
std::shared_ptr<const NavigationMeshGeometry> makeSourceGeometry(const NavigationMesh& mesh, const Vec3& centre,
                                                                 const EnvironmentLayers* layers) {
  auto geometry = std::make_shared<NavigationMeshGeometry>(*makeMeshGeometry(mesh, centre, walkablePaint(), layers));
  for (std::size_t t = 0; t < mesh.triangles.size() && t < mesh.sourceTriangles.size(); ++t) {
    const QColor colour = sourcePaint(mesh.sourceTriangles[t]).colour;
    for (std::size_t k = 0; k < 3; ++k) {
      geometry->surface[3 * t + k].colour = {static_cast<std::uint8_t>(colour.red()),
                                             static_cast<std::uint8_t>(colour.green()),
                                             static_cast<std::uint8_t>(colour.blue()), 255};
    }
  }
  addSourceEdges(mesh, centre, *geometry);
  return geometry;
}

}  // namespace

ViewModes::ViewModes(EditorWindow& window) : window_(window) {
  setObjectName(QStringLiteral("viewModes"));
  addCommands();
  connect(&window_, &EditorWindow::environmentLoaded, this, &ViewModes::forget);
  connect(&window_.composer(), &LevelComposer::edited, this, &ViewModes::refresh);
  connect(&window_.controller(), &RunController::finished, this, &ViewModes::refresh);
  connect(&window_.document(), &Document::filtersChanged, this, &ViewModes::refresh);
  enable();
}

ViewModes::~ViewModes() {
  if (context_) context_->cancel();
}

void ViewModes::addCommands() {
  auto* group = new QActionGroup(this);
  box_ = new QComboBox;
  box_->setObjectName(QStringLiteral("viewMode"));
  box_->setAccessibleName(tr("View mode"));
  box_->setToolTip(tr("What the view shows"));
  for (std::size_t i = 0; i < kViewModes.size(); ++i) {
    const ViewMode mode = kViewModes[i];
    Command command;
    command.id = QStringLiteral("view.mode.") + QString::fromUtf8(nameOf(mode).data(), qsizetype(nameOf(mode).size()));
    command.menu = CommandMenu::View;
    command.group = QStringLiteral("modes");
    command.text = labelOf(mode);
    command.help = helpOf(mode);
    command.keys = {QKeySequence(Qt::SHIFT | static_cast<Qt::Key>(Qt::Key_1 + static_cast<int>(i)))};
    command.checkable = true;
    actions_[i] = window_.commands().add(command, [this, mode](bool on) {
      if (on) setMode(mode);
    });
    group->addAction(actions_[i]);
    box_->addItem(labelOf(mode));
    box_->setItemData(static_cast<int>(i), helpOf(mode), Qt::ToolTipRole);
  }
  actions_[0]->setChecked(true);
  connect(box_, &QComboBox::activated, this, [this](int index) {
    setMode(kViewModes[static_cast<std::size_t>(index)]);
    window_.view().setFocus();
  });
  window_.toolBar()->addSeparator();
  window_.toolBar()->addWidget(box_);
}

void ViewModes::setMode(ViewMode mode) {
  const std::size_t index = static_cast<std::size_t>(mode);
  actions_[index]->setChecked(true);
  const QSignalBlocker quiet(box_);
  box_->setCurrentIndex(static_cast<int>(index));
  if (std::exchange(mode_, mode) == mode) return;
  refresh();
  emit modeChanged(mode_);
}

// Modes that show a result wait for one; they say so.
void ViewModes::enable() {
  const bool level = window_.level() != nullptr;
  const bool result = window_.controller().finishedRun() != nullptr;
  auto* model = qobject_cast<QStandardItemModel*>(box_->model());
  for (std::size_t i = 0; i < kViewModes.size(); ++i) {
    const ViewMode mode = kViewModes[i];
    const bool on = mode == ViewMode::Result || (level && (result || !needsResult(mode)));
    const QString missing = !level ? tr("Open an environment first") : tr("Waits for the first result of the filters");
    actions_[i]->setEnabled(on || mode == mode_);
    actions_[i]->setToolTip(on ? withKeys(helpOf(mode), *actions_[i]) : missing);
    if (!model) continue;
    model->item(static_cast<int>(i))->setEnabled(on || mode == mode_);
    model->item(static_cast<int>(i))->setToolTip(on ? helpOf(mode) : missing);
  }
}

std::optional<double> ViewModes::limitOf(FilterType filter) const {
  for (const FilterEntry& entry : window_.document().filters()) {
    if (entry.step.enabled && entry.step.filter->type == filter && !entry.step.values.empty())
      return entry.step.values[0];
  }
  return std::nullopt;
}

// Twice what is needed: above that, nobody cares.
double ViewModes::cap() const {
  const std::shared_ptr<const Environment> level = window_.level();
  const double usual = kUsualClearance / (level && level->metresPerUnit > 0 ? level->metresPerUnit : 1);
  return 2 * limitOf(FilterType::VerticalClearance).value_or(usual);
}

FieldScale ViewModes::scale() const {
  if (mode_ == ViewMode::Slope) return {0, kSteepest, limitOf(FilterType::Slope), true};
  return {0, cap(), limitOf(FilterType::VerticalClearance), false};
}

ViewModes::Made ViewModes::wanted() const {
  Made wanted;
  wanted.mode = mode_;
  if (isHeatMap(mode_)) wanted.level = window_.level();
  if (mode_ == ViewMode::Clearance) wanted.cap = cap();
  if (mode_ == ViewMode::SourceTriangles) wanted.run = window_.controller().finishedRun();
  return wanted;
}

// Another level: nothing of the old one may be seen with it.
void ViewModes::forget() {
  made_ = {};
  window_.view().setField(nullptr, {});
  window_.view().setSources(nullptr);
  refresh();
}

void ViewModes::describe() {
  const bool heat = isHeatMap(mode_);
  window_.legend().showMode(mode_, heat ? scale() : FieldScale(), !context_);
  window_.placeOverlays();
}

void ViewModes::refresh() {
  enable();
  LevelView& view = window_.view();
  if (isHeatMap(mode_)) view.setFieldScale(scale());
  const Made wanted = this->wanted();
  const bool needsNone = !wanted.level && !wanted.run;
  if (needsNone || wanted == made_) {
    if (context_) context_->cancel();
    const bool waited = std::exchange(context_, nullptr) != nullptr;
    view.setMode(mode_);
    describe();
    if (waited) emit ready();
    return;
  }
  if (!context_ || !(making_ == wanted)) compute();
  describe();
}

void ViewModes::compute() {
  if (context_) context_->cancel();
  context_ = std::make_shared<RunContext>();
  making_ = wanted();
  const auto geometry = window_.view().environmentGeometry();
  const Vec3 centre = geometry ? geometry->centre : Vec3{};
  queue_.post([this, context = context_, made = making_, centre, layers = window_.view().content().environmentLayers] {
    std::shared_ptr<const FieldGeometry> field;
    std::shared_ptr<const NavigationMeshGeometry> sources;
    QString error;
    const Poll poll(*context);
    try {
      poll();
      if (made.mode == ViewMode::Slope) field = makeSlopeField(*made.level, centre, poll);
      if (made.mode == ViewMode::Clearance) {
        field =
            onThreads(0, [&](int) { return makeClearanceField(made.level, centre, made.cap, kClearancePieces, poll); });
      }
      if (made.run && made.run->result.mesh) sources = makeSourceGeometry(*made.run->result.mesh, centre, layers.get());
    } catch (const Cancelled&) {
      return;
    } catch (const std::bad_alloc&) {
      error = tr("view: memory ran out; choose another view mode or a smaller environment");
    } catch (const std::exception& problem) {
      error = coreText(problem);
    }
    QMetaObject::invokeMethod(
        this,
        [this, context, made, field, sources, error] {
          if (context != context_) return;  // overtaken
          context_.reset();
          made_ = made;
          LevelView& view = window_.view();
          window_.messageBar().finish(MessageSubject::View);
          if (!error.isEmpty()) window_.messageBar().showErrorOf(MessageSubject::View, error);
          if (field) view.setField(field, scale());
          if (sources) view.setSources(sources);
          view.setMode(mode_);
          describe();
          emit ready();
        },
        Qt::QueuedConnection);
  });
}

}  // namespace footfall::ui
