// Everything that the German editor shows is German, if it went through the translators.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAbstractButton>
#include <QComboBox>
#include <QDockWidget>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QMutex>
#include <QProcess>
#include <QProcessEnvironment>
#include <QRegularExpression>
#include <QSet>
#include <QTabBar>
#include <QTextEdit>
#include <QTranslator>
#include <QXmlStreamReader>

#include "tests/editor/editor_driver.hpp"
#include "ui/agents/agents_panel.hpp"
#include "ui/base/commands/command_palette.hpp"
#include "ui/base/commands/translations.hpp"
#include "ui/base/widgets/panel_dock.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;

namespace {

/// Remembers texts that no other translator has, by source text: it comes last.
class Unknown : public QTranslator {
 public:
  [[nodiscard]] QString translate(const char* context, const char* source, const char*, int) const override {
    const QMutexLocker lock(&mutex_);
    contexts_[QString::fromUtf8(source)] << QString::fromUtf8(context);
    return {};
  }
  [[nodiscard]] bool isEmpty() const override { return false; }
  [[nodiscard]] QMap<QString, QSet<QString>> contexts() const {
    const QMutexLocker lock(&mutex_);
    return contexts_;
  }

 private:
  mutable QMutex mutex_;
  mutable QMap<QString, QSet<QString>> contexts_;
};

/// The comparable part of a text: letters and blanks.
QString words(QString text) {
  static const QRegularExpression tags("<[^>]*>"), places("%n|%L?[1-9]"), others("[^\\p{L}]+");
  return text.replace(tags, " ").replace(places, " ").remove('&').replace(others, " ").trimmed();
}

/// All sources that have a translation, with the contexts that they are for.
QMap<QString, QSet<QString>> translatedSources() {
  QMap<QString, QSet<QString>> found;
  QFile file(FOOTFALL_SOURCE_DIR "/translations/footfall_de.ts");
  if (!file.open(QIODevice::ReadOnly)) return found;
  QXmlStreamReader xml(&file);
  QString context;
  while (!xml.atEnd()) {
    if (!xml.readNextStartElement() && xml.hasError()) break;
    if (xml.name() == QLatin1String("name")) context = xml.readElementText();
    if (xml.name() == QLatin1String("source")) found[xml.readElementText()] << context;
  }
  return found;
}

/// Visible texts by their words, each with where it was.
using Texts = QMap<QString, QString>;

void add(Texts& texts, const QString& text, const QObject* where, const char* what) {
  if (text.startsWith('/')) return;  // a path
  for (const QString& line : text.split('\n')) {
    if (!words(line).isEmpty())
      texts.insert(words(line),
                   QString("%1 '%2' %3: %4")
                       .arg(where->metaObject()->className(), where->objectName(), QLatin1String(what), line));
  }
}

void addModel(Texts& texts, const QAbstractItemView& view) {
  const QAbstractItemModel* model = view.model();
  if (!model) return;
  for (int column = 0; column < model->columnCount(view.rootIndex()); ++column) {
    for (const int role : {int(Qt::DisplayRole), int(Qt::ToolTipRole)}) {
      add(texts, model->headerData(column, Qt::Horizontal, role).toString(), &view, "header");
      for (int row = 0; row < std::min(300, model->rowCount(view.rootIndex())); ++row)
        add(texts, model->index(row, column, view.rootIndex()).data(role).toString(), &view, "cell");
    }
  }
}

void addWidget(Texts& texts, const QWidget& widget) {
  add(texts, widget.toolTip(), &widget, "tool tip");
  add(texts, widget.accessibleName(), &widget, "name");
  add(texts, widget.accessibleDescription(), &widget, "description");
  if (widget.isWindow() || qobject_cast<const QDockWidget*>(&widget))
    add(texts, widget.windowTitle(), &widget, "title");
  if (const auto* label = qobject_cast<const QLabel*>(&widget)) add(texts, label->text(), label, "text");
  if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) add(texts, button->text(), button, "text");
  if (const auto* group = qobject_cast<const QGroupBox*>(&widget)) add(texts, group->title(), group, "title");
  if (const auto* line = qobject_cast<const QLineEdit*>(&widget)) add(texts, line->placeholderText(), line, "hint");
  if (const auto* edit = qobject_cast<const QTextEdit*>(&widget)) add(texts, edit->toPlainText(), edit, "text");
  if (const auto* tabs = qobject_cast<const QTabBar*>(&widget))
    for (int i = 0; i < tabs->count(); ++i) add(texts, tabs->tabText(i), tabs, "tab");
  if (const auto* view = qobject_cast<const QAbstractItemView*>(&widget)) addModel(texts, *view);
  if (const auto* box = qobject_cast<const QComboBox*>(&widget))
    for (int i = 0; i < box->count(); ++i) add(texts, box->itemText(i), box, "entry");
}

void addAction(Texts& texts, const QAction& action) {
  add(texts, action.text(), &action, "text");
  add(texts, action.iconText(), &action, "icon text");
  add(texts, action.toolTip(), &action, "tool tip");
  add(texts, action.statusTip(), &action, "status tip");
}

Texts textsOf(const QWidget& window) {
  Texts texts;
  addWidget(texts, window);
  for (const QWidget* widget : window.findChildren<QWidget*>()) addWidget(texts, *widget);
  for (const QAction* action : window.findChildren<QAction*>()) addAction(texts, *action);
  return texts;
}

