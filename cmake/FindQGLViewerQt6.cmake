# libQGLViewer for Qt6: a distribution's package, or what installer/build_qglviewer.sh made in build/deps/qglviewer
# (another prefix: -DQGLViewerQt6_ROOT=PREFIX). Gives the target QGLViewer::Qt6. Debian's Qt5 build is never taken:
# its library has another name.
# SPDX-License-Identifier: GPL-3.0-or-later
find_path(
  QGLViewerQt6_INCLUDE_DIR QGLViewer/qglviewer.h
  HINTS ${PROJECT_SOURCE_DIR}/build/deps/qglviewer/include)
find_library(
  QGLViewerQt6_LIBRARY
  NAMES QGLViewer-qt6 QGLViewer-Qt6
  HINTS ${PROJECT_SOURCE_DIR}/build/deps/qglviewer/lib)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(
  QGLViewerQt6
  REQUIRED_VARS QGLViewerQt6_LIBRARY QGLViewerQt6_INCLUDE_DIR
  REASON_FAILURE_MESSAGE "run installer/build_qglviewer.sh first")
mark_as_advanced(QGLViewerQt6_INCLUDE_DIR QGLViewerQt6_LIBRARY)

if(QGLViewerQt6_FOUND AND NOT TARGET QGLViewer::Qt6)
  find_package(Qt6 REQUIRED COMPONENTS Widgets OpenGL OpenGLWidgets Xml)
  find_package(OpenGL REQUIRED COMPONENTS OpenGL)
  add_library(QGLViewer::Qt6 UNKNOWN IMPORTED)
  set_target_properties(
    QGLViewer::Qt6
    PROPERTIES IMPORTED_LOCATION "${QGLViewerQt6_LIBRARY}"
               INTERFACE_INCLUDE_DIRECTORIES "${QGLViewerQt6_INCLUDE_DIR}"
               INTERFACE_LINK_LIBRARIES "Qt6::Widgets;Qt6::OpenGL;Qt6::OpenGLWidgets;Qt6::Xml;OpenGL::GLU;OpenGL::GL")
endif()
