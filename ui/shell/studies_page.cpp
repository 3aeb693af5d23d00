// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Studies: a coordinator hands the screen to a participant, sees the answers so far, exports them.

#include <QComboBox>
#include <QHBoxLayout>
#include <algorithm>
#include <set>

#include "assessment/statistics.h"
#include "reports/export.h"
#include "ui/shell/copies_left.h"
#include "ui/shell/export_folder.h"
#include "ui/shell/pages.h"
#include "ui/shell/parts.h"
#include "ui/shell/protocol_card.h"
#include "ui/shell/study_preview.h"
#include "ui/shell/table_width.h"

namespace placode::ui {
namespace {

using curriculum::ItemKind;

/// Shipped, or published here.
std::vector<std::string> known_questionnaires(AppContext& context) {
    std::vector<std::string> ids = curriculum::list_definitions("questionnaires");
    for (const auto& each : context.store().definitions().list("questionnaire"))
        if (std::find(ids.begin(), ids.end(), each.id) == ids.end()) ids.push_back(each.id);
    return ids;
}

class StudiesPage : public Page {
    Q_DECLARE_TR_FUNCTIONS(StudiesPage)
 public:
    StudiesPage(AppContext& context, const Place& place) : Page(context) {
        context.require(db::Action::kRunQuestionnaire);
        chosen_ = place.text;
        study_ = place.state.value("study").toString();
        erased_ = place.state.value("erased").toString();
        const std::vector<std::string> ids = known_questionnaires(context);
        const bool paper = std::find(ids.begin(), ids.end(), "face_validity") != ids.end();
        if (chosen_.isEmpty() && !ids.empty())
            chosen_ = paper ? QString("face_validity") : qstr(ids.front());
        questionnaire_ = newest_questionnaire(context, chosen_.toStdString());
        answers_ = context.store().studies().answers(questionnaire_.id);
        counted_ = countedAnswers();
        QVBoxLayout* column = make_column(this);
        if (QLabel* left = make_copies_left(context, erased_)) column->addWidget(left);
        column->addWidget(make_protocol_card(context, *this, study_,
                                             place.state.value("participant").toString()));
        column->addWidget(make_label(tr("Questionnaires without a protocol"), "title"));
        auto* head = new QHBoxLayout;
        head->addWidget(make_label(context.in(questionnaire_.title), "heading"), 1);
        addChooser(head, ids);
        column->addLayout(head);
        column->addWidget(make_label(context.in(questionnaire_.introduction), "muted"));
        column->addWidget(runCard());
        column->addWidget(itemsCard());
        column->addWidget(participantsCard());
        column->addStretch();
    }

    [[nodiscard]] QString title() const override { return tr("Studies"); }
    /// A change of theme or language comes back to the same study and participant: "Withdraw" must
    /// not be about somebody else by then.
    [[nodiscard]] QVariantMap state() const override {
        const auto* table = findChild<QTableWidget*>("progress_table");
        const auto* code = table != nullptr ? table->item(table->currentRow(), 0) : nullptr;
        return {{"study", study_},
                {"erased", erased_},
                {"participant", code != nullptr ? code->text() : QString()}};
    }

 private:
    void addChooser(QHBoxLayout* head, const std::vector<std::string>& ids) {
        if (ids.size() < 2) return;
        auto* chooser = new QComboBox;
        chooser->setAccessibleName(tr("Questionnaire"));
        chooser->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        chooser->setMinimumWidth(300);
        for (const std::string& id : ids)
            chooser->addItem(context_.in(newest_questionnaire(context_, id).title), qstr(id));
        chooser->setCurrentIndex(std::max(0, chooser->findData(chosen_)));
        connect(chooser, &QComboBox::activated, this, [this, chooser] {
            Q_EMIT go(
                {PageId::kStudies, 0, chooser->currentData().toString(), {{"study", study_}}});
        });
        head->addWidget(chooser);
    }

