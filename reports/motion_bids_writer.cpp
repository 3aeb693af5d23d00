// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Motion-BIDS (BIDS 1.9): the trajectories of the instruments, 100 Hz, and the ledger of events.
// Force and power have no channel type of their own and go as MISC.

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <array>
#include <charconv>
#include <filesystem>

#include "reports/csv_table.h"
#include "reports/formats.h"
#include "reports/report.h"
#include "sim/core/event.h"

namespace placode::reports {
namespace {

namespace fs = std::filesystem;

struct Channel {
    std::string name, component, type, tracked_point, units;
};

/// Floats get the digits of a float.
template <class Number>
std::string plain(Number value) {
    std::array<char, 40> text{};
    const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value);
    return {text.data(), end};
}

/// BIDS labels are letters and digits.
std::string label(const std::string& text) {
    std::string name;
    for (const char c : text)
        if (std::isalnum(static_cast<unsigned char>(c)) != 0) name += c;
    return name.empty() ? "x" : name;
}

std::string point_name(const sim::Recording& recording, size_t tool) {
    const bool scope = recording.header.tools[tool].kind == sim::ToolKind::kScope;
    return (scope ? "scope" : "tool") + std::to_string(tool + 1);
}

std::vector<Channel> channels_of(const sim::Recording& recording) {
    std::vector<Channel> channels{{"latency", "n/a", "LATENCY", "n/a", "s"}};
    for (size_t tool = 0; tool < recording.header.tools.size(); ++tool) {
        const std::string point = point_name(recording, tool);
        for (const char* axis : {"x", "y", "z"})
            channels.push_back({point + "_pos_" + axis, axis, "POS", point, "m"});
        for (const char* part : {"quat_w", "quat_x", "quat_y", "quat_z"})
            channels.push_back({point + "_" + part, part, "ORNT", point, "n/a"});
        for (const char* axis : {"x", "y", "z"})
            channels.push_back({point + "_force_" + axis, axis, "MISC", point, "N"});
        channels.push_back({point + "_jaw", "n/a", "MISC", point, "rad"});
        channels.push_back({point + "_power", "n/a", "MISC", point, "W"});
    }
    return channels;
}

std::vector<std::string> sample_cells(const sim::Recording& recording, const sim::Sample& sample) {
    std::vector<std::string> cells{plain(sample.time_s)};
    for (size_t tool = 0; tool < recording.header.tools.size(); ++tool) {
        const sim::ToolSample& state = sample.tools[tool];
        for (const float value : state.tip_m) cells.push_back(plain(value));
        for (const float value : state.orientation) cells.push_back(plain(value));
        for (const float value : state.force_n) cells.push_back(plain(value));
        cells.push_back(plain(state.jaw_rad));
        cells.push_back(plain(state.power_w));
    }
    return cells;
}

std::string motion_text(const sim::Recording& recording) {
    std::string text;
    for (const sim::Sample& sample : recording.samples)
        text += csv_line(sample_cells(recording, sample), '\t');
    return text;
}

std::string channels_text(const sim::Recording& recording) {
    std::string text = csv_line({"name", "component", "type", "tracked_point", "units"}, '\t');
    for (const Channel& channel : channels_of(recording))
        text += csv_line(
            {channel.name, channel.component, channel.type, channel.tracked_point, channel.units},
            '\t');
    return text;
}

std::string events_text(const sim::Recording& recording) {
    std::string text = csv_line({"onset", "duration", "trial_type", "tool", "value"}, '\t');
    for (const sim::Event& event : recording.events) {
        if (sim::only_in_recording(event.kind))
            continue;  // hundreds a second: they are in the recording
        const std::string kind(sim::event_name(event.kind));
        text += csv_line({plain(event.time_s), "0", kind,
                          std::to_string(static_cast<int>(event.tool) + 1), plain(event.value)},
                         '\t');
    }
    return text;
}

std::string motion_json(const sim::Recording& recording, const db::AttemptRecord& attempt,
                        const Row& row) {
    std::map<std::string, int> count;
    for (const Channel& channel : channels_of(recording)) ++count[channel.type];
    QJsonObject json{
        {"TaskName", QString::fromStdString(attempt.task_id)},
        {"TaskDescription", "Simulated fetoscopic spina bifida repair"},
        {"SamplingFrequency", recording.header.sample_s > 0 ? 1 / recording.header.sample_s : 100},
        {"TrackingSystemName", "placode"},
        {"Manufacturer", "Placode"},
        {"SoftwareVersions", QString::fromStdString(recording.header.build)},
        {"RecordingType", "continuous"},
        {"RecordingDuration", recording.end.duration_s},
        {"MotionChannelCount", static_cast<int>(channels_of(recording).size())},
        {"TrackedPointsCount", static_cast<int>(recording.header.tools.size())},
        {"SpatialAxes", "ALS"},
        {"RotationRule", "right-hand"},
        {"RotationOrder", "n/a"},
        {"DeviceSerialNumber", "n/a"},
        {"PlacodeDevice", QString::fromStdString(attempt.device)},
        {"PlacodeAttempt", static_cast<qint64>(attempt.id)},
        {"PlacodeSeed", QString::number(attempt.seed)},
        {"PlacodeStateHash", QString::number(recording.end.final_hash, 16)},
        {"PlacodeDemonstration", attempt.demonstration},
        {"PlacodeCounts", row.counts}};
    for (const auto& [field, key] : {std::pair{"void_reason", "PlacodeVoidReason"},
                                     {"not_done", "PlacodeNotDone"},
                                     {"superseded_reason", "PlacodeDoneAgainBecause"}})
        if (const auto found = row.values.find(field); found != row.values.end())
            json[key] = QString::fromStdString(found->second);
    for (const auto& [type, n] : count) json[QString::fromStdString(type) + "ChannelCount"] = n;
    return QJsonDocument(json).toJson().toStdString();
}

struct Place {
    const db::AttemptDetail* attempt;
    const Row* row;
    std::string folder, stem;
};

/// Where each attempt of the data set goes.
std::vector<Place> places_of(const Dataset& data, const std::string& root) {
    std::vector<Place> places;
    const Form* form = data.form("attempts");
    if (form == nullptr) return places;
    std::map<std::string, int> runs;
    for (const Row& row : form->rows) {
        for (const db::AttemptDetail& attempt : data.attempts) {
            if (attempt.record.id != row.attempt_id) continue;
            const std::string subject = "sub-" + label(row.participant);
            const std::string stem = subject + "_task-" + label(attempt.record.task_id);
            const int run = ++runs[stem];
            places.push_back({&attempt, &row, root + "/" + subject + "/motion",
                              stem + "_tracksys-placode_run-" + std::to_string(run)});
        }
    }
    return places;
}

std::string participants_text(const Dataset& data) {
    std::string text = csv_line({"participant_id", "code", "demonstration"}, '\t');
    std::set<std::string> seen;
    for (const Form& form : data.forms)
        for (const Row& row : form.rows)
            if (seen.insert(row.participant).second)
                text += csv_line({"sub-" + label(row.participant), row.participant,
                                  row.demonstration ? "true" : "false"},
                                 '\t');
    return text;
}

std::string description_json(const Dataset& data) {
    const QJsonObject generator{{"Name", "Placode"},
                                {"Version", QString::fromStdString(data.software)}};
    return QJsonDocument(QJsonObject{{"Name", QString::fromStdString(data.title)},
                                     {"BIDSVersion", "1.9.0"},
                                     {"DatasetType", "raw"},
                                     {"GeneratedBy", QJsonArray{generator}}})
        .toJson()
        .toStdString();
}

std::string readme(const Dataset& data, const std::vector<std::string>& without) {
    std::string text = data.title + "\n\n";
    if (data.demonstration)
        text += "DEMONSTRATION: holds simulated participants or scripted operators.\n\n";
    text +=
        "Instruments of the Placode simulator in the world frame: x towards the mother's head "
        "(cranial), y to the left,\nz outward from the back; origin at the lesion. Positions in "
        "m, forces of tissue on the tool in N, quaternions w x y z.\nThe motion files have no "
        "header; their columns are the rows of the channels file.\n";
    for (const std::string& each : without) text += "Without a recording: " + each + "\n";
    return text;
}

std::string root_of(const Dataset& data, const std::string& folder) {
    return folder + "/" + file_name(data.id) + "_motion-bids";
}

}  // namespace

