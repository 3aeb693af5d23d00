// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/study_deviations.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "db/study_conduct.h"
#include "db/study_records.h"

namespace placode::db {
namespace {

constexpr std::array<const char*, kDeviationKinds> kNames{
    "paused",       "slow_machine", "ended_early", "interrupted", "repeated",
    "other_device", "skipped",      "note",        "nothing_done"};

using AttemptsById = std::map<int64_t, AttemptDetail>;  ///< Those that are not gone.

/// What one participant's records tell, in the order of the records.
class Reader {
 public:
    Reader(const AttemptsById& attempts, const ParticipantRecord& participant,
           const curriculum::StudyProtocol* protocol, std::vector<Deviation>& found)
        : attempts_(attempts), protocol_(protocol), found_(found), device_(participant.device) {}

    void read(const StepRecord& record) {
        const auto* step = protocol_ != nullptr ? protocol_->step(record.step) : nullptr;
        if (record.state == StepState::kSkipped && (step == nullptr || step->required))
            add(DeviationKind::kSkipped, record);
        const bool practice =
            step != nullptr && step->kind == curriculum::StepKind::kFamiliarisation;
        // Getting used to the instruments is no data: pauses in it are nobody's concern.
        if (record.attempt_id != 0 && !practice)
            if (const auto at = attempts_.find(record.attempt_id); at != attempts_.end())
                read(record, step, at->second);
        if (record.superseded() && record.attempt_id != 0) {
            Deviation& one = add(DeviationKind::kRepeated, record);
            one.text = record.superseded_reason;
            one.by = record.superseded_by;
            one.at_utc = record.superseded_utc;
        }
    }

 private:
    Deviation& add(DeviationKind kind, const StepRecord& record) {
        Deviation one;
        one.kind = kind;
        one.participant = record.participant;
        one.visit = record.visit;
        one.step = record.step;
        one.attempt_id = record.attempt_id;
        one.at_utc = record.at_utc;
        found_.push_back(std::move(one));
        return found_.back();
    }

    void read(const StepRecord& record, const curriculum::StudyStep* step,
              const AttemptDetail& attempt) {
        readEvents(record, attempt);
        const double duration = attempt.record.duration_s;
        if (attempt.record.end == sim::EndReason::kInterrupted)
            add(DeviationKind::kInterrupted, record).seconds = duration;
        else if (step != nullptr && duration < step->min_s) {
            Deviation& one = add(DeviationKind::kEndedEarly, record);
            one.seconds = duration;
            one.expected_s = step->min_s;
        }
        // Short or broken off says it already.
        else if (attempt.record.verdict == assessment::Verdict::kNotAttempted)
            add(DeviationKind::kNothingDone, record).seconds = duration;
        // Where neither the protocol nor the coordinator named one, the first one is the rule.
        if (device_.empty()) device_ = attempt.record.device;
        const std::string& expected =
            step != nullptr && !step->device.empty() ? step->device : device_;
        if (attempt.record.device != expected) {
            Deviation& one = add(DeviationKind::kOtherDevice, record);
            one.text = attempt.record.device;
            one.expected = expected;
        }
    }

    void readEvents(const StepRecord& record, const AttemptDetail& attempt) {
        Deviation paused, slow;
        for (const sim::Event& event : attempt.events) {
            if (event.kind == sim::EventKind::kPaused) {
                ++paused.count;
                paused.seconds += event.value;
                paused.causes.insert(static_cast<sim::PauseCause>(event.value2));
            } else if (event.kind == sim::EventKind::kSlowSpell) {
                ++slow.count;
                slow.seconds += event.value;
            }
        }
        slow.text = attempt.record.void_reason;
        slow.meaning = attempt.record.void_meaning;
        if (paused.count > 0) {
            Deviation& one = add(DeviationKind::kPaused, record);
            one.count = paused.count;
            one.seconds = paused.seconds;
            one.causes = paused.causes;
        }
        if (slow.count > 0 || !slow.text.empty()) {
            Deviation& one = add(DeviationKind::kSlowMachine, record);
            one.count = slow.count;
            one.seconds = slow.seconds;
            one.text = slow.text;
            one.meaning = slow.meaning;
        }
    }

    const AttemptsById& attempts_;
    const curriculum::StudyProtocol* protocol_;
    std::vector<Deviation>& found_;
    std::string device_;
};

/// Of one code, or of all.
AttemptsById attempts_of(Store& store, const std::vector<StepRecord>& steps,
                         const std::string& code) {
    std::vector<int64_t> ids;
    for (const StepRecord& record : steps)
        if (record.attempt_id != 0 && (code.empty() || record.participant == code))
            ids.push_back(record.attempt_id);
    return store.attempts().details(ids);
}

void add_notes(Store& store, const std::string& study_id, const std::string& code,
               std::vector<Deviation>& found) {
    for (const StepNote& note : store.records().step_notes(study_id)) {
        if (!code.empty() && note.code != code) continue;
        Deviation one;
        one.kind = DeviationKind::kNote;
        one.participant = note.code;
        one.visit = note.visit;
        one.step = note.step;
        one.at_utc = note.at_utc;
        one.text = note.note;
        one.by = note.noted_by;
        found.push_back(std::move(one));
    }
}

}  // namespace

const char* deviation_name(DeviationKind kind) noexcept {
    return kNames.at(static_cast<size_t>(kind));
}

std::vector<Deviation> study_deviations(Store& store, const std::string& study_id,
                                        const std::string& code) {
    std::vector<Deviation> found;
    const std::vector<StepRecord> steps = store.studies().steps(study_id);
    const AttemptsById attempts = attempts_of(store, steps, code);
    std::map<int, std::optional<curriculum::StudyProtocol>> protocols;
    for (const ParticipantRecord& participant : store.studies().participants(study_id)) {
        if (!code.empty() && participant.code != code) continue;
        const int version = participant.protocol_version;
        if (version > 0 && !protocols.contains(version))
            protocols[version] = published_study(store, study_id, version);
        const auto& protocol = protocols[version];
        Reader reader(attempts, participant, protocol ? &*protocol : nullptr, found);
        for (const StepRecord& record : steps)
            if (record.participant == participant.code) reader.read(record);
    }
    add_notes(store, study_id, code, found);
    std::stable_sort(found.begin(), found.end(), [](const Deviation& a, const Deviation& b) {
        return a.participant < b.participant;
    });
    return found;
}

}  // namespace placode::db
