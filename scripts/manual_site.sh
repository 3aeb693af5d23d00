#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The manual as a web site of plain files, in both languages: put the folder on any web server, or open
# index.html. cmark-gfm makes the pages; every link is followed at the end.
#   scripts/manual_site.sh [FOLDER]     default: build/manual_site
set -euo pipefail
cd "$(dirname "$0")/.."
. scripts/prepare.sh
placode_install cmark-gfm
out=${1:-build/manual_site}
declare -A home=([en]="Contents" [pl]="Spis treści") other=([en]=pl [pl]=en) name=([en]=English [pl]=Polski)
# Nothing of anybody else's is thrown away.
[ ! -e "$out" ] || [ -e "$out/pl/metrics.html" ] ||
  placode_fail "manual_site.sh: $out is there and holds no manual; name a new folder"
rm -rf "$out"
mkdir -p "$out"
cp -r docs/manual/pictures "$out/pictures"
rm -f "$out/pictures/buttons.json"
cat >"$out/style.css" <<'CSS'
:root { color-scheme: light dark; --text: #1c1b1a; --ground: #fdfcfa; --line: #d8d5cf; --accent: #0b6e78; }
@media (prefers-color-scheme: dark) { :root { --text: #eceae6; --ground: #161718; --line: #3a3c3e; --accent: #58c4cf; } }
body { margin: 0 auto; max-width: 46rem; padding: 1rem; font: 1rem/1.6 sans-serif; color: var(--text); background: var(--ground); }
a { color: var(--accent); }
nav { display: flex; gap: 1.5rem; border-bottom: 1px solid var(--line); padding-bottom: .5rem; }
nav :last-child { margin-left: auto; }
img { max-width: 100%; height: auto; border: 1px solid var(--line); border-radius: 6px; }
table { border-collapse: collapse; display: block; overflow-x: auto; }
th, td { border: 1px solid var(--line); padding: .3rem .6rem; text-align: left; vertical-align: top; }
pre { overflow-x: auto; border: 1px solid var(--line); border-radius: 6px; padding: .6rem; }
CSS
for language in en pl; do
  mkdir "$out/$language"
  for page in docs/manual/"$language"/*.md; do
    file=$(basename "$page" .md)
    to=${other[$language]}
    {
      printf '<!DOCTYPE html>\n<html lang="%s">\n<head>\n<meta charset="utf-8">\n' "$language"
      printf '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
      printf '<title>%s - Placode</title>\n' "$(sed -n '1s/^# //p' "$page" | sed 's/&/\&amp;/g; s/</\&lt;/g')"
      printf '<link rel="stylesheet" href="../style.css">\n</head>\n<body>\n'
      printf '<nav><a href="index.html">%s</a><a href="../%s/%s.html" lang="%s">%s</a></nav>\n<main>\n' \
        "${home[$language]}" "$to" "$file" "$to" "${name[$to]}"
      cmark-gfm -e table "$page" | sed -E 's/href="([A-Za-z0-9_-]+)\.md([#"])/href="\1.html\2/g'
      printf '</main>\n</body>\n</html>\n'
    } >"$out/$language/$file.html"
  done
done
cat >"$out/index.html" <<'HTML'
<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="refresh" content="0; url=en/index.html">
<title>Placode</title>
</head>
<body><a href="en/index.html">English</a> <a href="pl/index.html" lang="pl">Polski</a></body>
</html>
HTML
dead=0 links=0
for page in "$out"/*/*.html; do
  while read -r link; do
    links=$((links + 1))
    [ -e "$(dirname "$page")/$link" ] || { echo "manual_site.sh: $page: $link is not there" >&2; dead=$((dead + 1)); }
  done < <(grep -oE '(href|src)="[^"#:]+' "$page" | cut -d '"' -f 2)
done
echo "$out: $(find "$out" -name '*.html' | wc -l) pages, $links links and pictures followed, $dead missing"
[ "$dead" -eq 0 ]
