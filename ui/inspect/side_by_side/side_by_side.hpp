// Two pipelines on one level, side by side in linked views.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>
#include <QSplitter>
#include <memory>
#include <optional>
#include <string>

#include "ui/base/work/latest_work.hpp"
#include "ui/document/document.hpp"
#include "ui/inspect/side_by_side/linked_view.hpp"
#include "ui/inspect/side_by_side/side_by_side_bar.hpp"
#include "ui/level/level_composer.hpp"
#include "ui/level/level_file.hpp"
#include "ui/run/run_controller.hpp"
#include "ui/view/feature_host.hpp"

namespace footfall::ui {

/// A is the list of filters, which is edited as ever; B is a pipeline that stays as it is, with runs of its own. A
/// child of its window; found as window.findChild<SideBySide*>().
class SideBySide : public QObject {
  Q_OBJECT

 public:
  /// `views` holds the view, and gets the other one beside it; it stands in a vertical layout, in which the bar comes
  /// above it.
  SideBySide(const FeatureHost& host, QSplitter& views, LevelView& view, Document& document, LevelFile& file,
             LevelComposer& composer, RunController& controller);
  ~SideBySide() override;

  /// Shows B beside A, or in place of another B.
  void open(const Pipeline& pipeline, const QString& name);
  void close();
  [[nodiscard]] bool isOpen() const { return pair_ != nullptr; }
  /// A run of B, or counting, is under way.
  [[nodiscard]] bool isBusy() const;

  [[nodiscard]] const Pipeline& other() const { return other_; }
  [[nodiscard]] SideBySideBar& bar() { return *bar_; }
  /// Null while it is closed.
  [[nodiscard]] LevelView* otherView() const;

 private:
  struct Pair;
  void fillSources();
  void openFile();
  void swap();
  void keep(bool b);
  void takeLevel();
  void takeFilters();
  void countA();
  void countB();
  void showFigures();
  [[nodiscard]] double shownWidth() const;
  [[nodiscard]] std::string save() const;
  void load(const std::string& text);

  QWidget& window_;  ///< parent of dialogs
  QSplitter& views_;
  LevelView& view_;
  Document& document_;
  LevelFile& file_;
  LevelComposer& composer_;
  RunController& controller_;
  MessageBar& messages_;
  SessionSections& sections_;
  QAction* action_;
  SideBySideBar* bar_;
  Pipeline other_;
  QString name_;
  double metresPerUnit_ = 1;          ///< the scale that `other_` is for
  bool isFromSession_ = false;        ///< B came with the file that is being opened
  std::optional<CameraPose> before_;  ///< the camera before the other view came; null once somebody has moved it
  std::optional<AgentFigures> a_, b_;
  std::unique_ptr<Pair> pair_;
  LatestWork countA_, countB_;  // last: their threads end before the rest goes
};

}  // namespace footfall::ui
