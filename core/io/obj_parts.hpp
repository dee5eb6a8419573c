// The parts of an OBJ file: which mesh and which material its faces belong to.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A mesh is named by the latest `o` or `g` statement: programs write either, and those that write both let `g` divide
// what `o` names. A `g` without a name goes back to the object. A material is named by `usemtl`. What comes before such
// a statement has empty names.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/environment/part_names.hpp"

namespace footfall::detail {

/// The statements `o`, `g` and `usemtl` of a stretch of the text, which must outlive this.
class ObjPartChanges {
 public:
  enum Kind : char { Object, Group, Material };
  struct Change {
    std::string_view name;
    std::size_t triangles;  ///< of the stretch, before the statement
    std::size_t polygons;   ///< the same, faces that are split later
    Kind kind;
  };

  /// `triangles` counts triangular faces until countPolygons().
  void add(Kind kind, std::string_view name, std::size_t triangles, std::size_t polygons);
  /// `added[i]` triangles came of the first i polygons.
  void countPolygons(const std::vector<std::size_t>& added);
  [[nodiscard]] const std::vector<Change>& all() const { return changes_; }

 private:
  std::vector<Change> changes_;
};

/// Goes through the stretches of a file in their order and gives the triangles their parts. A stretch need not outlive
/// its add().
class ObjPartAssigner {
 public:
  /// `triangles`: of the whole environment.
  ObjPartAssigner(Environment& environment, std::size_t triangles)
      : environment_(environment), list_(environment.parts) {
    environment.partOf.reserve(triangles);
  }
  /// Takes the changes of the next stretch, which has so many triangles.
  void add(const ObjPartChanges& changes, std::size_t triangles);
  /// To be called after the last stretch.
  void finish() { dropUnnamedPart(environment_); }

 private:
  void assign(std::size_t triangles);

  Environment& environment_;
  PartList list_;
  std::string object_, mesh_, material_;
  bool isChanged_ = true;  ///< the names, since `part_` was looked up
  std::uint32_t part_ = 0;
};

}  // namespace footfall::detail
