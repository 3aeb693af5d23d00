// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The folder of a data set: HDF5 by task, recordings, data sheet, licence, checksums.

#include <QCryptographicHash>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "db/recording_file.h"
#include "reports/demonstrations.h"
#include "reports/export.h"
#include "reports/report.h"
#include "sim/core/number_text.h"

namespace placode::reports {
namespace {

namespace fs = std::filesystem;

constexpr std::array<const char*, 3> kParts{"train", "valid", "test"};

std::string json_list(const std::vector<std::string>& words) {
    QJsonArray list;
    for (const std::string& word : words) list.append(QString::fromStdString(word));
    return QJsonDocument(list).toJson(QJsonDocument::Compact).toStdString();
}

/// Over all numbers of a demonstration: what is read back is compared without keeping them all.
std::string digest_of(const DemonstrationArrays& arrays) {
    QCryptographicHash hash(QCryptographicHash::Sha256);
    for (const std::vector<double>* numbers :
         {&arrays.observations.values, &arrays.next_observations.values, &arrays.actions.values,
          &arrays.rewards, &arrays.dones})
        hash.addData(QByteArray::fromRawData(
            reinterpret_cast<const char*>(numbers->data()),
            static_cast<qsizetype>(numbers->size()) * qsizetype{sizeof(double)}));
    return hash.result().toHex().toStdString();
}

/// What robomimic makes an environment from: 2 = an environment of Gymnasium.
std::string environment_arguments(const std::string& task, double step_s) {
    const QJsonObject arguments{{"task", QString::fromStdString(task)},
                                {"units", "absolute"},
                                // The attribute `seed` is that of the field.
                                {"lesions", 0},
                                {"frame_skip", static_cast<int>(std::llround(step_s * 1000))}};
    return QJsonDocument(QJsonObject{{"env_name", QString::fromStdString(task)},
                                     {"type", 2},
                                     {"env_kwargs", arguments}})
        .toJson(QJsonDocument::Compact)
        .toStdString();
}

/// One task's file; its demonstrations in their order, each with its part of the split.
class TaskFile {
 public:
    TaskFile(const std::string& path, const DemonstrationOptions& options)
        : path_(path), options_(options), file_(path, Hdf5File::Open::kCreate) {}

    /// The recording that is kept is written anew, without the day on which it was made.
    void add(const Demonstration& one, int part, const fs::path& recordings) {
        sim::Recording recording = db::read_recording_file(one.recording_file);
        const size_t tools = recording.header.tools.size();
        const auto action_names = demonstration_action_names(tools);
        if (count_ == 0)
            head(one, tools, action_names);
        else if (action_names.size() != columns_)
            throw ReportError(one.recording_file +
                              ": has other instruments than the attempts "
                              "before it; expected those of one task to have the same");
        const std::string name = "demo_" + std::to_string(count_++);
        const std::string place = "data/" + name;
        const auto arrays = demonstration_arrays(recording, one.points, options_.step_s);
        file_.attribute(place, "num_samples", static_cast<int64_t>(arrays.rewards.size()));
        file_.attribute(place, "operator", one.operator_name);
        file_.attribute(place, "points", one.points);
        file_.attribute(place, "passed", static_cast<int64_t>(one.passed ? 1 : 0));
        file_.attribute(place, "seed", static_cast<int64_t>(recording.header.seed));
        file_.attribute(place, "build", recording.header.build);
        file_.attribute(place, "recording", "recordings/" + one.task + "-" + name + ".placode");
        file_.write(place + "/actions", arrays.actions);
        file_.write(place + "/obs/state", arrays.observations);
        file_.write(place + "/next_obs/state", arrays.next_observations);
        file_.write(place + "/rewards", arrays.rewards);
        file_.write(place + "/dones", arrays.dones);
        parts_[static_cast<size_t>(part)].push_back(name);
        total_ += arrays.rewards.size();
        digests_.push_back(digest_of(arrays));
        recording.header.started_utc.clear();
        keep(recording, recordings / (one.task + "-" + name + ".placode"));
    }

