// After typing, or a click on a button that goes with it, the keys belong to the view again.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>
#include <QLineEdit>

namespace footfall::ui {

/// Gives the focus to what stands in the middle of the window that `field` is part of. False, and nothing happens, in
/// dialogs: there Enter and Escape are the dialog's.
bool giveKeysBack(QWidget& field);

/// Enter and Escape in `field` give the keys back, after all else that they do there.
void giveKeysBackAfterTyping(QLineEdit& field);

/// A click gives the keys back before anything else that it does: for buttons that go when they have been used, as the
/// focus would go on to whatever comes next.
void giveKeysBackAfterClick(QAbstractButton& button);

/// A double click in `field` selects all of the number in it, and not only the digits before or behind its point.
void selectNumberByDoubleClick(QLineEdit& field);

}  // namespace footfall::ui
