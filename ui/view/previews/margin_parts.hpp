// The clearance field of a mesh, prepared for drawing the places nearer to the border than any distance.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/poll.hpp"
#include "core/mesh/clearance_field.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/view/geometry/render_geometry.hpp"

namespace footfall::ui {

struct FacePart;
class ConvexPolygon;

/// The clearance field of a mesh as convex parts of its faces, each with one piece of the border: the places whose
/// straight way to that piece leads over the face's own side or through one stretch of it. The nearest piece of a place
/// is among those of the parts around it, so D(p) < r exactly where one of these parts is nearer than r (up to rounding
/// to floats, and up to 1 % at round corners, which are drawn with straight sides).
class MarginParts {
 public:
  /// Distances are known up to `bound`. `centre` is the origin of what is drawn.
  MarginParts(const NavigationMesh& mesh, double bound, const Vec3& centre, Poll poll);

  [[nodiscard]] double bound() const { return bound_; }
  /// Draws the places with D < `high`, without parts that are certainly nearer than `low`. Triangles may overlap. Null
  /// where there are no such places, or too many to preview.
  [[nodiscard]] std::shared_ptr<const NavigationMeshGeometry> between(double low, double high,
                                                                      const Paint& paint) const;
  /// Draws the places with D < `low` that between(low, high) covers.
  [[nodiscard]] std::shared_ptr<const NavigationMeshGeometry> below(double low, double high, const Paint& paint) const;

 private:
  using Corner = std::array<float, 3>;
  /// A part of a face. Distances are those in the plan from its places to its piece of the border.
  struct Part {
    float nearest = 0, farthest = 0;
    std::uint32_t face = 0, firstCorner = 0, cornerCount = 0;
    float sharedFrom = 1, sharedTo = 0;  ///< those of the FacePart
    bool isRound = false;                ///< the piece is a corner
    float spread = 0;                    ///< half the angle under which a corner sees the part; 0 for an edge
    float cosine = 1;                    ///< that of `spread`
    detail::FieldVector place;
    detail::FieldVector direction;  ///< towards the part, of length 1
  };
  class Drawing;

  void addPart(std::uint32_t face, const FacePart& shape);
  /// Sets the direction and the spread of a part around a corner; returns false where it has none.
  static bool look(Part& part, const ConvexPolygon& polygon, detail::FieldVector corner);
  template <class IsWanted>
  [[nodiscard]] std::shared_ptr<const NavigationMeshGeometry> draw(double low, double high, const Paint& paint,
                                                                   const IsWanted& isWanted) const;
  [[nodiscard]] std::vector<Part>::const_iterator endOf(double high) const;

  double bound_;
  detail::FieldVector origin_;                       ///< of the field's coordinates, relative to the centre
  std::vector<std::array<std::int8_t, 3>> normals_;  ///< of each face
  std::vector<Corner> corners_;
  std::vector<Part> parts_;  ///< ascending by `nearest`
  bool hasTooMany_ = false;
};

}  // namespace footfall::ui