    QWidget* runCard() {
        auto* layout = new QHBoxLayout;
        layout->setSpacing(kSpace12);
        auto* text = new QVBoxLayout;
        text->addWidget(make_label(tr("New participant"), "heading"));
        text->addWidget(make_label(
            tr("Placode gives a code without a name. Hand over the screen; the participant "
               "answers, reviews and submits."),
            "muted"));
        layout->addLayout(text, 1);
        QPushButton* run =
            make_button(context_, tr("Give this questionnaire"), "secondary", "plus");
        run->setObjectName("new_participant");
        connect(run, &QPushButton::clicked, this, [this] {
            context_.guard(tr("Making a participant code"), [this] {
                const std::string code =
                    context_.store().studies().new_participant(questionnaire_.id);
                Q_EMIT go({PageId::kParticipant,
                           0,
                           qstr(code),
                           {{"questionnaire", qstr(questionnaire_.id)}}});
            });
        });
        layout->addWidget(run, 0, Qt::AlignVCenter);
        QFrame* card = make_card(layout);
        card->setProperty("tone", "accent");
        return card;
    }

    /// What the report of these answers counts: the first ones of everybody to the version that is
    /// shown. Repeated ones are not independent, and another version asks other questions.
    [[nodiscard]] std::vector<const db::AnswerRecord*> countedAnswers() {
        std::set<std::string> open;
        for (const auto& each : context_.store().studies().participants(questionnaire_.id))
            if (each.usable()) open.insert(each.code);
        std::vector<const db::AnswerRecord*> counted;
        for (const db::AnswerRecord& record : answers_)
            if (record.questionnaire_version == questionnaire_.version &&
                open.erase(record.participant) > 0)
                counted.push_back(&record);
        return counted;
    }

    /// Answers of one item as numbers, in participant order.
    [[nodiscard]] std::vector<double> numbers(const std::string& item) const {
        std::vector<double> values;
        for (const db::AnswerRecord* record : counted_) {
            const auto found = record->answers.find(item);
            if (found == record->answers.end()) continue;
            bool ok = false;
            const double value = QLocale::c().toDouble(qstr(found->second), &ok);
            if (ok) values.push_back(value);
        }
        return values;
    }

    QWidget* itemsCard() {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace12);
        auto* head = new QHBoxLayout;
        head->addWidget(make_label(tr("Answers by item"), "heading"), 1);
        const bool may = !answers_.empty() && context_.may(db::Action::kExportStudy);
        auto* format = new QComboBox;
        format->setObjectName("export_format");
        format->setAccessibleName(tr("Export format"));
        for (const auto& each : reports::export_formats())
            if (QString(each.name) != "motion-bids")  // there are no attempts here
                format->addItem(QCoreApplication::translate("ExportFormat", each.title),
                                QString(each.name));
        format->setEnabled(may);
        head->addWidget(format);
        QPushButton* button = make_button(context_, tr("Export"), "secondary", "download");
        button->setObjectName("export");
        button->setEnabled(may);
        connect(button, &QPushButton::clicked, this,
                [this, format] { exportAs(format->currentData().toString()); });
        head->addWidget(button);
        layout->addLayout(head);
        QTableWidget* table = make_table(
            {tr("Item"), tr("Question"), tr("n"), tr("Mean"), tr("SD")}, tr("Answers by item"));
        table->setObjectName("item_table");
        table->setSortingEnabled(false);
        for (const curriculum::QuestionnaireItem& item : questionnaire_.items) {
            if (item.kind != ItemKind::kLikert && item.kind != ItemKind::kNumber) continue;
            const int row = table->rowCount();
            table->insertRow(row);
            const std::vector<double> values = numbers(item.id);
            const std::optional<double> mean = assessment::mean_of(values);
            const std::optional<double> sd = assessment::sample_sd(values);
            const int n = static_cast<int>(values.size());
            table->setItem(row, 0,
                           make_cell(qstr(curriculum::question_mark(questionnaire_, item))));
            table->setItem(row, 1, make_cell(context_.in(item.text)));
            table->item(row, 1)->setToolTip(context_.in(item.text));
            table->setItem(row, 2, make_number_cell(QString::number(n), n));
            table->setItem(
                row, 3, make_number_cell(mean ? format_number(*mean, 2) : "–", mean.value_or(0)));
            table->setItem(row, 4,
                           make_number_cell(sd ? format_number(*sd, 2) : "–", sd.value_or(0)));
        }
        fit_columns(table, 1);
        table->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
        table->setFixedHeight(table->rowCount() * kTouchTarget + 46);
        layout->addWidget(table);
        layout->addWidget(make_label(
            tr("First answers of each participant to version %1, without those whose data are used "
               "no more. SD is the sample standard deviation (n − 1); missing answers are left "
               "out.")
                .arg(questionnaire_.version),
            "small"));
        return make_card(layout);
    }

