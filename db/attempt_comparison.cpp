// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/attempt_comparison.h"

#include <QtGlobal>
#include <algorithm>
#include <cmath>
#include <vector>

#include "assessment/signal.h"
#include "db/attempt_counting.h"
#include "db/haptic_verdict.h"
#include "db/void_reason.h"
#include "sim/core/number_text.h"

namespace placode::db {
namespace {

constexpr int kDecimals = 6;

std::string shown(double value) { return sim::fixed_text(value, kDecimals); }
std::string shown(const std::string& value) { return "\"" + value + "\""; }
std::string shown(bool value) { return value ? "1" : "0"; }
template <class Number>
requires std::is_integral_v<Number> std::string shown(Number value) {
    return std::to_string(value);
}

/// The store keeps nothing that is not finite.
bool same(double a, double b) { return a == b || (!std::isfinite(a) && !std::isfinite(b)); }
template <class Value>
bool same(const Value& a, const Value& b) {
    return a == b;
}

/// The first difference that it is told.
class Difference {
 public:
    template <class Value>
    Difference& of(const char* column, const Value& kept, const Value& found) {
        if (text_.empty() && !same(kept, found))
            text_ = std::string(column) + " " + shown(kept) + ", not " + shown(found);
        return *this;
    }
    void is(const std::string& text) {
        if (text_.empty()) text_ = text;
    }
    [[nodiscard]] const std::string& text() const { return text_; }

 private:
    std::string text_;
};

Said said(const std::string& difference) {
    return Said::listed(
               QT_TRANSLATE_NOOP("Said", "the store holds something else than the recording (%1)"))
        .with(difference);
}

bool same_reason(const assessment::Reason& a, const assessment::Reason& b) {
    return a.item == b.item && a.text == b.text && same(a.points, b.points) &&
           same(a.time_s, b.time_s) && a.critical == b.critical && a.meaning == b.meaning;
}

bool same_metric(const assessment::Metric& a, const assessment::Metric& b) {
    return a.id == b.id && same(a.value, b.value);
}

bool same_event(const sim::Event& a, const sim::Event& b) {
    bool place = true;
    for (int i = 0; i < 3; ++i)
        place = place && same(double{a.rest_position_m[i]}, double{b.rest_position_m[i]});
    return place && same(a.time_s, b.time_s) && a.kind == b.kind && a.tool == b.tool &&
           a.tissue == b.tissue && same(double{a.value}, double{b.value}) &&
           same(double{a.value2}, double{b.value2}) && a.element == b.element;
}

/// Where two lists first part; "" where they do not.
template <class List, class Same>
std::string part_at(const char* table, const List& kept, const List& found, const Same& alike) {
    const auto [at, other] =
        std::mismatch(kept.begin(), kept.end(), found.begin(), found.end(), alike);
    if (at == kept.end() && other == found.end()) return {};
    return std::string(table) + ", position " + std::to_string(at - kept.begin());
}

/// Why the recording makes an attempt void, as saving it says (db/attempts.cpp).
std::vector<VoidReason> voids_of(const AttemptResult& found) {
    std::vector<VoidReason> voids = void_causes(found);
    const HapticVerdict haptics = haptic_verdict(found);
    voids.insert(voids.end(), haptics.voids.begin(), haptics.voids.end());
    return voids;
}

}  // namespace

std::string score_difference(const assessment::MetricSet& metrics, const assessment::Score& score,
                             const assessment::MetricSet& other_metrics,
                             const assessment::Score& other) {
    Difference difference;
    difference.of("points", score.points, other.points)
        .of("verdict", std::string(assessment::verdict_name(score.verdict)),
            std::string(assessment::verdict_name(other.verdict)))
        .of("rubric_id", score.rubric_id, other.rubric_id)
        .of("rubric_version", score.rubric_version, other.rubric_version)
        .of("metric_set_version", score.metric_set_version, other.metric_set_version);
    difference.is(part_at("attempt_metrics", metrics.values, other_metrics.values, same_metric));
    difference.is(part_at("attempt_reasons", score.reasons, other.reasons, same_reason));
    return difference.text();
}

std::optional<Said> facts_that_differ(const AttemptDetail& kept, const sim::Recording& recording) {
    const AttemptRecord& row = kept.record;
    const sim::RecordingHeader& head = recording.header;
    Difference difference;
    difference.of("task_id", row.task_id, head.task_id)
        .of("task_version", row.task_version, head.task_version)
        .of("seed", row.seed, head.seed)
        .of("device", row.device, head.device)
        .of("build", row.build, head.build)
        .of("end_reason", static_cast<int>(row.end), static_cast<int>(recording.end.reason))
        .of("duration_s", row.duration_s, recording.end.duration_s);
    // An older recording may not say when; and more may be called a demonstration than a script.
    if (!head.started_utc.empty()) difference.of("started_utc", row.started_utc, head.started_utc);
    if (head.demonstration) difference.of("demonstration", row.demonstration, true);
    if (difference.text().empty()) return std::nullopt;
    return said(difference.text());
}

ComparedScore compare_score(const AttemptDetail& kept, const AttemptResult& found) {
    const AttemptRecord& row = kept.record;
    if (row.metric_set_version < found.metrics.version ||
        row.preprocessing_version < assessment::kPreprocessingVersion) {
        const bool same_points = row.rubric_id == found.score.rubric_id &&
                                 row.rubric_version == found.score.rubric_version &&
                                 same(row.points, found.score.points) &&
                                 row.verdict == found.score.verdict;
        return {same_points ? ScoreComparison::kSame : ScoreComparison::kOfAnother, {}};
    }
    Difference difference;
    difference.is(score_difference(kept.metrics, kept.score, found.metrics, found.score));
    difference.of("preprocessing_version", row.preprocessing_version,
                  int{assessment::kPreprocessingVersion});
    std::vector<sim::Event> events = found.events;
    std::erase_if(events, [](const sim::Event& each) { return sim::only_in_recording(each.kind); });
    difference.is(part_at("attempt_events", kept.events, events, same_event));
    const std::vector<VoidReason> voids = why_void(row);
    for (const VoidReason& each : voids_of(found)) {
        const std::string text = void_text({each});
        if (std::none_of(voids.begin(), voids.end(),
                         [&](const VoidReason& one) { return void_text({one}) == text; }))
            difference.is("void_reason without \"" + text + "\"");
    }
    if (difference.text().empty()) return {};
    return {ScoreComparison::kDiffers, said(difference.text())};
}

}  // namespace placode::db
