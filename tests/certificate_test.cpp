// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/certificate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace placode::haptics {
namespace THIS_TEST {

using ::testing::HasSubstr;
using ::testing::SizeIs;

HapticCertificate sound() {
    HapticCertificate c;
    c.device = "3D Systems \"Touch\" 1234";
    c.force = c.real_time = c.memory_locked = true;
    c.duration_s = 600;
    c.ticks = 599'990;
    c.missed = 10;
    c.late = 300;
    c.gaps = 2;
    c.period_p50_us = 1000;
    c.period_p999_us = 1085;
    c.period_max_us = 6200.5;
    c.tool_age_p50_us = 500;
    c.tool_states = 1'200'000;
    c.saturated = 400;
    c.least_energy_j = -0.0003;
    c.peak_force_n = 2.6;
    c.rms_force_n = 0.41;
    c.compared = 5'000;
    c.differing = 3;
    return c;
}

TEST(Certificate, OfAGoodBenchIsSound) {
    EXPECT_EQ(judge(sound()).grade, CertificateGrade::kSound);
    EXPECT_TRUE(judge(sound()).reasons.empty());
}

TEST(Certificate, DoesNotApplyWithoutForceOrInStep) {
    HapticCertificate mouse = sound();
    mouse.force = false;
    mouse.gaps = 10'000;
    EXPECT_EQ(judge(mouse).grade, CertificateGrade::kNotApplicable);
    HapticCertificate script = sound();
    script.lock_step = true;
    EXPECT_EQ(judge(script).grade, CertificateGrade::kNotApplicable);
}

TEST(Certificate, NamesEveryReasonWithNumberAndLimit) {
    const auto with = [](auto change) {
        HapticCertificate c = sound();
        change(c);
        return judge(c);
    };
    const auto one = [](const CertificateVerdict& verdict, const char* words) {
        EXPECT_EQ(verdict.grade, CertificateGrade::kBad);
        ASSERT_THAT(verdict.reasons, SizeIs(1)) << words;
        EXPECT_THAT(verdict.reasons[0].english(), HasSubstr(words));
    };
    one(with([](auto& c) { c.late = 12'000; }), "late in 2 % of the ticks (at most 1 %)");
    one(with([](auto& c) {  // one gap, but of twenty seconds
            c.ticks = 580'000;
            c.missed = 20'000;
            c.late = c.gaps = 1;
        }),
        "late in 3.33 % of the ticks (at most 1 %)");
    one(with([](auto& c) { c.gaps = 11; }), "11 drop-outs");
    one(with([](auto& c) { c.stale = 6'600; }), "older than 10 ms in 1.1 %");
    one(with([](auto& c) { c.saturated = 60'000; }), "force at its ceiling in 10 %");
    one(with([](auto& c) { c.hot = 60'000; }), "motor heat");
    one(with([](auto& c) { c.faults = 1; }), "1 device faults (at most 0)");
    one(with([](auto& c) {
            c.faults = 2;
            c.last_error = "0x302 (communication error)";
        }),
        "(at most 0); the last error was 0x302 (communication error)");
    one(with([](auto& c) { c.least_energy_j = -0.02; }), "gave 20 mJ");
    one(with([](auto& c) { c.least_energy_j = std::nan(""); }), "haptic port");
    EXPECT_EQ(with([](auto& c) { c.ticks = 0; }).grade, CertificateGrade::kBad);
    EXPECT_EQ(with([](auto& c) { c.gaps = 10; }).grade, CertificateGrade::kSound)
        << "one a minute is allowed";
}

TEST(Certificate, ComesBackFromJson) {
    const HapticCertificate c = sound();
    const std::string json = certificate_to_json(c);
    EXPECT_THAT(json, HasSubstr("\"grade\":\"sound\""));
    EXPECT_EQ(json.find('\n'), std::string::npos) << "one line";
    const HapticCertificate back = certificate_from_json(json);
    EXPECT_EQ(back.device, c.device);
    EXPECT_EQ(back.ticks, c.ticks);
    EXPECT_EQ(back.gaps, c.gaps);
    EXPECT_EQ(back.period_max_us, c.period_max_us);
    EXPECT_EQ(back.least_energy_j, c.least_energy_j);
    EXPECT_EQ(back.compared, c.compared);
    EXPECT_EQ(back.differing, c.differing);
    EXPECT_EQ(certificate_to_json(back), json);
}

TEST(Certificate, RefusesWhatIsNone) {
    for (const char* text : {"", "[]", "{}", "{\"ticks\":5}", "{\"format\":1", "nonsense"})
        EXPECT_THROW((void)certificate_from_json(text), CertificateError) << text;
    EXPECT_NO_THROW((void)certificate_from_json(
        "{\"future\":{\"a\":[1,2,{\"b\":null}]},\"format\":2,\"ticks\":7}"));
    EXPECT_GT(certificate_from_json("{\"format\":1e43}").format, 1) << "no int holds it";
}

}  // namespace THIS_TEST
}  // namespace placode::haptics
