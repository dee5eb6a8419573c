// The sections that features save in sessions.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace footfall::ui {

/// A section that a feature saves in sessions, as a JSON text.
struct SessionSection {
  QString name;
  std::function<std::string()> save;
  /// Receives an empty text where the session does not have the section. Throws std::exception with the problem; the
  /// message is shown and the rest of the session is loaded.
  std::function<void(const std::string&)> load;
};

class SessionSections : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  void add(SessionSection section) { sections_.push_back(std::move(section)); }
  [[nodiscard]] std::map<std::string, std::string> save() const;
  /// failed() is emitted for each section with a problem.
  void load(const std::map<std::string, std::string>& sections);

 signals:
  /// Features emit it when data that they save has changed.
  void changed();
  void failed(const QString& message);

 private:
  std::vector<SessionSection> sections_;
};

}  // namespace footfall::ui
