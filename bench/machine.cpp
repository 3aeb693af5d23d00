// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/machine.h"

#include <sys/utsname.h>

#include <cstdlib>
#include <fstream>
#include <thread>

#include "sim/solver/soft_body.h"

namespace placode::bench {
namespace {

std::string processor() {
    std::ifstream in("/proc/cpuinfo");
    for (std::string line; std::getline(in, line);)
        if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
    return "unknown";
}

}  // namespace

Machine this_machine() {
    double load[3]{};
    (void)::getloadavg(load, 3);
    utsname name{};
    (void)::uname(&name);
    Machine machine;
    machine.processor = processor();
    machine.logical_cores = std::thread::hardware_concurrency();
    machine.system = std::string(name.sysname) + " " + name.release;
    machine.compiler = "g++ " __VERSION__;
#ifdef NDEBUG
    machine.build = "optimised";
#else
    machine.build = "with assertions";
#endif
    machine.kernel_target = sim::kernel_target();
    machine.load_average_1min = load[0];
    return machine;
}

}  // namespace placode::bench
