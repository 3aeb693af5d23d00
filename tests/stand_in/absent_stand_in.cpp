// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Stands for a library that a vendor's needs and the system no longer has.
extern "C" int placode_absent() { return 0; }
