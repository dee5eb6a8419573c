# For the tests of footfall-mpi: how ranks are started on this machine, without a network.
# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash

# Prints why and succeeds with what ctest takes for "skipped".
skip() {
  echo "skipped: $*"
  exit 0
}

# ranks N COMMAND...: runs N processes on this machine, which may have fewer processors.
ranks() {
  local count="$1"
  shift
  # mpirun 4.1.4 may wait for ever for a rank that died while it was started: FOOTFALL_TEST_LIMIT is for whoever does
  # not look for such an mpirun itself.
  local limit=()
  [ -z "${FOOTFALL_TEST_LIMIT:-}" ] || limit=(timeout --foreground --kill-after 10 "${FOOTFALL_TEST_LIMIT}")
  # Root is refused unless it insists; it is in containers. One copy through shared memory needs rights that those lack.
  "${limit[@]}" "${FOOTFALL_MPIRUN}" --allow-run-as-root --oversubscribe --host "localhost:${count}" --mca btl self,vader \
    --mca btl_vader_single_copy_mechanism none --mca pml ob1 --mca plm isolated --bind-to none -n "${count}" "$@" </dev/null
}

[ -x "${FOOTFALL_MPI}" ] || skip "footfall-mpi is not part of this build (MPI was not found)"
[ -x "${FOOTFALL_MPIRUN:-}" ] || skip "mpirun was not found"
work="$(mktemp -d)"
trap 'rm -rf -- "${work}"' EXIT
