// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/files/session_sections.hpp"

#include <exception>

#include "ui/base/text/core_text.hpp"

namespace footfall::ui {

std::map<std::string, std::string> SessionSections::save() const {
  std::map<std::string, std::string> texts;
  for (const SessionSection& section : sections_) texts[section.name.toStdString()] = section.save();
  return texts;
}

void SessionSections::load(const std::map<std::string, std::string>& sections) {
  for (const SessionSection& section : sections_) {
    const auto found = sections.find(section.name.toStdString());
    try {
      section.load(found == sections.end() ? std::string() : found->second);
    } catch (const std::exception& error) {
      emit failed(tr("session, '%1': %2; this part was left out").arg(section.name, coreText(error)));
    }
  }
}

}  // namespace footfall::ui
