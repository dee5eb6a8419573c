# Detour, the run-time half of Recast (Debian: librecast-dev), for exports. Gives Detour_INCLUDE_DIR and Detour_LIBRARY.
# SPDX-License-Identifier: GPL-3.0-or-later
find_path(Detour_INCLUDE_DIR DetourNavMeshBuilder.h PATH_SUFFIXES recastnavigation)
find_library(Detour_LIBRARY NAMES Detour)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Detour REQUIRED_VARS Detour_LIBRARY Detour_INCLUDE_DIR)
mark_as_advanced(Detour_INCLUDE_DIR Detour_LIBRARY)
