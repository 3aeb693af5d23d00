// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/study_publishing.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <algorithm>

#include "db/study_conduct.h"
#include "ui/shell/parts.h"
#include "ui/shell/study_parts.h"
#include "ui/shell/study_preview.h"

namespace placode::ui {
namespace {

struct ProtocolWords {
    Q_DECLARE_TR_FUNCTIONS(ProtocolCard)
};

void publish_protocol(AppContext& context, Page& page, const curriculum::StudyProtocol& protocol) {
    if (!confirm_draft(context, page.window(), protocol.json)) return;
    context.guard(ProtocolWords::tr("Publishing the study"), [&] {
        context.require(db::Action::kRunQuestionnaire);
        for (const auto& step : protocol.steps)
            if (!step.questionnaire.empty())
                db::publish_on_first_use(context.store(),
                                         curriculum::load_questionnaire(step.questionnaire));
        db::DefinitionRecord definition;
        definition.kind = "study";
        definition.id = protocol.id;
        definition.version = protocol.version;
        definition.json = protocol.json;
        definition.reason = protocol.reason;
        context.store().definitions().publish(definition);
        Q_EMIT page.go({PageId::kStudies, 0, {}, {{"study", qstr(protocol.id)}}});
    });
}

}  // namespace

void add_publishing(QVBoxLayout* layout, AppContext& context, Page& page,
                    const curriculum::StudyProtocol& protocol) {
    layout->addWidget(make_label(
        ProtocolWords::tr(
            "Not published yet. Publishing keeps this protocol for good; a change is a new "
            "version with a reason. Check the consent text first."),
        "muted"));
    auto* row = new QHBoxLayout;
    QLabel* version = make_label(
        ProtocolWords::tr(
            "The protocol that came with this program carries version %1: those before it were "
            "replaced before anybody published them here.")
            .arg(protocol.version),
        "small");
    version->setObjectName("version_words");
    version->setVisible(protocol.version > 1);
    row->addWidget(version, 1);
    row->addWidget(make_action(
        context, &page, ProtocolWords::tr("Check the consent text"), "secondary", "search",
        "check_consent", [&page, id = qstr(protocol.id)] {
            Q_EMIT page.go(
                {PageId::kProtocols, 0, {}, {{"kind", "study"}, {"id", id}, {"part", "consent"}}});
        }));
    row->addWidget(
        make_action(context, &page, ProtocolWords::tr("Publish version %1").arg(protocol.version),
                    "primary", "check", "publish_study",
                    [&context, &page, protocol] { publish_protocol(context, page, protocol); }));
    layout->addLayout(row);
}

void add_newer_version(QVBoxLayout* layout, AppContext& context, Page& page,
                       const curriculum::StudyProtocol& published) {
    const auto shipped = curriculum::list_definitions("studies");
    if (std::find(shipped.begin(), shipped.end(), published.id) == shipped.end()) return;
    const auto newer = curriculum::load_study(published.id);
    if (newer.version <= published.version) return;
    auto* row = new QHBoxLayout;
    row->addWidget(
        make_label(
            ProtocolWords::tr("Version %1 came with this program. %2 Who is enrolled already keeps "
                              "the version of that day.")
                .arg(newer.version)
                .arg(qstr(newer.reason)),
            "small"),
        1);
    row->addWidget(
        make_action(context, &page, ProtocolWords::tr("Publish version %1").arg(newer.version),
                    "secondary", "check", "publish_study",
                    [&context, &page, newer] { publish_protocol(context, page, newer); }));
    layout->addLayout(row);
}

}  // namespace placode::ui
