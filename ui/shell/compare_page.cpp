// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Compare: two attempts at the same task side by side: score, reasons, measures, time lines, paths,
// and both replayed at once, steered together.

#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QTemporaryDir>
#include <array>
#include <memory>

#include "assessment/ledger.h"
#include "db/attempt_counting.h"
#include "reports/attempt_figures.h"
#include "reports/words.h"
#include "ui/shell/compare_cards.h"
#include "ui/shell/kept_recording.h"
#include "ui/shell/ledger_view.h"
#include "ui/shell/pages.h"
#include "ui/shell/parts.h"
#include "ui/shell/replay_launcher.h"
#include "ui/shell/replay_place.h"
#include "ui/shell/training.h"

namespace placode::ui {
namespace {

constexpr int kOffered = 200;  ///< Newest attempts of the task to choose from.

/// One of the two.
struct Half {
    db::AttemptDetail detail;
    std::shared_ptr<sim::Recording> recording;
    std::shared_ptr<QTemporaryDir> folder;
    QString file;
    ReplayLauncher* replay = nullptr;
    QLabel* clock = nullptr;
    LedgerView* ledger = nullptr;
};

class ComparePage : public Page {
    Q_DECLARE_TR_FUNCTIONS(ComparePage)
 public:
    ComparePage(AppContext& context, const Place& place) : Page(context) {
        halves_[0].detail = readAllowed(place.number);
        QVBoxLayout* column = make_column(this, 1500);
        column->addLayout(head());
        body_ = new QVBoxLayout;
        body_->setSpacing(kSpace16);
        column->addLayout(body_);
        column->addStretch();
        const qint64 wanted = place.state.value("other").toLongLong();
        chooser_->setCurrentIndex(wanted == 0 ? bestIndex()
                                              : std::max(0, chooser_->findData(wanted)));
        connect(chooser_, &QComboBox::currentIndexChanged, this, [this] { showOther(); });
        showBoth();
    }

    [[nodiscard]] QString title() const override { return tr("Compare"); }
    [[nodiscard]] QVariantMap state() const override {
        return {{"other", chooser_->currentData()}};
    }

 private:
    db::AttemptDetail readAllowed(int64_t id) {
        db::AttemptDetail detail = context_.store().attempts().detail(id);
        require_sight(context_, detail.record);
        return detail;
    }

    /// Attempts of the same task: own ones, for an educator also those of others.
    QHBoxLayout* head() {
        const db::AttemptRecord& first = halves_[0].detail.record;
        auto* row = new QHBoxLayout;
        row->setSpacing(kSpace12);
        row->addWidget(make_label(tr("Compare"), "display"), 1);
        chooser_ = new QComboBox;
        chooser_->setObjectName("compare_with");
        chooser_->setAccessibleName(tr("Compare with"));
        chooser_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        chooser_->setMinimumWidth(420);
        db::AttemptFilter filter;
        filter.task_id = first.task_id;
        filter.limit = kOffered;
        filter.user_id =
            context_.may(db::Action::kViewAttempts, db::Scope::kOther) ? 0 : context_.user().id;
        // What a participant did is compared with what the same participant did.
        const bool study = !first.study.study.empty();
        for (const db::AttemptRecord& each : study
                                                 ? db::other_attempts(context_.store(), first)
                                                 : context_.store().attempts().page(filter).rows) {
            if (each.id == first.id) continue;
            chooser_->addItem(nameOf(each), QVariant::fromValue<qint64>(each.id));
            const bool own = each.user_id == first.user_id && db::counts(each);
            points_.push_back(own ? each.points : -1);
        }
        row->addWidget(chooser_);
        QPushButton* back = make_button(context_, tr("Back to the result"), "quiet", "back");
        back->setObjectName("back_to_result");
        connect(back, &QPushButton::clicked, this, [this, id = first.id] {
            Q_EMIT go({PageId::kResult, id, {}, {}});
        });
        row->addWidget(back);
        return row;
    }

    /// Points only where there are any: those of an attempt that was left are no score.
    [[nodiscard]] static QString nameOf(const db::AttemptRecord& each) {
        if (!db::counts(each))
            return tr("%1 · %2 · does not count")
                .arg(qstr(each.user_name), format_when(each.started_utc));
        return tr("%1 · %2 · %3 pts")
            .arg(qstr(each.user_name), format_when(each.started_utc), format_points(each.points));
    }

    /// The person's own best one: what one could do already.
    [[nodiscard]] int bestIndex() const {
        const auto best = std::max_element(points_.begin(), points_.end());
        return best == points_.end() ? -1 : static_cast<int>(best - points_.begin());
    }

    /// From a slot, which no exception may leave.
    void showOther() {
        if (context_.guard(tr("Reading the attempt"), [this] { showBoth(); })) return;
        // What is shown is the one before: the box must not name another.
        const QSignalBlocker quiet(chooser_);
        chooser_->setCurrentIndex(
            chooser_->findData(QVariant::fromValue<qint64>(halves_[1].detail.record.id)));
    }

