// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/look/theme.hpp"

#include <QApplication>
#include <QFile>
#include <QSettings>
#include <array>
#include <utility>

#include "ui/base/look/system_colours.hpp"

namespace footfall::ui {
namespace {

const auto kSetting = QStringLiteral("theme");
constexpr std::array<const char*, 3> kChoiceNames = {"system", "light", "dark"};

// A pair of colours, for light and for dark.
struct Shades {
  const char* light;
  const char* dark;
  [[nodiscard]] QColor of(bool isDark) const { return {QLatin1String(isDark ? dark : light)}; }
};

// Colours of the style sheet beyond the palette's roles, by their names in it. Longer names come first, because one
// name may begin like another.
constexpr std::array<std::pair<const char*, Shades>, 13> kNamed = {{
    {"@accentSoft", {"#e3f0f9", "#1d3a4d"}},
    {"@accent", {"#0072b2", "#56b4e9"}},
    {"@errorSoft", {"#fbe3dc", "#4a2620"}},
    {"@error", {"#b02000", "#ff9a80"}},
    {"@warningSoft", {"#fff3d6", "#43361a"}},
    {"@warning", {"#b07800", "#e6b450"}},
    {"@handle", {"#76808a", "#8d97a1"}},
    {"@rowEdge", {"#cfd5dc", "#454c54"}},
    {"@strongEdge", {"#b9c1ca", "#5a626b"}},
    {"@titleBar", {"#e3e7ec", "#2c3238"}},
    {"@glass", {"rgba(255, 255, 255, 225)", "rgba(34, 38, 43, 228)"}},
    {"@fainterText", {"#4a545f", "#b4bdc6"}},
    {"@disabledText", {"#8c9299", "#79828b"}},
}};

Shades named(const char* name) {
  for (const auto& [key, shades] : kNamed) {
    if (QLatin1String(key) == QLatin1String(name)) return shades;
  }
  return kNamed.front().second;
}

}  // namespace

bool isDarkTheme() { return QGuiApplication::palette().color(QPalette::Window).lightnessF() < 0.5F; }

QPalette themePalette(bool dark) {
  constexpr std::array<std::pair<QPalette::ColorRole, Shades>, 19> kRoles = {{
      {QPalette::Window, {"#f0f2f5", "#23272b"}},
      {QPalette::WindowText, {"#1c242c", "#e6eaee"}},
      {QPalette::Base, {"#ffffff", "#1b1e22"}},
      {QPalette::AlternateBase, {"#f6f7f9", "#202428"}},
      {QPalette::Text, {"#1c242c", "#e6eaee"}},
      {QPalette::PlaceholderText, {"#69737e", "#949da6"}},
      {QPalette::Button, {"#eceff2", "#30363c"}},
      {QPalette::ButtonText, {"#1c242c", "#e6eaee"}},
      {QPalette::BrightText, {"#ffffff", "#ffffff"}},
      {QPalette::Highlight, {"#0072b2", "#0072b2"}},
      {QPalette::HighlightedText, {"#ffffff", "#ffffff"}},
      {QPalette::ToolTipBase, {"#fffffa", "#31373d"}},
      {QPalette::ToolTipText, {"#1c242c", "#e6eaee"}},
      {QPalette::Link, {"#005a8c", "#7cc6f0"}},
      {QPalette::LinkVisited, {"#7a4a6a", "#d9a4c4"}},
      {QPalette::Light, {"#ffffff", "#3c434a"}},
      {QPalette::Midlight, {"#e3e7ec", "#353b42"}},
      {QPalette::Mid, {"#b9c1ca", "#4c545c"}},
      {QPalette::Dark, {"#8c959f", "#15181b"}},
  }};
  QPalette palette;
  for (const auto& [role, shades] : kRoles) palette.setColor(role, shades.of(dark));
  palette.setColor(QPalette::Shadow, dark ? Qt::black : QColor(90, 98, 106));
  const QColor disabled = named("@disabledText").of(dark);
  for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    palette.setColor(QPalette::Disabled, role, disabled);
  palette.setColor(QPalette::Disabled, QPalette::Highlight, palette.color(QPalette::Mid));
  return palette;
}

QString themeStyleSheet(bool dark) {
  QFile file(QStringLiteral(":/resources/theme.qss"));
  if (!file.open(QIODevice::ReadOnly)) return {};
  QString sheet = QString::fromUtf8(file.readAll());
  for (const auto& [name, shades] : kNamed)
    sheet.replace(QLatin1String(name), QLatin1String(dark ? shades.dark : shades.light));
  return sheet;
}

QColor errorTextColour() { return named("@error").of(isDarkTheme()); }
QColor fainterTextColour() { return named("@fainterText").of(isDarkTheme()); }

Theme::Theme(QObject* parent) : QObject(parent), system_(new SystemColours(this)) {
  setObjectName(QStringLiteral("theme"));
  const QString kept = QSettings().value(kSetting).toString();
  for (std::size_t i = 0; i < kChoiceNames.size(); ++i) {
    if (kept == QLatin1String(kChoiceNames[i])) choice_ = static_cast<ThemeChoice>(i);
  }
  connect(system_, &SystemColours::changed, this, &Theme::apply);
  apply();
}

Theme::~Theme() = default;

Theme* Theme::instance() { return qApp ? qApp->findChild<Theme*>(QStringLiteral("theme")) : nullptr; }

void Theme::setChoice(ThemeChoice choice) {
  QSettings().setValue(kSetting, QLatin1String(kChoiceNames[static_cast<std::size_t>(choice)]));
  show(choice);
}

void Theme::show(ThemeChoice choice) {
  if (std::exchange(choice_, choice) == choice) return;
  apply();
  emit choiceChanged();
}

void Theme::apply() {
  const bool dark = choice_ == ThemeChoice::System ? system_->dark() : choice_ == ThemeChoice::Dark;
  if (applied_ == dark) return;
  applied_ = dark;
  QApplication::setPalette(themePalette(dark));
  // set again, because it keeps the colours of the palette at the time it was set
  qApp->setStyleSheet(themeStyleSheet(dark));
}

}  // namespace footfall::ui
