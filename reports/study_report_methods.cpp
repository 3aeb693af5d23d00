// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Which study it is, how it was done and counted, with which software and data.

#include <QCryptographicHash>
#include <algorithm>

#include "reports/attempt_counts.h"
#include "reports/study_report_parts.h"
#include "reports/text.h"
#include "sim/core/counted.h"

namespace placode::reports {
namespace {

/// "2 attempts".
template <typename Count>
QString many(Count count, const char* noun, const char* plural = "") {
    return QString::fromStdString(sim::counted(count, noun, plural));
}

QString aids_of(const curriculum::StudyStep& step) {
    const std::string names = curriculum::aid_names(step.allowed_aids());
    return names.empty() ? QStringLiteral("none")
                         : safe(names)
                               .replace(QLatin1String(","), QLatin1String(", "))
                               .replace(QLatin1Char('_'), QLatin1Char(' '));
}

/// " (1 of them does not count)", so that no number here contradicts the analyses.
QString uncounted_part(const Dataset& data) {
    const int n = attempt_counts(data).uncounted();
    if (n == 0) return {};
    return QString(" (%1 of them %2 not count)").arg(n).arg(n == 1 ? "does" : "do");
}

QString steps_of(const curriculum::StudyProtocol& protocol) {
    QString steps;
    for (const auto& step : protocol.steps) {
        QString name = safe(step.title.en.empty() ? step.id : step.title.en);
        if (step.max_s > 0) name += " (at most " + number(step.max_s, 0) + " s)";
        if (step.kind == curriculum::StepKind::kProcedure)
            name += step.time_limit_s ? " (limit " + number(*step.time_limit_s, 0) + " s)"
                                      : QStringLiteral(" (no limit of the study)");
        if (step.min_s > 0) name += " (at least " + number(step.min_s, 0) + " s)";
        if (step.is_attempt())
            name += " (device: " +
                    (step.device.empty() ? QStringLiteral("the coordinator's choice")
                                         : safe(step.device)) +
                    "; aids: " + aids_of(step) + ")";
        steps += (steps.isEmpty() ? "" : ", ") + name;
    }
    return steps;
}

/// What participants went through: an amendment has no say in what was done before it.
void write_ways(Paper& paper, const StudyReport& report) {
    const auto versions = report.protocols.in_use();
    QStringList sources;
    for (const curriculum::StudyProtocol* protocol : versions) {
        const auto n = std::ranges::count_if(report.everybody, [&](const auto& each) {
            const auto* own = report.protocols.of(each.code);
            return own != nullptr && own->version == protocol->version;
        });
        const QString who = versions.size() == 1
                                ? QStringLiteral("Each participant")
                                : QString("Each participant of protocol version %1 (n = %2)")
                                      .arg(protocol->version)
                                      .arg(n);
        paper.html("<p>" + who + " went through: " + steps_of(*protocol) +
                   ". Visits: " + QString::number(protocol->visits) + ".</p>");
        if (!protocol->source.empty()) sources << safe(protocol->source);
    }
    sources.removeDuplicates();
    for (const QString& source : sources) paper.html("<p>Protocol: " + source + ".</p>");
}

}  // namespace

void write_title(Paper& paper, const StudyReport& report) {
    const Dataset& data = report.data;
    QString html;
    if (data.demonstration)
        html += QStringLiteral(
            "<p style='background-color:#fff1d6'><b>&nbsp;DEMONSTRATION</b> - simulated "
            "participants. No person gave these answers.</p>");
    html += "<p style='font-size:22px'><b>" + safe(data.title) + "</b></p>";
    html += "<p style='color:#5f666e'>Study " + safe(data.id) +
            (data.version > 0 ? ", protocol version " + QString::number(data.version)
                              : QStringLiteral(", without a published protocol")) +
            " &middot; report of " + safe(data.created_utc) + "</p>";
    if (!data.description.empty()) html += "<p>" + safe(data.description) + "</p>";
    paper.html(html);
}

void write_methods(Paper& paper, const StudyReport& report) {
    paper.heading("Methods");
    write_ways(paper, report);
    for (const auto& instrument : report.instruments)
        paper.html("<p><b>" + safe(instrument.title.en) + "</b> (" + safe(instrument.id) +
                   ", version " + QString::number(instrument.version) + "): " +
                   safe(instrument.source) + ". Licence: " + safe(instrument.licence) + ".</p>");
    paper.html(QStringLiteral(
        "<p><b>Statistics.</b> SD is the sample standard deviation (n - 1). Quartiles are of "
        "type 7. The interval of a mean is Student's, of a share Wilson's score interval, of "
        "Cronbach's alpha Feldt's, of Cliff's delta that of DeLong's area (delta = 2 A - 1); all "
        "intervals are at 95 %, all tests two-sided. Groups are compared by the exact permutation "
        "distribution of the Mann-Whitney statistic with ties, above 60 people by its normal "
        "approximation with continuity correction; p values of one family are adjusted "
        "by Holm's method. Top-2 is the share of answers in the two highest categories among "
        "those given. Missing answers are left out item by item and counted; alpha uses complete "
        "cases. Of repeated answers the first is analysed.</p>"));
}

void write_versions(Paper& paper, const StudyReport& report) {
    paper.heading("Software and data");
    const Dataset& data = report.data;
    const auto checksum = [](const std::string& text) {
        return QString::fromLatin1(
            QCryptographicHash::hash(QByteArray::fromStdString(text), QCryptographicHash::Sha256)
                .toHex()
                .left(16));
    };
    QString html = "<p>" + safe(data.software) + "; data read from the store at " +
                   safe(data.created_utc) + ": " + many(data.participants.size(), "participant") +
                   ", " + many(data.answers.size(), "set of answers", "sets of answers") + ", " +
                   many(data.attempts.size(), "attempt") + uncounted_part(data) + ", " +
                   many(cells_of(data).size(), "value") + ".</p><p>";
    if (!data.definition_json.empty())
        html += "Protocol " + safe(data.id) + " version " + QString::number(data.version) +
                ", SHA-256 " + checksum(data.definition_json) + "...<br/>";
    for (const auto& [name, json] : data.questionnaire_json)
        html += "Questionnaire " + safe(name) + ", SHA-256 " + checksum(json) + "...<br/>";
    html += "The same numbers follow from `placodectl export csv --study " + safe(data.id) +
            "` (scripts/study_report.R computes them there); the figures' data lie beside the "
            "figures, all numbers in numbers.csv.</p>";
    paper.html(html);
}

}  // namespace placode::reports
