#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Uses the packages in build/packages (scripts/package.sh makes them) as a centre would, in a bare Debian 12: install,
# first window, first exercise, a score, the researchers' packages, an upgrade with that store, removal. Needs root and
# a network; makes the system once with debootstrap, in ~/.cache/placode/bare. Pictures: build/packages/seen.
set -euo pipefail
cd "$(dirname "$0")/.."
. scripts/prepare.sh
placode_install debootstrap
packages=$PWD/build/packages
[ -e "$packages"/placode_*.deb ] || placode_fail "no package in build/packages; run scripts/package.sh first"
base=$HOME/.cache/placode/bare
if [ ! -e "$base/etc/debian_version" ]; then
  echo "making a bare Debian 12"
  mkdir -p "$base"
  mirror=$({ cat /etc/apt/sources.list /etc/apt/sources.list.d/*.sources 2>/dev/null || true; } |
    grep -oE -m1 'https?://[^ ]+/debian/?( |$)' | tr -d ' ' || true)
  debootstrap --variant=minbase --include=ca-certificates bookworm "$base" $mirror >"$base.log" 2>&1 ||
    { rm -rf "$base"; placode_fail "debootstrap failed (log: $base.log)"; }
fi
root=$(mktemp -d "$base.XXXXXX")
trap 'rm -rf --one-file-system "$root"' EXIT
cp -a --reflink=auto "$base/." "$root/"
for file in /etc/resolv.conf /etc/hosts /etc/apt/sources.list; do [ ! -e $file ] || cp -L $file "$root$file"; done
for folder in /etc/apt/apt.conf.d /etc/apt/sources.list.d /usr/share/keyrings; do cp -aL $folder/. "$root$folder/"; done
mkdir -p "$root/root/packages"
cp "$packages"/*.deb scripts/check_packages_inside.sh "$root/root/packages/"
status=0
unshare --mount --propagation private /bin/bash -c '
  root=$1
  mount -t proc proc "$root/proc"; mount -t sysfs sys "$root/sys"; mount --rbind /dev "$root/dev"
  exec env -i HOME=/root PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 TERM=dumb \
    DEBIAN_FRONTEND=noninteractive ${http_proxy:+http_proxy=$http_proxy} ${https_proxy:+https_proxy=$https_proxy} \
    chroot "$root" /bin/bash /root/packages/check_packages_inside.sh' x "$root" </dev/null || status=$?
rm -rf "$packages/seen"
cp -r "$root/root/seen" "$packages/" 2>/dev/null || true
exit $status
