// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/level/view_modes.hpp"

#include <QSignalBlocker>
#include <QStandardItemModel>
#include <algorithm>
#include <cmath>
#include <new>
#include <utility>

#include "core/base/poll.hpp"
#include "core/base/worker_arena.hpp"
#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/base/text/core_text.hpp"

namespace footfall::ui {
namespace {

constexpr std::size_t kClearancePieces = 150000;
constexpr double kUsualClearance = 2;  // in metres, where no filter has another one
constexpr double kSteepest = 90;       // in degrees

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

ViewModes::ViewModes(const FeatureHost& host, LevelView& view, ViewLayout& layout, const Document& document,
                     LevelFile& file, LevelComposer& composer, RunController& controller)
    : view_(view),
      layout_(layout),
      document_(document),
      composer_(composer),
      controller_(controller),
      messages_(host.messages) {
  setObjectName(QStringLiteral("viewModes"));
  addCommands(host.commands);
  connect(&file, &LevelFile::opened, this, &ViewModes::forget);
  connect(&composer_, &LevelComposer::edited, this, &ViewModes::refresh);
  connect(&controller_, &RunController::finished, this, &ViewModes::refresh);
  connect(&document_, &Document::filtersChanged, this, &ViewModes::refresh);
  enable();
}

void ViewModes::addCommands(CommandRegistry& commands) {
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
    actions_[i] = commands.add(command, [this, mode](bool on) {
      if (on) setMode(mode);
    });
    group->addAction(actions_[i]);
    box_->addItem(labelOf(mode));
    box_->setItemData(static_cast<int>(i), helpOf(mode), Qt::ToolTipRole);
  }
  actions_[0]->setChecked(true);
  connect(box_, &QComboBox::activated, this, [this](int index) {
    setMode(kViewModes[static_cast<std::size_t>(index)]);
    view_.setFocus();
  });
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

// Modes that show a result are disabled until there is one.
void ViewModes::enable() {
  const bool level = composer_.level() != nullptr;
  const bool result = controller_.finishedRun() != nullptr;
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
  for (const FilterEntry& entry : document_.filters()) {
    if (entry.step.enabled && entry.step.filter->type == filter && !entry.step.values.empty())
      return entry.step.values[0];
  }
  return std::nullopt;
}

// Twice the needed height; larger heights do not matter.
double ViewModes::cap() const {
  const std::shared_ptr<const Environment> level = composer_.level();
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
  if (isHeatMap(mode_)) wanted.level = composer_.level();
  if (mode_ == ViewMode::Clearance) wanted.cap = cap();
  if (mode_ == ViewMode::SourceTriangles) wanted.run = controller_.finishedRun();
  return wanted;
}

// Another level was opened: the old modes must not be shown with it.
void ViewModes::forget() {
  made_ = {};
  view_.setField(nullptr, {});
  view_.setSources(nullptr);
  refresh();
}

void ViewModes::describe() {
  const bool heat = isHeatMap(mode_);
  layout_.legend().showMode(mode_, heat ? scale() : FieldScale(), !work_.busy());
  layout_.update();
}

void ViewModes::refresh() {
  enable();
  if (isHeatMap(mode_)) view_.setFieldScale(scale());
  const Made wanted = this->wanted();
  const bool needsNone = !wanted.level && !wanted.run;
  if (needsNone || wanted == made_) {
    const bool waited = work_.busy();
    work_.stop();
    view_.setMode(mode_);
    describe();
    if (waited) emit ready();
    return;
  }
  if (!work_.busy() || !(making_ == wanted)) compute();
  describe();
}

void ViewModes::compute() {
  making_ = wanted();
  const auto geometry = view_.environmentGeometry();
  const Vec3 centre = geometry ? geometry->centre : Vec3{};
  work_.start(
      *this,
      [made = making_, centre, layers = view_.content().environmentLayers](RunContext& context) {
        Pictures pictures;
        const Poll poll(context);
        if (made.mode == ViewMode::Slope) pictures.field = makeSlopeField(*made.level, centre, poll);
        if (made.mode == ViewMode::Clearance) {
          pictures.field = onThreads(
              0, [&](int) { return makeClearanceField(made.level, centre, made.cap, kClearancePieces, poll); });
        }
        if (made.run && made.run->result.mesh)
          pictures.sources = makeSourceGeometry(*made.run->result.mesh, centre, layers.get());
        return pictures;
      },
      [this, made = making_](const Pictures& pictures) { take(made, pictures, {}); },
      [this, made = making_](const std::exception& error) {
        take(made, {},
             dynamic_cast<const std::bad_alloc*>(&error) != nullptr
                 ? tr("view: memory ran out; choose another view mode or a smaller environment")
                 : coreText(error));
      });
}

void ViewModes::take(const Made& made, const Pictures& pictures, const QString& error) {
  made_ = made;
  messages_.finish(MessageSubject::View);
  if (!error.isEmpty()) messages_.showErrorOf(MessageSubject::View, error);
  if (pictures.field) view_.setField(pictures.field, scale());
  if (pictures.sources) view_.setSources(pictures.sources);
  view_.setMode(mode_);
  describe();
  emit ready();
}

}  // namespace footfall::ui
