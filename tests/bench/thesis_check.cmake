# cmake -DPROGRAM=... -DHOUSE=house.obj -DSCRATCH=FOLDER -P thesis_check.cmake: runs the thesis's experiments once on the
# smallest sample and looks whether the files have what they promise. Says nothing about times.
# SPDX-License-Identifier: GPL-3.0-or-later
file(REMOVE_RECURSE "${SCRATCH}")
file(MAKE_DIRECTORY "${SCRATCH}")
execute_process(
  COMMAND "${PROGRAM}" "${HOUSE}:2" --runs 1 --least-seconds 0 --threads 1,2 --table-threads 2 --strategy "GridStrategy 2 2"
          --strategy AutoStrategy --json "${SCRATCH}/thesis.json" --markdown "${SCRATCH}/thesis.md" RESULT_VARIABLE code)
if(NOT code EQUAL 0)
  message(FATAL_ERROR "exit code ${code}")
endif()

# Each of these ends the script where the JSON cannot be parsed or lacks the field.
file(READ "${SCRATCH}/thesis.json" json)
string(JSON house GET "${json}" environments 0)
string(JSON triangles GET "${house}" triangles)
string(JSON rows LENGTH "${house}" strategies)
string(JSON cells GET "${house}" strategies 2 cells)
if(NOT triangles EQUAL 820 OR NOT rows EQUAL 4 OR NOT cells EQUAL 4)
  message(FATAL_ERROR "${triangles} triangles, ${rows} rows, ${cells} cells")
endif()
foreach(row 2 3) # the strategies, after the two rows without a block
  foreach(figure total_ms speed_up partitioning_ms parallel_ms merging_ms postprocessing_ms imbalance peak_bytes)
    string(JSON value GET "${house}" strategies ${row} ${figure})
    if(NOT value GREATER 0)
      message(FATAL_ERROR "${figure} of row ${row} is ${value}")
    endif()
  endforeach()
  string(JSON equal GET "${house}" strategies ${row} bytes_equal)
  if(NOT equal)
    message(FATAL_ERROR "row ${row} gives other bytes")
  endif()
endforeach()
foreach(line 0 1 2)
  string(JSON value GET "${house}" scaling lines ${line} points 0 efficiency)
  if(NOT value GREATER 0)
    message(FATAL_ERROR "efficiency of line ${line} is ${value}")
  endif()
endforeach()
string(JSON equal GET "${house}" correctness 0 bytes_equal)
string(JSON covered GET "${house}" correctness 1 covered)
if(NOT equal OR covered LESS 0.999 OR covered GREATER 1.001)
  message(FATAL_ERROR "bytes equal: ${equal}; the thesis's listings cover ${covered}")
endif()

file(READ "${SCRATCH}/thesis.md" markdown)
foreach(part "### By strategy and depth, 2 threads" "| Grid 2 x 2 |" "### Scaling over threads" "### Correctness"
        "| walkable space |")
  string(FIND "${markdown}" "${part}" found)
  if(found EQUAL -1)
    message(FATAL_ERROR "the tables have no '${part}'")
  endif()
endforeach()

# refuse EXPECTED ARGUMENT...: ends with exit code 2 and a message.
function(refuse expected)
  execute_process(COMMAND "${PROGRAM}" ${ARGN} RESULT_VARIABLE code ERROR_VARIABLE error)
  if(NOT code EQUAL 2 OR NOT error MATCHES "${expected}")
    message(FATAL_ERROR "${ARGN} gives ${code}: ${error}")
  endif()
endfunction()
refuse("missing.obj: no such file" "${SCRATCH}/missing.obj")
refuse("is out of range" "${HOUSE}" --strategy "GridStrategy 0 2")
refuse("nothing to measure")
