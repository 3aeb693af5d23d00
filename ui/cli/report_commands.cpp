// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl export csv | report attempt

#include <unistd.h>

#include <charconv>
#include <filesystem>
#include <map>
#include <memory>

#include "curriculum/questionnaire.h"
#include "db/recording_file.h"
#include "reports/report.h"
#include "ui/cli/session.h"

namespace placode::cli {
namespace {

namespace fs = std::filesystem;
using db::Action;
using db::Scope;

struct Options {
    std::string study, user, out, id;
};

/// A file name from what people typed: letters, digits, '-', '_' and '.' stay.
std::string file_name(const std::string& text) {
    std::string name = text;
    for (char& c : name)
        if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-' && c != '_' && c != '.')
            c = '_';
    return name.empty() || name[0] == '.' ? "_" + name : name;
}

std::string make_folder(const std::string& out) {
    std::error_code error;
    fs::create_directories(out, error);
    if (!fs::is_directory(out))
        throw InputError("--out " + out + ": cannot be made a folder; choose another place");
    return out;
}

int export_study(const Context& context, const Options& options) {
    Session session(context, Missing::kRefuse);
    session.need(Action::kExportStudy, Scope::kOther);
    std::map<std::string, std::vector<db::AnswerRecord>> by_questionnaire;
    for (auto& record : session.store().answers(options.study))
        by_questionnaire[record.questionnaire_id].push_back(std::move(record));
    if (by_questionnaire.empty())
        throw InputError("--study: found \"" + options.study + "\", which has no answers in " +
                         session.store().url() + "; expected the id of a study");
    const std::string folder = make_folder(options.out);
    Json json{{"study", options.study}, {"files", Json::array()}};
    std::string text;
    for (const auto& [id, answers] : by_questionnaire) {
        const std::string path =
            folder + "/" + file_name(options.study) + "_" + file_name(id) + ".csv";
        reports::write_answers_csv(curriculum::load_questionnaire(id), answers, path);
        json["files"].push_back({{"path", path}, {"rows", answers.size()}});
        text += path + ": " + std::to_string(answers.size()) + " rows\n";
    }
    session.store().audit(session.actor(), "export.csv", "study " + options.study,
                          std::to_string(by_questionnaire.size()) + " files");
    print(context, json, text);
    return 0;
}

int export_user(const Context& context, const Options& options) {
    Session session(context, Missing::kRefuse);
    const db::UserRecord user = session.find_user(options.user);
    const bool own = session.user() && session.user()->id == user.id;
    session.need(Action::kViewAttempts, own ? Scope::kOwn : Scope::kOther);
    std::vector<db::AttemptDetail> attempts;
    for (const auto& record : session.store().attempts(user.id))
        attempts.push_back(session.store().attempt(record.id));
    const std::string path =
        make_folder(options.out) + "/attempts_" + file_name(user.login) + ".csv";
    reports::write_attempts_csv(attempts, path);
    session.store().audit(session.actor(), "export.csv", "user " + std::to_string(user.id),
                          std::to_string(attempts.size()) + " attempts");
    print(context, {{"user", user.login}, {"path", path}, {"rows", attempts.size()}},
          path + ": " + std::to_string(attempts.size()) + " rows");
    return 0;
}

int export_csv(const Context& context, const Options& options) {
    if (options.study.empty() == options.user.empty())
        throw InputError("export csv: expected either --study ID or --user ID");
    return options.study.empty() ? export_user(context, options) : export_study(context, options);
}

/// Recording of an attempt, through a file that is gone afterwards.
sim::Recording recording_of(Session& session, int64_t id) {
    std::string name = (fs::temp_directory_path() / "placode-report-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr)
        throw std::runtime_error("cannot make a temporary folder in " +
                                 fs::temp_directory_path().string());
    const std::string file = name + "/attempt.placode";
    try {
        session.store().extract_recording(id, file);
        auto recording = db::recover_recording_file(file).recording;
        fs::remove_all(name);
        return recording;
    } catch (...) {
        fs::remove_all(name);
        throw;
    }
}

int report_attempt(const Context& context, const Options& options) {
    int64_t id = 0;
    const char* end = options.id.data() + options.id.size();
    const auto [rest, error] = std::from_chars(options.id.data(), end, id);
    if (error != std::errc{} || rest != end)
        throw InputError("report attempt: found \"" + options.id +
                         "\"; expected the number of an attempt, see `placodectl attempts`");
    Session session(context, Missing::kRefuse);
    const db::AttemptDetail attempt = session.store().attempt(id);
    const bool own = session.user() && session.user()->id == attempt.record.user_id;
    session.need(Action::kViewAttempts, own ? Scope::kOwn : Scope::kOther);
    const sim::Recording recording = recording_of(session, id);
    reports::write_attempt_pdf(
        attempt, recording,
        session.store().attempts(attempt.record.user_id, attempt.record.task_id), options.out);
    session.store().audit(session.actor(), "report.pdf", "attempt " + options.id, options.out);
    print(context, {{"attempt", id}, {"path", options.out}}, "wrote " + options.out);
    return 0;
}

}  // namespace

void add_report_commands(CLI::App& app, Context& context) {
    auto options = std::make_shared<Options>();
    CLI::App* exports = app.add_subcommand("export", "Data for other programs");
    exports->require_subcommand(1);
    CLI::App* csv = exports->add_subcommand(
        "csv", "Answers of a study (one row a participant) or attempts of a user (one row each)");
    csv->add_option("--study", options->study, "Study id");
    csv->add_option("--user", options->user, "Login or number");
    csv->add_option("--out", options->out, "Folder")->default_val(".");
    csv->callback([&context, options] {
        context.run = [&context, options] { return export_csv(context, *options); };
    });

    CLI::App* report = app.add_subcommand("report", "PDF for people");
    report->require_subcommand(1);
    CLI::App* attempt = report->add_subcommand("attempt", "One attempt on paper");
    attempt->add_option("ID", options->id, "Number, see `placodectl attempts`")->required();
    attempt->add_option("--out", options->out, "FILE.pdf")->required();
    attempt->callback([&context, options] {
        context.run = [&context, options] { return report_attempt(context, *options); };
    });
}

}  // namespace placode::cli
