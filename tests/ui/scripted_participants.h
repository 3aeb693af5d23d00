// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Scripted participants of the paper's study: from enrolment to the last question through the
// widgets that a person would use. Answers are those of `placodectl study demo`.

#include <QApplication>
#include <QCheckBox>
#include <QPlainTextEdit>
#include <QProcess>
#include <QRadioButton>

#include "curriculum/questionnaire.h"
#include "curriculum/study.h"
#include "db/study_conduct.h"
#include "export_columns.h"
#include "shell_harness.h"

namespace placode::ui {

inline constexpr const char* kStudy = "face_content_validity";

/// Standard output and errors; the test fails when the program does.
inline QString run_program(const QString& program, const QStringList& arguments) {
    QProcess process;
    process.setProcessChannelMode(QProcess::MergedChannels);
    process.start(program, arguments);
    process.waitForFinished(300000);
    const QString said = QString::fromUtf8(process.readAll());
    if (process.exitStatus() != QProcess::NormalExit || process.exitCode() != 0)
        QTest::qFail(qPrintable(program + " " + arguments.join(' ') + ": " + said), __FILE__,
                     __LINE__);
    return said;
}

struct ScriptedParticipants {
    std::unique_ptr<ShellHarness> shell;
    Rows answers;             ///< One row a participant, of the shipped simulated answers.
    size_t count = 14;        ///< As in the paper.
    double seconds = 0;       ///< Of a procedure [s]; 0 = until its operator has done something.
    double real_seconds = 9;  ///< Of the last procedure of each level's first participant.
    std::vector<std::string> codes;  ///< Of those who consented, in order.

    [[nodiscard]] db::Store& store() const { return shell->owner(); }
    [[nodiscard]] bool press(const QString& name, int patience_s = 20) const {
        return QTest::qWaitFor(
                   [&] {
                       auto* button = shell->find<QAbstractButton>(name);
                       return button != nullptr && button->isEnabled();
                   },
                   patience_s * 1000) &&
               shell->click(name);
    }
    [[nodiscard]] db::Progress progress(const std::string& code) const {
        for (const auto& each : db::study_progress(store(), kStudy))
            if (each.participant.code == code) return each;
        return {};
    }
    /// Of the row's three procedures, numbered from 1: how long it lasts [s].
    [[nodiscard]] double length_s(size_t row, int procedure) const {
        // By then each of them has cut or burned: an attempt in which nothing was done counts in no
        // analysis. The expert is at the tissue first, and every second of its work is computed
        // twice.
        constexpr double kDoneS[] = {7, 8.5, 5};
        const double least_s = seconds > 0 ? seconds : kDoneS[row % 3];
        return row <= 3 && procedure == 3 ? std::max(least_s, real_seconds) : least_s;
    }
    /// The script's levels go round: 1 intermediate, 2 expert, 3 novice, ...
    [[nodiscard]] static QString device(size_t row) {
        const char* const devices[] = {"script:novice", "script:intermediate", "script:expert"};
        return devices[row % 3];
    }

    void consent(const std::string& code);
    void answer(const std::string& questionnaire, size_t row);
    void perform(double length_s);
    void takePart(size_t row);

