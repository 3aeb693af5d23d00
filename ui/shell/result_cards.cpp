// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/result_cards.h"

#include <QHBoxLayout>
#include <algorithm>
#include <cmath>

#include "assessment/themes.h"
#include "db/attempt_counting.h"
#include "db/norm_bands.h"
#include "reports/words.h"
#include "ui/shell/ledger_view.h"

namespace placode::ui {
namespace {

struct Result {
    Q_DECLARE_TR_FUNCTIONS(ResultPage)
};

constexpr double kFullScore = 100;  ///< Points.
constexpr size_t kShownReasons = 3;
/// Own attempts before this one that the band is made of.
constexpr size_t kBandAttempts = 10;

QPushButton* show_button(AppContext& context, double time_s, const ShowMoment& show,
                         const QString& name) {
    QPushButton* button = make_button(context, Result::tr("Show"), "quiet", "play");
    button->setObjectName(name);
    button->setAccessibleName(Result::tr("Show the moment %1").arg(reports::minute_second(time_s)));
    QObject::connect(button, &QPushButton::clicked, button,
                     [show, time_s] { show(std::max(0.0, time_s - kLeadS)); });
    return button;
}

/// Of an attempt that does not count: what happened, without points.
QHBoxLayout* reason_line(AppContext& context, const assessment::Reason& reason, size_t number,
                         bool scored, const ShowMoment& show) {
    auto* line = new QHBoxLayout;
    line->setSpacing(kSpace12);
    const QString cost = !scored                ? QString(reason.critical ? "!" : "·")
                         : reason.points >= 0.5 ? "−" + format_points(reason.points)
                                                : QString("!");
    QLabel* points = make_badge(cost, reason.critical ? "critical" : "warn");
    points->setAlignment(Qt::AlignCenter);
    points->setMinimumWidth(48);
    line->addWidget(points, 0, Qt::AlignTop);
    auto* text = new QVBoxLayout;
    text->setSpacing(kSpace4);
    QLabel* words = make_label(reports::reason_words(reason));
    words->setObjectName(QString("reason_%1").arg(number));
    text->addWidget(words);
    QStringList remarks;
    if (reason.critical) remarks << Result::tr("critical error");
    if (reason.time_s >= 0) remarks << Result::tr("at %1").arg(format_duration(reason.time_s));
    if (!remarks.isEmpty()) text->addWidget(make_label(remarks.join(" · "), "small"));
    line->addLayout(text, 1);
    if (reason.time_s >= 0)
        line->addWidget(
            show_button(context, reason.time_s, show, QString("show_reason_%1").arg(number)), 0,
            Qt::AlignTop);
    return line;
}

QHBoxLayout* theme_line(const assessment::ThemeResult& result) {
    using Judgement = assessment::ThemeResult::Judgement;
    auto* line = new QHBoxLayout;
    line->setSpacing(kSpace12);
    const bool strong = result.judgement == Judgement::kStrength;
    const bool weak = result.judgement == Judgement::kWeakness;
    QLabel* sign = make_badge(strong ? "✓"
                              : weak ? "▼"
                                     : "·",
                              strong            ? "good"
                              : result.critical ? "critical"
                              : weak            ? "warn"
                                                : "");
    sign->setAlignment(Qt::AlignCenter);
    sign->setMinimumWidth(36);
    line->addWidget(sign, 0, Qt::AlignTop);
    auto* text = new QVBoxLayout;
    text->setSpacing(0);
    text->addWidget(make_label(reports::theme_words(result.theme)));
    QString words = result.lost < 0.05 ? Result::tr("no points lost")
                                       : Result::tr("−%1 points").arg(format_points(result.lost));
    if (result.critical) words = Result::tr("critical error") + ", " + words;
    if (result.before)
        words += " · " + (*result.before < 0.05
                              ? Result::tr("before: none lost")
                              : Result::tr("before: −%1").arg(format_points(*result.before)));
    text->addWidget(make_label(words, "small"));
    line->addLayout(text, 1);
    return line;
}

QString reasons_heading(const std::vector<assessment::Reason>& reasons, bool scored) {
    return !scored                    ? Result::tr("What was noticed (not scored)")
           : reasons.empty()          ? Result::tr("No points were lost")
           : reasons.front().critical ? Result::tr("What failed the attempt, then what cost most")
                                      : Result::tr("What cost most");
}

/// Behind a button: the reasons beyond the first kShownReasons.
void add_other_reasons(QVBoxLayout* layout, AppContext& context,
                       const std::vector<assessment::Reason>& reasons, bool scored,
                       const ShowMoment& show) {
    auto* rest = new QWidget;
    rest->setObjectName("other_reasons");
    rest->setFocusPolicy(Qt::StrongFocus);
    auto* more = new QVBoxLayout(rest);
    more->setContentsMargins(0, 0, 0, 0);
    more->setSpacing(kSpace12);
    double lost = 0;
    for (size_t i = kShownReasons; i < reasons.size(); ++i) {
        lost += reasons[i].points;
        more->addWidget(make_rule());
        more->addLayout(reason_line(context, reasons[i], i, scored, show));
    }
    rest->hide();
    layout->addWidget(rest);
    QPushButton* all =
        make_button(context,
                    scored ? Result::tr("Other reasons: %1, together −%2 "
                                        "points")
                                 .arg(reasons.size() - kShownReasons)
                                 .arg(format_points(lost))
                           : Result::tr("More: %1").arg(reasons.size() - kShownReasons),
                    "quiet");
    all->setObjectName("more_reasons");
    QObject::connect(all, &QPushButton::clicked, rest, [rest, all] {
        rest->show();
        // Hidden with the focus it would hand it on to the next field, and the page would
        // scroll there.
        rest->setFocus();
        all->hide();
    });
    layout->addWidget(all, 0, Qt::AlignLeft);
}

}  // namespace

ResultData read_result(db::Store& store, int64_t attempt_id) {
    ResultData data;
    data.detail = store.attempts().detail(attempt_id);
    const db::AttemptRecord& record = data.detail.record;
    data.history = db::other_attempts(store, record);
    std::vector<int64_t> before;
    for (const db::AttemptRecord& each : data.history) {
        if (each.id == attempt_id) break;
        if (db::counts(each)) before.push_back(each.id);
    }
    const size_t from = before.size() > kBandAttempts ? before.size() - kBandAttempts : 0;
    for (size_t i = from; i < before.size(); ++i)
        data.earlier.push_back(store.attempts().detail(before[i]));
    data.comments = store.reviews().comments(attempt_id);
    data.norms = db::norms_in_use(store, record.task_id);
    return data;
}

QWidget* make_reasons_card(AppContext& context, const ResultData& data, const ShowMoment& show) {
    auto* layout = new QVBoxLayout;
    layout->setSpacing(kSpace12);
    // A critical error decides the verdict, whatever it costs: it comes first.
    std::vector<assessment::Reason> reasons = data.detail.score.reasons;
    std::stable_partition(reasons.begin(), reasons.end(),
                          [](const assessment::Reason& reason) { return reason.critical; });
    const bool scored = db::counts(data.detail.record);
    if (!scored)
        std::erase_if(reasons, [](const assessment::Reason& reason) {
            return reason.meaning.pattern == assessment::kNotMeasuredPattern;
        });
    QLabel* heading = make_label(reasons_heading(reasons, scored), "heading");
    heading->setObjectName("reasons_heading");
    layout->addWidget(heading);
    if (reasons.empty())
        layout->addWidget(
            make_label(Result::tr("Nothing in the rubric took points off."), "muted"));
    const size_t shown = std::min(kShownReasons, reasons.size());
    for (size_t i = 0; i < shown; ++i) {
        if (i > 0) layout->addWidget(make_rule());
        layout->addLayout(reason_line(context, reasons[i], i, scored, show));
    }
    if (reasons.size() > shown) add_other_reasons(layout, context, reasons, scored, show);
    double lost = 0;
    for (const assessment::Reason& each : reasons) lost += each.points;
    // Else whoever adds them up finds a score that cannot be right.
    if (scored && lost > kFullScore) {
        QLabel* sum =
            make_label(Result::tr("The losses add up to %1 points; a score does not go below 0.")
                           .arg(format_points(lost)),
                       "small");
        sum->setObjectName("reasons_sum");
        layout->addWidget(sum);
    }
    layout->addStretch();
    return make_card(layout);
}

QWidget* make_themes_card(AppContext& context, const ResultData& data) {
    auto* layout = new QVBoxLayout;
    layout->setSpacing(kSpace12);
    layout->addWidget(make_label(Result::tr("Strengths and weaknesses"), "heading"));
    std::vector<assessment::ThemeResult> results;
    const auto problem = context.problemOf([&] {
        const curriculum::Task task = curriculum::load_task(data.detail.record.task_id);
        std::vector<std::vector<assessment::Reason>> earlier;
        for (const db::AttemptDetail& each : data.earlier) earlier.push_back(each.score.reasons);
        results = assessment::judge_themes(task.rubric, data.detail.score.reasons, earlier);
    });
    if (problem) {
        layout->addWidget(make_label(
            Result::tr("The task is not installed here, so its rubric is unknown."), "muted"));
        layout->addWidget(make_label(problem->detail, "small"));
    }
    for (const assessment::ThemeResult& result : results) layout->addLayout(theme_line(result));
    if (results.empty() && !problem) {
        QLabel* why = make_label(
            data.detail.record.verdict == assessment::Verdict::kNotAttempted
                ? Result::tr("Nothing was done that could be judged. Begin the first step of the "
                             "task: from then on this card says what went well and what to "
                             "practise.")
                : Result::tr("The rubric of this task judges nothing that belongs here."),
            "muted");
        why->setObjectName("themes_empty");
        layout->addWidget(why);
    }
    if (!data.earlier.empty())
        layout->addWidget(make_label(Result::tr("before: mean of the last %n attempt(s)", nullptr,
                                                static_cast<int>(data.earlier.size())),
                                     "small"));
    layout->addStretch();
    QFrame* card = make_card(layout);
    card->setObjectName("themes");
    return card;
}

QWidget* make_ledger_card(AppContext& context, const ResultData& data,
                          const sim::Recording& recording, const ShowMoment& show) {
    auto* layout = new QVBoxLayout;
    layout->setSpacing(kSpace8);
    layout->addWidget(make_label(Result::tr("Damage over time"), "heading"));
    reports::LedgerPicture picture =
        reports::ledger_picture(recording, reports::scope_of(recording.header));
    picture.marks = marks_of(data.comments);
    auto* view = new LedgerView(context, std::move(picture));
    view->setObjectName("ledger");
    layout->addWidget(view);
    auto* foot = new QHBoxLayout;
    QLabel* words = make_label(Result::tr("Choose an entry to read what happened."), "muted");
    words->setObjectName("ledger_words");
    QPushButton* button = make_button(context, Result::tr("Show"), "secondary", "play");
    button->setObjectName("show_entry");
    button->setEnabled(false);
    foot->addWidget(words, 1);
    foot->addWidget(button);
    layout->addLayout(foot);
    // That nothing was harmed the picture says itself; there is nothing to choose then.
    for (QWidget* each : std::initializer_list<QWidget*>{words, button})
        each->setVisible(!view->picture().entries.empty());
    view->selected = [view, words, button](int entry) {
        words->setText(view->words(entry));
        button->setEnabled(entry >= 0);
    };
    const auto show_selected = [view, show] {
        if (view->selection() < 0) return;
        const auto& entry = view->picture().entries[static_cast<size_t>(view->selection())];
        show(std::max(0.0, entry.from_s - kLeadS));
    };
    view->chosen = [show_selected](double, int entry) {
        if (entry >= 0) show_selected();
    };
    QObject::connect(button, &QPushButton::clicked, view, show_selected);
    return make_card(layout);
}

std::vector<reports::TimeMark> marks_of(const std::vector<db::CommentRecord>& comments) {
    std::vector<reports::TimeMark> marks;
    int number = 0;
    for (const db::CommentRecord& each : comments) {
        ++number;
        if (each.time_s >= 0) marks.push_back({each.time_s, std::to_string(number)});
    }
    return marks;
}

}  // namespace placode::ui
