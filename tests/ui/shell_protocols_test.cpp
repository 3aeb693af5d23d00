// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A coordinator builds a questionnaire and a study in the editor, sees mistakes while typing, looks
// at the preview, publishes; a participant then answers every kind of question of it.

#include <QApplication>
#include <QCheckBox>
#include <QFileInfo>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QRadioButton>
#include <QSlider>

#include "curriculum/questionnaire.h"
#include "curriculum/study.h"
#include "reports/export.h"
#include "shell_harness.h"

namespace placode::ui {

namespace {

/// Every kind of question, with branching, a reverse-keyed item and a scale of eleven points.
/// What the field of "Weight" takes, as it is said.
constexpr const char* kRange = "Weight: a number from 1 to 5 kg";
constexpr const char* kKinds = R"({
  "id": "kinds", "version": 1,
  "title": {"en": "Every kind", "pl": "Każdy rodzaj"},
  "sections": [{"id": "s", "title": {"en": "Section"}, "introduction": {"en": "Introduced"}}],
  "items": [
    {"id": "L", "kind": "likert", "section": "s", "text": {"en": "Five points"},
     "scale_min": 1, "scale_max": 5, "anchor_low": {"en": "low"}, "anchor_high": {"en": "high"},
     "not_applicable": true},
    {"id": "W", "kind": "likert", "section": "s", "text": {"en": "Eleven points"}, "reverse": true,
     "scale_min": 0, "scale_max": 10, "anchor_low": {"en": "no pain"},
     "anchor_high": {"en": "worst"}},
    {"id": "N", "kind": "number", "text": {"en": "Weight"}, "number_min": 1, "number_max": 5,
     "unit": "kg"},
    {"id": "D", "kind": "date", "text": {"en": "Day"}},
    {"id": "V", "kind": "visual_analogue", "text": {"en": "Line"}, "number_min": 0,
     "number_max": 1, "anchor_low": {"en": "none"}, "anchor_high": {"en": "all"}},
    {"id": "C", "kind": "choice", "text": {"en": "Trained?"},
     "choices": [{"en": "no"}, {"en": "yes"}]},
    {"id": "M", "kind": "multiple", "text": {"en": "Which?"},
     "choices": [{"en": "box"}, {"en": "computer"}], "show_if": {"item": "C", "any_of": ["1"]}},
    {"id": "T", "kind": "text", "text": {"en": "Remark"}, "required": false}
  ],
  "scales": [{"id": "both", "title": {"en": "Both"}, "items": ["L", "W"]}]
})";

/// Every kind that has a box "does not apply" beside its field.
constexpr const char* kApplies = R"({
  "id": "applies", "version": 1, "title": {"en": "What applies"},
  "items": [
    {"id": "N", "kind": "number", "text": {"en": "Weight"}, "number_min": 1, "number_max": 9,
     "not_applicable": true},
    {"id": "C", "kind": "choice", "text": {"en": "Trained?"},
     "choices": [{"en": "no"}, {"en": "yes"}], "not_applicable": true},
    {"id": "M", "kind": "multiple", "text": {"en": "Which?"},
     "choices": [{"en": "box"}, {"en": "computer"}], "not_applicable": true},
    {"id": "D", "kind": "date", "text": {"en": "Day"}, "not_applicable": true},
    {"id": "T", "kind": "text", "text": {"en": "Remark"}, "not_applicable": true},
    {"id": "V", "kind": "visual_analogue", "text": {"en": "Line"}, "number_min": 0,
     "number_max": 100, "anchor_low": {"en": "none"}, "anchor_high": {"en": "all"},
     "not_applicable": true}
  ]
})";

}  // namespace

class ShellProtocolsTest : public QObject {
    Q_OBJECT

 private Q_SLOTS:
    void initTestCase();
    void cleanupTestCase() { shell_.reset(); }

