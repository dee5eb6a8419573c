// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/filters/filter_selection.hpp"

#include <algorithm>

namespace footfall::ui {

int FilterSelection::indexOf(int id) const {
  const auto found = std::ranges::find(rows_, id);
  return found == rows_.end() ? -1 : static_cast<int>(found - rows_.begin());
}

void FilterSelection::setRows(const std::vector<int>& ids) {
  const int place = indexOf(current_);
  rows_ = ids;
  std::erase_if(chosen_, [this](int id) { return indexOf(id) < 0; });
  if (indexOf(anchor_) < 0) anchor_ = -1;
  if (indexOf(current_) >= 0) return;
  current_ = -1;
  if (place < 0 || rows_.empty()) return;
  const int next = rows_[static_cast<std::size_t>(std::min(place, static_cast<int>(rows_.size()) - 1))];
  if (chosen_.empty()) {
    choose(next);
  } else {
    current_ = chosen_.back();
  }
}

void FilterSelection::choose(int id, Qt::KeyboardModifiers modifiers) {
  if (indexOf(id) < 0) return;
  current_ = id;
  if (modifiers.testFlag(Qt::ShiftModifier) && anchor_ >= 0) {
    chooseRange(indexOf(anchor_), indexOf(id));
    return;
  }
  anchor_ = id;
  if (!modifiers.testFlag(Qt::ControlModifier)) {
    chosen_ = {id};
  } else if (contains(id)) {
    std::erase(chosen_, id);
  } else {
    chosen_.push_back(id);
  }
}

void FilterSelection::step(int rows, bool extend) {
  if (rows_.empty()) return;
  const int from = indexOf(current_);
  const int last = static_cast<int>(rows_.size()) - 1;
  const int to = from < 0 ? (rows > 0 ? 0 : last) : std::clamp(from + rows, 0, last);
  choose(rows_[static_cast<std::size_t>(to)], extend ? Qt::ShiftModifier : Qt::NoModifier);
}

void FilterSelection::chooseRange(int from, int to) {
  chosen_.clear();
  for (int i = std::min(from, to); i <= std::max(from, to); ++i) chosen_.push_back(rows_[static_cast<std::size_t>(i)]);
}

void FilterSelection::choose(const std::vector<int>& ids) {
  if (ids.empty()) return;
  chosen_ = ids;
  current_ = ids.back();
  anchor_ = ids.front();
}

bool FilterSelection::contains(int id) const { return std::ranges::find(chosen_, id) != chosen_.end(); }

std::vector<int> FilterSelection::ids() const {
  std::vector<int> ids;
  for (const int id : rows_) {
    if (contains(id)) ids.push_back(id);
  }
  return ids;
}

}  // namespace footfall::ui
