// Floor plans from the menu: the dialog, the file, and what is refused.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QComboBox>
#include <QFileDialog>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>

#include "tests/editor/editor_driver.hpp"
#include "ui/window/floor_plan_dialog.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;

namespace {

constexpr const char* kPipeline = "SlopeFilter 45\nVerticalClearanceFilter 2\nLayerSubdivisionFilter\n";

}  // namespace

class TestFloorPlanDialog : public QObject {
  Q_OBJECT
 private slots:
  void init() {
    folder_ = std::make_unique<QTemporaryDir>();
    QSettings().clear();
    window_ = std::make_unique<EditorWindow>();
    window_->resize(1280, 800);
    QVERIFY(showWindow(*window_));
  }
  void cleanup() {
    window_.reset();
    folder_.reset();
  }

  void nothingToDrawYet() { QVERIFY(!window_->commands().find("file.plan")->isEnabled()); }

  void pdfOfTheStoreys() {
    open();
    FloorPlanDialog* dialog = showDialog();
    QVERIFY(dialog->options().pages == PlanPages::Storeys && !dialog->options().scale && !dialog->options().paper);
    save("plan.pdf");
    QVERIFY(readFile(folder_->filePath("plan.pdf")).startsWith("%PDF-"));
  }

  void svgAsChosen() {
    open();
    FloorPlanDialog* dialog = showDialog();
    choose("planPages", "One for each layer");
    choose("planScale", "1:200");
    choose("planPaper", "A3");
    choose("planColours", "Black and white");
    const PlanOptions options = dialog->options();
    QVERIFY(options.scale == 200 && options.paper == Paper::A3 && options.colours == PlanColours::BlackAndWhite);
    save("plan.svg");
    const QByteArray svg = readFile(folder_->filePath("plan.svg"));
    QVERIFY2(svg.contains("1:200") && svg.contains("Layer 0") && svg.contains("297mm"), svg.left(300).constData());
    QVERIFY(!svg.contains("#d6f0e6"));
  }

  void theEnvironmentIsNotWrittenOver() {
    open();
    showDialog();
    const QByteArray before = readFile(folder_->filePath("table.obj"));
    save("table.obj", false);
    QCOMPARE(readFile(folder_->filePath("table.obj")), before);
  }

 private:
  void open() { QVERIFY(openZUp(*window_, writeFile(*folder_, "table.obj", tableObj()), kPipeline)); }

  FloorPlanDialog* showDialog() {
    window_->commands().find("file.plan")->trigger();
    FloorPlanDialog* dialog = nullptr;
    if (!QTest::qWaitFor([&] { return (dialog = window_->findChild<FloorPlanDialog*>()) != nullptr; }))
      qFatal("no dialog");
    return dialog;
  }

  void choose(const char* name, const QString& text) {
    auto* box = window_->findChild<FloorPlanDialog*>()->findChild<QComboBox*>(name);
    QVERIFY(box->findText(text) >= 0);
    box->setCurrentIndex(box->findText(text));
  }

  void save(const QString& name, bool isWritten = true) {
    auto* dialog = window_->findChild<FloorPlanDialog*>();
    QTest::mouseClick(dialog->findChild<QPushButton*>("planSave"), Qt::LeftButton);
    QFileDialog* files = nullptr;
    QVERIFY(QTest::qWaitFor([&] { return (files = window_->findChild<QFileDialog*>()) != nullptr; }));
    files->findChild<QLineEdit*>("fileNameEdit")->setText(folder_->filePath(name));
    QMetaObject::invokeMethod(files, "accept");
    QVERIFY(waitUntilIdle(*window_));
    if (isWritten) QTRY_VERIFY(QFile::exists(folder_->filePath(name)));
  }

  std::unique_ptr<QTemporaryDir> folder_;
  std::unique_ptr<EditorWindow> window_;
};

FOOTFALL_EDITOR_SUITE(TestFloorPlanDialog)
#include "test_floor_plan_dialog.moc"
