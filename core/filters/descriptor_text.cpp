// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filters/descriptor_text.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <limits>
#include <span>
#include <sstream>
#include <vector>

#include "footfall/filter.hpp"

namespace footfall::detail {
namespace {

// Limits at the end of what the type can hold are there for the program, not for people.
bool hasMaximum(const ParameterDescriptor& parameter) {
  const double limit =
      parameter.type == ParameterType::Integer ? std::numeric_limits<int>::max() : std::numeric_limits<double>::max();
  return parameter.maximum < limit;
}

Text unitText(Unit unit) {
  switch (unit) {
    case Unit::Degrees:
      return FOOTFALL_TEXT("degrees");
    case Unit::Length:
      return FOOTFALL_TEXT("length in the environment's units");
    case Unit::Area:
      return FOOTFALL_TEXT("area in the environment's units");
    case Unit::Count:
    case Unit::None:
      break;
  }
  return {};
}

std::string defaultText(const FilterDescriptor& filter, const ParameterDescriptor& parameter) {
  if (parameter.follows >= 0) return "as " + std::string(filter.parameters[parameter.follows].name);
  std::string text = formatValue(parameter, parameter.defaultValue);
  if (parameter.defaultValue != 0 && parameter.unit == Unit::Length) text += " m";
  if (parameter.defaultValue != 0 && parameter.unit == Unit::Area) text += " m²";
  return text;
}

std::string joinAliases(const FilterDescriptor& filter) {
  std::string text;
  for (const std::string_view alias : filter.aliases) text.append(text.empty() ? "" : ", ").append(alias);
  return text;
}

std::string_view scopeText(const FilterDescriptor& filter) {
  if (filter.kind != FilterKind::Filter) return "partitioning";
  return filter.scope == Scope::Local ? "local (may stand inside a parallel block)"
                                      : "global (may not stand inside a parallel block)";
}

// Breaks text into lines of at most 100 columns, each behind `indent` blanks but the first, which follows `head`.
void appendWrapped(std::string& out, const std::string& head, std::string_view text) {
  constexpr std::size_t kColumns = 100;
  const std::string indent(head.size(), ' ');
  std::string line = head;
  std::istringstream words{std::string(text)};
  bool first = true;
  for (std::string word; words >> word;) {
    if (!first && line.size() + 1 + word.size() > kColumns) {
      out += line + '\n';
      line = indent;
      first = true;
    }
    if (!first) line += ' ';
    line += word;
    first = false;
  }
  out += line + '\n';
}

std::size_t editDistance(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substituted = diagonal + (lower(a[i - 1]) == lower(b[j - 1]) ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, substituted});
    }
  }
  return row[b.size()];
}

}  // namespace

std::string formatValue(const ParameterDescriptor& parameter, double value) {
  if (parameter.type == ParameterType::Boolean) return value != 0 ? "true" : "false";
  std::array<char, 32> buffer;
  const auto fixed = parameter.type == ParameterType::Integer
                         ? std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed)
                         : std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  // Only a number beyond every range is too long for the plain form.
  const auto end = fixed.ec == std::errc() ? fixed.ptr : std::to_chars(buffer.data(), buffer.data() + 32, value).ptr;
  return {buffer.data(), end};
}

Text describeRange(const ParameterDescriptor& parameter) {
  if (parameter.type == ParameterType::Boolean) return FOOTFALL_TEXT("true or false");
  if (parameter.minimum == -std::numeric_limits<double>::max() && !hasMaximum(parameter)) {
    const Text any = unitText(parameter.unit);
    return any.empty() ? Text(FOOTFALL_TEXT("a number")) : Text(FOOTFALL_TEXT("a number (%1)"), any);
  }
  Pattern number =
      parameter.minimumOpen ? FOOTFALL_TEXT("a number above %1") : FOOTFALL_TEXT("a number of at least %1");
  if (parameter.type == ParameterType::Integer)
    number = parameter.minimumOpen ? FOOTFALL_TEXT("a whole number above %1")
                                   : FOOTFALL_TEXT("a whole number of at least %1");
  Text text(number, formatValue(parameter, parameter.minimum));
  if (hasMaximum(parameter)) {
    text = Text(parameter.maximumOpen ? FOOTFALL_TEXT("%1 and below %2") : FOOTFALL_TEXT("%1 and at most %2"), text,
                formatValue(parameter, parameter.maximum));
  }
  const Text unit = unitText(parameter.unit);
  return unit.empty() ? text : Text(Pattern{"%1 (%2)"}, text, unit);
}

std::string describeUsage(const FilterDescriptor& filter) {
  std::string text(filter.name);
  std::string closing;
  for (const ParameterDescriptor& parameter : filter.parameters) {
    text.append(parameter.optional ? " [" : " ").append(parameter.name);
    if (parameter.optional) closing += ']';
  }
  text += closing;
  if (filter.repeats > 0) {
    text += " [";
    for (const ParameterDescriptor& parameter : std::span(filter.parameters).last(filter.repeats))
      text.append(parameter.name).append(" ");
    text += "...]";
  }
  return text;
}

