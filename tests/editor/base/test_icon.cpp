// The icons: all of them load, and take the palette's colours.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QPainter>
#include <QToolButton>
#include <QtTest>

#include "ui/base/look/icon.hpp"

using namespace footfall;
using namespace footfall::ui;

namespace {

QImage imageOf(const QIcon& shown, int side, QIcon::Mode mode = QIcon::Normal) {
  return shown.pixmap(QSize(side, side), 1.0, mode).toImage().convertToFormat(QImage::Format_ARGB32);
}

/// The colour of the pixel that is covered most.
QColor inkOf(const QImage& image) {
  QColor ink(Qt::transparent);
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      if (image.pixelColor(x, y).alpha() > ink.alpha()) ink = image.pixelColor(x, y);
    }
  }
  return ink;
}

/// The share of the picture that is covered, from 0 to 1.
double coverOf(const QImage& image) {
  double sum = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) sum += image.pixelColor(x, y).alphaF();
  }
  return sum / (static_cast<double>(image.width()) * image.height());
}

QPalette paletteWith(const QColor& text, const QColor& disabled, const QColor& selected) {
  QPalette palette = QApplication::palette();
  palette.setColor(QPalette::ButtonText, text);
  palette.setColor(QPalette::Disabled, QPalette::ButtonText, disabled);
  palette.setColor(QPalette::HighlightedText, selected);
  return palette;
}

}  // namespace

class TestIcon : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { m_before = QApplication::palette(); }
  void cleanup() { QApplication::setPalette(m_before); }

  void everyFileIsAnIcon_data() {
    QTest::addColumn<QString>("name");
    for (const QString& name : iconNames()) QTest::newRow(qPrintable(name)) << name;
  }

  void everyFileIsAnIcon() {
    QFETCH(QString, name);
    const QIcon shown = icon(name);
    QVERIFY(!shown.isNull());
    for (const int side : {16, 24, 64}) {
      const QImage image = imageOf(shown, side);
      QCOMPARE(image.size(), QSize(side, side));
      QVERIFY(coverOf(image) > 0.03 && coverOf(image) < 0.7);
    }
    const QImage light = imageOf(shown, 24);
    QApplication::setPalette(paletteWith(QColor(230, 235, 240), QColor(120, 120, 120), Qt::white));
    QVERIFY(imageOf(shown, 24) != light);
  }

  void thereAreIconsForTheToolsOfTheEditor() {
    const QStringList names = iconNames();
    QVERIFY(names.size() >= 71);
    for (const char* name : {"open", "save", "undo", "redo", "run", "cancel", "why", "measure", "path", "state-done"}) {
      QVERIFY(names.contains(QLatin1String(name)));
    }
  }

  void coloursAreThoseOfThePaletteWhenItIsPainted() {
    const QIcon shown = icon(QStringLiteral("camera-top"));
    for (const QColor& text : {QColor(20, 30, 40), QColor(0, 200, 100)}) {
      QApplication::setPalette(paletteWith(text, QColor(150, 151, 152), QColor(250, 251, 252)));
      QCOMPARE(inkOf(imageOf(shown, 48)), text);
      QCOMPARE(inkOf(imageOf(shown, 48, QIcon::Disabled)), QColor(150, 151, 152));
      QCOMPARE(inkOf(imageOf(shown, 48, QIcon::Selected)), QColor(250, 251, 252));
      QCOMPARE(inkOf(imageOf(shown, 48, QIcon::Active)), text);
    }
  }

  void buttonsFollowAChangeOfTheme() {
    QToolButton button;
    button.setIcon(icon(QStringLiteral("cancel")));
    button.setIconSize(QSize(32, 32));
    button.show();
    QVERIFY(QTest::qWaitForWindowExposed(&button));
    const auto hasGreen = [&] {
      const QImage image = button.grab().toImage();
      for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
          const QColor pixel = image.pixelColor(x, y);
          if (pixel.green() > 150 && pixel.red() < 60 && pixel.blue() < 60) return true;
        }
      }
      return false;
    };
    QVERIFY(!hasGreen());
    QApplication::setPalette(paletteWith(QColor(0, 200, 0), Qt::gray, Qt::white));
    QTRY_VERIFY(hasGreen());
  }

  void morePixelsOnDenserScreens() {
    const QPixmap dense = icon(QStringLiteral("layers")).pixmap(QSize(24, 24), 2.0);
    QCOMPARE(dense.size(), QSize(48, 48));
    QCOMPARE(dense.devicePixelRatio(), 2.0);
    // Drawn in full resolution, not blown up.
    const QPixmap thin = icon(QStringLiteral("layers")).pixmap(QSize(24, 24), 1.0);
    QVERIFY(dense.toImage() != thin.scaled(48, 48).toImage());
  }

  void inAWideFieldItKeepsItsShape() {
    QImage canvas(60, 20, QImage::Format_ARGB32);
    canvas.fill(Qt::transparent);
    QPainter painter(&canvas);
    icon(QStringLiteral("state-done")).paint(&painter, QRect(0, 0, 60, 20));
    painter.end();
    QCOMPARE(canvas.pixelColor(5, 10).alpha(), 0);
    QVERIFY(coverOf(canvas.copy(20, 0, 20, 20)) > 0.1);
  }

  void theProgramHasAnIconInTheUsualSizes() {
    const QIcon shown = applicationIcon();
    for (const int side : {16, 32, 48, 256}) {
      QVERIFY(shown.availableSizes().contains(QSize(side, side)));
      const QImage image = imageOf(shown, side);
      QVERIFY(coverOf(image) > 0.7);
      QCOMPARE(image.pixelColor(0, 0).alpha(), 0);
    }
  }

  void anUnknownNameIsToldAndGivesNoIcon() {
    QTest::ignoreMessage(QtWarningMsg, "icon nonsense: there is no such file in resources/icons");
    QVERIFY(icon(QStringLiteral("nonsense")).isNull());
  }

 private:
  QPalette m_before;
};

QTEST_MAIN(TestIcon)
#include "test_icon.moc"
