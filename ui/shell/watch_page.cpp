// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Watch: an attempt again in the simulator's window, steered from here: camera, speed, pause, jumps
// along the time line. Remarks are made on what is being shown.

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QProgressBar>
#include <QTemporaryDir>
#include <QTimer>
#include <cmath>
#include <utility>

#include "reports/words.h"
#include "ui/shell/kept_recording.h"
#include "ui/shell/ledger_view.h"
#include "ui/shell/replay_launcher.h"
#include "ui/shell/replay_place.h"
#include "ui/shell/replay_time_line.h"
#include "ui/shell/result_cards.h"
#include "ui/shell/training.h"

namespace placode::ui {
namespace {

constexpr double kSpeeds[]{0.1, 0.25, 0.5, 1, 2, 4, 8};
constexpr int kLaidOutMs = 50;

class WatchPage : public Page {
    Q_DECLARE_TR_FUNCTIONS(WatchPage)
 public:
    WatchPage(AppContext& context, const Place& place)
        : Page(context),
          record_(context.store().attempts().detail(place.number).record),
          from_s_(place.state.value("from_s").toDouble()),
          blinded_(place.state.value("blinded").toBool()),
          begin_(place.state.value("watch", true).toBool()) {
        require_sight(context, record_);
        LaunchOptions options = context.launcher().options();
        options.language = context.language();
        replay_ = new ReplayLauncher(options, this);
        column_ = make_column(this);
        steer_ = steerCard(place);
        column_->addWidget(steer_);
        wait_ = make_label(tr("Reading the recording …"), "muted");
        column_->addWidget(wait_);
        pictures_ = new QVBoxLayout;
        pictures_->setSpacing(kSpace16);
        column_->addLayout(pictures_);
        column_->addStretch();
        connect(replay_, &ReplayLauncher::stateChanged, this, [this] { refresh(); });
        connect(replay_, &ReplayLauncher::ended, this,
                [this](const std::optional<ProgramEnd>& end) { onEnded(end); });
        refresh();
        readRecording();
    }

    [[nodiscard]] QString title() const override { return tr("Watch"); }
    [[nodiscard]] bool keepsTyped() const override { return true; }
    [[nodiscard]] QString aboutTask() const override { return qstr(record_.task_id); }
    [[nodiscard]] QVariantMap state() const override {
        return {{"from_s", replay_->running() ? replay_->state().time_s : from_s_},
                {"blinded", blinded_},
                // Built again in another theme or language: a window that is open stays so.
                {"watch", replay_->running() || begin_},
                {"camera", camera_->currentData()},
                {"speed", speed_->currentData()}};
    }

 private:
    QWidget* steerCard(const Place& place) {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace12);
        auto* head = new QHBoxLayout;
        head->setSpacing(kSpace12);
        QStringList facts{task_title(context_, record_.task_id), format_when(record_.started_utc)};
        if (record_.user_id != context_.user().id) facts.prepend(qstr(record_.user_name));
        // A blinded rater sees neither name nor day.
        if (blinded_) facts = QStringList{task_title(context_, record_.task_id)};
        head->addWidget(make_label(facts.join(" · "), "heading"), 1);  // Wraps.
        QPushButton* back =
            make_button(context_, blinded_ ? tr("Back to the ratings") : tr("Back to the result"),
                        "quiet", "back");
        back->setObjectName("back_to_result");
        connect(back, &QPushButton::clicked, this, [this] {
            Q_EMIT go(
                {blinded_ ? PageId::kRatings : PageId::kResult, blinded_ ? 0 : record_.id, {}, {}});
        });
        head->addWidget(back);
        layout->addLayout(head);
        layout->addLayout(buttons(place));
        auto* foot = new QHBoxLayout;
        clock_ = make_label("0:00", "display");
        clock_->setObjectName("replay_clock");
        clock_->setAccessibleName(tr("Moment of the recording"));
        clock_->setWordWrap(false);
        foot->addWidget(clock_);
        said_ = make_label({}, "muted");
        said_->setObjectName("replay_said");
        foot->addWidget(said_, 1);
        foot->addWidget(closeButton());
        layout->addLayout(foot);
        QLabel* keys = make_label(
            tr("Keys in its window: Space or Esc pauses and goes on, ← and → jump 5 s, ↑ and ↓ "
               "change the speed, V the camera, Q closes it."),
            "small");
        keys->setObjectName("replay_keys");
        layout->addWidget(keys);
        bar_ = new QProgressBar;
        bar_->setTextVisible(false);
        bar_->setAccessibleName(tr("Simulating to the moment"));
        bar_->hide();
        layout->addWidget(bar_);
        return make_card(layout);
    }

