#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# What scripts/check_packages.sh does inside the bare system; everything that a person does is done by "anna".
set -euo pipefail
cd /root/packages
mkdir -p /root/seen

# step WORDS COMMAND...: runs it and says how long it took
step() {
  local begun=$SECONDS words=$1
  shift
  "$@" >/root/step.log 2>&1 || { echo "FAILED: $words"; tail -n 20 /root/step.log; exit 1; }
  echo "$words: $((SECONDS - begun)) s"
}
# anna COMMAND: as a person with a desktop
anna() {
  su anna -c "cd; export XDG_RUNTIME_DIR=/tmp/anna; mkdir -p -m 700 /tmp/anna; xvfb-run -a -s '-screen 0 1280x800x24 +extension GLX' bash -euc '$1'"
}

step "list of Debian's packages" apt-get update -qq
step "placode installed" apt-get install -y -qq --no-install-recommends ./placode_*.deb
step "tools of this check" apt-get install -y -qq --no-install-recommends xvfb xauth xdotool imagemagick
step "the portal has its user" id placode-web
useradd -m anna
for program in placode placode-sim placodectl placode-web; do su anna -c "$program --version" 2>/dev/null; done

# The first window, and one key: its first button has the focus and begins the first exercise.
first_exercise() {
  anna 'placode & shell=$!
    for i in $(seq 100); do xdotool search --onlyvisible --name Placode >/dev/null 2>&1 && break; sleep 0.1; done
    sleep 2; import -window root first.png
    xdotool search --onlyvisible --name Placode windowfocus key Return
    sleep 5; import -window root exercise.png
    kill $shell; wait $shell || true
    placodectl --store sqlite:$HOME/.local/share/placode/placode.db user list | grep guest'
}
step "first window and first exercise" first_exercise
# An attempt by a script, saved and scored.
attempt() {
  anna 'placode-sim --task familiarisation --device script:mouse --duration 20 --record first.placode --size 960x720 --screenshots shots:10
    placodectl import first.placode --user guest
    placodectl score first.placode'
}
step "an attempt of 20 s and its score" attempt
grep -E '^score|^replay' /root/step.log
step "the recording gives the same again" su anna -c "cd; placode-sim --device play:first.placode --headless"
cp /home/anna/*.png /home/anna/shots/*.png /root/seen/

step "researchers' packages installed" apt-get install -y -qq --no-install-recommends ./libplacode1_*.deb ./libplacode-dev_*.deb ./python3-placode_*.deb
cat >/home/anna/try.py <<'P'
import placode
env = placode.make("Placode/Reach-v0")
env.reset(seed=1)
for _ in range(50):
    observation, reward, terminated, truncated, info = env.step(env.action_space.sample())
print("Python: 50 steps of", placode.__file__)
P
step "an environment in Python" su anna -c "cd; python3 try.py"
cat /root/step.log

# The same package under the next version, over the store that is there.
mkdir /root/next
for deb in ./*.deb; do
  dpkg-deb -R "$deb" /root/next/tree
  sed -i 's/^Version: .*/&+next/; s/(= \([0-9.]*\))/(= \1+next)/g' /root/next/tree/DEBIAN/control
  dpkg-deb -b /root/next/tree "/root/next/$(basename "$deb" _amd64.deb)+next_amd64.deb" >/dev/null
  rm -rf /root/next/tree
done
step "upgrade" apt-get install -y -qq --no-install-recommends /root/next/*.deb
dpkg-query -W -f '${Package} ${Version}\n' placode libplacode1 libplacode-dev python3-placode
step "the store opens after it, and is sound" su anna -c "placodectl check"

step "removal" apt-get remove -y -qq placode
[ ! -e /usr/bin/placode ] && [ ! -e /usr/share/placode ] || { echo "FAILED: removal left files"; exit 1; }
[ -s /home/anna/.local/share/placode/placode.db ] || { echo "FAILED: removal took the store"; exit 1; }
echo "removed; what anna did stays"
