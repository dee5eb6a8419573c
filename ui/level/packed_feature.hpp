// Environments that are too large to be loaded: their display, and the part that runs use.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <QObject>
#include <QStatusBar>
#include <QTimer>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "ui/base/work/latest_work.hpp"
#include "ui/level/block_choice.hpp"
#include "ui/level/level_file.hpp"
#include "ui/view/feature_host.hpp"
#include "ui/view/level_view.hpp"

namespace footfall::ui {

/// Around the part that is the level, the view shows a coarse surface of everything, and the visible blocks in full.
/// Blocks are read in the background, and dropped when they are out of sight.
class PackedFeature : public QObject {
  Q_OBJECT

 public:
  PackedFeature(const FeatureHost& host, QStatusBar& bar, LevelView& view, LevelFile& file);

  /// Returns whether blocks are being read or chosen.
  [[nodiscard]] bool busy() const { return part_ && (work_.busy() || settling_.isActive()); }
  /// Makes the visible place the part that runs use.
  void runHere();
  /// The text of the status bar about the shown part; empty for environments that are loaded whole.
  [[nodiscard]] QString statusText() const { return status_->text(); }
  /// The numbers of the blocks that are shown in full.
  [[nodiscard]] std::set<std::size_t> loadedBlocks() const;

 signals:
  /// Emitted when runs use another part.
  void placeChanged();

 private:
  using Pieces = std::map<std::size_t, BackdropPiecePtr>;
  struct Blocks {
    Pieces pieces;
    std::set<std::size_t> damaged;
    QString problem;  ///< problem of a damaged block
  };

  void follow(Reading reading);
  void tellOfPart();
  void followCamera();
  void choose();
  void loadNext();
  void show();
  void drawFrame();
  void say();
  /// The coarse triangles beside the part, for the blocks that are not shown in full.
  [[nodiscard]] std::vector<Backdrop::Range> coarseRanges(const std::function<bool(std::size_t)>& isShown) const;
  [[nodiscard]] std::string savePlace() const;
  void loadPlace(const std::string& text);

  LevelView& view_;
  LevelFile& file_;
  MessageBar& messages_;
  StatusLine& note_;
  QAction* runHere_ = nullptr;
  QLabel* status_ = nullptr;
  std::shared_ptr<const PackedPart> part_;  ///< null: the environment is loaded
  std::vector<BlockInView> blocks_;
  Pieces loaded_;
  std::set<std::size_t> damaged_;
  std::vector<std::size_t> wanted_;
  SceneCamera seen_;
  QTimer settling_;  ///< runs until the camera has rested for a moment
  LatestWork work_;  // declared last: its thread ends before the other members are destroyed
};

}  // namespace footfall::ui
