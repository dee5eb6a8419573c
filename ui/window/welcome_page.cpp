// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/welcome_page.hpp"

#include <QDir>
#include <QFileInfo>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QList>
#include <QLocale>
#include <QPainter>
#include <QScrollArea>
#include <QVBoxLayout>
#include <array>

#include "ui/base/look/icon.hpp"

namespace footfall::ui {
namespace {

constexpr QSize kThumbnail(168, 94);
constexpr int kWidest = 900;
constexpr int kSmallIcon = 24;
enum Role { PathRole = Qt::UserRole, MissingRole };

struct KnownSample {
  const char* folder;
  const char* title;
  const char* description;
};

// The generator's samples; further folders may lie beside them.
constexpr std::array<KnownSample, 6> kSamples = {{
    {"rooms", QT_TRANSLATE_NOOP("footfall::ui::WelcomePage", "Rooms"),
     QT_TRANSLATE_NOOP("footfall::ui::WelcomePage", "266 triangles: the tour's level, with a doorway that is too low")},
    {"house", QT_TRANSLATE_NOOP("footfall::ui::WelcomePage", "House"),
     QT_TRANSLATE_NOOP("footfall::ui::WelcomePage", "820 triangles: ramps, an overhang, walls without thickness")},
    {"villa", QT_TRANSLATE_NOOP("footfall::ui::WelcomePage", "Villa"),
     QT_TRANSLATE_NOOP("footfall::ui::WelcomePage", "30,000 triangles: three furnished storeys on rough ground")},
    {"arena", QT_TRANSLATE_NOOP("footfall::ui::WelcomePage", "Arena"),
     QT_TRANSLATE_NOOP("footfall::ui::WelcomePage",
                       "20,000 triangles: a stadium with steps and a ring road on pillars")},
    {"docks", QT_TRANSLATE_NOOP("footfall::ui::WelcomePage", "Docks"),
     QT_TRANSLATE_NOOP("footfall::ui::WelcomePage", "59,000 triangles: ships, piers, crates and ropes")},
    {"tower", QT_TRANSLATE_NOOP("footfall::ui::WelcomePage", "Tower"),
     QT_TRANSLATE_NOOP("footfall::ui::WelcomePage", "440 triangles: 26 storeys, one above the other")},
}};

/// The button is as high as its description at its width.
class SampleButton : public QToolButton {
 public:
  using QToolButton::QToolButton;

