// The dock Help: describes the filter that the user is editing.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTextBrowser>

namespace footfall {
struct FilterDescriptor;
}

namespace footfall::ui {

class Document;
class FilterList;

/// Follows the keyboard focus through the filter list; the last text stays when the focus moves elsewhere.
class HelpPanel : public QTextBrowser {
  Q_OBJECT

 public:
  HelpPanel(const Document& document, const FilterList& filters, QWidget* parent = nullptr);

  /// Shows a filter, beginning with one of its parameters (-1: from the top).
  void showFilter(const FilterDescriptor& filter, int parameter = -1);

 private:
  void follow(QWidget* focused);

  const Document& document_;
  const FilterList& filters_;
};

}  // namespace footfall::ui
