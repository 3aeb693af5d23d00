// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "batches/checksum.h"

#include <unistd.h>

#include <QCryptographicHash>
#include <QFile>
#include <cstdio>
#include <fstream>
#include <iterator>

#include "batches/batch_error.h"
#include "db/durable_file.h"

namespace placode::batches {

namespace fs = std::filesystem;

std::string sha256(const std::string& bytes) {
    return QCryptographicHash::hash(
               QByteArray::fromRawData(bytes.data(), static_cast<qsizetype>(bytes.size())),
               QCryptographicHash::Sha256)
        .toHex()
        .toStdString();
}

std::string sha256_of_file(const fs::path& path) {
    QFile file(QString::fromStdString(path.string()));
    QCryptographicHash hash(QCryptographicHash::Sha256);
    if (!file.open(QIODevice::ReadOnly) || !hash.addData(&file))
        throw BatchError(BatchError::Kind::kBadInput,
                         path.string() + ": cannot be read; put the file back or plan anew");
    return hash.result().toHex().toStdString();
}

std::string hash_text(uint64_t hash) {
    char text[24];
    std::snprintf(text, sizeof text, "0x%016llx", static_cast<unsigned long long>(hash));
    return text;
}

std::string read_text(const fs::path& path) {
    std::error_code none;
    if (fs::is_directory(path, none))
        throw BatchError(BatchError::Kind::kBadInput,
                         path.string() + ": is a folder; expected a file");
    std::ifstream in(path, std::ios::binary);
    std::string text;
    try {
        text.assign(std::istreambuf_iterator<char>(in), {});
    } catch (const std::ios_base::failure&) {  // what a disk that fails in the middle throws
        in.setstate(std::ios::badbit);
    }
    if (!in) throw BatchError(BatchError::Kind::kBadInput, path.string() + ": cannot be read");
    return text;
}

void write_whole(const fs::path& path, const std::string& text) {
    const std::string part = path.string() + "." + std::to_string(::getpid()) + ".part";
    try {
        std::ofstream out(part, std::ios::binary | std::ios::trunc);
        out << text;
        out.close();
        if (!out)
            throw fs::filesystem_error("cannot be written", path,
                                       std::make_error_code(std::errc::io_error));
        db::sync_file(part);
        fs::rename(part, path);
        db::sync_folder_of(path.string());
    } catch (const fs::filesystem_error& error) {
        std::error_code ignored;
        fs::remove(part, ignored);
        throw BatchError(BatchError::Kind::kFailed,
                         path.string() + ": cannot be written (" + error.code().message() +
                             "); make room there or choose another place");
    }
}

}  // namespace placode::batches
