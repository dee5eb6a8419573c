#include "tests/editor/editor_driver.hpp"
#include "ui/command_palette.hpp"
#include "ui/help_panel.hpp"
#include "ui/log_panel.hpp"
#include "ui/shortcut_window.hpp"
#include "ui/theme.hpp"
#include "ui/translations.hpp"
#include "ui/welcome_page.hpp"
using namespace footfall;
using namespace footfall::test;
int main(int argc, char** argv) {
  const QTemporaryDir settings;
  qputenv("XDG_CONFIG_HOME", settings.path().toUtf8());
  requestOpenGl();
  GuardedApplication app(argc, argv);
  prepareApplication();
  const QString lang = argc > 2 ? argv[2] : "en";
  const QString theme = argc > 1 ? argv[1] : "light";
  const QSize size = argc > 3 && QByteArray(argv[3]) == "4k" ? QSize(3840, 2160) : QSize(1280, 800);
  loadTranslations(lang);
  Theme::instance()->show(theme == "dark" ? ThemeChoice::Dark : ThemeChoice::Light);
  const QString base = "/tmp/shot-" + theme + "-" + lang + (size.width() > 2000 ? "-4k" : "") + "-";
  QSettings().setValue("recentFiles", QStringList{"/work/wt/feel/samples/house/house.obj", "/work/shared/envs/gone/level.obj", "/work/wt/feel/samples/villa/villa.obj"});
  EditorWindow w;
  w.resize(size);
  showWindow(w);
  QTest::qWait(300);
  w.grab().save(base + "welcome.png");
  const auto samples = findSamples(folderOfSamples());
  w.openWith(samples[0].path, readPipelineFile(samples[0].pipeline.toStdString()), {});
  QTest::qWaitFor([&] { return w.environment() != nullptr; }, 20000);
  waitUntilIdle(w);
  w.commands().find("view.help")->trigger();
  w.commands().find("view.log")->trigger();
  QTest::mouseClick(w.filterList().rows()[3]->field(0), Qt::LeftButton);
  QTest::keyClick(w.filterList().rows()[3]->field(0), Qt::Key_Tab);
  QTest::qWait(300);
  w.messageBar().showError("/tmp/x.obj: cannot be written: the disk is full; free some space or choose another disk");
  QTest::qWait(300);
  w.grab().save(base + "docks.png");
  w.messageBar().clear();
  w.commandPalette().openUp();
  QTest::keyClicks(w.commandPalette().field(), "add");
  QTest::qWait(200);
  w.commandPalette().grab().save(base + "palette.png");
  w.commandPalette().close();
  w.commands().find("help.keys")->trigger();
  QTest::qWait(200);
  if (auto* keys = w.findChild<ShortcutWindow*>()) {
    keys->grab().save(base + "keys.png");
    keys->close();
  }
  w.commands().find("view.help")->trigger();
  w.commands().find("view.log")->trigger();
  w.setCellsShown({true, true, CellColouring::Thread});
  w.document().addParallelBlock();
  waitUntilIdle(w);
  QTest::qWait(600);
  w.grab().save(base + "cells.png");
  return 0;
}
