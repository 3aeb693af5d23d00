// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/study_report.h"

#include <QCryptographicHash>
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "reports/attempt_counts.h"
#include "reports/export.h"
#include "reports/paper.h"
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

QString safe(const std::string& text) { return QString::fromStdString(text).toHtmlEscaped(); }

QString interval(const assessment::Interval& range, int decimals, double factor = 1) {
    return number(factor * range.low, decimals) + " to " + number(factor * range.high, decimals);
}

std::string item_label(const Field& field) {
    return field.id.size() <= 2 ? field.id + "  " + field.label : field.label;
}

QString p_text(double p) { return p < 0.001 ? QStringLiteral("&lt; 0.001") : number(p, 3); }

// --- figures -----------------------------------------------------------------------------------

/// Items of one form whose scales have the same width and words, in runs.
std::vector<std::vector<LikertBar>> likert_groups(const FormNumbers& form) {
    std::vector<std::vector<LikertBar>> groups;
    for (const ItemNumbers& item : form.items) {
        LikertBar bar;
        bar.id = item.field->id;
        bar.label = item.field->label;
        bar.scale_min = item.summary.scale_min;
        bar.counts = item.summary.counts;
        bar.low = item.field->codes.front().label;
        bar.high = item.field->codes.back().label;
        bar.missing = item.summary.missing;
        bar.mean = item.summary.mean;
        bar.sd = item.summary.sd;
        const bool fits = !groups.empty() && groups.back().back().low == bar.low &&
                          groups.back().back().high == bar.high &&
                          groups.back().back().counts.size() == bar.counts.size();
        if (!fits) groups.emplace_back();
        groups.back().push_back(bar);
    }
    return groups;
}

void add_form_figures(std::vector<Figure>& figures, const FormNumbers& form,
                      const ChartStyle& style) {
    int part = 0;
    const auto groups = likert_groups(form);
    for (const auto& bars : groups) {
        std::string id = "likert_" + form.form->name;
        if (groups.size() > 1) id += "_" + std::to_string(++part);
        std::string title = form.form->title;
        if (!bars.front().low.empty())
            title += ": " + bars.front().low + " to " + bars.front().high;
        figures.push_back(likert_figure(id, title, bars, style));
    }
    std::vector<StripGroup> scores;
    const size_t first = figures.size() - groups.size();
    for (const NumberNumbers& each : form.numbers) {
        if (each.values.empty()) continue;
        if (each.field->derived) {
            scores.push_back({each.field->label, each.values});
            continue;
        }
        figures.push_back(strip_figure(
            "strip_" + form.form->name + "_" + each.field->id, each.field->label,
            each.field->label + (each.field->unit.empty() ? "" : " [" + each.field->unit + "]"),
            {{each.field->label, each.values}}, style));
    }
    if (!scores.empty())
        figures.push_back(strip_figure("scales_" + form.form->name,
                                       form.form->title + ": scale scores", "score", scores,
                                       style));
    for (size_t i = first; i < figures.size(); ++i) figures[i].group = form.form->name;
}

std::optional<Figure> comparison_figure(const StudyNumbers& numbers, const ChartStyle& style) {
    if (!numbers.comparison) return std::nullopt;
    const GroupComparison& comparison = *numbers.comparison;
    std::vector<ForestRow> rows;
    for (const auto& each : comparison.rows)
        rows.push_back({item_label(*each.field), each.delta.delta, each.delta.ci95.low,
                        each.delta.ci95.high,
                        "p " + number(each.p_exact, 3).toStdString() + ", Holm " +
                            number(each.p_holm, 3).toStdString(),
                        each.delta.separated});
    return forest_figure(
        "forest_" + comparison.form->name,
        comparison.by->label + " " + comparison.group1 + " (n = " + std::to_string(comparison.n1) +
            ") against " + comparison.group2 + " (n = " + std::to_string(comparison.n2) + ")",
        "Cliff's delta (right: " + comparison.group1 + " answered higher)", rows, -1, 1, style);
}

std::optional<Figure> performance_figure(const Dataset& data, const ChartStyle& style) {
    const Form* form = data.form("attempts");
    if (form == nullptr) return std::nullopt;
    std::map<std::string, LearningLine> lines;
    for (const Row& row : form->rows) {
        if (!row.counts) continue;
        const auto points = row.values.find("points"), verdict = row.values.find("verdict");
        if (points == row.values.end() || verdict == row.values.end()) continue;
        if (verdict->second == "Not attempted") continue;
        LearningLine& line = lines[row.participant];
        line.label = row.participant;
        line.points.push_back(curriculum::answer_number(points->second).value_or(0));
        line.failed.push_back(verdict->second != "Passed");
    }
    std::vector<LearningLine> list;
    for (auto& [code, line] : lines) list.push_back(std::move(line));
    if (list.empty()) return std::nullopt;
    constexpr double kPass = 70;
    return learning_figure("learning_attempts", "Scores and CUSUM over attempts", list, kPass,
                           assessment::cusum_limits(0.05, 0.10, 0.05, 0.20), style);
}

