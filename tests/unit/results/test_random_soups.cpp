// Random, structured and degenerate soups through the filters and through the reference: the same, exactly.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <rapidcheck.h>

#include <QtTest>
#include <array>
#include <cmath>

#include "tests/reference/product_check.hpp"
#include "tests/support/soup_generators.hpp"

using namespace footfall;
using namespace footfall::test;
using reference::checkProduct;
using reference::Rounding;

namespace {

void expectSame(const Environment& environment, double slope, double clearance, Rounding rounding) {
  RC_LOG() << "slope " << slope << ", clearance " << clearance << "\n" << toText(environment);
  if (const auto error = checkProduct(environment, slope, clearance, rounding); !error.empty()) RC_FAIL(error);
}

double clearanceOf(int n) { return std::array{2.0, 1.0, 0.5, 1.5, 3.0}[static_cast<std::size_t>(n)]; }
double slopeOf(int n) { return std::array{45.0, 60.0, 30.0, 80.0, 54.7}[static_cast<std::size_t>(n)]; }

}  // namespace

Q_DECLARE_METATYPE(footfall::test::Soup)

class TestRandomSoups : public QObject {
  Q_OBJECT
 private slots:
  void foundBefore_data() {
    QTest::addColumn<Soup>("soup");
    QTest::addColumn<double>("clearance");
    const double tiny = 0x1p-30, huge = 0x1p30;
    QTest::newRow("crossing nearly at a corner")
        << Soup().triangle({0, 0, 0}, {2, 0, 0}, {0, huge, huge}).triangle({2, tiny, 0}, {0, huge, 0}, {1, tiny, 2})
        << 2.0;
    QTest::newRow("a sliver of a huge floor") << Soup()
                                                     .triangle({0, 0, 0}, {0, 1, 0}, {0, huge, tiny})
                                                     .triangle({0, 1, 0}, {0, 0, 0}, {huge, huge, 0})
                                                     .triangle({0, 256, 0}, {0, 0, 256}, {huge, 0, 0})
                                              << 2.0;
    QTest::newRow("one point by two constructions")
        << Soup()
               .triangle({122000.123, 487000.74171428574, 0.7}, {122000.123, 487000.456, 0},
                         {122000.45633333334, 487000.456, 1.4})
               .triangle({122000.123, 487000.74171428574, 0}, {122000.123, 487000.59885714285, 1.4},
                         {122000.78966666668, 487000.59885714285, 0})
               .triangle({122000.123, 487000.456, 1.4}, {122000.78966666668, 487000.456, 0},
                         {122000.45633333334, 487000.74171428574, 0.7})
        << 1.4;
  }

  void foundBefore() {  // Cases that the suites below once found, shrunk.
    QFETCH(Soup, soup);
    QFETCH(double, clearance);
    const std::string error = checkProduct(*soup.environment(), 80, clearance, Rounding::MayClose);
    QVERIFY2(error.empty(), error.c_str());
  }

  void tinyGrid() {
    QVERIFY(check("tiny grid", 120, [] {
      const auto soup = soupOf(*gridTriangles(14, 3, 3));
      expectSame(*soup.environment(*below(4) == 3), slopeOf(*below(5)), clearanceOf(*below(5)), Rounding::Harmless);
    }));
  }

  void flatGrid() {  // coplanar overlap everywhere
    QVERIFY(check("flat grid", 60, [] {
      const auto soup = soupOf(*gridTriangles(12, 4, 1));
      expectSame(*soup.environment(*below(2) == 1), 45, 1, Rounding::Harmless);
    }));
  }

  void twoLevels() {
    QVERIFY(check("two levels", 80, [] {
      const auto soup = soupOf(*gridTriangles(14, 4, 2));
      expectSame(*soup.environment(), slopeOf(*below(5)), clearanceOf(*below(5)), Rounding::Harmless);
    }));
  }

