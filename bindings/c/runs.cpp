// Pipelines, runs, their meshes and exports.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "handles.hpp"

using namespace footfall;
using namespace footfall::c;

namespace {

constexpr const char* kTextName = "pipeline";  // source in messages: "pipeline:LINE:COLUMN: ..."

Agent agentOf(const footfall_agent* agent) {
  return agent == nullptr ? Agent{} : Agent{agent->max_slope, agent->height, agent->minimum_area, agent->step,
                                            agent->gap,       agent->radius, agent->drop};
}

footfall_result* run(const footfall_environment& environment, Pipeline pipeline, footfall_cache* cache,
                     footfall_context* context, int threads) {
  RunContext ownContext;
  auto result = std::make_unique<footfall_result>();
  result->environment = environment.environment;
  result->pipeline = std::move(pipeline);
  result->run = runPipeline(result->environment, result->pipeline, context == nullptr ? ownContext : context->context,
                            cacheOf(cache), threads);
  return result.release();
}

}  // namespace

footfall_agent footfall_default_agent(void) {
  const Agent agent;
  return {agent.maxSlope, agent.height, agent.minimumArea, agent.step, agent.gap, agent.radius, agent.drop};
}

footfall_status footfall_pipeline_for(const footfall_environment* environment, const footfall_agent* agent,
                                      char** pipeline) {
  return guarded(__func__, [&] {
    given(environment, "environment");
    given(pipeline, "pipeline");
    *pipeline = copyOf(formatPipeline(pipelineFor(*environment->environment, agentOf(agent))));
  });
}

footfall_status footfall_check_pipeline(const char* pipeline) {
  return guarded(__func__, [&] { (void)parsePipeline(&given(pipeline, "pipeline"), kTextName); });
}

footfall_status footfall_make_cache(size_t bytes, footfall_cache** cache) {
  return guarded(__func__, [&] {
    given(cache, "cache");
    constexpr std::size_t kStates = 64;
    *cache = new footfall_cache{ResultCache(kStates, bytes)};
  });
}

void footfall_free_cache(footfall_cache* cache) { delete cache; }

footfall_status footfall_walkable_area(const footfall_environment* environment, const footfall_agent* agent,
                                       footfall_context* context, int threads, footfall_result** result) {
  return guarded(__func__, [&] {
    given(environment, "environment");
    given(result, "result");
    *result = run(*environment, pipelineFor(*environment->environment, agentOf(agent)), nullptr, context, threads);
  });
}

footfall_status footfall_run(const footfall_environment* environment, const char* pipeline, footfall_cache* cache,
                             footfall_context* context, int threads, footfall_result** result) {
  return guarded(__func__, [&] {
    given(environment, "environment");
    given(result, "result");
    Pipeline parsed =
        pipeline == nullptr ? defaultPipeline(*environment->environment) : parsePipeline(pipeline, kTextName);
    *result = run(*environment, std::move(parsed), cache, context, threads);
  });
}

footfall_status footfall_run_agents(const footfall_environment* environment, const footfall_agent* agents, size_t count,
                                    footfall_cache* cache, footfall_context* context, int threads,
                                    footfall_result** results) {
  return guarded(__func__, [&] {
    const std::shared_ptr<const Environment>& level = given(environment, "environment").environment;
    given(agents, "agents");
    given(results, "results");
    std::vector<Agent> list;
    for (std::size_t i = 0; i < count; ++i) list.push_back(agentOf(agents + i));
    RunContext ownContext;
    std::vector<std::unique_ptr<footfall_result>> made;
    AgentRunEvents events;
    events.finished = [&](std::size_t /*agent*/, AgentRun run) {
      made.push_back(
          std::unique_ptr<footfall_result>(new footfall_result{level, std::move(run.pipeline), std::move(run.result)}));
    };
    runAgents(level, list, context == nullptr ? ownContext : context->context, events, cacheOf(cache), threads);
    for (std::size_t i = 0; i < count; ++i) results[i] = made[i].release();
  });
}

void footfall_free_result(footfall_result* result) { delete result; }

