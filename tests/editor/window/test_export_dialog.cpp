// Exports by mouse and keyboard in the real window: formats, options, pictures, reports, and what goes wrong.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCheckBox>
#include <QComboBox>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QSpinBox>
#include <atomic>
#include <chrono>
#include <thread>

#include "core/io/gltf_export.hpp"
#include "footfall/report.hpp"
#include "footfall/up_axis.hpp"
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

class TestExportDialog : public QObject {
  Q_OBJECT
 private slots:
  void init() {
    folder_ = std::make_unique<QTemporaryDir>();
    QSettings().clear();
    window_ = std::make_unique<EditorWindow>();
    window_->resize(1280, 800);
    QVERIFY(showWindow(*window_));
    QVERIFY(openZUp(*window_, writeFile(*folder_, "table.obj", tableObj()), kPipeline));
  }
  void cleanup() {
    window_.reset();
    folder_.reset();
  }

  void suggestsANameAndTellsWhatIsWritten() {
    ExportDialog* dialog = openDialog();
    QCOMPARE(dialog->path(), folder_->filePath("table-walkable.obj"));
    const auto run = window_->controller().finishedRun();
    const QString content = label("exportContent");
    QVERIFY2(content.startsWith(QString::number(run->result.mesh->triangles.size()) + " triangles, 1 layer, "),
             qPrintable(content));
    const std::size_t size = formatObj(*run->result.mesh, makeExportHeader(run->pipeline)).size();
    QTRY_COMPARE(label("exportSize"), "Size: " + QLocale(QLocale::English).formattedDataSize(qint64(size)));
    shoot(*dialog, "export-obj");
    QTest::keyClick(dialog, Qt::Key_Escape);
    QVERIFY(QTest::qWaitFor([&] { return QApplication::activeModalWidget() == nullptr; }));
    QCOMPARE(QDir(folder_->path()).entryList(QDir::Files), QStringList{"table.obj"});
  }