 protected:
  void resizeEvent(QResizeEvent* event) override {
    QToolButton::resizeEvent(event);
    const auto* grid = static_cast<QGridLayout*>(layout());
    int height = 0;
    for (int row = 0; row < grid->rowCount(); ++row) {
      QWidget* text = grid->itemAtPosition(row, 1)->widget();
      const int width = grid->cellRect(row, 1).width();
      const int needed = text->hasHeightForWidth() ? text->heightForWidth(width) : text->sizeHint().height();
      text->setMinimumHeight(needed);  // the layout gives wrapped texts the height that they prefer
      height += needed;
    }
    const QMargins margins = grid->contentsMargins();
    const int least = std::max(height + grid->verticalSpacing(), kThumbnail.height() / 2);
    setMinimumHeight(std::max(minimumHeight(), least + margins.top() + margins.bottom()));
  }
};

QLabel* heading(const QString& text, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setObjectName(QStringLiteral("welcomeHeading"));
  return label;
}

}  // namespace

std::vector<Sample> findSamples(const QString& folder) {
  std::vector<Sample> samples;
  if (folder.isEmpty()) return samples;
  const QDir root(folder);
  for (const KnownSample& known : kSamples) {
    const QString name = QLatin1String(known.folder);
    const QString base = root.filePath(name + QLatin1Char('/') + name);
    if (!QFileInfo(base + QStringLiteral(".obj")).isFile()) continue;
    const QString pipeline = base + QStringLiteral(".pipeline");
    const QString picture = QStringLiteral(":/resources/samples/%1.png").arg(name);
    samples.push_back({base + QStringLiteral(".obj"), QFileInfo(pipeline).isFile() ? pipeline : QString(),
                       WelcomePage::tr(known.title), WelcomePage::tr(known.description),
                       QFileInfo::exists(picture) ? picture : QString()});
  }
  return samples;
}

WelcomePage::WelcomePage(QWidget* parent) : QFrame(parent) {
  setObjectName(QStringLiteral("welcome"));
  setAttribute(Qt::WA_StyledBackground);
  setFocusPolicy(Qt::NoFocus);
  auto* title = new QLabel(QStringLiteral("Footfall"), this);
  title->setObjectName(QStringLiteral("welcomeTitle"));
  auto* subtitle = new QLabel(tr("The exact walkable area of 3D environments"), this);
  subtitle->setObjectName(QStringLiteral("figures"));
  subtitle->setWordWrap(true);
  close_ = new QToolButton(this);
  close_->setObjectName(QStringLiteral("welcomeClose"));
  close_->setIcon(icon(QStringLiteral("cancel")));
  close_->setAutoRaise(true);
  close_->setFocusPolicy(Qt::StrongFocus);
  close_->setToolTip(tr("Back to the view (Esc)"));
  close_->setAccessibleName(tr("Back to the view"));
  connect(close_, &QToolButton::clicked, this, &WelcomePage::closeRequested);
  auto* head = new QHBoxLayout;
  auto* titles = new QVBoxLayout;
  titles->addWidget(title);
  titles->addWidget(subtitle);
  head->addLayout(titles, 1);
  head->addWidget(close_, 0, Qt::AlignTop);

  auto* columns = new QHBoxLayout;
  columns->setSpacing(28);
  columns->addWidget(makeFiles(), 5);
  columns->addWidget(makeSamples(), 4);

  auto* content = new QWidget;
  content->setObjectName(QStringLiteral("welcomeContent"));
  content->setMaximumWidth(kWidest);
  auto* inner = new QVBoxLayout(content);
  inner->setContentsMargins(24, 20, 24, 20);
  inner->setSpacing(14);
  inner->addLayout(head);
  inner->addLayout(columns, 1);
  // The page scrolls on a small screen, so that nothing is cut off.
  auto* middle = new QWidget;
  middle->setObjectName(QStringLiteral("welcomeMiddle"));
  auto* centring = new QHBoxLayout(middle);
  centring->setContentsMargins(0, 0, 0, 0);
  centring->addStretch(1);
  centring->addWidget(content, 100);
  centring->addStretch(1);
  auto* scroll = new QScrollArea(this);
  scroll->setObjectName(QStringLiteral("welcomeScroll"));
  scroll->setWidget(middle);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setFocusPolicy(Qt::NoFocus);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(scroll);
  setClosable(false);
  setLastSession({});
  setRecentFiles({}, RecentPictures::ofUser());
}

QWidget* WelcomePage::makeFiles() {
  auto* files = new QWidget(this);
  open_ = new QPushButton(icon(QStringLiteral("open")), tr("Open..."), files);
  open_->setObjectName(QStringLiteral("welcomeOpen"));
  open_->setToolTip(tr("Open an environment or a session (Ctrl+O)"));
  open_->setAutoDefault(true);
  continue_ = new QPushButton(icon(QStringLiteral("session")), QString(), files);
  continue_->setObjectName(QStringLiteral("welcomeContinue"));
  continue_->setAutoDefault(true);
  auto* drop = new QLabel(tr("or drop a file anywhere in this window"), files);
  drop->setObjectName(QStringLiteral("dropZone"));
  drop->setAlignment(Qt::AlignCenter);
  drop->setWordWrap(true);
  recent_ = new QListWidget(files);
  recent_->setObjectName(QStringLiteral("recentFiles"));
  recent_->setAccessibleName(tr("Recent files"));
  recent_->setToolTip(tr("Enter opens a file, Delete removes it from the list"));
  recent_->setTabKeyNavigation(false);
  recent_->setMinimumHeight(120);
  recent_->setTextElideMode(Qt::ElideMiddle);
  recent_->setIconSize(kThumbnail / 2);
  recent_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  recent_->installEventFilter(this);
  noRecent_ = new QLabel(tr("Files that you open are listed here."), files);
  noRecent_->setObjectName(QStringLiteral("figures"));
  noRecent_->setWordWrap(true);
  remove_ = new QPushButton(tr("Remove from the list"), files);
  remove_->setObjectName(QStringLiteral("removeRecent"));
  remove_->setToolTip(tr("Forget this file; the file itself stays"));
  remove_->setAutoDefault(true);
  auto* layout = new QVBoxLayout(files);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(8);
  layout->addWidget(open_);
  layout->addWidget(drop);
  layout->addWidget(continue_);
  layout->addSpacing(6);
  layout->addWidget(heading(tr("Recent files"), files));
  layout->addWidget(noRecent_);
  layout->addWidget(recent_, 1);
  layout->addWidget(remove_, 0, Qt::AlignRight);
  layout->addStretch(0);
  connect(open_, &QPushButton::clicked, this, &WelcomePage::openRequested);
  connect(continue_, &QPushButton::clicked, this, &WelcomePage::continueRequested);
  connect(remove_, &QPushButton::clicked, this, &WelcomePage::removeRecent);
  connect(recent_, &QListWidget::itemClicked, this, &WelcomePage::chooseRecent);
  connect(recent_, &QListWidget::currentItemChanged, this, &WelcomePage::updateRemove);
  return files;
}

QWidget* WelcomePage::makeSamples() {
  samples_ = new QWidget(this);
  auto* layout = new QVBoxLayout(samples_);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(8);
  layout->addWidget(heading(tr("Samples"), samples_));
  layout->addStretch(1);
  return samples_;
}

void WelcomePage::setSamples(const std::vector<Sample>& samples) {
  qDeleteAll(sampleButtons_);
  sampleButtons_.clear();
  samples_->setVisible(!samples.empty());
  auto* layout = static_cast<QVBoxLayout*>(samples_->layout());
  for (const Sample& sample : samples) {
    auto* button = new SampleButton(samples_);
    button->setObjectName(QStringLiteral("sampleButton"));
    button->setAccessibleName(tr("Sample %1").arg(sample.title));
    button->setAccessibleDescription(sample.description);
    button->setToolTip(sample.path);
    button->setFocusPolicy(Qt::StrongFocus);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    auto* picture = new QLabel(button);
    picture->setFixedSize(kThumbnail / 2);
    if (!sample.picture.isEmpty()) {
      QPixmap pixmap(sample.picture);
      pixmap =
          pixmap.scaled(kThumbnail / 2 * devicePixelRatioF(), Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation);
      pixmap.setDevicePixelRatio(devicePixelRatioF());
      picture->setPixmap(pixmap);
    }
    auto* title = new QLabel(QStringLiteral("<b>%1</b>").arg(sample.title), button);
    auto* text = new QLabel(sample.description, button);
    text->setObjectName(QStringLiteral("figures"));
    text->setWordWrap(true);
    for (QLabel* label : {picture, title, text}) label->setAttribute(Qt::WA_TransparentForMouseEvents);
    auto* grid = new QGridLayout(button);
    grid->setContentsMargins(6, 6, 8, 6);
    grid->setHorizontalSpacing(10);
    grid->setVerticalSpacing(1);
    grid->setColumnStretch(1, 1);
    grid->addWidget(picture, 0, 0, 2, 1);
    grid->addWidget(title, 0, 1, Qt::AlignBottom);
    grid->addWidget(text, 1, 1, Qt::AlignTop);
    // There is room for three lines at first; SampleButton grows where they do not suffice.
    button->setMinimumHeight(
        std::max(kThumbnail.height() / 2, title->sizeHint().height() + 3 * text->fontMetrics().lineSpacing()) + 12);
    connect(button, &QToolButton::clicked, this, [this, sample] { emit sampleChosen(sample.path, sample.pipeline); });
    layout->insertWidget(layout->count() - 1, button);
    sampleButtons_.push_back(button);
  }
}

QIcon WelcomePage::recentIcon(const QImage& picture, const QString& otherwise) const {
  const qreal ratio = devicePixelRatioF();
  QPixmap pixmap(kThumbnail / 2 * ratio);
  pixmap.setDevicePixelRatio(ratio);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  const QRect all(QPoint(0, 0), kThumbnail / 2);
  if (!picture.isNull()) {
    painter.drawImage(all, picture.scaled(pixmap.size(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation));
  } else {
    QRect middle(0, 0, kSmallIcon, kSmallIcon);
    middle.moveCenter(all.center());
    icon(otherwise).paint(&painter, middle);
  }
  painter.end();
  QIcon shown(pixmap);
  shown.addPixmap(pixmap, QIcon::Selected);  // as it is: a picture must not be tinted
  return shown;
}

void WelcomePage::setRecentFiles(const QStringList& paths, const RecentPictures& pictures) {
  const int row = recent_->currentRow();
  recent_->clear();
  for (const QString& path : paths) {
    const QFileInfo file(path);
    const bool missing = !file.exists();
    auto* item = new QListWidgetItem(recentIcon(missing ? QImage() : pictures.find(path),
                                                missing ? QStringLiteral("warning") : QStringLiteral("environment")),
                                     missing ? tr("%1 (missing)").arg(file.fileName()) + QLatin1Char('\n') + file.path()
                                             : file.fileName() + QLatin1Char('\n') + file.path(),
                                     recent_);
    item->setData(PathRole, path);
    item->setData(MissingRole, missing);
    item->setToolTip(path);
    if (missing) item->setForeground(palette().brush(QPalette::Disabled, QPalette::Text));
  }
  recent_->setCurrentRow(std::min(row, recent_->count() - 1));
  recent_->setVisible(!paths.isEmpty());
  noRecent_->setVisible(paths.isEmpty());
  updateRemove();
}

void WelcomePage::updateRemove() {
  remove_->setVisible(recent_->count() > 0);
  remove_->setEnabled(recent_->currentItem() != nullptr);
}

void WelcomePage::setLastSession(const std::optional<LastSession>& session) {
  continue_->setVisible(session.has_value());
  if (!session) return;
  continue_->setText(tr("Continue the last session: %1").arg(session->name));
  continue_->setToolTip(tr("As it was left on %1").arg(QLocale().toString(session->time, QLocale::ShortFormat)));
}

void WelcomePage::setClosable(bool closable) { close_->setVisible(closable); }

void WelcomePage::chooseRecent() {
  const QListWidgetItem* item = recent_->currentItem();
  if (item && !item->data(MissingRole).toBool()) emit fileChosen(item->data(PathRole).toString());
}

void WelcomePage::removeRecent() {
  if (const QListWidgetItem* item = recent_->currentItem()) emit removeRequested(item->data(PathRole).toString());
}

bool WelcomePage::eventFilter(QObject* watched, QEvent* event) {
  if (watched == recent_ && event->type() == QEvent::KeyPress) {
    switch (static_cast<QKeyEvent*>(event)->key()) {
      case Qt::Key_Return:
      case Qt::Key_Enter:
        chooseRecent();
        return true;
      case Qt::Key_Delete:
        removeRecent();
        return true;
      default:
        break;
    }
  }
  return QFrame::eventFilter(watched, event);
}

void WelcomePage::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && close_->isVisible()) {
    emit closeRequested();
    return;
  }
  QFrame::keyPressEvent(event);
}

// Samples are added and removed; the window's tab order does not contain those that were added late.
bool WelcomePage::focusNextPrevChild(bool next) {
  QList<QWidget*> order{close_, open_, continue_, recent_, remove_};
  for (QToolButton* button : sampleButtons_) order << button;
  order.removeIf([](const QWidget* widget) { return !widget->isVisible() || !widget->isEnabled(); });
  const qsizetype at = order.indexOf(window()->focusWidget());
  const qsizetype to = at + (next ? 1 : -1);
  if (at >= 0 && to >= 0 && to < order.size()) {
    order[to]->setFocus(next ? Qt::TabFocusReason : Qt::BacktabFocusReason);
    return true;
  }
  // Leaves the page through a control that the window's tab order contains.
  if (at >= 0) (next && remove_->isVisible() && remove_->isEnabled() ? remove_ : open_)->setFocus();
  return QFrame::focusNextPrevChild(next);
}

}  // namespace footfall::ui
