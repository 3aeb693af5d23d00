#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Checks that the test suite does not make. Each ends with an error when something is wrong.
#   scripts/check.sh format            clang-format over every C++ file
#   scripts/check.sh tidy [COMMITS]    clang-tidy over what the last COMMITS (10) changed, at most 12 files
#   scripts/check.sh asan|tsan|debug   physics, haptics, scoring and tasks with a sanitizer or assertions
#   scripts/check.sh turn              one of asan, tsan, debug, by the time of the last commit
# PLACODE_CHECK_S: seconds that a sanitizer may take (default: no limit). What was not reached is told.
set -euo pipefail
cd "$(dirname "$0")/.."

need() {
  command -v "$1" >/dev/null && return
  echo "check.sh: $1 is not installed, its check was left out (apt-get install $1)"
  return 1
}

check_format() {
  need clang-format || return 0
  git ls-files '*.cpp' '*.h' | xargs clang-format --dry-run -Werror
  echo "check.sh: format: $(git ls-files '*.cpp' '*.h' | wc -l) files"
}

check_tidy() {
  need clang-tidy || return 0
  # clang cannot read g++'s precompiled headers: a build folder that has none, for its commands only.
  cmake --preset release -B build/tidy -DPLACODE_PRECOMPILED_HEADERS=OFF >build/tidy.log 2>&1
  local files
  # Tests are left out: they include generated files that only a build makes.
  mapfile -t files < <(git log -n "${1:-10}" --name-only --format= -- '*.cpp' | grep -v '^tests/' |
    awk '!seen[$0]++' | while read -r f; do [ -f "$f" ] && echo "$f"; done | head -n 12)
  [ ${#files[@]} -gt 0 ] || { echo "check.sh: tidy: nothing changed"; return 0; }
  printf '%s\n' "${files[@]}" | xargs -P "$(nproc)" -n 1 clang-tidy -p build/tidy --quiet 2>/dev/null
  echo "check.sh: tidy: ${files[*]}"
}

check_build() {
  local preset=$1 limit=${PLACODE_CHECK_S:-0} start=$SECONDS status=0
  cmake --preset "$preset" >"build/$preset.log" 2>&1 || { tail -n 15 "build/$preset.log"; return 1; }
  echo "check.sh: $preset: building"
  timeout "$limit" ninja -C "build/$preset" core_tests >"build/$preset.log" 2>&1 || status=$?
  if [ "$status" = 124 ]; then
    echo "check.sh: $preset: out of time while building ($(tail -n 1 "build/$preset.log"))"
    return 0
  fi
  [ "$status" = 0 ] || { grep -E -m 5 'error|FAILED' "build/$preset.log"; return 1; }
  local left=0
  [ "$limit" = 0 ] || left=$((limit - (SECONDS - start)))
  [ "$left" -ge 0 ] || left=1
  # Whole attempts of scripted operators take too long here, and other tests take the same paths.
  timeout "$left" ctest --test-dir "build/$preset" -L core -E "$slow" -j "$(nproc)" --timeout 900 \
    --output-on-failure >"build/$preset.log" 2>&1 || status=$?
  grep -E 'tests passed|Failed|Timeout' "build/$preset.log" || true
  if [ "$status" = 124 ]; then
    echo "check.sh: $preset: out of time after $(grep -c ' Passed ' "build/$preset.log") tests"
    ! grep -q '\*\*\*Failed' "build/$preset.log"
    return
  fi
  [ "$status" = 0 ] || { grep -E -A 30 -m 3 'ERROR: |WARNING: Thread|runtime error|Assertion' "build/$preset.log"; return 1; }
  echo "check.sh: $preset: passed, $((SECONDS - start)) s"
}
slow='operator_levels_test|lift_operator_test|practice_operator_test|whole_state_test|frame_allocation_test'

case "${1:-}" in
  format) check_format ;;
  tidy) check_tidy "${2:-}" ;;
  asan | tsan | debug) check_build "$1" ;;
  turn)
    turns=(asan tsan debug)
    check_build "${turns[$(($(git log -1 --format=%ct) / 60 % 3))]}"
    ;;
  *) sed -n 's/^#   //p' "$0"; exit 2 ;;
esac
