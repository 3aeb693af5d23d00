// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl report attempt | seal | trainee | cohort | certificate | study. The entry in the audit
// trail comes before the first file: nothing leaves without it.

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <filesystem>
#include <iostream>
#include <memory>

#include "db/attempt_counting.h"
#include "db/attempt_seal.h"
#include "reports/cohort_report.h"
#include "reports/export.h"
#include "reports/report.h"
#include "reports/study_report.h"
#include "sim/core/counted.h"
#include "sim/core/near_word.h"
#include "ui/cli/people.h"
#include "ui/cli/scratch_folder.h"
#include "ui/cli/write_file.h"

namespace placode::cli {
namespace {

using db::Action;
using db::Scope;

struct ReportOptions {
    std::string out, id, figures, user, recording, language = "en";
};

/// The attempt of that number, which the person may see. @param command for what is wrong with it.
db::AttemptDetail need_attempt(Session& session, const std::string& command,
                               const std::string& number) {
    int64_t id = 0;
    const char* end = number.data() + number.size();
    const auto [rest, error] = std::from_chars(number.data(), end, id);
    if (error != std::errc{} || rest != end)
        throw InputError(command + ": found \"" + number +
                         "\"; expected the number of an attempt, see `placodectl attempts`");
    db::AttemptDetail attempt = session.store().attempts().detail(id);
    const bool own = session.user() && session.user()->id == attempt.record.user_id;
    const bool study = !attempt.record.study.study.empty() &&
                       session.may(Action::kRunQuestionnaire, Scope::kOther);
    if (!study) session.need(Action::kViewAttempts, own ? Scope::kOwn : Scope::kOther);
    return attempt;
}

/// What is written is a PDF, whatever it is called. @throws InputError
void need_pdf_name(const std::string& path) {
    std::string end = std::filesystem::path(path).extension().string();
    std::transform(end.begin(), end.end(), end.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (end == ".pdf") return;
    throw InputError("--out: found \"" + path +
                     "\"; expected FILE.pdf (figures as SVG, PNG and CSV: `report study "
                     "--figures FOLDER`)");
}

int report_seal(const Context& context, const ReportOptions& options) {
    need_file_place("--out", options.out);
    // One that is there may be the only one of its attempt.
    need_new_file("--recording", options.recording);
    Session session(context, Missing::kRefuse);
    const int64_t id = need_attempt(session, "report seal", options.id).record.id;
    const ScratchFolder scratch;
    const std::string file = scratch.file("attempt.placode");
    session.store().attempts().extract_recording(id, file);
    const std::string seal = db::attempt_seal(session.store(), id, file, now_utc());
    session.store().audit().write(session.actor(), "report.seal", "attempt " + options.id,
                                  options.out);
    if (!options.recording.empty())
        session.store().attempts().extract_recording(id, options.recording);
    reports::save_private_file(options.out, seal);
    print(context, {{"attempt", id}, {"path", options.out}, {"recording", options.recording}},
          seal + "wrote " + options.out +
              (options.recording.empty() ? std::string() : " and " + options.recording));
    return 0;
}

int report_attempt(const Context& context, const ReportOptions& options) {
    need_pdf_name(options.out);
    need_file_place("--out", options.out);
    Session session(context, Missing::kRefuse);
    const db::AttemptDetail attempt = need_attempt(session, "report attempt", options.id);
    const int64_t id = attempt.record.id;
    const auto recording = reports::recordings_of(session.store())(id);
    if (!recording)
        throw InputError("report attempt: found " + options.id +
                         ", which has no recording; expected an attempt with one");
    const auto history = db::other_attempts(session.store(), attempt.record);
    const auto head = reports::report_head(session.store(), attempt.record);
    session.store().audit().write(session.actor(), "report.pdf", "attempt " + options.id,
                                  options.out);
    reports::write_attempt_pdf(attempt, *recording, history, options.out, head);
    print(context, {{"attempt", id}, {"path", options.out}}, "wrote " + options.out);
    return 0;
}

/// "x.pdf" to "x_figures".
std::string figures_folder(const ReportOptions& options) {
    if (!options.figures.empty()) return options.figures;
    const std::string& out = options.out;
    return (out.ends_with(".pdf") ? out.substr(0, out.size() - 4) : out) + "_figures";
}

int report_study(const Context& context, const ReportOptions& options) {
    need_pdf_name(options.out);
    need_file_place("--out", options.out);
    need_writable_folder("--figures", figures_folder(options));
    Session session(context, Missing::kRefuse);
    session.need(Action::kExportStudy, Scope::kOther);
    if (session.store().studies().participants(options.id).empty())
        throw InputError("report study: \"" + options.id + "\" has no participants in " +
                         session.store().url() +
                         "; expected the id of a study, see `placodectl study list`" +
                         sim::did_you_mean(options.id, session.store().studies().ids()));
    const auto report = reports::read_study_report(session.store(), options.id, options.language);
    session.store().audit().write(session.actor(), "report.study", "study " + options.id,
                                  options.out);
    const reports::ExportPace pace{{}, [](const reports::ExportPart& part) {
                                       if (isatty(STDERR_FILENO) != 0)
                                           std::cerr << "making: " << part.name << '\n';
                                   }};
    reports::write_study_pdf(report, options.out, pace);
    const auto files = reports::write_study_figures(report, figures_folder(options));
    print(context,
          {{"study", options.id},
           {"path", options.out},
           {"figures", files},
           {"participants", report.data.participants.size()},
           {"participants_left_out", report.data.participants_left_out},
           {"demonstration", report.data.demonstration}},
          "wrote " + options.out + " and " + sim::counted(files.size(), "file") + " in " +
              figures_folder(options) +
              (report.data.demonstration ? "; holds DEMONSTRATION data" : ""));
    return 0;
}

int report_cohort(const Context& context, const ReportOptions& options) {
    Session session(context, Missing::kRefuse);
    session.need(Action::kViewAttempts, Scope::kOther);
    const int64_t group = options.id == "all" ? 0 : find_group(session, options.id).id;
    const auto report = reports::read_cohort_report(session.store(), group, now_utc());
    session.store().audit().write(session.actor(), "report.cohort",
                                  "group " + std::to_string(group), options.out);
    reports::write_cohort_pdf(report, options.out);
    Json json{{"group", report.group},
              {"path", options.out},
              {"demonstration", report.demonstration},
              {"people", Json::array()}};
    for (const auto& one : report.people)
        json["people"].push_back(
            {{"user_id", one.standing.user_id},
             {"task", one.standing.task_id},
             {"attempts", one.standing.attempts},
             {"best_points", one.standing.best_points},
             {"recent_points", one.standing_now.recent},
             {"standing", assessment::standing_name(one.standing_now.standing)}});
    print(context, json,
          "wrote " + options.out + ": " + sim::counted(report.people.size(), "row") +
              " (person and task)");
    return 0;
}

int report_trainee(const Context& context, const ReportOptions& options) {
    Session session(context, Missing::kRefuse);
    const db::UserRecord user = session.find_user(options.id);
    session.need_for(Action::kViewAttempts, user.id);
    const auto report = reports::read_trainee_report(session.store(), user, now_utc());
    session.store().audit().write(session.actor(), "report.trainee",
                                  "user " + std::to_string(user.id), options.out);
    reports::write_trainee_pdf(report, options.out);
    print(context,
          {{"user_id", user.id},
           {"path", options.out},
           {"courses", report.courses.size()},
           {"attempts", report.attempts.size()}},
          "wrote " + options.out);
    return 0;
}

int report_certificate(const Context& context, const ReportOptions& options) {
    Session session(context, Missing::kRefuse);
    const int64_t id = named_or_self(session, options.user);
    session.need_for(Action::kIssueCertificate, id);
    const auto certificate = [&] {
        try {
            return db::issue_certificate(session.store(), id, options.id, now_utc());
        } catch (const db::StoreError& error) {
            if (error.kind() == db::StoreError::Kind::kRefused) throw InputError(error.what());
            throw;
        }
    }();
    const auto course = db::find_course(session.store(), options.id, certificate.course_version);
    session.store().audit().write(session.actor(), "report.certificate",
                                  "user " + std::to_string(id), options.out);
    reports::write_certificate_pdf(certificate, *session.store().accounts().find(id), course,
                                   options.out);
    print(context,
          {{"user_id", id},
           {"course", options.id},
           {"version", certificate.course_version},
           {"code", certificate.code},
           {"mastered_utc", certificate.mastered_utc},
           {"path", options.out}},
          "wrote " + options.out + ", code " + certificate.code);
    return 0;
}

}  // namespace

void add_report_commands(CLI::App& app, Context& context) {
    auto options = std::make_shared<ReportOptions>();
    CLI::App* report = app.add_subcommand("report", "PDF for people");
    report->require_subcommand(1);
    CLI::App* attempt = report->add_subcommand("attempt", "One attempt on paper");
    attempt->add_option("ID", options->id, "Number, see `placodectl attempts`")->required();
    attempt->add_option("--out", options->out, "FILE.pdf")->required();
    attempt->callback([&context, options] {
        context.run = [&context, options] { return report_attempt(context, *options); };
    });
    CLI::App* seal = report->add_subcommand(
        "seal",
        "What this centre states about an attempt, signed; examples/check_seal.py checks it");
    seal->add_option("ID", options->id, "Number, see `placodectl attempts`")->required();
    seal->add_option("--out", options->out, "FILE.txt")->required();
    seal->add_option(
        "--recording", options->recording,
        "Writes the recording as well, a new FILE.placode, so that both can be checked");
    seal->callback([&context, options] {
        context.run = [&context, options] { return report_seal(context, *options); };
    });
    const auto command = [&](const char* name, const char* help, const char* id, auto work) {
        CLI::App* added = report->add_subcommand(name, help);
        added->add_option("ID", options->id, id)->required();
        added->add_option("--out", options->out, "FILE.pdf")->required();
        added->callback([&context, options, work] {
            context.run = [&context, options, work] {
                need_file_place("--out", options->out);
                return work(context, *options);
            };
        });
        return added;
    };
    command("cohort", "A group: who is stuck, who regressed, curves, everybody",
            "Name or number of a group, or \"all\"", report_cohort);
    command("trainee", "One person: courses, curves, history", "Login or number", report_trainee);
    command("certificate", "The certificate of a mastered course", "Id of the course",
            report_certificate)
        ->add_option("--user", options->user, "Login or number (default: whoever acts)");
    CLI::App* study = report->add_subcommand(
        "study", "Methods, flow, tables and figures of a study, ready to attach to a paper");
    study->add_option("ID", options->id, "Study id")->required();
    study->add_option("--out", options->out, "FILE.pdf")->required();
    study->add_option("--figures", options->figures,
                      "Folder for every figure as SVG, PNG and CSV (default: FILE_figures)");
    study->add_option("--language", options->language, "Of the questions")
        ->check(CLI::IsMember({"en", "pl"}))
        ->capture_default_str();
    study->callback([&context, options] {
        context.run = [&context, options] { return report_study(context, *options); };
    });
}

}  // namespace placode::cli
