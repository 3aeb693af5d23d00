// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What lies beside a recording that was left over says whose it is, and only as it was written
// when the attempt began: who changes it, or takes it away, has no exam.

#include "ui/shell/attempt_order.h"

#include <gmock/gmock.h>

#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>

#include "curriculum/utc_time.h"
#include "db/attempt_counting.h"
#include "db/course_conduct.h"
#include "db/evidence.h"
#include "db/recording_file.h"
#include "db/recording_order.h"
#include "db/sql_connection.h"
#include "tests/attempt_fixture.h"
#include "tests/exam_course.h"
#include "tests/forgeries.h"
#include "tests/store_fixture.h"
#include "ui/shell/attempt_launcher.h"

using namespace placode;
using namespace placode::test;
using db::VoidCause;

namespace THIS_TEST {

World* const world = World::install();

/// A few seconds of a scripted operator, who reaches a target.
const sim::Recording& short_attempt(curriculum::AttemptMode mode) {
    static std::map<curriculum::AttemptMode, sim::Recording> made;
    if (const auto found = made.find(mode); found != made.end()) return found->second;
    curriculum::AttemptOptions options;
    options.device = "script:expert";
    options.fast = true;
    options.threads = 1;
    options.duration_s = 4.5;
    options.mode = mode;
    options.started_utc = "2026-02-01T00:00:00Z";
    const curriculum::Task task = curriculum::load_task("touch_targets");
    options.steps = task.steps;
    const auto kept = std::make_shared<sim::Recording>();
    curriculum::AttemptRunner runner(task, 3, options, std::make_unique<MemorySink>(kept));
    runner.start();
    runner.wait();
    return made.emplace(mode, std::move(*kept)).first->second;
}

class AttemptOrders : public testing::Test {
 protected:
    void SetUp() override {
        ::setenv("PLACODE_STATION_KEY", folder.file("station.key").c_str(), 1);
        db::StoreOptions options;
        options.cheap_passwords = true;
        store = db::open_store("sqlite:" + folder.file("placode.db"), options);
        anna = add("anna", db::Role::kTrainee);
        jan = add("jan", db::Role::kTrainee);
        add("nina", db::Role::kEducator);
        add("olga", db::Role::kEducator);
        publish_exam(*store, "touch_targets", "3");
        for (const int64_t user : {anna, jan}) assign_exam(*store, user);
    }
    int64_t add(const std::string& login, db::Role role) const {
        return store->accounts().create({login, "Dr " + login, "long enough 1",
                                         static_cast<db::Roles>(role), role == db::Role::kTrainee});
    }
    [[nodiscard]] ui::AttemptOrder exam() const {
        ui::AttemptOrder order;
        order.user_id = anna;
        order.user_name = "Anna";
        order.task = "touch_targets";
        order.device = "script:expert";
        order.demonstration = true;
        order.seed = 3;
        order.exam = db::begin_exam(*store, anna,
                                    db::prepare_exam(*store, anna, "short", "final", "nina", "",
                                                     db::utc_now()))
                         .context;
        return order;
    }
    /// As the shell and the simulator it starts do. @param bound false: an older simulator.
    void perform(ui::AttemptOrder& order, bool bound = true) const {
        ui::write_order(order, QString::fromStdString(folder.file("recordings")));
        const QStringList arguments = ui::simulator_arguments(order, {});
        const auto at = arguments.indexOf("--order");
        ASSERT_GT(at, 0);
        const auto sink =
            db::create_recording_file(order.recording_file.toStdString(),
                                      bound ? arguments[at + 1].toStdString() : std::string());
        sim::Recording made = short_attempt(order.mode());
        // No two recordings are the same bytes.
        made.header.started_utc =
            curriculum::utc_text(*curriculum::utc_seconds(db::utc_now()) - 100 + ++performed);
        sink->begin(made.header);
        sink->append(made.inputs, made.samples, made.events);
        sink->finish(made.end);
    }
    /// As the page of what was left over does after a crash.
    db::AttemptRecord recover(const QString& recording_file) const {
        ui::AttemptOrder order = ui::read_order(recording_file).value_or(ui::AttemptOrder{});
        order.recording_file = recording_file;
        if (order.user_id == 0) order.user_id = anna;  // chosen by an administrator
        const ui::SavedAttempt saved = ui::save_recording(*store, order);
        EXPECT_EQ(saved.outcome, ui::Saving::kSaved);
        if (store->attempts().detail(saved.attempt_id).record.replay == db::ReplayState::kWaiting)
            (void)db::verify_attempt(*store, saved.attempt_id);
        return store->attempts().detail(saved.attempt_id).record;
    }
    static QString beside(const ui::AttemptOrder& order) {
        return order.recording_file + ".order.json";
    }
    static std::string read(const QString& path) {
        QFile file(path);
        EXPECT_TRUE(file.open(QIODevice::ReadOnly));
        return file.readAll().toStdString();
    }
    static void rewrite(const QString& path, const std::string& text) {
        QFile file(path);
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(QByteArray::fromStdString(text));
    }
    static std::vector<VoidCause> causes(const db::AttemptRecord& record) {
        std::vector<VoidCause> list;
        for (const auto& reason : db::void_reasons(record.void_reason))
            list.push_back(reason.cause);
        return list;
    }

