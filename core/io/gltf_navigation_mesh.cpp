// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/gltf_navigation_mesh.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <utility>

#include "core/base/disjoint_sets.hpp"
#include "core/io/base64.hpp"
#include "core/io/input_file.hpp"

namespace footfall::detail {
namespace {

using Json = nlohmann::json;
using Place = std::array<float, 3>;
using Edge = std::array<std::uint32_t, 2>;

constexpr std::size_t kRangePerPoll = 4096;
constexpr std::string_view kDataUri = "data:application/octet-stream;base64,";

std::uint32_t wordAt(std::string_view bytes, std::size_t at) {
  if (bytes.size() < 4 || at > bytes.size() - 4) throw std::out_of_range("beyond the end");
  std::uint32_t word = 0;
  for (std::size_t k = 4; k-- > 0;) word = word << 8 | static_cast<unsigned char>(bytes[at + k]);
  return word;
}

/// The JSON and the numbers of either kind of file.
struct GltfParts {
  Json json;
  std::string numbers;
};

GltfParts partsOf(std::string_view text) {
  GltfParts parts;
  if (!text.starts_with("glTF")) {
    parts.json = Json::parse(text);
    if (!parts.json.contains("buffers")) return parts;
    const auto uri = parts.json.at("buffers").at(0).at("uri").get<std::string>();
    if (!uri.starts_with(kDataUri)) throw std::out_of_range("numbers elsewhere");
    parts.numbers = fromBase64(std::string_view(uri).substr(kDataUri.size()));
    return parts;
  }
  const std::size_t size = wordAt(text, 12);
  if (size > text.size() - 20) throw std::out_of_range("cut off");
  parts.json = Json::parse(text.substr(20, size));
  if (20 + size == text.size()) return parts;
  const std::size_t numbers = wordAt(text, 20 + size);
  if (text.size() < 28 + size || numbers > text.size() - 28 - size) throw std::out_of_range("cut off");
  parts.numbers = text.substr(28 + size, numbers);
  return parts;
}

/// A mesh of the file: places, and triangles or lines as a list of their corners.
struct GltfMesh {
  std::string name;
  Json extras;
  std::vector<Place> places;
  std::vector<std::uint32_t> corners;
};

class MeshReader {
 public:
  MeshReader(const GltfParts& parts, Poll poll) : json_(parts.json), numbers_(parts.numbers), poll_(poll) {}

  [[nodiscard]] std::vector<GltfMesh> all() const {
    std::vector<GltfMesh> meshes;
    if (!json_.contains("meshes")) return meshes;
    for (const Json& node : json_.at("nodes")) {
      poll_();
      if (!node.contains("mesh")) continue;
      const Json& mesh = json_.at("meshes").at(node.at("mesh").get<std::size_t>());
      const Json& primitive = mesh.at("primitives").at(0);
      GltfMesh read{mesh.at("name"), node.value("extras", Json::object()), {}, {}};
      const std::vector<std::uint32_t> words = words_(primitive.at("attributes").at("POSITION"), 3);
      for (std::size_t i = 0; i + 2 < words.size(); i += 3) {
        Place place;
        for (std::size_t k = 0; k < 3; ++k) place[k] = std::bit_cast<float>(words[i + k]) + 0.0F;  // avoids -0
        for (const float x : place)
          if (!std::isfinite(x)) throw std::out_of_range("no number");
        read.places.push_back(place);
      }
      read.corners = words_(primitive.at("indices"), 1);
      for (const std::uint32_t corner : read.corners)
        if (corner >= read.places.size()) throw std::out_of_range("no vertex");
      meshes.push_back(std::move(read));
    }
    return meshes;
  }

 private:
  [[nodiscard]] std::vector<std::uint32_t> words_(const Json& number, std::size_t width) const {
    const Json& accessor = json_.at("accessors").at(number.get<std::size_t>());
    const Json& view = json_.at("bufferViews").at(accessor.at("bufferView").get<std::size_t>());
    const auto start = view.at("byteOffset").get<std::size_t>(), count = accessor.at("count").get<std::size_t>();
    if (start > numbers_.size() || count > (numbers_.size() - start) / (4 * width)) throw std::out_of_range("cut off");
    std::vector<std::uint32_t> words(count * width);
    for (std::size_t i = 0; i < words.size(); ++i) words[i] = wordAt(numbers_, start + 4 * i);
    return words;
  }