  void wallsOverFloors() {
    QVERIFY(check("walls over floors", 60, [] {
      Soup soup = Soup().floor(0, 0, 4, 4, 0).floor(4, 0, 6, 4, 0);
      for (const auto& n : *upTo(10, numbersBelow<6>(7)))
        soup.triangle({double(n[0]), double(n[1]), n[4] % 4 - 1.0}, {double(n[2]), double(n[3]), n[4] % 3 - 1.0},
                      {double(n[0]), double(n[1]), double(n[5] % 4)});
      expectSame(*soup.environment(), 45, clearanceOf(*below(5)), Rounding::Harmless);
    }));
  }

  void buildings() {
    QVERIFY(check("buildings", 40, [] {
      const auto soup = buildingOf(*buildingParts(8));
      expectSame(*soup.environment(), slopeOf(*below(5)), clearanceOf(*below(5)), Rounding::Harmless);
    }));
  }

  void largeGrid() {
    QVERIFY(check("large grid", 60, [] {
      const auto soup = soupOf(*gridTriangles(14, 1000, 5));
      expectSame(*soup.environment(), 80, clearanceOf(*below(5)), Rounding::MayClose);
    }));
  }

  void nearlyDegenerate() {  // a grid whose numbers are off by a few 2^-40
    QVERIFY(check("nearly degenerate", 80, [] {
      const auto triangles = *gridTriangles(13, 3, 3);
      const auto shifts = *rc::gen::container<std::vector<int>>(triangles.size() * 9, below(5));
      std::size_t i = 0;
      const auto soup = soupOf(triangles).mapped([&](const Vec3& v) {
        const auto next = [&] { return (shifts[i++] % 3 - 1) * 0x1p-40; };
        const double x = v.x + next(), y = v.y + next(), z = v.z + next();
        return Vec3{x, y, z};
      });
      expectSame(*soup.environment(), slopeOf(*below(5)), clearanceOf(*below(5)), Rounding::MayClose);
    }));
  }

  void hugeAndTiny() {  // powers of two far apart in one soup
    QVERIFY(check("huge and tiny", 80, [] {
      const auto triangles = *gridTriangles(13, 3, 3);
      const auto exponents = *rc::gen::container<std::vector<int>>(triangles.size() * 9, below(6));
      std::size_t i = 0;
      const auto soup = soupOf(triangles).mapped([&](const Vec3& v) {
        const auto scaled = [&](double c) {
          return std::ldexp(c, std::array{0, 0, 0, 30, -30, 8}[static_cast<std::size_t>(exponents[i++])]);
        };
        const double x = scaled(v.x), y = scaled(v.y), z = scaled(v.z);
        return Vec3{x, y, z};
      });
      expectSame(*soup.environment(), 80, clearanceOf(*below(5)), Rounding::MayClose);
    }));
  }

  void farFromTheOrigin() {  // map coordinates, all digits of a double in use
    QVERIFY(check("far from the origin", 60, [] {
      const auto soup = soupOf(*gridTriangles(14, 4, 3)).mapped([](const Vec3& v) {
        return Vec3{122000.123 + v.x / 3, 487000.456 + v.y / 7, v.z * 0.7};
      });
      expectSame(*soup.environment(), 80, 1.4, Rounding::MayClose);
    }));
  }

  void anyDoubles() {
    QVERIFY(check("any doubles", 80, [] {
      Soup soup;
      const auto element = rc::gen::container<std::array<std::uint32_t, 18>>(
          rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint32_t>()));
      for (const auto& n : *upTo(12, element)) {
        const auto number = [&](std::size_t i) {
          return std::ldexp(static_cast<double>((std::uint64_t{n[2 * i]} << 21) ^ n[2 * i + 1]), -51);
        };
        soup.triangle({number(0), number(1), number(2) / 8}, {number(3), number(4), number(5) / 8},
                      {number(6), number(7), number(8) / 8});
      }
      expectSame(*soup.environment(true), 45, 0.125, Rounding::MayClose);
    }));
  }
};

QTEST_APPLESS_MAIN(TestRandomSoups)
#include "test_random_soups.moc"
