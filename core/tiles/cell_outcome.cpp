// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/cell_outcome.hpp"

#include <algorithm>
#include <utility>

#include "core/base/byte_stream.hpp"

namespace footfall::detail {
namespace {

constexpr std::size_t kLeastPiece = 3, kLeastOutcome = 4;

CellOutcome readOutcome(ByteReader& in) {
  CellOutcome outcome;
  outcome.cell = static_cast<std::size_t>(in.number());
  outcome.pieces.resize(in.count(kLeastPiece));
  for (CellOutcome::Piece& piece : outcome.pieces) {
    piece.range.first = in.number();
    piece.range.last = in.number();
    piece.written = in.text();
  }
  outcome.atGaps.floors.resize(in.count(1));
  for (std::uint32_t& floor : outcome.atGaps.floors) floor = static_cast<std::uint32_t>(in.number());
  outcome.atGaps.corners.resize(in.count(2 * sizeof(double)));
  for (auto& [x, y] : outcome.atGaps.corners) {
    x = in.real();
    y = in.real();
  }
  return outcome;
}

}  // namespace

void CellCounts::add(const CellCounts& others) {
  cells += others.cells;
  largestCell = std::max(largestCell, others.largestCell);
  collected += others.collected;
  refused += others.refused;
  takenOver += others.takenOver;
}

std::string encodeOutcomes(const std::vector<CellOutcome>& outcomes, const CellCounts& counts) {
  ByteWriter out;
  for (const std::uint64_t count :
       {counts.cells, counts.largestCell, counts.collected, counts.refused, counts.takenOver})
    out.number(count);
  out.number(outcomes.size());
  for (const CellOutcome& outcome : outcomes) {
    out.number(outcome.cell);
    out.number(outcome.pieces.size());
    for (const CellOutcome::Piece& piece : outcome.pieces) {
      out.number(piece.range.first);
      out.number(piece.range.last);
      out.text(piece.written);
    }
    out.number(outcome.atGaps.floors.size());
    for (const std::uint32_t floor : outcome.atGaps.floors) out.number(floor);
    out.number(outcome.atGaps.corners.size());
    for (const auto& [x, y] : outcome.atGaps.corners) {
      out.real(x);
      out.real(y);
    }
  }
  return std::move(out.bytes);
}

void decodeOutcomes(std::string_view bytes, std::vector<CellOutcome>& outcomes, CellCounts& counts) {
  ByteReader in(bytes);
  CellCounts own;
  for (std::uint64_t* count : {&own.cells, &own.largestCell, &own.collected, &own.refused, &own.takenOver})
    *count = in.number();
  counts.add(own);
  for (std::size_t left = in.count(kLeastOutcome); left > 0; --left) outcomes.push_back(readOutcome(in));
  in.expectEnd();
}

}  // namespace footfall::detail
