#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Installs what is missing and builds. Sourced by run.sh and test.sh:
#   placode_prepare PRESET TARGETS...
# Does nothing (and needs no network) when packages and build are up to date.

placode_fail() { printf 'placode: %s\n' "$*" >&2; exit 1; }

# placode_install PACKAGES...: those that are missing
placode_install() {
  command -v dpkg-query >/dev/null || placode_fail "this is not a Debian system: install the packages named in packages.txt, then build with cmake --preset release"
  local wanted=("$@") missing=()
  local have
  have=$(dpkg-query -W -f='${Package} ${db:Status-Status}\n' "${wanted[@]}" 2>/dev/null | awk '$2=="installed"{print $1}' || true)
  local package
  for package in "${wanted[@]}"; do
    grep -qxF "$package" <<<"$have" || missing+=("$package")
  done
  [ ${#missing[@]} -gt 0 ] || return 0
  echo "placode: ${#missing[@]} packages are missing; installing them with apt:"
  printf '  %s\n' "${missing[*]}" | fold -s -w 100
  local sudo=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || placode_fail "installing needs root and there is no sudo; run as root: apt-get install ${missing[*]}"
    sudo=(sudo)
  fi
  export DEBIAN_FRONTEND=noninteractive
  "${sudo[@]}" apt-get update -qq || placode_fail "apt-get update failed: check the network and /etc/apt/sources.list, then run this again"
  "${sudo[@]}" apt-get install -y -qq --no-install-recommends "${missing[@]}" >/tmp/placode-apt.log 2>&1 ||
    { tail -n 5 /tmp/placode-apt.log; placode_fail "apt could not install the packages (log: /tmp/placode-apt.log)"; }
}

placode_prepare() {
  local preset=$1; shift
  cd "$(dirname "${BASH_SOURCE[0]}")/.." || exit 1
  local wanted
  mapfile -t wanted < <(sed -e 's/#.*//' -e '/^[[:space:]]*$/d' packages.txt)
  placode_install "${wanted[@]}"
  local build=build/$preset
  if [ ! -f "$build/build.ninja" ]; then
    echo "placode: configuring"
    mkdir -p "$build"
    cmake --preset "$preset" >"$build/configure.log" 2>&1 ||
      { tail -n 15 "$build/configure.log"; placode_fail "configuring failed (log: $build/configure.log); delete the folder build and run this again"; }
  fi
  echo "placode: building (first time: several minutes)"
  if [ -t 1 ]; then
    ninja -C "$build" "$@" || placode_fail "the build failed: the first error stands above"
  else
    NINJA_STATUS='[%f/%t] ' ninja -C "$build" "$@" >"$build/build.log" 2>&1 ||
      { grep -E -m 5 'error|FAILED' "$build/build.log"; placode_fail "the build failed (log: $build/build.log)"; }
  fi
}
