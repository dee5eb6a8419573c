// What the view shows of runs: the last finished result, changed where the run under way already has pieces of the
// next.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <optional>
#include <vector>

#include "ui/run/known_blocks.hpp"
#include "ui/run/provisional_content.hpp"
#include "ui/run/run_job.hpp"
#include "ui/view/cell_block.hpp"

namespace footfall::ui {

/// What is connected to a signal may cancel the run that it is about: callers check whether it is still there.
class RunDisplay : public QObject {
  Q_OBJECT

 public:
  /// There is no result.
  void clear();
  /// Keeps the result of a finished run; show() emits the signals.
  void setResult(const RunJob& job, const RunOutcome& outcome);
  /// The same result, of which more is known.
  void setContent(const ViewContent& content);
  /// The last result and its cells.
  void show();
  /// The same in place of what a run that did not finish has shown; nothing where it has shown nothing.
  void restore();
  /// Blocks of other filters or of another environment are not shown again.
  void forgetBlocks() { knownBlocks_.clear(); }

  [[nodiscard]] bool hasResult() const { return shown_.mesh != nullptr; }
  [[nodiscard]] std::shared_ptr<const NavigationMesh> result() const { return shown_.mesh; }
  /// A run begins. `changesShown`: what it changes is on the screen.
  void begin(bool changesShown);
  /// Over the last result: what an edit changes, as far as that is known before its run.
  void showChanges(const EditPreview::Surfaces& changes);
  /// Whether the first event of the run under way will give something to show.
  [[nodiscard]] bool waitsForPicture() const { return hasResult() && !lastPicture_; }
  /// The cells of the run under way, where something about them is new.
  void showCells(const std::vector<RunEventBuffer::Block>& blocks);
  /// What the run has so far, where the last picture is old enough for what the view needs to draw one.
  void showParts(RunJob& job, const std::vector<RunEventBuffer::Step>& steps);
  void setPictureTime(double ms) { pictureMs_ = ms; }

 signals:
  void contentReady(const footfall::ui::ViewContent& content);
  void cellsChanged(const footfall::ui::CellBlocks& blocks);

 private:
  [[nodiscard]] bool pictureIsDue(const RunJob& job) const;
  [[nodiscard]] ViewContent contentOf(const RunJob& job, const RunEventBuffer::Step& step) const;
  void emitResult();
  void showKnownCells();

  ShownResult shown_;         ///< of the last finished run; no mesh when there is none
  bool provisional_ = false;  ///< the view shows something else, of a run that has not finished
  KnownBlocks knownBlocks_;
  bool cellsShown_ = false;  ///< there is something to take back
  double pictureMs_ = 0;
  // Of the run under way.
  std::optional<std::size_t> shownStep_;
  std::size_t shownParts_ = 0;
  std::optional<RunEventBuffer::Clock::time_point> lastPicture_;
  std::size_t cellEvents_ = 0;  ///< as many as have been shown
};

}  // namespace footfall::ui