    void mistakesAreNamedWhileTyping();
    void aQuestionnaireIsBuiltFromTheForm();
    void everyKindIsPreviewedAndPublished();
    void aParticipantAnswersEveryKind();
    void whatDoesNotApplyIsPutAsideAndComesBack();
    void aStudyWithArmsIsBuiltAndPublishedWithAReason();
    void definitionsGoOutAndIn();
    void unsavedTextIsAskedAbout();
    void theFormWaitsForTextThatCanBeRead();
    void theFormTakesWhatIsOfAnotherKind();
    void whatWasRemovedIsPutBack();

 private:
    /// A questionnaire of every kind in the editor, whatever the test before has left there.
    void begin() {
        shell_->window().visit(
            {PageId::kProtocols, 0, {}, {{"kind", "questionnaire"}, {"text", kKinds}}});
        QVERIFY(shell_->arrives(PageId::kProtocols));
        QCOMPARE(list()->count(), 9);
    }
    [[nodiscard]] bool press(const QString& name) {
        return QTest::qWaitFor(
                   [&] {
                       auto* button = shell_->find<QAbstractButton>(name);
                       return button != nullptr && button->isEnabled();
                   },
                   10000) &&
               shell_->click(name);
    }
    void open(const QString& kind) {
        shell_->window().open({PageId::kProtocols, 0, {}, {{"kind", kind}}});
        QVERIFY(QTest::qWaitFor(
            [&] {
                return shell_->window().current() == PageId::kProtocols &&
                       shell_->window().page()->state().value("kind") == kind;
            },
            10000));
    }
    /// What the fields of kApplies show, one after the other, and which of them can be used.
    [[nodiscard]] QStringList fieldsShow() const {
        return {shell_->find<QLineEdit>("answer_N")->text(),
                QString::number(shell_->find<QComboBox>("answer_C")->currentIndex()),
                shell_->find<QCheckBox>("answer_M_1")->isChecked() ? "ticked" : "not ticked",
                shell_->find<QLineEdit>("answer_D")->text(),
                shell_->find<QPlainTextEdit>("answer_T")->toPlainText(),
                QString::number(shell_->find<QSlider>("answer_V")->value())};
    }
    [[nodiscard]] int fieldsInUse() const {
        int count = 0;
        for (const char* name :
             {"answer_N", "answer_C", "answer_M_1", "answer_D", "answer_T", "answer_V"})
            count += shell_->find<QWidget>(name)->isEnabled() ? 1 : 0;
        return count;
    }
    [[nodiscard]] QPlainTextEdit* json() { return shell_->find<QPlainTextEdit>("definition_json"); }
    [[nodiscard]] QListWidget* list() { return shell_->find<QListWidget>("elements"); }
    [[nodiscard]] bool statusSays(const QString& words) {
        return QTest::qWaitFor([&] { return shell_->text("definition_status").contains(words); },
                               5000);
    }

    std::unique_ptr<ShellHarness> shell_;
};

void ShellProtocolsTest::initTestCase() {
    shell_ = std::make_unique<ShellHarness>();
    QVERIFY(shell_->setUpWithDemonstration());
    QVERIFY(shell_->signIn("demo.coordinator", "placode-demo"));
    QVERIFY(shell_->arrives(PageId::kStudies));
}

void ShellProtocolsTest::mistakesAreNamedWhileTyping() {
    open("study");
    QVERIFY(statusSays("No errors."));
    QVERIFY(shell_->find<QPushButton>("definition_publish")->isEnabled());
    shell_->shot("70_protocol_editor");
    const QString good = json()->toPlainText();
    json()->setPlainText(QString(good).replace("\"diathermy_ring\"", "\"no_such_task\""));
    QVERIFY2(statusSays("no_such_task"), qPrintable(shell_->text("definition_status")));
    QVERIFY(!shell_->find<QPushButton>("definition_publish")->isEnabled());
    json()->setPlainText(QString(good).replace("\"max_s\"", "\"max_minutes\""));
    QVERIFY2(statusSays("max_minutes") || statusSays("/steps/3"),
             qPrintable(shell_->text("definition_status")));
    json()->setPlainText(good.left(200));
    QVERIFY(QTest::qWaitFor(
        [&] { return !shell_->find<QPushButton>("definition_publish")->isEnabled(); }, 5000));
    shell_->shot("71_protocol_mistake");
    json()->setPlainText(good);
    QVERIFY(statusSays("No errors."));
    for (const QSize size : {QSize(1024, 768), QSize(1920, 1080)}) {
        shell_->window().resize(size);
        QTest::qWait(80);
        QVERIFY2(shell_->fits(), qPrintable(QString::number(size.width())));
    }
    shell_->window().resize(1366, 768);
}

