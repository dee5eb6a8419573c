// Arrays whose copies share their elements: a copy costs nothing, a change is never seen in another one.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <vector>

#include "core/base/shared_array.hpp"

namespace {

using footfall::detail::SharedArray;

class TestSharedArray : public QObject {
  Q_OBJECT
 private slots:
  void isEmptyAtFirst() {
    const SharedArray<int> none;
    QVERIFY(none.empty());
    QCOMPARE(none.size(), std::size_t{0});
    QVERIFY(none.begin() == none.end());
    QVERIFY(none == SharedArray<int>(std::vector<int>{}));
  }

  void copiesShareElements() {
    const SharedArray<int> first(std::vector<int>{1, 2, 3});
    const SharedArray<int> copy = first;
    QVERIFY(copy.data() == first.data());
    QVERIFY(copy == first);
    QCOMPARE(copy[2], 3);
  }

  void changesStayOnesOwn() {
    SharedArray<int> first(std::vector<int>{1, 2, 3});
    const SharedArray<int> copy = first;
    first.own()[1] = 5;
    QCOMPARE(first[1], 5);
    QCOMPARE(copy[1], 2);
    QVERIFY(copy.data() != first.data());
    QVERIFY(!(copy == first));
  }

  void whatNobodySharesStaysWhereItIs() {
    SharedArray<int> only(std::size_t{4});
    const int* const before = only.data();
    only.own()[3] = 7;
    QVERIFY(only.data() == before);
    QCOMPARE(std::vector<int>(only.begin(), only.end()), (std::vector<int>{0, 0, 0, 7}));
  }

  void movedFromIsEmpty() {
    SharedArray<int> first(std::vector<int>{1, 2});
    const SharedArray<int> moved = std::move(first);
    QCOMPARE(moved.size(), std::size_t{2});
    QVERIFY(first.empty());  // NOLINT(bugprone-use-after-move)
  }
};

}  // namespace

QTEST_GUILESS_MAIN(TestSharedArray)
#include "test_shared_array.moc"
