// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl import: a recording made elsewhere, or left over, becomes an attempt of a person.

#include <memory>

#include "assessment/scoring.h"
#include "curriculum/task.h"
#include "db/course_conduct.h"
#include "db/recording_file.h"
#include "db/standards.h"
#include "ui/cli/people.h"
#include "ui/cli/save_recording.h"

namespace placode::cli {

SavedAttempt save_recording(Session& session, int64_t user_id, const std::string& file,
                            const db::ExamContext& exam) {
    const sim::Recording recording = db::read_recording_file(file);
    const curriculum::Task task =
        curriculum::load_task_text(recording.header.task_json, file + " (its task)");
    db::AttemptResult result;
    result.header = recording.header;
    result.end = recording.end;
    result.events = recording.events;
    result.metrics = assessment::compute_metrics(recording);
    result.score = assessment::score_attempt(
        db::rubric_at(session.store(), task, recording.header.started_utc), result.metrics,
        recording);
    result.recording_file = file;
    result.exam = exam;
    return {session.store().attempts().save(user_id, result), result.score, result.end.duration_s};
}

namespace {

struct Options {
    std::string file, user, exam, proctor, certificate;
};

/// The exam that this recording is, checked against its task and seed.
db::ExamContext exam_of(Session& session, int64_t user_id, const Options& options) {
    const size_t slash = options.exam.find('/');
    if (slash == std::string::npos)
        throw InputError("--exam " + options.exam + ": expected COURSE/STAGE");
    try {
        const sim::RecordingHeader header = db::read_recording_file(options.file).header;
        db::ExamOrder order = db::prepare_exam(
            session.store(), user_id, options.exam.substr(0, slash), options.exam.substr(slash + 1),
            options.proctor, options.certificate, now_utc());
        if (header.task_id != order.task_id || header.seed != order.seed)
            throw InputError(options.file + ": found task " + header.task_id + ", seed " +
                             std::to_string(header.seed) + "; expected task " + order.task_id +
                             ", seed " + std::to_string(order.seed));
        return order.context;
    } catch (const db::StoreError& error) {
        if (error.kind() == db::StoreError::Kind::kRefused) throw InputError(error.what());
        throw;
    }
}

int import_recording(const Context& context, const Options& options) {
    Session session(context, Missing::kRefuse);
    const db::UserRecord user = session.find_user(options.user);
    const bool own = session.user() && session.user()->id == user.id;
    session.need(db::Action::kPerformAttempt, own ? db::Scope::kOwn : db::Scope::kOther);
    SavedAttempt saved;
    try {
        const db::ExamContext exam =
            options.exam.empty() ? db::ExamContext{} : exam_of(session, user.id, options);
        saved = save_recording(session, user.id, options.file, exam);
    } catch (const db::StoreError& error) {
        if (error.kind() == db::StoreError::Kind::kDamaged) throw InputError(error.what());
        throw;
    }
    session.store().audit().write(session.actor(), "attempt.import",
                                  "attempt " + std::to_string(saved.id), options.file);
    print(context, {{"attempt", saved.id}, {"user", user.login}, {"points", saved.score.points}},
          "saved as attempt " + std::to_string(saved.id) + " of " + user.login + ": " +
              fixed(saved.score.points, 1) + " points\n");
    return 0;
}

}  // namespace

void add_import_command(CLI::App& app, Context& context) {
    auto options = std::make_shared<Options>();
    CLI::App* command =
        app.add_subcommand("import", "Saves a recording file as an attempt of a person");
    command->add_option("FILE", options->file, "FILE.placode")->required();
    command->add_option("--user", options->user, "Login or number")->required();
    command->add_option("--exam", options->exam, "COURSE/STAGE: it is an exam of this course");
    command->add_option("--proctor", options->proctor, "Name of who was present at the exam");
    command->add_option("--certificate", options->certificate, "Of the haptic device");
    command->callback([&context, options] {
        context.run = [&context, options] { return import_recording(context, *options); };
    });
}

}  // namespace placode::cli
