#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Checks that the test suite does not make. Each ends with an error when something is wrong.
#   scripts/check.sh format            clang-format over every C++ file
#   scripts/check.sh tidy [COMMITS]    clang-tidy over what the last COMMITS (10) changed, at most 12 files
#   scripts/check.sh debug|asan [PART] physics, haptics, scoring and tasks with assertions or sanitizers
#   scripts/check.sh tsan [PART]       what has threads, with the thread sanitizer
# PART: 2/4 = the second of four parts of the tests.
set -euo pipefail
cd "$(dirname "$0")/.."
mkdir -p build
export XDG_RUNTIME_DIR=${XDG_RUNTIME_DIR:-$(d=/tmp/placode-runtime-$(id -u); mkdir -p -m 700 "$d"; echo "$d")}

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
  cmake --preset release -B build/tidy -DPLACODE_PRECOMPILED_HEADERS=OFF -DPLACODE_UNITY=OFF >build/tidy.log 2>&1
  local files
  # Tests are left out: they include generated files that only a build makes.
  mapfile -t files < <(git log -n "${1:-10}" --name-only --format= -- '*.cpp' | grep -v '^tests/' |
    awk '!seen[$0]++' | while read -r f; do [ -f "$f" ] && echo "$f"; done | head -n 12)
  [ ${#files[@]} -gt 0 ] || { echo "check.sh: tidy: nothing changed"; return 0; }
  printf '%s\n' "${files[@]}" | xargs -P "$(nproc)" -n 1 clang-tidy -p build/tidy --quiet --extra-arg=-Wno-unknown-warning-option 2>/dev/null
  echo "check.sh: tidy: ${files[*]}"
}

# check_findings PRESET LOG: what failed, and why. With the address sanitizer a test that was only too slow is named
# and is no failure; elsewhere it may hang.
check_findings() {
  local preset=$1
  shift
  grep -E -A 30 -m 3 'ERROR: |WARNING: Thread|runtime error|Assertion|\*\*\*' "$1" || true
  grep -E '^\s+[0-9]+ - ' "$1" && [ "$preset" = asan ] || return 1
  ! grep -E '^\s+[0-9]+ - ' "$1" | grep -qvE '\((Timeout|Skipped)\)'
}

# check_build PRESET TARGET LABEL PART TESTS_LEFT_OUT
check_build() {
  local preset=$1 log=build/$1.log part=()
  [[ $4 =~ ^$|^([0-9]+)/([0-9]+)$ ]] || { echo "check.sh: part \"$4\"; expected one as 2/4"; return 2; }
  [ -z "$4" ] || part=(-I "${BASH_REMATCH[1]},,${BASH_REMATCH[2]}")
  cmake --preset "$preset" >"$log" 2>&1 || { tail -n 15 "$log"; return 1; }
  echo "check.sh: $preset: building"
  ninja -k 0 -C "build/$preset" "$2" >"$log" 2>&1 || { grep -E -m 5 'error|FAILED' "$log"; return 1; }
  echo "check.sh: $preset: built in $SECONDS s"
  ctest --test-dir "build/$preset" -L "$3" -E "$5" "${part[@]}" -j "$(nproc)" --output-on-failure >"$log" 2>&1 ||
    { check_findings "$preset" "$log" || return 1; }
  grep 'tests passed' "$log"
}
# Whole attempts of scripted operators take too long here, and other tests take the same paths.
slow='operator_levels_test|lift_operator_test|practice_operator_test|mouse_person_device_test|whole_state_test|frame_allocation_test|suture_run_test|suture_slit_test|wound_closure_test'

case "${1:-}" in
  format) check_format ;;
  tidy) check_tidy "${2:-}" ;;
  debug) check_build debug core_tests core "${2:-}" "$slow" ;;
  asan) check_build asan core_tests core "${2:-}" "accuracy_test|$slow" ;;
  tsan) check_build tsan threaded_tests threads "${2:-}" '^$' ;;
  *) sed -n 's/^#   //p' "$0"; exit 2 ;;
esac
