// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/thesis_pipelines.hpp"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "core/base/number_text.hpp"
#include "footfall/errors.hpp"
#include "footfall/filter.hpp"
#include "footfall/filter_type.hpp"
#include "tests/bench/pipeline_measurement.hpp"

namespace footfall::bench {
using namespace detail;
namespace {

constexpr double kWeldMetres = 0.005;
constexpr double kThesisMinimum = 50;

double valueOf(const Pipeline& pipeline, std::string_view filter) {
  for (const PipelineStep& step : pipeline.steps)
    if (step.filter->name == filter) return step.values[0];
  throw std::logic_error("the pipeline has no " + std::string(filter));
}

class Listing {
 public:
  void add(std::string_view filter, std::vector<double> values = {}) {
    const FilterDescriptor* descriptor = findFilter(filter);
    if (descriptor == nullptr) throw std::logic_error("no filter " + std::string(filter));
    PipelineStep step = defaultStep(*descriptor, 1);
    std::ranges::copy(values, step.values.begin());
    pipeline_.steps.push_back(std::move(step));
  }
  void add(const PipelineStep& step) { pipeline_.steps.push_back(step); }
  Pipeline take() { return std::move(pipeline_); }

 private:
  Pipeline pipeline_;
};

Pipeline thesisListing(const Pipeline& own, double metresPerUnit, const PipelineStep* strategyOfParallel) {
  const double weld = kWeldMetres / metresPerUnit;
  Listing listing;
  listing.add("DegeneracyFilter");
  listing.add("SlopeFilter", {valueOf(own, "SlopeFilter"), 0});
  listing.add("DuplicationFilter", {weld});
  if (strategyOfParallel != nullptr) {
    listing.add(*strategyOfParallel);
    listing.add("DegeneracyFilter");
  }
  listing.add("VerticalClearanceFilter", {valueOf(own, "VerticalClearanceFilter")});
  if (strategyOfParallel != nullptr) {
    listing.add("RoundingFilter");
    listing.add("Collapse");
  }
  listing.add("DegeneracyFilter");
  listing.add("DuplicationFilter", {weld});
  listing.add("AreaFilter", {valueOf(own, "AreaFilter")});
  if (strategyOfParallel != nullptr)
    listing.add("SimplificationFilter", {1, 0.000001});
  else
    listing.add("SimplificationFilter");
  listing.add("LayerSubdivisionFilter");
  return listing.take();
}

Pipeline withBlock(const Pipeline& filters, const PipelineStep& strategy) {
  Listing listing;
  for (const PipelineStep& step : filters.steps) {
    const bool inBlock = step.filter->type == FilterType::VerticalClearance;
    if (inBlock) listing.add(strategy);
    listing.add(step);
    if (inBlock) listing.add("Collapse");
  }
  return listing.take();
}

Pipeline ownFilters(const ThesisSubject& subject, const Environment& environment) {
  return subject.isSample() ? readPipelineFile(subject.pipelineFile) : pipelineFor(subject.subject, environment);
}

}  // namespace

std::vector<ThesisSubject> samplesWithPipelines() {
  std::vector<ThesisSubject> subjects;
  for (const Subject& sample : sampleSubjects()) {
    const std::string pipeline = std::filesystem::path(sample.path).replace_extension(".pipeline").string();
    subjects.push_back({sample, pipeline});
  }
  return subjects;
}

PipelineStep parseStrategy(const std::string& text) {
  const Pipeline pipeline = parsePipeline(text + "\nCollapse\n", "--strategy \"" + text + '"');
  if (pipeline.steps.size() != 2 || pipeline.steps[0].filter->kind != FilterKind::Strategy)
    throw InputError("--strategy \"" + text + "\": is not one strategy; give one such as \"GridStrategy 3 3\"");
  return pipeline.steps[0];
}

std::string describeStrategy(const std::string& text) {
  const PipelineStep step = parseStrategy(text);
  const std::string_view name = step.filter->name;
  const auto value = [&](std::size_t i) {
    std::string digits;
    appendNumber(digits, step.values[i]);
    return digits;
  };
  if (name == "GridStrategy") return "Grid " + value(0) + " x " + value(1);
  if (step.values.empty()) return std::string(name.substr(0, name.rfind("Strategy")));
  std::string described = name == "RecursiveStrategy"         ? "Recursive"
                          : name == "SortedRecursiveStrategy" ? "Sorted recursive"
                                                              : "Height-aware";
  described += ", depth " + value(1);
  if (step.values[0] != kThesisMinimum) described += ", min. " + value(0);
  return described;
}

Pipeline makeThesisPipeline(const ThesisSubject& subject, const Environment& environment, FilterList filters,
                            const std::string& strategy) {
  if (filters == FilterList::PrintedSequential || filters == FilterList::PrintedParallel) {
    const char* name = filters == FilterList::PrintedParallel ? "thesis_parallel" : "thesis_sequential";
    return readPipelineFile(std::string(FOOTFALL_SOURCE_DIR "/resources/pipelines/") + name + ".pipeline");
  }
  const Pipeline own = ownFilters(subject, environment);
  const double metresPerUnit = subject.subject.metresPerUnit();
  if (filters == FilterList::ThesisParallel) {
    const PipelineStep step = parseStrategy(strategy);
    return thesisListing(own, metresPerUnit, &step);
  }
  const Pipeline pipeline = filters == FilterList::ThesisSequential ? thesisListing(own, metresPerUnit, nullptr) : own;
  return strategy.empty() ? pipeline : withBlock(pipeline, parseStrategy(strategy));
}

}  // namespace footfall::bench
