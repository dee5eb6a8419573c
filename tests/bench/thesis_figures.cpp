// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/thesis_figures.hpp"

#include <map>
#include <utility>

namespace footfall::bench {
namespace {

template <class Key, class Value>
std::optional<Value> find(const std::map<Key, Value>& map, const Key& key) {
  const auto found = map.find(key);
  return found == map.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace

std::optional<ThesisRun> findThesisRun(const std::string& sample, const std::string& strategy) {
  static const std::map<std::pair<std::string, std::string>, ThesisRun> runs{
      {{"house", "GridStrategy 2 2"}, {3301, 2.7846107}},
      {{"house", "GridStrategy 3 3"}, {5229, 1.757889}},
      {{"house", "GridStrategy 4 4"}, {11225, 0.818886414}},
      {{"house", "RecursiveStrategy 50 2 true"}, {6463, 1.196}},
      {{"house", "RecursiveStrategy 50 3 true"}, {18981, 0.484}},
      {{"house", "SortedRecursiveStrategy 50 2 true"}, {3498, 2.6277873}},
      {{"house", "SortedRecursiveStrategy 50 3 true"}, {4732, 1.942519}},
      {{"house", "SortedRecursiveStrategy 50 4 true"}, {6773, 1.357153}},
      {{"villa", "GridStrategy 2 2"}, {97237, 9.255736}},
      {{"villa", "GridStrategy 3 3"}, {124510, 7.228335}},
      {{"villa", "GridStrategy 4 4"}, {105588, 8.523696}},
      {{"villa", "RecursiveStrategy 50 2 true"}, {107109, 8.402655}},
      {{"villa", "RecursiveStrategy 50 3 true"}, {129775, 6.93508}},
      {{"villa", "SortedRecursiveStrategy 50 2 true"}, {99332, 9.060524302}},
      {{"villa", "SortedRecursiveStrategy 50 3 true"}, {101081, 8.90375}},
      {{"villa", "SortedRecursiveStrategy 50 4 true"}, {133770, 6.727966}},
      {{"arena", "GridStrategy 3 3"}, {1143833, 1.5736563}},
      {{"arena", "GridStrategy 4 4"}, {824745, 2.182493}},
      {{"arena", "RecursiveStrategy 50 3 true"}, {190254, 9.461036}},
      {{"arena", "SortedRecursiveStrategy 50 3 true"}, {121877, 14.76899}},
      {{"arena", "SortedRecursiveStrategy 50 4 true"}, {129752, 13.87261853}},
      {{"tower", "GridStrategy 2 1"}, {7962, 0.2833459}},
      {{"tower", "GridStrategy 2 2"}, {244056, 0.00924378}},
      {{"docks", "SortedRecursiveStrategy 50 4 true"}, {465772, std::nullopt}},
  };
  return find(runs, {sample, strategy});
}

std::optional<ThesisEnvironment> findThesisEnvironment(const std::string& sample) {
  static const std::map<std::string, ThesisEnvironment> environments{
      {"house", {820, 9192, false}}, {"villa", {30363, 900'000, true}}, {"arena", {19829, 1'800'000, true}},
      {"docks", {59418, 0, false}},  {"tower", {440, 2256, false}},
  };
  return find(environments, sample);
}

std::optional<ThesisCorrectness> findThesisCorrectness(const std::string& sample) {
  static const std::map<std::string, ThesisCorrectness> figures{
      {"house", {0, 0.000041, 0.000001, 0.000005, 179'997.515625, 179'996.109375}},
      {"villa", {0, 0.368205, 0.001574, 0.000337, 9'104'859.0, 9'104'523.0}},
      {"arena", {0, 0.0941915, 0.001326, 0.006456, 116'101.421875, 116'101.242188}},
  };
  return find(figures, sample);
}

}  // namespace footfall::bench
