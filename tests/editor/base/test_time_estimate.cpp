// The text about the time left: never "1 s left" for a minute.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <cmath>
#include <limits>

#include "ui/base/work/time_estimate.hpp"

using namespace footfall;
using namespace footfall::ui;
using Kind = EndEstimate::Kind;

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

}  // namespace

class TestTimeEstimate : public QObject {
  Q_OBJECT
 private slots:
  // 16,000 floors one above another: the clearance took 0.2 s, the layers take a minute and report no progress.
  void aStepThatTellsNothingHasNoEnd() {
    const auto left = [](double elapsed, std::optional<double> expected, double fraction) {
      return remainingMs({{200, 200, 1, true}, {expected, elapsed, fraction, false}, {50, 0, 0, false}});
    };
    QCOMPARE(*left(100, std::nullopt, 0), 50 + 125.0);  // average time of the others
    QCOMPARE(*left(100, 300, 0), 250.0);
    QVERIFY(std::isinf(*left(5000, std::nullopt, 0)));
    QVERIFY(std::isinf(*left(5000, 300, 0.01)));
    QVERIFY(std::isfinite(*left(5000, 9000, 0.01)));   // it took that long before
    QCOMPARE(*left(5000, 300, 0.5), 0.5 * 5000 + 50);  // its own pace
  }

  void anEstimateCountsDown() {
    EndEstimate end;
    end.begin(0);
    QCOMPARE(end.at(1).kind, Kind::Nothing);
    end.update(1, 0.1, 9);
    QCOMPARE(end.at(1).kind, Kind::Left);
    QCOMPARE(end.at(4).seconds, 6.0);
    end.update(5, 0.5, 5);
    QCOMPARE(end.at(6).seconds, 4.0);
  }

  void whatIsLateIsSaidToBe() {
    // No progress is reported any more.
    EndEstimate silent;
    silent.begin(0);
    silent.update(2, 0.9, 1);
    QCOMPARE(silent.at(3).kind, Kind::Left);
    QCOMPARE(silent.at(6).kind, Kind::Late);
    // The same second is reported again and again.
    EndEstimate frozen;
    frozen.begin(0);
    int left = 0, late = 0;
    for (double now = 2; now < 60; now += 0.25) {
      frozen.update(now, 0.9 + now / 10000, 1);
      ++(frozen.at(now).kind == Kind::Late ? late : left);
    }
    QVERIFY2(left < 20 && late > 200, qPrintable(QString("%1 %2").arg(left).arg(late)));
    // Progress continues after all.
    frozen.update(61, 0.99 + 0.02, 3);
    QCOMPARE(frozen.at(61).kind, Kind::Left);
  }

  void aMuchLaterEndIsBelievedInTime() {
    EndEstimate end;
    end.begin(0);
    end.update(2, 0.2, 8);
    end.update(4, 0.21, 30);
    QCOMPARE(end.at(20).kind, Kind::Left);
    QCOMPARE(end.at(20).seconds, 14.0);
    QCOMPARE(end.at(60).kind, Kind::Late);
  }

  void nothingToGoByIsSaidAfterAWhile() {
    EndEstimate end;
    end.begin(10);
    end.update(11, 0, std::nullopt);
    QCOMPARE(end.at(12).kind, Kind::Nothing);
    QCOMPARE(end.at(16).kind, Kind::Unknown);
    end.update(17, 0.5, kInfinite);
    QCOMPARE(end.at(17).kind, Kind::Unknown);
    // An unknown end after a promise counts as late.
    end.update(18, 0.6, 4);
    QCOMPARE(end.at(18).kind, Kind::Left);
    end.update(19, 0.6, kInfinite);
    QCOMPARE(end.at(19).kind, Kind::Late);
  }
};

QTEST_GUILESS_MAIN(TestTimeEstimate)
#include "test_time_estimate.moc"
