// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Every page that every role may open, with people, attempts, norms, a standard and a study in the
// store: nothing is cut off at any size in either language, everything is named. With
// $PLACODE_GALLERY set to a folder every page is also saved at every size, in both themes and both
// languages.

#include <QAbstractSpinBox>
#include <QProcess>
#include <set>

#include "db/norm_bands.h"
#include "db/standards.h"
#include "page_fit.h"
#include "shell_harness.h"
#include "ui/shell/page_tour.h"

namespace placode::ui {

namespace {

constexpr const char* kTask = "diathermy_ring_small";
constexpr int kPeopleALevel = 6, kAttempts = 14;
const QSize kSizes[]{{960, 540}, {1024, 768}, {1366, 768}, {1920, 1080}};

struct Visitor {
    const char *login, *password;
};
constexpr Visitor kVisitors[]{{"demo.trainee", "placode-demo"},
                              {"demo.educator", "placode-demo"},
                              {"demo.coordinator", "placode-demo"},
                              {"ada", "correct horse"}};

}  // namespace

class ShellGalleryTest : public QObject {
    Q_OBJECT

 private Q_SLOTS:
    void initTestCase();
    void cleanupTestCase() { shell_.reset(); }
    void nothingIsCutOffAtAnySizeInAnyLanguage();
    void everythingThatTakesTheFocusIsNamed();
    void normsAndTheChartOfFailuresAreShown();

 private:
    [[nodiscard]] int64_t add(const std::string& login, const std::string& name, bool expert);
    void addAttempt(int64_t user, int number, double points, const std::string& task = kTask);
    void record();
    void addNorms(const std::vector<int64_t>& novices, const std::vector<int64_t>& experts);
    void lookAt(const TourStop& stop, const QString& who, QStringList& wrong);
    void settle();