// --- the paper ---------------------------------------------------------------------------------

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

QString aids_of(const curriculum::StudyStep& step) {
    const std::string names = curriculum::aid_names(step.allowed_aids());
    return names.empty() ? QStringLiteral("none")
                         : safe(names)
                               .replace(QLatin1String(","), QLatin1String(", "))
                               .replace(QLatin1Char('_'), QLatin1Char(' '));
}

void write_methods(Paper& paper, const StudyReport& report) {
    paper.heading("Methods");
    if (!report.data.definition_json.empty()) {
        const auto protocol =
            curriculum::load_study_text(report.data.definition_json, "study " + report.data.id);
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
        paper.html("<p>Each participant went through: " + steps +
                   ". Visits: " + QString::number(protocol.visits) + ".</p>");
        if (!protocol.source.empty()) paper.html("<p>Protocol: " + safe(protocol.source) + ".</p>");
    }
    for (const auto& instrument : report.instruments)
        paper.html("<p><b>" + safe(instrument.title.en) + "</b> (" + safe(instrument.id) +
                   ", version " + QString::number(instrument.version) + "): " +
                   safe(instrument.source) + ". Licence: " + safe(instrument.licence) + ".</p>");
    paper.html(QStringLiteral(
        "<p><b>Statistics.</b> SD is the sample standard deviation (n - 1). Quartiles are of "
        "type 7. The interval of a mean is Student's, of a share Wilson's score interval, of "
        "Cronbach's alpha Feldt's, of Cliff's delta that of DeLong's area (delta = 2 A - 1); all "
        "intervals are at 95 %, all tests two-sided. Groups are compared by the exact permutation "
        "distribution of the Mann-Whitney statistic with ties; p values of one family are adjusted "
        "by Holm's method. Top-2 is the share of answers in the two highest categories among "
        "those given. Missing answers are left out item by item and counted; alpha uses complete "
        "cases. Of repeated answers the first is analysed.</p>"));
}

void write_choices(Paper& paper, const FormNumbers& form) {
    std::vector<QStringList> rows;
    for (const NumberNumbers& each : form.numbers) {
        if (each.field->derived || each.values.empty()) continue;
        std::vector<double> sorted = each.values;
        std::sort(sorted.begin(), sorted.end());
        rows.push_back({safe(each.field->label) +
                            (each.field->unit.empty() ? "" : " [" + safe(each.field->unit) + "]"),
                        "mean (SD); least to greatest",
                        number(*each.mean, 1) + " (" + (each.sd ? number(*each.sd, 1) : "-") +
                            "); " + number(sorted.front(), 1) + " to " + number(sorted.back(), 1),
                        QString::number(each.values.size()), QString::number(each.missing)});
    }
    for (const ChoiceNumbers& each : form.choices) {
        for (size_t i = 0; i < each.counts.size(); ++i) {
            if (each.counts[i] == 0) continue;
            rows.push_back({i == 0 || rows.empty() || rows.back()[0] != safe(each.field->label)
                                ? safe(each.field->label)
                                : QString(),
                            safe(each.field->codes[i].label),
                            QString("%1 (%2 %)")
                                .arg(each.counts[i])
                                .arg(number(100.0 * each.counts[i] / std::max(1, each.n), 1)),
                            QString::number(each.n), QString::number(each.missing)});
        }
    }
    if (rows.empty()) return;
    QString last;  // The question stands once, before its first answer.
    for (QStringList& row : rows) {
        const QString own = row[0];
        if (!own.isEmpty() && own == last) row[0].clear();
        if (!own.isEmpty()) last = own;
    }
    paper.table(safe(form.form->title) + ": participants' characteristics and choices.",
                {"question", "answer", "value", "n", "missing"}, "llrrr", rows);
}

void write_items(Paper& paper, const FormNumbers& form) {
    if (form.items.empty()) return;
    std::vector<QStringList> rows;
    for (const ItemNumbers& item : form.items) {
        const auto& s = item.summary;
        if (s.n == 0) {
            rows.push_back({safe(item_label(*item.field)), "0", QString::number(s.missing), "-",
                            "-", "-", "-"});
            continue;
        }
        rows.push_back({safe(item_label(*item.field)), QString::number(s.n),
                        QString::number(s.missing),
                        number(*s.mean, 2) + (s.sd ? " (" + number(*s.sd, 2) + ")" : QString()),
                        item.mean_ci95 ? interval(*item.mean_ci95, 2) : QStringLiteral("-"),
                        number(*s.median, 1) + " [" + number(*s.lower_quartile, 1) + " - " +
                            number(*s.upper_quartile, 1) + "]",
                        QString("%1 (%2 %; %3)")
                            .arg(s.top2)
                            .arg(number(*s.top2_percent, 1), interval(item.top2_ci95, 0, 100))});
    }
    paper.table(safe(form.form->title) +
                    ": mean (sample SD) with Student's 95 % interval, median [quartiles, type 7], "
                    "top-2 answers (share; Wilson's 95 % interval, %). Missing counts unanswered "
                    "and not applicable.",
                {"item", "n", "missing", "mean (SD)", "95 % interval", "median [Q1 - Q3]", "top-2"},
                "lrrrrrr", rows);
}

