// Returns the keyboard focus to the view after typing, or after a click on a button.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>
#include <QLineEdit>

namespace footfall::ui {

/// Names the child of a window's central widget to which giveKeysBack() goes. A focus proxy of the central widget would
/// take Tab past everything that stands before that child.
void setKeysGoTo(QWidget& central, QWidget& child);

/// Gives the focus to what stands in the middle of the window that `field` is part of. False, and nothing happens, in
/// dialogs: there Enter and Escape are the dialog's.
bool giveKeysBack(QWidget& field);

/// Enter and Escape in `field` return the focus, after their other effects.
void giveKeysBackAfterTyping(QLineEdit& field);

/// A click returns the focus before its other effects, for buttons that are removed when they have been used; Qt would
/// otherwise move the focus to the next widget.
void giveKeysBackAfterClick(QAbstractButton& button);

/// A double click in `field` selects the whole number, not only the digits on one side of its point.
void selectNumberByDoubleClick(QLineEdit& field);

}  // namespace footfall::ui
