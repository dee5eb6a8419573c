// The content of the view during runs: the last finished result, with the pieces of the next one that the present run
// has computed.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <optional>
#include <vector>

#include "ui/run/known_blocks.hpp"
#include "ui/run/provisional_content.hpp"
#include "ui/run/run_job.hpp"
#include "ui/view/cells/cell_block.hpp"

namespace footfall::ui {

/// Receivers of a signal may cancel its run; callers check afterwards whether the run still exists.
class RunDisplay : public QObject {
  Q_OBJECT

 public:
  /// Drops the result.
  void clear();
  /// Keeps the result of a finished run; show() emits the signals.
  void setResult(const RunJob& job, const RunOutcome& outcome);
  /// Sets more complete content of the same result.
  void setContent(const ViewContent& content);
  /// Shows the last result and its cells.
  void show();
  /// Shows the last result again after an unfinished run; has no effect where that run has shown nothing.
  void restore();
  /// Blocks of other filters or of another environment are not shown again.
  void forgetBlocks() { knownBlocks_.clear(); }

  [[nodiscard]] bool hasResult() const { return shown_.mesh != nullptr; }
  [[nodiscard]] std::shared_ptr<const NavigationMesh> result() const { return shown_.mesh; }
  /// Called when a run begins. `changesShown`: its changes are on the screen.
  void begin(bool changesShown);
  /// Shows the known changes of an edit over the last result, before its run.
  void showChanges(const EditPreview::Surfaces& changes);
  /// Returns whether the first event of the present run will change the picture.
  [[nodiscard]] bool waitsForPicture() const { return hasResult() && !lastPicture_; }
  /// Shows the cells of the present run, when they have changed.
  void showCells(const std::vector<RunEventBuffer::Block>& blocks);
  /// Shows the intermediate result of a run, when the last picture is old enough for the time that the view needs to
  /// draw one.
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

  ShownResult shown_;         ///< last finished run; it has no mesh when there is none
  bool provisional_ = false;  ///< the view shows content of an unfinished run
  KnownBlocks knownBlocks_;
  bool cellsShown_ = false;  ///< cells of an unfinished run are shown
  double pictureMs_ = 0;
  // State of the present run.
  std::optional<std::size_t> shownStep_;
  std::size_t shownParts_ = 0;
  std::optional<RunEventBuffer::Clock::time_point> lastPicture_;
  std::size_t cellEvents_ = 0;  ///< as many as have been shown
};

}  // namespace footfall::ui
