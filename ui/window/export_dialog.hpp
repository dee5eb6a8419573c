// The dialog for exports: the target, what its format keeps and loses, options, the files, and their place.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <functional>
#include <map>
#include <memory>
#include <vector>

#include "ui/base/widgets/number_field.hpp"
#include "ui/base/work/background_queue.hpp"
#include "ui/document/export_settings.hpp"
#include "ui/run/run_controller.hpp"
#include "ui/window/plan_choices.hpp"

namespace footfall::ui {

/// The content to export when the dialog was opened.
struct ExportSource {
  std::shared_ptr<const FinishedRun> run;  ///< may be null: there is no result yet
  bool isUpToDate = true;                  ///< false: the export waits for the present run
  std::shared_ptr<const Environment> environment;
  std::vector<ExportExtra> placed;
  QSize view;  ///< logical pixels
  double devicePixelRatio = 1;
  LevelUnits units;
  /// The reason why a file must not be written; empty where it may be.
  std::function<QString(const QString& path)> refusal;
};

/// Shown with open(). The sizes of files are computed in the background, by making the files.
class ExportDialog : public QDialog {
  Q_OBJECT

 public:
  ExportDialog(ExportSource source, const ExportSettings& settings, const QString& path, QWidget* parent = nullptr);
  ~ExportDialog() override;

  [[nodiscard]] ExportSettings settings() const;
  [[nodiscard]] QString path() const;

 signals:
  void exportRequested(const QString& path, const footfall::ui::ExportSettings& settings);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void createWidgets();
  QWidget* createMeshOptions();
  QWidget* createFrameOptions();
  QWidget* createPolygonOptions();
  void createLayout();
  void takeSettings(const ExportSettings& settings);
  void takeName();
  void changeTarget();
  void browse();
  void readPath();
  void refresh();
  void estimate();
  /// Makes the dialog higher where its content needs more lines.
  void fitHeight();
  [[nodiscard]] QString problem() const;
  [[nodiscard]] QString content() const;
  [[nodiscard]] QString meshContent(const FormatDescriptor& format) const;
  [[nodiscard]] const ExportTarget& target() const;
  [[nodiscard]] ExportKind kind() const { return target().kind; }
  /// The existing files that may be replaced.
  [[nodiscard]] QStringList existing() const;
  void requestExport();

  ExportSource source_;
  const ExportTarget* shown_;                               ///< target whose options the widgets show
  std::map<const ExportTarget*, ExportSettings> settings_;  ///< settings of the other targets
  QComboBox *target_, *up_, *pictureSize_;
  QSpinBox* part_;
  QCheckBox *layers_, *connections_, *obstacleEdges_, *steps_, *drops_, *placed_, *pictures_, *bottlenecks_;
  NumberField* scale_;
  QLineEdit *path_, *coordinateSystem_;
  PlanChoices* plan_;
  QPushButton *browse_, *export_;
  QFormLayout* form_;
  QLabel *keeps_, *loses_, *content_, *size_, *problem_;
  QWidget *meshOptions_, *frameOptions_, *polygonOptions_, *pictureOptions_, *reportOptions_;
  std::shared_ptr<RunContext> estimating_;
  BackgroundQueue queue_;  // declared last: its thread ends before the other members are destroyed
};

}  // namespace footfall::ui
