// Light and dark: following the desktop, the user's choice, and colours that can be read.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QProcess>
#include <QSignalSpy>
#include <QtDBus/QDBusConnection>
#include <QtDBus/QDBusVariant>
#include <cmath>

#include "tests/editor/editor_driver.hpp"
#include "tests/editor/window_parts.hpp"
#include "ui/base/look/system_colours.hpp"
#include "ui/base/look/theme.hpp"
#include "ui/level/import_panel.hpp"
#include "ui/view/scene/appearance.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::ui;
using namespace footfall::test;

namespace {

// WCAG 2.1: relative luminance and contrast ratio.
double luminance(const QColor& colour) {
  const auto linear = [](double c) { return c <= 0.03928 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
  return 0.2126 * linear(static_cast<double>(colour.redF())) + 0.7152 * linear(static_cast<double>(colour.greenF())) +
         0.0722 * linear(static_cast<double>(colour.blueF()));
}

double contrast(const QColor& a, const QColor& b) {
  const double first = luminance(a);
  const double second = luminance(b);
  return (std::max(first, second) + 0.05) / (std::min(first, second) + 0.05);
}

QColor pixelOf(QWidget* widget, const QPoint& place) { return widget->grab().toImage().pixelColor(place); }

}  // namespace

/// Answers as a desktop portal does.
class FakePortal : public QObject {
  Q_OBJECT
  Q_CLASSINFO("D-Bus Interface", "org.freedesktop.portal.Settings")

 public:
  unsigned int scheme = 0;

 public slots:
  QDBusVariant Read(const QString& group, const QString& key) {
    const bool known = group == QLatin1String("org.freedesktop.appearance") && key == QLatin1String("color-scheme");
    // Portals wrap the value twice.
    return QDBusVariant(QVariant::fromValue(QDBusVariant(known ? QVariant(scheme) : QVariant(0U))));
  }

 signals:
  void SettingChanged(const QString& group, const QString& key, const QDBusVariant& value);
};

class TestTheme : public QObject {
  Q_OBJECT

 private slots:
  void cleanup() {
    if (Theme::instance()) Theme::instance()->setChoice(ThemeChoice::Light);
  }

  void textCanBeReadInBoth() {
    for (const bool dark : {false, true}) {
      const QPalette palette = themePalette(dark);
      using Pair = std::pair<QPalette::ColorRole, QPalette::ColorRole>;
      for (const auto& [text, ground] :
           {Pair{QPalette::WindowText, QPalette::Window}, Pair{QPalette::Text, QPalette::Base},
            Pair{QPalette::Text, QPalette::AlternateBase}, Pair{QPalette::ButtonText, QPalette::Button},
            Pair{QPalette::HighlightedText, QPalette::Highlight}, Pair{QPalette::ToolTipText, QPalette::ToolTipBase},
            Pair{QPalette::PlaceholderText, QPalette::Base}, Pair{QPalette::Link, QPalette::Window}}) {
        const double ratio = contrast(palette.color(text), palette.color(ground));
        QVERIFY2(ratio >= 4.5, qPrintable(QString("%1 on %2, dark %3: %4").arg(text).arg(ground).arg(dark).arg(ratio)));
      }
      Theme::instance()->setChoice(dark ? ThemeChoice::Dark : ThemeChoice::Light);
      QVERIFY(contrast(errorTextColour(), palette.color(QPalette::Base)) >= 4.5);
      QVERIFY(contrast(fainterTextColour(), palette.color(QPalette::Base)) >= 4.5);
    }
  }

  void everyNameOfTheStyleSheetIsAColour() {
    for (const bool dark : {false, true}) {
      const QString sheet = themeStyleSheet(dark);
      QVERIFY(sheet.contains("QDockWidget"));
      QVERIFY2(!sheet.contains('@'), qPrintable(sheet.mid(sheet.indexOf('@'), 40)));
    }
  }

