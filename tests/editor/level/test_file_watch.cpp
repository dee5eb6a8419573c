// Files that other programs save while the editor has them open.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QFile>
#include <QSettings>
#include <cstring>

#include "footfall/edit.hpp"
#include "tests/editor/editor_driver.hpp"
#include "tests/editor/window_parts.hpp"
#include "ui/base/messages/message_bar.hpp"
#include "ui/level/environment_tools.hpp"
#include "ui/level/import_panel.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;
using namespace std::chrono_literals;

namespace {

constexpr const char* kPipeline = "SlopeFilter 45\nVerticalClearanceFilter 2\n";
constexpr FileWatch::Timings kQuick{150ms, 60ms, 60ms};

/// The floor with a board over it whose plan area is `size` squared, and a fence far off that stays as it is.
QByteArray boardObj(int size, double height = 1) {
  const QByteArray s = QByteArray::number(size), z = QByteArray::number(height);
  QByteArray text = "o floor\n" + floorObj() + "o board\nv 0 0 " + z + "\nv " + s + " 0 " + z + "\nv " + s + ' ' + s +
                    ' ' + z + "\nv 0 " + s + ' ' + z + "\nf 5 6 7 8\no fence\n";
  for (int i = 0; i < 10; ++i) {
    const QByteArray x = QByteArray::number(10 + i);
    text += "v " + x + " 0 0\nv " + x + " 1 0\nv " + x + " 0 1\nf -3 -2 -1\n";
  }
  return text;
}

QByteArray gltfBuffer(float size) {
  const float positions[9] = {0, 0, 0, size, 0, 0, 0, 0, -size};  // Y up: faces up
  QByteArray bytes(sizeof positions, Qt::Uninitialized);
  std::memcpy(bytes.data(), positions, sizeof positions);
  return bytes;
}

const QByteArray kGltf =
    R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"name":"triangle"}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,-9],"max":[9,0,0]}],
"bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":36}],
"buffers":[{"byteLength":36,"uri":"triangle.bin"}]})";

}  // namespace

