#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# What takes hours: the tests that know a long form, then the fuzz targets, as many at once as there are
# processors; ends with a table of what was tried and what failed. Called by
#   ./test.sh --long [SECONDS [NAME...]]      of each fuzz target, 600; 0 = none
# With names (tests, fuzz targets) only these are tried again, after a change: their lines take the place
# of those of the last run, with a star.
set -euo pipefail
cd "$(dirname "$0")/.."
seconds=${1:-600}
names=("${@:2}")
export logs=build/release/long
run=run
if [ ${#names[@]} -gt 0 ]; then
  [ -f "$logs/run" ] || { echo "long.sh: there is no run to add to; leave out the names" >&2; exit 2; }
  run=again
fi
export PLACODE_LONG_TESTS=1 PLACODE_BARS=$PWD/$logs/$run.csv
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

wanted() { [ ${#names[@]} -eq 0 ] || [[ " ${names[*]} " == *" $1 "* ]]; }

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

# The table for readers.
report() {
  echo '# A long run'
  echo
  echo "Written by \`./test.sh --long\`: $(cat "$logs/run"). \`fuzzed\` counts executions."
  [ ! -f "$logs/again" ] || echo "Lines with a star were tried again after a change: $(cat "$logs/again")."
  echo
  echo '| what was tried | times | failed | seconds |'
  echo '|---|---|---|---|'
  for file in run again; do sed "s/^/$file,/" "$logs/$file.csv" 2>/dev/null || true; done |
    awk -F, '{if ($1 == "again" && !($2 in again)) {again[$2]; times[$2] = failed[$2] = took[$2] = 0}
        times[$2] += $3; failed[$2] += $4; took[$2] += $5; if (!($2 in seen)) {seen[$2]; name[++n] = $2}}
      END {for (i = 1; i <= n; ++i) {m = name[i]
        printf "| %s%s | %d | %d | %.0f |\n", m, m in again ? " *" : "", times[m], failed[m], took[m]}}'
}

# The fuzz targets are built first: a build that fails shows at once.
fuzzed=
[ "$seconds" -eq 0 ] || fuzzed=$(scripts/fuzz.sh --list)
status=0
work=$(
  tests | while read -r call name preload; do ! wanted "$name" || echo "$call $name $preload"; done
  for loader in $fuzzed; do ! wanted "$loader" || echo "scripts/fuzz.sh --built $seconds $loader"; done
)
for name in "${names[@]}"; do
  grep -qE "^long_test $name( |\$)|--built $seconds $name\$" <<<"$work" ||
    { echo "long.sh: $name is no test with a long form and no fuzz target" >&2; exit 2; }
done
# Only now, when there is something to put in its place.
if [ "$run" = again ]; then rm -f "$logs/again"*; else rm -rf "$logs"; fi
mkdir -p "$logs"
touch "$PLACODE_BARS"
xargs -P "$(nproc)" -I '{}' bash -c '{}' <<<"$work" || status=1

echo
printf '%-44s %12s %8s %8s\n' 'what was tried' times failed seconds
awk -F, '{printf "%-44s %12d %8d %8.0f\n", $1, $2, $3, $4; if ($3 > 0) bad = 1} END {exit bad}' "$PLACODE_BARS" || status=1
machine="$(date -u +%F), $(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1), $(nproc) cores, $commit, $SECONDS s in all"
echo "$machine; logs: $logs"
echo "$machine" >"$logs/$run"
report >"$logs/long-run.md"  # Commit it when the run was whole.
echo "for docs/measurements: $logs/long-run.md"
exit "$status"
