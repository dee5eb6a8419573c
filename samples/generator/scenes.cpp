// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes.hpp"

#include <charconv>
#include <cmath>
#include <limits>
#include <ostream>
#include <string>

#include "city.hpp"
#include "props.hpp"
#include "shapes.hpp"

namespace footfall::samples {
namespace {

constexpr float kUnit = 1.0F / kUnitsPerMetre;
constexpr int kBlock = 72;  // metres between blocks of the city

/// The transform of an object: a turn about Z, a scale and a translation in metres.
struct Placement {
  float cosine = 1, sine = 0, x = 0, y = 0, z = 0;
};

Placement placement(int angle, float scale, float x, float y, float z) {
  const Direction d = direction(angle);
  const auto part = [&](std::int64_t value) {
    return static_cast<float>(static_cast<double>(value) * 0x1p-30) * scale;
  };
  return {part(d.cos), part(d.sin), x, y, z};
}

/// An object in the frame of another one: the product of both, rounded to floats, as scene graphs compute it.
/// Placements that are made smaller are not to be used as the outer one.
Placement operator*(const Placement& outer, const Placement& inner) {
  return {outer.cosine * inner.cosine - outer.sine * inner.sine, outer.sine * inner.cosine + outer.cosine * inner.sine,
          outer.cosine * inner.x - outer.sine * inner.y + outer.x,
          outer.sine * inner.x + outer.cosine * inner.y + outer.y, outer.z + inner.z};
}

/// Writes objects until there are enough triangles.
class Scene {
 public:
  Scene(std::ostream& out, std::string_view description, std::uint64_t triangles) : out_(out), wanted_(triangles) {
    out_ << Mesh::objHead(description);
  }

  [[nodiscard]] bool isFull() const { return size_.triangles >= wanted_; }
  [[nodiscard]] const SceneSize& size() const { return size_; }

  /// `height` scales upwards. With `noise`, each coordinate is moved by up to so many units in the last place.
  void add(const Mesh& mesh, const Placement& place, float height, Random* noise = nullptr) {
    std::string text;
    for (std::size_t v = 0; v < mesh.vertexCount(); ++v) {
      const Point p = mesh.at(static_cast<int>(v));
      const float x = static_cast<float>(p.x) * kUnit, y = static_cast<float>(p.y) * kUnit;
      std::array<float, 3> placed{place.cosine * x - place.sine * y + place.x,
                                  static_cast<float>(p.z) * kUnit * height + place.z,
                                  -(place.sine * x + place.cosine * y + place.y)};
      text += 'v';
      for (float& c : placed) {
        for (int i = noise != nullptr ? noise->between(-2, 2) : 0; i != 0; i += i < 0 ? 1 : -1)
          c = std::nextafter(c, i < 0 ? -kMost : kMost);
        append(text, c);
      }
      text += '\n';
    }
    for (std::size_t t = 0; t < mesh.triangleCount(); ++t) {
      text += 'f';
      for (const int corner : mesh.corners(t))
        text.append(" ").append(std::to_string(size_.vertices + static_cast<std::uint64_t>(corner) + 1));
      text += '\n';
    }
    out_ << text;
    size_.vertices += mesh.vertexCount();
    size_.triangles += mesh.triangleCount();
  }

 private:
  static constexpr float kMost = std::numeric_limits<float>::max();

  // All digits of the double that the float is.
  static void append(std::string& text, float value) {
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), static_cast<double>(value)).ptr;
    text.append(" ").append(digits.data(), end);
  }

  std::ostream& out_;
  std::uint64_t wanted_;
  SceneSize size_;
};

/// Calls add(column, row) square shell by square shell until the scene is full.
template <class Add>
void fill(const Scene& scene, const Add& add) {
  for (int shell = 0; !scene.isFull(); ++shell) {
    for (int i = 0; i <= shell && !scene.isFull(); ++i) add(shell, i);
    for (int i = 0; i < shell && !scene.isFull(); ++i) add(i, shell);
  }
}

template <class Make>
Mesh meshOf(const Make& make) {
  Mesh mesh;
  make(mesh);
  return mesh;
}

Mesh floorOf(int side) {
  return meshOf([&](Mesh& mesh) { box(mesh, {0, 0, -0.25_m}, {side, side, 0}); });
}

// Four rows of keys in an eighth of the size: 15 mm each, 19 mm apart.
Mesh keyboard() {
  return meshOf([](Mesh& mesh) {
    constexpr int kKey = 0.125_m, kPitch = 0.15625_m;
    box(mesh, {-1.25_m, -0.5_m, 0}, {1.25_m, 0.5_m, 0.0625_m});
    for (int row = 0; row < 4; ++row)
      for (int key = 0; key < 14; ++key) {
        const Point lower{-1.125_m + key * kPitch, -0.375_m + row * kPitch, 0.0625_m};
        box(mesh, lower, lower + Point{kKey, kKey, 0.0625_m});
      }
  });
}

