// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl export FORMAT: the data of a study or of a person for other programs.

#include <filesystem>
#include <memory>

#include "reports/export.h"
#include "reports/report.h"
#include "sim/core/counted.h"
#include "sim/core/near_word.h"
#include "ui/cli/session.h"
#include "ui/cli/write_file.h"

namespace placode::cli {
namespace {

using db::Action;
using db::Scope;

struct ExportOptions {
    std::string format, study, user, out = ".", language = "en", identifying, base;
};

/// Fields that name a person leave only for somebody who may see names, with a reason that the
/// audit trail keeps.
void need_identifying(const Session& session, const ExportOptions& options, bool own) {
    constexpr size_t kShortestReason = 10;
    if (options.identifying.empty()) return;
    if (options.identifying.size() < kShortestReason)
        throw InputError("--identifying: found \"" + options.identifying +
                         "\"; expected the reason in at least 10 characters");
    if (!own) session.need(Action::kViewPersonalData, Scope::kOther);
}

reports::Dataset study_data(Session& session, const ExportOptions& options) {
    session.need(Action::kExportStudy, Scope::kOther);
    need_identifying(session, options, false);
    if (session.store().studies().participants(options.study).empty())
        throw InputError("--study: \"" + options.study + "\" has no participants in " +
                         session.store().url() +
                         "; expected the id of a study, see `placodectl study list`" +
                         sim::did_you_mean(options.study, session.store().studies().ids()));
    return reports::study_dataset(session.store(), options.study,
                                  {!options.identifying.empty(), options.language, options.base});
}

reports::Dataset user_data(Session& session, const ExportOptions& options) {
    const db::UserRecord user = session.find_user(options.user);
    const bool own = session.user() && session.user()->id == user.id;
    session.need(Action::kViewAttempts, own ? Scope::kOwn : Scope::kOther);
    need_identifying(session, options, own);
    return reports::user_dataset(session.store(), user,
                                 {!options.identifying.empty(), options.language, options.base});
}

int run_export(const Context& context, const ExportOptions& options) {
    try {
        (void)reports::checked_base_uri(options.base);
    } catch (const reports::ReportError& error) {
        throw InputError(std::string("--fhir-base: ") + error.what());
    }
    if (options.study.empty() == options.user.empty())
        throw InputError("export " + options.format + ": found " +
                         (options.study.empty() ? "neither" : "both") +
                         " of --study and --user; expected one of them");
    need_writable_folder("--out", options.out);
    Session session(context, Missing::kRefuse);
    const reports::ExportSource source{
        options.study.empty() ? user_data(session, options) : study_data(session, options),
        reports::recordings_of(session.store())};
    if (options.format == "motion-bids" && source.data.attempts.empty())
        throw InputError("export motion-bids: " + source.data.id +
                         " has no attempts; expected at least one");
    const std::string object =
        options.study.empty() ? "user " + options.user : "study " + options.study;
    // Before the first file: nothing leaves without its entry.
    session.store().audit().write(
        session.actor(), "export." + options.format, object,
        std::filesystem::absolute(options.out).lexically_normal().string() +
            (options.identifying.empty() ? ""
                                         : "; WITH IDENTIFYING FIELDS: " + options.identifying));
    const auto files = reports::export_dataset(source, options.format, options.out);
    size_t rows = 0;
    for (const auto& form : source.data.forms) rows += form.rows.size();
    Json json{{"format", options.format},
              {"object", object},
              {"rows", rows},
              {"demonstration", source.data.demonstration},
              {"participants_left_out", source.data.participants_left_out},
              {"read_back", "identical"},
              {"files", Json::array()}};
    std::string text;
    for (const auto& file : files) {
        json["files"].push_back({{"path", options.out + "/" + file.path},
                                 {"bytes", file.bytes},
                                 {"sha256", file.sha256}});
        text += options.out + "/" + file.path + "\n";
    }
    text += sim::counted(files.size(), "file") + ", read back and compared with the store" +
            (source.data.demonstration ? "; holds DEMONSTRATION data" : "");
    print(context, json, text);
    return 0;
}

}  // namespace

void add_export_command(CLI::App& app, Context& context) {
    auto options = std::make_shared<ExportOptions>();
    CLI::App* command = app.add_subcommand(
        "export",
        "Data for other programs: a study's answers and attempts, or a person's attempts");
    std::vector<std::string> names;
    std::string titles;
    for (const auto& format : reports::export_formats()) {
        names.emplace_back(format.name);
        titles += std::string(titles.empty() ? "" : "; ") + format.name + ": " + format.title;
    }
    command->add_option("FORMAT", options->format, titles)->required()->check(CLI::IsMember(names));
    command->add_option("--study", options->study, "Study id");
    command->add_option("--user", options->user, "Login or number");
    command->add_option("--out", options->out, "Folder")->capture_default_str();
    command->add_option("--language", options->language, "Of labels")
        ->check(CLI::IsMember({"en", "pl"}))
        ->capture_default_str();
    command
        ->add_option(
            "--fhir-base", options->base,
            "FHIR and xAPI: https address that the centre owns, below which names of forms, "
            "codes and pseudonyms stand (default: URNs made from the store)")
        ->type_name("URI");
    command->add_option("--identifying", options->identifying,
                        "REASON: with fields that name a person; audited");
    command->callback([&context, options] {
        context.run = [&context, options] { return run_export(context, *options); };
    });
}

}  // namespace placode::cli