void ShellProtocolsTest::aQuestionnaireIsBuiltFromTheForm() {
    // The text was set by hand above: leaving has to be affirmed.
    shell_->confirmNext();
    open("questionnaire");
    if (QTest::currentTestFailed()) return;
    QVERIFY(press("definition_new"));
    QVERIFY(statusSays("No errors."));
    QVERIFY(shell_->type("form_id", "built"));
    QVERIFY(press("element_add"));
    QCOMPARE(list()->count(), 3);
    QVERIFY(shell_->type("form_id", "weight"));
    QVERIFY(shell_->choose("form_kind", "number"));
    QVERIFY(shell_->type("form_text_en", "How heavy?"));
    QVERIFY(shell_->type("form_text_pl", "Jak wiele?"));
    QVERIFY(shell_->type("form_number_min", "1"));
    QVERIFY(shell_->type("form_number_max", "abc"));
    QVERIFY(statusSays("number_max"));
    QVERIFY(shell_->type("form_number_max", "5,5"));
    QVERIFY(shell_->type("form_show_if", "A = 4 5"));
    QVERIFY2(statusSays("No errors."), qPrintable(shell_->text("definition_status")));
    const auto read = curriculum::load_questionnaire_text(json()->toPlainText().toStdString(), "t");
    QCOMPARE(read.id, std::string("built"));
    QCOMPARE(read.items.size(), size_t(2));
    QCOMPARE(read.items[1].number_max, 5.5);
    QCOMPARE(read.items[1].text.pl, std::string("Jak wiele?"));
    QCOMPARE(read.items[1].show_if->any_of, (std::vector<std::string>{"4", "5"}));
    QVERIFY(press("element_up"));
    QVERIFY2(statusSays("no earlier item"), "a condition on a later question");
    QVERIFY(press("element_down"));
    QVERIFY(press("element_add"));
    QVERIFY(press("element_remove"));
    QCOMPARE(list()->count(), 3);
    shell_->whole("72_questionnaire_built");
    shell_->confirmNext();
    QVERIFY(press("definition_publish"));
    QVERIFY(shell_->bannerSays("is published"));
    QVERIFY(shell_->owner().definitions().find("questionnaire", "built").has_value());
}

void ShellProtocolsTest::everyKindIsPreviewedAndPublished() {
    open("questionnaire");
    json()->setPlainText(kKinds);
    QVERIFY2(statusSays("No errors."), qPrintable(shell_->text("definition_status")));
    QVERIFY(press("definition_preview"));
    QVERIFY(shell_->arrives(PageId::kParticipant));
    // Who builds it sees the condition, reverse keying and scores beside the question.
    const QWidget* page = shell_->window().page();
    QVERIFY(shell_->find<QWidget>("answer_M_0")->isVisibleTo(page));
    QCOMPARE(shell_->text("notes_M"), QString("asked only if C = yes"));
    QCOMPARE(shell_->text("notes_W"), QString("reverse-keyed · counts for Both"));
    QVERIFY(shell_->find<QLabel>("notes_N") == nullptr);
    shell_->find<QComboBox>("answer_C")->setCurrentIndex(1);
    QVERIFY2(!shell_->find<QWidget>("answer_M_0")->isVisibleTo(page), "branching hides it");
    shell_->find<QComboBox>("answer_C")->setCurrentIndex(2);
    QVERIFY(shell_->find<QWidget>("answer_M_0")->isVisibleTo(page));
    shell_->whole("73_preview_every_kind");
    QVERIFY(shell_->fits());
    QVERIFY(press("cancel_participant"));
    QVERIFY(shell_->arrives(PageId::kProtocols));
    QVERIFY2(json()->toPlainText().contains("Every kind"), "the text came back");
    shell_->confirmNext();
    QVERIFY(press("definition_publish"));
    QVERIFY(shell_->bannerSays("is published"));
    QVERIFY(shell_->owner().studies().answers("kinds").empty());
}