void write_scales(Paper& paper, const FormNumbers& form) {
    std::vector<QStringList> rows;
    for (const NumberNumbers& each : form.numbers) {
        if (!each.field->derived) continue;
        QString alpha = "-";
        for (const AlphaNumbers& a : form.alphas) {
            if (a.scale != each.field) continue;
            alpha = a.alpha ? number(a.alpha->raw, 2) + " (" + interval(a.alpha->feldt_ci95, 2) +
                                  "), n " + QString::number(a.complete)
                            : "none: " + safe(a.problem);
        }
        rows.push_back(
            {safe(each.field->label), QString::number(each.values.size()),
             QString::number(each.missing),
             each.mean ? number(*each.mean, 2) + " (" + (each.sd ? number(*each.sd, 2) : "-") + ")"
                       : QStringLiteral("-"),
             each.mean_ci95 ? interval(*each.mean_ci95, 2) : QStringLiteral("-"), alpha});
    }
    if (rows.empty()) return;
    paper.table(safe(form.form->title) +
                    ": scale scores, mean (sample SD) with Student's 95 % interval; Cronbach's "
                    "alpha with Feldt's 95 % interval, complete cases, reverse-keyed items turned "
                    "round.",
                {"scale", "n", "missing", "mean (SD)", "95 % interval", "alpha"}, "lrrrrr", rows);
}

void write_comparison(Paper& paper, const StudyNumbers& numbers) {
    if (!numbers.comparison) return;
    const GroupComparison& c = *numbers.comparison;
    std::vector<QStringList> rows;
    for (const auto& each : c.rows)
        rows.push_back(
            {safe(item_label(*each.field)), number(each.delta.delta, 2),
             each.delta.separated ? QStringLiteral("none") : interval(each.delta.ci95, 2),
             p_text(each.p_exact), p_text(each.p_holm)});
    paper.table(safe(c.by->label) + " " + safe(c.group1) + " (n = " + QString::number(c.n1) +
                    ") against " + safe(c.group2) + " (n = " + QString::number(c.n2) +
                    "): Cliff's delta with DeLong's 95 % interval, exact two-sided Mann-Whitney p, "
                    "adjusted by Holm over " +
                    QString::number(c.rows.size()) +
                    " items. The least p that these group sizes allow without ties is " +
                    number(c.least_p, 4) + ".",
                {"item", "delta", "95 % interval", "p (exact)", "p (Holm)"}, "lrrrr", rows);
}

/// " (1 of them does not count)", so that no number here contradicts the analyses.
QString uncounted_part(const Dataset& data) {
    const int n = attempt_counts(data).uncounted();
    if (n == 0) return {};
    return QString(" (%1 of them %2 not count)").arg(n).arg(n == 1 ? "does" : "do");
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

}  // namespace

StudyReport read_study_report(db::Store& store, const std::string& study_id,
                              const std::string& language) {
    StudyReport report;
    report.data = study_dataset(store, study_id, {false, language});
    for (const Form& form : report.data.forms)
        if (is_questionnaire(form))
            report.instruments.push_back(questionnaire_of(store, form.id, form.version));
    report.everybody = store.studies().participants(study_id);
    report.steps = store.studies().steps(study_id);
    for (auto& version : store.definitions().list("study"))
        if (version.id == study_id) report.versions.push_back(std::move(version));
    report.record_events = store.records().events(study_id);
    report.record_states = store.records().states(study_id);
    report.corrections = store.records().corrections(study_id);
    report.ratings = store.reviews().ratings("osats");
    return report;
}