class TestFileWatch : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    QSettings().remove("watchFile");
    folder_ = std::make_unique<QTemporaryDir>();
    path_ = writeFile(*folder_, "level.obj", boardObj(2));
    window_ = std::make_unique<EditorWindow>();
    window_->resize(1100, 800);
    QVERIFY(showWindow(*window_));
    QVERIFY(openZUp(*window_, path_, kPipeline));
    tools().watch().setTimings(kQuick);
    done_ = std::make_unique<QSignalSpy>(&window_->file(), &LevelFile::rereadDone);
    QCOMPARE(freeFloor(), 60.0);
  }
  void cleanup() {
    done_.reset();
    window_.reset();
  }

  void whatAnotherProgramSavesIsReadAgain() {
    window_->view().cameraController().viewFromTop();
    window_->view().cameraController().zoomBy(1.5);
    DocumentState state = partOf<Document>(*window_).state();
    state.partRules = {{"board", "", PartRole::ObstacleOnly}};
    partOf<Document>(*window_).edit(std::move(state), "role");
    QVERIFY(waitUntilIdle(*window_));
    const QPoint shown = placeOnScreen({1, 1, 0});
    const auto before = partOf<LevelComposer>(*window_).level();
    writeFile(*folder_, "level.obj", boardObj(3));
    QTRY_COMPARE(done_->count(), 1);
    QCOMPARE(partOf<MessageBar>(*window_).text(), QString("level.obj changed on disk; read again"));
    QCOMPARE(area(), 55.0);
    QVERIFY(partOf<LevelComposer>(*window_).level()->edit &&
            partOf<LevelComposer>(*window_).level()->edit->base.lock() == before);  // computed as a change
    QCOMPARE(partOf<Document>(*window_).state().partRules.size(), std::size_t{1});
    QVERIFY(partOf<Document>(*window_).undoStack()->canUndo());
    // The message takes a strip of the view; the picture stays where it is.
    QVERIFY((placeOnScreen({1, 1, 0}) - shown).manhattanLength() <= 2);
    QCOMPARE(filterNames(*window_), QStringList({"SlopeFilter", "VerticalClearanceFilter"}));
    QCOMPARE(window_->view().environmentGeometry()->surface.size(),
             partOf<LevelComposer>(*window_).level()->triangles.size() * 3);
    QTest::qWait(400);
    QCOMPARE(done_->count(), 1);  // once
  }

  void filesThatAreReplaced() {
    for (const int size : {3, 1}) {
      const QString temporary = writeFile(*folder_, "level.obj.tmp", boardObj(size));
      done_->clear();
      QVERIFY(QFile::remove(path_));
      QVERIFY(QFile::rename(temporary, path_));
      QTRY_COMPARE(done_->count(), 1);
      QCOMPARE(freeFloor(), 64.0 - size * size);
    }
  }

  void theSameContentChangesNothing() {
    writeFile(*folder_, "level.obj", boardObj(2));
    QTRY_COMPARE(done_->count(), 1);
    QCOMPARE(freeFloor(), 60.0);
  }

  void halfWrittenFilesAreWaitedFor() {
    const QByteArray whole = boardObj(3);
    QFile file(path_);
    QVERIFY(file.open(QIODevice::WriteOnly));
    QSignalSpy failed(&window_->file(), &LevelFile::rereadFailed);
    QVERIFY(file.write(whole.left(13)) > 0 && file.flush());  // ends inside a vertex
    QTRY_VERIFY(failed.count() >= 1);
    QVERIFY(partOf<MessageBar>(*window_).text().isEmpty());
    QVERIFY(file.write(whole.mid(13)) > 0);
    file.close();
    QTRY_COMPARE(done_->count(), 1);
    QCOMPARE(freeFloor(), 55.0);
  }

  void brokenFilesAreToldAndTheResultStays() {
    const auto run = window_->controller().finishedRun();
    writeFile(*folder_, "level.obj", "v 0 0 zero\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    QTRY_VERIFY_WITH_TIMEOUT(!partOf<MessageBar>(*window_).text().isEmpty(), 10000);
    const QString text = partOf<MessageBar>(*window_).text();
    QVERIFY2(text.contains("level.obj changed on disk, but") && text.contains("level.obj:1"), qPrintable(text));
    QCOMPARE(window_->controller().finishedRun(), run);
    QCOMPARE(window_->file().environment()->triangles.size(), std::size_t{14});
    writeFile(*folder_, "level.obj", boardObj(1));
    QTRY_COMPARE(done_->count(), 1);
    QCOMPARE(freeFloor(), 63.0);
  }

  void filesThatVanishAndComeBack() {
    QVERIFY(QFile::remove(path_));
    QTRY_VERIFY(partOf<MessageBar>(*window_).text().startsWith("level.obj was deleted"));
    QCOMPARE(freeFloor(), 60.0);
    QCOMPARE(done_->count(), 0);
    writeFile(*folder_, "level.obj", boardObj(3));
    QTRY_COMPARE(done_->count(), 1);
    QCOMPARE(freeFloor(), 55.0);
  }

  void switchedOffAndOn() {
    QCheckBox* box = partOf<ImportPanel>(*window_).watchBox();
    QVERIFY(box->isChecked());
    QTest::mouseClick(box, Qt::LeftButton, Qt::NoModifier, {8, box->height() / 2});
    QVERIFY(!box->isChecked() && !QSettings().value("watchFile").toBool());
    writeFile(*folder_, "level.obj", boardObj(3));
    QTest::qWait(600);
    QCOMPARE(done_->count(), 0);
    QTest::mouseClick(box, Qt::LeftButton, Qt::NoModifier, {8, box->height() / 2});
    QTRY_COMPARE(done_->count(), 1);
    QCOMPARE(freeFloor(), 55.0);
  }

  void ownWritesAreNotRead() {
    QSignalSpy written(window_.get(), &EditorWindow::written);
    window_->saveSession(folder_->filePath("level.footfall"));
    QVERIFY(written.wait());
    window_->exportResult(folder_->filePath("level-walkable.obj"));  // The export is beside the file.
    QVERIFY(written.wait());
    QTest::qWait(600);
    QCOMPARE(done_->count(), 0);
  }

  void anotherExtentKeepsTheView() {
    const Vec3 centre = window_->view().environmentGeometry()->centre;
    const QPoint shown = placeOnScreen({1, 1, 0});
    writeFile(*folder_, "level.obj", boardObj(2) + "o far\nv 100 0 0\nv 110 0 0\nv 100 10 0\nf -3 -2 -1\n");
    QTRY_COMPARE(done_->count(), 1);
    QCOMPARE(area(), 64.0 + 50.0);
    QVERIFY(window_->view().environmentGeometry()->centre == centre);
    QVERIFY((placeOnScreen({1, 1, 0}) - shown).manhattanLength() <= 2);
  }

  void buffersOfGltf() {
    writeFile(*folder_, "triangle.bin", gltfBuffer(4));
    const QString gltf = writeFile(*folder_, "level.gltf", kGltf);
    window_->openWith(gltf, parsePipeline(kPipeline, "test"), {});
    QTRY_VERIFY(window_->file().environment()->source == gltf.toStdString());
    QCOMPARE(area(), 8.0);
    writeFile(*folder_, "triangle.bin", gltfBuffer(2));
    QTRY_COMPARE(done_->count(), 1);
    QCOMPARE(area(), 2.0);
  }

  // The old file is not watched any more.
  void onlyTheOpenFileIsWatched() {
    const QString other = writeFile(*folder_, "other.obj", tableObj());
    QVERIFY(openZUp(*window_, other, kPipeline));
    QTRY_VERIFY(window_->file().environment()->source == other.toStdString());
    writeFile(*folder_, "level.obj", boardObj(3));
    QTest::qWait(500);
    QCOMPARE(done_->count(), 0);
  }

  void manyWritesAreOneChange() {
    FileWatch watch;
    watch.setTimings(kQuick);
    watch.watch(path_);
    QSignalSpy changed(&watch, &FileWatch::changed);
    for (int i = 0; i < 20; ++i) {
      writeFile(*folder_, "level.obj", boardObj(1 + i % 4) + QByteArray(i, '\n'));
      QTest::qWait(10);
    }
    QTRY_VERIFY(changed.count() >= 1);
    QTest::qWait(400);
    QVERIFY(changed.count() <= 2);  // a busy machine may pause between two of them
  }

 private:
  EnvironmentTools& tools() { return *window_->findChild<EnvironmentTools*>(); }
  /// The position of a place on the screen, in the window.
  QPoint placeOnScreen(const Vec3& place) {
    const auto at = window_->view().project(place);
    return at ? window_->view().mapTo(window_.get(), at->toPoint()) : QPoint();
  }
  double area() {
    if (!waitUntilIdle(*window_) || !window_->controller().upToDate()) return -1;
    return window_->controller().finishedRun()->result.summary.area;
  }
  /// The area of the floor without the board's own top.
  double freeFloor() {
    const double all = area();
    const auto& level = *partOf<LevelComposer>(*window_).level();
    double board = 0;
    for (std::size_t t = 0; t < level.triangles.size(); ++t) {
      if (level.partOf.empty() || level.parts[level.partOf[t]].mesh != "board") continue;
      const auto& [a, b, c] = level.triangles[t];
      const Vec3 &p = level.vertices[a], &q = level.vertices[b], &r = level.vertices[c];
      board += std::abs((q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x)) / 2;
    }
    return all - board;
  }

  std::unique_ptr<QTemporaryDir> folder_;
  std::unique_ptr<EditorWindow> window_;
  std::unique_ptr<QSignalSpy> done_;
  QString path_;
};

FOOTFALL_EDITOR_SUITE(TestFileWatch)
#include "test_file_watch.moc"
