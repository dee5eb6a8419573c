// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/level/packed_feature.hpp"

#include <QFileInfo>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <utility>

#include "footfall/errors.hpp"
#include "ui/base/text/core_text.hpp"
#include "ui/base/text/localized_numbers.hpp"
#include "ui/view/overlays/box_edges.hpp"
#include "ui/view/scene/appearance.hpp"

namespace footfall::ui {
namespace {

const QString kOverlay = QStringLiteral("part");
constexpr std::chrono::milliseconds kRest{150};  // wait before blocks are read for a new camera position
constexpr std::size_t kAtOnce = 8;               // blocks read at a time, which takes some 10 ms before they are shown

QString millions(std::uint64_t triangles) { return shortText(static_cast<double>(triangles) / 1e6, 3); }

std::vector<BlockInView> blocksOf(const PackedPart& part) {
  std::vector<BlockInView> blocks;
  const PackedEnvironment& environment = *part.environment;
  const Vec3& centre = part.whole->centre;
  for (std::size_t b = 0; b < environment.blocks().size(); ++b) {
    if (environment.blocks()[b].faces == 0 || isInPart(part, b)) continue;
    const auto [lower, upper] = environment.boxOf(b);
    blocks.push_back({b,
                      environment.blocks()[b].faces,
                      {{lower[0] - centre.x, lower[1] - centre.y, lower[2] - centre.z},
                       {upper[0] - centre.x, upper[1] - centre.y, upper[2] - centre.z}}});
  }
  return blocks;
}

// The distance to the farther sides of the view, at the depth of a place.
double seenAround(LevelView& view, const Vec3& place) {
  const qglviewer::Camera& camera = *view.camera();
  if (camera.type() == qglviewer::Camera::ORTHOGRAPHIC) {
    qreal width = 0, height = 0;
    camera.getOrthoWidthHeight(width, height);
    return std::max(width, height);
  }
  const Vec3 eye = view.cameraController().pose().position;
  const double away = std::hypot(place.x - eye.x, place.y - eye.y, place.z - eye.z);
  return away * std::tan(camera.fieldOfView() / 2) * std::max(1.0, camera.aspectRatio());
}

}  // namespace

PackedFeature::PackedFeature(const FeatureHost& host, QStatusBar& bar, LevelView& view, LevelFile& file)
    : QObject(&host.window), view_(view), file_(file), messages_(host.messages), note_(host.status) {
  setObjectName(QStringLiteral("packed"));
  runHere_ = host.commands.add(
      {QStringLiteral("pipeline.runHere"),
       CommandMenu::Pipeline,
       QStringLiteral("runs"),
       tr("Run on the visi&ble part"),
       tr("Run the filters on the part in the middle of the view, in an environment that is too large to run whole"),
       {QKeySequence(Qt::SHIFT | Qt::Key_F5)}},
      [this](bool) { runHere(); });
  runHere_->setEnabled(false);
  status_ = new QLabel(&bar);
  status_->setObjectName(QStringLiteral("blocks"));
  status_->setToolTip(tr("The parts of a large environment that the view shows in full"));
  status_->hide();
  bar.addPermanentWidget(status_);
  settling_.setSingleShot(true);
  settling_.setInterval(kRest);
  connect(&settling_, &QTimer::timeout, this, &PackedFeature::choose);
  connect(&view_, &QOpenGLWidget::frameSwapped, this, &PackedFeature::followCamera);
  connect(&file_, &LevelFile::opened, this, &PackedFeature::follow);
  connect(&file_, &LevelFile::rereadDone, this, [this] { follow(Reading::Again); });
  host.sections.add(
      {QStringLiteral("part"), [this] { return savePlace(); }, [this](const std::string& text) { loadPlace(text); }});
  connect(this, &PackedFeature::placeChanged, &host.sections, &SessionSections::changed);
}

void PackedFeature::follow(Reading reading) {
  const std::shared_ptr<const PackedPart> before = std::exchange(part_, file_.loaded().part);
  work_.stop();
  wanted_.clear();
  damaged_.clear();
  runHere_->setEnabled(part_ != nullptr);
  status_->setVisible(part_ != nullptr);
  note_.setToolRemark(part_ ? tr("Only the part in the frame is known.") : QString());
  if (!part_) {
    loaded_.clear();
    blocks_.clear();
    settling_.stop();
    status_->clear();
    if (!before) return;
    view_.setBackdrop(nullptr);
    view_.removeOverlay(kOverlay);
    return;
  }
  // Blocks outside of both parts do not change.
  const bool isSame = before && isSameFile(*before, *part_);
  std::erase_if(loaded_, [&](const auto& entry) {
    return !isSame || touchesPart(*before, entry.first) || touchesPart(*part_, entry.first);
  });
  blocks_ = blocksOf(*part_);
  show();
  drawFrame();
  settling_.start();
  if (reading == Reading::Another || !before) tellOfPart();  // the file may have grown since it was opened
  if (reading != Reading::OtherPart) return;
  emit placeChanged();
  if (part_->isSmaller)
    note_.say(
        StatusSubject::Note,
        tr("The visible place has more than %1 triangles; the part is smaller.").arg(countText(part_->limits.part)));
}

void PackedFeature::tellOfPart() {
  messages_.showHint(tr("%1 has %2 million triangles. The view shows them coarse, and in full where you look; filters "
                        "run on the part in the frame. All of it: footfall run --memory.")
                         .arg(QFileInfo(file_.path()).fileName(), millions(part_->environment->faceCount())),
                     tr("Run on the visible part"), [this] { runHere(); });
  messages_.setSubject(MessageSubject::Opening);
}

void PackedFeature::runHere() {
  if (!part_) return;
  const Vec3 place = view_.placeInTheMiddle();
  if (!file_.showPart({place.x, place.y, seenAround(view_, place)}))
    note_.say(StatusSubject::Note, tr("A file is being read; until that is done, the part stays where it is."));
}

// --- Blocks

void PackedFeature::followCamera() {
  if (!part_) return;
  const SceneCamera camera = view_.sceneCamera();
  if (camera == seen_) return;
  seen_ = camera;
  settling_.start();
}

void PackedFeature::choose() {
  if (!part_) return;
  wanted_ = chooseBlocks(blocks_, view_.sceneCamera(), part_->limits.shown, loadedBlocks());
  const std::size_t dropped = std::erase_if(
      loaded_, [&](const auto& entry) { return std::ranges::find(wanted_, entry.first) == wanted_.end(); });
  if (dropped > 0) show();
  loadNext();
}

void PackedFeature::loadNext() {
  std::vector<std::size_t> missing;
  for (const std::size_t block : wanted_)
    if (missing.size() < kAtOnce && !loaded_.contains(block) && !damaged_.contains(block)) missing.push_back(block);
  if (missing.empty()) {
    work_.stop();
    return;
  }
  work_.start(
      *this,
      [part = part_, missing](RunContext& context) {
        Blocks blocks;
        for (const std::size_t block : missing) {
          context.checkCancelled();
          try {
            blocks.pieces[block] = makeBlockPiece(*part, block);
          } catch (const InputError& error) {
            blocks.damaged.insert(block);
            blocks.problem = coreText(error);
          }
        }
        part->environment->forgetBlocks();
        return blocks;
      },
      [this](const Blocks& blocks) {
        if (!blocks.damaged.empty() && damaged_.empty())
          messages_.showErrorOf(MessageSubject::View, blocks.problem);  // once for each file
        damaged_.insert(blocks.damaged.begin(), blocks.damaged.end());
        loaded_.insert(blocks.pieces.begin(), blocks.pieces.end());
        show();
        loadNext();
      },
      [this](const std::exception& error) {
        wanted_.clear();  // not again before the camera moves
        messages_.showErrorOf(MessageSubject::View, coreText(error));
      });
}

std::set<std::size_t> PackedFeature::loadedBlocks() const {
  std::set<std::size_t> blocks;
  for (const auto& [block, piece] : loaded_) blocks.insert(block);
  return blocks;
}

// --- View

void PackedFeature::show() {
  auto backdrop = std::make_shared<Backdrop>();
  backdrop->coarse = part_->coarse;
  backdrop->shownCoarse = coarseRanges([this](std::size_t block) { return !loaded_.contains(block); });
  backdrop->coarseAlone = coarseRanges([](std::size_t) { return true; });
  for (const auto& [block, piece] : loaded_) backdrop->loaded.push_back(piece);
  view_.setBackdrop(std::move(backdrop));
  say();
}

std::vector<Backdrop::Range> PackedFeature::coarseRanges(const std::function<bool(std::size_t)>& isShown) const {
  std::vector<Backdrop::Range> ranges;
  for (std::size_t b = 0; b + 1 < part_->firstCoarse.size(); ++b) {
    if (!isShown(b)) continue;
    for (std::size_t t = part_->firstCoarse[b]; t < part_->firstCoarse[b + 1]; ++t) {
      if (part_->isCoarseInPart[t] != 0) continue;
      if (!ranges.empty() && ranges.back().first + ranges.back().second == t) {
        ++ranges.back().second;
      } else {
        ranges.emplace_back(t, 1);
      }
    }
  }
  return ranges;
}

void PackedFeature::drawFrame() {
  const WholeBounds& whole = *part_->whole;
  const PartPlace& place = part_->place;
  const Vec3& centre = whole.centre;
  const Vec3 lower{std::max(place.x - place.half, whole.lower.x + centre.x),
                   std::max(place.y - place.half, whole.lower.y + centre.y), whole.lower.z + centre.z};
  const Vec3 upper{std::min(place.x + place.half, whole.upper.x + centre.x),
                   std::min(place.y + place.half, whole.upper.y + centre.y), whole.upper.z + centre.z};
  ViewOverlay overlay;
  overlay.lines.push_back({edgesOfBox(lower, upper), selectedCellColour(), 2, outlineColour()});
  view_.setOverlay(kOverlay, std::move(overlay));
}

void PackedFeature::say() {
  const PackedEnvironment& environment = *part_->environment;
  std::uint64_t triangles = file_.environment()->triangles.size();
  for (const auto& [block, piece] : loaded_) triangles += piece->triangles();
  std::size_t inPart = 0, all = 0;
  for (std::size_t b = 0; b < environment.blocks().size(); ++b) {
    if (environment.blocks()[b].faces == 0) continue;
    ++all;
    inPart += isInPart(*part_, b) ? 1U : 0U;
  }
  status_->setText(tr("Coarse; in full: %1 of %2 blocks, %3 of %4 million triangles")
                       .arg(countText(loaded_.size() + inPart), countText(all), millions(triangles),
                            millions(environment.faceCount())));
}

// --- Sessions

std::string PackedFeature::savePlace() const {
  if (!part_) return "{}";
  const PartPlace& place = part_->place;
  return nlohmann::json{{"x", place.x}, {"y", place.y}, {"half", place.half}}.dump();
}

void PackedFeature::loadPlace(const std::string& text) {
  if (text.empty()) return;
  const nlohmann::json json = nlohmann::json::parse(text);
  if (!json.contains("half")) return;
  const PartPlace place{json.at("x").get<double>(), json.at("y").get<double>(), json.at("half").get<double>()};
  // The level is not set yet.
  QTimer::singleShot(0, this, [this, place] {
    if (part_ && !(part_->place == place)) file_.showPart(place);
  });
}

}  // namespace footfall::ui
