// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl study key-make | key-set | key-list | key-passphrase: who is behind a code. Every
// opening is audited, without names.

#include <algorithm>
#include <filesystem>
#include <memory>

#include "db/participant_key.h"
#include "ui/cli/session.h"
#include "ui/cli/study_options.h"
#include "ui/cli/study_records.h"
#include "ui/cli/write_file.h"

namespace placode::cli {
namespace {

using db::ParticipantKey;

struct StudyKeyOptions {
    std::string study, file;
    db::PersonEntry entry;
};

constexpr const char* kVariable = "PLACODE_PASSPHRASE";

std::string path_of(const Context& context, const StudyKeyOptions& options) {
    return options.file.empty() ? db::default_key_path(store_url_of(context), options.study)
                                : options.file;
}

ParticipantKey opened(Session& session, const Context& context, const StudyKeyOptions& options,
                      const std::string& what) {
    const std::string path = path_of(context, options);
    const std::string phrase = read_password(kVariable, "Passphrase of " + path, false);
    ParticipantKey key = as_input([&] { return ParticipantKey::open(path, phrase); },
                                  db::StoreError::Kind::kNotFound);
    if (key.study_id() != options.study)
        throw InputError(path + ": belongs to the study " + key.study_id() + ", not to " +
                         options.study);
    db::keep_consent_key(session.store(), options.study, key.consent_keys().public_key);
    session.store().audit().write(
        session.actor(), "study.key." + what,
        options.study + (options.entry.code.empty() ? "" : " ") + options.entry.code, path);
    return key;
}

int make(const Context& context, const StudyKeyOptions& options) {
    Session session = coordinator(context);
    const std::string path = path_of(context, options);
    need_place("--file " + path + ": cannot be written", std::filesystem::path(path).parent_path());
    const std::string phrase = read_password(kVariable, "Passphrase for " + path, true);
    as_input([&] {
        const auto key = ParticipantKey::create(path, options.study, phrase);
        db::keep_consent_key(session.store(), options.study, key.consent_keys().public_key);
    });
    session.store().audit().write(session.actor(), "study.key.make", options.study, path);
    print(context, {{"study", options.study}, {"path", path}},
          "made " + path +
              "; keep a copy, and the passphrase elsewhere: without it the names are "
              "lost");
    return 0;
}

int set(const Context& context, const StudyKeyOptions& options) {
    Session session = coordinator(context);
    const auto all = session.store().studies().participants(options.study);
    if (std::none_of(all.begin(), all.end(),
                     [&](const auto& each) { return each.code == options.entry.code; }))
        throw InputError("study " + options.study + ": has no participant " + options.entry.code);
    ParticipantKey key = opened(session, context, options, "name");
    as_input([&] { key.put(options.entry); });
    print(context, {{"participant", options.entry.code}, {"entries", key.entries().size()}},
          "the name of " + options.entry.code + " is kept");
    return 0;
}

int list(const Context& context, const StudyKeyOptions& options) {
    Session session = coordinator(context);
    const ParticipantKey key = opened(session, context, options, "open");
    Json json = Json::array();
    std::vector<std::vector<std::string>> rows{{"code", "name", "contact", "remark"}};
    for (const auto& each : key.entries()) {
        json.push_back({{"code", each.code},
                        {"name", each.name},
                        {"contact", each.contact},
                        {"remark", each.remark}});
        rows.push_back({each.code, each.name, each.contact, each.remark});
    }
    print(context, json, table(rows));
    return 0;
}

int change(const Context& context, const StudyKeyOptions& options) {
    Session session = coordinator(context);
    ParticipantKey key = opened(session, context, options, "passphrase");
    const std::string phrase = read_password("PLACODE_NEW_PASSPHRASE", "New passphrase", true);
    as_input([&] { key.change_passphrase(phrase); });
    print(context, {{"study", options.study}, {"changed", true}}, "the passphrase is changed");
    return 0;
}

}  // namespace

void add_study_key_commands(CLI::App& study, Context& context) {
    auto options = std::make_shared<StudyKeyOptions>();
    const auto add = [&](const char* name, const char* text,
                         int (*work)(const Context&, const StudyKeyOptions&)) {
        CLI::App* command = study.add_subcommand(name, text);
        command->add_option("STUDY", options->study, "Study id")->required();
        command->add_option("--file", options->file,
                            "Of the key (default: keys/STUDY.placode-key beside the store)");
        command->callback([&context, options, work] {
            context.run = [&context, options, work] { return work(context, *options); };
        });
        return command;
    };
    add("key-make", "An encrypted file for the names behind the codes; asks for a passphrase",
        make);
    CLI::App* set_command = add("key-set", "Keeps the name behind a code", set);
    set_command->add_option("CODE", options->entry.code, "Of the participant, e.g. P001-C")
        ->required();
    set_command->add_option("--name", options->entry.name, "Of the person behind the code")
        ->required();
    set_command->add_option("--contact", options->entry.contact, "Telephone or address");
    set_command->add_option("--remark", options->entry.remark, "Whatever helps to find the person");
    add("key-list", "Shows the names; asks for the passphrase", list);
    add("key-passphrase", "Gives the key another passphrase", change);
}

}  // namespace placode::cli
