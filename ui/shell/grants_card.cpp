// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/grants_card.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QSpinBox>

#include "db/access.h"
#include "db/course_conduct.h"
#include "ui/shell/course_words.h"
#include "ui/shell/day_text.h"
#include "ui/shell/parts.h"
#include "ui/shell/trainee_chooser.h"
#include "ui/shell/training.h"
#include "ui/shell/typed_texts.h"

namespace placode::ui {
namespace {

constexpr int kMostAtOnce = 20;

class GrantsCard : public QFrame {
    Q_DECLARE_TR_FUNCTIONS(GrantsCard)
 public:
    GrantsCard(AppContext& context, curriculum::Course course,
               std::function<void(const QString&)> changed)
        : context_(context), course_(std::move(course)), changed_(std::move(changed)) {
        setProperty("role", "card");
        auto* layout = new QVBoxLayout(this);
        layout->setContentsMargins(kSpace24, kSpace16, kSpace24, kSpace16);
        layout->setSpacing(kSpace12);
        layout->addWidget(make_label(tr("More attempts"), "heading"));
        layout->addWidget(
            make_label(tr("For somebody whose attempts at a stage were used up, or spoilt by what "
                          "was not their fault. The grant and its reason stay in the audit."),
                       "muted"));
        addChoice(layout);
        addGrant(layout);
        standing_ = make_label(QString(QChar::Nbsp), "small");  // keeps its line
        standing_->setObjectName("grant_standing");
        layout->addWidget(standing_);
        showStanding();
    }

 private:
    void addChoice(QVBoxLayout* layout) {
        auto* row = new QHBoxLayout;
        row->setSpacing(kSpace16);
        person_ = make_search_list("grant_person");
        add_trainees(context_, person_);
        person_->setCurrentIndex(-1);  // Nobody is granted something by being first in a list.
        person_->lineEdit()->setPlaceholderText(tr("Type a name, or choose from the list"));
        stage_ = new QComboBox;
        stage_->setObjectName("grant_stage");
        stage_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        stage_->setMinimumContentsLength(20);
        for (const curriculum::CourseStage& each : course_.stages)
            if (each.max_attempts > 0)
                stage_->addItem(QString("%1. %2 · %3")
                                    .arg(&each - course_.stages.data() + 1)
                                    .arg(task_title(context_, each.task_id), mode_word(each.mode)),
                                qstr(each.id));
        row->addLayout(make_field(tr("Person"), person_), 1);
        row->addLayout(make_field(tr("Stage with a limit of attempts"), stage_), 1);
        layout->addLayout(row);
        // Of whoever would be granted something now: also by typing, which chooses no entry.
        connect(person_, &QComboBox::editTextChanged, this, [this] {
            if (person() != shown_) showStanding();
        });
        connect(stage_, &QComboBox::currentIndexChanged, this, [this] { showStanding(); });
    }

    void addGrant(QVBoxLayout* layout) {
        auto* row = new QHBoxLayout;
        row->setSpacing(kSpace16);
        attempts_ = new QSpinBox;
        attempts_->setObjectName("grant_attempts");
        attempts_->setRange(1, kMostAtOnce);
        attempts_->setMinimumHeight(kTouchTarget);
        attempts_->setMinimumWidth(110);
        row->addLayout(make_field(tr("Attempts"), attempts_));
        reason_ = new QLineEdit;
        reason_->setObjectName("grant_reason");
        reason_->setMaxLength(300);
        reason_->setPlaceholderText(tr("e.g. the device was repaired"));
        row->addLayout(make_field(tr("Reason"), reason_), 1);
        QPushButton* grant = make_button(context_, tr("Grant"), "primary", "plus");
        grant->setObjectName("grant");
        connect(grant, &QPushButton::clicked, this, [this] { this->grant(); });
        connect(reason_, &QLineEdit::returnPressed, grant, &QPushButton::click);
        row->addWidget(grant, 0, Qt::AlignBottom);
        layout->addLayout(row);
        for (QWidget* field : {static_cast<QWidget*>(person_), static_cast<QWidget*>(stage_),
                               static_cast<QWidget*>(attempts_)})
            keep_choice(field);
    }

    /// 0 = it is not clear who.
    [[nodiscard]] int64_t person() const {
        const int row = chosen_row(person_);
        return row < 0 ? 0 : person_->itemData(row).toLongLong();
    }
    [[nodiscard]] std::string stage() const {
        return stage_->currentData().toString().toStdString();
    }

    void showStanding() {
        standing_->setText(QString(QChar::Nbsp));
        const int64_t user = person();
        shown_ = user;
        if (user == 0) return;
        context_.guard(tr("Reading where the person stands"), [&] {
            db::Store& store = context_.store();
            const std::string now =
                QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
            const auto standing = db::course_standing(store, user, course_.id, now);
            const curriculum::CourseStage* at = standing.course.stage(stage());
            if (at == nullptr) return;
            const auto place = static_cast<size_t>(at - standing.course.stages.data());
            const auto& own = standing.progress.stages[place];
            QStringList words{tr("Attempts made: %1").arg(own.attempts),
                              tr("left: %1").arg(std::max(0, own.attempts_left))};
            if (own.unfinished > 0) words << tr("begun, not finished: %1").arg(own.unfinished);
            for (const db::GrantRecord& each : store.courses().grants(user))
                if (each.course_id == course_.id && each.stage_id == at->id)
                    words << tr("%1 granted on %2 by %3 (%4)")
                                 .arg(each.attempts)
                                 .arg(day_text(each.granted_utc), qstr(each.granted_by),
                                      qstr(each.reason));
            standing_->setText(words.join(" · "));
        });
    }

    void grant() {
        context_.guard(tr("Granting attempts"), [this] {
            const int row = chosen_row(person_);
            if (row < 0)
                throw Refusal(why_no_row(
                    person_, tr("There is nobody called \"%1\" whom you teach; choose one of the "
                                "list.")));
            const QString reason = reason_->text().simplified();
            if (reason.isEmpty()) {
                reason_->setFocus();
                throw Refusal(
                    tr("A grant needs a reason: why is this person to have more attempts "
                       "than others?"));
            }
            const int64_t user = person_->itemData(row).toLongLong();
            context_.require(db::Action::kAssignCourses,
                             db::scope_between(context_.store(), context_.user().id, user));
            context_.store().courses().grant_attempts(
                {user, course_.id, stage(), attempts_->value(), reason.toStdString(), {}, {}});
            const int granted = attempts_->value();
            reason_->clear();
            attempts_->setValue(1);
            showStanding();
            changed_(tr("More attempts for %1: %2.").arg(person_->itemText(row)).arg(granted));
        });
    }

    AppContext& context_;
    curriculum::Course course_;
    std::function<void(const QString&)> changed_;
    int64_t shown_ = 0;  ///< Whose standing.
    QComboBox *person_ = nullptr, *stage_ = nullptr;
    QSpinBox* attempts_ = nullptr;
    QLineEdit* reason_ = nullptr;
    QLabel* standing_ = nullptr;
};

}  // namespace

QWidget* make_grants_card(AppContext& context, const curriculum::Course& course,
                          std::function<void(const QString&)> changed) {
    const bool limited =
        std::any_of(course.stages.begin(), course.stages.end(),
                    [](const curriculum::CourseStage& each) { return each.max_attempts > 0; });
    return limited ? new GrantsCard(context, course, std::move(changed)) : nullptr;
}

}  // namespace placode::ui
