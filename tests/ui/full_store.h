// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A store in which every page has something to show: people of two levels, attempts, norms, a
// standard, a group, remarks, an invitation, a request to be erased.

#include <QProcess>
#include <cmath>

#include "db/norm_bands.h"
#include "db/standards.h"
#include "shell_harness.h"

namespace placode::ui {

class FullStore {
 public:
    static constexpr const char* kTask = "diathermy_ring_small";
    static constexpr int kPeopleALevel = 6, kAttempts = 14;

    /// @param shell with its first start still to come. False when a step failed.
    [[nodiscard]] bool fill(ShellHarness& shell);
    [[nodiscard]] int64_t trainee() const { return trainee_; }

 private:
    [[nodiscard]] int64_t add(const std::string& login, const std::string& name, bool expert);
    void addAttempt(int64_t user, int number, double points, const std::string& task = kTask);
    [[nodiscard]] bool record();
    void addNorms(const std::vector<int64_t>& novices, const std::vector<int64_t>& experts);
    void addTeaching(const std::vector<int64_t>& novices);
    [[nodiscard]] db::Store& store() { return shell_->owner(); }

    ShellHarness* shell_ = nullptr;
    int64_t trainee_ = 0;
    QString recording_;  ///< Of the trainee's last attempt: seconds of a novice's real one.
};

inline int64_t FullStore::add(const std::string& login, const std::string& name, bool expert) {
    const int64_t id = store().accounts().create(
        {login, name, "first password", static_cast<db::Roles>(db::Role::kTrainee), true});
    for (int i = 0; i < kAttempts; ++i) {
        const double spread = (i * 37 + static_cast<int>(id) * 17) % 11;
        addAttempt(id, i, (expert ? 82 : 38) + (expert ? 0.3 : 1.5) * i + spread);
    }
    return id;
}

inline void FullStore::addAttempt(int64_t user, int number, double points,
                                  const std::string& task) {
    db::AttemptResult result;
    result.header.task_id = task;
    result.header.task_version = 1;
    result.header.device = "mouse";
    // Others are judged by novices and experts, who are added before the trainee is known.
    const bool judges = trainee_ == 0;
    result.header.demonstration = !judges;
    result.header.started_utc = QString("2026-03-%1T10:%2:00Z")
                                    .arg(number + 1, 2, 10, QChar('0'))
                                    .arg(user % 60, 2, 10, QChar('0'))
                                    .toStdString();
    result.end.reason = sim::EndReason::kFinished;
    result.end.duration_s = 300 - points;
    result.metrics.values = {{"task_time_s", 300 - points},
                             {"ring_completeness_percent", std::min(100.0, points + 5)},
                             {"contour_deviation_mm", 1.2 - points / 100},
                             {"path_length_mm", 900 - 5 * points},
                             {"peak_force_mn", 700 - 4 * points}};
    result.score.points = points;
    result.score.verdict =
        points >= 70 ? assessment::Verdict::kPassed : assessment::Verdict::kNotYet;
    result.score.rubric_id = "ring_incision";
    const auto cut = std::to_string(std::lround(std::min(100.0, points + 5)));
    result.score.reasons = {
        {"ring", "The ring was left open: only " + cut + " % is cut through.", 8, 12, false}};
    // One attempt only: the same recording a second time proves nothing.
    if (user == trainee_ && number == kAttempts - 1)
        result.recording_file = recording_.toStdString();
    const int64_t id = store().attempts().save(user, result);
    if (judges) store().attempts().set_replay(id, db::ReplayState::kIdentical);
}

inline void FullStore::addNorms(const std::vector<int64_t>& novices,
                                const std::vector<int64_t>& experts) {
    const auto levels =
        db::level_attempts(store(), kTask, {{"expert", experts}, {"novice", novices}});
    const int64_t pack = db::keep_own_norms(
        store(), db::make_norms(levels, "Demonstration centre", "2026-04-01T10:00:00Z", 5),
        "four words are good");
    store().norms().use(pack);
}

inline bool FullStore::record() {
    recording_ = shell_->path("seconds.placode");
    QProcess simulator;
    simulator.start(PLACODE_BIN_DIR "/placode-sim",
                    {"--task", kTask, "--device", "script:novice", "--headless", "--fast",
                     "--demonstration", "--duration", "14", "--record", recording_});
    return simulator.waitForFinished(300000) && QFile::exists(recording_);
}

inline void FullStore::addTeaching(const std::vector<int64_t>& novices) {
    const int64_t educator = shell_->idOf("demo.educator");
    const int64_t group = store().groups().create("Spring course with a rather long name");
    store().groups().set_role(group, educator, db::GroupRole::kEducator);
    for (const int64_t id : novices) store().groups().set_role(group, id, db::GroupRole::kMember);
    store().groups().set_role(group, trainee_, db::GroupRole::kMember);
    store().reviews().add_comment(
        {0, store().attempts().list(trainee_).back().id, educator, "", 3, "Slow down here.", ""});
    store().accounts().request_erasure(novices[0], "I leave.");
    (void)store().accounts().invite(
        {0, 1, group, "Nina Nowak", "ada", "", "2099-01-01T00:00:00Z", ""});
}

inline bool FullStore::fill(ShellHarness& shell) {
    shell_ = &shell;
    if (!shell.setUpWithDemonstration()) return false;
    store().act_as("ada");
    std::vector<int64_t> novices, experts;
    for (int i = 1; i <= kPeopleALevel; ++i) {
        novices.push_back(add("novice" + std::to_string(i), "Novice " + std::to_string(i), false));
        experts.push_back(add("expert" + std::to_string(i), "Expert " + std::to_string(i), true));
    }
    trainee_ = shell.idOf("demo.trainee");
    if (!record()) return false;
    for (const std::string& task : curriculum::list_definitions("tasks"))
        if (task != kTask) addAttempt(novices[1], 0, 60, task);
    // Eight good ones, then a bad time.
    for (int i = 0; i < kAttempts; ++i) addAttempt(trainee_, i, i < 8 ? 72 + 2 * i : 55 - i);
    addNorms(novices, experts);
    db::set_standard(store(),
                     db::standard_of_groups(kTask, db::person_means(store(), kTask, novices, 3),
                                            db::person_means(store(), kTask, experts, 3), 3),
                     "");
    addTeaching(novices);
    return true;
}

/// Until what workers, device lists and layouts bring stands on the page.
inline void settle(ShellHarness& shell) {
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    (void)QTest::qWaitFor([&] { return shell.context().workers().activeThreadCount() == 0; },
                          30000);
    (void)QTest::qWaitFor(
        [&] {
            const auto* again = shell.find<QAbstractButton>("look_again");
            return again == nullptr || again->isEnabled();
        },
        30000);
    (void)QTest::qWaitFor([&] { return !shell.context().busy(); }, 30000);
    QTest::qWait(30);
    // What is added to a page that stands already is shown by an event of its own: a page that took
    // longer than that wait to be filled leaves it behind.
    for (int i = 0; i < 5; ++i) {
        QCoreApplication::processEvents();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
    }
}

}  // namespace placode::ui