    void showBoth() {
        // Read first: what cannot be read leaves the page as it is.
        if (chooser_->currentIndex() >= 0)
            halves_[1].detail = readAllowed(chooser_->currentData().toLongLong());
        while (QLayoutItem* item = body_->takeAt(0)) {
            if (item->widget()) item->widget()->deleteLater();
            delete item;
        }
        for (Half& half : halves_) {
            if (half.replay) half.replay->deleteLater();
            half = Half{half.detail, {}, {}, {}, nullptr, nullptr, nullptr};
        }
        if (chooser_->currentIndex() < 0) {
            body_->addWidget(make_label(
                tr("There is no other attempt at this task yet. After the next one they can be "
                   "compared."),
                "muted"));
            return;
        }
        steer_ = steerCard();
        body_->addWidget(steer_);
        auto* row = new QHBoxLayout;
        row->setSpacing(kSpace16);
        for (size_t i = 0; i < 2; ++i) row->addWidget(headCard(i), 1);
        auto* holder = new QWidget;
        row->setContentsMargins(0, 0, 0, 0);
        holder->setLayout(row);
        body_->addWidget(holder);
        body_->addWidget(make_compare_metrics(context_, halves_[0].detail, halves_[1].detail));
        readRecordings();
    }

    QWidget* headCard(size_t i) const {
        const db::AttemptDetail& attempt = halves_[i].detail;
        return make_compare_head(attempt, nameOf(attempt.record), i);
    }

    // --- the recordings

    void readRecordings() {
        auto* wait = make_label(tr("Reading the recordings …"), "muted");
        body_->addWidget(wait);
        std::array<int64_t, 2> ids{};
        std::array<QString, 2> files;
        std::array<std::shared_ptr<sim::Recording>, 2> read;
        std::array<std::shared_ptr<QTemporaryDir>, 2> folders;
        auto there = std::make_shared<bool>(true);
        for (size_t i = 0; i < 2; ++i) {
            ids[i] = halves_[i].detail.record.id;
            folders[i] = halves_[i].folder = std::make_shared<QTemporaryDir>();
            files[i] = folders[i]->filePath("attempt.placode");
            read[i] = std::make_shared<sim::Recording>();
        }
        context_.background(
            wait, tr("Reading the recordings"),
            // Its own hold of the folders: the page may be left while they are written to.
            [ids, files, folders, read, there](db::Store& store) {
                for (size_t i = 0; i < 2; ++i)
                    *there = take_recording(store, ids[i], files[i], *read[i]) && *there;
            },
            [this, wait, files, read, there](bool done) {
                if (!done) return wait->setText(tr("A recording cannot be shown."));
                if (!*there)
                    return wait->setText(
                        tr("One of the two was kept without a recording: measures can be compared, "
                           "watching both needs two recordings."));
                wait->hide();
                for (size_t i = 0; i < 2; ++i) {
                    halves_[i].recording = read[i];
                    halves_[i].file = files[i];
                    makeReplay(halves_[i]);
                }
                play_->setEnabled(true);
                showPictures();
            });
    }

    void showPictures() {
        auto* grid = new QGridLayout;
        grid->setSpacing(kSpace16);
        reports::ChartStyle style = chart_style(context_.theme());
        for (int i = 0; i < 2; ++i) {
            Half& half = halves_[static_cast<size_t>(i)];
            const reports::TaskScope scope = reports::scope_of(half.recording->header);
            style.plan = scope.line;
            half.ledger = new LedgerView(context_, reports::ledger_picture(*half.recording, scope));
            half.ledger->setObjectName(QString("compare_ledger_%1").arg(i));
            half.ledger->chosen = [this](double time_s, int) { seek(time_s); };
            // One below the other: the same moment stands at the same place.
            grid->addWidget(half.ledger, i, 0, 1, 2);
            const auto recording = half.recording;
            QWidget* paths = make_picture(
                [recording, style](QPainter& painter, const QRectF& where) {
                    reports::draw_trajectory(painter, where, *recording, reports::Side::kAbove,
                                             style);
                },
                QSize(280, 280), tr("Tool paths from above"), nameOf(half.detail.record));
            paths->setFixedHeight(320);
            grid->addWidget(paths, 2, i);
        }
        auto* holder = new QVBoxLayout;
        holder->addWidget(make_label(tr("Time lines, and paths from above"), "heading"));
        holder->addLayout(grid);
        QFrame* card = make_card(holder);
        card->setObjectName("compare_pictures");
        body_->addWidget(card);
    }

    // --- both replays, steered together

