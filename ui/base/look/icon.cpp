// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/look/icon.hpp"

#include <QDir>
#include <QFile>
#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QPixmap>
#include <QPixmapCache>
#include <QSvgRenderer>
#include <QtDebug>
#include <algorithm>

namespace footfall::ui {
namespace {

// The colour of all files of resources/icons, which the palette's colour replaces.
constexpr char kDrawnWith[] = "#404850";

QString folder() { return QStringLiteral(":/resources/icons/"); }

QColor colourFor(QIcon::Mode mode) {
  const QPalette palette = QGuiApplication::palette();
  if (mode == QIcon::Disabled) return palette.color(QPalette::Disabled, QPalette::ButtonText);
  if (mode == QIcon::Selected) return palette.color(QPalette::Active, QPalette::HighlightedText);
  return palette.color(QPalette::Active, QPalette::ButtonText);
}

class OutlineIcon : public QIconEngine {
 public:
  OutlineIcon(const QString& name, const QByteArray& drawing) : m_name(name), m_drawing(drawing) {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override {
    const qreal ratio = painter->device() ? painter->device()->devicePixelRatioF() : 1.0;
    painter->drawPixmap(rect, scaledPixmap(rect.size() * ratio, mode, state, ratio));
  }

  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    return scaledPixmap(size, mode, state, 1.0);
  }

  // `size` is in device pixels.
  QPixmap scaledPixmap(const QSize& size, QIcon::Mode mode, QIcon::State /*state*/, qreal ratio) override {
    if (size.isEmpty()) return {};
    const QColor colour = colourFor(mode);
    const QString key = QStringLiteral("footfall-icon/%1/%2x%3@%4/%5")
                            .arg(m_name)
                            .arg(size.width())
                            .arg(size.height())
                            .arg(ratio)
                            .arg(colour.rgba(), 8, 16);
    QPixmap pixmap;
    if (QPixmapCache::find(key, &pixmap)) return pixmap;
    pixmap = QPixmap(size);
    pixmap.fill(Qt::transparent);
    QSvgRenderer renderer(QByteArray(m_drawing).replace(kDrawnWith, colour.name().toLatin1()));
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setOpacity(colour.alphaF());
    const int side = std::min(size.width(), size.height());
    renderer.render(&painter, QRectF((size.width() - side) / 2.0, (size.height() - side) / 2.0, side, side));
    painter.end();
    pixmap.setDevicePixelRatio(ratio);
    QPixmapCache::insert(key, pixmap);
    return pixmap;
  }

  QSize actualSize(const QSize& size, QIcon::Mode /*mode*/, QIcon::State /*state*/) override { return size; }

  QString iconName() override { return m_name; }

  bool isNull() override { return false; }

  QString key() const override { return QStringLiteral("footfall-outline"); }

  QIconEngine* clone() const override { return new OutlineIcon(*this); }

 private:
  QString m_name;
  QByteArray m_drawing;
};

}  // namespace

QIcon icon(const QString& name) {
  QFile file(folder() + name + QStringLiteral(".svg"));
  if (!file.open(QIODevice::ReadOnly)) {
    qWarning("icon %s: there is no such file in resources/icons", qPrintable(name));
    return {};
  }
  return QIcon(new OutlineIcon(name, file.readAll()));
}

QIcon applicationIcon() {
  QSvgRenderer renderer(QStringLiteral(":/resources/footfall.svg"));
  QIcon made;
  for (const int side : {16, 24, 32, 48, 64, 128, 256}) {
    QPixmap pixmap(side, side);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    renderer.render(&painter, QRectF(0, 0, side, side));
    painter.end();
    made.addPixmap(pixmap);
  }
  return made;
}

QStringList iconNames() {
  QStringList names = QDir(folder()).entryList({QStringLiteral("*.svg")}, QDir::Files, QDir::Name);
  for (QString& name : names) name.chop(4);
  return names;
}

}  // namespace footfall::ui
