// Sorted lists without duplicates, used as sets.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

namespace footfall::detail {

/// Sorts a list and removes duplicates.
template <class T, class Allocator>
void sortOnce(std::vector<T, Allocator>& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

/// Sorts a list by keyOf(element) and keeps one of several elements with equal keys.
template <class T, class Allocator, class KeyOf>
void sortOnceBy(std::vector<T, Allocator>& list, const KeyOf& keyOf) {
  std::sort(list.begin(), list.end(), [&](const T& a, const T& b) { return keyOf(a) < keyOf(b); });
  list.erase(std::unique(list.begin(), list.end(), [&](const T& a, const T& b) { return keyOf(a) == keyOf(b); }),
             list.end());
}

}  // namespace footfall::detail
