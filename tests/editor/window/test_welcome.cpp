// The welcome page, by mouse and keyboard.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>

#include "tests/editor/editor_driver.hpp"
#include "tests/editor/window_parts.hpp"
#include "ui/base/messages/message_bar.hpp"
#include "ui/window/welcome_page.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;

class TestWelcome : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    QSettings().remove("recentFiles");
    folder_ = std::make_unique<QTemporaryDir>();
    table_ = writeFile(*folder_, "table.obj", tableObj());
    window_ = std::make_unique<EditorWindow>();
    window_->resize(1280, 800);
    QVERIFY(showWindow(*window_));
  }
  void cleanup() { window_.reset(); }

  void isThereUntilSomethingIsLoaded() {
    WelcomePage& page = partOf<WelcomePage>(*window_);
    QVERIFY(page.isVisible());
    QVERIFY(!page.closeButton()->isVisible());
    QTest::keyClick(page.openButton(), Qt::Key_Escape);
    QVERIFY(page.isVisible());  // there is nothing behind it
    window_->open(table_);
    QVERIFY(QTest::qWaitFor([&] { return window_->file().environment() != nullptr; }));
    QVERIFY(!page.isVisible());
    window_->findChild<QAction*>("file.welcome")->trigger();
    QVERIFY(page.isVisible() && page.closeButton()->isVisible());
    QTest::keyClick(page.openButton(), Qt::Key_Escape);
    QVERIFY(!page.isVisible());
    QVERIFY(window_->view().hasFocus());
  }

  void nothingIsCutOffOnASmallScreen() {
    for (QWidget* widget : partOf<WelcomePage>(*window_).findChildren<QWidget*>()) {
      const auto* label = qobject_cast<QLabel*>(widget);
      if (!label || !label->isVisible() || label->text().isEmpty() || label->wordWrap()) continue;
      QVERIFY2(label->width() >= label->sizeHint().width() - 1, qPrintable(label->text()));
    }
    for (QToolButton* button : partOf<WelcomePage>(*window_).sampleButtons()) {
      const auto labels = button->findChildren<QLabel*>();
      for (const QLabel* label : labels) {
        QVERIFY2(button->rect().contains(label->geometry()), qPrintable(label->text()));
        if (!label->wordWrap()) continue;
        const int needed = label->heightForWidth(label->width());
        QVERIFY2(label->height() >= needed, qPrintable(QStringLiteral("%1: %2 of %3, button %4 of least %5")
                                                           .arg(label->text())
                                                           .arg(label->height())
                                                           .arg(needed)
                                                           .arg(button->height())
                                                           .arg(button->minimumHeight())));
      }
    }
  }

  void opensRecentFilesWithTheKeyboard() {
    window_->open(table_);
    QVERIFY(QTest::qWaitFor([&] { return window_->file().environment() != nullptr; }));
    QVERIFY(waitUntilIdle(*window_));
    EditorWindow other;
    other.resize(1100, 800);
    QVERIFY(showWindow(other));
    QListWidget* list = partOf<WelcomePage>(other).recentList();
    QCOMPARE(list->count(), 1);
    QVERIFY(list->item(0)->text().contains("table.obj"));
    list->setFocus();
    QTest::keyClick(list, Qt::Key_Down);
    QTest::keyClick(list, Qt::Key_Return);
    QVERIFY(QTest::qWaitFor([&] { return other.file().environment() != nullptr; }));
  }

  void opensRecentFilesWithTheMouse() {
    QSettings().setValue("recentFiles", QStringList{table_});
    window_->showWelcome(true);
    QListWidget* list = partOf<WelcomePage>(*window_).recentList();
    QTest::qWait(50);  // laid out
    QTest::mouseClick(list->viewport(), Qt::LeftButton, Qt::NoModifier, list->visualItemRect(list->item(0)).center());
    QVERIFY(QTest::qWaitFor([&] { return window_->file().environment() != nullptr; }));
  }

  void missingFilesAreToldAndCanBeTakenOff() {
    const QString gone = folder_->filePath("gone.obj");
    QSettings().setValue("recentFiles", QStringList{gone, table_});
    window_->showWelcome(true);
    WelcomePage& page = partOf<WelcomePage>(*window_);
    QListWidget* list = page.recentList();
    QCOMPARE(list->count(), 2);
    QVERIFY(list->item(0)->text().contains("missing"));
    list->setFocus();
    list->setCurrentRow(0);
    QTest::keyClick(list, Qt::Key_Return);
    QTest::qWait(100);
    QVERIFY(!window_->file().environment() && !partOf<MessageBar>(*window_).isVisible());
    QTest::keyClick(list, Qt::Key_Delete);
    QCOMPARE(list->count(), 1);
    QCOMPARE(QSettings().value("recentFiles").toStringList(), QStringList{table_});
    list->setCurrentRow(0);
    QTest::mouseClick(page.removeButton(), Qt::LeftButton);
    QCOMPARE(list->count(), 0);
    QVERIFY(QFile::exists(table_));  // only the list forgets it
  }

  void samplesOpenWithTheirPipelines() {
    const auto& buttons = partOf<WelcomePage>(*window_).sampleButtons();
    QVERIFY2(buttons.size() >= 6, "the samples of the source folder");
    QTest::keyClick(buttons.front(), Qt::Key_Space);
    QVERIFY(QTest::qWaitFor([&] { return window_->file().environment() != nullptr; }));
    QVERIFY(QString::fromStdString(window_->file().environment()->source).endsWith("rooms.obj"));
    QVERIFY(waitUntilIdle(*window_));
    QVERIFY(window_->controller().upToDate());
  }

  void samplesThatAreNotThereAreNotOffered() {
    QCOMPARE(findSamples(folder_->path()).size(), std::size_t{0});
    QCOMPARE(findSamples({}).size(), std::size_t{0});
    QDir(folder_->path()).mkdir("house");
    writeFile(*folder_, "house/house.obj", floorObj());
    const auto found = findSamples(folder_->path());
    QCOMPARE(found.size(), std::size_t{1});
    QVERIFY(found[0].pipeline.isEmpty());
  }

  void theLastSessionCanBeContinued() {
    QVERIFY(openZUp(*window_, table_, "SlopeFilter 33\n"));
    window_->close();
    window_.reset();  // all is written
    EditorWindow other;
    other.resize(1100, 800);
    QVERIFY(showWindow(other));
    other.offerRestoring();
    // It was closed properly.
    QVERIFY2(!partOf<MessageBar>(other).isVisible(), qPrintable(partOf<MessageBar>(other).text()));
    QPushButton* button = partOf<WelcomePage>(other).continueButton();
    QVERIFY(button->isVisible());
    QVERIFY(button->text().contains("table.obj"));
    QTest::mouseClick(button, Qt::LeftButton);
    QVERIFY(QTest::qWaitFor([&] { return other.file().environment() != nullptr; }));
    QCOMPARE(partOf<Document>(other).filters().at(0).step.values[0], 33.0);
    QVERIFY(!other.isWindowModified());
    QVERIFY(!other.windowTitle().contains("last-session"));
    QVERIFY(!QSettings().value("recentFiles").toStringList().join(' ').contains("last-session"));
  }

  void tabReachesEverything() {
    QSettings().setValue("recentFiles", QStringList{table_});
    window_->showWelcome(true);
    QTest::qWait(50);  // layouts show new widgets a moment later
    WelcomePage& page = partOf<WelcomePage>(*window_);
    QList<QWidget*> wanted{page.openButton(), page.recentList(), page.removeButton()};
    for (QToolButton* button : page.sampleButtons()) wanted << button;
    page.recentList()->setCurrentRow(0);
    page.openButton()->setFocus();
    for (int i = 0; i < 600 && !wanted.isEmpty(); ++i) {
      wanted.removeAll(QApplication::focusWidget());
      QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    }
    QVERIFY2(wanted.isEmpty(), wanted.isEmpty() ? "" : qPrintable(wanted.front()->objectName()));
  }

 private:
  std::unique_ptr<QTemporaryDir> folder_;
  std::unique_ptr<EditorWindow> window_;
  QString table_;
};

FOOTFALL_EDITOR_SUITE(TestWelcome)
#include "test_welcome.moc"
