// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspect/side_by_side/side_by_side.hpp"

#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/base/vector.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/base/text/core_text.hpp"
#include "ui/filters/pipeline_presets.hpp"

namespace footfall::ui {
namespace {

using Json = nlohmann::json;

bool allInSight(const LevelView& view) {
  const auto geometry = view.environmentGeometry();
  return geometry && std::ranges::all_of(geometry->extremes, [&](const Vec3& p) {
           const auto at = view.project(p + geometry->centre);
           return at && QRectF(view.rect()).contains(*at);
         });
}

}  // namespace

/// The letter in the upper edge of a view.
class ViewLetter : public QLabel {
 public:
  ViewLetter(const QString& letter, QWidget& view) : QLabel(letter, &view) {
    setObjectName(QStringLiteral("viewLetter"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAlignment(Qt::AlignCenter);
    setAutoFillBackground(true);
    setMargin(4);
    setMinimumWidth(26);
    view.installEventFilter(this);
    place();
    show();
  }

 protected:
  bool eventFilter(QObject*, QEvent* event) override {
    if (event->type() == QEvent::Resize) place();
    return false;
  }

 private:
  void place() {
    adjustSize();
    move((parentWidget()->width() - width()) / 2, 8);
  }
};

/// What there is while both are shown.
struct SideBySide::Pair {
  explicit Pair(LevelView& first)
      : view(new LevelView), link(std::make_unique<LinkedView>(first, *view, nullptr)), letter("A", first) {
    view->setObjectName(QStringLiteral("otherView"));
    view->setAccessibleName(SideBySide::tr("View of pipeline B"));
    new ViewLetter(QStringLiteral("B"), *view);
  }
  ~Pair() {
    controller.disconnect();
    link.reset();  // the first view may get another size, and move its camera, while the second one goes
    delete view;
  }
  Pair(const Pair&) = delete;
  Pair& operator=(const Pair&) = delete;

  LevelView* view;  ///< in the splitter, until the pair goes
  std::unique_ptr<LinkedView> link;
  ViewLetter letter;
  RunController controller;
};

SideBySide::SideBySide(const FeatureHost& host, QSplitter& views, LevelView& view, Document& document, LevelFile& file,
                       LevelComposer& composer, RunController& controller)
    : QObject(&host.window),
      window_(host.window),
      views_(views),
      view_(view),
      document_(document),
      file_(file),
      composer_(composer),
      controller_(controller),
      messages_(host.messages),
      sections_(host.sections),
      bar_(new SideBySideBar(views.parentWidget())) {
  setObjectName(QStringLiteral("sideBySide"));
  auto* rows = static_cast<QVBoxLayout*>(views_.parentWidget()->layout());
  rows->insertWidget(rows->indexOf(&views_), bar_);
  bar_->hide();
  action_ = host.commands.add({QStringLiteral("view.sideBySide"),
                               CommandMenu::View,
                               QStringLiteral("compare"),
                               tr("Two Pipelines Side by Side"),
                               tr("Keep the filters as they are as B, beside the list that you go on editing as A"),
                               {},
                               {},
                               true},
                              [this](bool on) {
                                if (on && !isOpen() && file_.environment())
                                  open(document_.pipeline(), tr("the filters as they were"));
                                if (!on) close();
                                action_->setChecked(isOpen());
                              });
  action_->setEnabled(false);
  connect(bar_->sources(), &QMenu::aboutToShow, this, &SideBySide::fillSources);
  connect(bar_, &SideBySideBar::swapRequested, this, &SideBySide::swap);
  connect(bar_, &SideBySideBar::keepRequested, this, &SideBySide::keep);
  connect(&controller_, &RunController::finished, this, &SideBySide::countA);
  connect(&composer_, &LevelComposer::edited, this, [this](const std::shared_ptr<const Environment>& level) {
    if (isOpen()) pair_->controller.editEnvironment(level);
  });
  connect(&file_, &LevelFile::rescaled, this, &SideBySide::takeFilters);
  connect(&file_, &LevelFile::opened, this, [this](Reading reading) {
    action_->setEnabled(true);
    if (!std::exchange(isFromSession_, false) && reading == Reading::Another) close();
    if (isOpen()) takeLevel();
  });
  const auto takeUnits = [this, &units = host.units] { bar_->setUnits(units.units()); };
  connect(&host.units, &UnitChoice::changed, this, takeUnits);
  takeUnits();
  sections_.add(
      {QStringLiteral("sideBySide"), [this] { return save(); }, [this](const std::string& text) { load(text); }});
}

SideBySide::~SideBySide() = default;

LevelView* SideBySide::otherView() const { return pair_ ? pair_->view : nullptr; }

bool SideBySide::isBusy() const { return pair_ && (pair_->controller.busy() || countA_.busy() || countB_.busy()); }

void SideBySide::open(const Pipeline& pipeline, const QString& name) {
  other_ = pipeline;
  name_ = name;
  metresPerUnit_ = file_.environment() ? file_.environment()->metresPerUnit : 1;
  bar_->setOther(name);
  emit sections_.changed();
  if (isOpen()) {
    takeFilters();
    return;
  }
  const CameraPose pose = view_.cameraController().pose();
  const double wide = isFromSession_ ? 0 : shownWidth();  // a session's camera stands for the half of the view
  const bool isWhole = allInSight(view_);
  pair_ = std::make_unique<Pair>(view_);
  views_.addWidget(pair_->view);
  views_.setStretchFactor(0, 1);
  views_.setStretchFactor(1, 1);
  views_.setSizes({view_.width() / 2, view_.width() / 2});
  RunController& controller = pair_->controller;
  connect(&controller, &RunController::contentReady, pair_->view, &LevelView::setContent);
  connect(&controller, &RunController::started, this, [this] { bar_->setNote(tr("B is being computed …")); });
  connect(&controller, &RunController::finished, this, &SideBySide::countB);
  connect(&controller, &RunController::failed, this,
          [this](const QString& message) { bar_->setNote(tr("B: %1").arg(message)); });
  connect(pair_->view, &QOpenGLWidget::frameSwapped, &controller, &RunController::frameShown);
  connect(pair_->view, &LevelView::failed, &messages_, &MessageBar::showError);
  bar_->show();
  action_->setChecked(true);
  takeLevel();
  countA();
  // The half of the view that is left keeps its middle and shows what was between the sides; a level that was in sight
  // as a whole is fitted.
  QTimer::singleShot(0, pair_->link.get(), [this, pose, wide, isWhole] {
    CameraController& camera = view_.cameraController();
    camera.setPose(pose);
    emit camera.moved();
    if (wide == 0) return;
    if (isWhole)
      camera.fit();
    else
      camera.zoomBy(std::min(1.0, shownWidth() / wide));
    camera.endGlide();
    before_ = pose;
    connect(&camera, &CameraController::moved, pair_->link.get(), [this] { before_.reset(); });
  });
}

// How much a view of its shape shows from side to side, where the camera stays. libQGLViewer derives the scale of a
// parallel projection from the shorter side.
double SideBySide::shownWidth() const {
  const double shape = view_.width() / std::max(1.0, static_cast<double>(view_.height()));
  return view_.cameraController().orthographic() ? std::max(1.0, shape) : shape;
}

void SideBySide::close() {
  if (!isOpen()) return;
  countA_.stop();
  countB_.stop();
  const CameraPose pose = before_.value_or(view_.cameraController().pose());
  before_.reset();
  pair_.reset();
  a_.reset();
  b_.reset();
  bar_->hide();
  action_->setChecked(false);
  view_.setFocus();
  emit sections_.changed();
  QTimer::singleShot(0, &view_, [this, pose] {
    view_.cameraController().setPose(pose);
    emit view_.cameraController().moved();
  });
}

void SideBySide::takeLevel() {
  b_.reset();
  showFigures();
  if (!file_.environment()) return;
  takeFilters();
  pair_->controller.setEnvironment(composer_.level(), file_.loaded().geometry->centre);
}

// Also after another scale: lengths stay the same in metres.
void SideBySide::takeFilters() {
  if (!isOpen()) return;
  const double scale = file_.environment() ? file_.environment()->metresPerUnit : metresPerUnit_;
  if (scale != metresPerUnit_) other_ = rescaleLengths(other_, std::exchange(metresPerUnit_, scale), scale);
  std::vector<FilterEntry> entries;
  for (const PipelineStep& step : other_.steps) entries.push_back({static_cast<int>(entries.size()) + 1, step});
  b_.reset();
  showFigures();
  pair_->controller.setFilters(entries);
}

void SideBySide::countA() {
  const auto run = controller_.finishedRun();
  if (!isOpen() || !run) return;
  countA_.start(
      *this, [run](const RunContext& context) { return figuresOf(*run, context); },
      [this](const AgentFigures& figures) {
        a_ = figures;
        showFigures();
      },
      [this](const std::exception& error) { messages_.showError(coreText(error)); });
}

void SideBySide::countB() {
  const auto run = isOpen() ? pair_->controller.finishedRun() : nullptr;
  if (!run) return;
  bar_->setNote({});
  countB_.start(
      *this, [run](const RunContext& context) { return figuresOf(*run, context); },
      [this](const AgentFigures& figures) {
        b_ = figures;
        showFigures();
      },
      [this](const std::exception& error) { messages_.showError(coreText(error)); });
}

void SideBySide::showFigures() { bar_->setFigures(a_, b_); }

// --- What B is

void SideBySide::fillSources() {
  QMenu& menu = *bar_->sources();
  menu.clear();
  const auto add = [this, &menu](const QString& text, const auto& make, const QString& name) {
    menu.addAction(text, this, [this, make, name] {
      try {
        open(make(), name);
      } catch (const std::exception& error) {
        messages_.showError(coreText(error));
      }
    });
  };
  add(
      tr("The filters as they are"), [this] { return document_.pipeline(); }, tr("the filters as they were"));
  menu.addSection(tr("Presets"));
  const double scale = file_.environment() ? file_.environment()->metresPerUnit : 1;
  for (const BuiltInPreset& preset : builtInPresets())
    add(
        preset.name, [preset, scale] { return builtInPipeline(preset, scale); }, preset.name);
  for (const QString& name : PresetStore::ofUser().names()) {
    QString shown = name;
    add(
        shown.replace(QLatin1Char('&'), QLatin1String("&&")), [name] { return PresetStore::ofUser().read(name); },
        name);
  }
  menu.addSeparator();
  menu.addAction(tr("A pipeline file…"), this, &SideBySide::openFile);
}

void SideBySide::openFile() {
  auto* dialog =
      new QFileDialog(&window_, tr("A pipeline for B"), QFileInfo(file_.path()).path(), tr("Pipelines (*.pipeline)"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
    try {
      open(readPipelineFile(QFile::encodeName(path).toStdString()), QFileInfo(path).fileName());
    } catch (const std::exception& error) {
      messages_.showError(coreText(error));
    }
  });
  dialog->open();
}

void SideBySide::swap() {
  const Pipeline list = document_.pipeline();
  const Pipeline other = other_;
  document_.replacePipeline(other, tr("Swap the pipelines A and B"));
  open(list, tr("the list before the swap"));
}

void SideBySide::keep(bool b) {
  const Pipeline other = other_;
  close();
  if (b) document_.replacePipeline(other, tr("Keep pipeline B"));
}

std::string SideBySide::save() const {
  if (!isOpen()) return "null";
  return Json{{"pipeline", formatPipeline(other_)}, {"name", name_.toStdString()}}.dump();
}

void SideBySide::load(const std::string& text) {
  close();
  const Json json = text.empty() ? Json() : Json::parse(text);
  if (json.is_null()) return;
  const Pipeline pipeline = parsePipeline(json.at("pipeline").get<std::string>(), "B");
  isFromSession_ = true;
  open(pipeline, QString::fromStdString(json.at("name").get<std::string>()));
}

}  // namespace footfall::ui
