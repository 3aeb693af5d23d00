// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl import: a recording made elsewhere, or left over, becomes an attempt of a person.

#include <cstdlib>
#include <memory>

#include "assessment/soundness.h"
#include "db/course_conduct.h"
#include "db/evidence.h"
#include "db/recording_file.h"
#include "ui/cli/people.h"
#include "ui/cli/save_recording.h"
#include "ui/cli/verify.h"

namespace placode::cli {

SavedAttempt save_recording(db::Store& store, int64_t user_id, const std::string& file,
                            const db::ExamContext& exam) {
    const sim::Recording recording = db::read_recording_file(file);
    if (const auto problem = assessment::unsound(recording))
        throw db::StoreError(db::StoreError::Kind::kDamaged,
                             file + ": the recording cannot be scored: " + problem->english());
    if (const auto known = store.attempts().find_recording(file))
        throw db::StoreError(
            db::StoreError::Kind::kConflict,
            file + ": the store has this recording already, as attempt " + std::to_string(*known));
    db::AttemptResult result = db::judged(store, recording);
    result.recording_file = file;
    result.exam = exam;
    db::publish_task_on_first_use(store, recording.header.task_id, recording.header.task_version);
    const int64_t id = store.attempts().save(user_id, result);
    return {id, store.attempts().detail(id), result.end.duration_s};
}

namespace {

struct ImportOptions {
    std::string file, user, exam, proctor, certificate;
};

/// Nobody names a proctor who knows nothing of it: that proctor's password is asked for, in
/// PLACODE_PROCTOR_PASSWORD, also of whoever owns the store's file. Without one the exam would be
/// the word of that owner or of the person examined, and void.
std::string proctor_of(Session& session, int64_t user_id, const ImportOptions& options) {
    if (options.proctor.empty())
        throw InputError(
            "--exam: somebody else than the person examined vouches for an exam: name the proctor "
            "(--proctor LOGIN)");
    const db::UserRecord proctor = db::find_proctor(session.store(), options.proctor, user_id);
    if (session.user() && session.user()->id == proctor.id) return proctor.login;
    const char* const password = std::getenv("PLACODE_PROCTOR_PASSWORD");
    const db::SignIn found = session.store().accounts().confirm(
        proctor.login, password == nullptr ? std::string() : std::string(password));
    if (found.outcome != db::SignInOutcome::kOk)
        throw InputError("--proctor " + options.proctor +
                         ": the proctor confirms with the own password, in "
                         "PLACODE_PROCTOR_PASSWORD; " +
                         (password == nullptr ? "it is missing" : "it is wrong"));
    return proctor.login;
}

/// The exam that this recording is, checked against its task and seed.
db::ExamContext exam_of(Session& session, int64_t user_id, const ImportOptions& options) {
    const size_t slash = options.exam.find('/');
    if (slash == std::string::npos)
        throw InputError("--exam " + options.exam + ": expected COURSE/STAGE");
    try {
        const sim::RecordingHeader header = db::read_recording_file(options.file).header;
        // What was not at stake when it was made is chosen among many.
        if (header.mode != "exam")
            throw InputError(options.file + ": it was recorded as " + header.mode +
                             "; an exam is recorded as one (placode-sim --exam)");
        db::ExamOrder order = db::prepare_exam(
            session.store(), user_id, options.exam.substr(0, slash), options.exam.substr(slash + 1),
            proctor_of(session, user_id, options), options.certificate, now_utc());
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

int import_recording(const Context& context, const ImportOptions& options) {
    Session session(context, Missing::kRefuse);
    const db::UserRecord user = session.find_user(options.user);
    const bool own = session.user() && session.user()->id == user.id;
    session.need(db::Action::kPerformAttempt, own ? db::Scope::kOwn : db::Scope::kOther);
    SavedAttempt saved;
    try {
        const db::ExamContext exam =
            options.exam.empty() ? db::ExamContext{} : exam_of(session, user.id, options);
        saved = save_recording(session.store(), user.id, options.file, exam);
    } catch (const db::StoreError& error) {
        if (error.kind() == db::StoreError::Kind::kDamaged ||
            error.kind() == db::StoreError::Kind::kConflict)
            throw InputError(error.what());
        throw;
    }
    db::AttemptRecord record = saved.attempt.record;
    if (record.replay == db::ReplayState::kWaiting) {
        (void)verify(session, saved.id);
        record = session.store().attempts().detail(saved.id).record;
    }
    session.store().audit().write(session.actor(), "attempt.import",
                                  "attempt " + std::to_string(saved.id), "");
    std::string text = "saved as attempt " + std::to_string(saved.id) + " of " + user.login + ": " +
                       fixed(record.points, 1) + " points\n";
    if (!record.void_reason.empty()) text += "it counts for nothing. " + record.void_reason + "\n";
    if (record.replay == db::ReplayState::kWaiting)
        text += "it counts once it was simulated again here: placodectl verify\n";
    print(context,
          {{"attempt", saved.id},
           {"user", user.login},
           {"points", record.points},
           {"void_reason", record.void_reason},
           {"replay", db::replay_name(record.replay)}},
          text);
    return 0;
}

}  // namespace

void add_import_command(CLI::App& app, Context& context) {
    auto options = std::make_shared<ImportOptions>();
    CLI::App* command =
        app.add_subcommand("import", "Saves a recording file as an attempt of a person");
    command->add_option("FILE", options->file, "FILE.placode")->required();
    command->add_option("--user", options->user, "Login or number")->required();
    command->add_option("--exam", options->exam, "COURSE/STAGE: it is an exam of this course");
    command->add_option("--proctor", options->proctor, "Login of who was present at the exam");
    command->add_option("--certificate", options->certificate, "Of the haptic device");
    command->callback([&context, options] {
        context.run = [&context, options] { return import_recording(context, *options); };
    });
}

}  // namespace placode::cli
