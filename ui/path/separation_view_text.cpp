// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/path/separation_view_text.hpp"

#include <QCoreApplication>
#include <algorithm>
#include <utility>

#include "core/navigation/separation_text.hpp"
#include "ui/base/look/core_colours.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/base/text/core_text.hpp"

namespace footfall::ui {
namespace {

/// The struct is the context of the translations.
struct SeparationText {
  Q_DECLARE_TR_FUNCTIONS(footfall::ui::SeparationText)
};

QColor barrierColour() { return toColour(kVermilion); }

}  // namespace

QString lackText(const BorderLink& link, const Separation& separation, const LevelWriter& write) {
  return coreText(
      detail::lackText(link, separation, [&](double length) { return write.length(length).toStdString(); }));
}

QString separationText(const Separation& separation, const LevelWriter& write) {
  const BorderLink& link = separation.barrier();
  QString text = SeparationText::tr("The parts are nearest at %1: %2.")
                     .arg(write.place(link.from), lackText(link, separation, write));
  const auto count = static_cast<int>(separation.links.size());
  if (count > 1)
    text += QLatin1Char(' ') + SeparationText::tr("It is the largest of %n obstacles on the easiest way.", "", count);
  const auto others = static_cast<int>(separation.others.size());
  if (others > 0) text += QLatin1Char(' ') + SeparationText::tr("%n other ways lack little more.", "", others);
  return text;
}

void addSeparation(ViewOverlay& overlay, const Separation& separation, const LevelWriter& write) {
  ViewOverlay::Lines lines{{}, barrierColour(), 3, QColor(Qt::white)};
  for (std::size_t i = 0; i < separation.links.size(); ++i) {
    const BorderLink& link = separation.links[i];
    lines.segments.push_back({link.from, link.to});
    overlay.marks.push_back({link.from, barrierColour(), i == separation.largest ? 12.0F : 7.0F});
  }
  overlay.lines.push_back(std::move(lines));
  overlay.labels.push_back({separation.barrier().to, lackText(separation.barrier(), separation, write)});
}

std::array<Vec3, 2> boundsOf(const Separation& separation, double margin) {
  const Vec3 &a = separation.barrier().from, &b = separation.barrier().to;
  return {Vec3{std::min(a.x, b.x) - margin, std::min(a.y, b.y) - margin, std::min(a.z, b.z) - margin},
          Vec3{std::max(a.x, b.x) + margin, std::max(a.y, b.y) + margin, std::max(a.z, b.z) + margin}};
}

}  // namespace footfall::ui
