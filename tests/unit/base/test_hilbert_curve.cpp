// The places of cells along a Hilbert curve, by their definition.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <utility>
#include <vector>

#include "core/base/hilbert_curve.hpp"

using namespace footfall::detail;

namespace {

// Level by level: which quarter, and how the curve is turned in it.
std::uint64_t placeByLevels(std::uint32_t x, std::uint32_t y) {
  std::uint64_t place = 0;
  for (std::uint32_t half = 1U << 15U; half > 0; half /= 2) {
    const std::uint32_t right = (x & half) != 0 ? 1 : 0, upper = (y & half) != 0 ? 1 : 0;
    place = place * 4 + ((3 * right) ^ upper);
    if (upper != 0) continue;
    if (right != 0) x = 65535 - x, y = 65535 - y;
    std::swap(x, y);
  }
  return place;
}

}  // namespace

class TestHilbertCurve : public QObject {
  Q_OBJECT

 private slots:
  void placesAreThoseOfTheDefinition() {
    std::mt19937 random(1);
    for (int i = 0; i < 100000; ++i) {
      const std::uint32_t x = random() & 65535U, y = random() & 65535U;
      QCOMPARE(hilbertIndex(x, y), placeByLevels(x, y));
    }
    for (const std::uint32_t x : {0U, 1U, 32767U, 32768U, 65535U})
      for (const std::uint32_t y : {0U, 1U, 32767U, 32768U, 65535U}) QCOMPARE(hilbertIndex(x, y), placeByLevels(x, y));
  }

  // Each cell of a corner of 64 by 64 has a place of its own among the first, beside that of the place before.
  void neighboursAlongTheCurveAreNeighbours() {
    std::vector<std::pair<int, int>> cells(4096, {-1, -1});
    for (int x = 0; x < 64; ++x)
      for (int y = 0; y < 64; ++y)
        cells[hilbertIndex(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y))] = {x, y};
    for (std::size_t i = 1; i < cells.size(); ++i)
      QCOMPARE(std::abs(cells[i].first - cells[i - 1].first) + std::abs(cells[i].second - cells[i - 1].second), 1);
  }

  void neighboursAlongTheCurveInSpaceAreNeighbours() {
    constexpr std::uint32_t kSide = 16;
    std::vector<std::array<int, 3>> cells(kSide * kSide * kSide, {-1, -1, -1});
    for (std::uint32_t x = 0; x < kSide; ++x)
      for (std::uint32_t y = 0; y < kSide; ++y)
        for (std::uint32_t z = 0; z < kSide; ++z) {
          std::array<int, 3>& cell = cells.at(hilbertIndex3({x, y, z}));
          QCOMPARE(cell[0], -1);
          cell = {static_cast<int>(x), static_cast<int>(y), static_cast<int>(z)};
        }
    for (std::size_t i = 1; i < cells.size(); ++i) {
      int steps = 0;
      for (std::size_t k = 0; k < 3; ++k) steps += std::abs(cells[i][k] - cells[i - 1][k]);
      QCOMPARE(steps, 1);
    }
  }
};

QTEST_GUILESS_MAIN(TestHilbertCurve)
#include "test_hilbert_curve.moc"
