// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/study_preview.h"

#include <QCoreApplication>
#include <algorithm>

#include "curriculum/draft_text.h"
#include "db/study_conduct.h"
#include "ui/shell/parts.h"
#include "ui/shell/study_parts.h"
#include "ui/shell/training.h"

namespace placode::ui {
namespace {

struct StudyPreview {
    Q_DECLARE_TR_FUNCTIONS(StudyPreview)
};
using curriculum::StepKind;

void add_consent(AppContext& context, QVBoxLayout* layout, const curriculum::Consent& consent) {
    for (const auto& text : consent.information) layout->addWidget(make_label(context.in(text)));
    for (const auto& statement : consent.statements)
        layout->addWidget(make_label("☐  " + context.in(statement.text)));
    layout->addWidget(make_label(StudyPreview::tr("Signature on the screen or on paper"), "small"));
}

void add_questions(AppContext& context, QVBoxLayout* layout, const std::string& id) {
    const auto questionnaire = newest_questionnaire(context, id);
    layout->addWidget(make_label(context.in(questionnaire.introduction), "muted"));
    for (const auto& item : questionnaire.items) {
        QString text =
            qstr(curriculum::question_mark(questionnaire, item)) + "  " + context.in(item.text);
        if (item.kind == curriculum::ItemKind::kLikert)
            text += QString("   [%1 %2 … %3 %4]")
                        .arg(item.scale_min)
                        .arg(context.in(item.anchor_low))
                        .arg(item.scale_max)
                        .arg(context.in(item.anchor_high));
        using curriculum::ItemKind;
        if (item.kind == ItemKind::kNumber)
            text += QString("   [%1 … %2 %3]")
                        .arg(item.number_min)
                        .arg(item.number_max)
                        .arg(qstr(item.unit))
                        .replace(" ]", "]");
        if (item.kind == ItemKind::kVisualAnalogue)
            text += QString("   [%1 ——— %2]")
                        .arg(context.in(item.anchor_low), context.in(item.anchor_high));
        if (item.kind == ItemKind::kDate) text += "   [" + StudyPreview::tr("a date") + "]";
        if (item.kind == ItemKind::kText) text += "   [" + StudyPreview::tr("free text") + "]";
        QStringList choices;
        for (const auto& choice : item.choices) choices << context.in(choice);
        if (!choices.isEmpty()) text += "   [" + choices.join(" / ") + "]";
        const QString notes = item_notes(context, questionnaire, item);
        layout->addWidget(make_label(notes.isEmpty() ? text : text + "   · " + notes, "small"));
    }
}

}  // namespace

QString item_notes(AppContext& context, const curriculum::Questionnaire& questionnaire,
                   const curriculum::QuestionnaireItem& item) {
    QStringList notes;
    if (item.show_if) {
        QStringList values;
        const auto* other = questionnaire.item(item.show_if->item);
        for (const std::string& value : item.show_if->any_of) {
            const QString text = qstr(value);
            bool is_index = false;
            const auto index = static_cast<size_t>(text.toUInt(&is_index));
            values << (other != nullptr && is_index && index < other->choices.size()
                           ? context.in(other->choices[index])
                           : text);
        }
        notes << StudyPreview::tr("asked only if %1 = %2")
                     .arg(qstr(item.show_if->item), values.join(StudyPreview::tr(" or ")));
    }
    if (item.reverse) notes << StudyPreview::tr("reverse-keyed");
    if (item.identifying) notes << StudyPreview::tr("names a person");
    for (const auto& scale : questionnaire.scales)
        if (std::find(scale.items.begin(), scale.items.end(), item.id) != scale.items.end())
            notes << StudyPreview::tr("counts for %1").arg(context.in(scale.title));
    return notes.join(" · ");
}

curriculum::Questionnaire newest_questionnaire(AppContext& context, const std::string& id) {
    if (const auto published = context.store().definitions().find("questionnaire", id))
        return curriculum::load_questionnaire_text(published->json, "questionnaire " + id);
    return curriculum::load_questionnaire(id);
}

void check_study_questionnaires(AppContext& context, const curriculum::StudyProtocol& study) {
    for (size_t i = 0; i < study.steps.size(); ++i) {
        const auto& step = study.steps[i];
        const std::string pointer = "/steps/" + std::to_string(i);
        const bool asks = !step.questionnaire.empty();
        try {
            if (asks) (void)newest_questionnaire(context, step.questionnaire);
            if (!step.task.empty()) (void)curriculum::load_task(step.task);
        } catch (const curriculum::DefinitionError& error) {
            throw curriculum::DefinitionError(
                "study " + study.id, pointer + (asks ? "/questionnaire" : "/task"), error.what());
        }
    }
}

bool confirm_draft(AppContext& context, QWidget* parent, const std::string& json) {
    const auto draft = curriculum::draft_text(json);
    if (!draft) return true;
    return confirm(parent, StudyPreview::tr("Publish a draft?"),
                   StudyPreview::tr(
                       "This text still calls itself a draft:\n\n\"%1\"\n\nParticipants would read "
                       "it like this, and a version that is published is never changed. Put in the "
                       "approved text first: Protocols edits it.")
                       .arg(context.in(*draft)),
                   StudyPreview::tr("Publish the draft"), StudyPreview::tr("Do not publish"));
}

void publish_questionnaires(AppContext& context, const curriculum::StudyProtocol& study) {
    for (const auto& step : study.steps)
        if (!step.questionnaire.empty() &&
            !context.store().definitions().find("questionnaire", step.questionnaire))
            db::publish_on_first_use(context.store(),
                                     curriculum::load_questionnaire(step.questionnaire));
}

QWidget* make_study_preview(AppContext& context, const curriculum::StudyProtocol& study) {
    auto* layout = new QVBoxLayout;
    layout->setSpacing(kSpace8);
    layout->addWidget(
        make_badge(StudyPreview::tr("Preview: what participants go through"), "accent"));
    layout->addWidget(make_label(context.in(study.title), "title"));
    layout->addWidget(make_label(context.in(study.description), "muted"));
    if (study.visits > 1)
        layout->addWidget(make_label(StudyPreview::tr("Visits: %1").arg(study.visits)));
    int number = 0;
    for (const auto& step : study.steps) {
        layout->addWidget(make_rule());
        QString title = context.in(step.title);
        if (title.isEmpty()) title = qstr(step.id);
        layout->addWidget(make_label(QString("%1  %2").arg(++number).arg(title), "heading"));
        QStringList arms;
        for (const int arm : step.arms)
            if (study.arms) arms << context.in(study.arms->names.at(static_cast<size_t>(arm)));
        if (!arms.isEmpty())
            layout->addWidget(
                make_label(StudyPreview::tr("Only: %1").arg(arms.join(", ")), "small"));
        if (step.kind == StepKind::kConsent) add_consent(context, layout, study.consent);
        for (const auto& text : step.text) layout->addWidget(make_label(context.in(text)));
        if (!step.questionnaire.empty()) add_questions(context, layout, step.questionnaire);
        if (step.task.empty()) continue;
        const double limit = step_limit_s(step);
        QStringList rules{task_title(context, step.task),
                          limit > 0 ? StudyPreview::tr("at most %1").arg(format_duration(limit))
                                    : StudyPreview::tr("no time limit")};
        if (step.min_s > 0)
            rules << StudyPreview::tr("at least %1").arg(format_duration(step.min_s));
        rules << (step.device.empty()
                      ? StudyPreview::tr("the coordinator chooses the device")
                      : StudyPreview::tr("device: %1").arg(device_name(step.device)));
        layout->addWidget(make_label(rules.join(", "), "muted"));
    }
    QFrame* card = make_card(layout);
    card->setObjectName("study_preview");
    return card;
}

}  // namespace placode::ui
