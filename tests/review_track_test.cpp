// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A track shows what the simulation showed: read back as a browser reads it and held against the
// moments of the attempt itself.
#include "reports/review_track.h"

#include <gtest/gtest.h>

#include <QByteArray>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <cmath>
#include <cstring>

#include "reports/review_part.h"
#include "sim/core/as_index.h"
#include "sim/step/snapshot.h"
#include "tests/live_attempt.h"

namespace placode::reports {
namespace THIS_TEST {

using sim::as_index;

/// Reader of the layout in docs/web.md.
class Bytes {
 public:
    explicit Bytes(const std::string& packed) {
        QByteArray with_length(4, '\x04');  // A guess of 67 MB, which Qt takes as a hint.
        with_length += QByteArray::fromStdString(packed);
        all_ = qUncompress(with_length);
    }
    template <class Value>
    std::vector<Value> take(size_t count) {
        std::vector<Value> values(count);
        EXPECT_LE(at_ + count * sizeof(Value), static_cast<size_t>(all_.size()));
        if (count > 0) std::memcpy(values.data(), all_.constData() + at_, count * sizeof(Value));
        at_ += count * sizeof(Value);
        return values;
    }
    [[nodiscard]] bool at_end() const { return at_ == static_cast<size_t>(all_.size()); }

