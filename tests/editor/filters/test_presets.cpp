// Presets: those that come along, and one's own as files.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QInputDialog>

#include "tests/editor/editor_driver.hpp"
#include "tests/editor/window_parts.hpp"
#include "ui/base/messages/message_bar.hpp"
#include "ui/filters/filter_list.hpp"

using namespace footfall;
using namespace footfall::ui;
using namespace footfall::test;

class TestPresets : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    folder_ = std::make_unique<QTemporaryDir>();
    QDir(settingsFolder()).removeRecursively();
    window_ = std::make_unique<EditorWindow>();
    window_->resize(1280, 800);
    QVERIFY(showWindow(*window_));
    QVERIFY(openZUp(*window_, writeFile(*folder_, "table.obj", tableObj()), "SlopeFilter 45\nAreaFilter 0.5\n"));
  }
  void cleanup() { window_.reset(); }

  void builtInPresetsAreThoseOfTheFiles() {
    for (const char* name : {"default", "parallel", "thesis_sequential", "thesis_parallel"}) {
      const std::string path = std::string(FOOTFALL_SOURCE_DIR "/resources/pipelines/") + name + ".pipeline";
      const Pipeline expected = readPipelineFile(path);
      QVERIFY2(std::ranges::any_of(builtInPresets(),
                                   [&](const auto& preset) { return builtInPipeline(preset, 1) == expected; }),
               name);
    }
    // Metres follow the scale, the thesis's units do not.
    QCOMPARE(builtInPipeline(builtInPresets()[0], 0.05).steps[3].values[0], 40.0);
    QCOMPARE(builtInPipeline(builtInPresets()[2], 0.05).steps[3].values[0], 3.0);
  }

  void oneClickTakesAPreset() {
    choose("Thesis, parallel");
    QCOMPARE(filterNames(*window_).size(), 13);
    QCOMPARE(partOf<Document>(*window_).undoStack()->undoText(), QString("Use preset Thesis, parallel"));
    QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(filterNames(*window_).size(), 2);
  }

  void ownPresetsAreKeptRenamedAndDeleted() {
    presets().saveAs();
    answerName("Mine & yours");
    QTRY_VERIFY(QFile::exists(settingsFolder() + "/Mine & yours.pipeline"));
    QCOMPARE(readFile(settingsFolder() + "/Mine & yours.pipeline"), QByteArray("SlopeFilter 45\nAreaFilter 0.5\n"));
    choose("Sequential");
    choose("Mine & yours");
    QCOMPARE(filterNames(*window_), (QStringList{"SlopeFilter", "AreaFilter"}));

    submenu("renamePreset")->actions()[0]->trigger();
    answerName("Others");
    QTRY_COMPARE(PresetStore(settingsFolder()).names(), QStringList{"Others"});

    submenu("deletePreset")->actions()[0]->trigger();
    QVERIFY(PresetStore(settingsFolder()).names().isEmpty());
    QVERIFY2(partOf<MessageBar>(*window_).text().contains("Others"), qPrintable(partOf<MessageBar>(*window_).text()));
    // Taken back.
    for (QPushButton* button : partOf<MessageBar>(*window_).findChildren<QPushButton*>()) {
      if (button->text() == "Undo") QTest::mouseClick(button, Qt::LeftButton);
    }
    QCOMPARE(PresetStore(settingsFolder()).names(), QStringList{"Others"});
    choose("Others");
  }

  void namesThatAreNoFilesAreRefused() {
    presets().saveAs();
    answerName("a/b");
    QTRY_VERIFY2(partOf<MessageBar>(*window_).text().contains("'/'"), qPrintable(partOf<MessageBar>(*window_).text()));
    for (const char* bad : {"", " x", ".hidden", "a\\b", "a\nb"}) QVERIFY2(!PresetStore::problemOf(bad).isEmpty(), bad);
    for (const char* good : {"a", "Größe 2.5", "thesis (5.4)"}) QVERIFY2(PresetStore::problemOf(good).isEmpty(), good);
  }

  void brokenFilesSayWhere() {
    QDir().mkpath(settingsFolder());
    QFile file(settingsFolder() + "/Broken.pipeline");
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("SlopeFilter 45\nNoFilter\n");
    file.close();
    choose("Broken");
    QVERIFY2(partOf<MessageBar>(*window_).text().contains("Broken.pipeline:2:1: unknown filter"),
             qPrintable(partOf<MessageBar>(*window_).text()));
    QCOMPARE(filterNames(*window_).size(), 2);
    const PresetStore store(settingsFolder());
    store.save("Good", partOf<Document>(*window_).pipeline());
    QVERIFY_THROWS_EXCEPTION(InputError, store.rename("Good", "Broken"));
    QVERIFY_THROWS_EXCEPTION(InputError, store.rename("Nowhere", "Else"));
    QVERIFY_THROWS_EXCEPTION(InputError, (void)store.remove("Nowhere"));
  }

 private:
  static QString settingsFolder() {
    return QStandardPaths::writableLocation(QStandardPaths::AppConfigLocation) + "/presets";
  }
  PresetsMenu& presets() { return *partOf<FilterList>(*window_).presets(); }
  void choose(const QString& name) {
    emit presets().aboutToShow();
    for (QAction* action : presets().actions()) {
      if (action->data() == QVariant(name)) {
        action->trigger();
        return;
      }
    }
    QFAIL(qPrintable(name));
  }
  QMenu* submenu(const char* name) {
    emit presets().aboutToShow();
    QList<QMenu*> found = presets().findChildren<QMenu*>(name);
    return found.back();
  }
  void answerName(const QString& name) {
    QInputDialog* dialog = nullptr;
    QVERIFY(QTest::qWaitFor([&] {
      for (auto* open : window_->findChildren<QInputDialog*>("presetName")) dialog = open->isVisible() ? open : dialog;
      return dialog != nullptr;
    }));
    auto* field = dialog->findChild<QLineEdit*>();
    QVERIFY(field);
    field->selectAll();
    QTest::keyClicks(field, name);
    QTest::keyClick(field, Qt::Key_Return);
  }

  std::unique_ptr<QTemporaryDir> folder_;
  std::unique_ptr<EditorWindow> window_;
};

FOOTFALL_EDITOR_SUITE(TestPresets)
#include "test_presets.moc"
