// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/view_mode.hpp"

#include <QCoreApplication>

namespace footfall::ui {

std::string_view nameOf(ViewMode mode) {
  switch (mode) {
    case ViewMode::Result:
      return "result";
    case ViewMode::Wireframe:
      return "wireframe";
    case ViewMode::HiddenLine:
      return "hidden-line";
    case ViewMode::WalkableOnly:
      return "walkable";
    case ViewMode::RejectedBy:
      return "rejected";
    case ViewMode::Slope:
      return "slope";
    case ViewMode::Clearance:
      return "clearance";
    case ViewMode::SourceTriangles:
      return "source";
  }
  return {};
}

std::optional<ViewMode> viewModeFrom(std::string_view name) {
  for (const ViewMode mode : kViewModes) {
    if (nameOf(mode) == name) return mode;
  }
  return std::nullopt;
}

QString labelOf(ViewMode mode) {
  switch (mode) {
    case ViewMode::Result:
      return QCoreApplication::translate("ViewMode", "Result");
    case ViewMode::Wireframe:
      return QCoreApplication::translate("ViewMode", "Wireframe");
    case ViewMode::HiddenLine:
      return QCoreApplication::translate("ViewMode", "Hidden line");
    case ViewMode::WalkableOnly:
      return QCoreApplication::translate("ViewMode", "Walkable only");
    case ViewMode::RejectedBy:
      return QCoreApplication::translate("ViewMode", "Rejected by");
    case ViewMode::Slope:
      return QCoreApplication::translate("ViewMode", "Slope");
    case ViewMode::Clearance:
      return QCoreApplication::translate("ViewMode", "Clearance");
    case ViewMode::SourceTriangles:
      return QCoreApplication::translate("ViewMode", "Source triangles");
  }
  return {};
}

QString helpOf(ViewMode mode) {
  switch (mode) {
    case ViewMode::Result:
      return QCoreApplication::translate("ViewMode", "What is walkable, and why the rest is not");
    case ViewMode::Wireframe:
      return QCoreApplication::translate("ViewMode", "The edges of all triangles; nothing hides anything");
    case ViewMode::HiddenLine:
      return QCoreApplication::translate("ViewMode", "The edges of the triangles that are in front");
    case ViewMode::WalkableOnly:
      return QCoreApplication::translate("ViewMode", "The walkable area without the environment");
    case ViewMode::RejectedBy:
      return QCoreApplication::translate("ViewMode", "Floors in the colour of the filter that removed them");
    case ViewMode::Slope:
      return QCoreApplication::translate("ViewMode", "Floors by their slope in degrees, with the limit of the filter");
    case ViewMode::Clearance:
      return QCoreApplication::translate("ViewMode",
                                         "Floors by the free height above them, with the limit of the filter");
    case ViewMode::SourceTriangles:
      return QCoreApplication::translate("ViewMode",
                                         "Walkable pieces by the triangle of the environment they come from");
  }
  return {};
}

bool needsResult(ViewMode mode) {
  return mode == ViewMode::WalkableOnly || mode == ViewMode::RejectedBy || mode == ViewMode::SourceTriangles;
}

}  // namespace footfall::ui
