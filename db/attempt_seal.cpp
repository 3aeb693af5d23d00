// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/attempt_seal.h"

#include <charconv>
#include <fstream>
#include <iterator>

#include "db/attempt_counting.h"
#include "db/evidence.h"
#include "db/packing.h"
#include "db/recording_file.h"
#include "db/recording_seal.h"
#include "db/station.h"
#include "db/store.h"
#include "sim/core/hidden_letters.h"
#include "sim/core/number_text.h"

namespace placode::db {
namespace {

constexpr std::string_view kSignature = "signature: ", kStation = "stated by station: ";

std::string read_file(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    if (!in)
        throw StoreError(StoreError::Kind::kNotFound,
                         "seal the attempt: " + path + " cannot be read");
    return {std::istreambuf_iterator<char>(in), {}};
}

std::string hexadecimal(uint64_t value) {
    char text[17];
    const auto [end, error] = std::to_chars(text, text + sizeof text, value, 16);
    return error == std::errc() ? std::string(text, end) : std::string();
}

/// A value stays on its line, whatever its reader takes for the end of one (U+2028, U+0085): what a
/// name or a remark holds must not look like another statement.
class Page {
 public:
    void line(std::string_view name, const std::string& value) {
        text_.append(name).append(": ");
        text_.append(value.empty() ? "-" : sim::without_hidden_letters(value)).append("\n");
    }
    void line(std::string_view name, int64_t value) { line(name, std::to_string(value)); }
    [[nodiscard]] std::string take() { return std::move(text_); }

 private:
    std::string text_ = std::string(kSealTitle) + "\n";
};

void state_whose(Page& page, const AttemptRecord& attempt) {
    page.line("attempt", attempt.id);
    page.line(attempt.study.study.empty() ? "person" : "participant", attempt.user_name);
    page.line("study", attempt.study.study);
    page.line("exam", attempt.exam.course_id.empty()
                          ? std::string()
                          : attempt.exam.course_id + ", version " +
                                std::to_string(attempt.exam.course_version) + ", stage " +
                                attempt.exam.stage_id);
    page.line("proctor", attempt.exam.proctor);
}

void state_what(Page& page, Store& store, const AttemptRecord& attempt) {
    const auto task = store.definitions().find("task", attempt.task_id, attempt.task_version);
    page.line("task", attempt.task_id + ", version " + std::to_string(attempt.task_version));
    page.line("task checksum", task ? checksum_hex(task->json) : std::string());
    page.line("case", std::to_string(attempt.seed));
    page.line("device", attempt.device);
    page.line("begun", attempt.started_utc);
    page.line("seconds", sim::fixed_text(attempt.duration_s, 3));
    page.line("demonstration", attempt.demonstration ? "yes" : "no");
}

void state_score(Page& page, const AttemptRecord& attempt) {
    page.line("points of 100", sim::fixed_text(attempt.points, 2));
    page.line("verdict", assessment::verdict_name(attempt.verdict));
    page.line("rubric", attempt.rubric_id + ", version " + std::to_string(attempt.rubric_version));
    page.line("metric set", attempt.metric_set_version);
    page.line("counts", counts(attempt) ? "yes" : "no");
    page.line("why it is void", attempt.void_reason);
    page.line("simulated again", replay_name(attempt.replay));
}

void state_recording(Page& page, const AttemptRecord& attempt, const std::string& file) {
    static constexpr const char* kSigned[]{"not signed", "signature is wrong", "signed"};
    const RecordingSeal seal = recording_seal(file);
    page.line("program", attempt.build);
    page.line("recording checksum", checksum_hex(read_file(file)));
    page.line("recording", kSigned[static_cast<size_t>(seal.signature)]);
    page.line("recorded by station", seal.station);
    page.line("last state", hexadecimal(recording_summary(file).end.final_hash));
}

/// The lines that were signed, and the signature; empty when the text is no seal.
std::pair<std::string_view, std::string_view> parts_of(std::string_view text) {
    const size_t at = text.rfind('\n' + std::string(kSignature));
    if (!text.starts_with(std::string(kSealTitle) + "\n") || at == std::string_view::npos ||
        !text.ends_with('\n'))
        return {};
    const std::string_view last = text.substr(at + 1);
    return {text.substr(0, at + 1),
            last.substr(kSignature.size(), last.size() - kSignature.size() - 1)};
}

}  // namespace

std::string attempt_seal(Store& store, int64_t attempt_id, const std::string& recording_file,
                         const std::string& now_utc) {
    const AttemptRecord attempt = store.attempts().detail(attempt_id).record;
    Station station;
    if (station.public_key().empty())
        throw StoreError(StoreError::Kind::kUnavailable,
                         "seal the attempt: this computer has no key, and none can be made; set "
                         "PLACODE_STATION_KEY to a file that can be written");
    const Audit::Standing standing = store.audit().standing_of(station.public_key());
    // What it states would be its own word, and not the centre's.
    if (standing == Audit::Standing::kUnknown)
        throw StoreError(
            StoreError::Kind::kRefused, "seal the attempt: ",
            Said::that("this computer (%1) is not one that the store trusts; at one that is, an "
                       "administrator trusts it: `placodectl station trust`")
                .with(fingerprint(station.public_key())));
    Page page;
    state_whose(page, attempt);
    state_what(page, store, attempt);
    state_score(page, attempt);
    state_recording(page, attempt, recording_file);
    page.line("stated", now_utc);
    page.line("station registered", standing == Audit::Standing::kRegistered
                                        ? "yes"
                                        : "no, it is the computer that has the file of the store");
    page.line("stated by station", station.public_key());
    const std::string text = page.take();
    return text + std::string(kSignature) + station.sign(text) + "\n";
}

bool seal_is_right(const std::string& text) {
    const auto [lines, signature] = parts_of(text);
    const size_t at = lines.rfind('\n' + std::string(kStation));
    if (at == std::string_view::npos) return false;
    const std::string_view last = lines.substr(at + 1);
    const std::string station(last.substr(kStation.size(), last.size() - kStation.size() - 1));
    return signature_is_right(std::string(lines), std::string(signature), station);
}

}  // namespace placode::db
