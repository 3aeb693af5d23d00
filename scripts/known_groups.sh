#!/bin/sh
# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
# Scripted operators of three levels on the same lesions, and what the score makes of them:
#   scripts/known_groups.sh TASK FOLDER [FIRST_SEED [SEEDS]]
# Recordings that are there are kept, so that it can be broken off and gone on with. One attempt at a
# time, at the lowest priority.
set -eu
task=${1:?task} folder=${2:?folder} first=${3:-1} seeds=${4:-30}
bin=$(dirname "$0")/../build/release/bin
mkdir -p "$folder"
seed=$first
while [ "$seed" -lt $((first + seeds)) ]; do
    for level in expert intermediate novice; do
        file=$folder/$task-$level-$seed.placode
        [ -s "$file" ] && continue
        rm -f "$file.part" "$file.part-journal"  # of a run that was broken off: nothing is overwritten
        nice -n 19 "$bin/placode-sim" --task "$task" --seed "$seed" --device "script:$level" \
            --headless --fast --threads 1 --record "$file.part" >/dev/null
        mv "$file.part" "$file"
    done
    seed=$((seed + 1))
done
"$bin/placodectl" norms quality "$task" --recordings "$folder"
