// Runs in which allocations of 4 kB and more fail from a random one on. Each ends with its result or with the message
// about memory; tests/memory/run.sh is the long form, on whole programs. FOOTFALL_TEST_ROUNDS multiplies the runs.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>
#include <atomic>
#include <cstdlib>
#include <memory>
#include <new>
#include <random>
#include <string>

#include "core/io/import.hpp"
#include "footfall/environment.hpp"
#include "footfall/errors.hpp"
#include "footfall/run.hpp"
#include "tests/support/live_runs.hpp"
#include "tests/support/soup_generators.hpp"

namespace {

constexpr std::size_t kSmall = 4096;
constexpr long kNever = 1L << 60;
std::atomic<bool> isCounting = false;
std::atomic<long> left = kNever;  ///< allocations of at least kSmall bytes before they fail

void* allocate(std::size_t bytes, std::size_t alignment) {
  if (bytes >= kSmall && isCounting.load(std::memory_order_relaxed) && left.fetch_sub(1) <= 0) return nullptr;
  if (alignment <= __STDCPP_DEFAULT_NEW_ALIGNMENT__) return std::malloc(bytes == 0 ? 1 : bytes);
  return std::aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment);
}

void* allocateOrThrow(std::size_t bytes, std::size_t alignment) {
  void* const memory = allocate(bytes, alignment);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

}  // namespace

void* operator new(std::size_t bytes) { return allocateOrThrow(bytes, 1); }
void* operator new[](std::size_t bytes) { return allocateOrThrow(bytes, 1); }
void* operator new(std::size_t bytes, std::align_val_t alignment) {
  return allocateOrThrow(bytes, static_cast<std::size_t>(alignment));
}
void* operator new[](std::size_t bytes, std::align_val_t alignment) {
  return allocateOrThrow(bytes, static_cast<std::size_t>(alignment));
}
void* operator new(std::size_t bytes, const std::nothrow_t& /*tag*/) noexcept { return allocate(bytes, 1); }
void* operator new[](std::size_t bytes, const std::nothrow_t& /*tag*/) noexcept { return allocate(bytes, 1); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t /*bytes*/) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t /*bytes*/) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t /*alignment*/) noexcept { std::free(memory); }
void operator delete[](void* memory, std::align_val_t /*alignment*/) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t /*bytes*/, std::align_val_t /*alignment*/) noexcept {
  std::free(memory);
}
void operator delete[](void* memory, std::size_t /*bytes*/, std::align_val_t /*alignment*/) noexcept {
  std::free(memory);
}
void operator delete(void* memory, const std::nothrow_t& /*tag*/) noexcept { std::free(memory); }
void operator delete[](void* memory, const std::nothrow_t& /*tag*/) noexcept { std::free(memory); }

using namespace footfall;
using namespace footfall::test;

namespace {

/// Makes allocations fail while it lives.
class FailingMemory {
 public:
  explicit FailingMemory(long from) {
    left = from;
    isCounting = true;
  }
  ~FailingMemory() { isCounting = false; }
  FailingMemory(const FailingMemory&) = delete;
  FailingMemory& operator=(const FailingMemory&) = delete;

  /// The number of allocations since `from`.
  [[nodiscard]] long asked(long from) const { return from - left; }
};

}  // namespace

class TestMemoryRunsOut : public QObject {
  Q_OBJECT

 private slots:
  void runsEndWithAMessage_data();
  void runsEndWithAMessage();
};

void TestMemoryRunsOut::runsEndWithAMessage_data() {
  QTest::addColumn<QString>("after");
  QTest::addRow("default") << "SimplificationFilter\nLayerSubdivisionFilter\n";
  QTest::addRow("drops") << "SimplificationFilter\nLayerSubdivisionFilter\nDropFilter 2\n";
  QTest::addRow("radius") << "RadiusFilter 0.3\nLayerSubdivisionFilter\n";
}

// Loops beside a part of their group that threw std::bad_alloc left half-filled arrays, and reading those crashed.
void TestMemoryRunsOut::runsEndWithAMessage() {
  QFETCH(QString, after);
  const auto environment = importEnvironment(FOOTFALL_SOURCE_DIR "/samples/docks/docks.obj");
  const Pipeline pipeline =
      parsePipeline("DuplicationFilter 0\nSlopeFilter 45\nVerticalClearanceFilter 2\nStepFilter 0.4\nAreaFilter 1\n" +
                        after.toStdString(),
                    "test");
  const auto runOnce = [&] {
    RunContext context;
    return runPipeline(environment, pipeline, context, nullptr, 2);
  };
  const std::string expected = exported(runOnce());
  long count = 0;
  {
    const FailingMemory memory(kNever);
    runOnce();
    count = memory.asked(kNever);
  }
  QVERIFY(count > 50);
  std::mt19937_64 random(seed());
  int messages = 0;
  for (int i = 0; i < rounds(30); ++i) {
    const auto from = static_cast<long>(random() % static_cast<std::uint64_t>(count));
    QString problem;
    bool isMemory = false;
    {
      const FailingMemory memory(from);
      try {
        runOnce();
      } catch (const RunError& error) {
        isMemory = std::string_view(error.what()).find("memory ran out") != std::string_view::npos;
        if (!isMemory) problem = error.what();
      } catch (const std::bad_alloc&) {
        isMemory = true;  // outside the steps, where the program has a message of its own
      } catch (const std::exception& error) {
        problem = error.what();
      }
    }
    QVERIFY2(problem.isEmpty(), qPrintable(QString("allocations fail from %1 on: %2").arg(from).arg(problem)));
    messages += isMemory ? 1 : 0;
  }
  QVERIFY(messages > 0);
  QVERIFY2(exported(runOnce()) == expected, "a run after failed runs gives other bytes");
}

QTEST_APPLESS_MAIN(TestMemoryRunsOut)
#include "test_memory_runs_out.moc"
