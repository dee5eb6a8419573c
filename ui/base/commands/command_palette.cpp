// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/commands/command_palette.hpp"

#include <QApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QStyledItemDelegate>
#include <QTextLayout>
#include <QVBoxLayout>
#include <algorithm>
#include <optional>

#include "ui/base/commands/commands.hpp"
#include "ui/base/commands/fuzzy_match.hpp"
#include "ui/base/look/theme.hpp"

namespace footfall::ui {
namespace {

enum Role { EntryRole = Qt::UserRole, DetailRole, ShortcutRole, PositionsRole };
constexpr int kWidth = 620;
constexpr int kRows = 12;
constexpr qsizetype kMostShown = 200;

/// Draws an entry: its title with the matched letters in bold, its detail in grey, and the keys at the right.
class EntryDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const override {
    return {kWidth / 2, option.fontMetrics.height() + 10};
  }

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    QStyleOptionViewItem blank = option;
    initStyleOption(&blank, index);
    blank.text.clear();
    blank.icon = {};
    blank.features &= ~QStyleOptionViewItem::HasDecoration;
    QStyle* style = option.widget ? option.widget->style() : QApplication::style();
    style->drawControl(QStyle::CE_ItemViewItem, &blank, painter, option.widget);

    const bool enabled = index.flags().testFlag(Qt::ItemIsEnabled);
    const bool marked = option.state.testFlag(QStyle::State_Selected);
    const QPalette::ColorGroup group = enabled ? QPalette::Active : QPalette::Disabled;
    const QColor text =
        option.palette.color(marked ? QPalette::Active : group, marked ? QPalette::HighlightedText : QPalette::Text);
    const QColor faint = marked ? text : enabled ? fainterTextColour() : text;
    QRect box = option.rect.adjusted(8, 0, -10, 0);
    const int side = option.fontMetrics.height();
    const QIcon icon = index.data(Qt::DecorationRole).value<QIcon>();
    const QRect iconBox(box.left(), box.center().y() - side / 2, side, side);
    icon.paint(painter, iconBox, Qt::AlignCenter, enabled ? QIcon::Normal : QIcon::Disabled);
    box.setLeft(iconBox.right() + 8);

    const QString keys = index.data(ShortcutRole).toString();
    painter->setPen(faint);
    painter->setFont(option.font);
    painter->drawText(box, Qt::AlignRight | Qt::AlignVCenter, keys);
    if (!keys.isEmpty()) box.setRight(box.right() - option.fontMetrics.horizontalAdvance(keys) - 14);

    QTextLayout layout(index.data(Qt::DisplayRole).toString(), option.font);
    QList<QTextLayout::FormatRange> formats;
    for (const QVariant& position : index.data(PositionsRole).toList()) {
      QTextCharFormat bold;
      bold.setFontWeight(QFont::Bold);
      formats.append({position.toInt(), 1, bold});
    }
    layout.setFormats(formats);
    layout.beginLayout();
    QTextLine line = layout.createLine();
    line.setLineWidth(box.width());
    layout.endLayout();
    painter->setPen(text);
    const double top = box.center().y() - line.height() / 2;
    painter->save();
    painter->setClipRect(box);
    layout.draw(painter, QPointF(box.left(), top));
    painter->restore();
    box.setLeft(box.left() + static_cast<int>(line.naturalTextWidth()) + 12);
    painter->setPen(faint);
    const QString detail = index.data(DetailRole).toString();
    if (box.width() > 30)
      painter->drawText(box, Qt::AlignLeft | Qt::AlignVCenter,
                        option.fontMetrics.elidedText(detail, Qt::ElideMiddle, box.width()));
  }
};

// Returns whether a word of the text begins with `word`, which needs some letters: shorter words begin words of too
// many texts.
bool beginsWordOf(const QString& text, const QString& word) {
  constexpr int kFewest = 4;
  const QString letters = word.trimmed();
  if (letters.size() < kFewest) return false;
  for (qsizetype at = text.indexOf(letters, 0, Qt::CaseInsensitive); at >= 0;
       at = text.indexOf(letters, at + 1, Qt::CaseInsensitive)) {
    if (at == 0 || !text[at - 1].isLetterOrNumber()) return true;
  }
  return false;
}

}  // namespace

