// Makes a new generation: the whole environment with double coordinates again, so that constructions never nest
// (model, Generations).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/assembly/earlier_result.hpp"
#include "core/assembly/walkable_state.hpp"
#include "core/filters/apply_filter.hpp"
#include "core/filters/rounding/rounded_mesh.hpp"
#include "footfall/navigation_mesh.hpp"

namespace footfall::detail {

/// Walkable and rejected triangles of a state as one soup of doubles.
struct GenerationSoup {
  std::vector<Vec3> vertices;
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> inputTriangles;                ///< number in the environment of each triangle
  std::vector<std::array<std::uint32_t, 2>> obstacleEdges;  ///< pairs of vertices
  std::vector<char> walkable;                               ///< one flag per triangle
  RoundingCases cases;                                      ///< cases that rounding met among the walkable triangles
  /// The product of a state that has links; its triangles and vertices come first. Else null.
  std::shared_ptr<const NavigationMesh> product;
};

/// The part that a floor's cuts cover, in triangles that face up.
struct CoveredPart {
  std::vector<Vec3> places;
  std::vector<std::array<Index, 3>> triangles;
};
/// One entry per face of a state; null where no cut divides it, and for level ones that are obstacles as a whole.
using CoveredParts = std::vector<std::shared_ptr<const CoveredPart>>;

/// The findings of another state's soup, and those of this one.
struct CoveredRecall {
  const EarlierResult* earlier = nullptr;  ///< may be null
  const CoveredParts* before = nullptr;    ///< parts of the earlier state
  CoveredParts found;
};

/// Rounds the state's mesh (if it has one) and repairs it; where there are links, its floors are those of the product,
/// whose borders have their links. Everything that is not, or no longer, a floor is in the soup as an obstacle:
/// rejected triangles, covered parts of floors, and regions that AreaFilter removed.
GenerationSoup makeGenerationSoup(const StatePtr& state, RunContext& context, ExactFallbacks& fallbacks);

/// The same, with a product of the state as its floors: they come first, in the product's order.
/// `covered` (may be null) gives and receives what lies under floors' cuts.
GenerationSoup makeGenerationSoup(const WalkableState& state, const NavigationMesh& product, RunContext& context,
                                  ExactFallbacks& fallbacks, CoveredRecall* covered = nullptr);

/// The same without obstacles: the product alone, and the edges on which obstacles stand.
GenerationSoup makeSoupOfFloors(const WalkableState& state, const NavigationMesh& product);

/// The state that starts from a soup. Floors that are degenerate or do not face up any more are rejected. `faces` (may
/// be null) receives for each triangle of the soup its number. The mesh is related to `before`, that of an earlier run
/// (may be null).
StatePtr startGeneration(const WalkableState& earlier, const GenerationSoup& soup, RunContext& context,
                         std::vector<Index>* faces = nullptr,
                         const std::shared_ptr<const SourceMesh>& before = nullptr);

/// The same with its mesh, if the earlier one has one, and the links of the soup's product. Where `isMoved`, the soup's
/// vertices are no longer the product's: links stay that became neither wider nor higher, and only where nothing is in
/// the way.
StatePtr nextGeneration(const WalkableState& earlier, const GenerationSoup& soup, bool isMoved, RunContext& context,
                        ExactFallbacks& fallbacks);

/// True when the state has vertices that are not the environment's own.
bool hasConstructedVertices(const WalkableState& state);

}  // namespace footfall::detail
