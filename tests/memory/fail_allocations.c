/* Loaded by LD_PRELOAD: allocations of 4 kB and more fail from a chosen one on, as when memory runs out.
 * FOOTFALL_FAIL_FROM=N: the first that fails, counted from 0. FOOTFALL_COUNT_TO=FILE: writes how many there were. */
/* SPDX-License-Identifier: GPL-3.0-or-later */
#define _GNU_SOURCE
#include <errno.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>

extern void* __libc_malloc(size_t);
extern void* __libc_calloc(size_t, size_t);
extern void* __libc_realloc(void*, size_t);
extern void* __libc_memalign(size_t, size_t);

static const size_t kSmall = 4096;
static long failFrom = -1; /* none before the library is initialized */
static long count = 0;

static int fails(size_t bytes) {
  if (bytes < kSmall || failFrom < 0) return 0;
  if (__atomic_fetch_add(&count, 1, __ATOMIC_RELAXED) < failFrom) return 0;
  errno = ENOMEM;
  return 1;
}

void* malloc(size_t bytes) { return fails(bytes) ? NULL : __libc_malloc(bytes); }
void* calloc(size_t number, size_t bytes) {
  return bytes != 0 && fails(number * bytes) ? NULL : __libc_calloc(number, bytes);
}
void* realloc(void* memory, size_t bytes) { return fails(bytes) ? NULL : __libc_realloc(memory, bytes); }
void* memalign(size_t alignment, size_t bytes) { return fails(bytes) ? NULL : __libc_memalign(alignment, bytes); }
void* aligned_alloc(size_t alignment, size_t bytes) { return memalign(alignment, bytes); }
int posix_memalign(void** memory, size_t alignment, size_t bytes) {
  *memory = memalign(alignment, bytes);
  return *memory == NULL ? ENOMEM : 0;
}

__attribute__((constructor)) static void begin(void) {
  const char* from = getenv("FOOTFALL_FAIL_FROM");
  failFrom = from != NULL ? atol(from) : -1;
}

__attribute__((destructor)) static void end(void) {
  const char* path = getenv("FOOTFALL_COUNT_TO");
  const long counted = count;
  failFrom = -1;
  FILE* file = path != NULL ? fopen(path, "w") : NULL;
  if (file == NULL) return;
  fprintf(file, "%ld\n", counted);
  fclose(file);
}
