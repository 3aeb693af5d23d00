// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/staged_folder.h"

#include <unistd.h>

#include <filesystem>
#include <system_error>
#include <vector>

#include "reports/export.h"
#include "reports/report.h"

namespace placode::reports {
namespace {

namespace fs = std::filesystem;

constexpr fs::perms kOwnerReadsAndWrites = fs::perms::owner_read | fs::perms::owner_write;

/// A folder that is made where there is none, with those above it; taken away again while nothing
/// lies in it.
class MadeFolder {
 public:
    explicit MadeFolder(const std::string& folder) {
        const fs::path whole = fs::absolute(folder).lexically_normal();
        std::error_code unknown;
        fs::path each = whole.has_filename() ? whole : whole.parent_path();
        for (; each.has_relative_path() && !fs::exists(each, unknown); each = each.parent_path())
            missing_.push_back(each);
        make_private_folder(folder);
    }
    ~MadeFolder() {
        std::error_code holds_something;
        for (const fs::path& each : missing_)
            if (!fs::remove(each, holds_something)) return;
    }
    MadeFolder(const MadeFolder&) = delete;
    MadeFolder& operator=(const MadeFolder&) = delete;

 private:
    std::vector<fs::path> missing_;  // the innermost first
};

/// A folder beside the final place, so that moving is renaming. Gone with everything in it unless
/// it was emptied.
class Staging {
 public:
    explicit Staging(const fs::path& folder) {
        std::string name = (folder / ".placode-export-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr)
            throw ReportError("export to " + folder.string() +
                              ": cannot write there; choose a folder that you may write to");
        path_ = name;
    }
    ~Staging() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    Staging(const Staging&) = delete;
    Staging& operator=(const Staging&) = delete;
    [[nodiscard]] const fs::path& path() const { return path_; }

 private:
    fs::path path_;
};

/// People's answers and attempts, whoever else has an account on this computer: not for them.
void close_to_others(const fs::path& folder) {
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        fs::permissions(entry.path(),
                        entry.is_directory() ? fs::perms::owner_all : kOwnerReadsAndWrites);
}

/// A folder in the way is refused before anything is moved: it may hold another export.
void hand_out(const fs::path& staged, const fs::path& folder) {
    std::vector<fs::path> entries;
    for (const auto& entry : fs::directory_iterator(staged)) entries.push_back(entry.path());
    for (const fs::path& entry : entries) {
        const fs::path target = folder / entry.filename();
        if (fs::is_directory(target))
            throw ReportError("export to " + target.string() +
                              ": is there already; remove it or choose another folder");
        if (fs::exists(target) && fs::is_directory(entry))
            throw ReportError("export to " + target.string() +
                              ": a file is in the way; remove it or choose another folder");
    }
    for (const fs::path& entry : entries) fs::rename(entry, folder / entry.filename());
}

/// Nobody knows the hidden folder, and it is gone when this is read.
std::string without_staging(std::string text, const std::string& staged,
                            const std::string& folder) {
    for (size_t at = text.find(staged); at != std::string::npos;
         at = text.find(staged, at + folder.size()))
        text.replace(at, staged.size(), folder);
    return text;
}

}  // namespace

void write_staged(const std::string& folder,
                  const std::function<void(const std::string& staged)>& write) {
    const MadeFolder made(folder);
    const Staging staging(folder);
    const std::string staged = staging.path().string();
    try {
        write(staged);
        close_to_others(staging.path());
        hand_out(staging.path(), folder);
    } catch (const ReportError& error) {
        throw ReportError(without_staging(error.what(), staged, folder));
    } catch (const fs::filesystem_error& error) {
        throw ReportError(without_staging("export to " + error.path1().string(), staged, folder) +
                          ": " + error.code().message() + "; free space or choose another folder");
    }
}

}  // namespace placode::reports