    void end() {
        file_.attribute("data", "total", static_cast<int64_t>(total_));
        for (size_t part = 0; part < kParts.size(); ++part)
            if (!parts_[part].empty())
                file_.write(std::string("mask/") + kParts[part], parts_[part]);
    }
    [[nodiscard]] const std::vector<std::string>& digests() const { return digests_; }
    [[nodiscard]] size_t total() const { return total_; }
    [[nodiscard]] size_t in_part(size_t part) const { return parts_[part].size(); }

 private:
    void head(const Demonstration& one, size_t tools,
              const std::vector<std::string>& action_names) {
        columns_ = action_names.size();
        file_.attribute("data", "env_args", environment_arguments(one.task, options_.step_s));
        file_.attribute("data", "task", one.task);
        file_.attribute("data", "observation_names", json_list(demonstration_names(tools)));
        file_.attribute("data", "action_names", json_list(action_names));
        file_.attribute("data", "step_s", options_.step_s);
        file_.attribute("data", "licence", options_.licence);
        file_.attribute("data", "software", options_.software);
    }

    static void keep(const sim::Recording& recording, const fs::path& path) {
        const auto sink = db::create_recording_file(path.string());
        sink->begin(recording.header);
        if (!recording.given.empty()) sink->give(recording.given);
        sink->append(recording.inputs, recording.samples, recording.events);
        sink->finish(recording.end);
    }

    std::string path_;
    const DemonstrationOptions& options_;
    Hdf5File file_;
    size_t count_ = 0, total_ = 0, columns_ = 0;
    std::array<std::vector<std::string>, 3> parts_;
    std::vector<std::string> digests_;
};

void compare(const std::string& path, const std::vector<std::string>& digests) {
    const Hdf5File file(path, Hdf5File::Open::kRead);
    for (size_t i = 0; i < digests.size(); ++i) {
        const std::string place = "data/demo_" + std::to_string(i);
        const DemonstrationArrays found{
            file.matrix(place + "/obs/state"), file.matrix(place + "/next_obs/state"),
            file.matrix(place + "/actions"), file.matrix(place + "/rewards").values,
            file.matrix(place + "/dones").values};
        if (digest_of(found) != digests[i])
            throw ReportError(path + ": " + place + " read back differs from what was written");
    }
}

struct TaskLine {
    std::string task;
    size_t demonstrations = 0, steps = 0, passed = 0;
    std::array<size_t, 3> parts{};
};

std::string data_sheet(const std::vector<Demonstration>& all, const DemonstrationOptions& options,
                       const std::vector<TaskLine>& tasks) {
    std::set<std::string> persons;
    size_t of_people = 0;
    for (const Demonstration& one : all) {
        if (!one.of_a_person) continue;
        ++of_people;
        persons.insert(one.person);
    }
    std::string text =
        "# Data sheet\n\n## What it is\n\nAttempts at simulated fetoscopic spina "
        "bifida repair as demonstrations, written by " +
        options.software + ". " + options.origin +
        "\n\n| task | demonstrations | passed | steps | train | "
        "valid | test |\n|---|---|---|---|---|---|---|\n";
    for (const TaskLine& one : tasks) {
        text += "| " + one.task + " | " + std::to_string(one.demonstrations) + " | " +
                std::to_string(one.passed) + " | " + std::to_string(one.steps) + " |";
        for (const size_t part : one.parts) text += " " + std::to_string(part) + " |";
        text += "\n";
    }
    text += "\n## Who operated\n\n" + std::to_string(of_people) + " attempts of " +
            std::to_string(persons.size()) + " people; the other " +
            std::to_string(all.size() - of_people) + " are of scripted operators or policies.\n" +
            options.consent + (options.consent.empty() ? "" : "\n") +
            (options.left_out > 0 ? std::to_string(options.left_out) +
                                        " attempts were left out: their people did not agree, or "
                                        "withdrew.\n"
                                  : "");
    text +=
        "No name, code, day or computer is in these files. A way of moving can still be "
        "recognised: do not try to find out whose an attempt is.\n";
    text +=
        "\n## How it is split\n\nBy person; attempts of scripts and policies by the seed of "
        "the lesion. Nobody, and no lesion of a script, is in two parts. Shares asked for: " +
        std::to_string(options.split[0]) + ", " + std::to_string(options.split[1]) + ", " +
        std::to_string(options.split[2]) + " %.\n";
    text +=
        "\n## What the arrays mean\n\nLayout of robomimic: `data/demo_k/{obs,next_obs}/state`, "
        "`actions`, `rewards`, `dones`, and `mask/{train,valid,test}`. A step is " +
        sim::shortest_text(options.step_s) +
        " s. The columns of `state` and `actions` are named in the attributes "
        "`observation_names` and `action_names` of `data`; names end in their unit and are "
        "those of Placode's environments. Observations are the recorded samples: what an "
        "environment computes beyond them (goals, distances to the plan, harm so far) is not "
        "among them. An action is where the hand was at the end of the step, in absolute "
        "units. The reward is sparse: the points over 100 with the last step.\n";
    text +=
        "\n## What it is not for\n\nTissue and anatomy are planning values that no fetal "
        "surgeon has confirmed. Nothing here tells how to operate on a patient.\n";
    text +=
        "\n## Proof\n\n`recordings/` holds each attempt as it was simulated: `placode-sim "
        "--device play:FILE --headless` repeats it on the build that the attribute `build` "
        "names. `SHA256SUMS` lists all files.\n\n## Licence\n\n" +
        options.licence + "\n";
    return text;
}

std::vector<std::string> write_sums(const fs::path& folder) {
    std::vector<std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file())
            files.push_back(entry.path().lexically_relative(folder).string());
    std::sort(files.begin(), files.end());
    std::string text;
    for (const std::string& file : files)
        text +=
            QCryptographicHash::hash(QByteArray::fromStdString(read_file((folder / file).string())),
                                     QCryptographicHash::Sha256)
                .toHex()
                .toStdString() +
            "  " + file + "\n";
    save_file((folder / "SHA256SUMS").string(), text);
    files.emplace_back("SHA256SUMS");
    return files;
}

}  // namespace

