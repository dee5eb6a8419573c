// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <algorithm>
#include <atomic>
#include <memory>

#include "core/environment/background_release.hpp"

using namespace footfall;

namespace {

std::atomic<int> alive = 0;

struct Counted {
  Counted() { ++alive; }
  ~Counted() {
    QTest::qSleep(1);
    --alive;
  }
};

}  // namespace

class TestBackgroundRelease : public QObject {
  Q_OBJECT

 private slots:
  void fewWait();
  void allGoInTheEnd();
};

// Faster than anybody could free them: what waits stays bounded all the same.
void TestBackgroundRelease::fewWait() {
  int most = 0;
  for (int i = 0; i < 200; ++i) {
    releaseInBackground(std::make_shared<Counted>());
    most = std::max(most, alive.load());
  }
  QVERIFY2(most <= 6, qPrintable(QString::number(most)));
}

void TestBackgroundRelease::allGoInTheEnd() { QTRY_COMPARE(alive.load(), 0); }

QTEST_GUILESS_MAIN(TestBackgroundRelease)
#include "test_background_release.moc"
