// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl norms key show | seal | passphrase | renew | export | import: the key with which the
// centre signs its norm packs.

#include <filesystem>
#include <memory>

#include "db/signature.h"
#include "ui/cli/centre_passphrase.h"
#include "ui/cli/norms_key_commands.h"
#include "ui/cli/write_file.h"
#include "ui/lti/secret_file.h"

namespace placode::cli {
namespace {

struct KeyOptions {
    std::string passphrase_file, new_passphrase_file, file;
    bool replace = false;
};

db::CentreKey need_key(Session& session) {
    const auto key = session.store().norms().centre_key();
    if (!key)
        throw InputError(session.store().url() +
                         ": the centre has no key yet; `placodectl norms make` makes it with the "
                         "first norm pack");
    return *key;
}

Json key_json(const db::CentreKey& key) {
    return {{"centre", key.centre},
            {"fingerprint", db::fingerprint(key.public_key)},
            {"public_key", key.public_key},
            {"made_utc", key.made_utc},
            {"sealed", key.sealed}};
}

/// What was done, and the key as it is now.
int key_done(const Context& context, Session& session, const std::string& text) {
    const db::CentreKey key = need_key(session);
    print(context, key_json(key),
          "the key " + db::fingerprint(key.public_key) + " of " + key.centre + text);
    return 0;
}

int show_key(const Context& context, const KeyOptions&) {
    Session session(context, Missing::kRefuse);
    const bool sealed = need_key(session).sealed;
    return key_done(context, session,
                    sealed
                        ? " is sealed under a passphrase"
                        : " lies in clear; `placodectl norms key seal` puts it under a passphrase");
}

int seal_clear_key(const Context& context, const KeyOptions& options) {
    Session session(context, Missing::kRefuse);
    if (need_key(session).sealed)
        throw InputError(
            "the centre's key is sealed already; `placodectl norms key passphrase` changes its "
            "passphrase");
    const db::Secret phrase = new_centre_passphrase(options.passphrase_file);
    as_input([&] { session.store().norms().seal_centre_key(phrase.text()); });
    return key_done(
        context, session,
        " is sealed. Keep the passphrase elsewhere. Backups from before hold the key in "
        "clear: make a new backup and remove them, or make a new key with `placodectl "
        "norms key renew`");
}

int change_passphrase(const Context& context, const KeyOptions& options) {
    Session session(context, Missing::kRefuse);
    (void)need_key(session);
    const db::Secret old_one = centre_passphrase(options.passphrase_file, "the one until now");
    const db::Secret new_one = new_centre_passphrase(options.new_passphrase_file);
    as_input([&] { session.store().norms().change_key_passphrase(old_one.text(), new_one.text()); },
             db::StoreError::Kind::kNotFound);
    return key_done(context, session,
                    " has the new passphrase. Backups from before open with the old one");
}

int renew_key(const Context& context, const KeyOptions& options) {
    Session session(context, Missing::kRefuse);
    (void)need_key(session);
    const db::Secret phrase = new_centre_passphrase(options.new_passphrase_file);
    as_input([&] { session.store().norms().renew_centre_key(phrase.text()); });
    return key_done(context, session,
                    " is new. What the old one signed stays right and is shown as before. Other "
                    "centres take new packs once they trust this key: read it to them over the "
                    "telephone");
}

int export_key(const Context& context, const KeyOptions& options) {
    need_new_file("--out", options.file);
    Session session(context, Missing::kRefuse);
    (void)need_key(session);
    const std::string text = as_input([&] { return session.store().norms().exported_centre_key(); },
                                      db::StoreError::Kind::kNotFound);
    // Before the file: nothing leaves without its entry.
    session.store().audit().write(session.actor(), "norms.key.export",
                                  db::fingerprint(need_key(session).public_key), options.file);
    lti::replace_text(options.file, text);
    return key_done(context, session,
                    " is in " + options.file + ", sealed; it opens with the same passphrase");
}

int import_key(const Context& context, const KeyOptions& options) {
    Session session(context, Missing::kRefuse);
    const std::string text = lti::read_text(options.file);
    const db::Secret phrase = centre_passphrase(options.passphrase_file, "which is in the file");
    const auto take = [&] {
        as_input(
            [&] { session.store().norms().take_centre_key(text, phrase.text(), options.replace); });
    };
    as_input(take, db::StoreError::Kind::kDamaged);  // The file is, not the store.
    return key_done(context, session, " signs the norm packs of this store from now on");
}

}  // namespace

void add_norms_key_commands(CLI::App& norms, Context& context) {
    auto options = std::make_shared<KeyOptions>();
    CLI::App* key = norms.add_subcommand("key", "The key with which this centre signs its packs");
    key->require_subcommand(1);
    const auto command = [&](const char* name, const char* help,
                             int (*work)(const Context&, const KeyOptions&)) {
        CLI::App* added = key->add_subcommand(name, help);
        added->callback([&context, options, work] {
            context.run = [&context, options, work] { return work(context, *options); };
        });
        return added;
    };
    const auto add_file = [](CLI::App* to, const char* name, std::string& file, const char* what) {
        to->add_option(name, file,
                       std::string(what) + " in the first line of FILE (mode 600); else typed")
            ->type_name("FILE");
    };
    command("show", "Whose key, its fingerprint, and whether it is sealed", show_key);
    CLI::App* sealing = command(
        "seal", "Puts a key that lies in clear under a passphrase (asked for)", seal_clear_key);
    add_file(sealing, "--passphrase-file", options->passphrase_file, "The new passphrase");
    CLI::App* changing =
        command("passphrase", "Gives the key another passphrase", change_passphrase);
    add_file(changing, "--passphrase-file", options->passphrase_file, "The passphrase until now");
    add_file(changing, "--new-passphrase-file", options->new_passphrase_file, "The new passphrase");
    CLI::App* renewing = command(
        "renew", "Makes a new key, for a passphrase that is lost or a key that got out", renew_key);
    add_file(renewing, "--new-passphrase-file", options->new_passphrase_file, "Its passphrase");
    command("export", "Writes the sealed key, for another store of the centre", export_key)
        ->add_option("--out", options->file, "New file")
        ->required();
    CLI::App* taking = command("import", "Takes a key that `norms key export` wrote", import_key);
    taking->add_option("FILE", options->file, "That `norms key export` wrote")->required();
    add_file(taking, "--passphrase-file", options->passphrase_file, "Its passphrase");
    taking->add_flag("--replace", options->replace, "Also where there is another key");
}

}  // namespace placode::cli