    std::unique_ptr<ShellHarness> shell_;
    int64_t trainee_ = 0;
    QString recording_;  ///< Of the trainee's attempts: seconds of a novice's real one.
};

int64_t ShellGalleryTest::add(const std::string& login, const std::string& name, bool expert) {
    const int64_t id = shell_->context().store().accounts().create(
        {login, name, "first password", static_cast<db::Roles>(db::Role::kTrainee), true});
    for (int i = 0; i < kAttempts; ++i) {
        const double spread = (i * 37 + static_cast<int>(id) * 17) % 11;
        addAttempt(id, i, (expert ? 82 : 38) + (expert ? 0.3 : 1.5) * i + spread);
    }
    return id;
}

void ShellGalleryTest::addAttempt(int64_t user, int number, double points,
                                  const std::string& task) {
    db::AttemptResult result;
    result.header.task_id = task;
    result.header.task_version = 1;
    result.header.device = "mouse";
    result.header.demonstration = true;
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
    result.score.reasons = {
        {"ring", "The ring was left open: only 92 % is cut through.", 8, 12, false}};
    if (user == trainee_) result.recording_file = recording_.toStdString();
    (void)shell_->context().store().attempts().save(user, result);
}

void ShellGalleryTest::addNorms(const std::vector<int64_t>& novices,
                                const std::vector<int64_t>& experts) {
    db::Store& store = shell_->context().store();
    const auto levels =
        db::level_attempts(store, kTask, {{"expert", experts}, {"novice", novices}});
    const int64_t pack = db::keep_own_norms(
        store, db::make_norms(levels, "Demonstration centre", "2026-04-01T10:00:00Z", 5));
    store.norms().use(pack);
}

void ShellGalleryTest::record() {
    recording_ = shell_->path("seconds.placode");
    QProcess simulator;
    simulator.start(PLACODE_BIN_DIR "/placode-sim",
                    {"--task", kTask, "--device", "script:novice", "--headless", "--fast",
                     "--demonstration", "--duration", "14", "--record", recording_});
    QVERIFY(simulator.waitForFinished(300000));
    QVERIFY2(QFile::exists(recording_), simulator.readAllStandardError().constData());
}

void ShellGalleryTest::initTestCase() {
    shell_ = std::make_unique<ShellHarness>();
    QVERIFY(shell_->setUpWithDemonstration());
    db::Store& store = shell_->context().store();
    store.act_as("ada");
    std::vector<int64_t> novices, experts;
    for (int i = 1; i <= kPeopleALevel; ++i) {
        novices.push_back(add("novice" + std::to_string(i), "Novice " + std::to_string(i), false));
        experts.push_back(add("expert" + std::to_string(i), "Expert " + std::to_string(i), true));
    }
    trainee_ = store.accounts().find_login("demo.trainee")->id;
    record();
    for (const std::string& task : curriculum::list_definitions("tasks"))
        if (task != kTask) addAttempt(novices[1], 0, 60, task);
    // Eight good ones, then a bad time.
    for (int i = 0; i < 14; ++i) addAttempt(trainee_, i, i < 8 ? 72 + 2 * i : 55 - i);
    const int64_t group = store.groups().create("Spring course with a rather long name");
    store.groups().set_role(group, store.accounts().find_login("demo.educator")->id,
                            db::GroupRole::kEducator);
    for (const int64_t id : novices) store.groups().set_role(group, id, db::GroupRole::kMember);
    store.groups().set_role(group, trainee_, db::GroupRole::kMember);
    addNorms(novices, experts);
    db::set_standard(store,
                     db::standard_of_groups(kTask, db::person_means(store, kTask, novices, 3),
                                            db::person_means(store, kTask, experts, 3), 3),
                     "");
    store.reviews().add_comment({0, store.attempts().list(trainee_).back().id,
                                 store.accounts().find_login("demo.educator")->id, "", 3,
                                 "Slow down here.", ""});
    store.accounts().request_erasure(novices[0], "I leave.");
    (void)store.accounts().invite(
        {0, 1, group, "Nina Nowak", "ada", "", "2099-01-01T00:00:00Z", ""});
}

void ShellGalleryTest::settle() {
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    (void)QTest::qWaitFor([] { return QThreadPool::globalInstance()->activeThreadCount() == 0; },
                          30000);
    // A device list that another process makes, and layouts that ask each other for room.
    (void)QTest::qWaitFor(
        [this] {
            const auto* again = shell_->find<QAbstractButton>("look_again");
            return again == nullptr || again->isEnabled();
        },
        30000);
    QTest::qWait(30);
    for (int i = 0; i < 5; ++i) QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
}

void ShellGalleryTest::lookAt(const TourStop& stop, const QString& who, QStringList& wrong) {
    ShellHarness& shell = *shell_;
    const QString folder = qEnvironmentVariable("PLACODE_GALLERY");
    if (!folder.isEmpty()) QDir().mkpath(folder);
    for (const ThemeKind theme : {ThemeKind::kDark, ThemeKind::kLight}) {
        if (folder.isEmpty() && theme == ThemeKind::kDark) continue;
        shell.context().setTheme(theme);
        shell.window().visit(stop.place);
        if (!shell.arrives(stop.place.page)) {
            wrong << QString("%1 cannot open %2").arg(who, stop.name);
            return;
        }
        for (const QSize size : kSizes) {
            shell.window().resize(size);
            settle();
            const QString name = QString("%1_%2_%3_%4_%5")
                                     .arg(who, stop.name, shell.context().language())
                                     .arg(size.width())
                                     .arg(theme == ThemeKind::kDark ? "dark" : "light");
            for (const QString& misfit : misfits(shell.window())) wrong << name + ": " + misfit;
            if (!folder.isEmpty()) shell.window().grab().save(folder + "/" + name + ".png");
        }
    }
}

void ShellGalleryTest::nothingIsCutOffAtAnySizeInAnyLanguage() {
    ShellHarness& shell = *shell_;
    QStringList wrong;
    std::set<std::string> seen;
    for (const Visitor& visitor : kVisitors) {
        QVERIFY2(shell.signIn(visitor.login, visitor.password), visitor.login);
        for (const char* language : {"pl", "en"}) {
            shell.context().setLanguage(language);
            for (const TourStop& stop : page_tour(shell.context())) {
                // Once is enough where a page is the same for several roles.
                if (!seen.insert(std::string(stop.name) + language).second) continue;
                lookAt(stop, visitor.login, wrong);
            }
        }
    }
    // QVERIFY2 cuts a long text.
    for (const QString& each : wrong) std::fprintf(stderr, "%s\n", qPrintable(each));
    QVERIFY2(wrong.isEmpty(), qPrintable(QString("%1 misfits").arg(wrong.size())));
    QVERIFY(seen.size() >= 2 * 22);
}

void ShellGalleryTest::everythingThatTakesTheFocusIsNamed() {
    ShellHarness& shell = *shell_;
    QStringList wrong;
    shell.window().resize(1366, 768);
    for (const Visitor& visitor : kVisitors) {
        QVERIFY(shell.signIn(visitor.login, visitor.password));
        for (const TourStop& stop : page_tour(shell.context())) {
            shell.window().visit(stop.place);
            QVERIFY2(shell.arrives(stop.place.page), stop.name);
            settle();
            for (const QWidget* widget : shell.window().findChildren<QWidget*>()) {
                if (!widget->isVisible() || (widget->focusPolicy() & Qt::TabFocus) == 0) continue;
                const QWidget* above = widget->parentWidget();
                // Inside a spin box or an editable list stands a line without a name of its own.
                if (qobject_cast<const QAbstractSpinBox*>(above) != nullptr ||
                    qobject_cast<const QComboBox*>(above) != nullptr)
                    continue;
                const auto* button = qobject_cast<const QAbstractButton*>(widget);
                const QString said = !widget->accessibleName().isEmpty() ? widget->accessibleName()
                                     : button != nullptr                 ? button->text()
                                                                         : QString();
                if (said.trimmed().isEmpty() && qobject_cast<const QScrollArea*>(widget) == nullptr)
                    wrong << QString("%1: %2 \"%3\" has no name")
                                 .arg(stop.name, widget->metaObject()->className(),
                                      widget->objectName());
            }
        }
    }
    wrong.removeDuplicates();
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join("\n")));
}

void ShellGalleryTest::normsAndTheChartOfFailuresAreShown() {
    ShellHarness& shell = *shell_;
    QVERIFY(shell.signIn("demo.trainee", "placode-demo"));
    const int64_t last = shell.context().store().attempts().list(trainee_).back().id;
    shell.window().open({PageId::kResult, last, {}, {}});
    QVERIFY(shell.arrives(PageId::kResult));
    settle();
    // Behind a measure of the pack stand the bands of novices and experts.
    auto* table = shell.find<QTableWidget>("metrics");
    QVERIFY(table != nullptr);
    int strips = 0;
    for (int row = 0; row < table->rowCount(); ++row)
        strips += table->cellWidget(row, 5) != nullptr ? 1 : 0;
    QVERIFY(strips >= 4);
    shell.whole("95_result_norms");
    shell.window().open({PageId::kHistory, 0, {}, {}});
    QVERIFY(shell.arrives(PageId::kHistory));
    settle();
    QVERIFY2(shell.text("cusum_words").startsWith("CUSUM: since attempt"),
             qPrintable(shell.text("cusum_words")));
    shell.whole("96_history_cusum");
}

}  // namespace placode::ui

int main(int argc, char** argv) {
    placode::ui::prepare_display();
    QApplication application(argc, argv);
    placode::ui::ShellGalleryTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "shell_gallery_test.moc"
