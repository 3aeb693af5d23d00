// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Ratings by people: a queue of attempts without name and score, the OSATS form, how far raters
// agree, and how their judgement goes with the score.

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <algorithm>
#include <map>
#include <set>

#include "assessment/correlation.h"
#include "assessment/rating_block.h"
#include "curriculum/questionnaire.h"
#include "db/attempt_counting.h"
#include "db/packing.h"
#include "ui/shell/pages.h"
#include "ui/shell/parts.h"
#include "ui/shell/training.h"

namespace placode::ui {
namespace {

constexpr const char* kForm = "osats";
constexpr int kQueued = 500;

class RatingsPage : public Page {
    Q_DECLARE_TR_FUNCTIONS(RatingsPage)
 public:
    RatingsPage(AppContext& context, const Place&) : Page(context) {
        context.require(db::Action::kViewAttempts, db::Scope::kOther);
        form_ = curriculum::load_questionnaire(kForm);
        ratings_ = context.store().reviews().ratings(kForm);
        // The newest wait for a rating; what was rated may be older.
        db::AttemptFilter newest;
        newest.limit = kQueued;
        newest.studies = true;  // Their codes are no names, and raters of a study are educators.
        const auto reached = db::reached_people(context.store(), context.user().id);
        reached_ = {reached.begin(), reached.end()};
        for (const db::AttemptRecord& each : context.store().attempts().page(newest).rows)
            attempts_[each.id] = each;
        std::vector<int64_t> older;
        for (const db::RatingRecord& each : ratings_)
            if (!attempts_.contains(each.attempt_id)) older.push_back(each.attempt_id);
        attempts_.merge(context.store().attempts().records(older));
        QVBoxLayout* column = make_column(this);
        column->addWidget(make_label(tr("Ratings"), "display"));
        column->addWidget(make_label(
            tr("Watch an attempt and judge it with the OSATS form. Name and score are hidden until "
               "the rating is saved; every rater gets another order."),
            "muted"));
        column->addWidget(queueCard());
        column->addWidget(agreementCard());
        column->addWidget(ratedCard());
        column->addStretch();
    }

    [[nodiscard]] QString title() const override { return tr("Ratings"); }

 private:
    /// Attempts of others that this rater may judge and has not rated, in an order of the rater's
    /// own that stays the same from day to day.
    [[nodiscard]] std::vector<const db::AttemptRecord*> queue() const {
        std::set<int64_t> rated;
        for (const db::RatingRecord& each : ratings_)
            if (each.rater_id == context_.user().id) rated.insert(each.attempt_id);
        std::vector<std::pair<std::string, const db::AttemptRecord*>> order;
        for (const auto& [id, each] : attempts_) {
            if (each.user_id == context_.user().id || rated.contains(id) || !db::counts(each))
                continue;
            if (each.study.study.empty() && !reached_.contains(each.user_id)) continue;
            order.emplace_back(db::checksum_hex(context_.user().login + "/" + std::to_string(id)),
                               &each);
        }
        std::sort(order.begin(), order.end());
        std::vector<const db::AttemptRecord*> list;
        for (const auto& [key, each] : order) list.push_back(each);
        return list;
    }

    QWidget* queueCard() {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace12);
        const auto list = queue();
        layout->addWidget(make_label(tr("To be rated: %1").arg(list.size()), "heading"));
        if (list.empty()) {
            layout->addWidget(make_label(tr("Nothing waits for your rating."), "muted"));
            return make_card(layout);
        }
        const db::AttemptRecord& next = *list.front();
        layout->addWidget(make_label(
            tr("Next: %1, %2")
                .arg(task_title(context_, next.task_id), format_duration(next.duration_s))));
        auto* row = new QHBoxLayout;
        row->setSpacing(kSpace12);
        row->addStretch();
        QPushButton* watch = make_button(context_, tr("Watch"), "secondary", "play");
        watch->setObjectName("rating_watch");
        connect(watch, &QPushButton::clicked, this, [this, id = next.id] {
            Q_EMIT go({PageId::kWatch, id, {}, {{"blinded", true}}});
        });
        QPushButton* rate = make_button(context_, tr("Rate"), "primary", "next");
        rate->setObjectName("rating_rate");
        connect(rate, &QPushButton::clicked, this, [this, id = next.id] {
            Q_EMIT go({PageId::kParticipant,
                       0,
                       {},
                       {{"questionnaire", kForm}, {"rating_of", QVariant::fromValue<qint64>(id)}}});
        });
        row->addWidget(watch);
        row->addWidget(rate);
        layout->addLayout(row);
        QFrame* card = make_card(layout);
        card->setProperty("tone", "accent");
        return card;
    }

    /// The first scale of the form: the global rating.
    [[nodiscard]] std::optional<double> global(const db::RatingRecord& rating) const {
        const auto scores = curriculum::scale_scores(form_, rating.answers);
        return scores.empty() ? std::nullopt : scores.front().value;
    }

