// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/course_preview.h"

#include <QVBoxLayout>

#include "db/course_conduct.h"
#include "ui/shell/course_words.h"
#include "ui/shell/parts.h"
#include "ui/shell/training.h"

namespace placode::ui {

CoursePreview::CoursePreview(AppContext& context) : context_(context) {
    auto* layout = new QVBoxLayout;
    layout->setSpacing(kSpace8);
    layout->addWidget(make_label(tr("Preview: the first day of a trainee"), "heading"));
    rows_ = new QVBoxLayout;
    rows_->setSpacing(kSpace4);
    layout->addLayout(rows_);
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->addWidget(make_card(layout));
}

void CoursePreview::follow(const curriculum::Course& course) {
    while (QLayoutItem* item = rows_->takeAt(0)) {
        if (item->widget()) item->widget()->deleteLater();
        delete item;
    }
    const auto progress = curriculum::course_progress(course, {});
    rows_->addWidget(make_label(context_.in(course.title), "title"));
    const auto next = curriculum::next_step(course, progress, db::task_titles(course), {}, "");
    QLabel* why = make_label(course.stages.empty() ? tr("What a trainee sees first appears here.")
                                                   : context_.in(next.reason),
                             "muted");
    why->setObjectName("preview_next");
    rows_->addWidget(why);
    for (size_t i = 0; i < course.stages.size(); ++i) {
        const curriculum::CourseStage& stage = course.stages[i];
        QStringList missing;
        for (const std::string& id : progress.stages[i].missing)
            missing << task_title(context_, id);
        QString line =
            QString("%1. %2 · %3 · %4")
                .arg(i + 1)
                .arg(task_title(context_, stage.task_id), mode_word(stage.mode),
                     missing.isEmpty() ? tr("open")
                                       : tr("opens when mastered: %1").arg(missing.join(", ")));
        rows_->addWidget(make_label(line));
        rows_->addWidget(make_label(stage_rule_words(stage), "small"));
        if (stage.mode == curriculum::StageMode::kExam)
            rows_->addWidget(make_label(exam_words(stage.exam), "small"));
    }
}

}  // namespace placode::ui
