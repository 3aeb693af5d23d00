#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The portal in a real browser: every page with axe, the review of an attempt, pictures of all in
# build/portal. Needs chromium, nodejs and npm, which fetches axe-core and puppeteer-core.
#   scripts/portal/check.sh [TASK [SECONDS]]    the attempt that is looked at (diathermy_ring_small, 8 s)
set -euo pipefail
cd "$(dirname "$0")/../.."
task=${1:-diathermy_ring_small} seconds=${2:-8}
for program in chromium node npm; do
  command -v "$program" >/dev/null || { echo "portal/check.sh: $program is not installed (apt-get install chromium nodejs npm)"; exit 1; }
done
bin=build/release/bin here=build/portal
[ -x "$bin/placode-web" ] || { echo "portal/check.sh: build first: ./run.sh or ./test.sh"; exit 1; }
rm -rf "$here/store" "$here/pictures"
mkdir -p "$here/store" "$here/pictures"
cp scripts/portal/check.mjs "$here/"
(cd "$here" && npm install --silent --no-save --no-package-lock axe-core@4 puppeteer-core@24 >npm.log 2>&1) ||
  { tail -n 5 "$here/npm.log"; exit 1; }
export PLACODE_STATION_KEY=$PWD/$here/store/station.key
store=sqlite:$PWD/$here/store/placode.db
"$bin/placodectl" --store "$store" demo --attempts 0 >"$here/demo.log"
"$bin/placode-sim" --task "$task" --device script:expert --headless --fast --duration "$seconds" \
  --record "$here/store/a.placode" >/dev/null
"$bin/placodectl" --store "$store" import "$here/store/a.placode" --user demo-anna >"$here/demo.log"
attempt=$(grep -o 'attempt [0-9]*' "$here/demo.log" | grep -o '[0-9]*')
"$bin/placode-web" --store "$store" --listen 127.0.0.1:0 >"$here/web.log" 2>&1 &
trap 'kill %1' EXIT
for _ in $(seq 50); do grep -q listening "$here/web.log" && break || sleep 0.1; done
address=$(grep -o 'http://[^,]*' "$here/web.log")
node "$here/check.mjs" "$address" demo-educator placode-demo "$here/pictures" "$attempt"
