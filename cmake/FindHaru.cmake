# libharu (Debian: libhpdf-dev), for floor plans as PDF. Gives Haru_INCLUDE_DIR and Haru_LIBRARY.
# SPDX-License-Identifier: GPL-3.0-or-later
find_path(Haru_INCLUDE_DIR hpdf.h)
find_library(Haru_LIBRARY NAMES hpdf)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Haru REQUIRED_VARS Haru_LIBRARY Haru_INCLUDE_DIR)
mark_as_advanced(Haru_INCLUDE_DIR Haru_LIBRARY)
