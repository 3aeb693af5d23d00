// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/certificate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "haptics/json_scan.h"
#include "sim/core/number_text.h"

namespace placode::haptics {

namespace {

using sim::Said;

/// Every field once: writer and reader walk the same list.
template <class Certificate, class Visit>
void each_field(Certificate& c, Visit&& visit) {
    visit("format", c.format);
    visit("device", c.device);
    visit("force", c.force);
    visit("lock_step", c.lock_step);
    visit("real_time", c.real_time);
    visit("memory_locked", c.memory_locked);
    visit("duration_s", c.duration_s);
    visit("ticks", c.ticks);
    visit("missed_periods", c.missed);
    visit("late_ticks", c.late);
    visit("gaps", c.gaps);
    visit("period_p50_us", c.period_p50_us);
    visit("period_p99_us", c.period_p99_us);
    visit("period_p999_us", c.period_p999_us);
    visit("period_max_us", c.period_max_us);
    visit("tool_age_p50_us", c.tool_age_p50_us);
    visit("tool_age_p99_us", c.tool_age_p99_us);
    visit("tool_age_max_us", c.tool_age_max_us);
    visit("tool_states", c.tool_states);
    visit("saturated_ticks", c.saturated);
    visit("slewed_ticks", c.slewed);
    visit("hot_ticks", c.hot);
    visit("stale_ticks", c.stale);
    visit("silent_ticks", c.silent);
    visit("passivity_ticks", c.passivity);
    visit("faults", c.faults);
    visit("least_energy_j", c.least_energy_j);
    visit("peak_force_n", c.peak_force_n);
    visit("rms_force_n", c.rms_force_n);
    visit("compared_ticks", c.compared);
    visit("differing_ticks", c.differing);
    visit("last_error", c.last_error);
}

std::string quoted(std::string_view text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        // Names of devices come from their drivers: control characters become blanks.
        out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
    out += '"';
    return out;
}

std::string unquoted(std::string_view text) {
    std::string out;
    for (size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '\\' && i + 1 < text.size()) ++i;
        out += text[i];
    }
    return out;
}

std::string json_value(const std::string& value) { return quoted(value); }
std::string json_value(bool value) { return value ? "true" : "false"; }
std::string json_value(int value) { return std::to_string(value); }
std::string json_value(uint64_t value) { return std::to_string(value); }
std::string json_value(double value) {
    return std::isfinite(value) ? sim::shortest_text(value) : "null";
}

void read_value(JsonScan& scan, std::string& value) { value = unquoted(scan.text()); }
void read_value(JsonScan& scan, bool& value) { value = scan.truth(value); }
void read_value(JsonScan& scan, int& value) {
    const double number = scan.number(value);
    // What no int holds, as much as one can: more faults, a later format.
    const bool held = number >= -2147483648.0 && number <= 2147483647.0;
    value = held ? static_cast<int>(number) : std::numeric_limits<int>::max();
}
void read_value(JsonScan& scan, double& value) { value = scan.number(value); }
void read_value(JsonScan& scan, uint64_t& value) {
    const double number = scan.number(static_cast<double>(value));
    value = number >= 0 && number < 9e15 ? static_cast<uint64_t>(number) : 0;
}

double share(uint64_t part, uint64_t whole) {
    return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0;
}

std::string percent(double value) { return sim::rounded_text(100 * value, 3) + " %"; }

Said faults_of(const HapticCertificate& c, const CertificateLimits& limits) {
    const auto counted = [&](const Said& faults) {
        return faults.with(std::to_string(c.faults)).with(std::to_string(limits.faults));
    };
    if (c.last_error.empty()) return counted(Said::that("%1 device faults (at most %2)"));
    return counted(Said::that("%1 device faults (at most %2); the last error was %3"))
        .with(c.last_error);
}

}  // namespace

std::string_view grade_name(CertificateGrade grade) noexcept {
    switch (grade) {
        case CertificateGrade::kNotApplicable:
            return "not_applicable";
        case CertificateGrade::kSound:
            return "sound";
        case CertificateGrade::kBad:
            return "bad";
    }
    return "bad";
}

CertificateVerdict judge(const HapticCertificate& c, const CertificateLimits& limits) {
    CertificateVerdict verdict;
    if (!c.force || c.lock_step) return verdict;
    const auto bad = [&](Said what) { verdict.reasons.push_back(std::move(what)); };
    const auto check_share = [&](const Said& what, double found, double limit) {
        if (found > limit) bad(what.with(percent(found)).with(percent(limit)));
    };
    if (c.duration_s < limits.shortest_s || c.ticks == 0)
        bad(Said::that("the haptic loop ran for %1 s only")
                .with(sim::rounded_text(c.duration_s, 3)));
    // A tick that never came is as late as one can be: one long gap counts by its length.
    check_share(Said::that("late in %1 of the ticks (at most %2)"),
                share(c.late + c.missed, c.ticks + c.missed), limits.late_share);
    const double minutes = std::max(c.duration_s / 60, 1.0);
    if (static_cast<double>(c.gaps) > limits.gaps_per_minute * minutes)
        bad(Said::that("%1 drop-outs of more than 5 ms (at most %2 a minute)")
                .with(std::to_string(c.gaps))
                .with(sim::rounded_text(limits.gaps_per_minute, 3)));
    check_share(Said::that("tool state older than 10 ms in %1 of the ticks (at most %2)"),
                share(c.stale, c.ticks), limits.stale_share);
    check_share(Said::that("force at its ceiling in %1 of the ticks (at most %2)"),
                share(c.saturated, c.ticks), limits.saturated_share);
    check_share(Said::that("force lowered by motor heat in %1 of the ticks (at most %2)"),
                share(c.hot, c.ticks), limits.hot_share);
    if (c.faults > limits.faults) bad(faults_of(c, limits));
    if (!(c.least_energy_j >= limits.least_energy_j))
        bad(Said::that("the haptic port gave %1 mJ more than it took (at most %2 mJ)")
                .with(sim::rounded_text(-1e3 * c.least_energy_j, 3))
                .with(sim::rounded_text(-1e3 * limits.least_energy_j, 3)));
    verdict.grade = verdict.reasons.empty() ? CertificateGrade::kSound : CertificateGrade::kBad;
    return verdict;
}

std::string certificate_to_json(const HapticCertificate& certificate) {
    std::string out = "{";
    each_field(certificate, [&](const char* key, const auto& value) {
        out.append("\"").append(key).append("\":").append(json_value(value)).append(",");
    });
    const CertificateVerdict verdict = judge(certificate);
    out.append("\"grade\":").append(quoted(grade_name(verdict.grade))).append(",\"reasons\":[");
    for (size_t i = 0; i < verdict.reasons.size(); ++i)
        out.append(i > 0 ? "," : "").append(quoted(verdict.reasons[i].english()));
    return out.append("]}");
}

HapticCertificate certificate_from_json(std::string_view json) {
    HapticCertificate certificate;
    certificate.format = 0;
    JsonScan scan(json);
    const bool object = scan.object([&](std::string_view key) {
        each_field(certificate, [&](const char* name, auto& value) {
            if (key == name) read_value(scan, value);
        });
    });
    if (!object || scan.failed() || certificate.format < 1)
        throw CertificateError("haptic certificate: not one JSON object with \"format\"");
    return certificate;
}

}  // namespace placode::haptics
