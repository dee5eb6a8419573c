// Floor plans in the dialog for exports: options, files, and what is not replaced.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>

#include "tests/editor/editor_driver.hpp"
#include "tests/editor/window_parts.hpp"
#include "ui/base/messages/message_bar.hpp"
#include "ui/window/export_dialog.hpp"

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

  void nothingToDrawYet() { QVERIFY(!window_->findChild<QAction*>("file.plan")->isEnabled()); }

  void pdfOfTheStoreys() {
    open();
    ExportDialog* dialog = showDialog();
    QCOMPARE(dialog->path(), folder_->filePath("table-plan.pdf"));
    const PlanOptions plan = dialog->settings().plan;
    QVERIFY(plan.pages == PlanPages::Storeys && !plan.scale && !plan.paper);
    QVERIFY(!dialog->findChild<QLabel*>("exportKeeps")->text().isEmpty());
    QTRY_VERIFY(dialog->findChild<QLabel*>("exportSize")->text().startsWith("Size: "));
    shoot(*dialog, "export-plan");
    save("plan.pdf");
    QVERIFY(readFile(folder_->filePath("plan.pdf")).startsWith("%PDF-"));
  }

  void svgAsChosen() {
    open();
    ExportDialog* dialog = showDialog();
    name()->setText(folder_->filePath("plan.svg"));
    emit name()->textEdited(name()->text());
    choose("planPages", "One for each layer");
    choose("planScale", "1:200");
    choose("planPaper", "A3");
    choose("planColours", "Black and white");
    const PlanOptions options = dialog->settings().plan;
    QVERIFY(options.scale == 200 && options.paper == Paper::A3 && options.colours == PlanColours::BlackAndWhite);
    save("plan.svg");
    const QByteArray svg = readFile(folder_->filePath("plan.svg"));
    QVERIFY2(svg.contains("1:200") && svg.contains("Layer 0") && svg.contains("297mm"), svg.left(300).constData());
    QVERIFY(!svg.contains("#d6f0e6"));
    // Another plan keeps them, but for the scale.
    showDialog("plan-svg");
    const PlanOptions again = this->dialog()->settings().plan;
    QVERIFY(!again.scale && again.paper == Paper::A3 && again.pages == PlanPages::Layers);
  }

  void passagesAsChosen() {
    // Two rooms, and between them a doorway of 0.8.
    const QByteArray rooms =
        "v -4 -4 0\nv 4 -4 0\nv 4 4 0\nv -4 4 0\nf 1 2 3 4\n"
        "v 0 -4 3\nv 0 -0.4 3\nv 0 -0.4 0\nv 0 -4 0\nf 5 6 7 8\n"
        "v 0 0.4 3\nv 0 4 3\nv 0 4 0\nv 0 0.4 0\nf 9 10 11 12\n";
    QVERIFY(openZUp(*window_, writeFile(*folder_, "rooms.obj", rooms), kPipeline));
    showDialog("plan-svg");
    QVERIFY(!dialog()->settings().plan.hasCorridors && !dialog()->settings().plan.narrowerThan);
    save("plain.svg");
    const QByteArray plain = readFile(folder_->filePath("plain.svg"));
    QVERIFY(!plain.contains("0.80"));
    showDialog("plan-svg");
    auto* width = dialog()->findChild<NumberField*>("planWidth");
    QVERIFY(!width->isEnabled() && width->value() == 1);
    dialog()->findChild<QCheckBox*>("planBottlenecks")->click();
    dialog()->findChild<QCheckBox*>("planCorridors")->click();
    QVERIFY(width->isEnabled());
    QVERIFY(dialog()->settings().plan.hasCorridors && dialog()->settings().plan.narrowerThan == 1);
    type(*width, "-1");
    QVERIFY(!dialog()->findChild<QPushButton*>("exportAccept")->isEnabled());
    QVERIFY(dialog()->findChild<QLabel*>("rowError")->text().startsWith("Width of bottlenecks: "));
    type(*width, "0.9");
    QCOMPARE(dialog()->settings().plan.narrowerThan, 0.9);
    QTRY_VERIFY(dialog()->findChild<QLabel*>("exportSize")->text().startsWith("Size: "));
    shoot(*dialog(), "export-plan-passages");
    save("passages.svg");
    const QByteArray svg = readFile(folder_->filePath("passages.svg"));
    QVERIFY(svg.contains("0.80") && svg.size() > plain.size());
    // The map is remembered, the width of one level is not.
    showDialog("plan-svg");
    QVERIFY(dialog()->settings().plan.hasCorridors && !dialog()->settings().plan.narrowerThan);
  }

  // A tower has a page for each layer; existing files of these names need a confirmation.
  void pagesAreNotReplacedUnasked() {
    window_->openWith(QStringLiteral(FOOTFALL_SOURCE_DIR "/samples/tower/tower.obj"), parsePipeline(kPipeline, "test"),
                      {});
    QVERIFY(waitUntilIdle(*window_));
    QVERIFY(window_->controller().finishedRun()->result.mesh->layerCount > 1);
    writeFile(*folder_, "plan-1.svg", "mine");
    showDialog("plan-svg");
    choose("planPages", "One for each layer");
    name()->setText(folder_->filePath("plan.svg"));
    QTest::keyClick(name(), Qt::Key_Return);
    QMessageBox* question = nullptr;
    QVERIFY(
        QTest::qWaitFor([&] { return (question = window_->findChild<QMessageBox*>("replaceQuestion")) != nullptr; }));
    QVERIFY2(question->text().contains("plan-1.svg"), qPrintable(question->text()));
    QTest::keyClick(question, Qt::Key_Escape);
    QTRY_VERIFY(!window_->findChild<QMessageBox*>("replaceQuestion"));
    QVERIFY(!QFile::exists(folder_->filePath("plan-0.svg")));
    QCOMPARE(readFile(folder_->filePath("plan-1.svg")), QByteArray("mine"));
    QTest::keyClick(name(), Qt::Key_Return);
    QVERIFY(
        QTest::qWaitFor([&] { return (question = window_->findChild<QMessageBox*>("replaceQuestion")) != nullptr; }));
    question->findChild<QPushButton*>("replaceAccept")->click();
    QVERIFY(QTest::qWaitFor([&] { return QFile::exists(folder_->filePath("plan-0.svg")) && window_->idle(); }, 20000));
    QVERIFY(readFile(folder_->filePath("plan-1.svg")).startsWith("<?xml"));
    // Again: its own pages may go, but not what came since.
    QVERIFY(QFile::remove(folder_->filePath("plan-0.svg")));
    window_->findChild<QAction*>("file.exportAgain")->trigger();
    QTRY_VERIFY(QFile::exists(folder_->filePath("plan-0.svg")));
    QVERIFY(waitUntilIdle(*window_));
    QVERIFY(partOf<MessageBar>(*window_).text().isEmpty());
  }

  void theEnvironmentIsNotWrittenOver() {
    open();
    showDialog();
    const QByteArray before = readFile(folder_->filePath("table.obj"));
    name()->setText(folder_->filePath("table.obj"));
    emit name()->textEdited(name()->text());
    QVERIFY(!dialog()->findChild<QPushButton*>("exportAccept")->isEnabled());
    QCOMPARE(readFile(folder_->filePath("table.obj")), before);
  }

 private:
  void open() { QVERIFY(openZUp(*window_, writeFile(*folder_, "table.obj", tableObj()), kPipeline)); }

  ExportDialog* dialog() { return qobject_cast<ExportDialog*>(QApplication::activeModalWidget()); }
  QLineEdit* name() { return dialog()->findChild<QLineEdit*>("fileNameEdit"); }

  ExportDialog* showDialog(const char* target = nullptr) {
    window_->findChild<QAction*>("file.plan")->trigger();
    if (!QTest::qWaitFor([&] { return dialog() != nullptr; })) qFatal("no dialog");
    if (target) {
      auto* box = dialog()->findChild<QComboBox*>("exportTarget");
      box->setCurrentIndex(static_cast<int>(&exportTarget(target) - exportTargets().data()));
      emit box->activated(box->currentIndex());
    }
    return dialog();
  }

  void choose(const char* name, const QString& text) {
    auto* box = dialog()->findChild<QComboBox*>(name);
    QVERIFY(box->isVisible() && box->findText(text) >= 0);
    box->setCurrentIndex(box->findText(text));
  }

  void type(QLineEdit& field, const QString& text) {
    field.setFocus();
    field.selectAll();
    QTest::keyClicks(&field, text);
  }

  void save(const QString& file) {
    name()->setText(folder_->filePath(file));
    emit name()->textEdited(name()->text());
    QTest::mouseClick(dialog()->findChild<QPushButton*>("exportAccept"), Qt::LeftButton);
    QTRY_VERIFY(QFile::exists(folder_->filePath(file)));
    QVERIFY(waitUntilIdle(*window_));
  }

  std::unique_ptr<QTemporaryDir> folder_;
  std::unique_ptr<EditorWindow> window_;
};

FOOTFALL_EDITOR_SUITE(TestFloorPlanDialog)
#include "test_floor_plan_dialog.moc"
