// Pictures of recent files: in the settings folder, on the welcome page, and gone with their files.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>

#include "tests/editor/editor_driver.hpp"
#include "tests/editor/window_parts.hpp"
#include "ui/window/recent/recent_photographer.hpp"
#include "ui/window/recent/recent_pictures.hpp"
#include "ui/window/welcome_page.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;

class TestRecentPictures : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    QSettings().remove("recentFiles");
    RecentPictures::ofUser().keepOnly({});
    folder_ = std::make_unique<QTemporaryDir>();
  }

  void picturesAreSmallAndBelongToAFile() {
    const RecentPictures pictures(folder_->filePath("pictures"));
    const QString one = folder_->filePath("one.obj"), two = folder_->filePath("two.obj");
    QVERIFY(pictures.find(one).isNull());
    QImage red(4000, 1000, QImage::Format_RGB32);
    red.fill(Qt::red);
    QVERIFY(pictures.store(one, red));
    red.fill(Qt::blue);
    QVERIFY(pictures.store(two, red));
    QCOMPARE(pictures.find(one).size(), RecentPictures::kSize);
    QCOMPARE(pictures.find(one).pixelColor(10, 10), QColor(Qt::red));
    QCOMPARE(pictures.find(two).pixelColor(10, 10), QColor(Qt::blue));
    QVERIFY(!pictures.store(one, {}));
    // Something else in its place is no picture.
    QVERIFY(QImage(5000, 5000, QImage::Format_Mono).save(pictures.pathOf(two), "PNG"));
    QVERIFY(pictures.find(two).isNull());
    QFile text(pictures.pathOf(two));
    QVERIFY(text.open(QIODevice::WriteOnly) && text.write("no picture") > 0);
    text.close();
    QVERIFY(pictures.find(two).isNull());
    pictures.keepOnly({one});
    QVERIFY(!pictures.find(one).isNull());
    QCOMPARE(QDir(folder_->filePath("pictures")).entryList(QDir::Files).size(), 1);
    // Where nothing can be written there is none.
    const RecentPictures nowhere(folder_->filePath("pictures") + "/" + QFileInfo(pictures.pathOf(one)).fileName() +
                                 "/below");
    QVERIFY(!nowhere.store(one, red) && nowhere.find(one).isNull());
  }

  void theWelcomePageShowsThem() {
    const QString table = writeFile(*folder_, "table.obj", tableObj());
    EditorWindow window;
    window.resize(1280, 800);
    QVERIFY(showWindow(window));
    partOf<RecentPhotographer>(window).setDelay(10);
    QSignalSpy changed(&partOf<RecentPhotographer>(window), &RecentPhotographer::changed);
    QVERIFY(openZUp(window, table, "SlopeFilter 45\nVerticalClearanceFilter 2\n"));
    QVERIFY(QTest::qWaitFor([&] { return changed.count() > 0; }, kWaitMs));
    const QImage stored = RecentPictures::ofUser().find(table);
    QCOMPARE(stored.size(), RecentPictures::kSize);
    QVERIFY(isColourful(stored));
    window.findChild<QAction*>("file.welcome")->trigger();
    QListWidget* list = partOf<WelcomePage>(window).recentList();
    QCOMPARE(list->count(), 1);
    const QImage shown = list->item(0)->icon().pixmap(list->iconSize()).toImage();
    QVERIFY(isColourful(shown));
    shoot(window, "welcome-pictures");
    // A file without one has a small icon in its place.
    QSettings().setValue("recentFiles", QStringList{table, writeFile(*folder_, "other.obj", floorObj())});
    window.findChild<QAction*>("file.welcome")->trigger();
    QCOMPARE(list->count(), 2);
    QVERIFY(!isColourful(list->item(1)->icon().pixmap(list->iconSize()).toImage()));
    // Off the list, the picture goes.
    list->setCurrentRow(0);
    list->setFocus();
    QTest::keyClick(list, Qt::Key_Delete);
    QTRY_VERIFY(!QFile::exists(RecentPictures::ofUser().pathOf(table)));
  }

  void nothingIsKeptWhereNothingIsRemembered() {
    EditorWindow window;
    window.setRemembering(false);
    QVERIFY(showWindow(window));
    const QString table = writeFile(*folder_, "table.obj", tableObj());
    QVERIFY(openZUp(window, table, "SlopeFilter 45\n"));
    QVERIFY(QTest::qWaitFor([&] { return window.view().isWhole(); }, kWaitMs));
    partOf<RecentPhotographer>(window).take();
    QTest::qWait(50);
    QVERIFY(!QFile::exists(RecentPictures::ofUser().pathOf(table)));
  }

 private:
  /// Floors are coloured; icons and backgrounds are grey.
  static bool isColourful(const QImage& image) {
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x)
        if (image.pixelColor(x, y).alpha() > 200 && image.pixelColor(x, y).saturation() > 100) return true;
    return false;
  }

  std::unique_ptr<QTemporaryDir> folder_;
};

FOOTFALL_EDITOR_SUITE(TestRecentPictures)
#include "test_recent_pictures.moc"
