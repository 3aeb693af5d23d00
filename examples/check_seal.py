#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks the seal of an attempt without Placode: who states it, and that nothing was changed.

    placodectl report seal 12 --out seal.txt --recording attempt.placode
    python3 check_seal.py seal.txt [attempt.placode] [--station PUBLIC_KEY]

Anybody can make a key and sign a page with it. That a page is a centre's shows only with --station: the key that the
centre gave out itself (`placodectl station key` there). What is not proved is said to be OPEN, and is not success.

Ed25519 is written out below (RFC 8032, section 5.1.7), so that Python alone is enough.
Exit status: 0 everything is proved, 1 something is wrong, 2 usage, 3 nothing is wrong and something is open.
"""
import argparse
import hashlib
import sqlite3
import sys
import unicodedata

P = 2**255 - 19
L = 2**252 + 27742317777372353535851937790883648493
D = -121665 * pow(121666, P - 2, P) % P


def add(p, q):
    """Sum of two points in extended coordinates (RFC 8032, section 5.1.4)."""
    a, b = (p[1] - p[0]) * (q[1] - q[0]) % P, (p[1] + p[0]) * (q[1] + q[0]) % P
    c, d = 2 * p[3] * q[3] * D % P, 2 * p[2] * q[2] % P
    e, f, g, h = b - a, d - c, d + c, b + a
    return e * f % P, g * h % P, f * g % P, e * h % P


def times(s, p):
    q = (0, 1, 1, 0)
    while s > 0:
        if s & 1:
            q = add(q, p)
        p, s = add(p, p), s >> 1
    return q


def point(octets):
    """The point that 32 bytes stand for; ValueError for what is none."""
    y = int.from_bytes(octets, "little")
    sign, y = y >> 255, y & (2**255 - 1)
    square = (y * y - 1) * pow(D * y * y + 1, P - 2, P) % P
    x = pow(square, (P + 3) // 8, P)
    if (x * x - square) % P != 0:
        x = x * pow(2, (P - 1) // 4, P) % P
    if y >= P or (x * x - square) % P != 0 or (x == 0 and sign == 1):
        raise ValueError("no point of the curve")
    x = P - x if x & 1 != sign else x
    return x, y, 1, x * y % P


BASE = point((4 * pow(5, P - 2, P) % P).to_bytes(32, "little"))


def signed_by(key, text, signature):
    """Whether `signature` over `text` (bytes) is that of `key`; key and signature are hexadecimal."""
    try:
        key, signature = bytes.fromhex(key), bytes.fromhex(signature)
        public, r, s = point(key), point(signature[:32]), int.from_bytes(signature[32:], "little")
    except ValueError:
        return False
    h = int.from_bytes(hashlib.sha512(signature[:32] + key + text).digest(), "little") % L
    left, right = times(s, BASE), add(r, times(h, public))
    same = (left[0] * right[2] - right[0] * left[2]) % P == 0
    return len(signature) == 64 and s < L and same and (left[1] * right[2] - right[1] * left[2]) % P == 0


def blake(data):
    return hashlib.blake2b(data, digest_size=32).hexdigest()


def recording_signature(path):
    """The station that a recording names, and whether its signature is right."""
    data = sqlite3.connect(f"file:{path}?mode=ro", uri=True)
    framed = lambda values: b"".join(b"%d:%s;" % (len(v), v) for v in (str(v).encode() for v in values))
    meta = dict(data.execute("SELECT key, value FROM meta"))
    text = b"".join(framed(pair) for pair in sorted(meta.items()) if pair[0] != "station") + b"\n"
    for row in data.execute("SELECT kind, first, count, checksum, content FROM chunks ORDER BY id"):
        if blake(row[4]) != row[3]:
            return None, False
        text += framed(row[:4])
    station, signature = (meta.get("station", " ").split(" ") + [""])[:2]
    return station, signed_by(station, b"placode recording 1\n" + blake(text).encode(), signature)


def on_screen(text):
    """Without letters that a terminal obeys or does not show: names are other people's text."""
    hidden = ("Cc", "Cf", "Zl", "Zp")
    return "".join("\N{REPLACEMENT CHARACTER}" if unicodedata.category(c) in hidden and c != "\n" else c for c in text)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("seal")
    parser.add_argument("recording", nargs="?")
    parser.add_argument("--station", help="public key of the computer that must have stated it")
    options = parser.parse_args()
    with open(options.seal, "rb") as file:
        lines, _, signature = file.read().rpartition(b"signature: ")
    said = dict(line.split(": ", 1) for line in lines.decode().split("\n") if ": " in line)
    checks = {
        "the page is a seal": lines.startswith(b"Placode seal of an attempt 1\n"),
        "signed by the station it names":
            signed_by(said.get("stated by station", ""), lines, signature.decode().strip())}
    if options.station:
        checks["stated by the station asked for"] = said.get("stated by station") == options.station
    if options.recording:
        with open(options.recording, "rb") as file:
            checks["the recording is the one sealed"] = blake(file.read()) == said.get("recording checksum")
        station, right = recording_signature(options.recording)
        checks["the recording is signed"] = right and station == said.get("recorded by station")
    print(on_screen(lines.decode()), end="")
    for what, right in checks.items():
        print("right" if right else "WRONG", what, sep="  ")
    unproved = []
    if not options.station:
        unproved.append("whose station that is: anybody can sign like this; ask the centre for its key, give it as --station")
    if said.get("station registered") != "yes":
        unproved.append("whether the store knows that station: it says so itself, or says nothing; ask the centre")
    if options.recording and said.get("recorded by station") != said.get("stated by station"):
        unproved.append("who recorded it: another station than the one that states this; ask the centre whether it is theirs")
    for what in unproved:
        print("OPEN ", what, sep="  ")
    return 1 if not all(checks.values()) else 3 if unproved else 0


if __name__ == "__main__":
    sys.exit(main())