    TemporaryFolder folder;
    std::unique_ptr<db::Store> store;
    int64_t anna = 0, jan = 0;
    mutable int performed = 0;
};

TEST_F(AttemptOrders, AnExamThatACrashLeftCountsAsItWasBegun) {
    ui::AttemptOrder order = exam();
    perform(order);
    const db::AttemptRecord kept = recover(order.recording_file);
    EXPECT_EQ(kept.void_reason, "");
    EXPECT_TRUE(db::counts(kept));
    EXPECT_EQ(kept.user_id, anna);
    EXPECT_EQ(kept.exam.stage_id, "final");
    EXPECT_EQ(kept.exam.proctor, "Dr nina");
    EXPECT_FALSE(QFile::exists(beside(order)));
}

TEST_F(AttemptOrders, WhoChangesTheOrderHasNoExam) {
    sim::SplitMix64 random(1);
    for (const OrderForgery& forgery : forgeries_of_the_order({jan, "olga", "other"})) {
        SCOPED_TRACE(forgery.name);
        ui::AttemptOrder order = exam();
        perform(order);
        auto json = nlohmann::json::parse(read(beside(order)));
        forgery.make(json, random);
        rewrite(beside(order), json.dump());
        const db::AttemptRecord kept = recover(order.recording_file);
        EXPECT_FALSE(db::counts(kept));
        EXPECT_THAT(causes(kept), testing::Contains(VoidCause::kOrderDiffers));
    }
}

TEST_F(AttemptOrders, PracticeIsMadeNoExamLater) {
    ui::AttemptOrder practice = exam();
    practice.exam = {};
    perform(practice);
    auto json = nlohmann::json::parse(read(beside(practice)));
    json["exam_course"] = "short";
    json["exam_course_version"] = 1;
    json["exam_stage"] = "final";
    json["proctor"] = "nina";
    rewrite(beside(practice), json.dump());
    const db::AttemptRecord kept = recover(practice.recording_file);
    EXPECT_FALSE(db::counts(kept));
    EXPECT_THAT(causes(kept),
                testing::ElementsAre(VoidCause::kOrderDiffers, VoidCause::kExamClosed));
}

TEST_F(AttemptOrders, WithoutItsOrderAnExamIsNoneAndPracticeIsStillPractice) {
    ui::AttemptOrder order = exam();
    perform(order);
    ASSERT_TRUE(QFile::remove(beside(order)));
    EXPECT_THAT(causes(recover(order.recording_file)),
                testing::ElementsAre(VoidCause::kOrderMissing));
    ui::AttemptOrder unbound = exam();
    perform(unbound, false);
    EXPECT_THAT(causes(recover(unbound.recording_file)),
                testing::ElementsAre(VoidCause::kOrderMissing));
    ui::AttemptOrder practice = exam();
    practice.exam = {};
    perform(practice);
    ASSERT_TRUE(QFile::remove(beside(practice)));
    const db::AttemptRecord kept = recover(practice.recording_file);
    EXPECT_EQ(kept.void_reason, "") << "an administrator says whose it is";
}

TEST_F(AttemptOrders, TheRecordingHoldsNoNames) {
    ui::AttemptOrder order = exam();
    perform(order);
    const std::string begun = db::recorded_order(order.recording_file.toStdString());
    EXPECT_TRUE(db::is_order_checksum(begun));
    const std::string bytes = read(order.recording_file);
    for (const char* name : {"Anna", "nina"})
        EXPECT_EQ(bytes.find(name), std::string::npos) << name;
    EXPECT_EQ(read(beside(order)).find("Anna"), std::string::npos) << "nor does its order";
    // Nobody finds the name by trying: the same order again has another checksum.
    ui::AttemptOrder same = exam();
    perform(same);
    EXPECT_NE(db::recorded_order(same.recording_file.toStdString()), begun);
}

TEST_F(AttemptOrders, AnErasureReadsWhoseARecordingIsAsTheShellWroteIt) {
    ui::AttemptOrder order;
    order.user_id = anna;
    order.task = "touch_targets";
    order.study = "pilot";
    order.participant = "P001-X";
    ui::write_order(order, QString::fromStdString(folder.file("recordings")));
    const std::string recording = order.recording_file.toStdString();
    EXPECT_EQ(db::order_file(recording), beside(order).toStdString());
    const auto found = db::order_beside(recording);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->user_id, anna);
    EXPECT_EQ(found->study, "pilot");
    EXPECT_EQ(found->participant, "P001-X");
    EXPECT_EQ(found->text, read(beside(order)));
    // What is no order says nothing of whose it is; its text may name somebody all the same.
    QFile file(beside(order));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly | QIODevice::Truncate));
    ASSERT_EQ(file.write("anna was here"), 13);
    file.close();
    const auto damaged = db::order_beside(recording);
    ASSERT_TRUE(damaged);
    EXPECT_EQ(damaged->user_id, 0);
    EXPECT_EQ(damaged->study + damaged->participant, "");
    EXPECT_EQ(damaged->text, "anna was here");
    ASSERT_TRUE(file.remove());
    EXPECT_FALSE(db::order_beside(recording));
}

}  // namespace THIS_TEST
