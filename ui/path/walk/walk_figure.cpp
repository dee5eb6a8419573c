// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/path/walk/walk_figure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/base/vector.hpp"
#include "ui/base/look/core_colours.hpp"
#include "ui/base/namespaces.hpp"
#include "ui/view/steering/eye_pose.hpp"

namespace footfall::ui {
namespace {

constexpr double kPersonRadius = 0.125;  // of the height: half of a person's width
constexpr int kSegments = 32;            // around
constexpr int kRings = 8;                // in each half of a sphere
constexpr int kShades = 8;
constexpr double kDarkest = 0.55;  // of the colour, on the side away from the light

/// A circle of the capsule: how far from the axis, how high, and how steep the surface is there.
struct Ring {
  double radius, height, outwards, upwards;
};

std::vector<Ring> ringsOf(const WalkBody& body) {
  std::vector<Ring> rings;
  for (const bool isTop : {false, true}) {
    for (int i = 0; i <= kRings; ++i) {
      const double angle = M_PI / 2 * (isTop ? static_cast<double>(i) / kRings : static_cast<double>(i) / kRings - 1);
      const double outwards = std::cos(angle), upwards = std::sin(angle);
      const double middle = isTop ? body.height - body.radius : body.radius;
      rings.push_back({body.radius * outwards, middle + body.radius * upwards, outwards, upwards});
    }
  }
  return rings;
}

/// The body's surface in shades, from dark to light, and the eyes.
class FigureMaker {
 public:
  FigureMaker(const WalkBody& body, const Vec3& feet, double turn, const CameraPose& camera)
      : body_(body), feet_(feet), turn_(turn * M_PI / 180), camera_(camera), sight_(directionOf(sightOf(camera))) {
    // The light comes from above, beside the camera.
    const double side = std::atan2(sight_.y, sight_.x) + 2.4;
    light_ = {0.6 * std::cos(side), 0.6 * std::sin(side), 0.8};
  }

  ViewOverlay make() {
    const std::vector<Ring> rings = ringsOf(body_);
    for (std::size_t i = 0; i + 1 < rings.size(); ++i) {
      for (int segment = 0; segment < kSegments; ++segment) addPatch(rings[i], rings[i + 1], segment);
    }
    ViewOverlay overlay;
    overlay.throughWalls = true;
    for (std::size_t i = 0; i < shades_.size(); ++i) {
      if (shades_[i].empty()) continue;
      const double light = kDarkest + (1 - kDarkest) * static_cast<double>(i) / (kShades - 1);
      const QColor colour = toColour(kSkyBlue);
      overlay.surfaces.push_back({std::move(shades_[i]), QColor::fromRgbF(static_cast<float>(colour.redF() * light),
                                                                          static_cast<float>(colour.greenF() * light),
                                                                          static_cast<float>(colour.blueF() * light))});
    }
    overlay.surfaces.push_back({std::move(eyes_), QColor(25, 30, 40)});
    return overlay;
  }

 private:
  [[nodiscard]] Vec3 placeOn(const Ring& ring, int segment) const {
    const double angle = turn_ + 2 * M_PI * segment / kSegments;
    return {feet_.x + ring.radius * std::cos(angle), feet_.y + ring.radius * std::sin(angle), feet_.z + ring.height};
  }

  // Four corners between two rings, where the camera sees them: of a convex body, nothing hides anything else then.
  void addPatch(const Ring& lower, const Ring& upper, int segment) {
    const double around = 2 * M_PI * (segment + 0.5) / kSegments;
    const double out = (lower.outwards + upper.outwards) / 2;
    const Vec3 normal{out * std::cos(turn_ + around), out * std::sin(turn_ + around),
                      (lower.upwards + upper.upwards) / 2};
    const std::array corners{placeOn(lower, segment), placeOn(lower, segment + 1), placeOn(upper, segment + 1),
                             placeOn(upper, segment)};
    const Vec3 sight = camera_.orthographic ? sight_ : corners[0] - camera_.position;
    if (dot(sight, normal) >= 0) return;
    const double height = (lower.height + upper.height) / 2;
    const double aside = std::min(around, 2 * M_PI - around);
    const bool isEye = std::fabs(height - body_.eyeHeight()) < 0.04 * body_.height && aside > 0.15 && aside < 0.75;
    const double light = std::clamp(dot(normal, light_) / std::max(length(normal), 1e-9), -1.0, 1.0);
    auto& triangles = isEye ? eyes_ : shades_[static_cast<std::size_t>((light + 1) / 2 * (kShades - 1) + 0.5)];
    triangles.push_back({corners[0], corners[1], corners[2]});
    triangles.push_back({corners[0], corners[2], corners[3]});
  }

  const WalkBody body_;
  const Vec3 feet_;
  const double turn_;
  const CameraPose camera_;
  const Vec3 sight_;
  Vec3 light_;
  std::array<std::vector<std::array<Vec3, 3>>, kShades> shades_;
  std::vector<std::array<Vec3, 3>> eyes_;
};

}  // namespace

WalkBody walkBodyFor(double height, double radius) {
  const double wanted = radius > 0 ? radius : kPersonRadius * height;
  return {height, std::min(wanted, height / 2)};
}

ViewOverlay drawFigure(const WalkBody& body, const Vec3& feet, double turn, const CameraPose& camera) {
  return FigureMaker(body, feet, turn, camera).make();
}

}  // namespace footfall::ui
