// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/session_keeper.hpp"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>
#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/io/export.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/base/work/guarded_application.hpp"
#include "ui/window/file_dialogs.hpp"
#include "ui/window/session_history.hpp"

namespace footfall::ui {
namespace {

constexpr const char* kSection = "autosave";
constexpr const char* kHistory = "history";

QString ending() { return QLatin1Char('.') + QLatin1String(kSessionExtension); }
QString lockOf(const QString& path) { return path + QStringLiteral(".lock"); }

std::shared_ptr<QLockFile> makeLock(const QString& path) {
  auto lock = std::make_shared<QLockFile>(lockOf(path));
  lock->setStaleLockTime(0);  // only the owner's death makes the lock stale, however old it is
  return lock;
}

}  // namespace

std::optional<KeptSession> readKeptSession(const QString& path) {
  try {
    const Session session = readSession(toPath(path));
    if (session.environment.empty()) return std::nullopt;
    KeptSession kept;
    kept.path = path;
    kept.environment = QFile::decodeName(QByteArray::fromStdString(session.environment));
    kept.time = QFileInfo(path).lastModified();
    const auto edits = session.sections.find(kHistory);
    if (edits != session.sections.end()) kept.history = parseHistory(edits->second);
    const auto section = session.sections.find(kSection);
    if (section != session.sections.end()) {
      const auto json = nlohmann::json::parse(section->second);
      kept.session = QString::fromStdString(json.value("session", std::string()));
      kept.unsaved = json.value("unsaved", false);
    }
    return kept;
  } catch (const std::exception&) {
    return std::nullopt;  // a file of another version, or damaged: nothing to offer
  }
}

SessionKeeper::SessionKeeper(BackgroundQueue& writing, QObject* parent)
    : QObject(parent),
      writing_(writing),
      folder_(QStandardPaths::writableLocation(QStandardPaths::AppConfigLocation)) {}

SessionKeeper::~SessionKeeper() = default;

bool SessionKeeper::takeOwnPath() {
  if (!ownPath_.isEmpty()) return true;
  QDir().mkpath(folder_);
  // Several windows of one process have numbers of their own; files of other processes are not overwritten.
  for (int i = 0; i < 100; ++i) {
    const QString path =
        QStringLiteral("%1/autosave-%2-%3%4").arg(folder_).arg(QCoreApplication::applicationPid()).arg(i).arg(ending());
    auto lock = makeLock(path);
    if (QFile::exists(path) || !lock->tryLock(0)) continue;
    ownPath_ = path;
    ownLock_ = std::move(lock);
    return true;
  }
  return false;
}

void SessionKeeper::keep(Session session, const QString& sessionPath, bool unsaved, EditHistory history) {
  if (!takeOwnPath()) {
    if (!std::exchange(failing_, true))
      emit failed(
          tr("%1: the session cannot be saved for recovery after a crash; make this folder writable").arg(folder_));
    return;
  }
  session.sections[kSection] = nlohmann::json{{"session", sessionPath.toStdString()}, {"unsaved", unsaved}}.dump(
      -1, ' ', false, nlohmann::json::error_handler_t::replace);
  writing_.post(
      [this, session = std::move(session), history = std::move(history), path = ownPath_, lock = ownLock_]() mutable {
        const QString error = errorOf([&] {
          session.sections[kHistory] = formatHistory(history);
          writeFileSafely(toPath(path), formatSession(session, toPath(path)));
        });
        QMetaObject::invokeMethod(
            this,
            [this, error] {
              const bool wasFailing = std::exchange(failing_, !error.isEmpty());
              if (wasFailing && error.isEmpty()) emit recovered();
              if (wasFailing || error.isEmpty()) return;
              emit failed(tr("The session cannot be saved for recovery after a crash: %1").arg(error));
            },
            Qt::QueuedConnection);
      });
}

void SessionKeeper::close() {
  if (ownPath_.isEmpty()) return;
  const QString last = folder_ + QStringLiteral("/last-session") + ending();
  writing_.post([path = std::exchange(ownPath_, QString()), lock = std::exchange(ownLock_, nullptr), last] {
    // rename() replaces in one step, which QFile::rename does not.
    if (std::rename(toPath(path).c_str(), toPath(last).c_str()) != 0) QFile::remove(path);
    lock->unlock();
  });
}

std::optional<KeptSession> SessionKeeper::lastSession() const {
  return readKeptSession(folder_ + QStringLiteral("/last-session") + ending());
}

std::vector<KeptSession> SessionKeeper::abandoned() {
  const QDir folder(folder_);
  for (const QString& name : folder.entryList({QStringLiteral("autosave-*") + ending()}, QDir::Files)) {
    const QString path = folder.filePath(name);
    const bool known = std::ranges::any_of(abandoned_, [&](const KeptSession& kept) { return kept.path == path; });
    if (known || path == ownPath_) continue;
    auto lock = makeLock(path);
    if (!lock->tryLock(0)) continue;  // its owner lives
    const std::optional<KeptSession> kept = readKeptSession(path);
    if (!kept) {
      QFile::remove(path);
      continue;
    }
    taken_.push_back(std::move(lock));
    abandoned_.push_back(*kept);
  }
  std::ranges::sort(abandoned_, std::ranges::greater(), &KeptSession::time);
  return abandoned_;
}

void SessionKeeper::forget(const KeptSession& kept) {
  const auto same = [&](const KeptSession& other) { return other.path == kept.path; };
  if (std::erase_if(abandoned_, same) == 0) return;
  std::shared_ptr<QLockFile> lock;
  std::erase_if(taken_, [&](const std::shared_ptr<QLockFile>& held) {
    if (held->fileName() != lockOf(kept.path)) return false;
    lock = held;
    return true;
  });
  writing_.post([path = kept.path, lock] {
    QFile::remove(path);
    if (lock) lock->unlock();
  });
}

}  // namespace footfall::ui
