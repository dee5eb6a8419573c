// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/camera_tools.hpp"

#include <QInputDialog>
#include <QSettings>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "footfall/errors.hpp"
#include "ui/base/number_text.hpp"

namespace footfall::ui {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kFlySeconds = 15;  // from one end of the level to the other

Json toJson(const Vec3& v) { return {v.x, v.y, v.z}; }

Vec3 vectorFrom(const Json& json) {
  const Vec3 v{json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
  if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z))
    throw InputError(FOOTFALL_TEXT("a place is not finite"));
  return v;
}

}  // namespace

CameraTools::CameraTools(EditorWindow& window) : QObject(&window), window_(window), fly_(window.view()) {
  setObjectName(QStringLiteral("cameraTools"));
  gizmo_ = new AxisGizmo(window_.view());
  window_.overlays().gizmo = gizmo_;
  const auto takeUnits = [this] { gizmo_->setUnits(window_.units().units()); };
  connect(&window_.units(), &UnitChoice::changed, gizmo_, takeUnits);
  takeUnits();
  addSides();
  addMoves();
  addBookmarks();
  connect(&window_, &EditorWindow::environmentLoaded, this, [this] {
    const auto geometry = window_.view().environmentGeometry();
    const Vec3 size = geometry ? Vec3{geometry->upper.x - geometry->lower.x, geometry->upper.y - geometry->lower.y,
                                      geometry->upper.z - geometry->lower.z}
                               : Vec3{};
    const double across = std::hypot(size.x, size.y, size.z);
    fly_.setSpeed(across > 0 ? across / kFlySeconds : 1);
  });
  connect(&fly_, &FlyTool::speedChanged, this, [this](double speed) {
    const LevelUnits& units = window_.units().units();
    window_.say(tr("Fly: %1 %2 a second").arg(shortText(speed * units.factor(), 3), units.name()));
  });
}

void CameraTools::addSides() {
  LevelView& view = window_.view();
  struct Side {
    ViewSide side;
    const char* id;
    QString text, help;
    QKeySequence key;
  };
  const QKeyCombination back = Qt::CTRL | Qt::Key_1;
  const std::array<Side, 5> sides = {
      {{ViewSide::Bottom, "view.bottom", tr("From &below"), tr("Look straight up"), Qt::CTRL | Qt::Key_7},
       {ViewSide::Front, "view.front", tr("From the f&ront"), tr("Look level, from the front"), Qt::Key_1},
       {ViewSide::Back, "view.back", tr("From the bac&k"), tr("Look level, from the back"), back},
       {ViewSide::Right, "view.right", tr("From the ri&ght"), tr("Look level, from the right"), Qt::Key_3},
       {ViewSide::Left, "view.left", tr("From the &left"), tr("Look level, from the left"), Qt::CTRL | Qt::Key_3}}};
  for (const Side& side : sides) {
    window_.commands().add(
        {QString::fromLatin1(side.id), CommandMenu::View, QStringLiteral("camera"), side.text, side.help, {side.key}},
        [&view, to = side.side](bool) { view.viewFrom(to); });
  }
  if (QAction* top = window_.commands().find(QStringLiteral("view.top")))
    top->setShortcuts(top->shortcuts() << QKeySequence(Qt::Key_7));
}

void CameraTools::addMoves() {
  LevelView& view = window_.view();
  const QString group = QStringLiteral("camera moves");
  window_.commands().add({QStringLiteral("view.projection"),
                          CommandMenu::View,
                          group,
                          tr("&Perspective or parallel"),
                          tr("Switch between perspective and parallel projection"),
                          {Qt::Key_5}},
                         [&view](bool) { view.setOrthographic(!view.orthographic()); });
  QAction* frame = window_.commands().add({QStringLiteral("view.frame"),
                                           CommandMenu::View,
                                           group,
                                           tr("Frame &selection"),
                                           tr("Bring what is selected, or what the mouse points at, into sight"),
                                           {Qt::Key_Home, Qt::Key_Period}},
                                          [&view](bool) { view.frameSelection(); });
  frame->setShortcutContext(Qt::WidgetWithChildrenShortcut);  // Home has another use in lists
  view.addAction(frame);
  Command fly{QStringLiteral("view.fly"),
              CommandMenu::Tools,
              QStringLiteral("camera"),
              tr("&Fly"),
              tr("Move through the level with W A S D, Q and E, and look with the mouse"),
              {QKeySequence(Qt::SHIFT | Qt::Key_F)}};
  window_.addTool(fly, &fly_);
  const QString setting = QStringLiteral("animateCamera");
  QAction* smooth = window_.commands().add({QStringLiteral("view.animate"),
                                            CommandMenu::View,
                                            group,
                                            tr("Glide to &new views"),
                                            tr("Show where the camera goes when it jumps; off to reduce motion"),
                                            {},
                                            {},
                                            true},
                                           [this, setting](bool on) {
                                             if (QSettings().value(setting, true).toBool() != on)
                                               QSettings().setValue(setting, on);
                                             window_.view().setAnimated(on && window_.interactive());
                                           });
  smooth->setChecked(QSettings().value(setting, true).toBool());
}

// --- Bookmarks

