// Returns the keyboard focus to the view after typing, or after a click on a button.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>
#include <QLineEdit>

namespace footfall::ui {

/// Moves the focus to the central widget of the window that holds `field`. Returns false and changes nothing in
/// dialogs, which use Enter and Escape themselves.
bool giveKeysBack(QWidget& field);

/// Enter and Escape in `field` return the focus, after their other effects.
void giveKeysBackAfterTyping(QLineEdit& field);

/// A click returns the focus before its other effects, for buttons that are removed when they have been used; Qt would
/// otherwise move the focus to the next widget.
void giveKeysBackAfterClick(QAbstractButton& button);

/// A double click in `field` selects the whole number, not only the digits on one side of its point.
void selectNumberByDoubleClick(QLineEdit& field);

}  // namespace footfall::ui