/// The same in both languages, and why.
const QSet<QString>& equalWords() {
  static const QSet<QString> words{
      // names of programs, of formats, and of what pipelines are written in
      "Footfall", "Unity", "Unreal", "Godot", "Recast", "Blender", "OBJ", "glTF", "GLB", "glb", "HTML", "PNG", "CSV",
      "EPSG", "Shift", "m", "s", "ms", "x", "y", "z", "X", "Y", "Z",
      // words that German shares with English
      "Name", "Filter", "Agent", "Block", "Format", "Parallel", "Threads", "Material", "Import", "Export", "Pipeline",
      "Status", "Start", "Version", "Modus", "OK", "Alt", "Plan", "Radius", "Villa", "Arena", "Docks"};
  return words;
}

}  // namespace

class TestUntranslated : public QObject {
  Q_OBJECT

 private slots:
  void everyShownTextHasBeenAskedForInGerman() {
    if (qEnvironmentVariableIsSet(kWalkTo)) return writeTexts(qEnvironmentVariable(kWalkTo));
    const QSet<QString> english = englishTexts();
    QCoreApplication::installTranslator(&unknown_);
    loadTranslations("de");
    const Texts german = walk();
    QVERIFY(english.size() > 400);
    const auto sources = translatedSources();
    QVERIFY(sources.size() > 500);
    // Requested texts without a translation: new if no context has them, else requested in a wrong one.
    QSet<QString> fresh;
    for (const QString& source : unknown_.contexts().keys()) {
      if (!sources.contains(source)) fresh << words(source);
    }
    QStringList wrong, waiting;
    for (auto it = german.begin(); it != german.end(); ++it) {
      if (!english.contains(it.key()) || isNoWord(it.key())) continue;
      // New texts come to the translators last; the test "translations" reports them.
      (fresh.contains(it.key()) ? waiting : wrong) << it.value();
    }
    if (!waiting.isEmpty())
      qWarning("waiting for a translation (%d):\n%s", int(waiting.size()), qPrintable(waiting.join("\n")));
    if (!wrong.isEmpty()) qWarning("English in the German editor:\n%s", qPrintable(wrong.join("\n")));
    QCOMPARE(wrong.size(), 0);
  }

 private:
  static constexpr const char* kWalkTo = "FOOTFALL_WALK_TO";  // names a file for the texts of an English editor

  /// The English texts come from a separate process, because some texts are made once, in the language of the moment.
  static QSet<QString> englishTexts() {
    const QTemporaryDir folder;
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(kWalkTo, folder.filePath("texts"));
    process.setProcessEnvironment(environment);
    process.start(QCoreApplication::applicationFilePath(), {});
    process.waitForFinished(120000);
    const QStringList lines = QString::fromUtf8(readFile(folder.filePath("texts"))).split('\n', Qt::SkipEmptyParts);
    return {lines.begin(), lines.end()};
  }

  void writeTexts(const QString& path) {
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(QStringList(walk().keys()).join('\n').toUtf8());
  }

  static bool isNoWord(const QString& text) {
    if (equalWords().contains(text)) return true;
    for (const QString& word : text.split(' ')) {
      // Filters and their parameters, as pipelines name them; files of this test.
      const bool isName = word.endsWith("Filter") || word.endsWith("Strategy") || word == "Collapse";
      if (word.size() > 2 && !isName && !equalWords().contains(word) && word != "table" && word != "obj") return false;
    }
    return true;
  }

  /// Opens all windows and collects their texts.
  Texts walk() {
    const QTemporaryDir folder;
    EditorWindow window;
    window.resize(1500, 1000);
    if (!showWindow(window)) return {};
    Texts texts = textsOf(window);
    const QByteArray level = tableObj() + "v 0 -4 0\nf 1 2 13\n";
    if (!openZUp(window, writeFile(folder, "table.obj", level),
                 "DuplicationFilter 0\nDegeneracyFilter\nAutoStrategy\nSlopeFilter 45\nVerticalClearanceFilter 2\n"
                 "Collapse\nAreaFilter 5\nSimplificationFilter\nLayerSubdivisionFilter\nRoundingFilter\n"))
      return {};
    for (auto* dock : window.findChildren<QDockWidget*>()) {
      bringToFront(*dock);
      QTest::qWait(30);
    }
    for (QMenu* menu : window.findChildren<QMenu*>()) emit menu->aboutToShow();
    texts.insert(textsOf(window));
    for (const char* tool : {"tools.path", "tools.measure", "tools.seeds", "inspect.why", "obstacle.box", "view.fly"}) {
      window.findChild<QAction*>(tool)->trigger();
      QTest::mouseClick(&window.view(), Qt::LeftButton, {}, window.view().rect().center());
      QTest::qWait(50);
      texts.insert(textsOf(window));
    }
    if (auto* add = window.findChild<QMenu*>("addAgentMenu"); add && !add->actions().isEmpty())
      add->actions().front()->trigger();
    for (const char* dialog : {"file.export", "help.keys", "help.about", "help.palette", "file.open"}) {
      window.findChild<QAction*>(dialog)->trigger();
      QWidget* shown = nullptr;
      if (!QTest::qWaitFor([&] { return (shown = QApplication::activeModalWidget()) != nullptr; })) continue;
      if (QByteArray(dialog) != "file.open") texts.insert(textsOf(*shown));
      shown->close();
      QTest::qWait(20);
    }
    for (const QByteArray id : {"view.cells", "view.cutPlane"}) window.findChild<QAction*>(id)->setChecked(true);
    QTest::qWait(200);
    texts.insert(textsOf(window));
    return texts;
  }

  Unknown unknown_;
};

FOOTFALL_EDITOR_SUITE(TestUntranslated)
#include "test_untranslated.moc"