void CameraTools::addBookmarks() {
  menu_ = new QMenu(tr("Book&marks"), &window_);
  menu_->setToolTipsVisible(true);
  window_.commands().adopt(menu_->menuAction(),
                           {QStringLiteral("view.bookmarks"), CommandMenu::View, QStringLiteral("bookmarks"), {}, {}});
  connect(menu_, &QMenu::aboutToShow, this, &CameraTools::fillMenu);
  // Their keys work without the menu.
  for (int slot = 1; slot <= kBookmarks; ++slot) {
    const auto key = static_cast<Qt::Key>(Qt::Key_0 + slot);
    for (const bool keep : {false, true}) {
      auto* action = new QAction(&window_);
      action->setObjectName(QStringLiteral("%1Bookmark%2").arg(keep ? "keep" : "recall").arg(slot));
      action->setShortcut(keep ? QKeySequence(Qt::CTRL | Qt::ALT | key) : QKeySequence(Qt::CTRL | Qt::SHIFT | key));
      connect(action, &QAction::triggered, this, [this, slot, keep] {
        if (keep) {
          keepBookmark(slot, bookmarks_.contains(slot) ? bookmarks_[slot].name : QString());
        } else {
          recallBookmark(slot);
        }
      });
      window_.addAction(action);
    }
  }
  fillMenu();
  window_.addSessionSection(
      {QStringLiteral("bookmarks"), [this] { return save(); }, [this](const std::string& text) { load(text); }});
}

void CameraTools::fillMenu() {
  menu_->clear();
  QAction* keep = menu_->addAction(tr("&Keep this view..."), this, &CameraTools::askForName);
  keep->setToolTip(tr("Remember where the camera is, under a name"));
  keep->setEnabled(window_.environment() != nullptr);
  menu_->addSeparator();
  if (bookmarks_.empty()) {
    menu_->addAction(tr("No bookmarks; Ctrl+Alt+1 to 9 keep one, Ctrl+Shift+1 to 9 go there"))->setEnabled(false);
    return;
  }
  auto* forget = new QMenu(tr("&Forget"), menu_);
  for (const auto& [number, bookmark] : bookmarks_) {
    const int slot = number;
    QAction* recall = menu_->addAction(bookmark.name, this, [this, slot] { recallBookmark(slot); });
    recall->setToolTip(
        QKeySequence(Qt::CTRL | Qt::SHIFT | static_cast<Qt::Key>(Qt::Key_0 + slot)).toString(QKeySequence::NativeText));
    forget->addAction(bookmark.name, this, [this, slot] {
      bookmarks_.erase(slot);
      window_.keepSoon();
    });
  }
  menu_->addSeparator();
  menu_->addMenu(forget);
}

// In the first slot that is free.
void CameraTools::askForName() {
  int slot = 1;
  while (slot < kBookmarks && bookmarks_.contains(slot)) ++slot;
  auto* dialog = new QInputDialog(&window_);
  dialog->setObjectName(QStringLiteral("bookmarkName"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(tr("Keep this view"));
  dialog->setLabelText(tr("Name of the view (Ctrl+Shift+%1 goes back to it):").arg(slot));
  dialog->setTextValue(tr("View %1").arg(slot));
  connect(dialog, &QInputDialog::textValueSelected, this,
          [this, slot](const QString& name) { keepBookmark(slot, name); });
  dialog->open();
}

void CameraTools::keepBookmark(int slot, const QString& name) {
  if (!window_.environment() || slot < 1 || slot > kBookmarks) return;
  const QString used = name.trimmed().isEmpty() ? tr("View %1").arg(slot) : name.trimmed();
  bookmarks_[slot] = {used, window_.view().cameraPose()};
  window_.say(tr("Kept '%1'; Ctrl+Shift+%2 goes back to it").arg(used).arg(slot));
  window_.keepSoon();
}

void CameraTools::recallBookmark(int slot) {
  const auto found = bookmarks_.find(slot);
  if (found == bookmarks_.end()) {
    window_.say(tr("No view is kept there; Ctrl+Alt+%1 keeps this one").arg(slot));
    return;
  }
  window_.view().glideTo(found->second.pose);
}

std::string CameraTools::save() const {
  Json json = Json::array();
  for (const auto& [slot, bookmark] : bookmarks_) {
    json.push_back({{"slot", slot},
                    {"name", bookmark.name.toStdString()},
                    {"position", toJson(bookmark.pose.position)},
                    {"pivot", toJson(bookmark.pose.pivot)},
                    {"orientation", bookmark.pose.orientation},
                    {"orthographic", bookmark.pose.orthographic}});
  }
  return json.dump();
}

void CameraTools::load(const std::string& text) {
  bookmarks_.clear();
  if (text.empty()) return;
  try {
    std::map<int, Bookmark> read;
    for (const Json& json : Json::parse(text)) {
      Bookmark bookmark;
      bookmark.name = QString::fromStdString(json.at("name").get<std::string>());
      bookmark.pose.position = vectorFrom(json.at("position"));
      bookmark.pose.pivot = vectorFrom(json.at("pivot"));
      bookmark.pose.orientation = json.at("orientation").get<std::array<double, 4>>();
      bookmark.pose.orthographic = json.value("orthographic", false);
      double norm = 0;
      for (const double part : bookmark.pose.orientation) norm += part * part;
      const int slot = json.at("slot").get<int>();
      if (!(norm > 0.9 && norm < 1.1) || slot < 1 || slot > kBookmarks)
        throw InputError(FOOTFALL_TEXT("'%1' is no view"), bookmark.name.toStdString());
      read[slot] = bookmark;
    }
    bookmarks_ = std::move(read);
  } catch (const Json::exception&) {
    throw InputError(FOOTFALL_TEXT("something is missing or of the wrong type"));
  }
}

void installCameraTools(EditorWindow& window) { new CameraTools(window); }

}  // namespace footfall::ui