void ShellProtocolsTest::aParticipantAnswersEveryKind() {
    ShellHarness& shell = *shell_;
    shell.window().open({PageId::kStudies, 0, "kinds", {}});
    QVERIFY(shell.arrives(PageId::kStudies));
    QVERIFY(press("new_participant"));
    QVERIFY(shell.arrives(PageId::kParticipant));
    const QWidget* page = shell.window().page();
    auto* which = shell.find<QCheckBox>("answer_M_0");
    QVERIFY2(!which->isVisibleTo(page), "branching hides it");
    shell.find<QRadioButton>("answer_L_2")->click();
    shell.find<QRadioButton>("answer_L_4")->click();  // changed before submission
    shell.find<QRadioButton>("answer_W_10")->click();
    // Letters are not taken; what is out of range is said when the field is left. Where no desktop
    // makes a window the active one, no field would be.
    QApplication::setActiveWindow(&shell.window());
    QVERIFY(!shell.type("answer_N", "a9b"));
    QCOMPARE(shell.find<QLineEdit>("answer_N")->text(), QString("9"));
    QVERIFY(!shell.find<QLabel>("missing_N")->isVisibleTo(page));
    QVERIFY(shell.type("answer_D", "2026-02-30"));
    QVERIFY2(shell.text("missing_N").endsWith(kRange), qPrintable(shell.text("missing_N")));
    QVERIFY(shell.find<QLabel>("missing_N")->isVisibleTo(page));
    auto* line = shell.find<QSlider>("answer_V");
    line->setFocus();
    for (int i = 0; i < 3; ++i) QTest::keyClick(line, Qt::Key_Right);
    shell.find<QComboBox>("answer_C")->setCurrentIndex(2);
    QVERIFY(which->isVisibleTo(page));
    which->click();
    shell.find<QCheckBox>("answer_M_1")->click();
    QVERIFY(press("review"));
    // Both at once, each in its question's words and at its field.
    const QString said = shell.text("participant_message");
    QVERIFY2(said.contains(kRange) && said.contains(": a date such as 2026-11-21"),
             qPrintable(said));
    QVERIFY2(!said.contains("item "), qPrintable(said));
    QVERIFY(shell.text("missing_N").endsWith(kRange));
    QVERIFY(shell.text("missing_D").endsWith(": a date such as 2026-11-21"));
    QVERIFY(shell.find<QFrame>("card_N")->isAncestorOf(shell.window().focusWidget()));
    QVERIFY(shell.find<QLabel>("missing_D")->isVisibleTo(page));
    shell.keep(shell.window().grab(), "74_wrong_answers");
    QVERIFY(shell.type("answer_N", "2,5"));
    QVERIFY(!shell.find<QLabel>("missing_N")->isVisibleTo(page));
    QVERIFY(press("review"));
    QVERIFY(!shell.text("participant_message").contains(kRange));
    QVERIFY(shell.find<QLabel>("missing_D")->isVisibleTo(page));
    QVERIFY(shell.type("answer_D", "2026-02-28"));
    QVERIFY(press("review"));
    // Without a change of theme, which would lead back to the questions.
    shell.keep(shell.window().grab(), "74_every_kind_review");
    QVERIFY(press("submit_answers"));
    shell.takeBackNext();
    QVERIFY(press("participant_done"));
    const auto answers = shell.owner().studies().answers("kinds");
    QCOMPARE(answers.size(), size_t(1));
    QCOMPARE(answers[0].answers, (curriculum::Answers{{"L", "4"},
                                                      {"W", "10"},
                                                      {"N", "2.5"},
                                                      {"D", "2026-02-28"},
                                                      {"V", "0.53"},
                                                      {"C", "1"},
                                                      {"M", "0;1"}}));
    std::vector<std::string> likert;
    for (const auto& change : answers[0].changes)
        if (change.item == "L") likert.push_back(change.old_answer + ">" + change.new_answer);
    QCOMPARE(likert, (std::vector<std::string>{">2", "2>4"}));
    // Reverse-keyed: 10 of 0..10 counts as 0.
    const auto form = curriculum::load_questionnaire_text(kKinds, "kinds");
    QCOMPARE(*curriculum::scale_scores(form, answers[0].answers).front().value, 2.0);
}

