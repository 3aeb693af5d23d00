// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Stands before the C library (LD_PRELOAD) in programs of tests that wait for work which the
// product puts behind everything else: attempts simulated again (ui/shell/replay_queue.cpp), tracks
// of the portal (ui/web/review_maker.cpp). Beside two other tests such a thread gets a thirtieth of
// a core, and the test that waits for it takes minutes, or runs out of time. No test looks at
// levels.

#include <dlfcn.h>

/// As sys/resource.h has it; that says more of its types in C++ than a definition can repeat.
extern "C" int setpriority(int which, unsigned who, int level) {
    if (level > 0) return 0;  // Asks to stand behind others.
    using Function = int(int, unsigned, int);
    static const auto real = reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, "setpriority"));
    return real(which, who, level);
}
