// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl dataset: attempts as demonstrations for machines that learn. Those of people only
// where they agreed to it.

#include <algorithm>
#include <filesystem>
#include <memory>

#include "batches/plan.h"
#include "db/attempt_counting.h"
#include "db/consent.h"
#include "db/evidence.h"
#include "db/recording_file.h"
#include "environment/judge.h"
#include "reports/demonstrations.h"
#include "reports/report.h"
#include "sim/core/counted.h"
#include "sim/core/near_word.h"
#include "ui/cli/batch.h"
#include "ui/cli/dataset.h"
#include "ui/cli/progress.h"
#include "ui/cli/scratch_folder.h"
#include "ui/cli/session.h"
#include "ui/cli/write_file.h"
#include "ui/seed_range.h"
#include "ui/version.h"

namespace placode::cli {
namespace {

namespace fs = std::filesystem;

struct DatasetOptions {
    std::string out, recordings, study, statement = "data", licence;
    std::vector<int> split{80, 10, 10};
    int step_ms = 20;
    uint64_t seed = 1;
};

struct Chosen {
    std::vector<reports::Demonstration> demonstrations;
    std::string origin, consent;
    int left_out = 0;     ///< Of people who did not agree.
    int not_counted = 0;  ///< Void, or not verified yet.
};

/// Points as of now, by the program's own task where it has it, else by the recording's.
reports::Demonstration judged(const std::string& file) {
    const sim::Recording recording = db::read_recording_file(file);
    if (recording.header.stage > 0)
        throw InputError(file + ": began at stage " + std::to_string(recording.header.stage) +
                         " of its task; expected attempts from the beginning");
    const auto published = db::shipped_task(recording.header.task_id);
    const auto task =
        published ? *published : curriculum::load_task_text(recording.header.task_json, file);
    const auto judgement = environment::judge_finished(task.rubric, recording);
    reports::Demonstration one;
    one.recording_file = file;
    one.task = recording.header.task_id;
    one.points = judgement.score.points;
    one.passed = judgement.score.verdict == assessment::Verdict::kPassed;
    one.of_a_person = !recording.header.demonstration;
    one.operator_name = one.of_a_person ? "person" : recording.header.device;
    one.person = "lesion " + std::to_string(recording.header.seed);
    return one;
}

/// Before each attempt is scored.
void tell_scored(size_t done, size_t of) {
    if (CancelOn::requested()) {
        clear_progress();
        throw std::runtime_error("dataset: stopped; nothing was written");
    }
    show_progress("scoring " + std::to_string(done + 1) + " of " + std::to_string(of));
}

/// Of scripts and policies. A folder says nothing about what a person agreed to.
Chosen from_folder(const DatasetOptions& options) {
    Chosen chosen;
    chosen.origin = "The attempts were made by programs.";
    const auto files = of_batch([&] { return batches::recordings_in(options.recordings); });
    for (const fs::path& file : files) {
        tell_scored(chosen.demonstrations.size(), files.size());
        reports::Demonstration one = judged(file.string());
        if (one.of_a_person)
            throw InputError(file.string() +
                             ": is of a person, and a folder says nothing about consent; expected "
                             "recordings of scripts and policies, or --study");
        chosen.demonstrations.push_back(std::move(one));
    }
    return chosen;
}

void need_statement(Session& session, const DatasetOptions& options) {
    const auto ids = session.store().studies().ids();
    if (std::find(ids.begin(), ids.end(), options.study) == ids.end())
        throw InputError("--study: \"" + options.study + "\" is not in " + session.store().url() +
                         "; see `placodectl study list`" + sim::did_you_mean(options.study, ids));
}

/// Attempts that count, of participants who agreed to the statement.
Chosen from_study(Session& session, const DatasetOptions& options, const fs::path& workplace) {
    session.need(db::Action::kExportStudy, db::Scope::kOther);
    need_statement(session, options);
    Chosen chosen;
    chosen.origin = "The attempts were made in a study.";
    chosen.consent = "Each of these people agreed to the statement \"" + options.statement +
                     "\" of the study's consent and has not withdrawn it.";
    std::map<std::string, bool> agreed;
    for (const auto& one : session.store().studies().participants(options.study))
        agreed[one.code] =
            db::has_agreed(session.store(), options.study, one.code, options.statement);
    const auto steps = session.store().studies().steps(options.study);
    for (size_t i = 0; i < steps.size(); ++i) {
        const db::StepRecord& step = steps[i];
        tell_scored(i, steps.size());
        if (step.attempt_id == 0 || step.superseded() || step.state != db::StepState::kDone)
            continue;
        if (!agreed[step.participant]) {
            ++chosen.left_out;
            continue;
        }
        if (!db::counts(session.store().attempts().detail(step.attempt_id).record)) {
            ++chosen.not_counted;
            continue;
        }
        const fs::path file = workplace / (std::to_string(step.attempt_id) + ".placode");
        try {
            session.store().attempts().extract_recording(step.attempt_id, file.string());
        } catch (const db::StoreError& error) {
            if (error.kind() != db::StoreError::Kind::kNotFound) throw;
            continue;  // It was made without a recording.
        }
        chosen.demonstrations.push_back(judged(file.string()));
        if (chosen.demonstrations.back().of_a_person)
            chosen.demonstrations.back().person = step.participant;
    }
    return chosen;
}

/// As write_demonstrations() will want it, before all the scoring.
void need_empty_folder(const std::string& out) {
    need_writable_folder("--out", out);
    if (!fs::is_directory(out)) return;
    for (const auto& entry : fs::directory_iterator(out))
        if (entry.path().filename() != "recordings" || !entry.is_directory() ||
            !fs::is_empty(entry.path()))
            throw InputError("--out " + out +
                             ": cannot be used for a data set; expected an empty folder, or one "
                             "that is not there and can be made");
}

std::array<int, 3> split_of(const DatasetOptions& options) {
    const auto& parts = options.split;
    if (parts.size() != 3 || parts[0] < 1 || std::min(parts[1], parts[2]) < 0 ||
        parts[0] + parts[1] + parts[2] != 100)
        throw InputError(
            "--split: expected three shares of together 100 % as in 80,10,10, the "
            "first at least 1");
    return {parts[0], parts[1], parts[2]};
}

/// What was typed, before anything is read. @throws InputError
reports::DemonstrationOptions how_of(const DatasetOptions& options) {
    if (options.recordings.empty() == options.study.empty())
        throw InputError("dataset: expected one of --recordings FOLDER and --study ID");
    if (options.step_ms % 10 != 0)
        throw InputError("--step " + std::to_string(options.step_ms) +
                         ": expected a multiple of 10 ms: samples are recorded as often");
    reports::DemonstrationOptions how;
    how.split = split_of(options);
    need_empty_folder(options.out);
    how.seed = options.seed;
    how.step_s = options.step_ms / 1000.0;
    if (!options.licence.empty()) how.licence = options.licence;
    how.software = std::string("Placode ") + ui::version_text();
    how.reader_file = (curriculum::data_folder() / "datasets" / "read_dataset.py").string();
    return how;
}

/// @throws InputError saying why there is none.
void need_any(const Chosen& chosen, const DatasetOptions& options) {
    if (!chosen.demonstrations.empty()) return;
    throw InputError(
        "dataset: no attempt may be given away: " + sim::counted(chosen.left_out, "attempt") +
        " of people who did not agree to \"" + options.statement + "\"" +
        (chosen.not_counted > 0 ? ", " + sim::counted(chosen.not_counted, "attempt") +
                                      " that do not count, or not before `placodectl verify`"
                                : ""));
}

int dataset(const Context& context, const DatasetOptions& options) {
    reports::DemonstrationOptions how = how_of(options);
    const CancelOn cancel{SIGINT, SIGTERM};
    const ScratchFolder workplace;
    std::unique_ptr<Session> session;
    if (!options.study.empty()) session = std::make_unique<Session>(context, Missing::kRefuse);
    const Chosen chosen =
        session ? from_study(*session, options, workplace.path()) : from_folder(options);
    clear_progress();
    need_any(chosen, options);
    how.origin = chosen.origin;
    how.consent = chosen.consent;
    how.left_out = chosen.left_out;
    // Before the first file: nothing leaves without its entry.
    if (session)
        session->store().audit().write(session->actor(), "export.dataset", "study " + options.study,
                                       sim::counted(chosen.demonstrations.size(), "attempt") +
                                           ", agreed to \"" + options.statement +
                                           "\"; left out: " + std::to_string(chosen.left_out));
    const auto files = reports::write_demonstrations(
        chosen.demonstrations, how, options.out, [](size_t done, size_t of) {
            show_progress("attempt " + std::to_string(done + 1) + " of " + std::to_string(of));
            return !CancelOn::requested();
        });
    clear_progress();
    print(context,
          {{"folder", options.out},
           {"demonstrations", chosen.demonstrations.size()},
           {"left_out", chosen.left_out},
           {"not_counted", chosen.not_counted},
           {"read_back", "identical"},
           {"files", files}},
          options.out + ": " + sim::counted(chosen.demonstrations.size(), "demonstration") +
              (chosen.left_out > 0
                   ? ", " + std::to_string(chosen.left_out) + " left out for want of consent"
                   : "") +
              (chosen.not_counted > 0
                   ? ", " + std::to_string(chosen.not_counted) +
                         " left out because they do not count, or not before `placodectl verify`"
                   : "") +
              "; read back and compared");
    return 0;
}

}  // namespace

void add_dataset_command(CLI::App& app, Context& context) {
    auto options = std::make_shared<DatasetOptions>();
    CLI::App* command = app.add_subcommand(
        "dataset", "Attempts as demonstrations for machines that learn: HDF5, robomimic's layout");
    command->add_option("--out", options->out, "Folder, empty or new")->required();
    command->add_option("--recordings", options->recordings,
                        "Folder with recordings of scripts and policies");
    command->add_option("--study", options->study,
                        "Attempts of a study, of those who agreed to --statement");
    command
        ->add_option("--statement", options->statement,
                     "Statement of the consent that allows giving recordings away")
        ->capture_default_str();
    command->add_option("--split", options->split, "Train, validation, test: shares of people [%]")
        ->delimiter(',')
        ->expected(3)
        ->default_str("80,10,10");
    command->add_option("--split-seed", options->seed, "Who is in which part")
        ->transform(ui::seed_range())
        ->capture_default_str();
    command->add_option("--step", options->step_ms, "Between two actions [ms]")
        ->check(CLI::Range(10, 1000))
        ->capture_default_str();
    command->add_option("--licence", options->licence, "Under which the data are given away");
    command->callback([&context, options] {
        context.run = [&context, options] { return dataset(context, *options); };
    });
}

}  // namespace placode::cli
