# What all targets of the project have in common.
# SPDX-License-Identifier: GPL-3.0-or-later

# ccache where it is found. It only stores results that used a precompiled header when told that macros and times in
# it do not matter, and only shares them between checkouts when it knows the root.
find_program(FOOTFALL_CCACHE ccache)
if(FOOTFALL_CCACHE AND (NOT CMAKE_CXX_COMPILER_LAUNCHER OR CMAKE_CXX_COMPILER_LAUNCHER STREQUAL "ccache"))
  set(CMAKE_CXX_COMPILER_LAUNCHER
      ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros CCACHE_BASEDIR=${PROJECT_SOURCE_DIR}
      ${FOOTFALL_CCACHE})
endif()

# Warnings, and what precompiled headers need, for a target of our own. The error bounds of core/exact are proven for
# separately rounded operations: no fused multiply-add behind our back, in whatever includes its headers either.
function(footfall_target target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -ffp-contract=off)
  if(FOOTFALL_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # ccache preprocesses first; GCC then needs to keep the inclusion of a precompiled header in sight.
    target_compile_options(${target} PRIVATE -fpch-preprocess)
    if(CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
      # GCC 12 warns of overlapping copies in every `"text" + std::string` (its bug 105651).
      target_compile_options(${target} PRIVATE -Wno-restrict)
    endif()
  endif()
endfunction()

# With FOOTFALL_UNITY, eight files of the target are compiled as one, so that templates and headers are compiled once for all of them.
function(footfall_compile_together target)
  if(FOOTFALL_UNITY)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
  endif()
endfunction()