    QHBoxLayout* buttons(const Place& place) {
        auto* row = new QHBoxLayout;
        row->setSpacing(kSpace8);
        play_ = make_button(context_, tr("Watch"), "primary", "play");
        play_->setObjectName("replay_play");
        play_->setMinimumWidth(130);
        connect(play_, &QPushButton::clicked, this, [this] { playOrPause(); });
        row->addWidget(play_);
        back_ = jumpButton(tr("5 s back"), "replay_back", -5);
        on_ = jumpButton(tr("5 s on"), "replay_on", 5);
        row->addWidget(back_);
        row->addWidget(on_);
        camera_ = new QComboBox;
        camera_->setObjectName("replay_camera");
        camera_->setAccessibleName(tr("Camera"));
        camera_->addItem(tr("As operated"), "scope");
        camera_->addItem(tr("From above"), "above");
        camera_->addItem(tr("From the left"), "left");
        camera_->addItem(tr("From the feet"), "feet");
        camera_->addItem(tr("Near the tip"), "near");
        camera_->setCurrentIndex(
            std::max(0, camera_->findData(place.state.value(
                            "camera", context_.settings().value("replay_camera", "scope")))));
        connect(camera_, &QComboBox::activated, this, [this] {
            context_.settings().setValue("replay_camera", camera_->currentData());
            replay_->setCamera(camera_->currentData().toString());
        });
        row->addWidget(camera_);
        speed_ = new QComboBox;
        speed_->setObjectName("replay_speed");
        speed_->setAccessibleName(tr("Speed"));
        for (const double speed : kSpeeds)
            speed_->addItem(tr("Speed %1×").arg(QLocale().toString(speed)), speed);
        speed_->setCurrentIndex(
            std::max(0, speed_->findData(place.state.value("speed", 1.0).toDouble())));
        connect(speed_, &QComboBox::activated, this,
                [this] { replay_->setSpeed(speed_->currentData().toDouble()); });
        row->addWidget(speed_);
        row->addStretch();
        return row;
    }

    QPushButton* closeButton() {
        close_ = make_button(context_, tr("Close the window"), "secondary", "stop");
        close_->setObjectName("replay_close");
        connect(close_, &QPushButton::clicked, this, [this] { replay_->stop(); });
        return close_;
    }

    QPushButton* jumpButton(const QString& text, const char* name, double seconds) {
        QPushButton* button = make_button(context_, text, "secondary");
        button->setObjectName(name);
        connect(button, &QPushButton::clicked, this, [this, seconds] {
            replay_->seek(std::max(0.0, replay_->state().time_s + seconds));
        });
        return button;
    }

    void readRecording() {
        auto recording = std::make_shared<sim::Recording>();
        auto there = std::make_shared<bool>(false);
        auto folder = std::make_shared<QTemporaryDir>();
        const QString file = folder->filePath("attempt.placode");
        const int64_t id = record_.id;
        context_.background(
            this, tr("Reading the recording"),
            [recording, there, id, file](db::Store& store) {
                *there = take_recording(store, id, file, *recording);
            },
            [this, recording, there, folder, file](bool done) {
                if (!done) return wait_->setText(tr("The recording cannot be shown."));
                if (!*there)
                    return wait_->setText(
                        tr("This attempt was kept without a recording, so it cannot be watched. "
                           "Its result is complete."));
                wait_->hide();
                folder_ = folder;
                file_ = file;
                showLedger(*recording);
                refresh();
                // Whoever comes here has asked to watch. The window goes where it leaves the time
                // line in sight, which has its place only after the page was laid out.
                if (begin_)
                    QTimer::singleShot(kLaidOutMs, this, [this] {
                        if (std::exchange(begin_, false) && !replay_->running()) start(from_s_);
                    });
            },
            {"reading", record_.duration_s});
    }

