// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/export.h"

#include <unistd.h>

#include <QCryptographicHash>
#include <QFile>
#include <QString>
#include <algorithm>
#include <filesystem>

#include "db/private_file.h"
#include "db/recording_file.h"
#include "db/whole_file.h"
#include "reports/formats.h"
#include "reports/report.h"
#include "reports/staged_folder.h"

namespace placode::reports {
namespace {

namespace fs = std::filesystem;

std::vector<ExportedFile> files_in(const fs::path& folder) {
    std::vector<ExportedFile> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (!entry.is_regular_file()) continue;
        const std::string bytes = read_file(entry.path().string());
        const QByteArray hash = QCryptographicHash::hash(
            QByteArray::fromRawData(bytes.data(), static_cast<qsizetype>(bytes.size())),
            QCryptographicHash::Sha256);
        files.push_back({fs::relative(entry.path(), folder).string(), hash.toHex().toStdString(),
                         static_cast<int64_t>(bytes.size())});
    }
    std::sort(files.begin(), files.end(),
              [](const auto& a, const auto& b) { return a.path < b.path; });
    return files;
}

const ExportFormat& format_of(const std::string& name) {
    std::string known;
    for (const ExportFormat& format : export_formats()) {
        if (name == format.name) return format;
        known += (known.empty() ? "" : ", ") + std::string(format.name);
    }
    throw ReportError("export: found the format \"" + name + "\"; expected one of: " + known);
}

}  // namespace

std::string file_name(const std::string& text) {
    std::string name = text;
    for (char& c : name)
        if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-' && c != '_' && c != '.')
            c = '_';
    return name.empty() || name[0] == '.' ? "_" + name : name;
}

void make_private_folder(const std::string& folder) {
    std::error_code error;
    const bool made = fs::create_directories(folder, error);
    if (!fs::is_directory(folder))
        throw ReportError("export to " + folder +
                          ": cannot be made a folder; choose another place");
    if (made) fs::permissions(folder, fs::perms::owner_all);
}

namespace {

void save(db::WholeFile& file, const std::string& path, const std::string& bytes) {
    const auto size = static_cast<qint64>(bytes.size());
    if (file.open(QIODevice::WriteOnly) && file.write(bytes.data(), size) == size && file.commit())
        return;
    throw ReportError("write " + path + ": " + file.errorString().toStdString() +
                      "; free space or choose a folder that you may write to");
}

}  // namespace

void save_file(const std::string& path, const std::string& bytes) {
    db::WholeFile file(QString::fromStdString(path));
    save(file, path, bytes);
}

void save_private_file(const std::string& path, const std::string& bytes) {
    db::PrivateFile file(path);
    save(file, path, bytes);
}

std::string read_file(const std::string& path) {
    QFile file(QString::fromStdString(path));
    if (!file.open(QIODevice::ReadOnly))
        throw ReportError("read " + path + ": " + file.errorString().toStdString());
    return file.readAll().toStdString();
}

const std::vector<ExportFormat>& export_formats() {
    static const std::vector<ExportFormat> formats{
        {"csv", "CSV (wide, long, codebook)", write_csv, verify_csv},
        {"spss", "SPSS (.sav)", write_spss, verify_spss},
        {"redcap", "REDCap (dictionary and records)", write_redcap, verify_redcap},
        {"fhir", "FHIR R4 (Questionnaire, QuestionnaireResponse)", write_fhir, verify_fhir},
        {"odm", "CDISC ODM 1.3.2", write_odm, verify_odm},
        {"xapi", "xAPI statements", write_xapi, verify_xapi},
        {"motion-bids", kMotionBidsTitle, write_motion_bids, verify_motion_bids},
        {"bundle", "All of these with manifest and checksums", write_bundle, verify_bundle}};
    return formats;
}

std::vector<ExportedFile> export_dataset(const ExportSource& source, const std::string& format,
                                         const std::string& folder) {
    const ExportFormat& chosen = format_of(format);
    std::vector<ExportedFile> files;
    write_staged(folder, [&](const std::string& staged) {
        source.pace.next({chosen.title});
        chosen.write(source, staged);
        source.pace.next({chosen.title});
        chosen.verify(source, staged);
        source.pace.next({chosen.title});
        files = files_in(staged);
    });
    return files;
}

RecordingOf recordings_of(db::Store& store) {
    return [&store](int64_t attempt_id) -> std::optional<sim::Recording> {
        std::string name = (fs::temp_directory_path() / "placode-recording-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr)
            throw ReportError("cannot make a temporary folder in " +
                              fs::temp_directory_path().string());
        std::optional<sim::Recording> recording;
        try {
            store.attempts().extract_recording(attempt_id, name + "/attempt.placode");
            recording = db::recover_recording_file(name + "/attempt.placode").recording;
        } catch (const db::StoreError& error) {
            fs::remove_all(name);
            if (error.kind() != db::StoreError::Kind::kNotFound) throw;
            return std::nullopt;
        }
        fs::remove_all(name);
        return recording;
    };
}

// --- bundle ------------------------------------------------------------------------------------

namespace {

std::string bundle_folder(const ExportSource& source, const std::string& folder) {
    return folder + "/" + file_name(source.data.id) + "_bundle";
}

std::string sums_of(const std::vector<ExportedFile>& files) {
    std::string text;  // As `sha256sum -c` reads it.
    for (const ExportedFile& file : files)
        if (file.path != "SHA256SUMS") text += file.sha256 + "  " + file.path + "\n";
    return text;
}

}  // namespace

void write_bundle(const ExportSource& source, const std::string& folder) {
    const std::string root = bundle_folder(source, folder);
    for (const ExportFormat& format : export_formats()) {
        if (format.write == write_bundle) continue;
        source.pace.next({format.title});
        const std::string part = root + "/" + format.name;
        fs::create_directories(part);
        format.write(source, part);
    }
    fs::create_directories(root + "/definitions");
    if (!source.data.definition_json.empty())
        save_file(root + "/definitions/study.json", source.data.definition_json);
    for (const auto& [name, json] : source.data.questionnaire_json)
        save_file(root + "/definitions/" + file_name(name) + ".json", json);
    save_file(root + "/manifest.json", bundle_manifest(source, files_in(root)));
    save_file(root + "/SHA256SUMS", sums_of(files_in(root)));
}

void verify_bundle(const ExportSource& source, const std::string& folder) {
    const std::string root = bundle_folder(source, folder);
    for (const ExportFormat& format : export_formats()) {
        if (format.write == write_bundle) continue;
        source.pace.next({format.title});
        format.verify(source, root + "/" + format.name);
    }
    if (read_file(root + "/SHA256SUMS") != sums_of(files_in(root)))
        throw ReportError(
            "export bundle: read back, a checksum in SHA256SUMS does not fit; "
            "nothing was handed out");
}

}  // namespace placode::reports
