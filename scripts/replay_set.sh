#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Proves that a change leaves the bits of the simulation as they were: record every task before it,
# replay all recordings after it.
#   scripts/replay_set.sh record FOLDER [SECONDS]   the scripted expert does each task, seed 1, at most
#                                                   so long (600); attempts are not cut off before
#   scripts/replay_set.sh check FOLDER              exit status 1 when a recording replays otherwise
# Two at a time, on one thread each.
set -euo pipefail
cd "$(dirname "$0")/.."
sim=$PWD/build/release/bin/placode-sim
usage() { sed -n '5,10s/^# \{0,1\}//p' "$0" >&2; exit 2; }

record() {  # TASK: one recording, written whole or not at all
  local part=$folder/$1.part.placode status=0
  rm -f "$part" "$part-journal"  # of a run that was broken off: nothing is overwritten
  "$sim" --task "$1" --device script:expert --seed 1 --headless --fast --threads 1 --duration "$seconds" \
    --record "$part" >"$folder/$1.log" 2>&1 || status=$?
  if [ "$status" -ne 0 ] || [ ! -s "$part" ]; then
    echo "$1: exit status $status; see $folder/$1.log"
    return 1
  fi
  mv "$part" "$folder/$1.placode"
  echo "$1: recorded"
}

check() {  # FILE: replays it and compares the hash of each frame
  local said
  said=$("$sim" --device "play:$1" --headless --fast --threads 1 2>&1 | grep '^replay:' || true)
  echo "$(basename "$1" .placode): ${said:-no answer}"
  [ "$said" = "replay: identical" ]
}

[ $# -ge 2 ] || usage
[ -x "$sim" ] || { echo "$sim is missing; build it: cmake --preset release && ninja -C build/release placode-sim" >&2; exit 2; }
command=$1 folder=$2
shift 2
export sim folder
export -f record check
case $command in
  record)
    seconds=${1:-600}
    [[ $seconds =~ ^[0-9]+$ ]] || { echo "seconds \"$seconds\"; expected a whole number" >&2; exit 2; }
    export seconds
    mkdir -p "$folder"
    folder=$(cd "$folder" && pwd)
    basename -s .json data/tasks/*.json | xargs -P 2 -I '{}' bash -c 'record "{}"'
    ;;
  check)
    ls "$folder"/*.placode >/dev/null 2>&1 || { echo "no recordings in $folder; make some: $0 record $folder" >&2; exit 2; }
    printf '%s\n' "$folder"/*.placode | xargs -P 2 -I '{}' bash -c 'check "{}"' || { echo "some differ" >&2; exit 1; }
    ;;
  *) usage ;;
esac