FlowNumbers flow_numbers(const StudyReport& report, const std::string& language) {
    FlowNumbers flow;
    flow.enrolled = static_cast<int>(report.everybody.size());
    for (const auto& each : report.everybody) {
        if (!each.withdrawal) continue;
        if (*each.withdrawal == db::WithdrawalMode::kKeep) ++flow.kept;
        if (*each.withdrawal == db::WithdrawalMode::kStop) ++flow.stopped;
        if (*each.withdrawal == db::WithdrawalMode::kErase) ++flow.erased;
    }
    std::set<std::string> answered;
    for (const auto& record : report.data.answers) answered.insert(record.participant);
    // An attempt that does not count is in no analysis.
    if (const Form* attempts = report.data.form("attempts"))
        for (const Row& row : attempts->rows)
            if (row.counts) answered.insert(row.participant);
    std::set<std::string> usable;
    for (const auto& each : report.data.participants) usable.insert(each.code);
    flow.analysed = static_cast<int>(
        std::count_if(answered.begin(), answered.end(),
                      [&](const std::string& code) { return usable.contains(code); }));
    flow.consented = -1;
    if (report.data.definition_json.empty()) return flow;
    const auto protocol =
        curriculum::load_study_text(report.data.definition_json, "study " + report.data.id);
    for (const auto& step : protocol.steps) {
        std::set<std::string> done;
        for (const auto& record : report.steps)
            if (record.step == step.id && record.state == db::StepState::kDone &&
                !record.superseded())
                done.insert(record.participant);
        const int n = static_cast<int>(done.size());
        if (step.kind == curriculum::StepKind::kConsent)
            flow.consented = n;
        else if (step.kind == curriculum::StepKind::kQuestionnaire ||
                 step.kind == curriculum::StepKind::kProcedure)
            flow.reached.emplace_back(step.title.en.empty() ? step.id : step.title.in(language), n);
    }
    return flow;
}

std::vector<Figure> study_figures(const StudyReport& report, const StudyNumbers& numbers,
                                  const ChartStyle& style) {
    std::vector<Figure> figures{flow_figure("flow", "Participants", flow_numbers(report), style)};
    for (const FormNumbers& form : numbers.forms) add_form_figures(figures, form, style);
    if (auto figure = comparison_figure(numbers, style)) figures.push_back(std::move(*figure));
    if (auto figure = performance_figure(report.data, style)) figures.push_back(std::move(*figure));
    return figures;
}

void write_study_pdf(const StudyReport& report, const std::string& path,
                     const std::function<void(const std::string&)>& progress) {
    const auto tell = [&](const std::string& what) {
        if (progress) progress(what);
    };
    tell("numbers");
    const StudyNumbers numbers = study_numbers(report.data, report.instruments);
    tell("figures");
    const std::vector<Figure> figures = study_figures(report, numbers);
    const auto draw = [&](Paper& paper, const std::string& beginning, const std::string& group) {
        for (const Figure& figure : figures)
            if (figure.group == group && figure.id.rfind(beginning, 0) == 0) paper.figure(figure);
    };
    QString footer = "Placode study " + QString::fromStdString(report.data.id);
    if (report.data.demonstration) footer += " - DEMONSTRATION, simulated data";
    Paper paper(path, QString::fromStdString(report.data.title),
                QString::fromStdString(report.data.software), footer);
    write_title(paper, report);
    write_methods(paper, report);
    paper.heading("Participants");
    draw(paper, "flow", "");
    write_deviations(paper, report);
    for (const FormNumbers& form : numbers.forms) {
        tell(form.form->title);
        paper.heading(QString::fromStdString(form.form->title));
        write_choices(paper, form);
        write_items(paper, form);
        for (const char* kind : {"likert_", "scales_", "strip_"}) {
            draw(paper, kind, form.form->name);
            if (std::string(kind) == "likert_") write_scales(paper, form);
        }
    }
    if (numbers.comparison) {
        paper.heading("Comparison of groups");
        write_comparison(paper, numbers);
        draw(paper, "forest_", "");
    }
    if (!report.data.attempts.empty()) {
        tell("performance");
        paper.heading("Performance");
        write_analyses(paper, report);
    }
    paper.heading("What this sample can carry");
    QString cautions;
    for (const std::string& each : numbers.cautions) cautions += "<li>" + safe(each) + "</li>";
    if (cautions.isEmpty()) cautions = "<li>No statistic shown here needs a caution.</li>";
    paper.html("<ul>" + cautions + "</ul>");
    write_data_care(paper, report);
    write_versions(paper, report);
    paper.finish();
}

std::vector<std::string> write_study_figures(const StudyReport& report, const std::string& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (!std::filesystem::is_directory(folder))
        throw ReportError("write figures to " + folder + ": cannot be made a folder");
    std::vector<std::string> paths;
    const StudyNumbers numbers = study_numbers(report.data, report.instruments);
    for (const Figure& figure : study_figures(report, numbers)) {
        save_figure(figure, folder, report.data.demonstration);
        for (const char* ending : {".svg", ".png", ".csv"})
            paths.push_back(folder + "/" + file_name(figure.id) + ending);
    }
    paths.push_back(folder + "/numbers.csv");
    save_file(paths.back(), study_numbers_csv(numbers));
    return paths;
}

}  // namespace placode::reports
