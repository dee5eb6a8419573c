// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/clearance/clearance_pass.hpp"

#include <algorithm>

#include "core/assembly/dropped_parts.hpp"
#include "core/assembly/mesh_assembly.hpp"
#include "core/environment/coordinate_grid.hpp"
#include "core/filters/clearance/crowding.hpp"
#include "core/filters/height_levels.hpp"
#include "core/filters/steps/kept_links.hpp"

namespace footfall::detail {
ClearancePass::Worker::Worker(const ClearancePass& pass, RunContext& context)
    : floors(pass.state_->walkable, pass.tests_),
      clipper_(
          *pass.result_->kernel, [this](Index face) { return floors.isFloor(face); }, pass.level_, context),
      mesher_(*pass.result_->kernel, context),
      copies_(makeCopyMemory()) {
  clipper_.useFans(pass.fans_.get());
}

ClearancePass::ClearancePass(const StatePtr& state, double given, std::vector<FaceTest> tests,
                             const BorderCoordinates& borders, const Recall& recall, RunContext& context)
    : state_(state),
      context_(context),
      large_(state->walkable.size() >= kLargeRelease),
      tests_(std::move(tests)),
      result_(std::make_shared<WalkableState>(*state)) {
  const double height = sufficientHeight(state->kernel->mesh(), clearanceOnGrid(state->environment->grid, given));
  checkHeight(state->kernel->mesh(), height,
              FOOTFALL_TEXT("a clearance of %1 is too small beside coordinates of up to %2; give at least %3, or check "
                            "the scale and the largest coordinates"));
  result_->agentHeight = std::max(state->agentHeight, given);
  result_->kernel = kernelWithHeight(state->kernel, height);
  const PlanKernel& kernel = *result_->kernel;
  level_ = *kernel.levelOf(height);
  borderKernel_ = borders[0].empty() && borders[1].empty()
                      ? result_->kernel
                      : std::make_shared<PlanKernel>(kernel.sharedMesh(), kernel.heights(), borders);
  fans_ = NeedleFans::find(kernel.mesh(), Poll(&context));
  const std::size_t count = kernel.mesh().triangles.size();

  // Only a first clearance filter can be taken over or remembered: later ones add to the cuts of others.
  if (!state->cuts && recall.keep) {
    memory_ = std::make_shared<AssemblyMemory>();
    large_.hold(memory_);
    memory_->candidates.resize(count);
    memory_->clearance = height;
    if (recall.before && recall.before->memory) earlier_ = EarlierResult::relate(recall.before, kernel);
  }
  known_.emplace(earlier_, *result_, height);
  cuts_ = std::make_shared<CutTable>(count);
  large_.hold(cuts_);
  meshes_ = std::make_shared<FaceMeshes>(count);
  large_.hold(meshes_);
  isChanged_.assign(count, 0);
  crowding_ = std::vector<std::atomic<Crowd>>(count);
}

ClearancePass::Worker& ClearancePass::worker() {
  auto& worker = workers_.local();
  if (!worker) worker = std::make_unique<Worker>(*this, context_);
  return *worker;
}

bool ClearancePass::canShare(Index face) const {
  return !state_->cuts && known_->before(face) < 0 && !mayBeCrowded(face);
}

// Counts everything in the box, which is never less than the obstacles within the clearance, so the clipper leaves out
// no obstacle of a shared face.
bool ClearancePass::mayBeCrowded(Index face) const {
  std::atomic<Crowd>& known = crowding_[static_cast<std::size_t>(face)];
  if (const Crowd crowd = known.load(std::memory_order_relaxed); crowd != Crowd::Unknown) return crowd == Crowd::Many;
  const SourceMesh& mesh = result_->kernel->mesh();
  Crowding crowding(mesh, face);
  std::vector<std::int32_t> stack;
  mesh.tree.visitOverlapping(clearanceBox(mesh, face, result_->kernel->heights()[level_ - 1]), stack,
                             [&](Index obstacle) {
                               if (obstacle != face) crowding.add(obstacle);
                               return !crowding.isCrowd();
                             });
  known.store(crowding.isCrowd() ? Crowd::Many : Crowd::Few, std::memory_order_relaxed);
  return crowding.isCrowd();
}

void ClearancePass::clip(Index face, Worker& own, const std::function<void(double)>& progress) {
  const Index then = known_->before(face);
  if (then >= 0 && known_->sameClearance() && !known_->isTouched(face)) {
    cuts_->set(face, earlier_->cuts(then, own.copies_));
    memory_->candidates[face] = earlier_->candidates(then, own.copies_);
    keepLarge(face, largeBefore(then));
    return;
  }
  isChanged_[face] = 1;
  if (clipNearChanges(face, then, own)) return;
  own.clipper_.crowdProgress = progress;
  const FaceCuts& cuts = known_->knowsAll(then)
                             ? own.clipper_.clip(face, known_->standing(face, then, own.copies_), known_->clearance())
                             : own.clipper_.clip(face, state_->cuts ? &(*state_->cuts)[face] : nullptr);
  if (!cuts.empty()) cuts_->set(face, keptIn(own.copies_, cuts));
  if (!memory_) return;
  keepCandidates(face, own.clipper_.candidates());
  keepLarge(face, own.clipper_.largeFace(cuts));
}

bool ClearancePass::clipNearChanges(Index face, Index faceBefore, Worker& own) {
  if (!known_->knowsAll(faceBefore) || !known_->sameClearance()) return false;
  const auto large = largeBefore(faceBefore);
  if (!large) return false;
  const CopyMemory copies = makeCopyMemory();
  const auto cuts = earlier_->cuts(faceBefore, copies);
  const auto known = earlier_->candidates(faceBefore, copies);
  const std::vector<Index> standing(known->begin(), known->end());
  EarlierCuts earlier{*cuts, *large, standing, earlier_->added(), {}, known_->changedAt(face)};
  const SourceMesh& before = earlier_->state().kernel->mesh();
  for (const Index gone : earlier_->gone(faceBefore))
    if (before.facing[gone] != 0) earlier.gone.push_back(boxOf(before, gone));
  auto updated = own.clipper_.update(face, earlier);
  if (!updated) return false;
  cuts_->set(face, keptIn(own.copies_, updated->cuts));
  keepCandidates(face, std::move(updated->standing));
  keepLarge(face, std::make_shared<const LargeFace>(std::move(updated->memory)));
  return true;
}

std::shared_ptr<const LargeFace> ClearancePass::largeBefore(Index faceBefore) const {
  const auto& large = earlier_->state().memory->large;
  const auto found = large.find(faceBefore);
  return found != large.end() ? found->second : nullptr;
}

void ClearancePass::keepLarge(Index face, std::shared_ptr<const LargeFace> large) {
  if (!large) return;
  const std::lock_guard lock(mutex_);
  memory_->large[face] = std::move(large);
}

void ClearancePass::keepCandidates(Index face, std::vector<Index> found) {
  if (!found.empty())
    memory_->candidates[face] = std::make_shared<const std::pmr::vector<Index>>(found.begin(), found.end());
}

FaceShare ClearancePass::clipShare(Index face, std::span<const CellSide> sides, Worker& own) {
  if (!own.shareClipper_)
    own.shareClipper_ = std::make_unique<ClearanceClipper>(
        *borderKernel_, [&own](Index f) { return own.floors.isFloor(f); }, level_, context_);
  return own.shareClipper_->clipShare(face, sides);
}

void ClearancePass::joinShares(Index face, std::span<const FaceShare> shares, Worker& own) {
  isChanged_[face] = 1;
  if (const FaceCuts cuts = own.clipper_.joinShares(face, shares); !cuts.empty())
    cuts_->set(face, keptIn(own.copies_, cuts));
  if (!memory_) return;
  keepCandidates(face, candidatesOf(shares));
}

std::size_t ClearancePass::mesh(Index face, Worker& own) {
  if (!cuts_->shared(face)) return 1;
  if (cuts_->isRemoved(face)) return 0;
  auto& mesh = (*meshes_)[face];
  const bool isKnown = earlier_ && known_->sameClearance() && isChanged_[face] == 0;
  if (isKnown)
    mesh = earlier_->mesh(earlier_->faceBefore(face), own.copies_);
  else if (!(*cuts_)[face].segments.empty())
    mesh = keptIn(own.copies_, own.mesher_.mesh(face, &(*cuts_)[face]));
  return triangles(face);
}

bool ClearancePass::isReused(Index face) const {
  return isChanged_[face] == 0 && known_->sameClearance() && known_->before(face) >= 0;
}

std::size_t ClearancePass::triangles(Index face) const {
  if (cuts_->isRemoved(face)) return 0;
  const auto& mesh = (*meshes_)[face];
  return mesh ? mesh->facets.size() : 1;
}

void ClearancePass::setResult(Index face, std::shared_ptr<const FaceCuts> cuts, std::shared_ptr<const FaceMesh> mesh) {
  isChanged_[face] = 1;
  cuts_->set(face, std::move(cuts));
  (*meshes_)[face] = std::move(mesh);
}

std::shared_ptr<const NavigationMesh> ClearancePass::preview(std::span<const Index> faces) const {
  return previewOfFaces(*result_->kernel, *cuts_, *meshes_, faces, context_);
}

FilterOutcome ClearancePass::finish(std::vector<char> walkable, std::vector<char> removed, bool isMeshed) {
  FilterOutcome outcome;
  for (const auto& worker : workers_) {
    outcome.fallbacks += worker->clipper_.fallbacks();
    outcome.fallbacks += worker->mesher_.fallbacks();
    outcome.fallbacks += worker->floors.fallbacks;
    if (worker->shareClipper_) outcome.fallbacks += worker->shareClipper_->fallbacks();
  }
  result_->walkable = std::move(walkable);
  result_->removed = std::move(removed);
  result_->cuts = cuts_;
  result_->clearance = std::max(state_->clearance, result_->kernel->heights()[level_ - 1]);
  const bool partly = earlier_ && known_->sameClearance();
  std::vector<Index> changed;
  for (Index t = 0; t < static_cast<Index>(isChanged_.size()) && partly; ++t)
    if (isChanged_[t] != 0) changed.push_back(t);
  const EarlierResult* earlier = partly ? &*earlier_ : nullptr;
  if (!isMeshed) meshFaces(*result_, earlier, changed, *meshes_, context_, outcome.fallbacks);
  result_->mesh = joinFaces(*result_, earlier, changed, meshes_, memory_.get(), context_, outcome.fallbacks);
  result_->simplified = false;
  result_->memory = memory_;
  if (result_->dropped)
    result_->mesh = withoutDropped(*result_->kernel, *result_->mesh, *result_->dropped, context_, outcome.fallbacks);
  outcome.state = result_;
  if (state_->mesh) {
    const bool isHigher = result_->clearance > state_->clearance;
    outcome.state = withLinks(outcome.state, *state_->mesh, isHigher, context_, outcome.fallbacks);
  }
  result_ = nullptr;
  return outcome;
}

}  // namespace footfall::detail
