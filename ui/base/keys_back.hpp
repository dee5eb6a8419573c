// After typing, the keys belong to the view again.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLineEdit>

namespace footfall::ui {

/// Gives the focus to what stands in the middle of the window that `field` is part of. False, and nothing happens, in
/// dialogs: there Enter and Escape are the dialog's.
bool giveKeysBack(QWidget& field);

/// Enter and Escape in `field` give the keys back, after all else that they do there.
void giveKeysBackAfterTyping(QLineEdit& field);

}  // namespace footfall::ui
