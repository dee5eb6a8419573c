// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <algorithm>
#include <atomic>
#include <memory>
#include <thread>

#include "core/base/background_release.hpp"

using namespace footfall;
using namespace footfall::detail;

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
  void theCallerNeverFrees();
  void fewWait();
  void allGoInTheEnd();
};

// However quick the other thread is: once in some ten thousand times it was done before the caller had let go.
void TestBackgroundRelease::theCallerNeverFrees() {
  struct Told {
    std::atomic<bool>& gone;
    std::atomic<bool>& elsewhere;
    std::thread::id caller = std::this_thread::get_id();
    ~Told() {
      elsewhere = elsewhere && std::this_thread::get_id() != caller;
      gone = true;
    }
  };
  std::atomic<bool> elsewhere = true;
  for (int i = 0; i < 50000; ++i) {
    std::atomic<bool> gone = false;
    releaseInBackground(std::shared_ptr<Told>(new Told{gone, elsewhere}));
    while (!gone) std::this_thread::yield();
  }
  QVERIFY(elsewhere);
}

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
