// The parts of an OBJ file: which mesh and which material its faces belong to.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A mesh is named by the latest `o` or `g` statement. Programs write either, and programs that write both divide the
// object of an `o` by `g`. A `g` without a name returns to the object. A material is named by `usemtl`. Faces before
// such a statement have empty names.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/environment/part_names.hpp"

namespace footfall::detail {

/// The statements `o`, `g` and `usemtl` of a stretch of the text, which must outlive this object.
class ObjPartChanges {
 public:
  enum Kind : char { Object, Group, Material };
  struct Change {
    std::string_view name;
    std::size_t triangles;  ///< number in the stretch before the statement
    std::size_t polygons;   ///< the same for faces that are split later
    Kind kind;
  };

  /// `triangles` counts triangular faces until countPolygons().
  void add(Kind kind, std::string_view name, std::size_t triangles, std::size_t polygons);
  /// The first i polygons were split into `added[i]` triangles.
  void countPolygons(const std::vector<std::size_t>& added);
  [[nodiscard]] const std::vector<Change>& all() const { return changes_; }

 private:
  std::vector<Change> changes_;
};

/// Assigns the parts of triangles, stretch by stretch in the order of the file. A stretch need not outlive its add().
class ObjPartAssigner {
 public:
  /// `triangles` is the number in the whole environment.
  ObjPartAssigner(Environment& environment, std::size_t triangles)
      : environment_(environment), list_(environment.parts) {
    environment.partOf.reserve(triangles);
  }
  /// Adds the changes of the next stretch, which has `triangles` triangles.
  void add(const ObjPartChanges& changes, std::size_t triangles);
  /// Called after the last stretch.
  void finish() { dropUnnamedPart(environment_); }

 private:
  void assign(std::size_t triangles);

  Environment& environment_;
  PartList list_;
  std::string object_, mesh_, material_;
  bool isChanged_ = true;  ///< names have changed since `part_` was looked up
  std::uint32_t part_ = 0;
};

}  // namespace footfall::detail
