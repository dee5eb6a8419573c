// The text form of pipelines: the thesis's files (5.4), with messages that name line and column.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <iterator>

#include "core/filters/descriptor_text.hpp"
#include "core/io/pipe_output.hpp"
#include "core/pipeline/block_structure.hpp"
#include "core/pipeline/pipeline_fragment.hpp"
#include "footfall/errors.hpp"
#include "footfall/filter.hpp"
#include "footfall/pipeline.hpp"

namespace footfall {
using namespace detail;
namespace {

constexpr std::string_view kBlanks = " \t\v\f";
constexpr std::string_view kSwitchedOff = "#off";

struct Token {
  std::string_view text;
  int column = 0;  // 1-based, in characters
};

int columnOf(std::string_view line, std::size_t offset) {
  int column = 1;
  for (const char c : line.substr(0, offset)) column += (static_cast<unsigned char>(c) & 0xC0) != 0x80;
  return column;
}

std::vector<Token> splitIntoTokens(std::string_view line, std::size_t from) {
  std::vector<Token> tokens;
  const std::size_t end = std::min(line.find('#', from), line.size());
  for (std::size_t at = line.find_first_not_of(kBlanks, from); at < end;) {
    const std::size_t stop = std::min(line.find_first_of(kBlanks, at), end);
    tokens.push_back({line.substr(at, stop - at), columnOf(line, at)});
    at = line.find_first_not_of(kBlanks, stop);
  }
  return tokens;
}

// The user's text, short and printable, whatever file was given as a pipeline.
std::string quote(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  std::string quoted = "\"";
  for (const char c : text.substr(0, kLongest)) {
    const bool printable = static_cast<unsigned char>(c) >= 0x20 && c != 0x7F;
    quoted += printable ? c : '?';
  }
  return quoted + (text.size() > kLongest ? "...\"" : "\"");
}

class Parser {
 public:
  explicit Parser(const std::string& source) : source_(source) {}

  void parseLine(std::string_view line, int number) {
    line_ = number;
    std::vector<Token> tokens = splitIntoTokens(line, 0);
    bool enabled = true;
    if (tokens.empty()) {
      tokens = tokensOfDisabledStep(line);
      enabled = false;
    }
    if (tokens.empty()) return;

    const FilterDescriptor* filter = findFilter(tokens[0].text);
    if (filter == nullptr) {
      fail(tokens[0].column,
           Text(FOOTFALL_TEXT("unknown filter %1; did you mean %2? (`footfall filters` lists them all)"),
                quote(tokens[0].text), nearestFilterName(tokens[0].text)));
    }
    PipelineStep step{filter, {}, enabled, number};
    parseValues(step, tokens, columnOf(line, line.find_last_not_of(kBlanks) + 1));
    pipeline_.steps.push_back(std::move(step));
    columns_.push_back(tokens[0].column);
  }

  Pipeline finishFragment() { return std::move(pipeline_); }

  Pipeline finish() {
    if (const auto error = findStructureError(pipeline_)) {
      line_ = pipeline_.steps[error->step].line;
      fail(columns_[error->step], error->message);
    }
    return std::move(pipeline_);
  }

 private:
  [[noreturn]] void fail(int column, const Text& message) const {
    throw InputError(Pattern{"%1:%2:%3: %4"}, source_, line_, column, message);
  }

  // `#off` before a filter's name is a step that is switched off; before anything else it is an ordinary comment.
  static std::vector<Token> tokensOfDisabledStep(std::string_view line) {
    const std::size_t at = line.find_first_not_of(kBlanks);
    if (at == line.npos || !line.substr(at).starts_with(kSwitchedOff)) return {};
    const std::size_t rest = at + kSwitchedOff.size();
    if (rest >= line.size() || kBlanks.find(line[rest]) == kBlanks.npos) return {};
    std::vector<Token> tokens = splitIntoTokens(line, rest);
    if (!tokens.empty() && findFilter(tokens[0].text) == nullptr) tokens.clear();
    return tokens;
  }

