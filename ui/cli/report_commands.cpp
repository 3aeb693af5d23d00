// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl report attempt

#include <charconv>
#include <memory>

#include "reports/export.h"
#include "reports/report.h"
#include "ui/cli/session.h"

namespace placode::cli {
namespace {

using db::Action;
using db::Scope;

struct Options {
    std::string out, id;
};

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
    const auto recording = reports::recordings_of(session.store())(id);
    if (!recording)
        throw InputError("report attempt: found " + options.id +
                         ", which has no recording; expected an attempt with one");
    reports::write_attempt_pdf(
        attempt, *recording,
        session.store().attempts(attempt.record.user_id, attempt.record.task_id), options.out);
    session.store().audit(session.actor(), "report.pdf", "attempt " + options.id, options.out);
    print(context, {{"attempt", id}, {"path", options.out}}, "wrote " + options.out);
    return 0;
}

}  // namespace

void add_report_commands(CLI::App& app, Context& context) {
    auto options = std::make_shared<Options>();
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
