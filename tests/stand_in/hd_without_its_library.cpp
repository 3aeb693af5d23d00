// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A vendor's library that cannot be loaded because one that it needs is not there.
extern "C" int placode_absent();
extern "C" unsigned hdInitDevice(const char*) { return placode_absent() == 0 ? 1 : 0; }
