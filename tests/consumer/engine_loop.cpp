// The loop of an engine: edits go to a thread that computes, finished grounds come back, and each frame answers as many
// paths as its budget has time for. docs/how-to/engine.md explains it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <cstdio>
#include <deque>
#include <exception>
#include <footfall/footfall.hpp>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "floor.hpp"

using namespace footfall;

namespace {

using Clock = std::chrono::steady_clock;

/// A finished result. It never changes, so a path that is under way keeps the one that it began with.
struct Ground {
  Ground(const RunResult& run, const RunContext& context, std::size_t edits)
      : finder(run.mesh, &context), edits(edits) {}
  Ground(const RunResult& run, const Ground& before, const RunContext& context, std::size_t edits)
      : finder(run.mesh, before.finder, &context), edits(edits) {}
  PathFinder finder;  // finder.mesh() is the walkable area
  std::size_t edits;  // how many edits it has
};

/// The walkable ground of a level that changes while a game runs. The game's thread calls its functions; none of them
/// waits for a run.
class LiveGround {
 public:
  using Edit = std::function<void(EditableEnvironment&)>;

  LiveGround(std::shared_ptr<const Environment> level, const Agent& agent, int threads)
      : level_(std::move(level)),
        pipeline_(pipelineFor(*level_.environment(), agent)),
        threads_(threads),
        worker_([this] { work(); }) {}

  ~LiveGround() {
    {
      const std::lock_guard lock(mutex_);
      isClosing_ = true;
      if (running_) running_->cancel();
    }
    wake_.notify_one();
    worker_.join();
  }

  /// Queues an edit. The next run computes all that are queued by then.
  void edit(Edit edit) {
    {
      const std::lock_guard lock(mutex_);
      edits_.push_back(std::move(edit));
    }
    wake_.notify_one();
  }

  /// The newest finished ground; null before the first one. Throws, once, what went wrong since the last call.
  std::shared_ptr<const Ground> newest() {
    const std::lock_guard lock(mutex_);
    if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
    return newest_;
  }

 private:
  /// The edits to compute next; nothing when the level closes.
  std::optional<std::vector<Edit>> nextEdits(bool isFirst) {
    std::unique_lock lock(mutex_);
    wake_.wait(lock, [&] { return isClosing_ || isFirst || !edits_.empty(); });
    if (isClosing_) return std::nullopt;
    running_ = std::make_shared<RunContext>();
    return std::exchange(edits_, {});
  }

  void work() {
    for (bool isFirst = true;; isFirst = false) {
      const auto edits = nextEdits(isFirst);
      if (!edits) return;
      try {
        apply(*edits);
        const RunResult run = runPipeline(level_.environment(), pipeline_, *running_, &cache_, threads_);
        // Only this thread changes newest_.
        auto ground = newest_ ? std::make_shared<const Ground>(run, *newest_, *running_, done_)
                              : std::make_shared<const Ground>(run, *running_, done_);
        const std::lock_guard lock(mutex_);
        newest_ = std::move(ground);
      } catch (const Cancelled&) {
        return;
      } catch (const std::exception&) {
        keepFailure();  // memory ran out, for example; the ground before stays
      }
    }
  }

  /// An edit that is wrong changes nothing; the others are made all the same.
  void apply(const std::vector<Edit>& edits) {
    for (const Edit& edit : edits) {
      try {
        edit(level_);
      } catch (const InputError&) {
        keepFailure();
      }
    }
    done_ += edits.size();
  }

  void keepFailure() {
    const std::lock_guard lock(mutex_);
    failure_ = std::current_exception();
  }

  // Only the worker uses these.
  EditableEnvironment level_;
  Pipeline pipeline_;
  ResultCache cache_;
  std::size_t done_ = 0;
  int threads_;

