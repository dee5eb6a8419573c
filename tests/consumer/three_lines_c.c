/* The common case in C: three_lines_c LEVEL OUTPUT computes where an agent can walk in a level.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <footfall.h>
#include <stdio.h>

int main(int count, char** arguments) {
  footfall_environment* level = NULL;
  footfall_result* result = NULL;
  if (count != 3) return 2;
  const int failed = footfall_load(arguments[1], NULL, NULL, &level) != FOOTFALL_OK ||
                     footfall_walkable_area(level, NULL, NULL, 0, &result) != FOOTFALL_OK ||
                     footfall_save(result, arguments[2], NULL) != FOOTFALL_OK;
  if (failed)
    fprintf(stderr, "%s\n", footfall_message());
  else
    printf("Footfall %s: %lu walkable triangles\n", footfall_version(),
           (unsigned long)footfall_result_triangles(result).count);
  footfall_free_result(result);
  footfall_free_environment(level);
  return failed;
}
