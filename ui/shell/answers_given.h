// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a participant has answered so far: every change with its time, and answers that another one
// hides, which come back with it.

#include <QVariantMap>
#include <string>
#include <vector>

#include "curriculum/questionnaire.h"
#include "db/study_records.h"

namespace placode::ui {

class AnswersGiven {
 public:
    /// @param questionnaire outlives this.
    explicit AnswersGiven(const curriculum::Questionnaire& questionnaire)
        : questionnaire_(questionnaire) {}

    [[nodiscard]] const curriculum::Answers& all() const { return answers_; }
    [[nodiscard]] const std::vector<db::AnswerChange>& changes() const { return changes_; }
    /// Empty = none.
    [[nodiscard]] QString of(const std::string& item) const;
    /// Empty takes the answer away.
    void set(const std::string& item, const QString& answer);
    /// Puts the answer aside when others hide the item, and brings it back with it. True = shown.
    bool follow(const curriculum::QuestionnaireItem& item);

    /// In the state of a page, and back from it.
    void keepIn(QVariantMap& state) const;
    void takeFrom(const QVariantMap& state);

 private:
    /// Every change is kept with its time; typing in one field is one change.
    void log(const std::string& id, const std::string& before, const std::string& now);

    const curriculum::Questionnaire& questionnaire_;
    curriculum::Answers answers_, aside_;
    std::vector<db::AnswerChange> changes_;
};

}  // namespace placode::ui
