#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Installs what is missing, builds everything and runs all tests; under Xvfb where there is no display.
#   ./test.sh [CTEST ARGUMENTS]        e.g. ./test.sh -R contact
#   ./test.sh --long [SECONDS]         what takes hours, as often as it should be tried (scripts/long.sh)
set -euo pipefail
cd "$(dirname "$0")"
. scripts/prepare.sh
# A batch goes through a Slurm of the test's own. Whoever only runs Placode needs none of it.
placode_install slurmctld slurmd slurm-client munge
placode_prepare release all
[ "${1:-}" != --long ] || exec scripts/long.sh "${@:2}"
built_s=$SECONDS
export XDG_RUNTIME_DIR=${XDG_RUNTIME_DIR:-$(d=/tmp/placode-runtime-$(id -u); mkdir -p -m 700 "$d"; echo "$d")}

log=build/release/test.log
# One more than there are cores: while one waits for a window, a server or a clock, another computes. Tests
# that no lateness may touch count as two (tests/CMakeLists.txt).
run=(ctest --test-dir build/release --output-on-failure -j "$(($(nproc) + 1))" "$@")
if [ -z "${DISPLAY:-}" ]; then
  run=(xvfb-run -a -s "-screen 0 1600x1000x24 +extension GLX" "${run[@]}")
fi
status=0
"${run[@]}" 2>&1 | tee "$log" || status=$?
total=$(grep -cE '^ *[0-9]+/[0-9]+ Test +#' "$log" || true)
passed=$(grep -cE '^ *[0-9]+/[0-9]+ Test +#.* Passed ' "$log" || true)
echo "built in $built_s s, tested in $((SECONDS - built_s)) s"
echo "$passed passed, $((total - passed)) failed"
[ "$total" -gt 0 ] || { echo "test.sh: no test ran" >&2; exit 1; }
exit "$status"