// Unticked, the box took the answer away that the field still showed.
void ShellProtocolsTest::whatDoesNotApplyIsPutAsideAndComesBack() {
    ShellHarness& shell = *shell_;
    shell.window().open({PageId::kParticipant, 0, {}, {{"preview", QString(kApplies)}}});
    QVERIFY(shell.arrives(PageId::kParticipant));
    const auto answers = [&shell] { return shell.window().page()->state()["answers"].toMap(); };
    const QStringList items{"N", "C", "M", "D", "T", "V"};
    const auto click = [&shell, &items] {
        for (const QString& item : items) shell.find<QCheckBox>("answer_" + item + "_NA")->click();
    };
    QVERIFY(shell.type("answer_N", "5"));
    shell.find<QComboBox>("answer_C")->setCurrentIndex(2);
    shell.find<QCheckBox>("answer_M_1")->click();
    QVERIFY(shell.type("answer_D", "2026-02-28"));
    shell.find<QPlainTextEdit>("answer_T")->setPlainText("slow");
    shell.find<QSlider>("answer_V")->setValue(20);
    const QVariantMap given = answers();
    const QStringList shown = fieldsShow();
    const QStringList nothing{"", "0", "not ticked", "", "", "50"};
    QCOMPARE(shown, (QStringList{"5", "2", "ticked", "2026-02-28", "slow", "20"}));
    click();
    for (const QString& item : items) QCOMPARE(answers()[item].toString(), QString("NA"));
    QCOMPARE(fieldsShow(), nothing);
    QCOMPARE(fieldsInUse(), 0);
    click();
    QCOMPARE(answers(), given);
    QCOMPARE(fieldsShow(), shown);
    QCOMPARE(fieldsInUse(), 6);
    // In the other language the boxes are ticked still, and no entry is chosen.
    click();
    shell.context().setLanguage("pl");
    QVERIFY(shell.arrives(PageId::kParticipant));
    for (const QString& item : items) {
        QVERIFY(shell.find<QCheckBox>("answer_" + item + "_NA")->isChecked());
        QCOMPARE(answers()[item].toString(), QString("NA"));
    }
    QCOMPARE(fieldsShow(), nothing);
    QCOMPARE(fieldsInUse(), 0);
    click();
    QVERIFY2(answers().isEmpty(), "nothing is shown and nothing is answered");
    QCOMPARE(fieldsShow(), nothing);
    shell.context().setLanguage("en");
    QVERIFY(shell.arrives(PageId::kParticipant));
}