std::vector<std::string> write_demonstrations(const std::vector<Demonstration>& demonstrations,
                                              const DemonstrationOptions& options,
                                              const std::string& folder,
                                              const DemonstrationProgress& progress) {
    const fs::path place(folder);
    std::error_code error;
    fs::create_directories(place / "recordings", error);
    if (error || std::distance(fs::directory_iterator(place), {}) != 1 ||
        !fs::is_empty(place / "recordings"))
        throw ReportError(folder +
                          ": cannot be used for a data set; expected an empty folder, or "
                          "one that is not there and can be made");
    const std::vector<int> parts = split_by_person(demonstrations, options.split, options.seed);
    std::set<std::string> tasks;
    for (const Demonstration& one : demonstrations) tasks.insert(one.task);
    std::vector<TaskLine> lines;
    size_t done = 0;
    for (const std::string& task : tasks) {
        const std::string path = (place / (file_name(task) + ".hdf5")).string();
        std::vector<std::string> digests;
        TaskLine line;
        line.task = task;
        {
            TaskFile file(path, options);
            for (size_t i = 0; i < demonstrations.size(); ++i) {
                if (demonstrations[i].task != task) continue;
                if (progress && !progress(done++, demonstrations.size()))
                    throw ReportError(folder + ": stopped; what is there is not complete");
                file.add(demonstrations[i], parts[i], place / "recordings");
                ++line.demonstrations;
                line.passed += demonstrations[i].passed ? 1 : 0;
            }
            file.end();
            line.steps = file.total();
            for (size_t part = 0; part < 3; ++part) line.parts[part] = file.in_part(part);
            digests = file.digests();
        }
        compare(path, digests);
        lines.push_back(line);
    }
    save_file((place / "DATASHEET.md").string(), data_sheet(demonstrations, options, lines));
    save_file((place / "LICENCE.txt").string(), options.licence + "\n");
    if (!options.reader_file.empty())
        save_file((place / "read_dataset.py").string(), read_file(options.reader_file));
    return write_sums(place);
}

}  // namespace placode::reports
