#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Installs what is missing, builds, and starts Placode.
#   ./run.sh           the shell on your own store
#   ./run.sh --demo    the shell on a demonstration store with really simulated attempts
# Without a display it performs one demonstration attempt headless and prints its score.
set -euo pipefail
cd "$(dirname "$0")"
. scripts/prepare.sh

demo=0
shell_arguments=()
for argument in "$@"; do
  case "$argument" in
    --demo) demo=1 ;;
    -h|--help) sed -n '5,8p' "$0" | sed 's/^# \{0,1\}//'; exit 0 ;;
    *) shell_arguments+=("$argument") ;;
  esac
done

placode_prepare release placode placode-sim placodectl
bin=$PWD/build/release/bin
export XDG_RUNTIME_DIR=${XDG_RUNTIME_DIR:-$(d=/tmp/placode-runtime-$(id -u); mkdir -p -m 700 "$d"; echo "$d")}

data=${XDG_DATA_HOME:-$HOME/.local/share}/placode
if [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]; then
  if [ "$demo" = 1 ]; then
    store="sqlite:$data/demonstration.db"
    echo "placode: preparing the demonstration store (scripted operators, about three minutes the first time)"
    "$bin/placodectl" --store "$store" demo --attempts 3
    exec "$bin/placode" --store "$store" ${shell_arguments[@]+"${shell_arguments[@]}"}
  fi
  exec "$bin/placode" ${shell_arguments[@]+"${shell_arguments[@]}"}
fi

# No display: the same job without a window.
echo "placode: there is no display, so the demonstration trainee operates headless (script:intermediate)"
out=$PWD/build/headless-demo
store="sqlite:$data/demonstration.db"
mkdir -p "$data"
rm -rf "$out"
mkdir -p "$out/screenshots"
"$bin/placodectl" --store "$store" demo --attempts 0 >/dev/null
"$bin/placode-sim" --task diathermy_ring --device script:intermediate --headless --fast --demonstration \
  --record "$out/attempt.placode" --screenshots "$out/screenshots:10" --size 960x720
id=$("$bin/placodectl" --store "$store" --json import "$out/attempt.placode" --user demo-anna | sed -n 's/.*"attempt": *\([0-9]*\).*/\1/p')
"$bin/placodectl" score "$out/attempt.placode"
"$bin/placodectl" --store "$store" report attempt "$id" --out "$out/attempt.pdf" >/dev/null
echo
echo "saved as attempt $id of demo-anna in $store (demonstration)"
echo "recording    $out/attempt.placode"
echo "report       $out/attempt.pdf"
echo "screenshots  $out/screenshots"