    void showLedger(const sim::Recording& recording) {
        const TimeLine line =
            make_time_line(context_, recording, [this](double time_s) { jump(time_s); });
        ledger_ = line.ledger;
        pictures_->addWidget(line.card);
        if (blinded_) return;  // remarks name people
        // Without them the attempt can be watched all the same.
        context_.guard(tr("Reading the remarks"), [this] { addRemarks(); });
    }

    void addRemarks() {
        pictures_->addWidget(make_comments_card(
            context_, record_.id, record_.user_id,
            [this] { return replay_->running() ? replay_->state().time_s : from_s_; },
            [this](double time_s) { jump(time_s); },
            [this](const std::vector<db::CommentRecord>& comments) {
                ledger_->setMarks(marks_of(comments));
            }));
        Q_EMIT fieldsCame();
    }

    void playOrPause() {
        if (replay_->running())
            replay_->setPaused(!replay_->state().paused);
        else
            start(from_s_);
    }

    void start(double from_s) {
        context_.guard(tr("Starting the replay"), [&] {
            replay_->setPlace(replay_place(*steer_, ledger_));
            replay_->start(file_, camera_->currentData().toString(),
                           speed_->currentData().toDouble(), from_s);
        });
        refresh();
    }

    void jump(double time_s) {
        if (file_.isEmpty()) return;
        if (replay_->running())
            replay_->seek(time_s);
        else
            start(time_s);
    }

    void onEnded(const std::optional<ProgramEnd>& end) {
        from_s_ = 0;
        if (end) context_.report(simulator_problem(*end));
        refresh();
    }

    void refresh() {
        const bool running = replay_->running();
        const ReplayState& now = replay_->state();
        play_->setEnabled(!file_.isEmpty());
        play_->setText(!running ? tr("Watch") : now.paused ? tr("Go on") : tr("Pause"));
        set_button_icon(context_, play_, running && !now.paused ? "pause" : "play");
        for (QPushButton* button : {back_, on_, close_}) button->setEnabled(running);
        clock_->setText(reports::minute_second(running ? now.time_s : from_s_) + " / " +
                        reports::minute_second(record_.duration_s));
        const bool seeking = running && now.target_s >= 0;
        bar_->setVisible(seeking);
        if (seeking) {
            bar_->setRange(0, static_cast<int>(10 * now.target_s) + 1);
            bar_->setValue(static_cast<int>(10 * now.time_s));
        }
        if (ledger_) ledger_->setCursor_s(running ? now.time_s : -1);
        if (!running) {
            said_->setText(
                tr("The attempt is simulated again exactly, in a window beside this one."));
            return;
        }
        camera_->setCurrentIndex(std::max(0, camera_->findData(now.camera)));
        const int speed = speed_->findData(now.speed);
        if (speed >= 0) speed_->setCurrentIndex(speed);
        QString said = seeking ? tr("Simulating to %1; going back means beginning again.")
                                     .arg(reports::minute_second(now.target_s))
                       : now.paused ? tr("Paused")
                                    : tr("Playing");
        if (!seeking && !now.paused && now.pace > 0 && now.pace < 0.8 * now.speed)
            said = tr("Playing at %1×: this computer cannot do %2×.")
                       .arg(format_number(now.pace, 1), QLocale().toString(now.speed));
        said_->setText(said);
    }

    db::AttemptRecord record_;
    double from_s_ = 0;
    bool blinded_ = false;
    bool begin_ = true;  ///< As soon as the recording is there.
    QWidget* steer_ = nullptr;
    ReplayLauncher* replay_ = nullptr;
    std::shared_ptr<QTemporaryDir> folder_;
    QString file_;
    QVBoxLayout *column_ = nullptr, *pictures_ = nullptr;
    QLabel *wait_ = nullptr, *clock_ = nullptr, *said_ = nullptr;
    QProgressBar* bar_ = nullptr;
    QPushButton *play_ = nullptr, *back_ = nullptr, *on_ = nullptr, *close_ = nullptr;
    QComboBox *camera_ = nullptr, *speed_ = nullptr;
    LedgerView* ledger_ = nullptr;
};

}  // namespace

Page* make_watch_page(AppContext& context, const Place& place) {
    return new WatchPage(context, place);
}

}  // namespace placode::ui
