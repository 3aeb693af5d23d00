#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# What takes hours: the tests that know a long form, then the fuzz targets, as many at once as there are
# processors; ends with a table of what was tried and what failed. Called by
#   ./test.sh --long [SECONDS]      of each fuzz target, 600; 0 = none
set -euo pipefail
cd "$(dirname "$0")/.."
seconds=${1:-600}
export logs=build/release/long
rm -rf "$logs"
mkdir -p "$logs"
export PLACODE_LONG_TESTS=1 PLACODE_BARS=$PWD/$logs/bars.csv
touch "$PLACODE_BARS"
# What is tried, whatever is committed in these hours.
commit=$(git rev-parse --short HEAD 2>/dev/null || echo 'no commit')

# long_test NAME: a station key of its own, because several run at once; passwords cost what they cost
# people only where that is what is tested, as in the suite.
long_test() {
  local begun=$SECONDS result=passed status=0
  env PLACODE_STATION_KEY="$PWD/$logs/$1.key" PLACODE_LOG="$PWD/$logs/$1" ${2:+LD_PRELOAD="$2"} \
    "build/release/tests/$1" >"$logs/$1.log" 2>&1 || { result=FAILED status=1; }
  printf '%-32s %-7s %6d s\n' "$1" "$result" $((SECONDS - begun))
  return "$status"
}
export -f long_test

# Each test and what it wants to be loaded first.
preloads() {
  ctest --test-dir build/release --show-only=json-v1 | python3 -c '
import json, sys
for test in json.load(sys.stdin)["tests"]:
    values = [v for p in test["properties"] if p["name"] == "ENVIRONMENT" for v in p["value"]]
    print(test["name"], *[v.split("=", 1)[1] for v in values if v.startswith("LD_PRELOAD=")])'
}

# What takes longest begins first.
tests() {
  local headers file
  # A header of the tests may bring the long form along.
  headers=$(grep -lE 'tests/bars.h|PLACODE_LONG_TESTS' tests/*.h | paste -sd'|')
  for file in random_kills_test disk_faults_test replay_check_test \
    $(grep -lE "tests/bars.h|PLACODE_LONG_TESTS|$headers" tests/*_test.cpp); do
    basename "$file" .cpp
  done | awk 'NR == FNR {preload[$1] = $2; next} !seen[$1]++ {print "long_test", $1, preload[$1]}' <(preloads) -
}

# The fuzz targets are built first: a build that fails shows at once.
fuzzed=
[ "$seconds" -eq 0 ] || fuzzed=$(scripts/fuzz.sh --list)
status=0
{
  tests
  for loader in $fuzzed; do echo "scripts/fuzz.sh --built $seconds $loader"; done
} | xargs -P "$(nproc)" -I '{}' bash -c '{}' || status=1

echo
printf '%-44s %12s %8s %8s\n' 'what was tried' times failed seconds
awk -F, '{printf "%-44s %12d %8d %8.0f\n", $1, $2, $3, $4; if ($3 > 0) bad = 1} END {exit bad}' "$PLACODE_BARS" || status=1
machine="$(date -u +%F), $(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1), $(nproc) cores, $commit, $SECONDS s in all"
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