  const Json& json_;
  const std::string& numbers_;
  Poll poll_;
};

class MeshMaker {
 public:
  explicit MeshMaker(Poll poll) : poll_(poll) {}

  GltfNavigationMesh make(const std::vector<GltfMesh>& meshes) {
    for (const GltfMesh& mesh : meshes)
      if (mesh.name.starts_with("layer_") || mesh.name.starts_with("walkable")) addLayer(mesh);
    const std::size_t layered = result_.mesh.layers.size();
    if (layered != 0 && layered != result_.mesh.triangles.size()) throw std::out_of_range("triangles without a layer");
    for (const GltfMesh& mesh : meshes) {
      if (mesh.name == "connections") joinLayers(mesh);
      if (mesh.name == "drops") addDrops(mesh);
    }
    weld();
    for (const GltfMesh& mesh : meshes) {
      if (mesh.name == "obstacle_edges") addObstacleEdges(mesh);
      if (mesh.name == "steps") addLinks(mesh, true, result_.steps, result_.statedSteps);
      if (mesh.name == "gaps") addLinks(mesh, false, result_.gaps, result_.statedGaps);
    }
    return std::move(result_);
  }

 private:
  using Ends = std::array<Place, 2>;

  void addLayer(const GltfMesh& mesh) {
    const auto first = static_cast<std::uint32_t>(places_.size());
    const auto layer = static_cast<std::uint32_t>(result_.layerNames.size());
    const bool isLayer = mesh.name.starts_with("layer_");
    result_.layerNames.push_back(isLayer ? mesh.name : "walkable");
    if (isLayer) result_.mesh.layerCount = layer + 1;
    places_.insert(places_.end(), mesh.places.begin(), mesh.places.end());
    layerOf_.resize(places_.size(), layer);
    for (std::size_t i = 0; i + 2 < mesh.corners.size(); i += 3) {
      result_.mesh.triangles.push_back(
          {first + mesh.corners[i], first + mesh.corners[i + 1], first + mesh.corners[i + 2]});
      if (isLayer) result_.mesh.layers.push_back(layer);
    }
    for (std::size_t t = result_.mesh.triangles.size() - mesh.corners.size() / 3; t < result_.mesh.triangles.size();
         ++t) {
      if (t % kRangePerPoll == 0) poll_();
      for (std::size_t k = 0; k < 3; ++k) {
        const Edge edge{result_.mesh.triangles[t][k], result_.mesh.triangles[t][(k + 1) % 3]};
        edges_[{places_[edge[0]], places_[edge[1]]}].push_back(edge);
      }
    }
  }

  /// Joins the vertices of different layers that a connection shares.
  void joinLayers(const GltfMesh& mesh) {
    for (std::size_t i = 0; i + 1 < mesh.corners.size(); i += 2) {
      if (i % kRangePerPoll == 0) poll_();
      const Ends ends{mesh.places[mesh.corners[i]], mesh.places[mesh.corners[i + 1]]};
      std::optional<Edge> kept;
      for (const Edge& edge : edgesAt(ends)) {
        if (kept) break;
        for (const Edge& other : edgesAt({ends[1], ends[0]})) {
          if (kept || layerOf_[edge[0]] == layerOf_[other[0]]) continue;
          joined_.push_back({edge[0], other[1]});
          joined_.push_back({edge[1], other[0]});
          kept = edge;
        }
      }
      if (kept) result_.mesh.connections.push_back(*kept);
    }
  }

  void addDrops(const GltfMesh& mesh) {
    for (std::size_t i = 0; i + 1 < mesh.corners.size(); i += 2)
      result_.drops.push_back({wide(mesh.places[mesh.corners[i]]), wide(mesh.places[mesh.corners[i + 1]])});
  }

