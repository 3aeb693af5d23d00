#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Do the tests bite? Makes one mistake after the other in the code and says which tests see it.

    scripts/mutate.py                  every line of tests/mutations.json (an hour)
    scripts/mutate.py slit-flow roles  those whose name contains one of the words
    scripts/mutate.py --table          the same, and a table of it in Markdown
    scripts/mutate.py --check          only whether the list fits the code

Builds in build/release, which must be there. Works in the tree itself and puts every file back,
also when it is ended from outside; a file with changes of yours is refused. Exit status 1 when a mistake
was not seen, 2 when the list does not fit the code."""
import json
import os
import pathlib
import platform
import signal
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
BUILD = ROOT / "build" / "release"
KEYS = {"name", "file", "was", "becomes", "tests", "mistake"}


def load(words: list[str]) -> list[dict]:
    mutations = json.loads((ROOT / "tests" / "mutations.json").read_text())
    for m in mutations:
        if set(m) != KEYS:
            raise SystemExit(f"tests/mutations.json: {m.get('name')}: keys are {sorted(KEYS)}")
        found = (ROOT / m["file"]).read_text().count(m["was"])
        if found != 1:
            print(f"{m['name']}: \"{m['was']}\" stands {found} times in {m['file']}, not once")
            raise SystemExit(2)
    return [m for m in mutations if not words or any(w in m["name"] for w in words)]


def run(command: list[str], **options) -> subprocess.CompletedProcess:
    return subprocess.run(command, capture_output=True, text=True, **options)


def need_clean(path: str) -> None:
    if run(["git", "-C", str(ROOT), "status", "--porcelain", path]).stdout:
        print(f"{path} has changes of yours: commit them first")
        raise SystemExit(2)


def test_runs(tests: list[str]) -> list[str]:
    """Names of those tests that fail."""
    failed = []
    environment = {**os.environ, "QT_QPA_PLATFORM": "offscreen"}
    for test in tests:
        done = run(["ctest", "--test-dir", str(BUILD), "-R", f"^{test}$", "--no-tests=error"],
                   env=environment)
        if done.returncode != 0:
            failed.append(test)
    return failed


def try_one(m: dict) -> tuple[str, list[str]]:
    """("seen" | "not seen" | "does not compile", the tests that failed)."""
    path = ROOT / m["file"]
    text = path.read_text()
    path.write_text(text.replace(m["was"], m["becomes"]))
    try:
        built = run(["ninja", "-C", str(BUILD), *m["tests"]])
        if built.returncode != 0:
            return "does not compile", []
        failed = test_runs(m["tests"])
        return ("seen" if failed else "not seen"), failed
    finally:
        path.write_text(text)


def report(rows: list[tuple[dict, str, list[str]]]) -> None:
    commit = run(["git", "-C", str(ROOT), "rev-parse", "--short", "HEAD"]).stdout.strip()
    print("<!-- Written by `scripts/mutate.py --table`; run it again instead of editing. -->")
    print("# Mistakes that the tests see\n")
    print("Each row is a mistake that was put into the code on purpose, one at a time, and the tests "
          "that failed then. Made with\n`scripts/mutate.py --table` at commit "
          f"{commit}, {time.strftime('%Y-%m-%d')}, {platform.machine()}: "
          f"{sum(r[1] == 'seen' for r in rows)} of {len(rows)} seen.\n")
    print("| mistake | in | seen by |\n|---|---|---|")
    for m, outcome, failed in rows:
        print(f"| {m['mistake']} | `{m['file']}` | {', '.join(failed) or '**' + outcome + '**'} |")


def main() -> int:
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))  # so that files are put back then, too
    arguments = sys.argv[1:]
    table = "--table" in arguments
    mutations = load([a for a in arguments if not a.startswith("--")])
    if "--check" in arguments:
        print(f"{len(mutations)} mistakes fit the code")
        return 0
    for m in mutations:
        need_clean(m["file"])
    rows = []
    for m in mutations:
        outcome, failed = try_one(m)
        rows.append((m, outcome, failed))
        print(f"{m['name']}: {outcome} {' '.join(failed)}", file=sys.stderr if table else sys.stdout,
              flush=True)
    run(["ninja", "-C", str(BUILD), *sorted({t for m in mutations for t in m["tests"]})])
    if table:
        report(rows)
    return 0 if all(outcome == "seen" for _, outcome, _ in rows) else 1


if __name__ == "__main__":
    sys.exit(main())