    QWidget* participantsCard() {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace12);
        layout->addWidget(
            make_label(tr("Answered this questionnaire: %1").arg(answers_.size()), "heading"));
        if (answers_.empty()) {
            layout->addWidget(
                make_label(tr("Nobody has answered this questionnaire yet."), "muted"));
            return make_card(layout);
        }
        QTableWidget* table =
            make_table({tr("Code"), tr("Answered"), tr("Version"), tr("Answers"), tr("Remark")},
                       tr("Participants"));
        table->setObjectName("participant_table");
        table->setSortingEnabled(false);
        table->setRowCount(static_cast<int>(answers_.size()));
        int row = 0;
        for (const db::AnswerRecord& record : answers_) {
            table->setItem(row, 0, make_cell(qstr(record.participant)));
            table->setItem(row, 1, make_cell(format_when(record.answered_utc)));
            table->setItem(row, 2,
                           make_number_cell(QString::number(record.questionnaire_version),
                                            record.questionnaire_version));
            table->setItem(
                row, 3,
                make_number_cell(
                    tr("%1 of %2").arg(record.answers.size()).arg(questionnaire_.items.size()),
                    static_cast<double>(record.answers.size())));
            table->setItem(row, 4,
                           make_cell(record.demonstration ? tr("DEMONSTRATION") : QString()));
            ++row;
        }
        fit_columns(table, 4);
        keep_within(table, {.stretch = 4, .drop = {2}});
        table->setSortingEnabled(true);
        table->setMinimumHeight(std::min<int>(8, row + 1) * kTouchTarget + 10);
        layout->addWidget(table);
        return make_card(layout);
    }

    void exportAs(const QString& format) {
        const QString parent = context_.askFolder(this, tr("Export into this folder"));
        if (parent.isEmpty()) return;
        const QString folder = export_folder(parent, qstr(questionnaire_.id));
        context_.guard(tr("Exporting the answers"), [&] {
            context_.require(db::Action::kExportStudy);
            const reports::ExportSource source{
                reports::study_dataset(context_.store(), questionnaire_.id,
                                       {false, context_.language().toStdString()}),
                reports::recordings_of(context_.store())};
            // Before the first file: nothing leaves without its entry.
            context_.audit(("export." + format).toUtf8().constData(), "study " + chosen_, folder);
            const auto files =
                reports::export_dataset(source, format.toStdString(), folder.toStdString());
            Q_EMIT written(tr("%n file(s), read back and compared with the store: %1", nullptr,
                              static_cast<int>(files.size()))
                               .arg(folder),
                           folder);
        });
    }

    QString study_;   ///< Shown; empty: the first.
    QString erased_;  ///< Participant whose data were just erased, or none.
    QString chosen_;
    curriculum::Questionnaire questionnaire_;
    std::vector<db::AnswerRecord> answers_;
    std::vector<const db::AnswerRecord*> counted_;  ///< Of answers_.
};

}  // namespace

Page* make_studies_page(AppContext& context, const Place& place) {
    return new StudiesPage(context, place);
}

}  // namespace placode::ui
