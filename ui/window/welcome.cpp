// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/welcome.hpp"

#include <QApplication>
#include <QEvent>
#include <QFileInfo>

#include "ui/base/files/installed_files.hpp"

namespace footfall::ui {

Welcome::Welcome(WelcomePage& page, LevelView& view, CommandRegistry& commands, LevelFile& file, RecentFiles& recent,
                 SessionFiles& sessions, LevelOpening& opening)
    : QObject(&page), page_(page), view_(view), file_(file), recent_(recent), sessions_(sessions) {
  commands.add({QStringLiteral("file.welcome"),
                CommandMenu::File,
                QStringLiteral("open"),
                tr("&Welcome"),
                tr("Samples, recent files and the last session"),
                {},
                QStringLiteral("environment")},
               [this](bool) { show(true); });
  connect(&page_, &WelcomePage::openRequested, &opening, &LevelOpening::askForFile);
  connect(&page_, &WelcomePage::fileChosen, &opening, &LevelOpening::openAsking);
  connect(&page_, &WelcomePage::sampleChosen, &opening, &LevelOpening::openSample);
  connect(&page_, &WelcomePage::continueRequested, &opening, &LevelOpening::continueLastSession);
  connect(&page_, &WelcomePage::removeRequested, &recent_, &RecentFiles::remove);
  connect(&page_, &WelcomePage::closeRequested, this, [this] { show(false); });
  connect(&recent_, &RecentFiles::changed, this, &Welcome::refresh);
  connect(&file_, &LevelFile::opened, this, [this] { show(false); });
  view_.installEventFilter(this);
  show(true);
}

bool Welcome::eventFilter(QObject* watched, QEvent* event) {
  if (watched == &view_ && event->type() == QEvent::Resize) {
    page_.setGeometry(view_.rect());
    if (!page_.isHidden()) page_.raise();
  }
  return QObject::eventFilter(watched, event);
}

void Welcome::refresh() {
  if (!page_.isHidden()) update();
}

void Welcome::update() {
  page_.setRecentFiles(recent_.paths(), RecentPictures::ofUser());
  const std::optional<KeptSession> last = sessions_.lastSession();
  page_.setLastSession(
      last ? std::optional(WelcomePage::LastSession{QFileInfo(last->environment).fileName(), last->time})
           : std::nullopt);
  page_.setClosable(file_.environment() != nullptr);
}

void Welcome::show(bool on) {
  if (!on && !file_.environment()) return;
  if (on) {
    page_.setSamples(findSamples(samplesFolder()));
    update();
    page_.setGeometry(view_.rect());
    page_.raise();
  }
  const bool hadFocus = page_.isAncestorOf(QApplication::focusWidget());
  page_.setVisible(on);
  if (on) {
    page_.openButton()->setFocus();
  } else if (hadFocus) {
    view_.setFocus();
  }
}

}  // namespace footfall::ui
