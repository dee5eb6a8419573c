// The editor's icons: the files of resources/icons in the colours of the palette.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>
#include <QString>
#include <QStringList>

namespace footfall::ui {

/// The icon resources/icons/NAME.svg. It is painted with the application's palette at the time of painting (ButtonText;
/// greyed where disabled, HighlightedText where selected), so that it follows a change of theme, and from its outlines,
/// so that it is sharp at every device pixel ratio. An unknown name gives a null icon and a warning.
QIcon icon(const QString& name);

/// The program's own icon in the usual sizes, from resources/footfall.svg.
QIcon applicationIcon();

/// The names of all icons, sorted.
QStringList iconNames();

}  // namespace footfall::ui