  void switchesWhileTheWindowIsOpen() {
    EditorWindow window;
    window.resize(1000, 700);
    QVERIFY(showWindow(window));
    Theme::instance()->setChoice(ThemeChoice::Light);
    QVERIFY(!isDarkTheme());
    QWidget* panel = &partOf<ImportPanel>(window);
    const QPoint corner(panel->width() - 3, panel->height() - 3);
    QTRY_VERIFY(pixelOf(panel, corner).lightness() > 180);
    QAction* dark = window.findChild<QAction*>("view.theme.dark");
    QVERIFY(dark && !dark->isChecked());
    dark->trigger();
    QVERIFY(isDarkTheme());
    QTRY_VERIFY(pixelOf(panel, corner).lightness() < 80);
    QVERIFY(backgroundUpper().lightness() < 60);
    QVERIFY(!window.findChild<QAction*>("view.theme.light")->isChecked());
    window.findChild<QAction*>("view.theme.light")->trigger();
    QTRY_VERIFY(pixelOf(panel, corner).lightness() > 180);
    QVERIFY(backgroundUpper().lightness() > 200);
  }

  // Pictures are kept while the camera rests.
  void theViewFollowsTheTheme() {
    const QTemporaryDir folder;
    EditorWindow window;
    window.resize(1000, 700);
    QVERIFY(showWindow(window));
    Theme::instance()->setChoice(ThemeChoice::Light);
    QVERIFY(openZUp(window, writeFile(folder, "table.obj", tableObj()), "SlopeFilter 45\n"));
    const auto background = [&] { return window.view().grabFramebuffer().pixelColor(3, 3).lightness(); };
    QVERIFY(background() > 180);
    for (const auto& [id, dark] : {std::pair{"view.theme.dark", true}, std::pair{"view.theme.light", false}}) {
      window.findChild<QAction*>(id)->trigger();
      QTRY_COMPARE(isDarkTheme(), dark);
      QCOMPARE(background() < 80, dark);
    }
  }

  void theChoiceIsKept() {
    Theme::instance()->setChoice(ThemeChoice::Dark);
    QCOMPARE(QSettings().value("theme").toString(), QString("dark"));
    delete Theme::instance();
    prepareApplication();
    QCOMPARE(Theme::instance()->choice(), ThemeChoice::Dark);
    QVERIFY(isDarkTheme());
  }

  void portalValues() {
    QCOMPARE(darkFromPortal(1U), std::optional(true));
    QCOMPARE(darkFromPortal(2U), std::optional(false));
    QCOMPARE(darkFromPortal(0U), std::optional<bool>());
    QCOMPARE(darkFromPortal({}), std::optional<bool>());
    const QVariant inner = QVariant::fromValue(QDBusVariant(QVariant(1U)));
    QCOMPARE(darkFromPortal(QVariant::fromValue(QDBusVariant(inner))), std::optional(true));
  }

  // The test runs on a bus of its own (initTestCase of main), so that the desktop of the machine does not matter.
  void followsTheDesktop() {
    QDBusConnection bus = QDBusConnection::sessionBus();
    if (!bus.isConnected()) QSKIP("no D-Bus here: dbus-daemon is not installed");
    FakePortal portal;
    portal.scheme = 1;
    QDBusConnection desktop = QDBusConnection::connectToBus(QDBusConnection::SessionBus, "desktop");
    QVERIFY(desktop.registerService("org.freedesktop.portal.Desktop"));
    QVERIFY(desktop.registerObject("/org/freedesktop/portal/desktop", &portal,
                                   QDBusConnection::ExportAllSlots | QDBusConnection::ExportAllSignals));
    SystemColours colours;
    QTRY_VERIFY(colours.dark());
    const QSignalSpy changed(&colours, &SystemColours::changed);
    emit portal.SettingChanged("org.freedesktop.appearance", "color-scheme", QDBusVariant(2U));
    QTRY_VERIFY(!colours.dark());
    QCOMPARE(changed.count(), 1);
    emit portal.SettingChanged("org.freedesktop.appearance", "accent-color", QDBusVariant(1U));
    emit portal.SettingChanged("org.freedesktop.appearance", "color-scheme", QDBusVariant(1U));
    QTRY_VERIFY(colours.dark());
    const SystemColours next;
    QVERIFY(next.dark());  // the last answer holds until the portal has answered
  }
};

// A bus of its own, if there is a daemon for one.
int main(int argc, char** argv) {
  QProcess daemon;
  daemon.start("dbus-daemon", {"--session", "--nofork", "--print-address"});
  if (daemon.waitForStarted() && daemon.waitForReadyRead(5000)) {
    qputenv("DBUS_SESSION_BUS_ADDRESS", daemon.readLine().trimmed());
  } else {
    qunsetenv("DBUS_SESSION_BUS_ADDRESS");
  }
  const int code = runSuite<TestTheme>(argc, argv);
  daemon.kill();
  daemon.waitForFinished();
  return code;
}
#include "test_theme.moc"
