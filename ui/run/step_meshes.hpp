// Meshes of single steps, for display.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "core/pipeline/state_size.hpp"
#include "footfall/navigation_mesh.hpp"
#include "ui/base/namespaces.hpp"

namespace footfall::ui {

/// Stores meshes beside the cached states, by the steps so far. Thread-safe; the least recently used mesh is dropped
/// first.
class StepMeshes {
 public:
  using Mesh = std::shared_ptr<const NavigationMesh>;

  void store(const std::string& prefix, Mesh mesh) {
    const std::scoped_lock lock(mutex_);
    entries_.remove_if([&](const auto& entry) { return entry.first == prefix; });
    entries_.emplace_front(prefix, std::move(mesh));
    std::size_t bytes = 0;
    for (const auto& entry : entries_) bytes += entry.second ? detail::sizeOf(*entry.second) : 0;
    while (entries_.size() > kEntries || (bytes > kMostBytes && entries_.size() > kLeastEntries)) {
      bytes -= entries_.back().second ? detail::sizeOf(*entries_.back().second) : 0;
      entries_.pop_back();
    }
  }
  /// Returns null when the mesh is not known.
  Mesh find(const std::string& prefix) {
    const std::scoped_lock lock(mutex_);
    for (auto it = entries_.begin(); it != entries_.end(); ++it) {
      if (it->first != prefix) continue;
      entries_.splice(entries_.begin(), entries_, it);
      return it->second;
    }
    return nullptr;
  }

 private:
  static constexpr std::size_t kEntries = 32;       // the number of states that ResultCache keeps
  static constexpr std::size_t kLeastEntries = 12;  // enough for a run of a typical pipeline
  static constexpr std::size_t kMostBytes = std::size_t{256} << 20;
  std::mutex mutex_;
  std::list<std::pair<std::string, Mesh>> entries_;
};

}  // namespace footfall::ui
