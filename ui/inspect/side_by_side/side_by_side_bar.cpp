// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspect/side_by_side/side_by_side_bar.hpp"

#include <QGridLayout>
#include <QHBoxLayout>
#include <cmath>

#include "ui/base/text/localized_numbers.hpp"
#include "ui/base/widgets/flow_layout.hpp"

namespace footfall::ui {
namespace {

QString differenceText(double value, const QString& text) {
  return value > 0 ? QLatin1Char('+') + text : value < 0 ? QStringLiteral("\u2212") + text : text;
}

QString countDifference(std::size_t from, std::size_t to) {
  const double difference = static_cast<double>(to) - static_cast<double>(from);
  return differenceText(difference, countText(static_cast<std::uint64_t>(std::fabs(difference))));
}

}  // namespace

SideBySideBar::SideBySideBar(QWidget* parent) : QFrame(parent) {
  setObjectName(QStringLiteral("sideBySideBar"));
  auto* table = new QGridLayout;
  table->setHorizontalSpacing(18);
  table->setVerticalSpacing(1);
  const std::array heads{tr("Walkable area"), tr("Layers"), tr("Components")};
  for (std::size_t column = 0; column < 3; ++column)
    table->addWidget(new QLabel(heads[column], this), 0, static_cast<int>(column) + 1, Qt::AlignRight);
  nameB_ = new QLabel(this);
  const std::array names{new QLabel(tr("<b>A</b> the list of filters"), this), nameB_, new QLabel(tr("B − A"), this)};
  for (std::size_t row = 0; row < 3; ++row) {
    table->addWidget(names[row], static_cast<int>(row) + 1, 0);
    for (std::size_t column = 0; column < 3; ++column) {
      cells_[row][column] = new QLabel(this);
      table->addWidget(cells_[row][column], static_cast<int>(row) + 1, static_cast<int>(column) + 1, Qt::AlignRight);
    }
  }
  note_ = new QLabel(this);
  note_->setObjectName(QStringLiteral("figures"));
  note_->setWordWrap(true);
  const auto button = [this](const char* id, const QString& text, const QString& help) {
    auto* made = new QPushButton(text, this);
    made->setObjectName(QLatin1String(id));
    made->setToolTip(help);
    return made;
  };
  swap_ = button("sideBySideSwap", tr("&Swap"), tr("Edit B: its filters become the list, and the list becomes B"));
  keepA_ = button("keepA", tr("Keep &A"), tr("End side by side; the list of filters stays as it is"));
  keepB_ = button("keepB", tr("Keep &B"), tr("End side by side; the list of filters becomes B's (can be undone)"));
  auto* choose = new QToolButton(this);
  choose->setObjectName(QStringLiteral("sideBySideSource"));
  choose->setText(tr("B is…"));
  choose->setToolTip(tr("Choose the filters that B shows"));
  choose->setPopupMode(QToolButton::InstantPopup);
  choose->setFocusPolicy(Qt::StrongFocus);
  sources_ = new QMenu(choose);
  choose->setMenu(sources_);
  auto* buttons = new FlowLayout(6);
  buttons->addWidget(choose);
  for (QPushButton* one : {swap_, keepA_, keepB_}) buttons->addWidget(one);
  auto* right = new QVBoxLayout;
  right->addLayout(buttons);
  right->addWidget(note_);
  right->addStretch(1);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(10, 5, 10, 5);
  layout->setSpacing(24);
  layout->addLayout(table);
  layout->addLayout(right, 1);
  connect(swap_, &QPushButton::clicked, this, &SideBySideBar::swapRequested);
  connect(keepA_, &QPushButton::clicked, this, [this] { emit keepRequested(false); });
  connect(keepB_, &QPushButton::clicked, this, [this] { emit keepRequested(true); });
}

void SideBySideBar::setUnits(const LevelUnits& units) {
  units_ = units;
  showFigures();
}

void SideBySideBar::setOther(const QString& name) {
  nameB_->setText(QStringLiteral("<b>B</b> ") + name.toHtmlEscaped());
}

void SideBySideBar::setNote(const QString& note) {
  note_->setText(note);
  note_->setVisible(!note.isEmpty());
}

void SideBySideBar::setFigures(const std::optional<AgentFigures>& a, const std::optional<AgentFigures>& b) {
  a_ = a;
  b_ = b;
  showFigures();
}

void SideBySideBar::showFigures() {
  const QString unknown = QStringLiteral("…");
  const auto fill = [&](std::size_t row, const std::optional<AgentFigures>& figures) {
    cells_[row][0]->setText(figures ? units_.area(figures->area) : unknown);
    cells_[row][1]->setText(figures ? countText(figures->layers) : unknown);
    cells_[row][2]->setText(figures ? countText(figures->components) : unknown);
  };
  fill(0, a_);
  fill(1, b_);
  const bool both = a_ && b_;
  const double area = both ? b_->area - a_->area : 0;
  cells_[2][0]->setText(both ? differenceText(area, units_.area(std::fabs(area))) : unknown);
  cells_[2][1]->setText(both ? countDifference(a_->layers, b_->layers) : unknown);
  cells_[2][2]->setText(both ? countDifference(a_->components, b_->components) : unknown);
}

}  // namespace footfall::ui
