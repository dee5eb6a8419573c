// The exact number types against GMP and MPFR: every carry, width and rounding that the predicates can meet.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmpxx.h>
#include <mpfr.h>

#include <QtTest>
#include <cmath>
#include <random>
#include <unordered_map>

#include "core/base/numbered_table.hpp"
#include "core/exact/error_twofold.hpp"
#include "core/exact/grid_integer.hpp"
#include "core/exact/integer_triples.hpp"
#include "core/exact/plan_kernel.hpp"
#include "core/exact/rounded_quotient.hpp"
#include "core/exact/sign_of_area.hpp"
#include "tests/support/soup_generators.hpp"

using namespace footfall;
using namespace footfall::detail;

namespace {

using Random = std::mt19937_64;

int integer(Random& random, int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); }

mpz_class toMpz(IntegerView x) {
  mpz_t borrowed;
  return mpz_class(mpz_roinit_n(borrowed, x.limbs, x.size));
}

IntegerView viewOf(const mpz_class& x) {
  return {mpz_limbs_read(x.get_mpz_t()), static_cast<int>(mpz_size(x.get_mpz_t())) * sgn(x)};
}

/// Limbs that carries run through: zeros, ones, single bits, and random ones.
mpz_class randomInteger(Random& random, int limbs) {
  mpz_class x = 0;
  const int pattern = integer(random, 0, 4);
  for (int i = 0; i < limbs; ++i) {
    unsigned long limb = random();
    const int kind = pattern == 4 ? integer(random, 0, 3) : pattern;
    if (kind == 0) limb = ~0UL;
    if (kind == 1) limb = i + 1 == limbs ? 1 : 0;
    if (kind == 2) limb = 1UL << (limb & 63);
    x = (x << 64) + mpz_class(limb);
  }
  return integer(random, 0, 1) == 0 ? x : mpz_class(-x);
}

bool isTrimmed(IntegerView x) { return x.size == 0 || x.limbs[x.count() - 1] != 0; }

bool equal(IntegerView x, const mpz_class& y) { return isTrimmed(x) && toMpz(x) == y && sgn(x) == sgn(y); }

