// The core's messages in German: notes of filters, messages about files, values and pipelines.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/counted_text.hpp"
#include "core/pipeline/pipeline_fragment.hpp"
#include "footfall/errors.hpp"
#include "tests/editor/editor_driver.hpp"
#include "tests/editor/window_parts.hpp"
#include "ui/base/commands/translations.hpp"
#include "ui/base/messages/message_bar.hpp"
#include "ui/base/text/core_text.hpp"
#include "ui/base/widgets/number_field.hpp"
#include "ui/filters/filter_list.hpp"
#include "ui/filters/filter_row.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;

class TestGerman : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { loadTranslations("de"); }
  void init() {
    folder_ = std::make_unique<QTemporaryDir>();
    window_ = std::make_unique<EditorWindow>();
    window_->resize(1000, 700);
    QVERIFY(showWindow(*window_));
  }
  void cleanup() { window_.reset(); }

  void placesAreFilledAfterTranslation() {
    const Text place(FOOTFALL_TEXT("line %1"), 3);
    QCOMPARE(coreText(Text(Pattern{"%1: %2"}, place, "100%1")), QString("Zeile 3: 100%1"));
    QCOMPARE(coreText(Text("1 cell")), QString("1 cell"));  // a name is no sentence
    QCOMPARE(coreText(Text(FOOTFALL_TEXT("1 cell"))), QString("1 Zelle"));
    // Counts have groups of thousands, places in files have none.
    QCOMPARE(coreText(countedText(26815, FOOTFALL_TEXT("1 vertex"), FOOTFALL_TEXT("%1 vertices"))),
             QString("26.815 Ecken"));
    QCOMPARE(coreText(Text(Pattern{"%1: %2"}, 26815, "x")), QString("26815: x"));
    // So have decimals their comma; a version is no number.
    QCOMPARE(coreText(Text(Pattern{"%1, %2, %3, %4"}, "0.504", "-1.5", "1.2.3", ".5")),
             QString("0,504, -1,5, 1.2.3, .5"));
    QCOMPARE(coreText(Text(Pattern{"%1:%2:%3: %4"}, "a.obj", 1, 2, "1.5")), QString("a.obj:1:2: 1.5"));
    QCOMPARE(coreText(std::runtime_error("as it is")), QString("as it is"));
    QCOMPARE(coreText(InputError(FOOTFALL_TEXT("no such file"))), QString("diese Datei gibt es nicht"));
  }

  void notesOfFilters() {
    QVERIFY(openZUp(*window_, writeFile(*folder_, "table.obj", tableObj()),
                    "AutoStrategy\nVerticalClearanceFilter 2\nCollapse\nAreaFilter 5\nLayerSubdivisionFilter\n"));
    QVERIFY2(note(0).startsWith("1 Zelle; Gitterstrategie 1 · 1: Eine Zelle, weil "), qPrintable(note(0)));
    QCOMPARE(note(3), QString("1 von 3 Gebieten entfernt"));
    QCOMPARE(note(4), QString("1 Ebene, 0 Verbindungen"));
  }

  void messagesAboutFiles() {
    const QString path = writeFile(*folder_, "bad.obj", "v 0 0 0\nf 1 2 9\n");
    QCOMPARE(messageAfterOpening(path), path +
                                            ":2: Eckennummer 9 liegt außerhalb: Die Datei hat 1 Ecke; berichtigen Sie "
                                            "die Zeile, oder exportieren Sie die Datei noch einmal");
    const QString session = writeFile(*folder_, "bad.footfall", "{\"footfall_session\": 1");
    QVERIFY(messageAfterOpening(session).contains(": fehlerhaft bei Byte "));
    const QString pipeline = writeFile(*folder_, "bad.pipeline", "SlopeFilter\n");
    window_->openPipeline(pipeline);
    QCOMPARE(partOf<MessageBar>(*window_).text(),
             pipeline +
                 ":1:12: SlopeFilter braucht einen Wert für max_slope; schreiben Sie "
                 "zum Beispiel „SlopeFilter 45“");
  }

  void messagesAboutValuesAndBlocks() {
    QVERIFY(openZUp(*window_, writeFile(*folder_, "table.obj", tableObj()), "SlopeFilter 45\n"));
    FilterRow* row = partOf<FilterList>(*window_).rows()[0];
    auto* field = openField(*window_, 0);
    QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(field, "95");
    QVERIFY2(
        row->errorText().endsWith("95 liegt außerhalb des Bereichs; geben Sie eine Zahl über 0 und unter 90 (Grad)"),
        qPrintable(row->errorText()));
    QVERIFY(!row->errorText().contains("max_slope"));
    QTest::keyClick(field, Qt::Key_Escape);
    partOf<Document>(*window_).replacePipeline(parsePipelineFragment("GridStrategy 2 2\n", "test"), "test");
    QTRY_COMPARE(partOf<MessageBar>(*window_).text(),
                 QString("Schritt 1 (Gitterstrategie): Gitterstrategie beginnt einen parallelen Block, der nie "
                         "endet; setzen Sie ein Collapse dahinter"));
  }

 private:
  QString note(std::size_t step) const {
    return window_->controller().status(partOf<Document>(*window_).filters().at(step).id).note;
  }
  QString messageAfterOpening(const QString& path) {
    QSignalSpy failed(window_.get(), &EditorWindow::loadFailed);
    window_->open(path);
    return failed.count() > 0 || failed.wait() ? partOf<MessageBar>(*window_).text() : QString();
  }

  std::unique_ptr<QTemporaryDir> folder_;
  std::unique_ptr<EditorWindow> window_;
};

FOOTFALL_EDITOR_SUITE(TestGerman)
#include "test_german.moc"