void ShellProtocolsTest::aStudyWithArmsIsBuiltAndPublishedWithAReason() {
    open("study");
    QVERIFY(press("definition_new"));
    list()->setCurrentRow(2);  // Arms
    shell_->find<QPlainTextEdit>("form_names")->setPlainText("haptic | haptyczna\nplain | zwykła");
    QVERIFY(shell_->type("form_block_size", "3"));
    QVERIFY(statusSays("not a multiple"));
    QVERIFY(shell_->type("form_block_size", "4"));
    QVERIFY(press("element_add"));
    QVERIFY(shell_->choose("form_kind", "questionnaire"));
    QVERIFY(shell_->type("form_questionnaire", "nowhere"));
    QVERIFY(statusSays("nowhere"));
    QVERIFY(shell_->type("form_questionnaire", "kinds"));
    QVERIFY(shell_->type("form_arms", "0"));
    QVERIFY2(statusSays("No errors."), qPrintable(shell_->text("definition_status")));
    list()->setCurrentRow(1);  // Consent
    shell_->find<QPlainTextEdit>("form_statements")
        ->setPlainText("voluntary | I take part. | Biorę udział.\ndata | Use it. | Zgoda.");
    QVERIFY(press("definition_preview"));
    QVERIFY(shell_->find<QWidget>("study_preview") != nullptr);
    shell_->whole("75_study_built");
    // What still calls itself a draft asks first.
    const QString ready = json()->toPlainText();
    json()->setPlainText(QString(ready).replace("I take part.", "DRAFT: I take part."));
    QVERIFY(statusSays("No errors."));
    shell_->refuseNext();
    QVERIFY(press("definition_publish"));
    QVERIFY(!shell_->owner().definitions().find("study", "my_study").has_value());
    json()->setPlainText(ready);
    QVERIFY(statusSays("No errors."));
    shell_->confirmNext();
    QVERIFY(press("definition_publish"));
    QVERIFY(shell_->bannerSays("is published"));
    const auto first = shell_->owner().definitions().find("study", "my_study");
    QVERIFY(first.has_value());
    const auto study = curriculum::load_study_text(first->json, "my_study");
    QCOMPARE(study.arms->names.size(), size_t(2));
    QCOMPARE(study.consent.statements.at(1).text.pl, std::string("Zgoda."));
    QCOMPARE(study.steps.at(1).arms, std::vector<int>{0});
    // The same version with another text, and a new version without a reason, are refused.
    list()->setCurrentRow(0);
    QVERIFY(shell_->type("form_title_en", "Amended"));
    shell_->confirmNext();
    QVERIFY(press("definition_publish"));
    QVERIFY(shell_->bannerSays("next version"));
    QVERIFY(shell_->type("form_version", "2"));
    shell_->confirmNext();
    QVERIFY(press("definition_publish"));
    QVERIFY(shell_->bannerSays("reason"));
    QVERIFY(shell_->type("publish_reason", "the committee asked for it"));
    shell_->confirmNext();
    QVERIFY(press("definition_publish"));
    QVERIFY(shell_->bannerSays("version 2 is published"));
    QCOMPARE(shell_->owner().definitions().find("study", "my_study", 1)->json, first->json);
    QCOMPARE(shell_->owner().definitions().find("study", "my_study")->reason,
             std::string("the committee asked for it"));
    // The text's own reason will do, but not that of the version before.
    QVERIFY(shell_->type("publish_reason", ""));
    for (const char* version : {"3", "4"}) {
        list()->setCurrentRow(0);
        QVERIFY(shell_->type("form_version", version));
        QVERIFY(shell_->type("form_reason", "a clearer title"));
        QVERIFY(statusSays("No errors."));
        shell_->confirmNext();
        QVERIFY(press("definition_publish"));
        QVERIFY(shell_->bannerSays(*version == '3' ? "version 3 is published" : "reason"));
    }
    QVERIFY(!shell_->owner().definitions().find("study", "my_study", 4).has_value());
    QVERIFY(shell_->type("publish_reason", "the title once more"));
    shell_->confirmNext();
    QVERIFY(press("definition_publish"));
    QVERIFY(shell_->bannerSays("version 4 is published"));
}

void ShellProtocolsTest::definitionsGoOutAndIn() {
    open("questionnaire");
    json()->setPlainText(kKinds);
    QVERIFY(statusSays("No errors."));
    shell_->save_as = shell_->path("kinds.json");
    QVERIFY(press("definition_export"));
    QVERIFY(shell_->bannerSays("kinds.json"));
    QVERIFY(press("definition_new"));
    QVERIFY(!json()->toPlainText().contains("Every kind"));
    shell_->open_this = shell_->save_as;
    QVERIFY(press("definition_import"));
    QCOMPARE(json()->toPlainText(), QString(kKinds));
    shell_->context().setLanguage("pl");
    QVERIFY(shell_->arrives(PageId::kProtocols));
    QVERIFY(statusSays("Brak błędów"));
    shell_->shot("76_protocol_editor_polish");
    shell_->context().setLanguage("en");
}

