// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#undef emit  // Qt's; TBB has functions of that name

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <mutex>
#include <new>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "core/base/parallel.hpp"
#include "core/base/parallel_sort.hpp"
#include "footfall/errors.hpp"
#include "tests/support/run_with_threads.hpp"

using namespace footfall;
using namespace footfall::detail;

namespace {

struct Other {};  // no std::exception: whatever is thrown arrives

/// Work on `values` that has a visible result; false when some of it is missing although it returned.
using NestedWork = std::function<bool(std::vector<int>& values)>;
/// The beginning of an exception's message names its kind.
using Thrower = std::function<void()>;

bool areAll(const std::vector<int>& values, int value) {
  return std::all_of(values.begin(), values.end(), [=](int v) { return v == value; });
}

bool fillRanges(std::vector<int>& values) {
  parallelRanges(values.size(), 16, [&](const auto& range) {
    for (std::size_t i = range.begin(); i != range.end(); ++i) values[i] = 1;
  });
  return areAll(values, 1);
}

bool fillEach(std::vector<int>& values) {
  parallelFor(values.size(), [&](std::size_t i) { values[i] = 1; });
  return areAll(values, 1);
}

bool fillBlocks(std::vector<int>& values) {
  forRanges(values.size(), 16, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i != last; ++i) values[i] = 1;
  });
  return areAll(values, 1);
}

template <std::size_t... Parts>
bool fillTogether(std::vector<int>& values, std::index_sequence<Parts...> /*parts*/) {
  const auto fill = [&](std::size_t part) {
    for (std::size_t i = part; i < values.size(); i += sizeof...(Parts)) values[i] = 1;
  };
  parallelInvoke([&] { fill(Parts); }...);
  return areAll(values, 1);
}

/// Two functions that each run a loop: a group within a group within the group that ends.
bool fillDeep(std::vector<int>& values) {
  const auto fill = [&](std::size_t first) {
    parallelRanges(values.size() / 2, 16, [&](const auto& range) {
      for (std::size_t i = range.begin(); i != range.end(); ++i) values[first + i] = 1;
    });
  };
  parallelInvoke([&] { fill(0); }, [&] { fill(values.size() / 2); });
  return areAll(values, 1);
}

bool sum(std::vector<int>& values) {
  return parallelReduce(
             values.size(), 16, std::size_t{0},
             [](const auto& range, std::size_t before) { return before + range.end() - range.begin(); },
             std::plus<>()) == values.size();
}

bool sort(std::vector<int>& values) {
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<int>(i * 7919 % values.size());
  parallelSort(values.begin(), values.end());
  return std::is_sorted(values.begin(), values.end());
}

std::string kindOf(const std::function<void()>& work) {
  try {
    work();
  } catch (const Cancelled&) {
    return "cancelled";
  } catch (const std::bad_alloc&) {
    return "memory";
  } catch (const std::runtime_error& error) {
    return error.what();
  } catch (const Other&) {
    return "other";
  }
  return "none";
}

struct Sibling {
  int incomplete = 0;  ///< results with missing parts that nested work returned
  int ended = 0;       ///< nested work that has reported an early end
  std::string thrown;  ///< the kind of the exception that reached whoever started the group
};

/// Runs `nested` again and again until the other function of its group throws, after `moment` microseconds.
Sibling runBeside(const NestedWork& nested, const Thrower& fail, int moment) {
  Sibling result;
  std::atomic<bool> isStarted = false;
  const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(30);
  result.thrown = kindOf([&] {
    parallelInvoke(
        [&] {
          while (!isStarted && std::chrono::steady_clock::now() < limit) std::this_thread::yield();
          const auto until = std::chrono::steady_clock::now() + std::chrono::microseconds(moment);
          while (std::chrono::steady_clock::now() < until) {
          }
          fail();
        },
        [&] {
          while (result.incomplete == 0 && std::chrono::steady_clock::now() < limit) {
            isStarted = true;
            std::vector<int> values(4096, 0);
            try {
              result.incomplete += nested(values) ? 0 : 1;
            } catch (const Cancelled&) {
              ++result.ended;
              throw;
            }
          }
        });
  });
  return result;
}

}  // namespace

class TestParallel : public QObject {
  Q_OBJECT

 private slots:
  void nestedWorkEndsWithItsGroup_data();
  void nestedWorkEndsWithItsGroup();
  void exceptionsArriveAsTheyAre_data();
  void exceptionsArriveAsTheyAre();
  void loopsVisitEachNumberOnce();
  void sortsAllSizes();
  void eachThreadHasItsOwnValue();
};

void TestParallel::nestedWorkEndsWithItsGroup_data() {
  QTest::addColumn<NestedWork>("nested");
  QTest::addColumn<Thrower>("fail");
  QTest::addColumn<QString>("kind");
  const std::vector<std::pair<const char*, NestedWork>> works{
      {"ranges", fillRanges},
      {"each", fillEach},
      {"blocks", fillBlocks},
      {"two", [](auto& values) { return fillTogether(values, std::make_index_sequence<2>()); }},
      {"three", [](auto& values) { return fillTogether(values, std::make_index_sequence<3>()); }},
      {"four", [](auto& values) { return fillTogether(values, std::make_index_sequence<4>()); }},
      {"deep", fillDeep},
      {"sum", sum},
      {"sort", sort}};
  const std::vector<std::pair<const char*, Thrower>> failures{
      {"cancelled", [] { throw Cancelled(); }},
      {"memory", [] { throw std::bad_alloc(); }},
      {"an error", [] { throw std::runtime_error("an error"); }},
      {"other", [] { throw Other(); }}};
  for (const auto& [name, work] : works)
    for (const auto& [kind, fail] : failures)
      QTest::addRow("%s beside %s", name, kind) << work << fail << QString(kind);
}

