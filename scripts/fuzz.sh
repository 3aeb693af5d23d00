#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Lets libFuzzer look for inputs that no loader stands, under AddressSanitizer and UBSan, as many loaders at
# once as there are processors.
#   scripts/fuzz.sh [SECONDS [LOADER...]]      600 s for each of all loaders, or five million inputs
#   scripts/fuzz.sh --list                     builds, and says which loaders there are
# What it found stands in build/fuzz/found/LOADER; put it into tests/data/fuzz/LOADER, where the normal
# suite tries it for ever, and mend the loader. The corpus grows in build/fuzz/corpus.
set -euo pipefail
cd "$(dirname "$0")/.."
export fuzz=build/fuzz/tests/fuzz
# Short traces of who allocated, and less kept of what was freed: a quarter more executions. Who looks at
# a finding sets other options.
export ASAN_OPTIONS=${ASAN_OPTIONS:-malloc_context_size=2:quarantine_size_mb=16}

# Half of the loaders read files, one file an input: into memory, not onto a disk.
[ ! -w /dev/shm ] || export TMPDIR=/dev/shm

# fuzz_one LOADER: a line of the table. A station key of its own, because several run at once.
fuzz_one() {
  local corpus=build/fuzz/corpus/$1 found=build/fuzz/found/$1 log=build/fuzz/$1.log ended=0 begun=$SECONDS
  export PLACODE_LOADER=$1 PLACODE_STATION_KEY=$PWD/build/fuzz/$1.key
  mkdir -p "$corpus" "$found"
  "$fuzz" --seeds "$corpus.seeds"
  # The seeds are short, and what grows is let grow to twice the longest: what is long for its own sake has
  # limits of its own, which tests hold. Entropic scheduling takes longer here than most loaders.
  local longest
  longest=$(find "$corpus.seeds" -type f -printf '%s\n' | sort -n | tail -n 1)
  longest=$((longest * 2 < 4096 ? 4096 : longest * 2))
  "$fuzz" -max_total_time="$seconds" -runs=5000000 -max_len="$longest" -entropic=0 -timeout=20 -rss_limit_mb=2048 \
    -malloc_limit_mb=512 -print_final_stats=1 -artifact_prefix="$found/" "$corpus" "$corpus.seeds" >"$log" 2>&1 || ended=1
  local runs bad
  runs=$(awk '/stat::number_of_executed_units/ {print $2}' "$log")
  bad=$(find "$found" -type f | wc -l)
  # A fuzzer that could not run has found nothing either.
  [ "$bad" -gt 0 ] || bad=$ended
  printf '%-20s %12s %8s\n' "$1" "${runs:-0}" "$bad"
  [ -z "${PLACODE_BARS:-}" ] || echo "fuzzed: $1,${runs:-0},$bad,$((SECONDS - begun))" >>"$PLACODE_BARS"
  [ "$bad" -eq 0 ]
}
export -f fuzz_one

# long.sh calls this for one loader at a time, beside itself: built already.
if [ "${1:-}" != --built ]; then
  . scripts/prepare.sh
  placode_install clang libclang-rt-14-dev >&2
  placode_prepare fuzz fuzz >&2
else
  shift
fi
[ "${1:-}" != --list ] || exec "$fuzz" --list
export seconds=${1:-600}
shift || true
loaders=("$@")
if [ ${#loaders[@]} -eq 0 ]; then
  mapfile -t loaders < <("$fuzz" --list)
  printf '%-20s %12s %8s\n' loader executions found
fi
printf '%s\n' "${loaders[@]}" | xargs -P "$(nproc)" -I '{}' bash -c 'fuzz_one "{}"' || exit 1