QString plainText(const QString& menuText) {
  QString text = menuText;
  text.replace(QLatin1String("&&"), QLatin1String("\n"));
  text.remove(QLatin1Char('&'));
  return text.replace(QLatin1Char('\n'), QLatin1Char('&'));
}

// Panels come last, so that a tool is found before the panel of the same name.
std::vector<PaletteEntry> commandEntries(const CommandRegistry& commands) {
  std::vector<CommandRegistry::Entry> ordered = commands.entries();
  std::ranges::stable_partition(ordered, [](const CommandRegistry::Entry& entry) {
    return entry.command.menu != CommandMenu::View || entry.command.group != QLatin1String("panels");
  });
  std::vector<PaletteEntry> entries;
  for (const CommandRegistry::Entry& entry : ordered) {
    QAction* action = entry.action;
    if (action->menu()) continue;  // its own commands stand for it
    PaletteEntry palette;
    palette.title = plainText(action->text());
    QStringList menus = commands.path(entry);
    for (QString& title : menus) title = plainText(title);
    palette.detail = menus.join(QStringLiteral(" > "));
    palette.shortcut = action->shortcut().toString(QKeySequence::NativeText);
    palette.icon = action->icon();
    palette.enabled = action->isEnabled();
    palette.help = entry.command.help;
    if (action->isCheckable() && action->isChecked()) palette.detail += CommandPalette::tr(" (on)");
    palette.run = [action] { action->trigger(); };
    entries.push_back(std::move(palette));
  }
  return entries;
}

CommandPalette::CommandPalette(QWidget* parent) : QDialog(parent, Qt::Dialog | Qt::FramelessWindowHint) {
  setObjectName(QStringLiteral("commandPalette"));
  setWindowTitle(tr("Commands"));
  setAccessibleName(tr("Commands"));
  field_ = new QLineEdit(this);
  field_->setObjectName(QStringLiteral("commandField"));
  field_->setPlaceholderText(tr("What do you want to do?"));
  field_->setAccessibleName(tr("Search commands, filters, files and samples"));
  field_->setToolTip(tr("A few letters are enough; Enter does what is marked"));
  field_->installEventFilter(this);
  model_ = new QStandardItemModel(this);
  list_ = new QListView(this);
  list_->setObjectName(QStringLiteral("commandList"));
  list_->setAccessibleName(tr("Commands found"));
  list_->setModel(model_);
  list_->setItemDelegate(new EntryDelegate(list_));
  list_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  list_->setUniformItemSizes(true);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setFocusPolicy(Qt::NoFocus);  // the field keeps the focus and moves the selection
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 8, 8, 8);
  layout->addWidget(field_);
  layout->addWidget(list_, 1);
  connect(field_, &QLineEdit::textChanged, this, &CommandPalette::showMatches);
  connect(field_, &QLineEdit::returnPressed, this, &CommandPalette::runMarked);
  connect(list_, &QListView::clicked, this, &CommandPalette::runMarked);
}

void CommandPalette::openUp() {
  entries_.clear();
  for (const Source& source : sources_) std::ranges::move(source(), std::back_inserter(entries_));
  field_->clear();
  showMatches();
  const int row = list_->sizeHintForRow(0) > 0 ? list_->sizeHintForRow(0) : 24;
  const int width = std::min(kWidth, parentWidget()->width() - 40);
  resize(width, std::min(field_->sizeHint().height() + 30 + kRows * row, parentWidget()->height() - 80));
  const QPoint middle = parentWidget()->mapToGlobal(QPoint(parentWidget()->width() / 2, 60));
  move(middle.x() - width / 2, middle.y());
  open();
  field_->setFocus();
}

