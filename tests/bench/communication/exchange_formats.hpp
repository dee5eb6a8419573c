// The formats between nodes that the communication benchmark compares (thesis 4.2), one block of points at a time.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

namespace footfall::bench {

/// A block of points in one format: made at random, then written, then read back.
class ExchangeFormat {
 public:
  virtual ~ExchangeFormat() = default;
  /// Makes `points` random points; the same for the same seed. Never timed.
  virtual void prepare(std::uint64_t seed, std::size_t points) = 0;
  /// The points as bytes, behind what `out` has.
  virtual void write(std::string& out) = 0;
  /// Reads a block. Throws detail::BadBytes.
  virtual void read(const std::string& bytes, std::size_t points) = 0;
  /// Returns whether read() gave the points of prepare(): the same value, the same expression or the same provenance.
  [[nodiscard]] virtual bool isSame() const = 0;
};

/// `operations` of each coordinate's expression: 0 for one node, else 3 or 12.
/// - ascii: the expression is evaluated, and written with 17 digits (4.2.1);
/// - binary: evaluated, eight bytes (4.2.2);
/// - tree: the expression itself, evaluated neither way (4.2.3);
/// - provenance: ours, which crossing of which lines a point is, by the writer of cell shares. There are no
/// expressions:
///   the depth means nothing.
std::unique_ptr<ExchangeFormat> makeAsciiFormat(int operations);
std::unique_ptr<ExchangeFormat> makeBinaryFormat(int operations);
std::unique_ptr<ExchangeFormat> makeTreeFormat(int operations);
std::unique_ptr<ExchangeFormat> makeProvenanceFormat();

}  // namespace footfall::bench
