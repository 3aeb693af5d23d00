// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The style sheet. Colours are those of the shell's two themes (ui/shell/theme.cpp).

#include "ui/web/frame.h"

namespace placode::web {

std::string_view style_sheet() {
    return R"css(:root {
  color-scheme: light dark;
  --surface: #FAFAF8; --raised: #FFFFFF; --line: #E3E2DC; --text: #1C1E21; --muted: #5F666E;
  --accent: #0B6E77; --on-accent: #FFFFFF; --accent-soft: #E4F0F1; --field: #8C9097; --hover: #F2F2EE;
  --good: #2C774B; --good-soft: #E6F2EA; --warn: #9C5D00; --warn-soft: #FBF1DF;
  --critical: #B3261E; --critical-soft: #FBE9E7;
}
@media (prefers-color-scheme: dark) {
  :root {
    --surface: #16181B; --raised: #1F2226; --line: #33373D; --text: #ECEDEE; --muted: #9AA3AD;
    --accent: #4FB8C2; --on-accent: #0E1A1C; --accent-soft: #1D3538; --field: #6F7782; --hover: #282C31;
    --good: #6CC58F; --good-soft: #1E3327; --warn: #E0A44A; --warn-soft: #382D1B;
    --critical: #F2857C; --critical-soft: #3D2422;
  }
}
* { box-sizing: border-box; }
body { margin: 0; background: var(--surface); color: var(--text);
  font: 16px/1.5 "Noto Sans", system-ui, sans-serif; }
a { color: var(--accent); text-underline-offset: 0.15em; }
:focus-visible { outline: 3px solid var(--accent); outline-offset: 2px; border-radius: 4px; }
main:focus { outline: none; }
.skip { position: absolute; left: -9999px; }
.skip:focus { left: 8px; top: 8px; padding: 8px 16px; background: var(--accent); color: var(--on-accent); z-index: 1; }
header { display: flex; flex-wrap: wrap; align-items: center; gap: 4px 24px; padding: 8px 24px;
  background: var(--raised); border-bottom: 1px solid var(--line); }
.brand { font-size: 20px; font-weight: 600; color: var(--text); text-decoration: none; padding: 8px 0; }
.rail { flex: 1 1 auto; min-width: 0; }
.rail ul, .ways { display: flex; flex-wrap: wrap; gap: 4px; margin: 0; padding: 0; list-style: none; }
.rail a, .ways a { display: block; padding: 10px 12px; border-radius: 8px; text-decoration: none; font-weight: 600; }
.rail a { color: var(--muted); }
.rail a:hover, .ways a:hover { background: var(--hover); }
.rail a[aria-current], .ways a[aria-current] { background: var(--accent-soft); color: var(--accent); }
.ways { margin: 0 0 16px -12px; }
.languages { margin-left: auto; }
.languages ul { display: flex; gap: 4px; margin: 0; padding: 0; list-style: none; }
.languages a { display: block; min-width: 44px; padding: 10px 8px; border-radius: 8px; text-align: center;
  text-decoration: none; font-weight: 600; color: var(--muted); }
.languages a:hover { background: var(--hover); }
.languages a[aria-current] { background: var(--accent-soft); color: var(--accent); }
.out { display: flex; align-items: center; gap: 12px; }
main { max-width: 1240px; margin: 0 auto; padding: 24px; }
footer { max-width: 1240px; margin: 0 auto; padding: 8px 24px 32px; color: var(--muted); font-size: 14px; }
h1 { font-size: 28px; line-height: 1.25; margin: 0 0 8px; overflow-wrap: anywhere; }
h2 { font-size: 20px; line-height: 1.3; margin: 0 0 12px; }
h3 { font-size: 16px; margin: 16px 0 4px; }
p { margin: 0 0 12px; max-width: 75ch; }
.muted { color: var(--muted); }
.small { color: var(--muted); font-size: 14px; }
.verdict { font-size: 20px; }
.verdict strong { font-size: 28px; }
.card { background: var(--raised); border: 1px solid var(--line); border-radius: 8px; padding: 16px 20px; margin: 0 0 16px; }
.narrow { max-width: 460px; margin: 48px auto; padding: 32px; }
.said { border-left: 4px solid var(--critical); background: var(--critical-soft); padding: 8px 12px; }
.scroll { overflow-x: auto; margin: 0 0 12px; }
table { border-collapse: collapse; width: 100%; font-size: 15px; font-variant-numeric: tabular-nums; }
caption { text-align: left; color: var(--muted); font-size: 14px; padding: 0 0 8px; }
th, td { text-align: left; vertical-align: top; padding: 8px 12px 8px 0; border-bottom: 1px solid var(--line); }
thead th { color: var(--muted); font-size: 14px; font-weight: 600; vertical-align: bottom; }
tbody th { font-weight: 400; }
tbody tr:hover { background: var(--hover); }
.number { text-align: right; white-space: nowrap; padding-right: 28px; }
.badge { display: inline-block; padding: 1px 8px; border-radius: 8px; font-size: 14px; font-weight: 600;
  background: var(--hover); color: var(--muted); white-space: nowrap; }
.badge.good { background: var(--good-soft); color: var(--good); }
.badge.warn { background: var(--warn-soft); color: var(--warn); }
.badge.critical { background: var(--critical-soft); color: var(--critical); }
.facts { display: grid; grid-template-columns: repeat(auto-fill, minmax(170px, 1fr)); gap: 12px 24px; margin: 0; }
.facts dt { color: var(--muted); font-size: 14px; }
.facts dd { margin: 0; overflow-wrap: anywhere; }
figure { margin: 0; }
figcaption { color: var(--muted); font-size: 14px; max-width: 75ch; }
picture { display: block; }
img { display: block; max-width: none; }
blockquote { margin: 0 0 12px; padding: 4px 16px; border-left: 3px solid var(--line); overflow-wrap: anywhere; }
blockquote p { margin: 0; white-space: pre-line; }
blockquote footer { padding: 0; }
label { display: block; font-size: 14px; font-weight: 600; margin-bottom: 4px; }
input, select { width: 100%; min-height: 44px; padding: 8px 12px; font: inherit; color: var(--text);
  background: var(--raised); border: 1px solid var(--field); border-radius: 8px; }
button { min-height: 44px; padding: 8px 16px; font: inherit; font-weight: 600; border-radius: 8px; cursor: pointer;
  color: var(--text); background: var(--raised); border: 1px solid var(--field); }
button:hover { background: var(--hover); }
.primary { width: 100%; color: var(--on-accent); background: var(--accent); border-color: var(--accent); }
.primary:hover { color: var(--on-accent); background: var(--accent); filter: brightness(1.1); }
.row { margin: 0 0 16px; }
.day { white-space: nowrap; }
.choices { display: flex; flex-wrap: wrap; align-items: end; gap: 12px; margin: 0 0 16px; }
.choices > div { flex: 0 1 260px; min-width: 0; }
.pager { display: flex; flex-wrap: wrap; align-items: center; gap: 8px 24px; }
.pager a { padding: 10px 0; }
.review canvas { display: block; width: 100%; height: min(64vh, 62vw); min-height: 220px; margin: 0 0 12px;
  background: #1b0d0c; border-radius: 8px; touch-action: none; cursor: grab; }
.review canvas:active { cursor: grabbing; }
.line { display: flex; align-items: center; gap: 12px; margin: 0 0 12px; }
.line input { flex: 1 1 auto; min-width: 0; padding: 0; border: 0; accent-color: var(--accent); }
.line button { min-width: 104px; }
.line output { white-space: nowrap; font-variant-numeric: tabular-nums; }
.moment { min-width: 72px; }
progress { width: min(100%, 460px); height: 12px; accent-color: var(--accent); }
[hidden] { display: none; }
@media (max-width: 640px) {
  header { padding: 8px 16px; }
  main { padding: 16px; }
  footer { padding: 8px 16px 24px; }
  .card { padding: 16px; }
  .rail { order: 3; flex-basis: 100%; overflow-x: auto; }
  .rail ul { flex-wrap: nowrap; }
  .rail a { white-space: nowrap; }
  .narrow { margin: 16px auto; padding: 24px 16px; }
  .choices > div { flex: 1 1 100%; }
  th, td { padding-right: 16px; }
  .number { padding-right: 20px; }
}
@media print {
  header, .choices, .pager, .skip { display: none; }
}
)css";
}

}  // namespace placode::web
