// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/unattended.hpp"

#include <QApplication>
#include <QFile>
#include <QSaveFile>
#include <QTimer>
#include <cstdio>
#include <functional>

#include "ui/inspect/corridors/corridors_feature.hpp"
#include "ui/level/level_look.hpp"
#include "ui/level/packed_feature.hpp"
#include "ui/view/widgets/view_hint.hpp"
#include "ui/window/turntable/turntable_feature.hpp"

namespace footfall::ui {
namespace {

constexpr int kSettleMs = 100;  // for the layout, before the picture is taken

using Finish = std::function<void(int code)>;

/// Calls `work` once the view shows the finished result, as the options say; the loop ends when work calls what it
/// gets.
int runUnattended(EditorWindow& window, const EditorOptions& options, const std::function<void(const Finish&)>& work) {
  int code = 0;
  const Finish finish = [&code](int result) {
    code = result;
    QCoreApplication::exit(result);
  };
  QObject::connect(&window, &EditorWindow::loadFailed, &window,
                   [&](const QString& message) { finish(failWith(2, message)); });
  QObject::connect(&window.controller(), &RunController::failed, &window,
                   [&](const QString& message) { finish(failWith(1, message)); });
  QObject::connect(&window.view(), &LevelView::failed, &window,
                   [&](const QString& message) { finish(failWith(1, message)); });
  auto* look = window.findChild<LevelLook*>();
  auto* corridors = window.findChild<CorridorsFeature*>();
  QTimer settle;
  settle.setInterval(kSettleMs);
  QObject::connect(&window.controller(), &RunController::finished, &window, [&] {
    if (options.cells) window.setCellsShown(*options.cells);
    if (options.mode) look->modes().setMode(*options.mode);
    settle.start();
  });
  QObject::connect(&settle, &QTimer::timeout, &window, [&] {
    if (!window.cellWatch().upToDate() || !look->modes().upToDate() || window.controller().seeksMarginKinds()) return;
    // A session's part of a large environment comes after the first one, and blocks after either.
    if (window.file().busy() || window.controller().busy() || window.packed().busy() || window.drawing()) return;
    if (corridors->watch().isBusy()) return;
    settle.stop();
    // A session has a view of its own.
    if (options.top) window.view().cameraController().viewFromTop();
    if (!options.top && !window.openedSession()) window.view().cameraController().viewOblique();
    work(finish);
  });
  QApplication::exec();
  return code;
}

}  // namespace

int failWith(int code, const QString& message) {
  std::fprintf(stderr, "footfall-editor: %s\n", qPrintable(message));
  return code;
}

int takeScreenshot(EditorWindow& window, const EditorOptions& options) {
  // Only pictures: a slip of the hand must not replace a level.
  const QString target = QFile::decodeName(options.screenshot.c_str());
  if (!target.endsWith(QLatin1String(".png"), Qt::CaseInsensitive))
    return failWith(2, QStringLiteral("%1: --screenshot writes .png files; give a name that ends so").arg(target));
  return runUnattended(window, options, [&](const Finish& finish) {
    const QString why = window.writer().refusal(target, WrittenKind::Export);
    if (!why.isEmpty()) {
      finish(failWith(2, why));
      return;
    }
    // Nobody can close them in a picture.
    for (ViewHint* hint : window.findChildren<ViewHint*>()) hint->hide();
    window.view().grabFramebuffer();  // what follows finds all of it drawn
    QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
    QSaveFile file(target);
    const bool written = file.open(QIODevice::WriteOnly) && window.grab().save(&file, "PNG") && file.commit();
    finish(written ? 0
                   : failWith(1, QStringLiteral("%1: cannot be written (%2); choose another folder or name")
                                     .arg(target, file.errorString())));
  });
}

int writeTurntable(EditorWindow& window, const EditorOptions& options) {
  Turntable& turntable = window.findChild<TurntableFeature*>()->turntable();
  TurntableSettings settings;
  settings.folder = QFile::decodeName(options.turntable.c_str());
  settings.frames = options.frames;
  if (!options.size.isEmpty()) settings.pixels = options.size;
  return runUnattended(window, options, [&](const Finish& finish) {
    QObject::connect(&turntable, &Turntable::finished, &window, [finish] { finish(0); });
    QObject::connect(&turntable, &Turntable::stopped, &window,
                     [finish](const QString& message) { finish(failWith(1, message)); });
    turntable.start(settings);
  });
}

}  // namespace footfall::ui