    /// Attempts that the same raters have all rated.
    [[nodiscard]] assessment::Scores block() const {
        assessment::RatingTable values;
        for (const db::RatingRecord& each : ratings_)
            if (const auto value = global(each)) values[each.attempt_id][each.rater_id] = *value;
        return assessment::complete_block(values, 2).scores;
    }

    QWidget* agreementCard() {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace8);
        layout->addWidget(make_label(tr("Agreement of raters"), "heading"));
        const assessment::Scores rows = block();
        QLabel* said = make_label({});
        said->setObjectName("icc");
        layout->addWidget(said);
        if (rows.size() < 2) {
            said->setText(
                tr("Two raters have to rate the same two attempts before agreement can be told."));
        } else {
            const auto problem = context_.problemOf([&] {
                const assessment::Icc icc = assessment::intraclass_correlation(rows);
                said->setText(
                    tr("ICC(2,1) %1, 95 % interval %2 to %3; mean of the raters ICC(2,k) %4 "
                       "(attempts %5, raters %6)")
                        .arg(format_number(icc.icc2.icc, 2), format_number(icc.icc2.ci95.low, 2),
                             format_number(icc.icc2.ci95.high, 2), format_number(icc.icc2k.icc, 2))
                        .arg(icc.subjects)
                        .arg(icc.raters));
            });
            if (problem)
                said->setText(tr("These ratings carry no ICC: they do not vary.") + " " +
                              problem->detail);
            if (rows.size() < 10)
                layout->addWidget(make_label(
                    tr("Fewer than 10 attempts: the interval says how little this tells."),
                    "warn"));
        }
        layout->addWidget(make_label(
            tr("Two-way random effects, absolute agreement (Shrout and Fleiss 1979)."), "small"));
        return make_card(layout);
    }

    QWidget* ratedCard() {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace8);
        layout->addWidget(make_label(tr("Ratings beside the score"), "heading"));
        std::map<int64_t, std::vector<double>> values;
        for (const db::RatingRecord& each : ratings_)
            if (const auto value = global(each)) values[each.attempt_id].push_back(*value);
        // A rater must not learn scores of attempts that are still in the own queue.
        std::set<int64_t> open;
        for (const db::AttemptRecord* each : queue()) open.insert(each->id);
        QTableWidget* table = make_table(
            {tr("Person"), tr("Task"), tr("Points"), tr("Global rating (1 to 5)"), tr("Raters")},
            tr("Ratings beside the score"));
        table->setObjectName("rated");
        table->setSortingEnabled(false);
        std::vector<double> points, judged;
        for (const auto& [id, list] : values) {
            const auto found = attempts_.find(id);
            if (found == attempts_.end() || open.contains(id)) continue;
            double mean = 0;
            for (const double value : list) mean += value / static_cast<double>(list.size());
            const int row = table->rowCount();
            table->insertRow(row);
            table->setItem(row, 0, make_cell(qstr(found->second.user_name)));
            table->setItem(row, 1, make_cell(task_title(context_, found->second.task_id)));
            table->setItem(
                row, 2,
                make_number_cell(format_points(found->second.points), found->second.points));
            table->setItem(row, 3, make_number_cell(format_number(mean, 1), mean));
            const auto n = static_cast<double>(list.size());
            table->setItem(row, 4, make_number_cell(format_number(n, 0), n));
            points.push_back(found->second.points);
            judged.push_back(mean);
        }
        fit_columns(table, 1);
        table->setFixedHeight(std::min(6, std::max(1, table->rowCount())) * kTouchTarget + 50);
        table->setVisible(table->rowCount() > 0);
        layout->addWidget(table);
        QLabel* said = make_label({}, "small");
        said->setObjectName("rating_correlation");
        layout->addWidget(said);
        if (points.size() < 5)
            said->setText(tr("With five rated attempts the correlation with the score is told."));
        else
            (void)context_.problemOf([&] { said->setText(correlation(points, judged)); });
        return make_card(layout);
    }

    [[nodiscard]] static QString correlation(const std::vector<double>& points,
                                             const std::vector<double>& judged) {
        const assessment::Correlation result = assessment::correlation(points, judged);
        return tr("Spearman's rho between score and rating: %1, 95 % interval %2 to %3 (n = %4)")
            .arg(format_number(result.spearman, 2), format_number(result.spearman_ci95.low, 2),
                 format_number(result.spearman_ci95.high, 2))
            .arg(result.n);
    }

    curriculum::Questionnaire form_;
    std::vector<db::RatingRecord> ratings_;
    std::map<int64_t, db::AttemptRecord> attempts_;
    std::set<int64_t> reached_;  ///< Whose attempts this rater may judge.
};

}  // namespace

Page* make_ratings_page(AppContext& context, const Place& place) {
    return new RatingsPage(context, place);
}

}  // namespace placode::ui
