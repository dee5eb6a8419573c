// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/thesis_figures.hpp"

#include <map>
#include <tuple>
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
      {{"house", "GridStrategy 2 2"}, {3301, 2.7846107, {43, 364, 959, 15, 320, 1600}}},
      {{"house", "GridStrategy 3 3"}, {5229, 1.757889, {47, 980, 2217, 14, 450, 1521}}},
      {{"house", "GridStrategy 4 4"}, {11225, 0.818886414, {116, 236, 9072, 8, 306, 1487}}},
      {{"house", "RecursiveStrategy 50 2 true"}, {6463, 1.196, {37, 1083, 3322, 12, 318, 1691}}},
      {{"house", "RecursiveStrategy 50 3 true"}, {18981, 0.484, {21, 4338, 11755, 34, 1284, 1549}}},
      {{"house", "SortedRecursiveStrategy 50 2 true"}, {3498, 2.6277873, {62, 565, 1109, 15, 276, 1471}}},
      {{"house", "SortedRecursiveStrategy 50 3 true"}, {4732, 1.942519, {41, 1000, 1880, 13, 325, 1473}}},
      {{"house", "SortedRecursiveStrategy 50 4 true"}, {6773, 1.357153, {50, 1518, 3123, 33, 442, 1607}}},
      {{"villa", "GridStrategy 2 2"}, {97237, 9.255736, {220, 1589, 42195, 455, 50522, 2256}}},
      {{"villa", "GridStrategy 3 3"}, {124510, 7.228335, {206, 3245, 63010, 797, 55000, 2252}}},
      {{"villa", "GridStrategy 4 4"}, {105588, 8.523696, {243, 4302, 40702, 806, 56995, 2540}}},
      {{"villa", "RecursiveStrategy 50 2 true"}, {107109, 8.402655, {219, 4991, 41378, 1008, 57236, 2277}}},
      {{"villa", "RecursiveStrategy 50 3 true"}, {129775, 6.93508, {252, 16555, 35253, 3258, 72120, 2337}}},
      {{"villa", "SortedRecursiveStrategy 50 2 true"}, {99332, 9.060524302, {243, 3417, 38995, 658, 53772, 2247}}},
      {{"villa", "SortedRecursiveStrategy 50 3 true"}, {101081, 8.90375, {212, 5074, 36621, 2191, 54781, 2202}}},
      {{"villa", "SortedRecursiveStrategy 50 4 true"}, {133770, 6.727966, {240, 8823, 53334, 3490, 65431, 2452}}},
      {{"arena", "GridStrategy 3 3"}, {1143833, 1.5736563, {2479, 6476, 1017566, 67801, 47921, 1590}}},
      {{"arena", "GridStrategy 4 4"}, {824745, 2.182493, {2556, 10051, 706710, 54141, 49735, 1552}}},
      {{"arena", "RecursiveStrategy 50 3 true"}, {190254, 9.461036, {167, 70625, 58762, 984, 57602, 2114}}},
      {{"arena", "SortedRecursiveStrategy 50 3 true"}, {121877, 14.76899, {169, 5002, 66262, -1, -1, 2278}}},
      {{"arena", "SortedRecursiveStrategy 50 4 true"}, {129752, 13.87261853, {217, 9027, 62496, -1, -1, 2085}}},
      {{"tower", "GridStrategy 2 1"}, {7962, 0.2833459, {38, 316, 5942, 2, 142, 1522}}},
      {{"tower", "GridStrategy 2 2"}, {244056, 0.00924378, {26, 1081, 241153, 46, 130, 1620}}},
      {{"docks", "SortedRecursiveStrategy 50 4 true"}, {465772, std::nullopt, {305, 8654, 78175, 5467, 370937, 2234}}},
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
      {"house", {0, 0.000041, 0.000001, 0.000005, 0.000041, 0.000001, 0.000005, 179'997.515625, 179'996.109375}},
      {"villa", {0, 0.368205, 0.001574, 0.000337, 15.668283, 0.004275, 0.214389, 9'104'859.0, 9'104'523.0}},
      {"arena", {0, 0.0941915, 0.001326, 0.006456, 0.188383, 0.002652, 0.012911, 116'101.421875, 116'101.242188}},
  };
  return find(figures, sample);
}

std::optional<ThesisCommunication> findThesisCommunication(const std::string& format, int depth, std::size_t values) {
  using Key = std::tuple<std::string, int, std::size_t>;
  static const std::map<Key, ThesisCommunication> figures{
      {{"binary", 1, 1}, {0.7, 4.2}},        {{"binary", 1, 1000}, {2.8, 23.4}},
      {{"binary", 1, 10'000}, {2.2, 111.0}}, {{"binary", 1, 1'000'000}, {143.2, 9146.3}},
      {{"ascii", 1, 1}, {3.3, 5.9}},         {{"ascii", 1, 1000}, {6.9, 46.7}},
      {{"ascii", 1, 10'000}, {45.3, 204.7}}, {{"ascii", 1, 1'000'000}, {3446.8, 17042.8}},
      {{"tree", 12, 1}, {7.0, 0.0}},         {{"tree", 12, 1000}, {12.4, 3.7}},
      {{"tree", 12, 10'000}, {40.8, 26.6}},  {{"tree", 12, 1'000'000}, {2831.2, 2156.2}},
      {{"tree", 3, 1}, {6.9, 0.0}},          {{"tree", 3, 1000}, {12.5, 0.7}},
      {{"tree", 3, 10'000}, {25.2, 10.7}},   {{"tree", 3, 1'000'000}, {814.9, 606.0}},
      {{"tree", 1, 1}, {6.5, 0.0}},          {{"tree", 1, 1000}, {10.1, 0.0}},
      {{"tree", 1, 10'000}, {12.5, 1.8}},    {{"tree", 1, 1'000'000}, {114.3, 103.0}},
  };
  return find(figures, Key{format, depth, values});
}

}  // namespace footfall::bench
