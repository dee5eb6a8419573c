// What the colours of cells mean: thread (or rank, of several processes), time, triangles or estimated cost.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QString>
#include <array>
#include <optional>
#include <vector>

#include "ui/view/cell_block.hpp"

namespace footfall::ui {

enum class CellColouring { Thread, Time, Triangles, Cost };
inline constexpr std::array kCellColourings = {CellColouring::Thread, CellColouring::Time, CellColouring::Triangles,
                                               CellColouring::Cost};

/// The name of a colouring for people, e.g. "Thread".
QString labelOf(CellColouring colouring);
/// The name of a colouring in files and on the command line, e.g. "thread".
const char* nameOf(CellColouring colouring);
std::optional<CellColouring> colouringFrom(const std::string& name);

/// Colours that people with the common colour deficiencies can tell apart (Okabe and Ito 2008), then darker and
/// lighter ones.
QColor threadColour(int thread);
/// Light for 0 to dark for 1: viridis (van der Walt and Smith 2015) the other way round, as the view's ground is light.
QColor scaleColour(double fraction);
/// Cells that have no figure yet; the view and the swatches hatch it.
QColor unfinishedColour();
/// The colour of a step inside bars, by the filter's place in its block.
QColor filterColour(std::size_t index);

/// The value from which on the darkest colour is used: the largest value, unless it lies far above the upper quartile
/// (twice as much, and more than three spans between the quartiles beyond it). Tukey 1977, "far out".
double darkestValue(std::vector<double> values);

/// The colours of one block's cells.
class CellScale {
 public:
  CellScale(const CellBlock& block, CellColouring wanted);

  /// What the colours show: the wanted, or costs where no cell has begun.
  [[nodiscard]] CellColouring shown() const { return shown_; }
  /// The largest value; 0 for threads.
  [[nodiscard]] double maximum() const { return maximum_; }
  /// The value of the darkest colour, which larger values have, too: few very large values must not make all others
  /// look alike. At most the largest.
  [[nodiscard]] double darkest() const { return darkest_; }
  /// How many colours there are for threads, or ranks.
  [[nodiscard]] int threads() const { return threads_; }
  [[nodiscard]] bool allKnown() const { return allKnown_; }
  /// Nothing while the cell has no such figure.
  [[nodiscard]] std::optional<QColor> colourOf(std::size_t cell) const { return colours_[cell]; }

 private:
  CellColouring shown_;
  double maximum_ = 0, darkest_ = 0;
  int threads_ = 1;
  bool allKnown_ = true;
  std::vector<std::optional<QColor>> colours_;
};

/// What a thread has done of a block, or a rank where there are ranks.
struct ThreadShare {
  int thread = 0;  ///< or rank
  double ms = 0;
  std::size_t cells = 0;
};
/// "Thread 3"; where there are ranks "Rank 1, thread 0" or "Editor, thread 0".
QString threadName(const CellRanks& ranks, int thread);

/// The shares of the threads (or ranks) that have finished a cell, the largest first.
std::vector<ThreadShare> threadShares(const CellBlock& block);

/// "12.3 ms", "1.24 s"; never "0 ms" for something.
QString durationText(double milliseconds);
/// A value of the colouring with its unit.
QString valueText(CellColouring colouring, double value);

}  // namespace footfall::ui
