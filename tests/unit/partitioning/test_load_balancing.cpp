// Longest processing time first, against Graham's bound and the best of all assignments.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include "core/partitioning/load_balancing.hpp"
#include "tests/support/soup_generators.hpp"

using namespace footfall;
using namespace footfall::detail;

namespace {

using Tasks = std::vector<std::size_t>;

double largest(const std::vector<double>& loads) { return *std::max_element(loads.begin(), loads.end()); }

// The smallest largest load, by trying everything; bins that are equally full are one choice.
double optimum(const std::vector<double>& costs, std::size_t task, std::vector<double>& loads, double best) {
  if (task == costs.size()) return std::min(best, largest(loads));
  for (std::size_t bin = 0; bin < loads.size(); ++bin) {
    if (std::find(loads.begin(), loads.begin() + static_cast<std::ptrdiff_t>(bin), loads[bin]) !=
        loads.begin() + static_cast<std::ptrdiff_t>(bin))
      continue;
    if (loads[bin] + costs[task] >= best) continue;
    loads[bin] += costs[task];
    best = optimum(costs, task + 1, loads, best);
    loads[bin] -= costs[task];
  }
  return best;
}

std::vector<double> wholeCosts(const std::vector<int>& numbers) { return {numbers.begin(), numbers.end()}; }

}  // namespace

class TestLoadBalancing : public QObject {
  Q_OBJECT

 private slots:
  void longestComeFirst() {
    QVERIFY(longestFirst(std::vector<double>{}).empty());
    QVERIFY((longestFirst(std::vector<double>{1, 3, 2}) == Tasks{1, 2, 0}));
    QVERIFY((longestFirst(std::vector<double>{2, 0, 2, 5, 0, 2}) == Tasks{3, 0, 2, 5, 1, 4}));
  }

  // Graham's example for three bins: 11 where 9 is possible, exactly the bound of 4/3 - 1/9.
  void worstCaseOfThree() {
    const std::vector<double> costs{5, 5, 4, 4, 3, 3, 3};
    const LoadBalance balance = assignLongestFirst(costs, 3);
    QVERIFY((balance.bins == std::vector<Tasks>{{0, 4, 6}, {1, 5}, {2, 3}}));
    QVERIFY((balance.loads == std::vector<double>{11, 8, 8}));
    QCOMPARE(balance.imbalance(), 11.0 / 9);
    std::vector<double> loads(3, 0);
    QCOMPARE(optimum(costs, 0, loads, std::numeric_limits<double>::infinity()), 9.0);
  }

  void tiesGoToTheFirst() {
    const LoadBalance balance = assignLongestFirst(std::vector<double>{1, 1, 1, 1, 1}, 2);
    QVERIFY((balance.bins == std::vector<Tasks>{{0, 2, 4}, {1, 3}}));
    QCOMPARE(balance.imbalance(), 1.2);
  }

  void moreBinsThanTasks() {
    const LoadBalance balance = assignLongestFirst(std::vector<double>{2, 4}, 4);
    QVERIFY((balance.bins == std::vector<Tasks>{{1}, {0}, {}, {}}));
    QVERIFY((balance.loads == std::vector<double>{4, 2, 0, 0}));
    QCOMPARE(balance.imbalance(), 4 / 1.5);
  }

  void nothingToDo() {
    const LoadBalance empty = assignLongestFirst(std::vector<double>{}, 3);
    QCOMPARE(empty.bins.size(), std::size_t{3});
    QCOMPARE(empty.imbalance(), 1.0);
    const LoadBalance zeros = assignLongestFirst(std::vector<double>{0, 0, 0}, 2);
    QCOMPARE(zeros.imbalance(), 1.0);
    QCOMPARE(zeros.bins[0].size() + zeros.bins[1].size(), std::size_t{3});
    QCOMPARE(LoadBalance().imbalance(), 1.0);
  }

  void enormousCosts() {
    const LoadBalance balance = assignLongestFirst(std::vector<double>{1.5e308, 1.5e308, 1.5e308}, 3);
    QCOMPARE(balance.imbalance(), 1.0);
  }

  void everyTaskOnceWithinTheBound() {
    QVERIFY(test::check("LPT bound", 300, [] {
      const auto costs = wholeCosts(*test::upTo(9, test::below(12)));
      const auto bins = static_cast<std::size_t>(1 + *test::below(4));
      const LoadBalance balance = assignLongestFirst(costs, bins);

      std::vector<int> met(costs.size(), 0);
      for (std::size_t bin = 0; bin < bins; ++bin) {
        double load = 0;
        for (const std::size_t task : balance.bins[bin]) ++met[task], load += costs[task];
        RC_ASSERT(load == balance.loads[bin]);
      }
      RC_ASSERT(std::all_of(met.begin(), met.end(), [](int count) { return count == 1; }));

      std::vector<double> loads(bins, 0);
      const double best = optimum(costs, 0, loads, std::numeric_limits<double>::infinity());
      const double m = static_cast<double>(bins);
      RC_ASSERT(largest(balance.loads) * 3 * m <= (4 * m - 1) * best);
      RC_ASSERT(balance.imbalance() >= 1);
    }));
  }

  void sameTwice() {
    std::mt19937_64 random(1);
    std::vector<double> costs(1000);
    for (double& cost : costs) cost = static_cast<double>(random() % 50);
    const LoadBalance first = assignLongestFirst(costs, 7), second = assignLongestFirst(costs, 7);
    QVERIFY(first.bins == second.bins);
    QVERIFY(first.imbalance() < 1.01);
  }
};

QTEST_APPLESS_MAIN(TestLoadBalancing)
#include "test_load_balancing.moc"
