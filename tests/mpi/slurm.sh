#!/usr/bin/env bash
# slurm.sh: installer/footfall.slurm by a Slurm of two machines that are both this one, brought up for the test in a
# folder of its own. Jobs started by srun and by mpirun, and one that was cancelled and is given again, end with the bytes
# of footfall. Skipped where Slurm (Debian: slurm-wlm, munge) is missing or the user is not root. Environment as check.sh.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
# shellcheck source=tests/mpi/common.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"

for program in munged slurmctld slurmd sbatch srun scancel scontrol sinfo squeue; do
  command -v "${program}" >/dev/null || skip "${program} was not found (Debian: slurm-wlm and munge)"
done
[ "$(id -u)" -eq 0 ] || skip "Slurm's daemons are started as root here"

host="$(hostname -s)"
job="$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../../installer" && pwd)/footfall.slurm"
export SLURM_CONF="${work}/slurm.conf"
# Two machines that are one must not meet in one folder for temporary files, or in shared memory.
export OMPI_MCA_btl=self,tcp OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
export FOOTFALL_MPI FOOTFALL_WORK="${work}/shares"

fail() {
  echo "failed: $*"
  tail -n 20 "${work}"/*.log "${work}"/job-* 2>/dev/null || true
  exit 1
}
stop() {
  local file pid
  scancel --user=root 2>/dev/null || true
  for file in "${work}"/slurmd-*.pid "${work}/slurmctld.pid" "${work}/munged.pid"; do
    pid="$(cat "${file}" 2>/dev/null || true)"
    [ -z "${pid}" ] || kill "${pid}" 2>/dev/null || true
    for ((i = 0; i < 50; ++i)); do
      if [ -z "${pid}" ] || ! kill -0 "${pid}" 2>/dev/null; then break; fi
      sleep 0.1
    done
  done
  rm -rf -- "${work}"
}
trap stop EXIT

write_configuration() {
  local port=$((20000 + RANDOM % 10000))
  cat >"${SLURM_CONF}" <<END
ClusterName=footfall
SlurmctldHost=${host}(127.0.0.1)
SlurmctldPort=${port}
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=${work}/munge.socket
StateSaveLocation=${work}/state
SlurmdSpoolDir=${work}/spool-%n
SlurmctldPidFile=${work}/slurmctld.pid
SlurmdPidFile=${work}/slurmd-%n.pid
SlurmctldLogFile=${work}/slurmctld.log
SlurmdLogFile=${work}/slurmd-%n.log
TmpFS=${work}/tmp-%n
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SchedulerParameters=batch_sched_delay=0
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SlurmdParameters=config_overrides
ReturnToService=2
KillWait=5
MailProg=/bin/true
NodeName=one NodeHostname=${host} NodeAddr=127.0.0.1 Port=$((port + 1)) CPUs=2 State=UNKNOWN
NodeName=two NodeHostname=${host} NodeAddr=127.0.0.1 Port=$((port + 2)) CPUs=2 State=UNKNOWN
PartitionName=test Nodes=one,two Default=YES MaxTime=10 State=UP
END
}

start_slurm() {
  mkdir "${work}/state" "${work}/tmp-one" "${work}/tmp-two"
  chmod 755 "${work}"
  (umask 077 && head -c 128 /dev/urandom >"${work}/munge.key")
  munged --force --key-file="${work}/munge.key" --socket="${work}/munge.socket" --pid-file="${work}/munged.pid" \
    --log-file="${work}/munged.log" --seed-file="${work}/munged.seed" || skip "munged does not start here"
  slurmctld -f "${SLURM_CONF}" -c || skip "slurmctld does not start here"
  slurmd -f "${SLURM_CONF}" -N one || skip "slurmd does not start here"
  slurmd -f "${SLURM_CONF}" -N two || skip "slurmd does not start here"
  local idle
  for ((i = 0; i < 100; ++i)); do
    idle="$(timeout 10 sinfo --noheader --states=idle --format=%D 2>/dev/null || true)"
    [ "${idle:-0}" != 2 ] || return 0
    sleep 0.1
  done
  tail -n 20 "${work}"/*.log
  skip "Slurm's two machines do not come up here"
}

write_configuration
start_slurm

steps=(--filter "SortedRecursiveStrategy 50 6 true" --filter "SlopeFilter 45" --filter "VerticalClearanceFilter 2"
  --filter Collapse --filter "AreaFilter 1" --filter LayerSubdivisionFilter)
sample="${FOOTFALL_SAMPLES}/docks/docks.obj"
"${FOOTFALL}" run "${sample}" "${steps[@]}" --quiet -o "${work}/one.obj"

# submit ARGUMENT...: on both machines; prints the job's number.
submit() {
  timeout --kill-after 10 300 sbatch --parsable --nodes 2 --chdir "${work}" --output "${work}/job-%j" "${job}" "$@"
}
# run_job ARGUMENT...: the same, and waits for the job; returns its exit code. (sbatch --wait looks 2, 8, 32 s later.)
run_job() {
  local id told
  id="$(submit "$@")" || return $?
  for ((i = 0; i < 1500; ++i)); do
    told="$(timeout 10 scontrol --oneliner show job "${id}" 2>/dev/null || true)"
    case "$(sed -nE 's/.* JobState=([A-Z_]+) .*/\1/p' <<<"${told}")" in
      '' | PENDING | CONFIGURING | RUNNING | COMPLETING) ;;
      COMPLETED | FAILED) return "$(sed -E 's/.* ExitCode=([0-9]+):.*/\1/' <<<"${told}")" ;;
      *)
        echo "${told}"
        return 1
        ;;
    esac
    sleep 0.2
  done
  echo "the job does not end"
  return 1
}