// TBB ends work within a group that ended without an exception. Results with missing parts were read after that.
void TestParallel::nestedWorkEndsWithItsGroup() {
  QFETCH(NestedWork, nested);
  QFETCH(Thrower, fail);
  QFETCH(QString, kind);
  int incomplete = 0, ended = 0;
  test::runWithThreads(2, [&] {
    for (int moment = 0; moment < 12; ++moment) {
      const Sibling result = runBeside(nested, fail, moment * 20);
      incomplete += result.incomplete;
      ended += result.ended;
      QCOMPARE(QString::fromStdString(result.thrown), kind);
    }
  });
  QCOMPARE(incomplete, 0);
  QVERIFY2(ended > 0, "no nested work was ended early: the test shows nothing");
}

void TestParallel::exceptionsArriveAsTheyAre_data() {
  QTest::addColumn<Thrower>("fail");
  QTest::addColumn<QString>("kind");
  QTest::addRow("memory") << Thrower([] { throw std::bad_alloc(); }) << "memory";
  QTest::addRow("error") << Thrower([] { throw std::runtime_error("an error"); }) << "an error";
  QTest::addRow("other") << Thrower([] { throw Other(); }) << "other";
}

// The other parts of the group are busy with nested work, each of which ends with Cancelled. None replaces the cause.
void TestParallel::exceptionsArriveAsTheyAre() {
  QFETCH(Thrower, fail);
  QFETCH(QString, kind);
  test::runWithThreads(4, [&] {
    for (int round = 0; round < 50; ++round) {
      const auto work = [&](std::size_t part) {
        parallelInvoke(
            [&] {
              for (int i = 0; i < 20; ++i) {
                std::vector<int> values(512, 0);
                fillRanges(values);
              }
            },
            [&] {
              std::vector<int> values(512, 0);
              parallelFor(values.size(), [&](std::size_t i) {
                if (part == 17 && i == 100) fail();
                values[i] = 1;
              });
            });
      };
      QCOMPARE(QString::fromStdString(kindOf([&] { parallelFor(32, work); })), kind);
    }
  });
}

void TestParallel::loopsVisitEachNumberOnce() {
  test::runWithThreads(4, [] {
    for (const int count : {0, 1, 2, 15, 16, 17, 1000, 100000}) {
      std::vector<std::atomic<int>> ranges(count), each(count), blocks(count);
      parallelRanges(count, 16, [&](const auto& range) {
        for (int i = range.begin(); i != range.end(); ++i) ++ranges[i];
      });
      parallelFor(count, [&](int i) { ++each[i]; });
      std::atomic<bool> isLong = false;
      forRanges(count, 16, [&](std::size_t first, std::size_t last) {
        if (last - first > 16) isLong = true;
        for (std::size_t i = first; i != last; ++i) ++blocks[i];
      });
      QVERIFY(!isLong);
      for (int i = 0; i < count; ++i) QVERIFY(ranges[i] == 1 && each[i] == 1 && blocks[i] == 1);
      const int sum = parallelReduce(
          count, 16, 0, [](const auto& range, int before) { return before + range.end() - range.begin(); },
          std::plus<>());
      QCOMPARE(sum, count);
    }
    parallelFor(-1, [](int) { QFAIL("no number is below -1"); });
  });
}

void TestParallel::sortsAllSizes() {
  test::runWithThreads(4, [] {
    std::mt19937 random(27);
    for (const std::size_t count : {0, 1, 2, 3, 500, 501, 16384, 16385, 16386, 200000})
      for (const int kinds : {1, 3, 1 << 30}) {
        std::vector<int> values(count);
        for (int& value : values) value = static_cast<int>(random() % kinds);
        std::vector<int> expected = values;
        std::sort(expected.begin(), expected.end(), std::greater<>());
        parallelSort(values.begin(), values.end(), std::greater<>());
        QVERIFY(values == expected);
      }
  });
}

void TestParallel::eachThreadHasItsOwnValue() {
  test::runWithThreads(4, [] {
    std::atomic<int> made = 0;
    PerThread<std::vector<std::thread::id>> values([&] {
      if (made++ == 0) throw std::bad_alloc();
      return std::vector<std::thread::id>();
    });
    QVERIFY_THROWS_EXCEPTION(std::bad_alloc, values.local());
    QVERIFY(!(values.begin() != values.end()));
    parallelFor(10000, [&](int) { values.local().push_back(std::this_thread::get_id()); });
    std::size_t total = 0;
    std::set<std::thread::id> threads;
    for (const auto& own : values) {
      QVERIFY(threads.insert(own.front()).second);
      total += own.size();
      for (const std::thread::id id : own) QVERIFY(id == own.front());
    }
    QCOMPARE(total, std::size_t{10000});
    QCOMPARE(made.load(), static_cast<int>(threads.size()) + 1);
  });
}

QTEST_APPLESS_MAIN(TestParallel)
#include "test_parallel.moc"