  std::mutex mutex_;  // guards the members below
  std::condition_variable wake_;
  std::vector<Edit> edits_;
  std::shared_ptr<RunContext> running_;
  std::shared_ptr<const Ground> newest_;
  std::exception_ptr failure_;
  bool isClosing_ = false;
  std::thread worker_;  // declared last: it starts when all others are there
};

/// Somebody who wants to go somewhere.
struct Walker {
  Vec3 at, target;
  PathResult path;
  std::size_t edits = 0;  ///< of the ground that the path is on
};

/// Gives new paths to walkers whose ground has changed, until the frame's budget is used up. Returns how many are left.
std::size_t plan(std::vector<Walker>& walkers, const Ground& ground, Clock::time_point deadline, std::size_t& next) {
  std::size_t left = 0;
  for (const Walker& walker : walkers) left += walker.edits != ground.edits;
  for (std::size_t i = 0; i < walkers.size() && left > 0 && Clock::now() < deadline; ++i) {
    Walker& walker = walkers[next++ % walkers.size()];
    if (walker.edits == ground.edits) continue;
    walker.path = ground.finder.find(walker.at, walker.target);
    walker.edits = ground.edits;
    --left;
  }
  return left;
}

/// A wall of two metres' height from (x, 0) to (x, y).
TriangleSoup wallAt(double x, double y) {
  return {{{x, 0, 0}, {x, y, 0}, {x, y, 2}, {x, 0, 2}}, {{0, 1, 2}, {0, 2, 3}}};
}

int failed(const char* what) {
  std::fprintf(stderr, "failed: %s\n", what);
  return 1;
}

/// A game in which a wall moves in each frame, and walkers plan around it.
int play() {
  constexpr auto kBudget = std::chrono::milliseconds(1);
  constexpr std::size_t kEdits = 40;
  LiveGround live(floorOf(40), {.height = 1.8}, 1);
  auto wall = std::make_shared<ObstacleId>();
  live.edit([wall](EditableEnvironment& level) { *wall = level.add(wallAt(20, 30)); });

  std::vector<Walker> walkers;
  for (int i = 0; i < 20; ++i) walkers.push_back({{1, 1.0 + i, 0}, {39, 1.0 + i, 0}, {}, 0});
  std::size_t next = 0, frames = 0, edits = 1, grounds = 0, seen = 0, waiting = walkers.size();
  const auto end = Clock::now() + std::chrono::seconds(100);
  while (seen < kEdits || waiting > 0) {
    if (Clock::now() > end) return failed("the last edit arrives");
    ++frames;
    if (edits < kEdits) {
      const double x = 20 - 0.25 * static_cast<double>(edits++);
      live.edit([wall, x](EditableEnvironment& level) { level.replace(*wall, wallAt(x, 30)); });
    }
    if (const std::shared_ptr<const Ground> ground = live.newest()) {
      grounds += ground->edits != seen;
      seen = ground->edits;
      waiting = plan(walkers, *ground, Clock::now() + kBudget, next);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));  // the rest of the frame
  }
  std::printf("%zu frames, %zu edits, %zu grounds\n", frames, edits, grounds);
  if (grounds > kEdits) return failed("edits that are queued are computed at once");

  // The last ground is that of a run from nothing, and each path goes around the end of the wall.
  EditableEnvironment level(floorOf(40));
  level.add(wallAt(20 - 0.25 * (kEdits - 1), 30));
  RunContext context;
  const RunResult anew = runPipeline(level.environment(), pipelineFor(*level.environment(), {.height = 1.8}), context);
  const std::shared_ptr<const Ground> last = live.newest();
  if (anew.mesh->vertices != last->finder.mesh().vertices || anew.mesh->triangles != last->finder.mesh().triangles)
    return failed("the result is that of a run from nothing");
  for (const Walker& walker : walkers)
    if (!walker.path.reached() || walker.path.bends.empty()) return failed("walkers go around the wall");
  return 0;
}

/// A level that is left while its first run goes on: the run is cancelled, and nothing waits for its end.
int leaveEarly() {
  const auto begin = Clock::now();
  { const LiveGround live(floorOf(700), {}, 1); }
  const std::chrono::duration<double> took = Clock::now() - begin;
  std::printf("left after %.2f s\n", took.count());
  return 0;
}

/// An edit that is wrong arrives as an exception, and the edits after it are made.
int refuse() {
  LiveGround live(floorOf(4), {}, 1);
  const auto end = Clock::now() + std::chrono::seconds(100);
  std::string message;
  live.edit([](EditableEnvironment& level) { level.remove(7); });
  live.edit([](EditableEnvironment& level) { level.add(wallAt(2, 3)); });
  while (message.empty() && Clock::now() < end) {
    try {
      live.newest();
    } catch (const InputError& error) {
      message = error.what();
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  std::printf("%s\n", message.c_str());
  if (message.empty()) return failed("a wrong edit is reported");
  while (Clock::now() < end) {
    const std::shared_ptr<const Ground> ground = live.newest();
    if (ground && ground->edits == 2 && ground->finder.find({1, 1, 0}, {3, 1, 0}).bends.size() == 1) return 0;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return failed("the edit after a wrong one is made");
}

}  // namespace

int main() { return play() + leaveEarly() + refuse(); }
