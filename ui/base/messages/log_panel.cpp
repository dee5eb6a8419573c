// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/messages/log_panel.hpp"

#include <QClipboard>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QScrollBar>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/base/look/icon.hpp"
#include "ui/base/widgets/flow_layout.hpp"

namespace footfall::ui {
namespace {

/// The messages of at least a level that contain a text.
class ShownMessages : public QSortFilterProxyModel {
 public:
  using QSortFilterProxyModel::QSortFilterProxyModel;
  void setLevel(int level) {
    level_ = level;
    invalidateFilter();
  }
  void setText(const QString& text) {
    text_ = text;
    invalidateFilter();
  }

 protected:
  [[nodiscard]] bool filterAcceptsRow(int row, const QModelIndex& parent) const override {
    const QModelIndex index = sourceModel()->index(row, 0, parent);
    return index.data(MessageLog::LevelRole).toInt() >= level_ &&
           index.data(MessageLog::TextRole).toString().contains(text_, Qt::CaseInsensitive);
  }

 private:
  int level_ = 0;
  QString text_;
};

}  // namespace

LogPanel::LogPanel(MessageLog& log, QWidget* parent) : QWidget(parent), log_(log) {
  setObjectName(QStringLiteral("logPanel"));
  auto* shown = new ShownMessages(this);
  shown_ = shown;
  shown->setSourceModel(&log_);
  levels_ = new QComboBox(this);
  levels_->setObjectName(QStringLiteral("logLevels"));
  levels_->setAccessibleName(tr("Which messages are shown"));
  levels_->setToolTip(tr("Which messages are shown"));
  levels_->addItems({tr("Everything"), tr("Hints and errors"), tr("Errors")});
  connect(levels_, &QComboBox::currentIndexChanged, this, [shown](int index) { shown->setLevel(index); });
  search_ = new QLineEdit(this);
  search_->setObjectName(QStringLiteral("logSearch"));
  search_->setPlaceholderText(tr("Search"));
  search_->setAccessibleName(tr("Search in the messages"));
  search_->setToolTip(tr("Show messages with this text"));
  search_->setClearButtonEnabled(true);
  connect(search_, &QLineEdit::textChanged, this, [shown](const QString& text) { shown->setText(text); });
  copy_ = makeButton(QStringLiteral("logCopy"), QStringLiteral("copy"), tr("Copy"),
                     tr("Copy the selected messages, or all that are shown"));
  save_ = makeButton(QStringLiteral("logSave"), QStringLiteral("save"), tr("Save..."),
                     tr("Save the selected messages, or all that are shown, as a text file"));
  clear_ = makeButton(QStringLiteral("logClear"), QStringLiteral("remove"), tr("Clear"), tr("Forget all messages"));

  list_ = new QListView(this);
  list_->setObjectName(QStringLiteral("logList"));
  list_->setAccessibleName(tr("Messages"));
  list_->setModel(shown_);
  list_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  list_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  list_->setWordWrap(true);
  list_->setTabKeyNavigation(false);
  list_->setUniformItemSizes(false);
  list_->setResizeMode(QListView::Adjust);
  list_->installEventFilter(this);

  auto* head = new FlowLayout(6);
  head->addWidget(levels_);
  head->addWidget(search_);
  for (QToolButton* button : {copy_, save_, clear_}) head->addWidget(button);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->setSpacing(4);
  layout->addLayout(head);
  layout->addWidget(list_, 1);

  connect(copy_, &QToolButton::clicked, this, &LogPanel::copy);
  connect(save_, &QToolButton::clicked, this, &LogPanel::saveRequested);
  connect(clear_, &QToolButton::clicked, &log_, &MessageLog::clear);
  // Scrolls to new messages while the end is visible.
  connect(shown_, &QAbstractItemModel::rowsAboutToBeInserted, this, [this] {
    const QScrollBar* bar = list_->verticalScrollBar();
    if (bar->value() == bar->maximum())
      QMetaObject::invokeMethod(list_, &QListView::scrollToBottom, Qt::QueuedConnection);
  });
}

QToolButton* LogPanel::makeButton(const QString& name, const QString& iconName, const QString& text,
                                  const QString& help) {
  auto* button = new QToolButton(this);
  button->setObjectName(name);
  button->setIcon(icon(iconName));
  button->setText(text);
  button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  button->setToolTip(help);
  button->setFocusPolicy(Qt::StrongFocus);
  return button;
}

QString LogPanel::text() const {
  QModelIndexList rows = list_->selectionModel()->selectedIndexes();
  if (rows.isEmpty()) {
    for (int row = 0; row < shown_->rowCount(); ++row) rows << shown_->index(row, 0);
  }
  std::ranges::sort(rows, {}, &QModelIndex::row);
  QString text;
  for (const QModelIndex& row : rows) {
    const int at = shown_->mapToSource(row).row();
    text += logLine(log_.messages()[static_cast<std::size_t>(at)]) + QLatin1Char('\n');
  }
  return text;
}

void LogPanel::copy() const { QGuiApplication::clipboard()->setText(text()); }

bool LogPanel::eventFilter(QObject* watched, QEvent* event) {
  if (watched == list_ && event->type() == QEvent::KeyPress &&
      static_cast<QKeyEvent*>(event)->matches(QKeySequence::Copy)) {
    copy();
    return true;
  }
  return QWidget::eventFilter(watched, event);
}

}  // namespace footfall::ui
