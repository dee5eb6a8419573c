// Pictures from all around: poses, files, and what stops them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QImageReader>
#include <QProcess>
#include <cmath>

#include "core/base/vector.hpp"
#include "tests/editor/editor_driver.hpp"
#include "tests/editor/window_parts.hpp"
#include "ui/base/messages/message_bar.hpp"
#include "ui/base/messages/status_line.hpp"
#include "ui/window/turntable/turntable_dialog.hpp"
#include "ui/window/turntable/turntable_feature.hpp"
#include "ui/window/turntable/turntable_poses.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;

namespace {

constexpr const char* kPipeline = "SlopeFilter 45\nVerticalClearanceFilter 2\n";

/// Half of the picture is 1: where a place is in the picture of an upright camera.
std::array<double, 2> placeInPicture(const CameraPose& pose, const Vec3& p, const QSize& picture, double field) {
  const Sight sight = sightOf(pose);
  const Vec3 ahead = directionOf(sight), up = directionOf({sight.turn, sight.pitch + 90}), right = cross(ahead, up);
  const Vec3 way = p - pose.position;
  const double tall = std::tan(field / 2), depth = dot(way, ahead);
  return {dot(way, right) / depth / tall * picture.height() / picture.width(), dot(way, up) / depth / tall};
}

}  // namespace

