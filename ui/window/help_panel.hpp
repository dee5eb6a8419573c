// The dock Help: what the filter is that one is working on.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTextBrowser>

#include "footfall/filter.hpp"

namespace footfall::ui {

class Document;
class FilterList;

/// Follows the keyboard focus through the filter list; what has been shown stays when the focus goes elsewhere.
class HelpPanel : public QTextBrowser {
  Q_OBJECT

 public:
  HelpPanel(const Document& document, const FilterList& filters, QWidget* parent = nullptr);

  /// Shows a filter, and one of its parameters first (-1: from the top).
  void showFilter(const FilterDescriptor& filter, int parameter = -1);

 private:
  void follow(QWidget* focused);

  const Document& document_;
  const FilterList& filters_;
};

}  // namespace footfall::ui
