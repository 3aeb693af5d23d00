#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# What the last build and the last run of the tests took, as a page for docs/measurements:
#   scripts/times.sh [BUILD]                    BUILD: build/release
#   scripts/times.sh --keep FILE [BUILD]        writes the figures behind it to FILE instead
#   scripts/times.sh --against FILE [BUILD]     the page, with the figures of FILE as those of before
# It reads BUILD/.ninja_log and BUILD/test.log (./test.sh writes it). Only what `./test.sh` does on an empty
# BUILD says what a build takes; a file that was compiled again counts with its last time.
set -euo pipefail
cd "$(dirname "$0")/.."
mode=page file=
case "${1:-}" in
  --keep | --against) mode=${1#--} file=${2:?FILE}; shift 2 ;;
  -h | --help) sed -n '5,11p' "$0" | sed 's/^# \{0,1\}//'; exit 0 ;;
esac
build=${1:-build/release}
[ -f "$build/.ninja_log" ] || { echo "scripts/times.sh: $build/.ninja_log is missing: build first" >&2; exit 1; }

# Figures: kind, folder, name, seconds (or a number), separated by tabs.
build_figures() {
  awk -F'\t' -v root="$PWD/" '
    # The log is in the order in which steps ended; with an earlier end another run of ninja has begun.
    /^#/ {next}
    {
      if ($2 < last) wall += last
      last = $2
      took[$4] = ($2 - $1) / 1000; key[$4] = $1 " " $2 " " $5
    }
    END {
      for (output in took) {
        if (took[output] == 0 || seen[key[output]]++) continue  # a step may have several outputs
        name = output; sub("^" root, "", name); sub(/^build\/[^\/]*\//, "", name)
        kind = name ~ /\.o$/ ? "compile" : name ~ /\.(gch|pch)$/ ? "precompile" : \
               name ~ /\.(a|so[0-9.]*)$|^bin\/[^\/]*$|^tests\/[^\/.]*$/ ? "link" : "other"
        if (match(name, /CMakeFiles\/[^\/]*\.dir\//)) {
          target = substr(name, RSTART + 11, RLENGTH - 16)
          rest = substr(name, RSTART + RLENGTH); before = substr(name, 1, RSTART - 1)
          short = target; sub(/^placode_/, "", short)
          sub(/\.o$/, "", rest)
          if (rest ~ /^Unity\//) {
            # Several sources in one: unity_ROOM_3_cxx.cxx
            sub(/^Unity\/unity_/, "", rest); sub(/_?cxx\.cxx$/, "", rest)
            number = rest; sub(/.*_/, "", number)
            room = rest; if (!sub(/_[0-9]+$/, "", room)) room = ""
            folder = before == "tests/" ? "tests" : room == "" || room == short ? short : short "/" room
            name = folder == "tests" ? "tests/" target : folder " (" number ")"
          } else if (kind == "precompile") {
            folder = "precompiled headers"; name = target
          } else {
            name = before rest; folder = name
            if (!sub(/\/[^\/]*$/, "", folder)) folder = "generated"
            if (name ~ /autogen/) folder = short
          }
        } else {
          folder = kind == "link" ? "linking" : "other"
        }
        printf "%s\t%s\t%s\t%.2f\n", kind, folder, name, took[output]
      }
      printf "total\tbuild\twall\t%.1f\n", (wall + last) / 1000
    }' "$build/.ninja_log"
}
test_figures() {
  [ -f "$build/test.log" ] || return 0
  sed -nE 's/^ *[0-9]+\/[0-9]+ Test +#[0-9]+: ([^ ]+) .* ([0-9.]+) sec.*/test\ttests\t\1\t\2/p' "$build/test.log"
  sed -nE 's/^Total Test time \(real\) = +([0-9.]+) sec.*/total\ttests\twall\t\1/p' "$build/test.log"
}
# What there is in the sources: so that a quicker suite is seen to be the whole one.
counted() {
  local sources
  mapfile -t sources < <(find tests -name '*.cpp' -o -name '*.h' -o -name '*.py' | sort)
  awk '
    /^TEST(_F|_P)?\(/ || /^ *def test_/ {++tests}
    /private Q_SLOTS:/ {slots = 1; next}
    /^ *(public|protected|private)( |:)/ {slots = 0}
    slots && /^ *void [A-Za-z]+\(\)/ && !/(_data|TestCase|init|cleanup)\(/ {++tests}
    {
      assertions += gsub(/(EXPECT|ASSERT)_[A-Z0-9_]+\(/, "")
      assertions += gsub(/Q(VERIFY2?|COMPARE|FAIL|TRY_VERIFY|TRY_COMPARE)[A-Z_]*\(/, "")
      assertions += gsub(/ADD_FAILURE|self\.(assert[A-Za-z]+|fail)\(/, "")
    }
    END {printf "total\ttests\tfunctions\t%d\ntotal\ttests\tassertions\t%d\n", tests, assertions}' "${sources[@]}"
}
figures() {
  build_figures
  test_figures
  counted
}

if [ "$mode" = keep ]; then
  figures >"$file"
  exit
fi
old=/dev/null
[ "$mode" = page ] || old=$file
echo '# Building and testing'
echo
echo "Written by \`scripts/times.sh\`: $(date -u +%F), $(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1),"
echo "$(nproc) cores, $(git rev-parse --short HEAD 2>/dev/null || echo 'no commit'). Seconds as they passed; steps run side by side, so that sums are work."
figures | awk -F'\t' -v old="$old" -v compares="$([ "$mode" = against ] && echo 1 || echo 0)" '
  function add(to, kind, folder, name, value) {
    if (kind == "total") {to["total " folder " " name] = value; return}
    to["sum " kind] += value
    if (kind == "test") {to["count tests"] += 1; to["test " name] = value; return}
    to["count steps"] += 1
    if (kind == "compile") {to["file " name] = value; to["folder " folder] += value}
  }
  function shown(all, key, form) {return key in all ? sprintf(form, all[key]) : ""}
  function head(first) {
    if (compares) printf "\n| %s | before | now |\n|---|---|---|\n", first
    else printf "\n| %s | |\n|---|---|\n", first
  }
  function row(label, key, form) {
    if (compares) printf "| %s | %s | %s |\n", label, shown(before, key, form), shown(now, key, form)
    else if (key in now) printf "| %s | %s |\n", label, shown(now, key, form)
  }
  # The longest `most` of one kind, now or before.
  function longest(kind, most,    key, n, i, best, taken, value, order) {
    for (i = 0; i < most; ++i) {
      best = ""
      for (key in now) if (index(key, kind " ") == 1 && !(key in taken) && (best == "" || now[key] > now[best])) best = key
      if (best == "") return
      taken[best] = 1
      row(substr(best, length(kind) + 2), best, "%.1f")
    }
  }
  {add(now, $1, $2, $3, $4)}
  END {
    while ((getline line < old) > 0) {split(line, part, "\t"); add(before, part[1], part[2], part[3], part[4])}
    head("")
    row("build, from first to last step", "total build wall", "%.0f")
    row("compiling", "sum compile", "%.0f")
    row("precompiling headers", "sum precompile", "%.0f")
    row("linking", "sum link", "%.0f")
    row("generating and other steps", "sum other", "%.0f")
    row("number of steps", "count steps", "%d")
    row("tests, from first to last", "total tests wall", "%.0f")
    row("tests, one after the other", "sum test", "%.0f")
    row("number of tests (programs)", "count tests", "%d")
    row("number of tests (functions)", "total tests functions", "%d")
    row("number of assertions in them", "total tests assertions", "%d")
    print "\n## Files that take longest"
    head("compiled file")
    longest("file", 25)
    print "\n## Folders"
    head("folder")
    longest("folder", 60)
    if (now["count tests"] > 0) {
      print "\n## Tests that take longest"
      head("test")
      longest("test", 40)
    }
  }'
