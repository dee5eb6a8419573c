// The undo history of an autosaved session, as JSON.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "ui/document/document.hpp"

namespace footfall::ui {

/// Writes the newest edits, at most `most` of them.
std::string formatHistory(const EditHistory& history, std::size_t most = 100);
/// Empty where the text is no history, or has unknown filters.
std::optional<EditHistory> parseHistory(const std::string& text);

}  // namespace footfall::ui
