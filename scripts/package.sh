#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Builds the packages in build/packages: .deb for Debian 12 (placode: all that a training centre needs; libplacode1,
# libplacode-dev and python3-placode: for researchers), and a .tar.zst that runs from any folder on such a
# system. Installs what is missing for that, as run.sh does.
set -euo pipefail
cd "$(dirname "$0")/.."
. scripts/prepare.sh
placode_prepare release placode placode-sim placodectl placode-web placode_interface placode_python
placode_install help2man lintian dpkg-dev file
ninja -C build/release pages >build/release/pages.log 2>&1 || { tail -n 5 build/release/pages.log; exit 1; }
out=$PWD/build/packages
rm -rf "$out"
mkdir -p "$out"
(cd build/release && cpack -B "$out" >cpack.log 2>&1) || { tail -n 10 build/release/cpack.log; exit 1; }
rm -rf "$out/_CPack_Packages"
# As the manual says where it is. A prefix for all generators would put usr/ before it.
cmake -E tar tf "$out"/*.tar.zst | grep '^[^/]*/bin/placode$' >/dev/null ||
  { echo "scripts/package.sh: the archive has no bin/placode in its folder"; exit 1; }
lintian --fail-on error,warning --tag-display-limit 0 "$out"/*.deb
ls -l "$out"
