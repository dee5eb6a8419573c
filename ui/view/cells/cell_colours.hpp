// The colours of cells by thread (or rank, with several processes), time, triangles or estimated cost.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QString>
#include <array>
#include <optional>
#include <vector>

#include "ui/view/cells/cell_block.hpp"

namespace footfall::ui {

enum class CellColouring { Thread, Time, Triangles, Cost };
inline constexpr std::array kCellColourings = {CellColouring::Thread, CellColouring::Time, CellColouring::Triangles,
                                               CellColouring::Cost};

/// The name of a colouring for people, e.g. "Thread".
QString labelOf(CellColouring colouring);
/// The name of a colouring in files and on the command line, e.g. "thread".
const char* nameOf(CellColouring colouring);
std::optional<CellColouring> colouringFrom(const std::string& name);

/// The colours of threads: colours that people with the common colour deficiencies can distinguish (Okabe and Ito
/// 2008), then darker and lighter ones.
QColor threadColour(int thread);
/// The colour of a fraction, from light for 0 to dark for 1: viridis (van der Walt and Smith 2015) reversed, because
/// the view's background is light.
QColor scaleColour(double fraction);
/// The colour of cells without a figure; the view and the swatches hatch it.
QColor unfinishedColour();
/// The colour of a step inside bars, by the filter's place in its block.
QColor filterColour(std::size_t index);

/// The value that gets the darkest colour: the largest value, unless it lies far above the upper quartile (twice as
/// much, and more than three interquartile ranges beyond it; "far out" in Tukey 1977).
double darkestValue(std::vector<double> values);

/// The colours of one block's cells.
class CellScale {
 public:
  CellScale(const CellBlock& block, CellColouring wanted);

  /// The colouring that is shown: the chosen one, or costs where no cell has begun.
  [[nodiscard]] CellColouring shown() const { return shown_; }
  /// The largest value; 0 for threads.
  [[nodiscard]] double maximum() const { return maximum_; }
  /// The value of the darkest colour, which larger values have too, so that few very large values do not make all
  /// others look alike. At most the largest value.
  [[nodiscard]] double darkest() const { return darkest_; }
  /// The number of colours for threads, or ranks.
  [[nodiscard]] int threads() const { return threads_; }
  [[nodiscard]] bool allKnown() const { return allKnown_; }
  /// Empty while the cell has no such figure.
  [[nodiscard]] std::optional<QColor> colourOf(std::size_t cell) const { return colours_[cell]; }

 private:
  CellColouring shown_;
  double maximum_ = 0, darkest_ = 0;
  int threads_ = 1;
  bool allKnown_ = true;
  std::vector<std::optional<QColor>> colours_;
};

/// The share of a thread in a block's work, or of a rank where there are ranks.
struct ThreadShare {
  int thread = 0;  ///< or rank
  double ms = 0;
  std::size_t cells = 0;
};
/// The name of a thread: "Thread 3"; where there are ranks, "Rank 1, thread 0" or "Editor, thread 0".
QString threadName(const CellRanks& ranks, int thread);

/// The shares of the threads (or ranks) that have finished a cell, the largest first.
std::vector<ThreadShare> threadShares(const CellBlock& block);

/// A time such as "12.3 ms" or "1.24 s"; "0 ms" only for exactly nothing.
QString durationText(double milliseconds);
/// A value of the colouring with its unit.
QString valueText(CellColouring colouring, double value);

}  // namespace footfall::ui
