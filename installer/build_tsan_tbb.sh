#!/usr/bin/env bash
# Builds oneTBB with ThreadSanitizer from Debian's source package into build/deps/tbb-tsan: the distribution's own build
# synchronizes where ThreadSanitizer cannot see it. Skipped when that was done before. Needs no root.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
# shellcheck source=installer/common.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"

if [ -d "${tsan_tbb_prefix}" ]; then exit 0; fi

for tool in cmake g++ ninja; do
  command -v "${tool}" >/dev/null || fail "${tool} is missing; run installer/install_dependencies.sh first"
done

scratch="$(mktemp -d)"
trap 'rm -rf -- "${scratch}"' EXIT
chmod 755 "${scratch}" # apt downloads as its own user, who must be able to look inside
logs="${tsan_tbb_prefix}-logs"

say "TBB for ThreadSanitizer: fetching the source package"
fetch_source onetbb "${scratch}" "${logs}"
shopt -s nullglob
sources=("${scratch}"/source/onetbb-*/CMakeLists.txt)
[ "${#sources[@]}" -eq 1 ] || fail "the source package of onetbb does not hold one folder with a CMakeLists.txt"

say "TBB for ThreadSanitizer: building"
# Without TBB's own allocator: ThreadSanitizer has to see memory being freed and given out again.
quietly "${logs}/configure.log" cmake -G Ninja -S "$(dirname -- "${sources[0]}")" -B "${scratch}/build" \
  -DCMAKE_BUILD_TYPE=RelWithDebInfo -DCMAKE_CXX_FLAGS_RELWITHDEBINFO="-O1 -g" \
  -DCMAKE_CXX_FLAGS="-fno-omit-frame-pointer -ffile-prefix-map=${scratch}=." -DCMAKE_INSTALL_LIBDIR=lib \
  -DTBB_SANITIZE=thread -DTBB_TEST=OFF -DTBB_STRICT=OFF -DTBBMALLOC_BUILD=OFF -DTBB_DISABLE_HWLOC_AUTOMATIC_SEARCH=ON
quietly "${logs}/build.log" cmake --build "${scratch}/build" -j "$(build_jobs)"
# In one move: the folder's presence says that all is done.
rm -rf -- "${tsan_tbb_prefix}.part"
quietly "${logs}/install.log" cmake --install "${scratch}/build" --prefix "${tsan_tbb_prefix}.part"
mv -- "${tsan_tbb_prefix}.part" "${tsan_tbb_prefix}"
say "TBB for ThreadSanitizer: done, in ${tsan_tbb_prefix}"
