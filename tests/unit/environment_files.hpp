// Helpers for tests that read and write environment files.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <memory>
#include <string>

#include "core/io/import.hpp"
#include "footfall/errors.hpp"

#ifndef FOOTFALL_SOURCE_DIR
#define FOOTFALL_SOURCE_DIR "."
#endif

namespace footfall::test {
using namespace detail;

/// A folder that is removed with this object.
class TemporaryFolder {
 public:
  [[nodiscard]] std::string path(const char* name) const { return folder_.filePath(name).toStdString(); }
  [[nodiscard]] QStringList files() const {
    return QDir(folder_.path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::System | QDir::NoDotAndDotDot);
  }

  /// Writes a file and returns its path.
  std::string write(const char* name, const QByteArray& content) const {
    QFile file(folder_.filePath(name));
    if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size()) qFatal("cannot write a test file");
    return path(name);
  }

 private:
  QTemporaryDir folder_;
};

inline std::string dataFile(const char* name) { return std::string(FOOTFALL_SOURCE_DIR "/tests/data/") + name; }

inline QByteArray readAll(const std::string& path) {
  QFile file(QString::fromStdString(path));
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// Folder of the real environments, or empty.
inline QString sharedEnvironments() {
  const QString shared = qEnvironmentVariable("FOOTFALL_SHARED", QStringLiteral(FOOTFALL_SOURCE_DIR "/../shared"));
  const QDir folder(shared + "/envs");
  return folder.exists() ? folder.path() : QString();
}

/// Imports OBJ text as Z up, so that coordinates can be compared as written.
inline std::shared_ptr<const Environment> importObjText(const QByteArray& text) {
  const TemporaryFolder folder;
  ImportOptions options;
  options.up = UpAxis::Z;
  return importEnvironment(folder.write("test.obj", text), options);
}

/// The message of the `Error` that `action` throws; empty when it throws nothing.
template <class Error, class Action>
QString messageOf(Action action) {
  try {
    action();
  } catch (const Error& error) {
    return QString::fromStdString(error.what());
  }
  return {};
}

}  // namespace footfall::test
