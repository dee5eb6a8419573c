// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/preferences.hpp"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLocale>
#include <QSettings>
#include <QVBoxLayout>
#include <array>

#include "ui/base/commands/translations.hpp"
#include "ui/base/look/theme.hpp"

namespace footfall::ui {
namespace {

constexpr const char* kScale = "view/interfaceScale";
constexpr std::array kScales{75, 90, 100, 110, 125, 150, 175, 200};

QString withoutMnemonic(QString text) { return text.remove(QLatin1Char('&')); }

QString keysText(const QList<QKeySequence>& keys) { return QKeySequence::listToString(keys, QKeySequence::NativeText); }

}  // namespace

int interfaceScale() {
  // This must also work before there is an application, which names the settings.
  return QSettings(QStringLiteral("footfall"), QStringLiteral("footfall")).value(QLatin1String(kScale), 100).toInt();
}

void applyInterfaceScale() {
  const int percent = interfaceScale();
  const bool isChosen = percent != 100 && percent >= kScales.front() && percent <= kScales.back();
  if (isChosen && qEnvironmentVariableIsEmpty("QT_SCALE_FACTOR"))
    qputenv("QT_SCALE_FACTOR", QByteArray::number(percent / 100.0));
}

Preferences::Preferences(CommandRegistry& commands, UserKeys& keys, UnitChoice& units, RunThreads& threads,
                         QWidget* parent)
    : QDialog(parent), commands_(commands), keys_(keys) {
  setObjectName(QStringLiteral("preferences"));
  setWindowTitle(tr("Preferences"));
  auto* tabs = new QTabWidget(this);
  tabs->addTab(makeGeneral(units, threads), tr("General"));
  tabs->addTab(makeKeys(), tr("Keys"));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(tabs, 1);
  layout->addWidget(buttons);
  resize(560, 460);
}

QWidget* Preferences::makeGeneral(UnitChoice& units, RunThreads& threads) {
  auto* page = new QWidget(this);
  auto* form = new QFormLayout(page);
  const auto box = [&](const QString& name, const QString& label) {
    auto* made = new QComboBox(page);
    made->setObjectName(name);
    form->addRow(label, made);
    return made;
  };
  QComboBox* length = box(QStringLiteral("preferredUnit"), tr("&Lengths in"));
  for (const auto& [unit, text] :
       {std::pair{LengthUnit::Metres, tr("Metres")}, std::pair{LengthUnit::Millimetres, tr("Millimetres")},
        std::pair{LengthUnit::Feet, tr("Feet")}, std::pair{LengthUnit::FileUnits, tr("The file's units")}})
    length->addItem(text, static_cast<int>(unit));
  length->setCurrentIndex(length->findData(static_cast<int>(units.units().wanted)));
  connect(length, &QComboBox::activated, this,
          [length, &units](int index) { units.choose(static_cast<LengthUnit>(length->itemData(index).toInt())); });

  QComboBox* workers = box(QStringLiteral("preferredThreads"), tr("&Threads of runs"));
  std::vector<int> choices = threadChoices(processorCount());
  choices.back() = 0;
  for (const int n : choices) workers->addItem(threadsText(n), n);
  workers->setCurrentIndex(std::max(0, workers->findData(threads.chosen())));
  connect(workers, &QComboBox::activated, this,
          [workers, &threads](int index) { threads.choose(workers->itemData(index).toInt()); });

  QComboBox* theme = box(QStringLiteral("preferredTheme"), tr("T&heme"));
  for (const auto& [choice, text] :
       {std::pair{ThemeChoice::System, tr("As the system")}, std::pair{ThemeChoice::Light, tr("Light")},
        std::pair{ThemeChoice::Dark, tr("Dark")}})
    theme->addItem(text, static_cast<int>(choice));
  if (Theme::instance()) theme->setCurrentIndex(theme->findData(static_cast<int>(Theme::instance()->choice())));
  connect(theme, &QComboBox::activated, this, [theme](int index) {
    if (Theme::instance()) Theme::instance()->setChoice(static_cast<ThemeChoice>(theme->itemData(index).toInt()));
  });

  QComboBox* language = box(QStringLiteral("preferredLanguage"), tr("L&anguage (from the next start on)"));
  language->addItem(tr("As the system"), QString());
  for (const QString& code : languages()) language->addItem(QLocale(code).nativeLanguageName(), code);
  language->setCurrentIndex(std::max(0, language->findData(chosenLanguage())));
  connect(language, &QComboBox::activated, this,
          [language](int index) { chooseLanguage(language->itemData(index).toString()); });

  QComboBox* scale = box(QStringLiteral("preferredScale"), tr("&Size of the interface (from the next start on)"));
  for (const int percent : kScales) scale->addItem(QStringLiteral("%1 %").arg(percent), percent);
  scale->setCurrentIndex(std::max(0, scale->findData(interfaceScale())));
  connect(scale, &QComboBox::activated, this,
          [scale](int index) { QSettings().setValue(QLatin1String(kScale), scale->itemData(index)); });
  return page;
}

QWidget* Preferences::makeKeys() {
  auto* page = new QWidget(this);
  table_ = new QTreeWidget(page);
  table_->setObjectName(QStringLiteral("keyTable"));
  table_->setAccessibleName(tr("Commands and their keys"));
  table_->setColumnCount(2);
  table_->setHeaderLabels({tr("Command"), tr("Keys")});
  table_->setRootIsDecorated(false);
  table_->setAlternatingRowColors(true);
  table_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  table_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  table_->header()->setStretchLastSection(false);
  key_ = new QKeySequenceEdit(page);
  key_->setAccessibleName(tr("Keys"));
  key_->setToolTip(tr("Press the new keys of the selected command"));
  usual_ = new QPushButton(tr("&Usual keys"), page);
  none_ = new QPushButton(tr("&No keys"), page);
  auto* all = new QPushButton(tr("&Reset all"), page);
  problem_ = new QLabel(page);
  problem_->setObjectName(QStringLiteral("rowError"));
  problem_->setWordWrap(true);
  auto* row = new QHBoxLayout;
  row->addWidget(key_, 1);
  for (QPushButton* button : {usual_, none_, all}) row->addWidget(button);
  auto* layout = new QVBoxLayout(page);
  layout->addWidget(table_, 1);
  layout->addLayout(row);
  layout->addWidget(problem_);
  connect(table_, &QTreeWidget::currentItemChanged, this, &Preferences::showKey);
  connect(key_, &QKeySequenceEdit::editingFinished, this, [this] { takeKey(key_->keySequence()); });
  connect(usual_, &QPushButton::clicked, this, [this] {
    keys_.reset(current());
    fillKeys();
  });
  connect(none_, &QPushButton::clicked, this, [this] { takeKey({}); });
  connect(all, &QPushButton::clicked, this, [this] {
    keys_.resetAll();
    fillKeys();
  });
  fillKeys();
  return page;
}

QString Preferences::current() const {
  return table_->currentItem() ? table_->currentItem()->data(0, Qt::UserRole).toString() : QString();
}

void Preferences::fillKeys() {
  const QString before = current();
  table_->clear();
  for (const CommandRegistry::Entry& entry : commands_.entries()) {
    if (entry.action->text().isEmpty() || entry.action->menu()) continue;
    QStringList path;
    for (const QString& title : commands_.path(entry)) path << withoutMnemonic(title);
    path << withoutMnemonic(entry.action->text());
    auto* item = new QTreeWidgetItem(table_, {path.join(QStringLiteral(" > ")), keysText(entry.action->shortcuts())});
    item->setData(0, Qt::UserRole, entry.command.id);
    item->setToolTip(0, entry.command.help);
    if (entry.command.id == before) table_->setCurrentItem(item);
  }
  showKey();
}

void Preferences::showKey() {
  problem_->clear();
  const bool any = !current().isEmpty();
  for (QWidget* widget : {static_cast<QWidget*>(key_), static_cast<QWidget*>(usual_), static_cast<QWidget*>(none_)})
    widget->setEnabled(any);
  key_->setKeySequence(any ? keys_.keysOf(current()).value(0) : QKeySequence());
}

void Preferences::takeKey(const QKeySequence& key) {
  const QString id = current();
  if (id.isEmpty() || keys_.keysOf(id).value(0) == key) return;
  const QString owner = keys_.ownerOf(key, id);
  if (!owner.isEmpty()) {
    const QString name = withoutMnemonic(commands_.find(owner)->text());
    showKey();
    problem_->setText(
        tr("%1 is already used by %2; remove it there first.").arg(key.toString(QKeySequence::NativeText), name));
    return;
  }
  keys_.setKey(id, key);
  fillKeys();
}

}  // namespace footfall::ui