// New, and the rail during a preview, took a text that stood nowhere else.
void ShellProtocolsTest::unsavedTextIsAskedAbout() {
    begin();
    if (QTest::currentTestFailed()) return;
    const QString typed = QString(kKinds).replace("Remark", "Typed by hand");
    const auto refused = [this](PageId here) {
        shell_->refuseNext();
        shell_->window().open({PageId::kStudies, 0, {}, {}});
        return shell_->window().current() == here;
    };
    json()->setPlainText(typed);
    shell_->refuseNext();
    QVERIFY(press("definition_new"));
    QCOMPARE(json()->toPlainText(), typed);
    QVERIFY(press("definition_preview"));
    QVERIFY(shell_->arrives(PageId::kParticipant));
    QVERIFY(refused(PageId::kParticipant));
    QVERIFY(press("cancel_participant"));
    QVERIFY(shell_->arrives(PageId::kProtocols));
    QCOMPARE(json()->toPlainText(), typed);
    QVERIFY(refused(PageId::kProtocols));
    QCOMPARE(json()->toPlainText(), typed);
    // Whoever stays finds lists and text about the same definition.
    auto* chooser = shell_->find<QComboBox>("definition_id");
    const int shown = chooser->currentIndex(), other = shown == 0 ? 1 : 0;
    QVERIFY(chooser->count() > 1);
    shell_->refuseNext();
    chooser->setCurrentIndex(other);
    Q_EMIT chooser->activated(other);
    QCOMPARE(chooser->currentIndex(), shown);
    QCOMPARE(json()->toPlainText(), typed);
    // So they are in another theme.
    list()->setCurrentRow(3);
    for (const ThemeKind theme : {ThemeKind::kDark, ThemeKind::kLight}) {
        shell_->context().setTheme(theme);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        QCOMPARE(list()->currentRow(), 3);
        QCOMPARE(shell_->find<QComboBox>("definition_id")->currentIndex(), shown);
        QCOMPARE(json()->toPlainText(), typed);
    }
    // Of what was exported nothing is asked.
    shell_->save_as = shell_->path("typed.json");
    QVERIFY(press("definition_export"));
    QVERIFY(press("definition_preview"));
    QVERIFY(shell_->arrives(PageId::kParticipant));
    shell_->window().open({PageId::kStudies, 0, {}, {}});
    QVERIFY(shell_->arrives(PageId::kStudies));
}

// The form holds what the text was before: with one comma missing, a touch of it wrote that over
// everything that was typed since.
void ShellProtocolsTest::theFormWaitsForTextThatCanBeRead() {
    begin();
    if (QTest::currentTestFailed()) return;
    QString broken = QString(kKinds).replace("Remark", "Typed by hand");
    broken.remove(broken.indexOf(','), 1);
    json()->setPlainText(broken);
    // Also before the page has read it: it waits for a moment without a key.
    QVERIFY(shell_->click("element_add"));
    QCOMPARE(json()->toPlainText(), broken);
    QVERIFY(statusSays("The form waits until the text can be read"));
    for (const char* name : {"element_add", "element_up", "element_down", "element_remove"})
        QVERIFY2(!shell_->find<QPushButton>(name)->isEnabled(), name);
    QVERIFY(!shell_->find<QLineEdit>("form_id")->isEnabled());
    QCOMPARE(json()->toPlainText(), broken);
    const QString mended = QString(kKinds).replace("Remark", "Typed by hand");
    json()->setPlainText(mended);
    QVERIFY(press("element_add"));
    QCOMPARE(list()->count(), 10);
    QVERIFY(json()->toPlainText().contains("Typed by hand"));
    // A field of the form, a moment after a key in the text: the text leads, the form follows.
    json()->setPlainText(mended);
    QTest::keyClick(shell_->find<QLineEdit>("form_id"), Qt::Key_X);  // It is gone afterwards.
    QCOMPARE(json()->toPlainText(), mended);
    QVERIFY(QTest::qWaitFor([&] { return list()->count() == 9; }, 5000));
}

