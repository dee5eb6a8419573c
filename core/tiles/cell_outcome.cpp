// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/cell_outcome.hpp"

#include <algorithm>
#include <utility>

#include "core/base/byte_stream.hpp"

namespace footfall::detail {
namespace {

constexpr std::size_t kLeastPiece = 3, kLeastOutcome = 6;

FloorsAtGaps readFloors(ByteReader& in) {
  FloorsAtGaps read;
  const auto number = [&in] { return static_cast<std::uint32_t>(in.number()); };
  read.floors.resize(in.count(1));
  for (std::uint32_t& floor : read.floors) floor = number();
  read.joined.resize(in.count(2));
  for (auto& pair : read.joined)
    for (std::uint32_t& floor : pair) floor = number();
  read.corners.resize(in.count(1 + 2 * sizeof(double)));
  for (FloorsAtGaps::Corner& corner : read.corners) {
    corner.floor = number();
    for (double* x : {&corner.x, &corner.y}) *x = in.real();
  }
  read.sides.resize(in.count(1 + 4 * sizeof(double)));
  for (FloorsAtGaps::Side& side : read.sides) {
    side.floor = number();
    for (auto* place : {&side.lower, &side.upper})
      for (double& x : *place) x = in.real();
  }
  return read;
}

CellOutcome readOutcome(ByteReader& in) {
  CellOutcome outcome;
  outcome.cell = static_cast<std::size_t>(in.number());
  outcome.pieces.resize(in.count(kLeastPiece));
  for (CellOutcome::Piece& piece : outcome.pieces) {
    piece.range.first = in.number();
    piece.range.last = in.number();
    piece.written = in.text();
  }
  outcome.atGaps = readFloors(in);
  return outcome;
}

void write(const FloorsAtGaps& floors, ByteWriter& out) {
  out.number(floors.floors.size());
  for (const std::uint32_t floor : floors.floors) out.number(floor);
  out.number(floors.joined.size());
  for (const auto& pair : floors.joined)
    for (const std::uint32_t floor : pair) out.number(floor);
  out.number(floors.corners.size());
  for (const FloorsAtGaps::Corner& corner : floors.corners) {
    out.number(corner.floor);
    for (const double x : {corner.x, corner.y}) out.real(x);
  }
  out.number(floors.sides.size());
  for (const FloorsAtGaps::Side& side : floors.sides) {
    out.number(side.floor);
    for (const auto& place : {side.lower, side.upper})
      for (const double x : place) out.real(x);
  }
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
    write(outcome.atGaps, out);
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
