// Any bytes as a pipeline file: a pipeline that is the same when it is written and read, or one line of error.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "footfall/filter.hpp"
#include "footfall/pipeline.hpp"
#include "footfall/report.hpp"
#include "tests/fuzz/fuzz_target.hpp"

using namespace footfall;
using namespace footfall::detail;
using namespace footfall::fuzz;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Pipeline pipeline;
  try {
    pipeline = parsePipeline(textOf(data, size), "fuzz.pipeline");
  } catch (const InputError& error) {
    requireGoodMessage(error.what(), "fuzz.pipeline:");
    return 0;
  }
  for (const PipelineStep& step : pipeline.steps) {
    require(step.filter != nullptr, "a step without a filter");
    require(step.filter->takes(step.values.size()), "not one value for each parameter");
    for (std::size_t i = 0; i < step.values.size(); ++i)
      require(checkValue(step.filter->parameterOf(i), step.values[i]).empty(), "a value out of range was accepted");
  }
  const std::string text = formatPipeline(pipeline);
  const Pipeline again = parsePipeline(text, "again.pipeline");
  require(again == pipeline, "the pipeline changes when it is written and read: " + text);
  require(formatPipeline(again) == text, "its text changes when it is written again: " + text);
  makeExportHeader(pipeline);
  return 0;
}