Mesh cup() {
  return meshOf([](Mesh& mesh) { cylinder(mesh, {0, 0, 0}, 0.25_m, 0.5_m, 12); });
}

Mesh screen() {
  return meshOf([](Mesh& mesh) {
    box(mesh, {-0.125_m, -0.0625_m, 0}, {0.125_m, 0.0625_m, 0.015625_m});
    box(mesh, {-0.03125_m, -0.015625_m, 0.015625_m}, {0.03125_m, 0.015625_m, 0.25_m});
    box(mesh, {-0.3125_m, -0.015625_m, 0.125_m}, {0.3125_m, 0.015625_m, 0.5_m});
  });
}

Mesh books(Random& random, int length) {
  return meshOf([&](Mesh& mesh) {
    for (int x = 0; x < length;) {
      const int thickness = random.between(1, 4), depth = random.between(0.125_m, 0.25_m);
      box(mesh, {x, 0, 0}, {x + thickness, depth, random.between(0.1875_m, 0.3125_m)});
      x += thickness + (random.chance(20) ? 1 : 0);
    }
  });
}

// A place of work of 2 m by 2 m about the origin.
void addDesk(Scene& scene, const Placement& place, Random& random) {
  const auto at = [&](int angle, float scale, float x, float y, float z) {
    return place * placement(angle, scale, x, y, z);
  };
  const auto little = [&] { return random.between(-200, 200); };
  constexpr float kTop = 0.75F;
  scene.add(meshOf([](Mesh& mesh) { table(mesh, 1.5_m, 0.75_m); }), place, 1);
  scene.add(meshOf([](Mesh& mesh) { chair(mesh); }), at(little() + 2 * kQuarterTurn, 1, 0.1F, -0.8F, 0), 1);
  scene.add(screen(), at(little(), 1, -0.1F, 0.2F, kTop), 1);
  scene.add(keyboard(), at(little() / 4, 0.125F, 0, -0.15F, kTop), 0.125F);
  scene.add(cup(), at(little(), 0.1875F, 0.5F, 0.1F, kTop), 0.1875F);
  if (!random.chance(40)) return;
  scene.add(meshOf([](Mesh& mesh) { shelf(mesh, 1_m, 4); }), at(0, 1, 0, 1, 0), 1);
  scene.add(books(random, 0.875_m), at(0, 1, -0.45F, 0.9F, 1.0F), 1);
}

/// A leaf of 3 to 10 cm about the origin, tilted, seen from both sides.
void addLeaf(Mesh& mesh, Random& random, Point at) {
  const Direction d = direction(random.between(0, kTurn - 1));
  const int length = random.between(24, 80), width = length / 2, rise = random.between(-length / 3, length / 3);
  const Point along{scaled(length, d.cos), scaled(length, d.sin), rise};
  const Point across{scaled(-width, d.sin), scaled(width, d.cos), random.between(-width / 4, width / 4)};
  const int a = mesh.vertex(at - across), b = mesh.vertex(at + along), c = mesh.vertex(at + across),
            e = mesh.vertex(at - along);
  mesh.quad(e, a, b, c);
  mesh.quad(c, b, a, e);
}

// Coordinates are in twelfths of the size.
Mesh crown(Random& random, int leaves, int radius, int height) {
  return meshOf([&](Mesh& mesh) {
    for (int i = 0; i < leaves; ++i) {
      const Direction d = direction(random.between(0, kTurn - 1));
      const int distance = random.between(0, radius);
      addLeaf(mesh, random, {scaled(distance, d.cos), scaled(distance, d.sin), random.between(0, height)});
    }
  });
}

SceneSize writeBlocks(std::ostream& out, std::string_view description, std::uint64_t triangles, std::uint64_t seed,
                      bool isNoisy) {
  Random random(seed * 2 + 1);
  Scene scene(out, description, triangles);
  const Placement town = placement(random.between(100, kQuarterTurn - 100), 1, 12.3F, -45.6F, 0.1F);
  fill(scene, [&](int column, int row) {
    const auto x = static_cast<float>(column * kBlock), y = static_cast<float>(row * kBlock);
    // The blocks come in the place of the first one.
    Mesh tile = makeCityTile(column, row);
    const Placement back = placement(0, 1, -x, -y, 0),
                    there = placement(isNoisy ? 0 : random.between(-6, 6), 1, x, y, 0);
    if (isNoisy)
      scene.add(tile, placement(0, 1, 0, 0, 0), 1, &random);
    else
      scene.add(tile, town * (there * back), 1);
  });
  return scene.size();
}

}  // namespace

SceneSize writeTown(std::ostream& out, std::uint64_t triangles, std::uint64_t random) {
  return writeBlocks(out, kScenes[0].description, triangles, random, false);
}

