// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/camera/camera_tools.hpp"

#include <QInputDialog>
#include <QSettings>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "footfall/errors.hpp"
#include "ui/base/text/localized_numbers.hpp"

namespace footfall::ui {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kFlySeconds = 15;  // time to fly from one end of the level to the other

Json toJson(const Vec3& v) { return {v.x, v.y, v.z}; }

Vec3 vectorFrom(const Json& json) {
  const Vec3 v{json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
  if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z))
    throw InputError(FOOTFALL_TEXT("a place is not finite"));
  return v;
}

}  // namespace

CameraTools::CameraTools(const FeatureHost& host, LevelView& view, ViewLayout& layout)
    : QObject(&host.window),
      window_(host.window),
      view_(view),
      camera_(view.cameraController()),
      status_(host.status),
      units_(host.units),
      sections_(host.sections),
      fly_(view) {
  setObjectName(QStringLiteral("cameraTools"));
  gizmo_ = new AxisGizmo(view_);
  layout.setGizmo(gizmo_);
  const auto takeUnits = [this] { gizmo_->setUnits(units_.units()); };
  connect(&units_, &UnitChoice::changed, gizmo_, takeUnits);
  takeUnits();
  addSides(host.commands);
  addMoves(host);
  addBookmarks(host.commands);
  connect(&view_, &LevelView::environmentChanged, this, [this] {
    const auto geometry = view_.environmentGeometry();
    const Vec3 size = geometry ? Vec3{geometry->upper.x - geometry->lower.x, geometry->upper.y - geometry->lower.y,
                                      geometry->upper.z - geometry->lower.z}
                               : Vec3{};
    const double across = std::hypot(size.x, size.y, size.z);
    fly_.setSpeed(across > 0 ? across / kFlySeconds : 1);
  });
  connect(&fly_, &FlyTool::speedChanged, this, [this](double speed) {
    const LevelUnits& units = units_.units();
    status_.say(StatusSubject::Note, tr("Fly: %1 %2 a second").arg(shortText(speed * units.factor(), 3), units.name()));
  });
}

void CameraTools::addSides(CommandRegistry& commands) {
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
    commands.add(
        {QString::fromLatin1(side.id), CommandMenu::View, QStringLiteral("camera"), side.text, side.help, {side.key}},
        [this, to = side.side](bool) { camera_.viewFrom(to); });
  }
  if (QAction* top = commands.find(QStringLiteral("view.top")))
    top->setShortcuts(top->shortcuts() << QKeySequence(Qt::Key_7));
}

void CameraTools::addMoves(const FeatureHost& host) {
  const QString group = QStringLiteral("camera moves");
  host.commands.add({QStringLiteral("view.projection"),
                     CommandMenu::View,
                     group,
                     tr("&Perspective or parallel"),
                     tr("Switch between perspective and parallel projection"),
                     {Qt::Key_5}},
                    [this](bool) { camera_.setOrthographic(!camera_.orthographic()); });
  QAction* frame = host.commands.add({QStringLiteral("view.frame"),
                                      CommandMenu::View,
                                      group,
                                      tr("Frame &selection"),
                                      tr("Bring the selection, or the place under the mouse, into view"),
                                      {Qt::Key_Home, Qt::Key_Period}},
                                     [this](bool) { camera_.frameSelection(); });
  frame->setShortcutContext(Qt::WidgetWithChildrenShortcut);  // lists use Home themselves
  view_.addAction(frame);
  Command fly{QStringLiteral("view.fly"),
              CommandMenu::Tools,
              QStringLiteral("camera"),
              tr("&Fly"),
              tr("Move through the level with W A S D, Q and E, and look with the mouse"),
              {QKeySequence(Qt::SHIFT | Qt::Key_F)}};
  host.tools.add(fly, &fly_);
  const QString setting = QStringLiteral("animateCamera");
  smooth_ = host.commands.add({QStringLiteral("view.animate"),
                               CommandMenu::View,
                               group,
                               tr("Glide to &new views"),
                               tr("Animate jumps of the camera; switch off to reduce motion"),
                               {},
                               {},
                               true},
                              [this, setting](bool on) {
                                if (QSettings().value(setting, true).toBool() != on) QSettings().setValue(setting, on);
                                camera_.setAnimated(on && interactive_);
                              });
  smooth_->setChecked(QSettings().value(setting, true).toBool());
}

void CameraTools::setInteractive(bool on) {
  interactive_ = on;
  camera_.setAnimated(on && smooth_->isChecked());
}

// --- Bookmarks

void CameraTools::addBookmarks(CommandRegistry& commands) {
  menu_ = new QMenu(tr("Book&marks"), &window_);
  menu_->setToolTipsVisible(true);
  commands.registerAction(menu_->menuAction(),
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
  sections_.add(
      {QStringLiteral("bookmarks"), [this] { return save(); }, [this](const std::string& text) { load(text); }});
}

void CameraTools::fillMenu() {
  menu_->clear();
  QAction* keep = menu_->addAction(tr("&Keep this view..."), this, &CameraTools::askForName);
  keep->setToolTip(tr("Save the camera position under a name"));
  keep->setEnabled(view_.environmentGeometry() != nullptr);
  menu_->addSeparator();
  if (bookmarks_.empty()) {
    menu_->addAction(tr("No bookmarks; Ctrl+Alt+1 to 9 saves one, Ctrl+Shift+1 to 9 goes there"))->setEnabled(false);
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
      emit sections_.changed();
    });
  }
  menu_->addSeparator();
  menu_->addMenu(forget);
}

// The view is saved in the first free slot.
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
  if (!view_.environmentGeometry() || slot < 1 || slot > kBookmarks) return;
  const QString used = name.trimmed().isEmpty() ? tr("View %1").arg(slot) : name.trimmed();
  bookmarks_[slot] = {used, camera_.pose()};
  status_.say(StatusSubject::Note, tr("Kept '%1'; Ctrl+Shift+%2 goes back to it").arg(used).arg(slot));
  emit sections_.changed();
}

void CameraTools::recallBookmark(int slot) {
  const auto found = bookmarks_.find(slot);
  if (found == bookmarks_.end()) {
    status_.say(StatusSubject::Note, tr("No view is saved there; Ctrl+Alt+%1 saves this one").arg(slot));
    return;
  }
  camera_.glideTo(found->second.pose);
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

}  // namespace footfall::ui
