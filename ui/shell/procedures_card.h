// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What one participant of a study has done at the simulator, for the coordinator: every attempt,
// also those that do not count; doing a procedure again for a reason; notes; deviations.

#include <functional>

#include "db/study_deviations.h"
#include "ui/shell/pages.h"
#include "ui/shell/parts.h"

class QLineEdit;

namespace placode::ui {

class ProceduresCard : public QFrame {
    Q_OBJECT
 public:
    /// @param page speaks and leads on for the card.
    /// @param changed is called when something was recorded.
    ProceduresCard(AppContext& context, Page& page, const std::string& study,
                   std::function<void()> changed);

    void open(const std::string& code);

 private:
    void readRows();
    void fillTable(QVBoxLayout* layout);
    void fillDeviations(QVBoxLayout* layout);
    [[nodiscard]] QLayout* actions();
    /// Done, and nobody operated: the coordinator decides whether it is done again.
    [[nodiscard]] static bool idle(const db::StepRecord& record);
    /// As exports and reports judge it: the step is done, and so is what its attempt has to show.
    [[nodiscard]] bool counts(const db::StepRecord& record) const;
    [[nodiscard]] QString stateWords(const db::StepRecord& record) const;
    [[nodiscard]] QString titleOf(const std::string& step) const;
    [[nodiscard]] const db::StepRecord* selected() const;
    void repeat();
    void note();

    AppContext& context_;
    Page& page_;
    std::string study_, code_;
    std::function<void()> changed_;
    std::map<std::string, QString> titles_;  ///< Of steps, in the participant's version.
    std::vector<db::StepRecord> rows_;       ///< With an attempt, oldest first.
    std::map<int64_t, db::AttemptRecord> attempts_;
    QVBoxLayout* body_ = nullptr;
    QTableWidget* table_ = nullptr;
    QLineEdit *reason_ = nullptr, *note_ = nullptr;
};

}  // namespace placode::ui