  void parseValues(PipelineStep& step, const std::vector<Token>& tokens, int columnBehind) const {
    const std::vector<ParameterDescriptor>& parameters = step.filter->parameters;
    const std::string_view name = tokens[0].text;
    const auto failMissing = [&](const ParameterDescriptor& parameter) {
      fail(columnBehind, Text(FOOTFALL_TEXT("%1 needs a value for %2; write for example \"%3\""), name, parameter.name,
                              formatStep(defaultStep(*step.filter, 1))));
    };
    const std::size_t given = tokens.size() - 1, repeats = step.filter->repeats, once = parameters.size() - repeats;
    if (repeats > 0 && given > once && !step.filter->takes(given)) {
      fail(tokens[1 + given - (given - once) % repeats].column,
           Text(FOOTFALL_TEXT("%1 takes \"%2\"; values given: %3; give a multiple of %4"), name,
                describeUsage(*step.filter), given, repeats));
    }
    if (repeats == 0 && given > once) {
      const Token& extra = tokens[once + 1];
      if (parameters.empty())
        fail(extra.column, Text(FOOTFALL_TEXT("%1 takes no parameters; remove %2"), name, quote(extra.text)));
      fail(extra.column, Text(FOOTFALL_TEXT("%1 takes only \"%2\"; remove %3"), name, describeUsage(*step.filter),
                              quote(extra.text)));
    }
    for (std::size_t i = 0; i < std::max(once, given); ++i) {
      if (i < given) {
        step.values.push_back(parseValue(step.filter->parameterOf(i), tokens[i + 1]));
        step.columns.push_back(tokens[i + 1].column);
      } else if (parameters[i].optional) {
        const int follows = parameters[i].follows;
        step.values.push_back(follows < 0 ? parameters[i].defaultValue : step.values[follows]);
      } else {
        failMissing(parameters[i]);
      }
    }
  }

  double parseValue(const ParameterDescriptor& parameter, const Token& token) const {
    const auto notValue = [&]() {
      fail(token.column, Text(FOOTFALL_TEXT("%1 is no value for %2; give %3"), quote(token.text), parameter.name,
                              describeRange(parameter)));
    };
    if (parameter.type == ParameterType::Boolean) {
      if (token.text != "true" && token.text != "false") notValue();
      return token.text == "true" ? 1 : 0;
    }
    double value = 0;
    const char* end = token.text.data() + token.text.size();
    const auto read = std::from_chars(token.text.data(), end, value);
    if (read.ec != std::errc() || read.ptr != end) notValue();
    const Text wrong = checkValue(parameter, value);
    if (!wrong.empty()) fail(token.column, wrong);
    return value + 0.0;  // -0 becomes 0: equal values are to be equal in every way
  }

  const std::string& source_;
  int line_ = 0;
  Pipeline pipeline_;
  std::vector<int> columns_;  // column of each step's name
};

}  // namespace

namespace {

void parseLines(std::string_view text, Parser& parser) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  int number = 1;
  for (std::size_t at = 0; at < text.size(); ++number) {
    const std::size_t end = std::min(text.find_first_of("\r\n", at), text.size());
    parser.parseLine(text.substr(at, end - at), number);
    at = end + (text.substr(end).starts_with("\r\n") ? 2 : 1);
  }
}

}  // namespace

Pipeline parsePipeline(std::string_view text, const std::string& source) {
  Parser parser(source);
  parseLines(text, parser);
  return parser.finish();
}

Pipeline detail::parsePipelineFragment(std::string_view text, const std::string& source) {
  Parser parser(source);
  parseLines(text, parser);
  return parser.finishFragment();
}

Pipeline detail::readPipeline(const std::string& path, const RunContext* context) {
  constexpr std::size_t kLongest = 1 << 20;  // a thousand times more than any pipeline
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    throw InputError(FOOTFALL_TEXT("%1: is a folder; give a pipeline file"), path);
  }
  std::string text;
  if (const int error = readFromPipe(path, kLongest, text, Poll(context)); error != 0) {
    throw InputError(FOOTFALL_TEXT("%1: cannot be opened (%2); give a pipeline file that can be read"), path,
                     std::strerror(error));
  }
  if (text.size() > kLongest)
    throw InputError(FOOTFALL_TEXT("%1: is too long for a pipeline; give a text file of filters"), path);
  return parsePipeline(text, path);
}

Pipeline readPipelineFile(const std::string& path) { return readPipeline(path, nullptr); }

}  // namespace footfall