void write_motion_bids(const ExportSource& source, const std::string& folder) {
    const std::string root = root_of(source.data, folder);
    fs::create_directories(root);
    std::vector<std::string> without;
    const std::vector<Place> places = places_of(source.data, root);
    for (size_t i = 0; i < places.size(); ++i) {
        const Place& place = places[i];
        source.pace.next({kMotionBidsTitle, i, places.size()});
        const auto recording = source.recording(place.attempt->record.id);
        if (!recording) {
            without.push_back("attempt " + std::to_string(place.attempt->record.id));
            continue;
        }
        fs::create_directories(place.folder);
        const std::string stem = place.folder + "/" + place.stem;
        save_file(stem + "_motion.tsv", motion_text(*recording));
        save_file(stem + "_motion.json",
                  motion_json(*recording, place.attempt->record, *place.row));
        save_file(stem + "_channels.tsv", channels_text(*recording));
        save_file(stem + "_events.tsv", events_text(*recording));
    }
    save_file(root + "/dataset_description.json", description_json(source.data));
    save_file(root + "/participants.tsv", participants_text(source.data));
    save_file(root + "/README", readme(source.data, without));
}

void verify_motion_bids(const ExportSource& source, const std::string& folder) {
    const std::string root = root_of(source.data, folder);
    const std::vector<Place> places = places_of(source.data, root);
    for (size_t i = 0; i < places.size(); ++i) {
        const Place& place = places[i];
        source.pace.next({kMotionBidsTitle, i, places.size()});
        const auto recording = source.recording(place.attempt->record.id);
        if (!recording) continue;
        const std::string path = place.folder + "/" + place.stem;
        const auto rows = parse_csv(read_file(path + "_motion.tsv"), '\t');
        const auto channels = parse_csv(read_file(path + "_channels.tsv"), '\t');
        const auto fail = [&](const std::string& problem) {
            throw ReportError("export motion-bids: read back, " + place.stem + " " + problem +
                              "; nothing was handed out");
        };
        if (rows.size() != recording->samples.size())
            fail("has " + std::to_string(rows.size()) + " rows; the recording has " +
                 std::to_string(recording->samples.size()) + " samples");
        for (size_t i = 0; i < rows.size(); ++i) {
            if (rows[i].size() + 1 != channels.size())
                fail("row " + std::to_string(i + 1) + " does not fit its channels");
            if (rows[i] != sample_cells(*recording, recording->samples[i]))
                fail("row " + std::to_string(i + 1) + " differs from the recording");
        }
    }
}

