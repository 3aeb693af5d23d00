// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/recording_file.h"

#include <gtest/gtest.h>
#include <sqlite3.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <thread>

#include "db/recording_chunks.h"
#include "db/store.h"
#include "tests/scratch_root.h"

using namespace placode;
namespace fs = std::filesystem;

namespace THIS_TEST {

class Folder {
 public:
    Folder() {
        std::string name = (test::scratch_root() / "placode-recording-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("mkdtemp");
        path_ = name;
    }
    ~Folder() { fs::remove_all(path_); }
    [[nodiscard]] std::string file(const std::string& name) const {
        return (path_ / name).string();
    }
    [[nodiscard]] std::string path() const { return path_.string(); }

 private:
    fs::path path_;
};

sim::RecordingHeader make_header() {
    sim::RecordingHeader header;
    header.task_id = "diathermy_ring";
    header.task_version = 3;
    header.task_json = "{\"id\": \"diathermy_ring\", \"note\": \"zażółć \\\"quoted\\\"\"}";
    header.seed = 0xfedcba9876543210ULL;  // Above the signed range.
    header.build = "0.1.0 AVX2";
    header.device = "script:expert";
    header.started_utc = "2026-01-02T03:04:05.678Z";
    header.demonstration = true;
    header.tools.emplace_back();
    header.tools[0].pivot_m = sim::Vec3(0.1, 1.0 / 3.0, -std::sqrt(2.0));
    header.geometry.planned_contour = {{0.1, 0.2, 0.3}, {1e-300, -0.7, std::nextafter(1.0, 2.0)}};
    header.geometry.placode_volume_m3 = 1.0 / 7.0 * 1e-9;
    return header;
}

std::vector<sim::Input> make_inputs(int64_t first, int count) {
    std::vector<sim::Input> inputs(static_cast<size_t>(count));
    for (int i = 0; i < count; ++i) {
        auto& input = inputs[static_cast<size_t>(i)];
        const double t = static_cast<double>(first + i) * 1e-3;
        input.frame = first + i;
        input.tool_count = 1;
        input.tools[0].position_m = {static_cast<float>(0.006 * std::cos(t)),
                                     static_cast<float>(0.004 * std::sin(t)), 0.0021f};
        input.tools[0].pedals = (i / 100) % 2 ? sim::kPedalCut : 0;
        input.tools[0].engaged = 1;
    }
    return inputs;
}

std::vector<sim::Sample> make_samples(int64_t first_frame, int count) {
    std::vector<sim::Sample> samples(static_cast<size_t>(count));
    for (int i = 0; i < count; ++i) {
        auto& sample = samples[static_cast<size_t>(i)];
        sample.time_s = static_cast<double>(first_frame) * 1e-3 + 0.01 * (i + 1);
        sample.tools[0].force_n = {0, 0, static_cast<float>(std::sin(0.1 * i))};
        sample.tools[0].touched = sim::Tissue::kZone;
        sample.cut_fraction = 0.25f;
        sample.phase = sim::Phase::kIncise;
        sample.step_flags = 0x80000001u;
    }
    return samples;
}

sim::Event make_event(double time_s) {
    sim::Event event;
    event.time_s = time_s;
    event.kind = sim::EventKind::kStateHash;
    event.tissue = sim::Tissue::kPlacode;
    event.value = 1.5f;
    event.element = 12345;
    event.hash = 0xffffffffffffff01ULL;
    return event;
}

/// Half a second: 500 inputs, 50 samples, one event.
void append_half_second(sim::RecordingSink& sink, int index) {
    const int64_t first = int64_t{500} * index;
    const sim::Event event = make_event(0.5 * index);
    sink.append(make_inputs(first, 500), make_samples(first, 50), {&event, 1});
}

void write_recording(const std::string& path, int halves, bool finished = true) {
    const auto sink = db::create_recording_file(path);
    sink->begin(make_header());
    for (int i = 0; i < halves; ++i) append_half_second(*sink, i);
    if (finished) sink->finish({sim::EndReason::kFinished, 0.5 * halves, ~uint64_t{0}, 2});
}

bool same_bits(const sim::ToolInput& a, const sim::ToolInput& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;  // 36 bytes, no padding.
}

/// Kind and text of what reading throws.
std::pair<db::StoreError::Kind, std::string> failure_of(const std::string& path) {
    try {
        (void)db::read_recording_file(path);
    } catch (const db::StoreError& error) {
        return {error.kind(), error.what()};
    }
    return {db::StoreError::Kind::kOther, "nothing was thrown"};
}

std::string read_text(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

void write_text(const std::string& path, const std::string& text) {
    std::ofstream(path, std::ios::binary | std::ios::trunc) << text;
}

void execute(const std::string& path, const std::string& sql) {
    sqlite3* database = nullptr;
    ASSERT_EQ(sqlite3_open(path.c_str(), &database), SQLITE_OK);
    ASSERT_EQ(sqlite3_exec(database, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK) << sql;
    sqlite3_close(database);
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST(RecordingFile, GivesBackEveryBit) {
    const Folder folder;
    const std::string path = folder.file("a.placode");
    write_recording(path, 3);
    const sim::Recording read = db::read_recording_file(path);

    const sim::RecordingHeader header = make_header();
    EXPECT_EQ(read.header.task_id, header.task_id);
    EXPECT_EQ(read.header.task_version, 3);
    EXPECT_EQ(read.header.task_json, header.task_json);
    EXPECT_EQ(read.header.seed, header.seed);
    EXPECT_EQ(read.header.build, header.build);
    EXPECT_EQ(read.header.device, header.device);
    EXPECT_EQ(read.header.started_utc, header.started_utc);
    EXPECT_TRUE(read.header.demonstration);
    EXPECT_EQ(read.header.frame_s, 1e-3);
    ASSERT_EQ(read.header.tools.size(), 1u);
    EXPECT_EQ(read.header.tools[0].pivot_m, header.tools[0].pivot_m);
    EXPECT_EQ(read.header.tools[0].hand_n_m, header.tools[0].hand_n_m);
    EXPECT_EQ(read.header.geometry.planned_contour, header.geometry.planned_contour);
    EXPECT_EQ(read.header.geometry.placode_volume_m3, header.geometry.placode_volume_m3);

    const auto inputs = make_inputs(0, 1500);
    ASSERT_EQ(read.inputs.size(), 1500u);
    for (size_t i = 0; i < 1500; ++i) {
        ASSERT_EQ(read.inputs[i].frame, inputs[i].frame);
        // make_inputs starts its pedal pattern anew in every half second.
        if (i < 500) {
            ASSERT_TRUE(same_bits(read.inputs[i].tools[0], inputs[i].tools[0])) << i;
        }
    }
    ASSERT_EQ(read.samples.size(), 150u);
    EXPECT_EQ(read.samples[149].time_s, make_samples(1000, 50)[49].time_s);
    EXPECT_EQ(read.samples[60].tools[0].force_n, make_samples(500, 50)[10].tools[0].force_n);
    EXPECT_EQ(read.samples[0].step_flags, 0x80000001u);
    EXPECT_EQ(read.samples[0].tools[0].touched, sim::Tissue::kZone);
    ASSERT_EQ(read.events.size(), 3u);
    EXPECT_EQ(read.events[2].hash, 0xffffffffffffff01ULL);
    EXPECT_EQ(read.events[2].element, 12345);
    EXPECT_EQ(read.end.reason, sim::EndReason::kFinished);
    EXPECT_EQ(read.end.final_hash, ~uint64_t{0});
    EXPECT_EQ(read.end.dropped, 2);
}

/// What was given, in more than one chunk.
void write_staged(const std::string& path, sim::RecordingHeader header) {
    const auto sink = db::create_recording_file(path);
    sink->begin(header);
    sink->give(make_inputs(0, 70'000));
    append_half_second(*sink, 0);
    sink->finish({sim::EndReason::kFinished, 0.5, 1, 0});
}

sim::RecordingHeader staged_header() {
    sim::RecordingHeader header = make_header();
    header.stage = 2;
    header.given_frames = 70'000;
    header.given_hash = ~uint64_t{0} - 5;
    return header;
}

TEST(RecordingFile, KeepsWhatWasGivenBeforeAStage) {
    const Folder folder;
    const std::string path = folder.file("a.placode"), plain = folder.file("b.placode");
    write_staged(path, staged_header());
    const sim::Recording read = db::read_recording_file(path);
    EXPECT_EQ(read.header.stage, 2);
    EXPECT_EQ(read.header.given_frames, 70'000);
    EXPECT_EQ(read.header.given_hash, ~uint64_t{0} - 5);
    const auto given = make_inputs(0, 70'000);
    ASSERT_EQ(read.given.size(), given.size());
    for (size_t i = 0; i < given.size(); i += 997)
        ASSERT_TRUE(read.given[i].frame == given[i].frame &&
                    same_bits(read.given[i].tools[0], given[i].tools[0]))
            << i;
    EXPECT_EQ(read.inputs.size(), 500U);
    EXPECT_EQ(db::recording_summary(path).header.stage, 2);
    EXPECT_DOUBLE_EQ(db::recording_summary(path).end.duration_s, 0.5) << "its own part";
    write_recording(plain, 1);
    EXPECT_EQ(db::read_recording_file(plain).header.stage, 0);
    EXPECT_TRUE(db::read_recording_file(plain).given.empty());
}

TEST(RecordingFile, WhatWasGivenIsWholeAndToldInTheHeader) {
    const Folder folder;
    const std::string less = folder.file("less.placode"), silent = folder.file("silent.placode"),
                      gone = folder.file("gone.placode");
    sim::RecordingHeader header = staged_header();
    header.given_frames = 70'001;
    write_staged(less, header);
    EXPECT_TRUE(contains(failure_of(less).second, "70000 inputs, the header says 70001"))
        << failure_of(less).second;
    write_staged(silent, make_header());
    EXPECT_TRUE(contains(failure_of(silent).second, "70000 inputs, the header says 0"))
        << failure_of(silent).second;
    write_staged(gone, staged_header());
    execute(gone, "DELETE FROM chunks WHERE kind = 'given'");
    EXPECT_EQ(failure_of(gone).first, db::StoreError::Kind::kDamaged);
}

TEST(RecordingFile, AStageThatCannotBeIsRefused) {
    const Folder folder;
    int at = 0;
    for (const auto& [stage, frames] :
         {std::pair<int, int64_t>{-1, 10}, {9, 10}, {1, 0}, {1, -5}, {1, int64_t{1} << 40}}) {
        sim::RecordingHeader header = make_header();
        header.stage = stage;
        header.given_frames = frames;
        const std::string path = folder.file(std::to_string(at++) + ".placode");
        db::create_recording_file(path)->begin(header);
        EXPECT_EQ(failure_of(path).first, db::StoreError::Kind::kDamaged) << stage << " " << frames;
        EXPECT_TRUE(contains(failure_of(path).second, stage == 1 ? "\"frames\"" : "\"stage\""))
            << failure_of(path).second;
    }
}

TEST(RecordingFile, KeepsTheHapticCertificateOfItsAttempt) {
    const Folder folder;
    const std::string path = folder.file("a.placode");
    write_recording(path, 1);
    EXPECT_EQ(db::haptic_certificate(path), "") << "an older file, or a crash";
    const std::string json = R"({"format":1,"ticks":1000})";
    db::add_haptic_certificate(path, json);
    EXPECT_EQ(db::haptic_certificate(path), json);
    EXPECT_THROW(db::add_haptic_certificate(path, "{}"), db::StoreError) << "once only";
    EXPECT_EQ(db::haptic_certificate(path), json);
    EXPECT_EQ(db::read_recording_file(path).inputs.size(), 500u) << "the rest is untouched";
    execute(path, "UPDATE meta SET value = '{}' WHERE key = 'haptics'");
    EXPECT_THROW((void)db::haptic_certificate(path), db::StoreError) << "the checksum tells";
    EXPECT_THROW((void)db::haptic_certificate(folder.file("none.placode")), db::StoreError);
}

TEST(RecordingFile, KeepsNotANumberAndInfinityBitForBit) {
    std::vector<sim::Sample> samples(2);
    samples[0].placode_peak_c = std::numeric_limits<float>::quiet_NaN();
    samples[1].placode_peak_c = -std::numeric_limits<float>::infinity();
    std::vector<sim::Sample> back;
    db::decode_chunk(db::encode_chunk(std::span<const sim::Sample>(samples)), 2, back);
    EXPECT_EQ(std::memcmp(&back[0].placode_peak_c, &samples[0].placode_peak_c, 4), 0);
    EXPECT_EQ(back[1].placode_peak_c, samples[1].placode_peak_c);
}

TEST(RecordingFile, IsWrittenByAnotherThreadThanTheOneThatMadeIt) {
    const Folder folder;
    const std::string path = folder.file("a.placode");
    auto sink = db::create_recording_file(path);
    std::thread([&sink] {
        sink->begin(make_header());
        append_half_second(*sink, 0);
        sink->finish({sim::EndReason::kFinished, 0.5, 1, 0});
    }).join();
    EXPECT_EQ(db::read_recording_file(path).inputs.size(), 500u);
}

TEST(RecordingFile, IsNeverOverwritten) {
    const Folder folder;
    const std::string path = folder.file("a.placode");
    write_recording(path, 1);
    const std::string before = read_text(path);
    try {
        (void)db::create_recording_file(path);
        FAIL() << "an existing file was opened for writing";
    } catch (const db::StoreError& error) {
        EXPECT_EQ(error.kind(), db::StoreError::Kind::kConflict);
        EXPECT_TRUE(contains(error.what(), path)) << error.what();
    }
    EXPECT_EQ(read_text(path), before);
}

TEST(RecordingFile, AFolderThatIsNotThereIsNamed) {
    EXPECT_THROW((void)db::create_recording_file("/nonexistent-folder/a.placode"), db::StoreError);
}

TEST(RecordingFile, WithoutAnEndIsInterruptedAndAsLongAsWhatWasCommitted) {
    const Folder folder;
    const std::string path = folder.file("a.placode");
    write_recording(path, 3, false);
    const sim::Recording read = db::read_recording_file(path);
    EXPECT_EQ(read.end.reason, sim::EndReason::kInterrupted);
    EXPECT_NEAR(read.end.duration_s, 1.5, 1e-9);  // 1500 frames of 1 ms.
}

TEST(RecordingFile, TheSummarySaysWhatTheWholeFileSays) {
    const Folder folder;
    for (const bool finished : {true, false}) {
        const std::string path = folder.file(finished ? "whole.placode" : "broken.placode");
        write_recording(path, 5, finished);
        const db::RecordingSummary brief = db::recording_summary(path);
        const sim::Recording whole = db::read_recording_file(path);
        EXPECT_EQ(brief.header.task_id, whole.header.task_id);
        EXPECT_EQ(brief.header.started_utc, whole.header.started_utc);
        EXPECT_EQ(brief.end.reason, whole.end.reason);
        EXPECT_EQ(brief.end.final_hash, whole.end.final_hash);
        EXPECT_NEAR(brief.end.duration_s, whole.end.duration_s, 1e-9);
    }
    // Whoever damages the end of an exam's recording does not make it as if it had not been.
    const std::string damaged = folder.file("whole.placode");
    execute(damaged, "UPDATE meta SET value = '{}' WHERE key = 'end'");
    const auto recovered = db::recover_recording_file(damaged);
    EXPECT_GT(recovered.recording.end.duration_s, 2);
    EXPECT_EQ(db::recording_summary(damaged).end.duration_s, recovered.recording.end.duration_s);
    EXPECT_EQ(db::recording_summary(damaged).end.reason, recovered.recording.end.reason);
    write_text(folder.file("no.placode"), "nothing");
    EXPECT_THROW((void)db::recording_summary(folder.file("no.placode")), db::StoreError);
}

TEST(RecordingFile, AKilledWriterLosesOnlyWhatItHadNotAppended) {
    const Folder folder;
    const std::string path = folder.file("a.placode");
    int channel[2];
    ASSERT_EQ(::pipe(channel), 0);
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        // Appends without end and reports every append that returned.
        const auto sink = db::create_recording_file(path);
        sink->begin(make_header());
        for (int i = 0;; ++i) {
            append_half_second(*sink, i);
            const int done = i + 1;
            if (::write(channel[1], &done, sizeof done) != sizeof done) ::_exit(1);
        }
    }
    ::close(channel[1]);
    int appended = 0;
    while (appended < 8) ASSERT_EQ(::read(channel[0], &appended, sizeof appended), 4);
    EXPECT_TRUE(db::leftover_recordings(folder.path()).empty()) << "its writer is alive";
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status));
    int report = 0;
    while (::read(channel[0], &report, sizeof report) == sizeof report) appended = report;
    ::close(channel[0]);

    ASSERT_EQ(db::leftover_recordings(folder.path()), std::vector<std::string>{path});
    const sim::Recording read = db::read_recording_file(path);
    EXPECT_EQ(read.end.reason, sim::EndReason::kInterrupted);
    EXPECT_EQ(read.inputs.size() % 500, 0u) << "an append is all or nothing";
    const int whole = static_cast<int>(read.inputs.size() / 500);
    EXPECT_GE(whole, appended);
    EXPECT_LE(whole, appended + 1) << "committed, but killed before it could say so";
    EXPECT_EQ(read.samples.size(), static_cast<size_t>(50 * whole));
}

TEST(RecordingFile, AFinishedFileThatNobodyTookIsLeftOver) {
    const Folder folder;
    write_recording(folder.file("b.placode"), 1);
    write_recording(folder.file("a.placode"), 1);
    write_text(folder.file("note.txt"), "not a recording");
    EXPECT_EQ(db::leftover_recordings(folder.path()),
              (std::vector<std::string>{folder.file("a.placode"), folder.file("b.placode")}));
    EXPECT_TRUE(db::leftover_recordings("/nonexistent-folder").empty());
}

TEST(RecordingFile, AFlippedByteIsFoundAndItsChunkIsNamed) {
    const Folder folder;
    const std::string path = folder.file("a.placode");
    write_recording(path, 4);
    // Chunks are 1 inputs, 2 samples, 3 events, 4 inputs, ...: number 7 starts the second 1.0 s.
    execute(path,
            "UPDATE chunks SET content = CAST(substr(content, 1, 20) || x'5a' || substr(content, "
            "22) AS BLOB) WHERE id = 7");
    const auto [kind, text] = failure_of(path);
    EXPECT_EQ(kind, db::StoreError::Kind::kDamaged) << text;
    EXPECT_TRUE(contains(text, path) && contains(text, "chunk 7")) << text;
    EXPECT_TRUE(contains(text, "1.00 s before it are whole")) << text;

    const auto recovered = db::recover_recording_file(path);
    EXPECT_EQ(recovered.recording.inputs.size(), 1000u);
    EXPECT_EQ(recovered.recording.end.reason, sim::EndReason::kInterrupted);
    EXPECT_NEAR(recovered.recording.end.duration_s, 1.0, 1e-9);
    EXPECT_TRUE(contains(recovered.damage, "chunk 7"));
}

TEST(RecordingFile, AMissingChunkIsFound) {
    const Folder folder;
    const std::string path = folder.file("a.placode");
    write_recording(path, 2);
    execute(path, "DELETE FROM chunks WHERE id = 4");
    EXPECT_TRUE(contains(failure_of(path).second, "chunk 4: is missing"));
}

TEST(RecordingFile, EveryTruncationIsToldAndNeverCrashes) {
    const Folder folder;
    const std::string whole = folder.file("whole.placode");
    write_recording(whole, 4);
    const std::string bytes = read_text(whole);
    const std::string path = folder.file("cut.placode");
    size_t recovered_some = 0;
    for (size_t size = 0; size < bytes.size(); size += bytes.size() / 23) {
        write_text(path, bytes.substr(0, size));
        const auto [kind, text] = failure_of(path);
        EXPECT_EQ(kind, db::StoreError::Kind::kDamaged) << size << ": " << text;
        EXPECT_TRUE(contains(text, path)) << text;
        try {
            recovered_some += db::recover_recording_file(path).recording.inputs.empty() ? 0u : 1u;
        } catch (const db::StoreError&) {
            // Cut before the header: nothing to recover.
        }
    }
    EXPECT_GT(recovered_some, 0u);
}

TEST(RecordingFile, EveryFlippedByteIsToldOrHarmless) {
    const Folder folder;
    const std::string whole = folder.file("whole.placode");
    write_recording(whole, 2);
    const std::string bytes = read_text(whole);
    const sim::Recording truth = db::read_recording_file(whole);
    const std::string path = folder.file("flipped.placode");
    size_t told = 0;
    for (size_t at = 0; at < bytes.size(); at += 97) {
        std::string flipped = bytes;
        flipped[at] = static_cast<char>(flipped[at] ^ 0x41);
        write_text(path, flipped);
        try {
            const sim::Recording read = db::read_recording_file(path);
            // Not told: then it was free space, and what is read is the truth.
            ASSERT_EQ(read.inputs.size(), truth.inputs.size()) << "byte " << at;
            ASSERT_EQ(read.header.seed, truth.header.seed) << "byte " << at;
            ASSERT_EQ(read.end.final_hash, truth.end.final_hash) << "byte " << at;
            for (size_t i = 0; i < read.inputs.size(); ++i)
                ASSERT_TRUE(same_bits(read.inputs[i].tools[0], truth.inputs[i].tools[0])) << at;
        } catch (const db::StoreError&) {
            ++told;
        }
    }
    EXPECT_GT(told, 10u);
}

TEST(RecordingFile, WhatIsNoRecordingIsToldApart) {
    const Folder folder;
    const std::string path = folder.file("a.placode");
    EXPECT_EQ(failure_of(path).first, db::StoreError::Kind::kNotFound);
    write_text(path, "");
    EXPECT_TRUE(contains(failure_of(path).second, "the file is empty"));
    write_text(path, std::string(5000, 'x'));
    EXPECT_TRUE(contains(failure_of(path).second, "not a recording"));
    fs::remove(path);
    execute(path, "CREATE TABLE t (x)");
    EXPECT_TRUE(contains(failure_of(path).second, "another program"));
    EXPECT_EQ(failure_of(path).first, db::StoreError::Kind::kDamaged);
}

TEST(RecordingFile, AnAttemptThatNeverBeganLeavesNoFile) {
    const Folder folder;
    const std::string path = folder.file("a.placode");
    (void)db::create_recording_file(path);
    EXPECT_FALSE(fs::exists(path));
}

TEST(RecordingFile, OneWithoutAHeaderSaysThatItNeverBegan) {
    const Folder folder;
    const std::string path = folder.file("a.placode");
    write_recording(path, 1);
    execute(path, "DELETE FROM meta WHERE key = 'header'");
    EXPECT_TRUE(contains(failure_of(path).second, "never began"));
}

TEST(RecordingFile, ANewerFormatIsRefused) {
    const Folder folder;
    const std::string path = folder.file("a.placode");
    write_recording(path, 1);
    execute(path, "PRAGMA user_version = 999");
    const auto [kind, text] = failure_of(path);
    EXPECT_EQ(kind, db::StoreError::Kind::kTooNew);
    EXPECT_TRUE(contains(text, "999")) << text;
}

TEST(RecordingFile, AHeaderWithAWrongKindOfValueNamesTheKey) {
    std::string json = db::header_to_json(make_header());
    const std::string from = "\"frame_s\":0.001";
    json.replace(json.find(from), from.size(), "\"frame_s\":\"1 ms\"");
    try {
        (void)db::header_from_json(json);
        FAIL();
    } catch (const db::StoreError& error) {
        EXPECT_TRUE(contains(error.what(), "frame_s")) << error.what();
    }
}

TEST(RecordingFile, SaysWhereTheScopeLookedFirstAndOlderOnesLookedAtTheLesion) {
    sim::RecordingHeader header = make_header();
    header.tools[0].kind = sim::ToolKind::kScope;
    header.tools[0].look_at_m = sim::Vec3(0.011, 0, 0);
    header.tools[0].look_from_m = 0.038;
    std::string json = db::header_to_json(header);
    const sim::ToolSpec scope = db::header_from_json(json).tools[0];
    EXPECT_EQ(scope.look_at_m, header.tools[0].look_at_m);
    EXPECT_EQ(scope.look_from_m, 0.038);
    for (const std::string key : {"look_at_m", "look_from_m"})
        json.replace(json.find(key), key.size(), "x" + key.substr(1));
    const sim::ToolSpec older = db::header_from_json(json).tools[0];
    EXPECT_TRUE(older.look_at_m.isZero());
    EXPECT_EQ(older.look_from_m, sim::ToolSpec{}.look_from_m);
}

}  // namespace THIS_TEST