// JSON can be read and be of another kind than any definition: it ended the program.
void ShellProtocolsTest::theFormTakesWhatIsOfAnotherKind() {
    shell_->window().visit({PageId::kProtocols, 0, {}, {{"kind", "study"}}});
    QVERIFY(shell_->arrives(PageId::kProtocols));
    json()->setPlainText(R"({"id": 7, "arms": [], "consent": "", "steps": {"a": [5]}})");
    QVERIFY(statusSays("found"));
    list()->setCurrentRow(2);
    auto* names = shell_->find<QPlainTextEdit>("form_names");
    QVERIFY(names != nullptr);
    names->setPlainText("A");
    QVERIFY(json()->toPlainText().contains("\"A\""));
    for (int row = 0; row < list()->count(); ++row) list()->setCurrentRow(row);
    const QString deep =
        R"({"arms": )" + QString("[").repeated(100000) + QString("]").repeated(100000) + "}";
    json()->setPlainText(deep);
    QVERIFY(statusSays("levels of brackets"));
    QVERIFY(!shell_->find<QPushButton>("element_add")->isEnabled());
    json()->setPlainText(R"({"id": "x"})");
    QVERIFY(statusSays("missing"));
}

void ShellProtocolsTest::whatWasRemovedIsPutBack() {
    begin();
    if (QTest::currentTestFailed()) return;
    const auto names = [this] {
        QStringList all;
        for (int row = 0; row < list()->count(); ++row) all << list()->item(row)->text();
        return all;
    };
    const QStringList before = names();
    const QString text = json()->toPlainText();
    list()->setCurrentRow(4);
    // Two clicks that were meant as one, also on a slow computer.
    const int interval = QApplication::doubleClickInterval();
    QApplication::setDoubleClickInterval(5000);
    QVERIFY(shell_->click("element_remove"));
    QVERIFY(shell_->click("element_remove"));
    QApplication::setDoubleClickInterval(interval);
    QCOMPARE(list()->count(), before.size() - 1);
    QVERIFY(!names().contains(before[4]));
    QCOMPARE(shell_->text("element_removed"), "Removed: " + before[4]);
    QTest::qWait(interval + 100);
    QVERIFY(shell_->click("element_remove"));
    QCOMPARE(list()->count(), before.size() - 2);
    // The last one first.
    QTest::qWait(interval + 100);
    QVERIFY(shell_->click("element_put_back"));
    QCOMPARE(shell_->text("element_removed"), "Removed: " + before[4]);
    QVERIFY(shell_->click("element_put_back"));
    QCOMPARE(names(), before);
    QCOMPARE(list()->currentRow(), 4);
    const QWidget* page = shell_->window().page();
    QVERIFY(!shell_->find<QPushButton>("element_put_back")->isVisibleTo(page));
    using curriculum::load_questionnaire_text;
    const auto put_back = load_questionnaire_text(json()->toPlainText().toStdString(), "t");
    const auto whole = load_questionnaire_text(text.toStdString(), "t");
    QCOMPARE(put_back.items.size(), whole.items.size());
    for (size_t i = 0; i < whole.items.size(); ++i)
        QCOMPARE(put_back.items[i].text.en, whole.items[i].text.en);
    // Of another definition nothing is put back.
    QVERIFY(shell_->click("element_remove"));
    shell_->confirmNext();
    QVERIFY(press("definition_new"));
    QVERIFY(!shell_->find<QPushButton>("element_put_back")->isVisibleTo(page));
}

}  // namespace placode::ui

int main(int argc, char** argv) {
    placode::ui::prepare_display();
    QApplication application(argc, argv);
    placode::ui::ShellProtocolsTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "shell_protocols_test.moc"
