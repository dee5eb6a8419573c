// The objects behind the handles of footfall.h, and the code that all its functions share.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <footfall.h>

#include <array>
#include <cstdint>
#include <footfall/footfall.hpp>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

struct footfall_context {
  footfall::RunContext context;
};

struct footfall_environment {
  std::shared_ptr<const footfall::Environment> environment;
};

struct footfall_level {
  footfall::EditableEnvironment level;
};

struct footfall_cache {
  footfall::ResultCache cache;
};

struct footfall_result {
  std::shared_ptr<const footfall::Environment> environment;
  footfall::Pipeline pipeline;
  footfall::RunResult run;

  [[nodiscard]] const footfall::NavigationMesh& mesh() const { return *run.mesh; }
};

struct footfall_components {
  footfall::Components components;
};

struct footfall_path_finder {
  std::shared_ptr<const footfall::Environment> environment;
  footfall::Pipeline pipeline;
  footfall::PathFinder finder;
};

struct footfall_path {
  footfall::PathResult path;
  std::string failure;
};

struct footfall_body_path_finder {
  std::shared_ptr<const footfall::Environment> environment;
  footfall::Pipeline pipeline;
  std::unique_ptr<const footfall::BodyPathFinder> finder;
};

struct footfall_body_path {
  footfall::BodyPath path;
  footfall_path way;  ///< the same as a handle of its own, with the reason why there is none
};

struct footfall_inspector {
  footfall::Inspector inspector;
};

namespace footfall::c {

/// Keeps the message of the exception that is being handled, for this thread, and returns its status.
footfall_status keepMessage(const char* function) noexcept;

/// Runs what stands in a function that can fail; keeps the message of what it throws.
template <class Work>
footfall_status guarded(const char* function, const Work& work) noexcept {
  try {
    work();
    return FOOTFALL_OK;
  } catch (...) {
    return keepMessage(function);
  }
}

/// Throws InputError when an argument is NULL.
template <class T>
T& given(T* argument, const char* name) {
  if (argument == nullptr) throw InputError(Pattern{"%1 is NULL"}, name);
  return *argument;
}

/// A place from three numbers; throws InputError when there are none.
inline Vec3 placeFrom(const double* numbers, const char* name) {
  given(numbers, name);
  return {numbers[0], numbers[1], numbers[2]};
}
inline void copyTo(const Vec3& from, double* to) {
  to[0] = from.x;
  to[1] = from.y;
  to[2] = from.z;
}

/// A handle, or null where it may be left out.
inline RunContext* contextOf(footfall_context* context) { return context == nullptr ? nullptr : &context->context; }
inline ResultCache* cacheOf(footfall_cache* cache) { return cache == nullptr ? nullptr : &cache->cache; }

/// A copy that footfall_free_text() frees.
char* copyOf(const std::string& text);

/// Throws InputError when there is a count and no array.
TriangleSoup soupOf(footfall_points vertices, footfall_triangles triangles);

/// The up axis that is meant; empty: guessed. Throws InputError for another number.
std::optional<UpAxis> upAxisOf(footfall_up_axis up);

// Points and lists of numbers lie in memory as C sees them.
static_assert(sizeof(Vec3) == 3 * sizeof(double) && sizeof(Triangle) == 3 * sizeof(std::uint32_t));
inline footfall_points spanOf(const std::vector<Vec3>& points) {
  return {reinterpret_cast<const double*>(points.data()), points.size()};
}
inline footfall_triangles spanOf(const std::vector<Triangle>& triangles) {
  return {reinterpret_cast<const std::uint32_t*>(triangles.data()), triangles.size()};
}
inline footfall_edges spanOf(const std::vector<std::array<std::uint32_t, 2>>& edges) {
  return {reinterpret_cast<const std::uint32_t*>(edges.data()), edges.size()};
}
inline footfall_numbers spanOf(const std::vector<std::uint32_t>& numbers) { return {numbers.data(), numbers.size()}; }

}  // namespace footfall::c