std::string bundle_manifest(const ExportSource& source, const std::vector<ExportedFile>& files) {
    const Dataset& data = source.data;
    QJsonArray list, forms;
    for (const ExportedFile& file : files)
        list.append(QJsonObject{{"path", QString::fromStdString(file.path)},
                                {"bytes", static_cast<qint64>(file.bytes)},
                                {"sha256", QString::fromStdString(file.sha256)}});
    for (const Form& form : data.forms)
        forms.append(QJsonObject{{"form", QString::fromStdString(form.name)},
                                 {"version", form.version},
                                 {"fields", static_cast<int>(form.fields.size())},
                                 {"rows", static_cast<int>(form.rows.size())}});
    return QJsonDocument(
               QJsonObject{{"study", QString::fromStdString(data.id)},
                           {"title", QString::fromStdString(data.title)},
                           {"protocol_version", data.version},
                           {"created_utc", QString::fromStdString(data.created_utc)},
                           {"software", QString::fromStdString(data.software)},
                           {"demonstration", data.demonstration},
                           {"participants_left_out", data.participants_left_out},
                           {"cells", static_cast<int>(cells_of(data).size())},
                           {"read_back", "every file was read back and compared with the store"},
                           {"forms", forms},
                           {"files", list}})
        .toJson()
        .toStdString();
}

}  // namespace placode::reports
