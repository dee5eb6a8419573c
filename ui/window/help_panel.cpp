// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/help_panel.hpp"

#include <QApplication>
#include <QEvent>
#include <algorithm>

#include "footfall/filter.hpp"
#include "ui/base/text/filter_text.hpp"
#include "ui/document/document.hpp"
#include "ui/filters/filter_list.hpp"

namespace footfall::ui {

HelpPanel::HelpPanel(const Document& document, const FilterList& filters, QWidget* parent)
    : QTextBrowser(parent), document_(document), filters_(filters) {
  setObjectName(QStringLiteral("helpPanel"));
  setAccessibleName(tr("Help about the filter that has the focus"));
  setOpenLinks(false);
  setFrameShape(QFrame::NoFrame);
  setHtml(
      tr("<p>Click on a filter, or go to it with Tab: this tells what it does, what its values mean and what it "
         "needs.</p><p>F1 lists all keys. Ctrl+K finds every command by a few letters.</p>"));
  connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) { follow(now); });
}

void HelpPanel::follow(QWidget* focused) {
  if (!focused || !filters_.isAncestorOf(focused)) return;
  const auto& rows = filters_.rows();
  const auto row = std::ranges::find_if(
      rows, [&](const FilterRow* r) { return static_cast<const QWidget*>(r) == focused || r->isAncestorOf(focused); });
  if (row == rows.end()) return;
  const auto& entries = document_.filters();
  const auto entry = std::ranges::find(entries, (*row)->entryId(), &FilterEntry::id);
  if (entry == entries.end()) return;
  const FilterDescriptor& filter = *entry->step.filter;
  int parameter = -1;
  for (std::size_t i = 0; i < (*row)->fieldCount(); ++i) {
    const QWidget* field = (*row)->field(i);
    if (field && (field == focused || field->isAncestorOf(focused)))
      parameter = static_cast<int>(&filter.parameterOf(i) - filter.parameters.data());
  }
  showFilter(filter, parameter);
}

void HelpPanel::showFilter(const FilterDescriptor& filter, int parameter) {
  setHtml(filterHelp(filter, parameter));
  if (parameter > 0) scrollToAnchor(QStringLiteral("parameter%1").arg(parameter));
}

}  // namespace footfall::ui