  void againAndAfterEachRun() {
    QAction *again = window_->findChild<QAction*>("file.exportAgain"),
            *live = window_->findChild<QAction*>("file.exportAfterRuns");
    QVERIFY(!again->isEnabled() && !live->isEnabled());
    const QString path = folder_->filePath("again.obj");
    const auto run = [&](const char* pipeline) {
      partOf<Document>(*window_).replacePipeline(parsePipeline(pipeline, "test"), "filters");
      return waitUntilIdle(*window_);
    };
    openDialog();
    const QByteArray first = accept("again.obj");
    QVERIFY(!first.isEmpty());
    QVERIFY(QFile::remove(path));
    QTest::keyClick(window_.get(), Qt::Key_E, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_COMPARE(readFile(path), first);
    // Each new result is written by itself, until that is switched off.
    live->trigger();
    QVERIFY(live->isChecked() && waitUntilIdle(*window_));
    QVERIFY(run("SlopeFilter 45\nVerticalClearanceFilter 0.5\nLayerSubdivisionFilter\n"));
    QTRY_VERIFY(readFile(path).contains("VerticalClearanceFilter 0.5"));
    live->trigger();
    QVERIFY(!live->isChecked());
    const QByteArray second = readFile(path);
    QVERIFY(run(kPipeline));
    QTest::qWait(300);
    QCOMPARE(readFile(path), second);
    // Targets of one level are not overwritten by the next.
    live->trigger();
    QTRY_COMPARE(readFile(path), first);
    QVERIFY(openZUp(*window_, writeFile(*folder_, "other.obj", floorObj()), kPipeline));
    QVERIFY(!again->isEnabled() && !live->isEnabled() && !live->isChecked());
    QTest::qWait(300);
    QCOMPARE(readFile(path), first);
  }

  // Each layer is a file: a second layer means a file that was not confirmed.
  void againReplacesNothingUnasked() {
    openDialog();
    QVERIFY(!accept("again.wkt").isEmpty());
    const QString second = folder_->filePath("again-1.wkt");
    writeFile(*folder_, "again-1.wkt", "mine");
    partOf<Document>(*window_).replacePipeline(
        parsePipeline("SlopeFilter 45\nVerticalClearanceFilter 0.5\nLayerSubdivisionFilter\n", "test"), "filters");
    QVERIFY(waitUntilIdle(*window_));
    window_->findChild<QAction*>("file.exportAgain")->trigger();
    QTRY_VERIFY2(partOf<MessageBar>(*window_).text().contains("again-1.wkt: already exists"),
                 qPrintable(partOf<MessageBar>(*window_).text()));
    QCOMPARE(readFile(second), QByteArray("mine"));
    QVERIFY(!QFile::exists(folder_->filePath("again-0.wkt")));
    QVERIFY(QFile::remove(second));
    window_->findChild<QAction*>("file.exportAgain")->trigger();
    QTRY_VERIFY(QFile::exists(second));
    QVERIFY(readFile(second).startsWith("POLYGON"));
  }

  void objWithOptions() {
    openDialog();
    for (const char* name : {"exportLayers", "exportConnections", "exportObstacleEdges"}) toggle(name);
    box("exportUp")->setFocus();
    QTest::keyClick(box("exportUp"), Qt::Key_Down);
    auto* scale = dialog()->findChild<QLineEdit*>("exportScale");
    scale->setFocus();
    QTest::keyClick(scale, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(scale, "100");
    const QByteArray text = accept("result.obj");
    QVERIFY(text.contains("# frame: Y up, 0.01 metres per unit\n"));
    QVERIFY(text.contains("g walkable\n") && !text.contains("layer_") && !text.contains("\nl "));
  }

  void everyUpAxis() {
    for (int i = 0; i < 6; ++i) {
      openDialog();
      box("exportUp")->setFocus();
      for (int k = 0; k <= i; ++k) QTest::keyClick(box("exportUp"), Qt::Key_Down);
      const std::string name = shownName(kUpAxes[static_cast<std::size_t>(i)]);
      QCOMPARE(box("exportUp")->currentText(), QString::fromStdString(name) + " up");
      QVERIFY(accept(("up" + std::to_string(i) + ".obj").c_str()).contains(("# frame: " + name + " up, ").c_str()));
    }
  }

  void gltfFollowsTheName() {
    for (const char* name : {"result.gltf", "result.glb"}) {
      openDialog();
      const QByteArray bytes = accept(name);
      const auto run = window_->controller().finishedRun();
      const GltfFile expected = formatGltf(QString(name).endsWith("glb") ? GltfKind::Binary : GltfKind::Text,
                                           *run->result.mesh, makeExportHeader(run->pipeline));
      QCOMPARE(bytes, QByteArray::fromStdString(expected.bytes));
    }
    // The target is remembered, and the suggested name has its ending.
    QVERIFY(openDialog()->path().endsWith("table-walkable.glb"));
    QCOMPARE(box("exportUp")->isVisible(), false);
  }

  void theNameFollowsTheTarget() {
    ExportDialog* dialog = openDialog();
    QStringList endings{QFileInfo(dialog->path()).suffix()};
    for (std::size_t i = 1; i < exportTargets().size(); ++i) {
      box("exportTarget")->setFocus();
      QTest::keyClick(box("exportTarget"), Qt::Key_Down);
      const ExportTarget& target = exportTargets()[i];
      QVERIFY(dialog->settings().target == &target);
      endings << QFileInfo(dialog->path()).suffix();
      QCOMPARE(label("exportKeeps").isEmpty(), target.kind == ExportKind::Png || target.kind == ExportKind::Html);
      if (const FormatDescriptor* format = meshFormat(target.kind)) {
        QCOMPARE(label("exportKeeps"), QString(format->keeps.english));
        QCOMPARE(label("exportLoses"), QString(format->loses.english));
      }
      QCOMPARE(box("planPages")->isVisible(), isPlan(target.kind));
      QVERIFY2(button("exportAccept")->isEnabled(), target.id);
    }
    QCOMPARE(endings, (QStringList{"obj", "glb", "tres", "tres", "glb", "bin", "glb", "gltf", "wkt", "geojson", "pdf",
                                   "svg", "png", "html"}));
    QVERIFY(!box("exportPictureSize")->isVisible());
    shoot(*dialog, "export-html");
  }

  // The options of one target are kept for it, in the dialog, in the next one, and after a start.
  void optionsAreRememberedForEachTarget() {
    openDialog();
    chooseTarget("godot-3");
    toggle("exportSteps");
    chooseTarget("obj");
    QVERIFY(dialog()->settings().options.steps);
    toggle("exportLayers");
    chooseTarget("godot-3");
    QVERIFY(!dialog()->settings().options.steps && dialog()->settings().options.layers);
    const QByteArray three = accept("level.tres");
    QVERIFY2(three.contains("format=2"), three.left(100).constData());
    window_.reset();
    window_ = std::make_unique<EditorWindow>();
    window_->resize(1024, 700);
    QVERIFY(showWindow(*window_));
    QVERIFY(openZUp(*window_, folder_->filePath("table.obj"), kPipeline));
    QVERIFY(openDialog()->settings().target == &exportTarget("godot-3"));
    QVERIFY(!dialog()->settings().options.steps);
    chooseTarget("godot-4");
    QVERIFY(dialog()->settings().options.steps);
    QVERIFY(accept("level4.tres").contains("format=3"));
    // Again and after each run keep to it.
    QVERIFY(QFile::remove(folder_->filePath("level4.tres")));
    window_->findChild<QAction*>("file.exportAgain")->trigger();
    QTRY_VERIFY(readFile(folder_->filePath("level4.tres")).contains("format=3"));
  }

  void polygonsOfAPart() {
    openDialog();
    chooseTarget("maps");
    auto* part = dialog()->findChild<QSpinBox*>("exportPart");
    auto* system = dialog()->findChild<QLineEdit*>("exportCoordinateSystem");
    QVERIFY(part->isVisible() && system->isVisible());
    system->setFocus();
    QTest::keyClicks(system, "25832");
    QVERIFY(!button("exportAccept")->isEnabled());
    QVERIFY(label("rowError").contains("EPSG:25832"));
    QTest::keyClick(system, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(system, "EPSG:25832");
    part->setValue(99);
    QTRY_VERIFY(label("exportSize").contains("no connected part 99"));
    part->setValue(1);
    const QByteArray json = accept("level.geojson");
    QVERIFY(json.contains("EPSG::25832") && json.contains("\"part\": 1") && !json.contains("\"part\": 2"));
    openDialog();
    chooseTarget("simulators");
    QVERIFY(!dialog()->findChild<QLineEdit*>("exportCoordinateSystem")->isVisible());
    QTRY_VERIFY(label("exportSize").contains("files, the first is "));
    QVERIFY(accept("level.wkt").contains("POLYGON (("));
    QVERIFY(QFile::exists(folder_->filePath("level-links.wkt")));
  }

  void picturesInAllSizes() {
    const QSize view = window_->view().size();
    const QList<QSize> sizes{view, view * 2, view * 4, QSize(3840, 2160)};
    for (int i = 0; i < 4; ++i) {
      openDialog();
      name()->setFocus();
      QTest::keyClick(name(), Qt::Key_A, Qt::ControlModifier);
      QTest::keyClicks(name(), folder_->filePath(QString("picture%1.png").arg(i)));
      QVERIFY(box("exportPictureSize")->isVisible());
      box("exportPictureSize")->setFocus();
      for (int k = 0; k < 4; ++k) QTest::keyClick(box("exportPictureSize"), Qt::Key_Up);
      for (int k = 0; k < i; ++k) QTest::keyClick(box("exportPictureSize"), Qt::Key_Down);
      press("exportAccept");
      const QString file = folder_->filePath(QString("picture%1.png").arg(i));
      QVERIFY(QTest::qWaitFor([&] { return QFile::exists(file) && window_->idle(); }, 20000));
      const QImage image(file);
      QCOMPARE(image.size(), sizes[i] * (i < 3 ? window_->view().devicePixelRatioF() : 1));
      // The middle of the picture shows the table; it looks the same in every size.
      const QColor middle = image.pixelColor(image.width() / 2, image.height() / 2);
      QVERIFY(middle.green() > middle.red());
      QCOMPARE(window_->view().size(), view);
      if (!qEnvironmentVariable("FOOTFALL_TEST_PICTURES").isEmpty())
        QFile::copy(file, qEnvironmentVariable("FOOTFALL_TEST_PICTURES") + QString("/picture%1.png").arg(i));
    }
  }

  void aReportWithPictures() {
    window_->view().cameraController().zoomBy(2);  // not one of the report's own
    const CameraPose pose = window_->view().cameraController().pose();
    openDialog();
    const QByteArray html = accept("report.html");
    QVERIFY(html.startsWith("<!DOCTYPE html>"));
    QCOMPARE(html.count("<figure>"), 3);
    QVERIFY(html.contains("From the top") && html.contains("VerticalClearanceFilter 2"));
    const CameraPose after = window_->view().cameraController().pose();
    QVERIFY(std::hypot(after.position.x - pose.position.x, after.position.y - pose.position.y) < 1e-6);
    QCOMPARE(after.orthographic, pose.orthographic);
    // Different pictures.
    const QByteArrayList parts = html.mid(html.indexOf("<figure>")).split(',');
    QSet<QByteArray> pictures;
    for (const QByteArray& part : parts)
      if (part.startsWith("iVBOR")) pictures << part.left(part.indexOf('"'));
    QCOMPARE(pictures.size(), 3);
    if (!qEnvironmentVariable("FOOTFALL_TEST_PICTURES").isEmpty())
      QFile::copy(folder_->filePath("report.html"), qEnvironmentVariable("FOOTFALL_TEST_PICTURES") + "/report.html");

    openDialog();
    toggle("exportPictures");
    const QByteArray plain = accept("plain.html");
    QCOMPARE(plain.count("data:image/png"), 0);
    QVERIFY(!plain.contains("Bottlenecks"));
    openDialog();
    toggle("exportBottlenecks");
    QVERIFY2(label("exportContent").endsWith("bottlenecks."), qPrintable(label("exportContent")));
    QVERIFY(accept("narrow.html").contains("Bottlenecks"));
  }

  void whatCannotBeWrittenIsToldBeforehand() {
    openDialog();
    typeName("/no/such/folder/a.obj");
    QVERIFY2(label("rowError").contains("does not exist"), qPrintable(label("rowError")));
    QVERIFY(!button("exportAccept")->isEnabled());
    typeName(folder_->filePath("a.fbx"));
    QVERIFY(label("rowError").contains("no format that can be written"));
    typeName("");
    QVERIFY(label("rowError").contains("Give a name"));
    typeName(folder_->path());
    QVERIFY(label("rowError").contains("is a folder"));
    typeName(folder_->filePath("a"));
    QCOMPARE(label("rowError"), QString());
    auto* scale = dialog()->findChild<QLineEdit*>("exportScale");
    scale->setFocus();
    QTest::keyClick(scale, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(scale, "-1");
    QVERIFY(!button("exportAccept")->isEnabled());
  }

  void afterTheDialogTheBarTells() {
    const QString full = folder_->filePath("full.glb");
    QVERIFY(QFile::link("/dev/full", full));
    window_->exportResult(full);
    QTRY_VERIFY(partOf<MessageBar>(*window_).text().contains("the disk is full"));
    for (const char* ending : {"obj", "gltf", "png", "html"}) {
      partOf<MessageBar>(*window_).clear();
      window_->exportResult(folder_->filePath(QString("no/such/folder/a.") + ending));
      QTRY_VERIFY2(partOf<MessageBar>(*window_).text().contains("its folder does not exist"), ending);
    }
    QVERIFY(waitUntilIdle(*window_));
  }

  void cancelledExportsLeaveTheFile() {
    const QString target = folder_->filePath("kept.obj");
    writeFile(*folder_, "kept.obj", "before");
    // One that goes on until it is cancelled, also when a run ends meanwhile.
    std::atomic<bool> begun{false};
    window_->writer().writeLong(
        [&begun, target](const RunContext& context) {
          begun = true;
          for (;; std::this_thread::sleep_for(std::chrono::milliseconds(1))) context.checkCancelled();
        },
        target);
    QTRY_VERIFY(begun);
    window_->controller().runNow();
    QTRY_VERIFY(!window_->controller().busy());
    QVERIFY(window_->findChild<QPushButton*>("cancel")->isVisible());
    QTest::mouseClick(window_->findChild<QPushButton*>("cancel"), Qt::LeftButton);
    QVERIFY(waitUntilIdle(*window_));
    QVERIFY(!window_->findChild<QPushButton*>("cancel")->isVisible());
    QVERIFY2(partOf<MessageBar>(*window_).text().contains("not written, as it was cancelled"),
             qPrintable(partOf<MessageBar>(*window_).text()));
    QCOMPARE(readFile(target), QByteArray("before"));
    window_->exportResult(target);
    QTRY_VERIFY(readFile(target).contains("# pipeline: "));
  }

  void waitsForTheRun() {
    DocumentState next = partOf<Document>(*window_).state();
    next.filters.front().step.values[0] = 80;  // the ramp is walkable now
    partOf<Document>(*window_).edit(next, "change the slope");
    const QString target = folder_->filePath("late.obj");
    window_->exportResult(target);
    QVERIFY(QTest::qWaitFor([&] { return QFile::exists(target) && window_->idle(); }, 20000));
    QVERIFY(readFile(target).contains("# pipeline: SlopeFilter 80\n"));
  }

  void everythingHasItsHeight() {
    openDialog();
    for (const ExportTarget& target : exportTargets()) {
      chooseTarget(target.id);
      QVERIFY(QTest::qWaitFor([&] { return label("exportSize") != "Size: ..."; }));
      QCoreApplication::processEvents();
      for (const QCheckBox* box : dialog()->findChildren<QCheckBox*>())
        if (box->isVisible()) QVERIFY2(box->height() >= box->sizeHint().height(), target.id);
      for (const QLabel* text : dialog()->findChildren<QLabel*>()) {
        if (!text->isVisible() || !text->hasHeightForWidth()) continue;
        const int needed = text->heightForWidth(text->width());
        QVERIFY2(
            text->height() >= needed && text->height() < needed + text->fontMetrics().height(),
            qPrintable(
                QString("%1: %2 has %3 of %4").arg(target.id, text->objectName()).arg(text->height()).arg(needed)));
      }
    }
  }

  void everythingIsReachedByTab() {
    openDialog();
    name()->setFocus();
    QStringList order;
    for (int i = 0; i < 13; ++i) {
      order << dialog()->focusWidget()->objectName();
      QTest::keyClick(dialog()->focusWidget(), Qt::Key_Tab);
    }
    for (const char* wanted :
         {"fileNameEdit", "exportBrowse", "exportTarget", "exportLayers", "exportConnections", "exportObstacleEdges",
          "exportDrops", "exportUp", "exportScale", "exportAccept", "exportCancel"})
      QVERIFY2(order.contains(wanted), qPrintable(wanted + QString(": ") + order.join(' ')));
    QVERIFY(order.lastIndexOf("fileNameEdit") > 0);  // and around again
  }

 private:
  ExportDialog* dialog() { return qobject_cast<ExportDialog*>(QApplication::activeModalWidget()); }
  ExportDialog* openDialog() {
    window_->activateWindow();  // Needed after an earlier dialog, without a window manager.
    if (!QTest::qWaitForWindowActive(window_.get())) qFatal("the window does not get the focus");
    QTest::keyClick(window_.get(), Qt::Key_E, Qt::ControlModifier);
    if (!QTest::qWaitFor([&] { return dialog() != nullptr; })) qFatal("no dialog for exports");
    dialog()->activateWindow();
    if (!QTest::qWaitForWindowActive(dialog())) qFatal("the dialog does not get the focus");
    return dialog();
  }
  void chooseTarget(const char* id) {
    const int index = static_cast<int>(&exportTarget(id) - exportTargets().data());
    box("exportTarget")->setCurrentIndex(index);
    emit box("exportTarget")->activated(index);
  }
  QString label(const char* name) { return dialog()->findChild<QLabel*>(name)->text(); }
  QComboBox* box(const char* name) { return dialog()->findChild<QComboBox*>(name); }
  QPushButton* button(const char* name) { return dialog()->findChild<QPushButton*>(name); }
  QLineEdit* name() { return dialog()->findChild<QLineEdit*>("fileNameEdit"); }
  void toggle(const char* name) {
    auto* box = dialog()->findChild<QCheckBox*>(name);
    box->setFocus();
    QTest::keyClick(box, Qt::Key_Space);
  }
  void press(const char* name) {
    button(name)->setFocus();
    QTest::keyClick(button(name), Qt::Key_Space);
  }
  void typeName(const QString& path) {
    name()->setFocus();
    QTest::keyClick(name(), Qt::Key_A, Qt::ControlModifier);
    QTest::keyClick(name(), Qt::Key_Delete);
    QTest::keyClicks(name(), path);
  }
  /// Types the name, presses Return and gives what was written.
  QByteArray accept(const QString& file) {
    const QString path = folder_->filePath(file);
    typeName(path);
    QTest::keyClick(name(), Qt::Key_Return);
    if (!QTest::qWaitFor([&] { return QFile::exists(path) && window_->idle(); }, 20000)) return {};
    return readFile(path);
  }

  std::unique_ptr<QTemporaryDir> folder_;
  std::unique_ptr<EditorWindow> window_;
};

FOOTFALL_EDITOR_SUITE(TestExportDialog)
#include "test_export_dialog.moc"
