// What features keep in sessions.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace footfall::ui {

/// What a feature keeps in sessions, as a JSON text.
struct SessionSection {
  QString name;
  std::function<std::string()> save;
  /// Gets an empty text where the session has none of it. Throws std::exception with what is wrong; the message is
  /// shown and the rest of the session counts.
  std::function<void(const std::string&)> load;
};

class SessionSections : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  void add(SessionSection section) { sections_.push_back(std::move(section)); }
  [[nodiscard]] std::map<std::string, std::string> save() const;
  /// failed() follows for each section that is wrong.
  void load(const std::map<std::string, std::string>& sections);

 signals:
  /// Features emit it after a change of what they save.
  void changed();
  void failed(const QString& message);

 private:
  std::vector<SessionSection> sections_;
};

}  // namespace footfall::ui