class TestTurntable : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    folder_ = std::make_unique<QTemporaryDir>();
    window_ = std::make_unique<EditorWindow>();
    window_->setRemembering(false);
    window_->resize(1100, 760);
    QVERIFY(showWindow(*window_));
    QVERIFY(openZUp(*window_, writeFile(*folder_, "table.obj", tableObj()), kPipeline));
  }
  void cleanup() {
    window_.reset();
    folder_.reset();
  }

  void allIsInSightFromAllAround() {
    const std::vector<Vec3> points{{0, 0, 0}, {10, 0, 0}, {10, 4, 0}, {0, 4, 0}, {5, 2, 3}, {0, 0, 3}};
    for (const QSize size : {QSize(1280, 720), QSize(400, 900)}) {
      for (const double pitch : {-90.0, -40.0, 0.0, 30.0}) {
        const auto poses = turntablePoses(points, {25, pitch}, 24, size, M_PI / 4);
        QCOMPARE(poses.size(), 24U);
        double farthest = 0;
        for (std::size_t i = 0; i < poses.size(); ++i) {
          for (const Vec3& p : points) {
            const auto [x, y] = placeInPicture(poses[i], p, size, M_PI / 4);
            QVERIFY2(std::fabs(x) < 0.9 && std::fabs(y) < 0.9, qPrintable(QString("%1: %2 %3").arg(i).arg(x).arg(y)));
            farthest = std::max({farthest, std::fabs(x), std::fabs(y)});
          }
          const double turn = std::remainder(sightOf(poses[i]).turn - 25 - 15.0 * static_cast<double>(i), 360);
          QVERIFY(std::fabs(turn) < 1e-6);
        }
        QVERIFY(farthest > 0.5);  // and it fills the picture
      }
    }
    QCOMPARE(turntablePoses({}, {0, 0}, 2, {100, 100}, 1).size(), 2U);
  }

  void framesAreWrittenInOrder() {
    const CameraPose before = window_->view().cameraController().pose();
    const QString folder = folder_->filePath("new/frames");
    QSignalSpy finished(&table(), &Turntable::finished), stopped(&table(), &Turntable::stopped);
    table().start({folder, 6, {320, 240}});
    QVERIFY(table().isRunning() && !window_->idle());
    QVERIFY(finished.wait(kWaitMs));
    QCOMPARE(stopped.count(), 0);
    QVERIFY(!table().isRunning() && window_->idle());
    QCOMPARE(QDir(folder).entryList(QDir::Files).size(), 6);
    QImage last;
    for (int i = 1; i <= 6; ++i) {
      const QImage frame(folder + QString("/frame_000%1.png").arg(i));
      QCOMPARE(frame.size(), QSize(320, 240));
      QVERIFY(frame != last);
      last = frame;
    }
    QVERIFY(window_->view().cameraController().pose() == before);
    QVERIFY(partOf<StatusLine>(*window_).text().contains("Wrote 6 frames"));
    // Not into the same folder again: a shorter sequence would leave frames of this one.
    table().start({folder, 4, {320, 240}});
    QVERIFY(partOf<MessageBar>(*window_).text().contains("has frames of another sequence"));
    QCOMPARE(QDir(folder).entryList(QDir::Files).size(), 6);
  }

  void messagesSayWhatToDo() {
    const auto messageFor = [&](const QString& folder, const QSize& size = {320, 240}) {
      QSignalSpy stopped(&table(), &Turntable::stopped);
      table().start({folder, 3, size});
      if (stopped.isEmpty()) stopped.wait(kWaitMs);
      return stopped.isEmpty() ? QString() : stopped.first().first().toString();
    };
    QVERIFY(messageFor({}).contains("name one"));
    QVERIFY(messageFor(folder_->filePath("table.obj")).endsWith("is a file; name a folder"));
    QVERIFY(messageFor(folder_->filePath("table.obj/frames")).contains("the folder cannot be made"));
    QVERIFY(messageFor(folder_->filePath("large"), {100000, 100000}).contains("choose a smaller size"));
    // A device that is always full takes the place of the last frame.
    const QString full = folder_->filePath("full");
    const auto fill = connect(&table(), &Turntable::progressed, this, [full](int written, int) {
      if (written == 1) QFile::link("/dev/full", turntableFrame(full, 3));
    });
    const QString message = messageFor(full);
    disconnect(fill);
    QVERIFY2(message.contains("the disk is full") && message.contains("2 of 3 frames are written"),
             qPrintable(message));
    QCOMPARE(partOf<MessageBar>(*window_).text(), message);
    const QString readOnly = folder_->filePath("read only");
    QVERIFY(QDir().mkpath(readOnly));
    QVERIFY(QFile::setPermissions(readOnly, QFile::ReadOwner | QFile::ExeOwner));
    if (QFileInfo(readOnly).isWritable()) return;  // the superuser may write everywhere
    const QString refusal = messageFor(readOnly);
    QVERIFY2(refusal.contains("permission"), qPrintable(refusal));
  }

  void escapeAndEditsEndIt() {
    QSignalSpy stopped(&table(), &Turntable::stopped), progressed(&table(), &Turntable::progressed);
    table().start({folder_->filePath("a"), 500, {320, 240}});
    QVERIFY(QTest::qWaitFor([&] { return progressed.count() > 2; }, kWaitMs));
    QVERIFY(window_->findChild<QPushButton*>("cancel")->isVisible());
    QTest::mouseClick(window_->findChild<QPushButton*>("cancel"), Qt::LeftButton);
    QCOMPARE(stopped.count(), 1);
    QVERIFY(stopped.first().first().toString().contains("of 500 frames are written, as the turntable was cancelled"));
    QVERIFY(!window_->findChild<QPushButton*>("cancel")->isVisible());
    table().start({folder_->filePath("b"), 500, {320, 240}});
    partOf<Document>(*window_).setValue(partOf<Document>(*window_).filters()[1].id, 0, 0.5, -1);
    QVERIFY(QTest::qWaitFor([&] { return stopped.count() == 2; }, kWaitMs));
    QVERIFY(stopped.last().first().toString().contains("as the filters run again"));
    QVERIFY(waitUntilIdle(*window_));
  }

  void theDialog() {
    window_->findChild<QAction*>("file.turntable")->trigger();
    auto* dialog = window_->findChild<TurntableDialog*>();
    QVERIFY(dialog);
    QVERIFY(dialog->folderField()->text().endsWith("table-turntable"));
    dialog->framesField()->setValue(2);
    dialog->sizeBox()->setCurrentIndex(0);
    shoot(*dialog, "turntable-dialog");
    QSignalSpy finished(&table(), &Turntable::finished);
    QTest::keyClick(dialog, Qt::Key_Return);
    QVERIFY(finished.wait(kWaitMs));
    QCOMPARE(QImage(folder_->filePath("table-turntable/frame_0002.png")).size(), QSize(960, 540));
    EditorWindow empty;
    QVERIFY(!empty.findChild<QAction*>("file.turntable")->isEnabled());
  }

  void fromTheCommandLine() {
    const QString level = folder_->filePath("table.obj"), frames = folder_->filePath("frames");
    QString error;
    QCOMPARE(run({level, "--up", "z", "--turntable", frames, "--frames", "4", "--size", "400x300"}, error), 0);
    QVERIFY2(!error.contains("footfall-editor:"), qPrintable(error));
    QCOMPARE(QDir(frames).entryList(QDir::Files),
             (QStringList{"frame_0001.png", "frame_0002.png", "frame_0003.png", "frame_0004.png"}));
    QCOMPARE(QImage(frames + "/frame_0003.png").size(), QSize(400, 300));
    QCOMPARE(run({level, "--turntable", frames, "--frames", "4"}, error), 1);
    QVERIFY2(error.contains("frames of another sequence"), qPrintable(error));
    QCOMPARE(run({level, "--turntable", level}, error), 1);
    QVERIFY2(error.contains("is a file; name a folder"), qPrintable(error));
    QCOMPARE(run({level, "--turntable", frames, "--frames", "1"}, error), 2);
    QCOMPARE(run({level, "--frames", "4"}, error), 2);
    QCOMPARE(run({"--turntable", frames}, error), 2);
    QVERIFY2(error.contains("needs an environment"), qPrintable(error));
    QCOMPARE(run({level, "--turntable", frames, "--screenshot", "a.png"}, error), 2);
  }

 private:
  Turntable& table() { return window_->findChild<TurntableFeature*>()->turntable(); }
  static int run(const QStringList& arguments, QString& error) {
    QProcess process;
    process.start(FOOTFALL_EDITOR_PROGRAM, arguments);
    if (!process.waitForFinished(120000)) return -1;
    error = QString::fromUtf8(process.readAllStandardError());
    return process.exitCode();
  }

  std::unique_ptr<QTemporaryDir> folder_;
  std::unique_ptr<EditorWindow> window_;
};

FOOTFALL_EDITOR_SUITE(TestTurntable)
#include "test_turntable.moc"