std::string describeFilter(const FilterDescriptor& filter) {
  std::string text = describeUsage(filter) + "\n\n";
  appendWrapped(text, "  ", filter.help);
  text += '\n';
  for (const ParameterDescriptor& parameter : filter.parameters) {
    const std::string head = "  " + std::string(parameter.name) + ": ";
    appendWrapped(text, head,
                  std::string(parameter.help) + " Write " + describeRange(parameter).str() +
                      (filter.repeats > 0 ? "" : "; default " + defaultText(filter, parameter)) +
                      (parameter.optional ? ", may be left out." : "."));
  }
  if (!filter.parameters.empty()) text += '\n';
  if (!filter.aliases.empty()) appendWrapped(text, "  also called:  ", joinAliases(filter));
  if (!filter.precondition.empty()) appendWrapped(text, "  precondition: ", filter.precondition);
  appendWrapped(text, "  effect:       ", filter.effect);
  appendWrapped(text, "  scope:        ", scopeText(filter));
  appendWrapped(text, "  source:       ", filter.source);
  return text;
}

std::string listFilters() {
  std::size_t width = 0;
  for (const FilterDescriptor& filter : filterDescriptors()) width = std::max(width, describeUsage(filter).size());
  std::string text;
  for (const FilterDescriptor& filter : filterDescriptors()) {
    const std::string usage = describeUsage(filter);
    const std::string_view help = filter.help;
    // The first sentence describes the filter; the rest is shown by `footfall filters NAME`.
    const std::string_view sentence = help.substr(0, help.find_first_of(".:"));
    text += usage + std::string(width + 2 - usage.size(), ' ') + std::string(sentence) + '\n';
  }
  return text + "\n`footfall filters NAME` tells everything about one of them.\n";
}

std::string filtersMarkdown() {
  std::string text =
      "# Filters\n\n"
      "<!-- Generated by `footfall filters --markdown` from core/filters/descriptors; change it there. -->\n\n"
      "A pipeline file holds one filter a line: its name, then its parameters, with blanks in between. Everything\n"
      "behind a `#` is a comment, except that `#off` in front of a filter keeps the filter but switches it off.\n"
      "Parameters in brackets may be left out; then their default holds. Lengths and areas are in the environment's\n"
      "units; their defaults below are in metres, and Footfall converts them when it makes a new pipeline.\n\n"
      "```\n"
      "SlopeFilter 45            # as steep as the agent can walk\n"
      "VerticalClearanceFilter 2 # as high as the agent is\n"
      "LayerSubdivisionFilter\n"
      "```\n\n"
      "A parallel block runs from a strategy to `Collapse` and holds local filters only.\n";
  for (const FilterDescriptor& filter : filterDescriptors()) {
    text += "\n## " + std::string(filter.name) + "\n\n`" + describeUsage(filter) + "`\n\n" + std::string(filter.help);
    text += "\n\n";
    if (!filter.parameters.empty()) {
      text += "| parameter | meaning | value | default |\n|---|---|---|---|\n";
      for (const ParameterDescriptor& parameter : filter.parameters) {
        text += "| `" + std::string(parameter.name) + "` | " + std::string(parameter.help) + " | " +
                describeRange(parameter).str() + " | " + (filter.repeats > 0 ? "" : defaultText(filter, parameter)) +
                " |\n";
      }
      text += '\n';
    }
    if (!filter.aliases.empty()) text += "- Also called: " + joinAliases(filter) + "\n";
    if (!filter.precondition.empty()) text += "- Precondition: " + std::string(filter.precondition) + "\n";
    text += "- Effect: " + std::string(filter.effect) + "\n- Scope: " + std::string(scopeText(filter)) +
            "\n- Source: " + std::string(filter.source) + "\n";
  }
  return text;
}

std::string_view nearestFilterName(std::string_view name) {
  // A longer text is no misspelt name; comparing its beginning is enough.
  name = name.substr(0, 64);
  std::string_view best;
  std::size_t bestDistance = std::numeric_limits<std::size_t>::max();
  const auto consider = [&](std::string_view candidate, std::size_t distance) {
    if (distance < bestDistance) {
      best = candidate;
      bestDistance = distance;
    }
  };
  const auto considerName = [&](std::string_view known) {
    consider(known, editDistance(name, known));
    // "Slope" stands for SlopeFilter, although other names may be fewer edits away.
    for (const std::string_view ending : {"Filter", "Strategy"}) {
      if (known.ends_with(ending)) consider(known, editDistance(name, known.substr(0, known.size() - ending.size())));
    }
  };
  for (const FilterDescriptor& filter : filterDescriptors()) {
    considerName(filter.name);
    std::ranges::for_each(filter.aliases, considerName);
  }
  return best;
}

}  // namespace footfall::detail
