// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The data of a study or of one person as forms, fields and rows: the one structure that every
// export writes and every read-back is compared with.

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "curriculum/study.h"
#include "db/store.h"
#include "db/study_deviations.h"

namespace placode::reports {

enum class FieldKind : uint8_t {
    kCode,      ///< One of `codes`, whole numbers.
    kMultiple,  ///< Any of `codes`: "0;2".
    kDecimal,
    kDate,  ///< "2026-11-21"
    kText,
};

struct Code {
    int value = 0;
    std::string label;  ///< May be empty: a point of a scale without a word.
};

struct Field {
    std::string id;    ///< As in the questionnaire: unique in its form.
    std::string name;  ///< Lower case, letters, digits and '_': unique in the data set.
    std::string label, section, unit;
    std::string anchor_low, anchor_high;  ///< Of an unmarked line.
    FieldKind kind = FieldKind::kText;
    std::vector<Code> codes;
    std::optional<double> minimum, maximum;
    bool ordinal = false;   ///< Likert.
    bool analogue = false;  ///< Visual analogue.
    bool required = false, reverse = false;
    bool not_applicable = false;  ///< "NA" is a possible value.
    bool identifying = false;     ///< Left out without permission.
    bool derived = false;         ///< Computed: a scale score.
    std::string rule;             ///< Of a scale score: "mean of A B C", "2.5 * sum of ...".
    std::optional<curriculum::ShowIf> show_if;

    /// The number that stands for "does not apply" where only numbers can: the first of 99, 999,
    /// ... that leaves room above every code for the two before it, SPSS's other missing codes.
    [[nodiscard]] int not_applicable_code() const;
};

struct Row {
    std::string participant;  ///< "P001-K", or "U12" for an account.
    int instance = 1;         ///< Counts rows of one participant, those of answers by visit.
    std::string at_utc, language;
    bool demonstration = false;
    int64_t attempt_id = 0;  ///< Of an attempt; else 0.
    int64_t answer_id = 0;   ///< Of a set of answers; else 0.
    bool counts = true;      ///< False for an attempt that no analysis uses: void, or done again.
    bool waits = false;      ///< An attempt that may yet count: it waits for its replay.
    std::map<std::string, std::string> values;  ///< Field id to value; missing is absent.
    std::set<std::string> not_asked;            ///< Hidden by branching.
};

struct Form {
    std::string id;    ///< Questionnaire id, "attempts", "deviations" or "participants".
    std::string name;  ///< Id, and "_v2" behind it where there are several versions.
    int version = 1;
    std::string title, introduction, source, licence;
    bool repeating = false;
    std::vector<Field> fields;
    std::vector<Row> rows;  ///< By participant, then time.

    [[nodiscard]] const Field* field(const std::string& field_id) const;
};

struct Dataset {
    std::string id;  ///< Study id, or "user_12".
    std::string title, description;
    int version = 0;  ///< Of the protocol; 0 = none.
    std::string created_utc, software;
    std::string origin;    ///< UUID of the store, the same in its backups and copies.
    std::string base_uri;  ///< Of the centre, without '/' at its end; empty: addresses are URNs.
    bool demonstration = false;                             ///< Any row is simulated.
    std::string definition_json;                            ///< Of the protocol, if any.
    std::map<std::string, std::string> questionnaire_json;  ///< "sus_v1" to text.
    std::vector<Form> forms;                                ///< Participants first.
    std::vector<db::ParticipantRecord> participants;        ///< Those whose data are used.
    int participants_left_out = 0;            ///< Withdrew, and wanted their data unused or erased.
    std::vector<db::AttemptDetail> attempts;  ///< In the order of the rows of the form "attempts".
    std::vector<db::AnswerRecord> answers;    ///< As stored.
    std::vector<db::Deviation> deviations;    ///< Of the participants whose data are used.

    [[nodiscard]] const Form* form(const std::string& form_id) const;
};

struct DatasetOptions {
    bool identifying = false;     ///< With fields that name a person. Permission is the caller's.
    std::string language = "en";  ///< Of labels.
    /// https address that the centre owns, under which FHIR and xAPI put their names; empty: each
    /// is a urn:uuid made from the store and the name. Nothing is served there either way.
    std::string base_uri = {};
};

/// Everything of a study but who wanted it unused. Throws ReportError when the study has no
/// participants, or when a questionnaire's version is nowhere to be found.
[[nodiscard]] Dataset study_dataset(db::Store& store, const std::string& study_id,
                                    const DatasetOptions& options = {});
/// The attempts of one account.
[[nodiscard]] Dataset user_dataset(db::Store& store, const db::UserRecord& user,
                                   const DatasetOptions& options = {});
/// Attempts as a form; the row of attempts[i] belongs to owners[i].
[[nodiscard]] Form attempts_form(const std::vector<db::AttemptDetail>& attempts,
                                 const std::vector<std::string>& owners);
/// The published text, else the shipped one of that version. Throws ReportError.
[[nodiscard]] curriculum::Questionnaire questionnaire_of(db::Store& store, const std::string& id,
                                                         int version);

/// A form whose rows are answers of people, and not lists of what was done.
[[nodiscard]] inline bool is_questionnaire(const Form& form) {
    return form.id != "participants" && form.id != "attempts" && form.id != "deviations";
}
/// The address of a thing in exports ("Questionnaire/sus"): below the centre's base, else a URN
/// that is the same in every export of this store.
[[nodiscard]] std::string address_of(const Dataset& data, const std::string& thing);
/// Throws ReportError unless it is an absolute http or https address; takes '/' off its end.
[[nodiscard]] std::string checked_base_uri(const std::string& text);

/// "form|participant|instance|field" to value.
using Cells = std::map<std::string, std::string>;
[[nodiscard]] std::string cell_key(const Form& form, const Row& row, const Field& field);
[[nodiscard]] Cells cells_of(const Dataset& data);

/// Throws ReportError naming `what` and the first cell that differs. Numbers are compared as
/// numbers, all else letter by letter.
void compare_cells(const Cells& expected, const Cells& found, const std::string& what);

/// Lower case letters, digits and '_', not starting with a digit.
[[nodiscard]] std::string plain_name(const std::string& text);

}  // namespace placode::reports
