#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Lets libFuzzer look for inputs that no loader stands, under AddressSanitizer and UBSan.
#   scripts/fuzz.sh [SECONDS [LOADER...]]      600 s for each of all loaders
# What it found stands in build/fuzz/found/LOADER; put it into tests/data/fuzz/LOADER, where the normal
# suite tries it for ever, and mend the loader. The corpus grows in build/fuzz/corpus.
set -euo pipefail
cd "$(dirname "$0")/.."
. scripts/prepare.sh
seconds=${1:-600}
shift || true
placode_install clang libclang-rt-14-dev
placode_prepare fuzz fuzz
fuzz=build/fuzz/tests/fuzz
export PLACODE_STATION_KEY=$PWD/build/fuzz/station.key
loaders=("$@")
[ ${#loaders[@]} -gt 0 ] || mapfile -t loaders < <("$fuzz" --list)
status=0
printf '%-20s %12s %8s\n' loader executions found
for loader in "${loaders[@]}"; do
  export PLACODE_LOADER=$loader
  corpus=build/fuzz/corpus/$loader found=build/fuzz/found/$loader log=build/fuzz/$loader.log
  mkdir -p "$corpus" "$found"
  "$fuzz" --seeds "$corpus"
  ended=0
  "$fuzz" -max_total_time="$seconds" -max_len=65536 -timeout=20 -rss_limit_mb=2048 -malloc_limit_mb=512 \
    -print_final_stats=1 -artifact_prefix="$found/" "$corpus" >"$log" 2>&1 || ended=1
  runs=$(awk '/stat::number_of_executed_units/ {print $2}' "$log")
  bad=$(find "$found" -type f | wc -l)
  # A fuzzer that could not run has found nothing either.
  [ "$bad" -gt 0 ] || bad=$ended
  [ "$bad" -eq 0 ] || status=1
  printf '%-20s %12s %8s\n' "$loader" "${runs:-0}" "$bad"
  [ -z "${PLACODE_BARS:-}" ] || echo "fuzzed: $loader,${runs:-0},$bad,$seconds" >>"$PLACODE_BARS"
done
exit "$status"