void CommandPalette::showMatches() {
  struct Found {
    std::size_t entry;
    FuzzyMatch match;
  };
  const std::optional<FuzzyMatch> itself = fuzzyMatch(field_->text(), field_->text());
  const int wholeWord = itself ? itself->score : 0;
  std::vector<Found> found;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    std::optional<FuzzyMatch> match = fuzzyMatch(field_->text(), entries_[i].title);
    if (!match) {
      match = fuzzyMatch(field_->text(), entries_[i].title + QLatin1Char(' ') + entries_[i].detail);
      // The letters of the detail are not drawn in bold, and score less.
      if (match) match = FuzzyMatch{match->score / 2, {}};
    }
    // A word of the help scores more than letters that are scattered over a title.
    const int inHelp = beginsWordOf(entries_[i].help, field_->text()) ? wholeWord / 2 : 0;
    if (inHelp > (match ? match->score : 0)) match = FuzzyMatch{inHelp, {}};
    if (match) found.push_back({i, *match});
  }
  const auto better = [this](const Found& a, const Found& b) {
    return a.match.score != b.match.score ? a.match.score > b.match.score
                                          : entries_[a.entry].enabled && !entries_[b.entry].enabled;
  };
  std::ranges::stable_sort(found, better);
  model_->clear();
  for (const Found& one : found) {
    if (model_->rowCount() >= kMostShown) break;
    const PaletteEntry& entry = entries_[one.entry];
    auto* item = new QStandardItem(entry.icon, entry.title);
    QVariantList positions;
    for (const int position : one.match.positions) positions << position;
    item->setData(static_cast<qulonglong>(one.entry), EntryRole);
    item->setData(entry.enabled ? entry.detail : tr("%1, not available now").arg(entry.detail), DetailRole);
    item->setData(entry.shortcut, ShortcutRole);
    item->setData(positions, PositionsRole);
    item->setToolTip(entry.help);
    item->setAccessibleText(entry.enabled ? entry.title : tr("%1, not available now").arg(entry.title));
    // Disabled entries can be selected too, because the selection moves over all rows.
    item->setFlags(entry.enabled ? Qt::ItemIsSelectable | Qt::ItemIsEnabled : Qt::ItemIsSelectable);
    model_->appendRow(item);
  }
  if (model_->rowCount() == 0) {
    auto* none = new QStandardItem(tr("No command found"));
    none->setFlags(Qt::NoItemFlags);
    model_->appendRow(none);
  }
  list_->setCurrentIndex(model_->index(0, 0));
}

void CommandPalette::runMarked() {
  const QModelIndex marked = list_->currentIndex();
  if (!marked.isValid() || !marked.data(EntryRole).isValid()) return;
  const PaletteEntry entry = entries_[marked.data(EntryRole).toULongLong()];
  if (!entry.enabled) return;
  accept();
  if (entry.run) QMetaObject::invokeMethod(parentWidget(), entry.run, Qt::QueuedConnection);
}

void CommandPalette::moveMark(int rows) {
  const int count = model_->rowCount();
  if (count == 0) return;
  const int at = list_->currentIndex().isValid() ? list_->currentIndex().row() : 0;
  // One step beyond an end wraps around; a page stops at the end.
  const int next = std::abs(rows) == 1 ? (at + rows + count) % count : std::clamp(at + rows, 0, count - 1);
  list_->setCurrentIndex(model_->index(next, 0));
}

bool CommandPalette::eventFilter(QObject* watched, QEvent* event) {
  if (watched == field_ && event->type() == QEvent::KeyPress) {
    switch (static_cast<QKeyEvent*>(event)->key()) {
      case Qt::Key_Down:
        moveMark(1);
        return true;
      case Qt::Key_Up:
        moveMark(-1);
        return true;
      case Qt::Key_PageDown:
        moveMark(kRows - 2);
        return true;
      case Qt::Key_PageUp:
        moveMark(2 - kRows);
        return true;
      default:
        break;
    }
  }
  return QDialog::eventFilter(watched, event);
}

QStringList CommandPalette::titles() const {
  QStringList titles;
  for (int row = 0; row < model_->rowCount(); ++row) {
    if (model_->index(row, 0).data(EntryRole).isValid()) titles << model_->index(row, 0).data().toString();
  }
  return titles;
}

}  // namespace footfall::ui