  void weld() {
    DisjointSets sets(static_cast<Index>(places_.size()));
    for (const Edge& pair : joined_) sets.unite(static_cast<Index>(pair[0]), static_cast<Index>(pair[1]));
    std::vector<std::uint32_t> numberOf(places_.size());
    std::map<Index, std::uint32_t> numberOfSet;
    for (std::size_t v = 0; v < places_.size(); ++v) {
      if (v % kRangePerPoll == 0) poll_();
      const auto [at, isNew] = numberOfSet.try_emplace(sets.find(static_cast<Index>(v)),
                                                       static_cast<std::uint32_t>(result_.mesh.vertices.size()));
      if (isNew) result_.mesh.vertices.push_back(wide(places_[v]));
      numberOf[v] = at->second;
    }
    for (Triangle& triangle : result_.mesh.triangles)
      for (std::uint32_t& v : triangle) v = numberOf[v];
    for (auto& connection : result_.mesh.connections)
      for (std::uint32_t& v : connection) v = numberOf[v];
    for (auto& [ends, edges] : edges_)
      for (Edge& edge : edges)
        for (std::uint32_t& v : edge) v = numberOf[v];
  }

  // Both sides of an obstacle edge are listed, each with its own vertices.
  void addObstacleEdges(const GltfMesh& mesh) {
    std::set<Edge> taken;
    for (std::size_t i = 0; i + 1 < mesh.corners.size(); i += 2) {
      if (i % kRangePerPoll == 0) poll_();
      const Ends ends{mesh.places[mesh.corners[i]], mesh.places[mesh.corners[i + 1]]};
      bool isFound = false;
      for (const Ends& way : {ends, Ends{ends[1], ends[0]}})
        for (const Edge& edge : edgesAt(way)) {
          if (isFound || !taken.insert(edge).second) continue;
          isFound = true;
          result_.mesh.obstacleEdges.push_back(way == ends ? edge : Edge{edge[1], edge[0]});
        }
      if (!isFound) throw std::out_of_range("no such edge");
    }
  }

  void addLinks(const GltfMesh& mesh, bool areSteps, std::vector<GltfNavigationMesh::LinkEdges>& links,
                std::size_t& stated) {
    const Json& faces = mesh.extras.at("faces");
    stated = faces.size();
    std::size_t at = 0;
    for (const Json& count : faces) {
      poll_();
      const auto own = count.get<std::size_t>();
      if (own < 1 || own > 2 || at + 3 * own > mesh.corners.size()) throw std::out_of_range("no such face");
      const auto place = [&](std::size_t corner) { return mesh.places[mesh.corners[at + corner]]; };
      const Place a = place(0), b = place(1), c = place(2);
      Ends across{c, own == 2 ? place(5) : a};
      if (own == 1) {  // the borders meet at b, or at a
        const bool isOverFirst = a[0] == c[0] && a[2] == c[2];
        if (areSteps ? isOverFirst : edgesAt(across).empty()) across = {b, c};
      }
      at += 3 * own;
      const std::vector<Edge>&from = edgesAt({a, b}), &to = edgesAt(across);
      if (!from.empty() && !to.empty()) links.push_back({from[0][0], from[0][1], to[0][0], to[0][1]});
    }
  }

  [[nodiscard]] const std::vector<Edge>& edgesAt(const Ends& ends) const {
    static const std::vector<Edge> kNone;
    const auto found = edges_.find(ends);
    return found == edges_.end() ? kNone : found->second;
  }
  static Vec3 wide(const Place& p) { return {p[0], p[1], p[2]}; }

  Poll poll_;
  GltfNavigationMesh result_;
  std::vector<Place> places_;
  std::vector<std::uint32_t> layerOf_;       ///< by place
  std::map<Ends, std::vector<Edge>> edges_;  ///< directed edges of triangles
  std::vector<Edge> joined_;
};

}  // namespace

std::optional<GltfNavigationMesh> readGltfNavigationMesh(const std::string& path, std::string_view text, Poll poll) {
  try {
    if (text.find("\"generator\"") == std::string_view::npos) return std::nullopt;
    const GltfParts parts = partsOf(text);
    if (!parts.json.at("asset").value("generator", "").starts_with("Footfall ")) return std::nullopt;
    return MeshMaker(poll).make(MeshReader(parts, poll).all());
  } catch (const Json::exception&) {
  } catch (const std::out_of_range&) {
  }
  failInput(path, 0, FOOTFALL_TEXT("its glTF is damaged"),
            FOOTFALL_TEXT("it was cut off or changed by hand: export it again"));
}

}  // namespace footfall::detail
