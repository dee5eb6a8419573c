// The dialog for exports: format, options, what will be written, and where.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <functional>
#include <memory>
#include <vector>

#include "ui/base/background_queue.hpp"
#include "ui/base/number_field.hpp"
#include "ui/document/export_settings.hpp"
#include "ui/run/run_controller.hpp"

namespace footfall::ui {

/// What there is to export, as it was when the dialog was opened.
struct ExportSource {
  std::shared_ptr<const FinishedRun> run;  ///< may be null: there is no result yet
  bool isUpToDate = true;                  ///< false: the export waits for the run under way
  std::shared_ptr<const Environment> environment;
  std::vector<ExportExtra> placed;
  QSize view;  ///< logical pixels
  double devicePixelRatio = 1;
  /// Why a file must not be written to; empty where it may be.
  std::function<QString(const QString& path)> refusal;
};

/// Shown with open(). The size of files is computed in the background, by making them.
class ExportDialog : public QDialog {
  Q_OBJECT

 public:
  ExportDialog(ExportSource source, const ExportSettings& settings, const QString& path, QWidget* parent = nullptr);
  ~ExportDialog() override;

  [[nodiscard]] ExportSettings settings() const;
  [[nodiscard]] QString path() const;

 signals:
  void exportRequested(const QString& path, const footfall::ui::ExportSettings& settings);

 private:
  void createWidgets();
  void takeSettings(const ExportSettings& settings);
  void changeKind();
  void browse();
  void readPath();
  void refresh();
  void estimate();
  [[nodiscard]] QString problem() const;
  [[nodiscard]] QString content() const;
  [[nodiscard]] ExportKind kind() const;

  ExportSource source_;
  QComboBox *kind_, *up_, *pictureSize_;
  QCheckBox *layers_, *connections_, *obstacleEdges_, *steps_, *drops_, *placed_, *pictures_;
  NumberField* scale_;
  QLineEdit* path_;
  QPushButton *browse_, *export_;
  QLabel *content_, *size_, *problem_;
  QWidget *meshOptions_, *frameOptions_, *pictureOptions_, *reportOptions_;
  std::shared_ptr<RunContext> estimating_;
  BackgroundQueue queue_;  // last: its thread ends before the rest goes
};

}  // namespace footfall::ui
