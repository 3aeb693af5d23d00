#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# What takes hours: the tests that know a long form, then the fuzz targets; ends with a table of what
# was tried and what failed. Called by `./test.sh --long [SECONDS]` (of each fuzz target, 600; 0 = none).
set -euo pipefail
cd "$(dirname "$0")/.."
seconds=${1:-600}
logs=build/release/long
rm -rf "$logs"
mkdir -p "$logs"
export PLACODE_LONG_TESTS=1 PLACODE_BARS=$PWD/$logs/bars.csv PLACODE_STATION_KEY=$PWD/$logs/station.key
touch "$PLACODE_BARS"
status=0
# A header of the tests may bring the long form along.
headers=$(grep -lE 'tests/bars.h|PLACODE_LONG_TESTS' tests/*.h | paste -sd'|')
for file in $(grep -lE "tests/bars.h|PLACODE_LONG_TESTS|$headers" tests/*_test.cpp); do
  name=$(basename "$file" .cpp)
  begun=$SECONDS
  result=passed
  "build/release/tests/$name" >"$logs/$name.log" 2>&1 || { result=FAILED; status=1; }
  printf '%-32s %-7s %6d s\n' "$name" "$result" $((SECONDS - begun))
done
[ "$seconds" -eq 0 ] || scripts/fuzz.sh "$seconds" || status=1

echo
printf '%-44s %12s %8s %8s\n' 'what was tried' times failed seconds
awk -F, '{printf "%-44s %12d %8d %8.0f\n", $1, $2, $3, $4; if ($3 > 0) bad = 1} END {exit bad}' "$PLACODE_BARS" || status=1
machine="$(date -u +%F), $(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1), $(nproc) cores, $(git rev-parse --short HEAD 2>/dev/null || echo 'no commit'), $SECONDS s in all"
echo "$machine; logs: $logs"
# The same for readers; commit it when the run was whole.
{
  echo '# A long run'
  echo
  echo "Written by \`./test.sh --long\`: $machine. \`fuzzed\` counts executions."
  echo
  echo '| what was tried | times | failed | seconds |'
  echo '|---|---|---|---|'
  awk -F, '{times[$1] += $2; failed[$1] += $3; took[$1] += $4; if (!($1 in seen)) {seen[$1]; name[++n] = $1}}
    END {for (i = 1; i <= n; ++i) printf "| %s | %d | %d | %.0f |\n", name[i], times[name[i]], failed[name[i]], took[name[i]]}' "$PLACODE_BARS"
} >"$logs/long-run.md"
echo "for docs/measurements: $logs/long-run.md"
exit "$status"
