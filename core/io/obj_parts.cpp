// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/obj_parts.hpp"

namespace footfall::detail {

void ObjPartChanges::add(Kind kind, std::string_view name, std::size_t triangles, std::size_t polygons) {
  changes_.push_back({name, triangles, polygons, kind});
}

void ObjPartChanges::countPolygons(const std::vector<std::size_t>& added) {
  for (Change& change : changes_) change.triangles += added[change.polygons];
}

void ObjPartAssigner::add(const ObjPartChanges& changes, std::size_t triangles) {
  std::size_t done = 0;
  for (const ObjPartChanges::Change& change : changes.all()) {
    assign(change.triangles - done);
    done = change.triangles;
    std::string& name = change.kind == ObjPartChanges::Material ? material_ : mesh_;
    if (change.kind == ObjPartChanges::Object) object_ = change.name;
    const std::string_view now =
        change.kind == ObjPartChanges::Group && change.name.empty() ? std::string_view(object_) : change.name;
    if (name == now) continue;
    name = now;
    isChanged_ = true;
  }
  assign(triangles - done);
}

void ObjPartAssigner::assign(std::size_t triangles) {
  if (triangles == 0) return;
  if (isChanged_) part_ = list_.numberOf(mesh_, material_);
  isChanged_ = false;
  environment_.partOf.insert(environment_.partOf.end(), triangles, part_);
}

}  // namespace footfall::detail
