// The undo history of a session that is kept for after a crash, as JSON.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "ui/document/document.hpp"

namespace footfall::ui {

/// The newest edits: at most `most` of them.
std::string formatHistory(const EditHistory& history, std::size_t most = 100);
/// Nothing where the text is no history, or one of filters that are not known.
std::optional<EditHistory> parseHistory(const std::string& text);

}  // namespace footfall::ui
