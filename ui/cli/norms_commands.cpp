// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl norms ...: bands of groups and their exchange between centres.

#include <memory>

#include "db/norm_bands.h"
#include "db/signature.h"
#include "reports/export.h"
#include "sim/core/counted.h"
#include "ui/cli/centre_passphrase.h"
#include "ui/cli/norms_key_commands.h"
#include "ui/cli/norms_quality.h"
#include "ui/cli/norms_standard.h"
#include "ui/cli/people.h"
#include "ui/cli/write_file.h"

namespace placode::cli {
namespace {

using db::Action;
using db::Scope;

struct NormsOptions {
    std::string task, file, centre, level = "expert", passphrase_file;
    std::vector<std::string> levels;
    int64_t id = 0;
    int least = curriculum::kLeastNormGroup;
    bool trust = false;
};

Session educator(const Context& context) {
    Session session(context, Missing::kRefuse);
    session.need(Action::kSetStandards, Scope::kOther);
    return session;
}

/// "expert=Consultants" to people by level.
std::map<std::string, std::vector<int64_t>> people_of(Session& session,
                                                      const std::vector<std::string>& levels) {
    std::map<std::string, std::vector<int64_t>> people;
    for (const std::string& each : levels) {
        const size_t sign = each.find('=');
        if (sign == std::string::npos || sign == 0)
            throw InputError("--level " + each +
                             ": expected LEVEL=GROUP, such as expert=Consultants");
        people[each.substr(0, sign)] = find_group(session, each.substr(sign + 1)).members;
    }
    return people;
}

std::string band_table(const curriculum::NormGroup& group) {
    std::vector<std::vector<std::string>> rows{
        {"metric", "n", "mean", "SD", "of", "quartile 1", "median", "quartile 3"}};
    for (const auto& metric : group.metrics) {
        const auto& b = metric.band;
        rows.push_back({metric.id, std::to_string(b.n), fixed(b.mean, 3), fixed(b.sd, 3),
                        b.log ? "ln" : "value", fixed(b.q25, 2), fixed(b.q50, 2), fixed(b.q75, 2)});
    }
    return group.level + ": " + sim::counted(group.persons, "person") + ", " +
           sim::counted(group.attempts, "attempt") + "\n" + table(rows);
}

std::string pack_text(const db::NormPackRecord& record) {
    const auto& pack = record.pack;
    std::string text = "norm pack " + std::to_string(record.id) + ": " + pack.task_id +
                       " version " + std::to_string(pack.task_version) + ", rubric " +
                       pack.rubric_id + " " + std::to_string(pack.rubric_version) +
                       ", metric set " + std::to_string(pack.metric_set_version) + ", " +
                       pack.centre + ", key " + db::fingerprint(record.norms.public_key) +
                       (record.in_use ? ", IN USE" : "") +
                       (pack.demonstration ? ", DEMONSTRATION data" : "") + "\n";
    for (const auto& group : pack.groups) text += band_table(group);
    return text;
}

Json pack_json(const db::NormPackRecord& record) {
    Json json{{"id", record.id},
              {"in_use", record.in_use},
              {"fingerprint", db::fingerprint(record.norms.public_key)},
              {"added_by", record.added_by},
              {"added_utc", record.added_utc}};
    json["norms"] = Json::parse(record.norms.content);
    return json;
}

db::NormPackRecord find_pack(Session& session, int64_t id) {
    for (auto& record : session.store().norms().list({}))
        if (record.id == id) return std::move(record);
    throw InputError("there is no norm pack " + std::to_string(id) +
                     "; `placodectl norms list` shows them");
}

int make(const Context& context, const NormsOptions& options) {
    Session session = educator(context);
    const auto levels =
        db::level_attempts(session.store(), options.task, people_of(session, options.levels));
    const auto pack =
        as_input([&] { return db::make_norms(levels, options.centre, now_utc(), options.least); });
    // Before anybody is asked for a passphrase.
    if (options.centre.empty() && !session.store().norms().centre_key())
        throw InputError(
            "the centre has no name yet; give it with the first norm pack: --centre NAME");
    const db::Secret phrase = passphrase_to_sign(session, options.passphrase_file);
    const int64_t id =
        as_input([&] { return db::keep_own_norms(session.store(), pack, phrase.text()); },
                 db::StoreError::Kind::kNotFound);
    const auto record = find_pack(session, id);
    print(context, pack_json(record), pack_text(record));
    return 0;
}

int list(const Context& context, const NormsOptions& options) {
    Session session(context, Missing::kRefuse);
    Json json = Json::array();
    std::vector<std::vector<std::string>> rows{
        {"id", "task", "centre", "groups", "made (UTC)", "in use", "key"}};
    for (const auto& record : session.store().norms().list(options.task)) {
        std::string groups;
        for (const auto& group : record.pack.groups)
            groups +=
                (groups.empty() ? "" : ", ") + group.level + " " + std::to_string(group.persons);
        json.push_back(pack_json(record));
        rows.push_back({std::to_string(record.id), record.pack.task_id, record.pack.centre, groups,
                        record.pack.made_utc, record.in_use ? "yes" : "",
                        db::fingerprint(record.norms.public_key)});
    }
    print(context, json, rows.size() == 1 ? "no norm packs" : table(rows));
    return 0;
}

int show(const Context& context, const NormsOptions& options) {
    Session session(context, Missing::kRefuse);
    const auto record = find_pack(session, options.id);
    print(context, pack_json(record), pack_text(record));
    return 0;
}

int export_pack(const Context& context, const NormsOptions& options) {
    need_file_place("--out", options.file);
    Session session = educator(context);
    const auto record = find_pack(session, options.id);
    // Before the file: nothing leaves without its entry.
    session.store().audit().write(session.actor(), "norms.export",
                                  "norm pack " + std::to_string(options.id), options.file);
    reports::save_private_file(options.file, curriculum::signed_norms_text(record.norms));
    print(context, {{"id", options.id}, {"path", options.file}},
          "wrote " + options.file + ", signed by " + record.pack.centre + " (" +
              db::fingerprint(record.norms.public_key) + ")");
    return 0;
}

int import_pack(const Context& context, const NormsOptions& options) {
    Session session = educator(context);
    const auto norms =
        curriculum::load_signed_norms(curriculum::read_norm_file(options.file), options.file);
    const auto pack = curriculum::load_norm_pack(norms.content, options.file + " (its content)");
    if (!db::signature_is_right(norms.content, norms.signature, norms.public_key))
        throw InputError(options.file +
                         ": /signature: wrong: the pack was changed after it was signed; ask the "
                         "centre for it again");
    const std::string mark = db::fingerprint(norms.public_key);
    if (!session.store().norms().trusted_centres().contains(norms.public_key)) {
        if (!options.trust)
            throw InputError(options.file + ": \"" + pack.centre + "\" with the key " + mark +
                             " is not trusted here; compare the key with the centre by telephone, "
                             "then give --trust");
        session.store().norms().trust_centre(norms.public_key, pack.centre);
    }
    const int64_t id = as_input([&] { return session.store().norms().save(norms); },
                                db::StoreError::Kind::kNotFound);
    print(context, {{"id", id}, {"centre", pack.centre}, {"fingerprint", mark}},
          "norm pack " + std::to_string(id) + " of " + pack.centre + " (" + mark + ")");
    return 0;
}

int apply(const Context& context, const NormsOptions& options) {
    Session session = educator(context);
    const auto record = find_pack(session, options.id);
    session.store().norms().use(options.id);
    print(context, {{"id", options.id}, {"task", record.pack.task_id}, {"in_use", true}},
          "attempts of " + record.pack.task_id + " are now shown against norm pack " +
              std::to_string(options.id) + " of " + record.pack.centre);
    return 0;
}

int compare(const Context& context, const NormsOptions& options) {
    Session session(context, Missing::kRefuse);
    const db::AttemptDetail attempt = session.store().attempts().detail(options.id);
    session.need_for(Action::kViewAttempts, attempt.record.user_id);
    const auto norms = db::norms_in_use(session.store(), attempt.record.task_id);
    if (!norms)
        throw InputError("no norm pack is in use for " + attempt.record.task_id +
                         "; `placodectl norms apply ID` chooses one");
    const curriculum::NormGroup* group = norms->pack.group(options.level);
    if (group == nullptr)
        throw InputError("--level " + options.level + ": norm pack " + std::to_string(norms->id) +
                         " has no such level");
    Json json{{"attempt", options.id},
              {"norm_pack", norms->id},
              {"level", options.level},
              {"same_versions",
               attempt.record.metric_set_version == norms->pack.metric_set_version &&
                   attempt.record.preprocessing_version == norms->pack.preprocessing_version},
              {"metrics", Json::array()}};
    std::vector<std::vector<std::string>> rows{{"metric", "value", "band median", "z", "0-100"}};
    for (const auto& one : db::compare_with_band({attempt.record, attempt.metrics}, *group)) {
        json["metrics"].push_back({{"id", one.metric},
                                   {"value", one.value},
                                   {"band_q25", one.band.q25},
                                   {"band_q50", one.band.q50},
                                   {"band_q75", one.band.q75},
                                   {"z", optional_number(one.z)},
                                   {"score", optional_number(one.score)}});
        rows.push_back({one.metric, fixed(one.value, 2), fixed(one.band.q50, 2),
                        optional_text(one.z, 2), optional_text(one.score, 0)});
    }
    print(context, json,
          (json["same_versions"] == true ? "" : "attention: other versions of metrics\n") +
              table(rows));
    return 0;
}

}  // namespace

void add_norms_commands(CLI::App& app, Context& context) {
    auto options = std::make_shared<NormsOptions>();
    CLI::App* norms =
        app.add_subcommand("norms", "Bands of groups, pass marks, quality of metrics");
    norms->require_subcommand(1);
    const auto command = [&](const char* name, const char* help, auto work) {
        CLI::App* added = norms->add_subcommand(name, help);
        added->callback([&context, options, work] {
            context.run = [&context, options, work] { return work(context, *options); };
        });
        return added;
    };
    CLI::App* made = command("make", "Makes and signs the bands of groups in a task", make);
    made->add_option("TASK", options->task, "Task id")->required();
    made->add_option("--level", options->levels, "LEVEL=GROUP; may be given again")->required();
    made->add_option("--centre", options->centre, "Name of this centre, for the first pack");
    made->add_option("--least", options->least, "Least persons a group")
        ->check(CLI::Range(curriculum::kLeastNormGroup, 1000))
        ->capture_default_str();
    made->add_option("--passphrase-file", options->passphrase_file,
                     "The passphrase of the centre's key in the first line of FILE (mode 600); "
                     "else typed")
        ->type_name("FILE");
    add_norms_key_commands(*norms, context);
    command("list", "Lists norm packs", list)->add_option("--task", options->task, "Task id");
    command("show", "One norm pack", show)
        ->add_option("ID", options->id, "Number of the pack, see `norms list`")
        ->required();
    CLI::App* out = command("export", "Writes a signed norm pack", export_pack);
    out->add_option("ID", options->id, "Number of the pack, see `norms list`")->required();
    out->add_option("--out", options->file, "FILE.json")->required();
    CLI::App* in = command("import", "Takes a norm pack of another centre", import_pack);
    in->add_option("FILE", options->file, "FILE.json that `norms export` wrote")->required();
    in->add_flag("--trust", options->trust, "Trust this centre's key from now on");
    command("apply", "Shows a task's attempts against this pack", apply)
        ->add_option("ID", options->id, "Number of the pack, see `norms list`")
        ->required();
    CLI::App* compared = command("compare", "An attempt against the bands in use", compare);
    compared->add_option("ATTEMPT", options->id, "Number")->required();
    compared->add_option("--level", options->level, "Of the band, such as expert")
        ->capture_default_str();
    add_norms_standard_command(*norms, context);
    add_norms_quality_command(*norms, context);
}

}  // namespace placode::cli