SceneSize writeNoise(std::ostream& out, std::uint64_t triangles, std::uint64_t random) {
  return writeBlocks(out, kScenes[3].description, triangles, random, true);
}

SceneSize writeOffice(std::ostream& out, std::uint64_t triangles, std::uint64_t seed) {
  Random random(seed * 2 + 1);
  Scene scene(out, kScenes[1].description, triangles);
  const Placement office = placement(random.between(100, kQuarterTurn - 100), 1, 3.7F, 1.9F, 0);
  const Mesh floor = floorOf(4_m);
  fill(scene, [&](int column, int row) {
    const auto x = static_cast<float>(column * 4), y = static_cast<float>(row * 4);
    const Placement cell = office * placement(0, 1, x, y, 0);
    scene.add(floor, cell, 1);
    addDesk(scene, cell * placement(random.between(0, kTurn - 1), 1, 2, 2, 0), random);
  });
  return scene.size();
}

SceneSize writeFoliage(std::ostream& out, std::uint64_t triangles, std::uint64_t seed) {
  Random random(seed * 2 + 1);
  Scene scene(out, kScenes[2].description, triangles);
  constexpr float kSmall = 1.0F / 12;
  const Mesh ground = floorOf(6_m);
  const Mesh trunk = meshOf([](Mesh& mesh) { cylinder(mesh, {0, 0, 0}, 0.1875_m, 3_m, 8); });
  fill(scene, [&](int column, int row) {
    const auto x = static_cast<float>(column * 6), y = static_cast<float>(row * 6);
    scene.add(ground, placement(0, 1, x, y, 0), 1);
    const auto place = [&](float scale, float dx, float dy, float z) {
      return placement(random.between(0, kTurn - 1), scale, x + dx, y + dy, z);
    };
    scene.add(trunk, place(1, 2, 2, 0), 1);
    scene.add(crown(random, 300, 18_m, 24_m), place(kSmall, 2, 2, 2.5F), kSmall);
    for (const float at : {0.8F, 2.9F, 4.7F})
      scene.add(crown(random, 80, 6_m, 6_m), place(kSmall, 4.5F, at, 0.05F), kSmall);
  });
  return scene.size();
}

SceneSize writeRamps(std::ostream& out, std::uint64_t triangles, std::uint64_t seed) {
  Random random(seed * 2 + 1);
  Scene scene(out, kScenes[4].description, triangles);
  const Mesh floor = floorOf(16_m);
  fill(scene, [&](int column, int row) {
    const auto x = static_cast<float>(column * 16), y = static_cast<float>(row * 16);
    scene.add(floor, placement(0, 1, x, y, 0), 1);
    for (const float dx : {4.0F, 12.0F})
      for (const float dy : {4.0F, 12.0F}) {
        const int rise = random.between(1_m, 2_m);
        const Mesh tower = meshOf([&](Mesh& mesh) {
          box(mesh, {0, -1_m, 0}, {2_m, 1_m, rise});
          ramp(mesh, {-rise, -1_m, 0}, {0, 1_m, rise});
        });
        scene.add(tower, placement(random.between(0, kTurn - 1), 1, x + dx, y + dy, 0), 1);
      }
  });
  return scene.size();
}

SceneSize writeStands(std::ostream& out, std::uint64_t triangles, std::uint64_t seed) {
  Random random(seed * 2 + 1);
  Scene scene(out, kScenes[5].description, triangles);
  constexpr int kRows = 12, kSides = 64, kApart = 40;
  constexpr int kPitch = 8_m, kDepth = 0.75_m, kRise = 0.375_m;
  fill(scene, [&](int column, int row) {
    const int lean = random.chance(50) ? 0.015625_m : -0.015625_m;
    const Mesh bowl = meshOf([&](Mesh& mesh) {
      mesh.polygon(polygonRing({0, 0, 0}, kPitch, kSides));
      int inner = -1, radius = kPitch;
      const auto goOnTo = [&](int height) {
        const int outer = static_cast<int>(mesh.vertexCount());
        for (const Point& p : polygonRing({0, 0, height}, radius, kSides)) mesh.vertex(p);
        for (int i = 0; i < kSides && inner >= 0; ++i) {
          const int j = (i + 1) % kSides;
          mesh.quad(inner + i, outer + i, outer + j, inner + j);
        }
        inner = outer;
      };
      goOnTo(0);
      for (int i = 0; i < kRows; ++i) {
        radius += lean;
        goOnTo((i + 1) * kRise);
        radius += kDepth;
        goOnTo((i + 1) * kRise);
      }
    });
    const auto x = static_cast<float>(column * kApart), y = static_cast<float>(row * kApart);
    scene.add(bowl, placement(random.between(0, kTurn - 1), 1, x, y, 0), 1);
  });
  return scene.size();
}

}  // namespace footfall::samples