 private:
    static constexpr int kPatienceMs = 240000;  ///< The field takes a busy machine long to build.
};

inline void ScriptedParticipants::consent(const std::string& code) {
    for (const auto& statement : curriculum::load_study(kStudy).consent.statements)
        QVERIFY(shell->click("consent_" + QString::fromStdString(statement.id)));
    auto* pad = shell->find<QWidget>("signature");
    QVERIFY(pad != nullptr);
    auto* agree = shell->find<QPushButton>("consent_given");
    QVERIFY2(!agree->isEnabled(), "nothing is signed yet");
    QTest::mousePress(pad, Qt::LeftButton, {}, QPoint(20, 70));
    for (int i = 1; i <= 8; ++i) {
        const QPoint at(20 + 18 * i, 70 - (i % 3) * 20);
        QTest::mouseMove(pad, at);
        QMouseEvent move(QEvent::MouseMove, QPointF(at), pad->mapToGlobal(QPointF(at)),
                         Qt::NoButton, Qt::LeftButton, {});
        QApplication::sendEvent(pad, &move);
    }
    QTest::mouseRelease(pad, Qt::LeftButton, {}, QPoint(170, 60));
    if (codes.empty()) shell->keep(shell->window().grab(), "80_scenario_consent_signed");
    QVERIFY(press("consent_given"));
    QVERIFY(QTest::qWaitFor([&] { return progress(code).next == "demographics"; }, 20000));
}

/// As the row of the shipped table says, item by item.
inline void ScriptedParticipants::answer(const std::string& questionnaire, size_t row) {
    QVERIFY(press("step_questionnaire"));
    QVERIFY(shell->arrives(PageId::kParticipant));
    using curriculum::ItemKind;
    for (const auto& item : curriculum::load_questionnaire(questionnaire).items) {
        const QString given = QString::fromStdString(cell(answers, row, item.id));
        if (given.isEmpty()) continue;
        const QString name = "answer_" + QString::fromStdString(item.id);
        if (item.kind == ItemKind::kLikert) {
            auto* point = shell->find<QRadioButton>(name + "_" + given);
            QVERIFY2(point != nullptr, qPrintable(name + "_" + given));
            point->click();
        } else if (item.kind == ItemKind::kChoice) {
            shell->find<QComboBox>(name)->setCurrentIndex(given.toInt() + 1);
        } else if (item.kind == ItemKind::kMultiple) {
            for (const QString& each : given.split(';'))
                shell->find<QCheckBox>(name + "_" + each)->click();
        } else if (item.kind == ItemKind::kText) {
            shell->find<QPlainTextEdit>(name)->setPlainText(given);
        } else {
            QVERIFY(shell->type(name, given));
        }
    }
    QVERIFY(shell->click("review"));
    QVERIFY2(shell->find<QPushButton>("submit_answers") != nullptr,
             qPrintable(shell->text("participant_message")));
    QVERIFY(shell->click("submit_answers"));
    QVERIFY(shell->arrives(PageId::kStudyRun));
}

inline void ScriptedParticipants::perform(double length_s) {
    QVERIFY2(shell->find<QComboBox>("device") == nullptr, "a participant chooses no device");
    QVERIFY(press("start_attempt"));
    QVERIFY(shell->arrives(PageId::kRunning));
    QVERIFY(QTest::qWaitFor(
        [&] {
            return shell->context().launcher().status().time_s > length_s ||
                   shell->window().current() == PageId::kStudyRun;
        },
        kPatienceMs));
    if (shell->window().current() == PageId::kRunning) {
        shell->confirmNext();
        QVERIFY(shell->click("stop_and_score"));
    }
    QVERIFY(shell->arrives(PageId::kStudyRun, 120));
}

inline void ScriptedParticipants::takePart(size_t row) {
    QVERIFY(shell->choose("study_device", device(row)));
    shell->confirmNext();
    QVERIFY(press("enrol"));
    QVERIFY(shell->arrives(PageId::kStudyRun));
    const std::string code = store().studies().participants(kStudy).back().code;
    consent(code);
    if (QTest::currentTestFailed()) return;
    codes.push_back(code);
    answer("demographics", row);
    if (QTest::currentTestFailed()) return;
    QVERIFY(press("step_done"));
    QVERIFY(press("step_skip"));  // Operators of a script need no getting used to.
    for (int procedure = 1; procedure <= 3; ++procedure) {
        const std::string due = "procedure_" + std::to_string(procedure);
        QVERIFY(QTest::qWaitFor([&] { return progress(code).next == due; }, 20000));
        QVERIFY(shell->text("step_line_familiarisation").contains("(skipped)"));
        perform(length_s(row, procedure));
        if (QTest::currentTestFailed()) return;
    }
    answer("face_validity", row);
    if (QTest::currentTestFailed()) return;
    QVERIFY(progress(code).next.empty());
    shell->takeBackNext();
    QVERIFY(press("run_finished"));
    QVERIFY(shell->arrives(PageId::kStudies));
}

}  // namespace placode::ui