 private:
    QByteArray all_;
    size_t at_ = 0;
};

struct Triangle {
    std::array<uint32_t, 3> corner{};
    uint8_t tissue = 0;
};
struct Moment {
    float time_s = 0;
    std::vector<std::array<double, 3>> x;  ///< Tissue, then contour [m].
    std::vector<std::array<int, 3>> damage;
    std::vector<Triangle> triangles;
    std::vector<float> tools;
    std::vector<uint8_t> flags, cut;
    size_t vertices = 0;
    std::vector<float> needle;
    std::vector<std::array<double, 3>> thread;  ///< [m]
};

int signed_of(int zigzag) { return (zigzag >> 1) ^ -(zigzag & 1); }

std::vector<Moment> moments_of(const std::string& packed) {
    Bytes in(packed);
    const auto head = in.take<uint32_t>(8);
    EXPECT_EQ(head[0], kReviewPartVersion);
    const size_t pictures = head[1], vertices = head[2], surfaces = head[3], contour = head[4],
                 tools = head[5], places = vertices + contour, needles = head[6],
                 thread_points = head[7];
    const auto times = in.take<float>(pictures);
    const auto surface_of = in.take<uint32_t>(pictures);
    const auto states = in.take<float>(pictures * tools * kReviewToolFloats);
    const auto needle = in.take<float>(pictures * needles * kReviewNeedleFloats);
    const auto thread_counts = in.take<uint32_t>(pictures * needles);
    const auto heads = in.take<uint32_t>(2 * surfaces);
    size_t edits = 0;
    for (size_t s = 0; s < surfaces; ++s) edits += heads[2 * s + 1];
    const auto gaps = in.take<uint32_t>(edits);
    const auto flags = in.take<uint8_t>(pictures * tools), corners = in.take<uint8_t>(9 * edits),
               tissue = in.take<uint8_t>(edits), cut = in.take<uint8_t>(pictures * contour),
               damage = in.take<uint8_t>(pictures * 3 * vertices),
               low = in.take<uint8_t>(pictures * 3 * places),
               high = in.take<uint8_t>(pictures * 3 * places),
               thread_low = in.take<uint8_t>(3 * thread_points),
               thread_high = in.take<uint8_t>(3 * thread_points);
    EXPECT_TRUE(in.at_end());
    std::vector<Moment> all;
    std::vector<uint16_t> x(3 * places, 0);
    std::vector<uint8_t> now(3 * vertices, 0);
    std::vector<Triangle> triangles;
    size_t edit = 0, shown = 0, thread_from = 0;
    int first_corner = 0;
    for (size_t p = 0; p < pictures; ++p) {
        Moment moment{times[p], {}, {}, {}, {}, {}, {}, vertices, {}, {}};
        for (size_t i = 0; i < 3 * places; ++i) {
            const int value = low[p * 3 * places + i] | high[p * 3 * places + i] << 8;
            const int before = p > 0 ? x[i] : i > 0 ? x[i - 1] : 0;
            x[i] = static_cast<uint16_t>(before + signed_of(value));
        }
        for (size_t i = 0; i < places; ++i)
            moment.x.push_back({kReviewLeastM + kReviewStepM * x[i],
                                kReviewLeastM + kReviewStepM * x[places + i],
                                kReviewLeastM + kReviewStepM * x[2 * places + i]});
        for (size_t i = 0; i < 3 * vertices; ++i)
            now[i] = static_cast<uint8_t>(now[i] + damage[p * 3 * vertices + i]);
        for (size_t i = 0; i < vertices; ++i)
            moment.damage.push_back({now[i], now[vertices + i], now[2 * vertices + i]});
        for (; shown <= surface_of[p]; ++shown) {
            triangles.resize(heads[2 * shown]);
            size_t next = 0;
            for (size_t e = 0; e < heads[2 * shown + 1]; ++e, ++edit) {
                next += gaps[edit];
                const auto column = [&](size_t k) {
                    const size_t at = k * edits + edit;
                    return corners[at] | corners[at + 3 * edits] << 8 |
                           corners[at + 6 * edits] << 16;
                };
                first_corner += signed_of(column(0));
                const auto first = static_cast<uint32_t>(first_corner);
                triangles.at(next++) = {{first, first + static_cast<uint32_t>(column(1)),
                                         first + static_cast<uint32_t>(column(2))},
                                        tissue[edit]};
            }
        }
        moment.triangles = triangles;
        const auto part = [p](const auto& from, size_t count) {
            return std::vector(from.begin() + static_cast<std::ptrdiff_t>(p * count),
                               from.begin() + static_cast<std::ptrdiff_t>((p + 1) * count));
        };
        moment.tools = part(states, tools * kReviewToolFloats);
        moment.flags = part(flags, tools);
        moment.cut = part(cut, contour);
        if (needles > 0) {
            moment.needle = part(needle, kReviewNeedleFloats);
            for (uint32_t i = 0; i < thread_counts[p]; ++i, ++thread_from) {
                auto& place = moment.thread.emplace_back();
                for (size_t k = 0; k < 3; ++k) {
                    const size_t n = k * thread_points + thread_from;
                    place[k] = kReviewLeastM + kReviewStepM * (thread_low[n] | thread_high[n] << 8);
                }
            }
        }
        all.push_back(moment);
    }
    return all;
}

void expect_near(const std::array<double, 3>& shown, const std::array<float, 3>& was) {
    // Half a step of rounding, those that it may rest, and the float's own last bit at 65 mm.
    for (size_t i = 0; i < 3; ++i)
        ASSERT_NEAR(shown[i], static_cast<double>(was[i]),
                    (kReviewRestSteps + 0.51) * kReviewStepM);
}

/// Every triangle, by where its corners lie, what it is made of and how it is harmed.
void expect_same(const Moment& shown, const sim::Snapshot& was) {
    ASSERT_FLOAT_EQ(shown.time_s, static_cast<float>(was.time_s));
    ASSERT_EQ(shown.triangles.size(), was.triangles.size());
    for (size_t t = 0; t < was.triangles.size(); ++t) {
        const sim::SurfaceTriangle& triangle = was.triangles[t];
        ASSERT_EQ(shown.triangles[t].tissue & 0x7f, static_cast<int>(triangle.tissue));
        ASSERT_EQ(shown.triangles[t].tissue >> 7, triangle.fresh != 0 ? 1 : 0);
        // It begins with the lowest vertex, and goes round as it did.
        const auto turn =
            static_cast<size_t>(std::min_element(triangle.vertex.begin(), triangle.vertex.end()) -
                                triangle.vertex.begin());
        for (size_t k = 0; k < 3; ++k) {
            const auto v = as_index(triangle.vertex[(turn + k) % 3]);
            const uint32_t n = shown.triangles[t].corner[k];
            expect_near(shown.x[n], was.x[v]);
            for (size_t kind = 0; kind < 3; ++kind)
                ASSERT_NEAR(shown.damage[n][kind] / 255.0,
                            std::clamp(static_cast<double>(was.damage[v][kind]), 0.0, 1.0),
                            0.51 / 255);
        }
    }
    const size_t plan = was.contour.size();
    ASSERT_EQ(shown.x.size() - shown.vertices, plan + was.resect_line.size());
    for (size_t i = 0; i < plan; ++i) {
        expect_near(shown.x[shown.vertices + i], was.contour[i]);
        ASSERT_EQ(shown.cut[i], was.contour_cut[i] != 0 ? 1 : 0);
    }
    for (size_t i = 0; i < was.resect_line.size(); ++i) {
        expect_near(shown.x[shown.vertices + plan + i], was.resect_line[i]);
        ASSERT_EQ(shown.cut[plan + i], was.resect_cut[i] != 0 ? 3 : 2);
    }
    for (int i = 0; i < was.tool_count; ++i) {
        const sim::ToolSnapshot& tool = was.tools[as_index(i)];
        const float* state = &shown.tools[as_index(i) * kReviewToolFloats];
        for (int k = 0; k < 3; ++k) ASSERT_FLOAT_EQ(state[k], static_cast<float>(tool.pose.p[k]));
        ASSERT_FLOAT_EQ(state[3], static_cast<float>(tool.pose.q.w()));
        ASSERT_FLOAT_EQ(state[7], tool.jaw_rad);
        ASSERT_EQ(shown.flags[as_index(i)] & 1, tool.engaged != 0 ? 1 : 0);
        ASSERT_EQ(shown.flags[as_index(i)] >> 1 & 1, tool.energised != 0 ? 1 : 0);
    }
}

void expect_same_needle(const Moment& shown, const sim::NeedleSnapshot& was) {
    if (was.present == 0) {
        ASSERT_TRUE(std::all_of(shown.needle.begin(), shown.needle.end(),
                                [](float value) { return value == 0; }));
        return;
    }
    ASSERT_EQ(shown.needle.size(), 7U);
    for (int k = 0; k < 3; ++k)
        ASSERT_FLOAT_EQ(shown.needle[as_index(k)], static_cast<float>(was.pose.p[k]));
    ASSERT_FLOAT_EQ(shown.needle[3], static_cast<float>(was.pose.q.w()));
    ASSERT_EQ(shown.thread.size(), was.thread.size());
    for (size_t i = 0; i < was.thread.size(); ++i) expect_near(shown.thread[i], was.thread[i]);
}

struct Looked {
    size_t moments = 0, least_triangles = SIZE_MAX, most_triangles = 0;
    bool fresh = false, harmed = false;
    size_t needles = 0, most_thread = 0;
};

/// The first seconds of the expert's attempt, and what was to be seen in them.
struct Seen {
    Seen(const std::string& task, double seconds) {
        test::LiveAttempt attempt(curriculum::load_task(task), "expert", seconds, 3);
        while (!attempt.over()) {
            attempt.step();
            if (attempt.state().frame != due_frame(moments.size())) continue;
            sim::fill_snapshot(attempt.scene(), attempt.state(), moments.emplace_back());
        }
        recording = attempt.recording();
    }
    /// Thirty moments a second.
    static int64_t due_frame(size_t moment) {
        return 1 + std::llround(static_cast<double>(moment) * 1000 / 30);
    }
    sim::Recording recording;
    std::vector<sim::Snapshot> moments;
};

/// The track of a recording, which simulates it again, against what was seen.
Looked compare(const Seen& seen, const ReviewTrack& track) {
    Looked looked;
    for (const std::string& part : track.parts)
        for (const Moment& moment : moments_of(part)) {
            const auto due = std::llround(static_cast<double>(moment.time_s) * 1000);
            EXPECT_EQ(due, Seen::due_frame(looked.moments));
            if (looked.moments >= seen.moments.size()) {
                ADD_FAILURE() << "more moments than there were";
                return looked;
            }
            const sim::Snapshot& was = seen.moments[looked.moments];
            expect_same(moment, was);
            expect_same_needle(moment, was.needle);
            looked.needles += was.needle.present;
            looked.most_thread = std::max(looked.most_thread, moment.thread.size());
            if (testing::Test::HasFatalFailure()) return looked;
            ++looked.moments;
            looked.least_triangles = std::min(looked.least_triangles, moment.triangles.size());
            looked.most_triangles = std::max(looked.most_triangles, moment.triangles.size());
            for (const Triangle& each : moment.triangles) looked.fresh |= each.tissue >> 7 != 0;
            for (const auto& each : moment.damage) looked.harmed |= each[1] > 0;
        }
    return looked;
}

QJsonObject head_of(const ReviewTrack& track) {
    return QJsonDocument::fromJson(QByteArray::fromStdString(track.head)).object();
}

TEST(ReviewTrack, ShowsARingAsTheSimulationDid) {
    const Seen seen("diathermy_ring_small", 9);
    const auto track = make_review_track(seen.recording);
    ASSERT_TRUE(track);
    EXPECT_TRUE(track->identical);
    const QJsonObject head = head_of(*track);
    EXPECT_EQ(head["parts"].toInt(), static_cast<int>(track->parts.size()));
    EXPECT_EQ(static_cast<size_t>(head["tools"].toArray().size()),
              seen.recording.header.tools.size());
    EXPECT_NEAR(head["until_s"].toDouble(), 9, 0.04);
    const Looked looked = compare(seen, *track);
    EXPECT_EQ(static_cast<int>(looked.moments), head["pictures"].toInt());
    EXPECT_NEAR(static_cast<double>(looked.moments), 9 * 30, 1);
    EXPECT_TRUE(looked.fresh) << "nothing was burned away: the test saw no change of the surface";
    EXPECT_TRUE(looked.harmed);
    RecordProperty("bytes_a_second", static_cast<int>(static_cast<double>(track->bytes()) / 9));
}

TEST(ReviewTrack, ShowsScissorsAsTheSimulationDid) {
    const Seen seen("scissors_resection", 14);
    const auto track = make_review_track(seen.recording);
    ASSERT_TRUE(track);
    const Looked looked = compare(seen, *track);
    EXPECT_GT(looked.most_triangles, looked.least_triangles) << "nothing was cut";
    EXPECT_TRUE(looked.fresh);
}

TEST(ReviewTrack, ShowsNeedleAndThreadAsTheSimulationDid) {
    const Seen seen("suture_bite", 9);
    const auto track = make_review_track(seen.recording);
    ASSERT_TRUE(track);
    EXPECT_NEAR(head_of(*track)["needle"].toObject()["arc_m"].toDouble(), 0.017, 1e-9);
    const Looked looked = compare(seen, *track);
    EXPECT_GT(looked.needles, 200U);
    EXPECT_GT(looked.most_thread, 1U);
}

TEST(ReviewTrack, SaysWhereTheSimulationDiffers) {
    sim::Recording recording = test::scripted_seconds("touch_targets", 6);
    bool changed = false;
    for (sim::Event& event : recording.events)
        if (!changed && event.kind == sim::EventKind::kStateHash && event.time_s > 2) {
            event.hash ^= 1;
            changed = true;
        }
    ASSERT_TRUE(changed);
    const auto track = make_review_track(recording);
    ASSERT_TRUE(track);
    EXPECT_FALSE(track->identical);
    EXPECT_LT(track->until_s, 5);
    EXPECT_FALSE(head_of(*track)["identical"].toBool(true));
}

TEST(ReviewTrack, IsBrokenOffWhenNobodyWantsItAnyMore) {
    const sim::Recording recording = test::scripted_seconds("touch_targets", 3);
    double last = -1;
    int asked = 0;
    EXPECT_FALSE(make_review_track(recording, [&](double share) {
        EXPECT_GT(share, last);
        last = share;
        return ++asked < 4;
    }));
    EXPECT_EQ(asked, 4);
    EXPECT_LT(last, 0.3);
}

TEST(ReviewTrack, OfATaskThatCannotBeBuiltIsRefused) {
    sim::Recording recording = test::scripted_seconds("touch_targets", 1);
    recording.header.task_json = "{}";
    EXPECT_ANY_THROW((void)make_review_track(recording));
}

}  // namespace THIS_TEST
}  // namespace placode::reports