    QWidget* steerCard() {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace8);
        auto* row = new QHBoxLayout;
        row->setSpacing(kSpace8);
        play_ = make_button(context_, tr("Watch both"), "primary", "play");
        play_->setObjectName("compare_play");
        play_->setEnabled(false);
        connect(play_, &QPushButton::clicked, this, [this] { playOrPause(); });
        row->addWidget(play_);
        camera_ = new QComboBox;
        camera_->setObjectName("compare_camera");
        camera_->setAccessibleName(tr("Camera"));
        const std::pair<QString, const char*> cameras[]{{tr("As operated"), "scope"},
                                                        {tr("From above"), "above"},
                                                        {tr("From the left"), "left"},
                                                        {tr("From the feet"), "feet"},
                                                        {tr("Near the tip"), "near"}};
        for (const auto& [name, id] : cameras) camera_->addItem(name, id);
        connect(camera_, &QComboBox::activated, this, [this] {
            for (Half& half : halves_)
                if (half.replay) half.replay->setCamera(camera_->currentData().toString());
        });
        row->addWidget(camera_);
        speed_ = new QComboBox;
        speed_->setObjectName("compare_speed");
        speed_->setAccessibleName(tr("Speed"));
        for (const double speed : {0.1, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0})
            speed_->addItem(tr("Speed %1×").arg(QLocale().toString(speed)), speed);
        speed_->setCurrentIndex(3);
        connect(speed_, &QComboBox::activated, this, [this] {
            for (Half& half : halves_)
                if (half.replay) half.replay->setSpeed(speed_->currentData().toDouble());
        });
        row->addWidget(speed_);
        close_ = make_button(context_, tr("Close the windows"), "secondary", "stop");
        close_->setObjectName("compare_close");
        close_->setEnabled(false);
        connect(close_, &QPushButton::clicked, this, [this] {
            for (Half& half : halves_)
                if (half.replay) half.replay->stop();
        });
        row->addWidget(close_);
        row->addStretch();
        for (size_t i = 0; i < 2; ++i) {
            halves_[i].clock = make_label("0:00", "heading");
            halves_[i].clock->setObjectName(QString("compare_clock_%1").arg(i));
            halves_[i].clock->setAccessibleName(i == 0 ? tr("Moment of this one")
                                                       : tr("Moment of the other"));
            halves_[i].clock->setWordWrap(false);
            row->addWidget(halves_[i].clock);
        }
        layout->addLayout(row);
        layout->addWidget(make_label(
            tr("Both are simulated again exactly, each in a window of its own; camera, speed, "
               "pause and jumps on either time line act on both."),
            "small"));
        return make_card(layout);
    }

    void makeReplay(Half& half) {
        LaunchOptions options = context_.launcher().options();
        options.language = context_.language();
        half.replay = new ReplayLauncher(options, this);
        connect(half.replay, &ReplayLauncher::stateChanged, this, [this] { refresh(); });
        connect(half.replay, &ReplayLauncher::ended, this,
                [this](const std::optional<ProgramEnd>& end) {
                    if (end) context_.report(simulator_problem(*end));
                    refresh();
                });
    }

    [[nodiscard]] bool running() const {
        return std::any_of(halves_.begin(), halves_.end(),
                           [](const Half& half) { return half.replay && half.replay->running(); });
    }

    void playOrPause() {
        if (!running()) return seek(0);
        const bool pause = !halves_[0].replay->state().paused;
        for (Half& half : halves_) half.replay->setPaused(pause);
    }

    void seek(double time_s) {
        context_.guard(tr("Starting the replays"), [&] {
            const std::vector<QRect> places = two_of(replay_place(*steer_));
            size_t side = 0;
            for (Half& half : halves_) {
                if (!half.replay) return;
                half.replay->setPlace(places[side++]);
                const double to = std::min(time_s, half.detail.record.duration_s);
                if (half.replay->running())
                    half.replay->seek(to);
                else
                    half.replay->start(half.file, camera_->currentData().toString(),
                                       speed_->currentData().toDouble(), to);
            }
        });
        refresh();
    }

    void refresh() {
        const bool any = running();
        close_->setEnabled(any);
        play_->setText(!any                                ? tr("Watch both")
                       : halves_[0].replay->state().paused ? tr("Go on")
                                                           : tr("Pause"));
        set_button_icon(context_, play_,
                        any && !halves_[0].replay->state().paused ? "pause" : "play");
        for (Half& half : halves_) {
            const bool runs = half.replay && half.replay->running();
            if (half.clock)
                half.clock->setText(reports::minute_second(runs ? half.replay->state().time_s : 0));
            if (half.ledger) half.ledger->setCursor_s(runs ? half.replay->state().time_s : -1);
        }
    }

    std::array<Half, 2> halves_;
    std::vector<double> points_;
    QVBoxLayout* body_ = nullptr;
    QWidget* steer_ = nullptr;
    QComboBox *chooser_ = nullptr, *camera_ = nullptr, *speed_ = nullptr;
    QPushButton *play_ = nullptr, *close_ = nullptr;
};

}  // namespace

Page* make_compare_page(AppContext& context, const Place& place) {
    return new ComparePage(context, place);
}

}  // namespace placode::ui
