// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What the servo says about its own loop: a line of status while it runs, and the certificate of an
// attempt. Any thread but the servo's.
#include "haptics/real_time.h"
#include "haptics/servo_loop.h"

namespace placode::haptics {

ServoHealth Servo::health() const {
    const Impl& impl = *impl_;
    const Counters& c = impl.counters;
    ServoHealth health;
    health.ticks = c.ticks;
    health.overruns = c.missed;
    health.clamped = c.saturated;
    health.faults = c.faults;
    health.stale = c.stale;
    health.period_p50_us = c.periods.quantile_us(0.5);
    health.period_p99_us = c.periods.quantile_us(0.99);
    health.period_p999_us = c.periods.quantile_us(0.999);
    health.period_max_us = c.periods.max_us();
    health.real_time = impl.real_time || impl.own_scheduler;
    if (impl.was_started) {
        health.remark = missing_rights(health.real_time, impl.locked);
    } else if (impl.devices->lock_step()) {
        health.remark = "In step with the simulation: no servo thread, no real-time rights needed.";
    }
    return health;
}

HapticCertificate Servo::certificate() const {
    const Impl& impl = *impl_;
    const Counters& c = impl.counters;
    HapticCertificate out;
    out.device = impl.device_names;
    out.force = impl.force;
    out.lock_step = impl.devices->lock_step();
    out.real_time = impl.real_time || impl.own_scheduler;
    out.memory_locked = impl.locked;
    out.duration_s = static_cast<double>(c.last_ns - c.first_ns) * 1e-9;
    out.ticks = c.ticks;
    out.missed = c.missed;
    out.late = c.late;
    out.gaps = c.gaps;
    out.period_p50_us = c.periods.quantile_us(0.5);
    out.period_p99_us = c.periods.quantile_us(0.99);
    out.period_p999_us = c.periods.quantile_us(0.999);
    out.period_max_us = c.periods.max_us();
    out.tool_age_p50_us = c.ages.quantile_us(0.5);
    out.tool_age_p99_us = c.ages.quantile_us(0.99);
    out.tool_age_max_us = c.ages.max_us();
    out.tool_states = c.tool_states;
    out.saturated = c.saturated;
    out.slewed = c.slewed;
    out.hot = c.hot;
    out.stale = c.stale;
    out.silent = c.silent;
    out.passivity = c.passivity;
    out.faults = c.faults;
    out.least_energy_j = c.least_j;
    out.peak_force_n = c.peak_n;
    out.rms_force_n = c.rms_n;
    out.compared = c.compared;
    out.differing = c.differing;
    out.last_error = impl.devices->last_error();
    return out;
}

}  // namespace placode::haptics
