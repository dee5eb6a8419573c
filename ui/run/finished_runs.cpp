// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/run/finished_runs.hpp"

#include <algorithm>
#include <utility>

#include "core/pipeline/state_size.hpp"
#include "ui/base/namespaces.hpp"

namespace footfall::ui {
namespace {

template <typename Value>
std::size_t bytesOf(const std::vector<Value>& values) {
  return values.capacity() * sizeof(Value);
}

std::size_t bytesOf(const NavigationMeshGeometry& geometry) {
  return bytesOf(geometry.surface) + bytesOf(geometry.creases) + bytesOf(geometry.outline) +
         bytesOf(geometry.obstacleEdges) + bytesOf(geometry.connections) + bytesOf(geometry.steps) +
         bytesOf(geometry.gaps) + bytesOf(geometry.drops);
}

std::size_t bytesOf(const FinishedRun& run, const ViewContent& content) {
  std::size_t bytes = run.result.mesh ? sizeOf(*run.result.mesh) : 0;
  for (const auto& geometry : content.walkable) bytes += bytesOf(*geometry);
  for (const ViewContent::Removed& removed : content.removed) bytes += bytesOf(*removed.before);
  if (content.environmentLayers) bytes += bytesOf(*content.environmentLayers);
  return bytes;
}

}  // namespace

void FinishedRuns::store(const std::string& key, std::shared_ptr<const FinishedRun> run, const ViewContent& content) {
  entries_.remove_if([&](const Entry& entry) {
    if (entry.key != key) return false;
    bytes_ -= entry.bytes;
    return true;
  });
  const std::size_t bytes = bytesOf(*run, content);
  if (bytes > bound_) return;
  entries_.push_front({key, std::move(run), content, bytes});
  bytes_ += bytes;
  while (bytes_ > bound_) {
    bytes_ -= entries_.back().bytes;
    entries_.pop_back();
  }
}

const FinishedRuns::Entry* FinishedRuns::find(const std::string& key) {
  const auto found = std::ranges::find(entries_, key, &Entry::key);
  if (found == entries_.end()) return nullptr;
  entries_.splice(entries_.begin(), entries_, found);
  return &entries_.front();
}

std::shared_ptr<const FinishedRun> FinishedRuns::peek(const std::string& key) const {
  const auto found = std::ranges::find(entries_, key, &Entry::key);
  return found == entries_.end() ? nullptr : found->run;
}

void FinishedRuns::clear() {
  entries_.clear();
  bytes_ = 0;
}

}  // namespace footfall::ui