/// The nearest double of value * 2^exponent by MPFR, subnormal ones included.
double reference(const mpq_class& value, int exponent) {
  mpq_class scaled = value;
  if (exponent >= 0)
    mpq_mul_2exp(scaled.get_mpq_t(), scaled.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
  else
    mpq_div_2exp(scaled.get_mpq_t(), scaled.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
  const mpfr_exp_t low = mpfr_get_emin(), high = mpfr_get_emax();
  mpfr_set_emin(-1073);
  mpfr_set_emax(1024);
  mpfr_t rounded;
  mpfr_init2(rounded, 53);
  const int lost = mpfr_set_q(rounded, scaled.get_mpq_t(), MPFR_RNDN);
  mpfr_subnormalize(rounded, lost, MPFR_RNDN);
  const double result = mpfr_get_d(rounded, MPFR_RNDN);
  mpfr_clear(rounded);
  mpfr_set_emin(low);
  mpfr_set_emax(high);
  return result + 0.0;
}

}  // namespace

class TestExactNumbers : public QObject {
  Q_OBJECT

 private slots:
  void sumsAndProducts() {
    Random random(test::seed());
    constexpr int kHalf = FixedInteger::kCapacity / 2;
    for (int i = 0; i < test::rounds(400'000); ++i) {
      // mostly as narrow as most decisions are, sometimes as wide as they can be
      const int most = i % 16 == 0 ? kHalf : 5;
      const mpz_class x = randomInteger(random, integer(random, 0, most));
      mpz_class y = randomInteger(random, integer(random, 0, most));
      if (i % 5 == 0) y = x;
      if (i % 5 == 1) y = -x;
      if (i % 5 == 2) y = i % 2 == 0 ? mpz_class(x + 1) : mpz_class(1 - x);
      if (std::max(mpz_size(x.get_mpz_t()), mpz_size(y.get_mpz_t())) > kHalf) continue;
      const FixedInteger a(viewOf(x)), b(viewOf(y));
      QVERIFY(equal(a, x) && equal(b, y));
      QVERIFY(equal(a + b, x + y));
      QVERIFY(equal(a - b, x - y));
      QVERIFY(equal(a * b, x * y));
      QVERIFY(equal(-a, -x));
      QCOMPARE(IntegerView(a).width(), x == 0 ? 0 : static_cast<int>(mpz_sizeinbase(x.get_mpz_t(), 2)));
      FixedInteger c = a;
      c = b;
      QVERIFY(equal(c, y));
    }
  }

  void fullWidth() {
    // the highest limbs, and results that shrink from there to nothing
    Random random(test::seed() + 1);
    constexpr int kMost = FixedInteger::kCapacity;
    for (int i = 0; i < test::rounds(20'000); ++i) {
      const mpz_class x = randomInteger(random, kMost - 1);
      const mpz_class y = i % 2 == 0 ? mpz_class(x - integer(random, -2, 2)) : randomInteger(random, kMost - 1);
      if (mpz_size(y.get_mpz_t()) > kMost - 1) continue;
      const FixedInteger a(viewOf(x)), b(viewOf(y));
      QVERIFY(equal(a + b, x + y));
      QVERIFY(equal(a - b, x - y));
      const int limbs = integer(random, 0, kMost);
      const mpz_class u = randomInteger(random, limbs), v = randomInteger(random, kMost - limbs);
      QVERIFY(equal(viewOf(u) * viewOf(v), u * v));
    }
  }

  void doublesOnTheGrid() {
    Random random(test::seed() + 2);
    for (int i = 0; i < test::rounds(150'000); ++i) {
      const bool narrow = i % 2 == 0;
      const int span = narrow ? kNarrowGrid - 53 : 1500;
      const int low = integer(random, -1074, -600);
      const auto number = [&]() -> double {
        if (integer(random, 0, 4) == 0) return 0;
        const double digits = integer(random, 0, 3) == 0 ? 1 : static_cast<double>(random() >> 11);
        return std::ldexp(integer(random, 0, 1) == 0 ? digits : -digits, low + integer(random, 0, span));
      };
      const double x = number(), y = i % 7 == 0 ? x : number();
      const auto toGrid = [&](double v) {
        mpq_class q(v);
        mpq_mul_2exp(q.get_mpq_t(), q.get_mpq_t(), static_cast<mp_bitcnt_t>(-low));
        return mpz_class(q);
      };
      QVERIFY(mpq_class(x) == mpq_class(toGrid(x)) / (mpz_class(1) << static_cast<mp_bitcnt_t>(-low)));
      QVERIFY(equal(gridInteger<FixedInteger>(x, low), toGrid(x)));
      QVERIFY(gridInteger<mpz_class>(x, low) == toGrid(x));
      QVERIFY(equal(gridDifference<FixedInteger>(x, y, low, narrow), toGrid(x) - toGrid(y)));
      Grid grid;
      grid.include(x);
      grid.include(y);
      if (grid.empty()) continue;
      QVERIFY(grid.low >= low);
      const mpz_class larger = cmp(abs(toGrid(x)), abs(toGrid(y))) > 0 ? toGrid(x) : toGrid(y);
      QCOMPARE(grid.width(), static_cast<int>(mpz_sizeinbase(larger.get_mpz_t(), 2)) + low - grid.low);
    }
  }

  void quotients() {
    Random random(test::seed() + 3);
    for (int i = 0; i < test::rounds(150'000); ++i) {
      const int most = i % 16 == 0 ? FixedInteger::kCapacity - 2 : i % 64 == 1 ? 100 : 6;
      mpz_class n = randomInteger(random, integer(random, 0, most)), d = 0;
      while (d == 0) d = randomInteger(random, integer(random, 1, most));
      if (i % 3 == 0) {
        // exactly representable, half way between two doubles, or just beside: 53 or 54 bits times the divisor
        const unsigned long digits = (random() >> integer(random, 9, 20)) | 1;
        n = d * mpz_class(digits);
        n <<= static_cast<mp_bitcnt_t>(integer(random, 0, 70));
        n += integer(random, -1, 1);
      }
      int exponent = integer(random, -200, 100);
      if (i % 4 == 0 && n != 0) {
        // sizes at the ends of the range
        const int size = static_cast<int>(mpz_sizeinbase(n.get_mpz_t(), 2) - mpz_sizeinbase(d.get_mpz_t(), 2));
        exponent = (i % 8 == 0 ? integer(random, -1080, -1015) : integer(random, 1018, 1026)) - size;
      }
      mpq_class value(n, d);
      value.canonicalize();
      const double expected = reference(value, exponent);
      bool exact = true;
      const double result = roundedQuotient(viewOf(n), viewOf(d), exponent, &exact);
      QVERIFY(result == expected);  // QCOMPARE lets doubles differ
      QVERIFY(!std::signbit(result) || result != 0);
      mpq_class scaled = value;
      if (exponent >= 0)
        scaled *= mpz_class(1) << static_cast<mp_bitcnt_t>(exponent);
      else
        scaled /= mpz_class(1) << static_cast<mp_bitcnt_t>(-exponent);
      QCOMPARE(exact, std::isfinite(result) && mpq_class(result) == scaled);
      bool lost = false;
      roundedQuotient(viewOf(n), viewOf(d), exponent, &lost);
      QVERIFY(!lost);
      if (exponent == 0) QVERIFY(nearestDouble(value) == result);
    }
  }

  // The bound holds after sums, products and quotients of numbers near to and far from each other, and is small.
  void twofolds() {
    Random random(5);
    const auto randomDouble = [&] {
      const double digits = static_cast<double>(static_cast<std::int64_t>(random()) >> integer(random, 0, 60));
      return std::ldexp(digits, integer(random, -80, 10));
    };
    const auto valueOf = [](const ErrorTwofold& x) { return mpq_class(mpq_class(x.high) + mpq_class(x.low)); };
    int quotients = 0, tight = 0;
    for (int round = 0; round < 3000; ++round) {
      std::vector<ErrorTwofold> numbers;
      std::vector<mpq_class> exact;
      for (int i = 0; i < 3; ++i) {
        const double a = randomDouble(), b = integer(random, 0, 1) == 0 ? 0 : randomDouble();
        numbers.push_back(ErrorTwofold::sum(a, b));
        exact.emplace_back(mpq_class(a) + mpq_class(b));
        QVERIFY(valueOf(numbers.back()) == exact.back());
      }
      for (int step = 0; step < 8; ++step) {
        const auto pick = [&] {
          return static_cast<std::size_t>(integer(random, 0, static_cast<int>(exact.size()) - 1));
        };
        const std::size_t i = pick(), j = pick();
        const int kind = integer(random, 0, 3);
        if (kind == 3 && exact[j] == 0) continue;
        const ErrorTwofold x = numbers[i], y = numbers[j];
        const ErrorTwofold made = kind == 0 ? x + y : kind == 1 ? x - y : kind == 2 ? x * y : x / y;
        if (!std::isfinite(made.error) || std::fabs(made.high) > 1e90 || std::fabs(made.high) < 1e-90) continue;
        mpq_class value = exact[i];
        if (kind == 0) value += exact[j];
        if (kind == 1) value -= exact[j];
        if (kind == 2) value *= exact[j];
        if (kind == 3) value /= exact[j];
        QVERIFY(abs(valueOf(made) - value) <= mpq_class(made.error));
        QVERIFY(std::fabs(made.low) <= 0x1p-53 * std::fabs(made.high));
        quotients += static_cast<int>(kind == 3);
        tight += static_cast<int>(made.error <= 0x1p-95 * std::fabs(made.high));
        numbers.push_back(made);
        exact.push_back(value);
      }
    }
    QVERIFY2(quotients > 1000 && tight > 10000, qPrintable(QString("%1 %2").arg(quotients).arg(tight)));
  }

  void triples() {
    Random random(test::seed() + 4);
    IntegerTriples store;
    for (int round = 0; round < 3; ++round) {
      store.clear();
      std::vector<std::array<mpz_class, 3>> truth;
      for (int i = 0; i < 500; ++i) {
        std::array<mpz_class, 3> x;
        for (auto& v : x) v = randomInteger(random, integer(random, 0, i % 50 == 0 ? 100 : 8));
        const bool fits = i % 50 != 0;
        const auto number = fits && i % 2 == 0
                                ? store.add(std::array{FixedInteger(viewOf(x[0])), FixedInteger(viewOf(x[1])),
                                                       FixedInteger(viewOf(x[2]))})
                                : store.add(x);
        QCOMPARE(number, i);
        truth.push_back(x);
      }
      for (int i = 0; i < 500; ++i)
        for (std::size_t k = 0; k < 3; ++k) {
          QVERIFY(equal(store[i][k], truth[i][k]));
          QVERIFY(store.wide(i)[k] == truth[i][k]);
        }
    }
  }

  // Places that are nearly or exactly on one line, with coordinates of few bits and of many.
  void signsOfAreas() {
    Random random(13);
    const auto coordinate = [&](int bits) {
      const double size = std::ldexp(static_cast<double>(random() >> (64 - bits)), 36 - bits);
      return integer(random, 0, 1) == 0 ? size : -size;
    };
    int zeros = 0, open = 0, openZeros = 0;
    for (int round = 0; round < 200000; ++round) {
      const int bits = integer(random, 0, 1) == 0 ? 20 : 53;
      const std::array<double, 2> p{coordinate(bits), coordinate(bits)}, q{coordinate(bits), coordinate(bits)};
      const double t = integer(random, 0, 3) / 2.0 + (integer(random, 0, 1) == 0 ? 0 : 0.1);
      std::array<double, 2> r{p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])};
      for (double& c : r)
        for (int ulps = integer(random, 0, 4); ulps > 2; --ulps) c = std::nextafter(c, 1e30);
      const auto exact = [](double x) { return mpq_class(x); };
      const mpq_class area = (exact(p[0]) - exact(r[0])) * (exact(q[1]) - exact(r[1])) -
                             (exact(p[1]) - exact(r[1])) * (exact(q[0]) - exact(r[0]));
      const MaybeSign sign = signOfArea(p, q, r);
      zeros += sgn(area) == 0 ? 1 : 0;
      open += sign ? 0 : 1;
      openZeros += !sign && sgn(area) == 0 ? 1 : 0;
      if (sign) QCOMPARE(*sign, sgn(area));
    }
    QVERIFY2(zeros > 10000 && open - openZeros < 20,
             qPrintable(QString("%1 %2 %3").arg(zeros).arg(open).arg(openZeros)));
  }

  void numberedTable() {
    Random random(test::seed() + 5);
    NumberedTable<PlanPoint> table;
    for (int filling = 0; filling < test::rounds(300); ++filling) {
      const int count = filling % 50 == 0 ? 3000 : integer(random, 0, 40);
      const auto text = [](const PlanPoint& p) {
        const PlanLine first = p.firstLine(), second = p.secondLine();
        std::string words = std::to_string(p.kind());
        for (const Index number : {first.kind, first.a, first.b, second.kind, second.a, second.b, p.face()})
          words.append(1, ' ').append(std::to_string(number));
        return words;
      };
      std::unordered_map<std::string, int> truth;
      for (int i = 0; i < 2 * count; ++i) {
        const int some = integer(random, 0, count);
        const PlanPoint p = integer(random, 0, 1) == 0 ? PlanPoint::edgePlane(some, integer(random, -1, 3), 4, -1)
                                                       : PlanPoint::crossing({0, some, integer(random, -1, 3)},
                                                                             {1, 2, 3}, integer(random, -1, 1));
        const auto [it, isNew] = truth.try_emplace(text(p), static_cast<int>(truth.size()));
        const auto [number, added] = table.insert(p);
        QCOMPARE(number, it->second);
        QCOMPARE(added, isNew);
        QVERIFY(table[number] == p);
      }
      QCOMPARE(table.size(), truth.size());
      table.clear();
      QCOMPARE(table.size(), std::size_t{0});
    }
  }
};

QTEST_APPLESS_MAIN(TestExactNumbers)
#include "test_exact_numbers.moc"