for launch in srun mpirun; do
  if [ "${launch}" = srun ] && ! srun --mpi=list 2>&1 | grep -qw pmix; then continue; fi
  rm -f "${work}/out.obj"
  FOOTFALL_LAUNCH="${launch}" run_job "${sample}" "${steps[@]}" -o "${work}/out.obj" \
    --stats "${work}/stats.json" || fail "by ${launch}: the job ended with $?"
  cmp "${work}/one.obj" "${work}/out.obj" || fail "by ${launch}: other bytes"
  [ "$(grep -c '"bytes_sent"' "${work}/stats.json")" -eq 2 ] || fail "by ${launch}: not two ranks"
  [ "$(grep -c '"threads": 2,' "${work}/stats.json")" -ge 2 ] || fail "by ${launch}: not all threads of the machines"
  [ -z "$(ls "${FOOTFALL_WORK}")" ] || fail "by ${launch}: shares are left"
done

# Cancelled when some cells are done, and given again.
rm -f "${work}/out.obj"
submit "${sample}" "${steps[@]}" -o "${work}/out.obj" || fail "sbatch ended with $?"
for ((i = 0; i < 600; ++i)); do
  kept="$(find "${FOOTFALL_WORK}" -name '*.share' | wc -l)"
  [ "${kept}" -eq 0 ] || break
  sleep 0.05
done
[ "${kept}" -gt 0 ] || fail "no cell was done within half a minute"
scancel --user=root
for ((i = 0; i < 600; ++i)); do
  [ -n "$(squeue --noheader)" ] || break
  sleep 0.1
done
[ -z "$(squeue --noheader)" ] || fail "a cancelled job goes on"
[ ! -f "${work}/out.obj" ] || cmp "${work}/one.obj" "${work}/out.obj" || fail "half a result"
run_job "${sample}" "${steps[@]}" -o "${work}/out.obj" || fail "given again: the job ended with $?"
cmp "${work}/one.obj" "${work}/out.obj" || fail "given again: other bytes"

# What is wrong is told in the job's output, and by its exit code.
code=0
run_job || code=$?
[ "${code}" -eq 2 ] || fail "without an environment: exit code ${code}, not 2"
code=0
run_job "${work}/missing.obj" || code=$?
[ "${code}" -eq 2 ] || fail "an environment that is missing: exit code ${code}, not 2"
grep -q "missing.obj" "${work}"/job-* || fail "nothing is told of an environment that is missing"
# Jobs of the editor, where its tests are built.
editor="not there"
if [ -x "${FOOTFALL_TESTS:-}/test_run_place" ]; then
  editor=tried
  QT_QPA_PLATFORM=offscreen "${FOOTFALL_TESTS}/test_run_place" machinesOfSlurm >"${work}/editor.log" 2>&1 ||
    fail "jobs of the editor"
fi
echo "the same by srun, by mpirun and behind a cancelled job that left ${kept} shares; jobs of the editor: ${editor}"
