// One run of VerticalClearanceFilter, face by face in any order and on any threads: over the whole environment, or cell
// by cell in a parallel block.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "core/base/background_release.hpp"
#include "core/base/parallel.hpp"
#include "core/filters/apply_filter.hpp"
#include "core/filters/clearance/clearance_clipper.hpp"
#include "core/filters/clearance/known_cuts.hpp"
#include "core/filters/clearance/needle_fans.hpp"
#include "core/filters/face_filter.hpp"

namespace footfall::detail {

/// Faces that are given to clip() or mesh() at the same time must be different ones.
class ClearancePass {
 public:
  /// The clipper, mesher and flags of one thread.
  class Worker {
   public:
    Worker(const ClearancePass& pass, RunContext& context);

    FloorFlags floors;

   private:
    friend ClearancePass;
    ClearanceClipper clipper_;
    std::unique_ptr<ClearanceClipper> shareClipper_;  ///< on the kernel with borders; made when needed
    FaceMesher mesher_;
    CopyMemory copies_;
  };

  /// `tests` are filters that come before, not yet in the state's flags (none when there is something to recall).
  /// `borders` are those between cells that share faces.
  ClearancePass(const StatePtr& state, double height, std::vector<FaceTest> tests, const BorderCoordinates& borders,
                const Recall& recall, RunContext& context);

  /// The calling thread's own, for as long as the pass.
  Worker& worker();
  /// Returns whether a face may be cut into shares. It may not when it has cuts of an earlier clearance, or known ones,
  /// and when the crowd above it is so deep that the relevant obstacles can only be found from all of it.
  [[nodiscard]] bool canShare(Index face) const;
  /// False: there is no crowd above the face.
  [[nodiscard]] bool mayBeCrowded(Index face) const;

  /// Finds the cuts of a floor. `progress` is called with the share that is done of a crowd above it; may be empty.
  void clip(Index face, Worker& own, const std::function<void(double)>& progress = {});
  /// The part of a floor's cuts that one cell finds.
  FaceShare clipShare(Index face, std::span<const CellSide> sides, Worker& own);
  /// All parts of a floor's cuts.
  void joinShares(Index face, std::span<const FaceShare> shares, Worker& own);
  /// The number of segments with which a clipped floor has to be triangulated; 0: it stays whole or is covered.
  [[nodiscard]] std::size_t segments(Index face) const {
    return cuts_->isRemoved(face) ? 0 : (*cuts_)[face].segments.size();
  }
  /// Sets the result of another process for a floor, instead of clip() and mesh(); `mesh` is null where mesh() makes
  /// none.
  void setResult(Index face, std::shared_ptr<const FaceCuts> cuts, std::shared_ptr<const FaceMesh> mesh);
  /// The cuts of a floor, and its mesh; null where nothing cuts it, or where there is no mesh.
  [[nodiscard]] const std::shared_ptr<const FaceCuts>& cutsOf(Index face) const { return cuts_->shared(face); }
  [[nodiscard]] const std::shared_ptr<const FaceMesh>& meshOf(Index face) const { return (*meshes_)[face]; }
  /// True when the outcome of a floor that is finished is that of an earlier run. Not to be called during clip().
  [[nodiscard]] bool isReused(Index face) const;
  /// How many triangles are left of a floor that is finished.
  [[nodiscard]] std::size_t triangles(Index face) const;
  [[nodiscard]] const PlanKernel& kernel() const { return *result_->kernel; }
  /// Triangulates what the cuts of a floor leave, to be taken by finish(). Returns its number of triangles.
  std::size_t mesh(Index face, Worker& own);
  /// The remaining floors, for display.
  [[nodiscard]] std::shared_ptr<const NavigationMesh> preview(std::span<const Index> faces) const;

  /// The filter's outcome, when every floor is clipped. `isMeshed`: mesh() was called for every floor, too. `walkable`
  /// and `removed`: the flags after the filters before.
  FilterOutcome finish(std::vector<char> walkable, std::vector<char> removed, bool isMeshed);

 private:
  void keepCandidates(Index face, std::vector<Index> found);
  void keepLarge(Index face, std::shared_ptr<const LargeFace> large);
  /// The stored data of a face under many obstacles, by its earlier number; or null.
  [[nodiscard]] std::shared_ptr<const LargeFace> largeBefore(Index faceBefore) const;
  /// False: the face must be clipped as a whole.
  bool clipNearChanges(Index face, Index faceBefore, Worker& own);

  StatePtr state_;
  RunContext& context_;
  ReleaseOnException large_;
  std::vector<FaceTest> tests_;
  std::shared_ptr<WalkableState> result_;
  std::shared_ptr<const PlanKernel> borderKernel_;
  std::unique_ptr<const NeedleFans> fans_;
  Index level_ = -1;
  std::shared_ptr<AssemblyMemory> memory_;
  std::optional<EarlierResult> earlier_;
  std::optional<KnownCuts> known_;
  std::shared_ptr<CutTable> cuts_;
  std::shared_ptr<FaceMeshes> meshes_;  ///< made by mesh()
  std::vector<char> isChanged_;
  std::mutex mutex_;  ///< of what is remembered of large faces
  enum class Crowd : std::int8_t { Unknown, Few, Many };
  mutable std::vector<std::atomic<Crowd>> crowding_;
  PerThread<std::unique_ptr<Worker>> workers_;
};

}  // namespace footfall::detail