size_t footfall_result_computed_steps(const footfall_result* result) {
  return result == nullptr ? 0 : computedSteps(result->run);
}

footfall_points footfall_result_vertices(const footfall_result* result) {
  return result == nullptr ? footfall_points{} : spanOf(result->mesh().vertices);
}

footfall_triangles footfall_result_triangles(const footfall_result* result) {
  return result == nullptr ? footfall_triangles{} : spanOf(result->mesh().triangles);
}

footfall_numbers footfall_result_layers(const footfall_result* result) {
  return result == nullptr ? footfall_numbers{} : spanOf(result->mesh().layers);
}

uint32_t footfall_result_layer_count(const footfall_result* result) {
  return result == nullptr ? 0 : result->mesh().layerCount;
}

footfall_numbers footfall_result_sources(const footfall_result* result) {
  return result == nullptr ? footfall_numbers{} : spanOf(result->mesh().sourceTriangles);
}

footfall_edges footfall_result_obstacle_edges(const footfall_result* result) {
  return result == nullptr ? footfall_edges{} : spanOf(result->mesh().obstacleEdges);
}

footfall_edges footfall_result_connections(const footfall_result* result) {
  return result == nullptr ? footfall_edges{} : spanOf(result->mesh().connections);
}

footfall_links footfall_result_links(const footfall_result* result) {
  static_assert(sizeof(StepLink) == sizeof(footfall_link) && offsetof(StepLink, to) == offsetof(footfall_link, to) &&
                offsetof(StepLink, fromTriangle) == offsetof(footfall_link, from_triangle) &&
                offsetof(StepLink, height) == offsetof(footfall_link, height) &&
                offsetof(StepLink, width) == offsetof(footfall_link, width) &&
                offsetof(StepLink, kind) == offsetof(footfall_link, kind));
  if (result == nullptr) return {};
  const std::vector<StepLink>& links = result->mesh().links;
  return {reinterpret_cast<const footfall_link*>(links.data()), links.size()};
}

footfall_drops footfall_result_drops(const footfall_result* result) {
  static_assert(sizeof(DropLink) == sizeof(footfall_drop) &&
                offsetof(DropLink, fromTriangle) == offsetof(footfall_drop, from_triangle) &&
                offsetof(DropLink, toTriangle) == offsetof(footfall_drop, to_triangle) &&
                offsetof(DropLink, start) == offsetof(footfall_drop, start) &&
                offsetof(DropLink, landing) == offsetof(footfall_drop, landing) &&
                offsetof(DropLink, depth) == offsetof(footfall_drop, depth) &&
                offsetof(DropLink, width) == offsetof(footfall_drop, width));
  if (result == nullptr) return {};
  const std::vector<DropLink>& drops = result->mesh().drops;
  return {reinterpret_cast<const footfall_drop*>(drops.data()), drops.size()};
}

double footfall_result_area(const footfall_result* result) { return result == nullptr ? 0 : result->run.summary.area; }

footfall_status footfall_result_statistics(const footfall_result* result, char** json) {
  return guarded(__func__, [&] {
    given(result, "result");
    given(json, "json");
    *json = copyOf(formatStatistics(*result->environment, result->run));
  });
}

footfall_status footfall_save(const footfall_result* result, const char* path, const footfall_export_options* options) {
  return guarded(__func__, [&] {
    given(result, "result");
    given(path, "path");
    ExportOptions exported;
    if (options != nullptr) {
      exported.layers = options->without_layers == 0;
      exported.connections = options->without_connections == 0;
      exported.obstacleEdges = options->without_obstacle_edges == 0;
      exported.steps = options->without_steps == 0;
      exported.drops = options->without_drops == 0;
      exported.up = upAxisOf(options->up);
      if (options->scale != 0) exported.scale = options->scale;
      if (options->godot != 0) exported.godot = options->godot;
      exported.navmeshNode = options->navmesh_node != 0;
      if (options->part != 0) exported.part = options->part - 1;
      if (options->coordinate_system != nullptr) exported.coordinateSystem = options->coordinate_system;
    }
    save(result->mesh(), path, exported, makeExportHeader(result->pipeline));
  });
}
