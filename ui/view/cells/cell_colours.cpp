// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/cells/cell_colours.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "ui/base/look/core_colours.hpp"
#include "ui/base/text/localized_numbers.hpp"
#include "ui/base/text/translated.hpp"

namespace footfall::ui {
namespace {

double valueOf(const CellReport& cell, CellColouring colouring) {
  switch (colouring) {
    case CellColouring::Time:
      return cell.workMs();
    case CellColouring::Triangles:
      return static_cast<double>(cell.trianglesIn);
    case CellColouring::Cost:
      return cell.cost;
    case CellColouring::Thread:
      break;
  }
  return 0;
}

// The rank that began a cell where there are ranks, else the thread.
int workerOf(const CellBlock& block, const CellReport& cell) {
  return block.ranks.empty() ? cell.thread : std::max(0, block.ranks.placeOf(cell.thread).rank);
}

}  // namespace

QString labelOf(CellColouring colouring) {
  switch (colouring) {
    case CellColouring::Thread:
      return tr("Thread");
    case CellColouring::Time:
      return tr("Time");
    case CellColouring::Triangles:
      return tr("Triangles");
    case CellColouring::Cost:
      return tr("Estimated cost");
  }
  return {};
}

const char* nameOf(CellColouring colouring) {
  constexpr std::array kNames = {"thread", "time", "triangles", "cost"};
  return kNames[static_cast<std::size_t>(colouring)];
}

std::optional<CellColouring> colouringFrom(const std::string& name) {
  const auto* const found =
      std::ranges::find_if(kCellColourings, [&](CellColouring colouring) { return name == nameOf(colouring); });
  return found == kCellColourings.end() ? std::nullopt : std::optional(*found);
}

QColor threadColour(int thread) {
  constexpr std::array<Rgb, 7> kColours{kBlue, kOrange, kSkyBlue, kReddishPurple, kYellow, kBluishGreen, kVermilion};
  return numberedColour(kColours, static_cast<std::size_t>(thread));
}

QColor scaleColour(double fraction) {
  static const std::array<QColor, 9> kStops = {QColor(253, 231, 37), QColor(173, 220, 48), QColor(94, 201, 98),
                                               QColor(40, 174, 128), QColor(33, 145, 140), QColor(44, 114, 142),
                                               QColor(59, 82, 139),  QColor(71, 45, 123),  QColor(68, 1, 84)};
  const double place = std::clamp(fraction, 0.0, 1.0) * static_cast<double>(kStops.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), kStops.size() - 2);
  const auto part = static_cast<float>(place - static_cast<double>(below));
  const QColor& a = kStops[below];
  const QColor& b = kStops[below + 1];
  const auto mix = [part](float x, float y) { return x + part * (y - x); };
  return QColor::fromRgbF(mix(a.redF(), b.redF()), mix(a.greenF(), b.greenF()), mix(a.blueF(), b.blueF()));
}

QColor unfinishedColour() { return {206, 210, 215}; }

QColor filterColour(std::size_t index) {
  static const std::array<QColor, 5> kColours = {QColor(214, 219, 226), QColor(150, 160, 173), QColor(92, 103, 118),
                                                 QColor(184, 172, 156), QColor(128, 112, 96)};
  return kColours[index % kColours.size()];
}

QString threadName(const CellRanks& ranks, int thread) {
  if (ranks.empty()) return tr("Thread %1").arg(thread);
  const CellRanks::Place place = ranks.placeOf(thread);
  if (place.rank < 0) return tr("Editor, thread %1").arg(place.thread);
  return tr("Rank %1, thread %2").arg(place.rank).arg(place.thread);
}

double darkestValue(std::vector<double> values) {
  if (values.empty()) return 0;
  std::ranges::sort(values);
  const auto quartile = [&](std::size_t number) { return values[number * (values.size() - 1) / 4]; };
  const double upper = quartile(3);
  const double fence = std::max(2 * upper, upper + 3 * (upper - quartile(1)));
  return upper > 0 ? std::min(values.back(), fence) : values.back();
}

CellScale::CellScale(const CellBlock& block, CellColouring wanted)
    : shown_(wanted), threads_(block.ranks.empty() ? block.threads() : static_cast<int>(block.ranks.threads.size())) {
  const std::vector<CellReport>& cells = block.report.cells;
  if (!block.begun()) shown_ = CellColouring::Cost;
  const auto known = [&](std::size_t cell) { return shown_ == CellColouring::Cost || block.finished[cell] != 0; };
  std::vector<double> values;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!known(i)) continue;
    values.push_back(valueOf(cells[i], shown_));
    maximum_ = std::max(maximum_, values.back());
  }
  darkest_ = darkestValue(std::move(values));
  colours_.resize(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    allKnown_ = allKnown_ && known(i);
    if (!known(i)) continue;
    if (shown_ == CellColouring::Thread) {
      colours_[i] = threadColour(workerOf(block, cells[i]));
    } else {
      colours_[i] = scaleColour(darkest_ > 0 ? valueOf(cells[i], shown_) / darkest_ : 0);
    }
  }
}

std::vector<ThreadShare> threadShares(const CellBlock& block) {
  const std::vector<double> busy = block.ranks.empty() ? block.report.busyMs(block.threads()) : block.busyMsOfRanks();
  std::map<int, ThreadShare> shares;
  for (std::size_t i = 0; i < block.report.cells.size(); ++i) {
    if (block.finished[i] == 0) continue;
    const CellReport& cell = block.report.cells[i];
    const int worker = workerOf(block, cell);
    ThreadShare& share = shares[worker];
    share.thread = worker;
    share.ms = busy[static_cast<std::size_t>(worker)];
    ++share.cells;
  }
  std::vector<ThreadShare> sorted;
  for (const auto& [thread, share] : shares) sorted.push_back(share);
  std::ranges::stable_sort(sorted, [](const ThreadShare& a, const ThreadShare& b) { return a.ms > b.ms; });
  return sorted;
}

QString durationText(double milliseconds) {
  if (milliseconds >= 1000) return tr("%1 s").arg(fixedText(milliseconds / 1000, 2));
  if (milliseconds >= 10) return tr("%1 ms").arg(fixedText(milliseconds, milliseconds < 100 ? 1 : 0));
  if (milliseconds >= 0.005 || milliseconds == 0) return tr("%1 ms").arg(fixedText(milliseconds, 2));
  return tr("under 0.01 ms");
}

QString valueText(CellColouring colouring, double value) {
  switch (colouring) {
    case CellColouring::Time:
      return durationText(value);
    case CellColouring::Triangles:
      return value == 1 ? tr("1 triangle") : tr("%1 triangles").arg(fixedText(value, 0));
    case CellColouring::Cost:
      return tr("%1 units of work").arg(fixedText(value, 0));
    case CellColouring::Thread:
      break;
  }
  return tr("thread %1").arg(fixedText(value, 0));
}

}  // namespace footfall::ui
