// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl study construct | retest | learning | raters: what the page Results shows.

#include <memory>

#include "reports/study_analysis.h"
#include "sim/core/counted.h"
#include "ui/cli/session.h"
#include "ui/cli/study_records.h"
#include "ui/cli/write_file.h"

namespace placode::cli {
namespace {

struct StudyAnalysisOptions {
    std::string study, by, out, form = "osats";
};

using Work = reports::Analysis (*)(const reports::StudyReport&, Session&,
                                   const StudyAnalysisOptions&);

reports::Analysis construct(const reports::StudyReport& report, Session&,
                            const StudyAnalysisOptions& options) {
    const auto possible = reports::possible_groupings(report.data);
    if (options.by.empty() || possible.empty())
        return reports::construct_validity(report, options.by);
    std::string known;
    for (const auto& each : possible) {
        if (each.id == options.by) return reports::construct_validity(report, options.by);
        known += (known.empty() ? "" : ", ") + each.id;
    }
    throw InputError("--by: found \"" + options.by + "\"; expected one of: " + known);
}
reports::Analysis retest(const reports::StudyReport& report, Session&,
                         const StudyAnalysisOptions&) {
    return reports::test_retest(report);
}
reports::Analysis learning(const reports::StudyReport& report, Session&,
                           const StudyAnalysisOptions&) {
    return reports::learning_curves(report);
}
reports::Analysis raters(const reports::StudyReport& report, Session& session,
                         const StudyAnalysisOptions& options) {
    return reports::rater_agreement(report, session.store().reviews().ratings(options.form),
                                    curriculum::load_questionnaire(options.form));
}

int analyse(const Context& context, const StudyAnalysisOptions& options, Work work) {
    need_writable_folder("--out", options.out);
    Session session(context, Missing::kRefuse);
    session.need(db::Action::kExportStudy, db::Scope::kOther);
    if (session.store().studies().participants(options.study).empty())
        throw InputError("study: found \"" + options.study + "\", which has no participants in " +
                         session.store().url());
    const auto report = reports::read_study_report(session.store(), options.study);
    const auto analysis = work(report, session, options);
    if (!analysis.problem.empty()) throw InputError(analysis.title + ": " + analysis.problem);
    Json json{{"study", options.study},
              {"analysis", analysis.id},
              {"method", analysis.method},
              {"caution", analysis.caution},
              {"demonstration", report.data.demonstration},
              {"rows", Json::array()}};
    std::vector<std::vector<std::string>> rows{analysis.head};
    for (const auto& row : analysis.rows) {
        Json entry;
        std::vector<std::string> cells;
        for (size_t c = 0; c < row.size(); ++c) {
            entry[analysis.head[c]] = row[c].value ? Json(*row[c].value) : Json(row[c].text);
            cells.push_back(row[c].text);
        }
        json["rows"].push_back(entry);
        rows.push_back(cells);
    }
    std::string text = analysis.title + (report.data.demonstration ? " (DEMONSTRATION)" : "") +
                       "\n" + table(rows) + "\n" + analysis.method;
    if (!analysis.caution.empty()) text += "\n" + analysis.caution;
    if (!options.out.empty()) {
        // Before the first file: nothing leaves without its entry.
        session.store().audit().write(session.actor(), "report." + analysis.id,
                                      "study " + options.study, options.out);
        json["files"] = reports::write_analysis(analysis, options.out, report.data.demonstration);
        text += "\nwrote " + sim::counted(json["files"].size(), "file") + " to " + options.out;
    }
    print(context, json, text);
    return 0;
}

}  // namespace

void add_study_analysis_commands(CLI::App& study, Context& context) {
    auto options = std::make_shared<StudyAnalysisOptions>();
    const auto add = [&](const char* name, const char* text, Work work) {
        CLI::App* command = study.add_subcommand(name, text);
        command->add_option("STUDY", options->study, "Study id")->required();
        command->add_option("--out", options->out,
                            "Folder for the table as CSV and the figures as SVG, PNG and CSV");
        command->callback([&context, options, work] {
            context.run = [&context, options, work] { return analyse(context, *options, work); };
        });
        return command;
    };
    add("construct", "Do levels of experience differ? All metrics, effect sizes, Holm", construct)
        ->add_option("--by", options->by, "FORM.FIELD of the levels, e.g. demographics.gender");
    add("retest", "Test-retest reliability of every metric", retest);
    add("learning", "Learning curves and CUSUM of everybody", learning);
    add("raters", "Agreement of raters on the study's attempts", raters)
        ->add_option("--form", options->form, "Questionnaire of the raters")
        ->capture_default_str();
}

}  // namespace placode::cli
