// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/messages.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <filesystem>
#include <new>
#include <stdexcept>

#include "curriculum/definitions.h"
#include "haptics/device.h"
#include "reports/people_file.h"
#include "reports/report.h"
#include "reports/words.h"
#include "ui/shell/attempt_launcher.h"
#include "ui/shell/parts.h"

namespace placode::ui {
namespace {

struct Messages {
    Q_DECLARE_TR_FUNCTIONS(Messages)
};

QString nothing_lost() {
    return Messages::tr(
        "Nothing was changed. Try again; if it happens again, the details tell an administrator "
        "where to look.");
}

/// `said` contains one of the words that a full disk, a missing right, ... leave behind.
bool says(const QString& said, std::initializer_list<const char*> words) {
    for (const char* word : words)
        if (said.contains(word, Qt::CaseInsensitive)) return true;
    return false;
}

/// The way out where the operating system's reason is plain; else `otherwise`.
QString file_way_out(const QString& said, const QString& otherwise) {
    if (says(said, {"no space left", "disk is full", "SQLITE_FULL", "database or disk is full"}))
        return Messages::tr("The disk is full: make room, then try again.");
    if (says(said, {"permission denied", "readonly", "read-only", "may be written"}))
        return Messages::tr(
            "You may not write there: choose another folder, or ask an "
            "administrator.");
    if (says(said, {"no such file", "does not exist", "no such backup"}))
        return Messages::tr("The file or folder is not there any more: choose another one.");
    return otherwise;
}

void describe_store(const db::StoreError& error, const QString& doing, Problem& problem) {
    using Kind = db::StoreError::Kind;
    const QString words = error.said() == nullptr ? QString() : reports::said_words(*error.said());
    switch (error.kind()) {
        case Kind::kLocked:
            problem.title = Messages::tr("The store is locked by another program.");
            problem.way_out = Messages::tr("Close the other program, or wait and try again.");
            return;
        case Kind::kDamaged:
            problem.title = Messages::tr("A file is damaged and was left as it is.");
            problem.way_out = Messages::tr("Restore a backup; nothing has been overwritten.");
            return;
        case Kind::kMissing:
            problem.title = Messages::tr("The store is not where it was.");
            problem.way_out = Messages::tr("Restore a backup, or show where the store is now.");
            return;
        case Kind::kTooNew:
            problem.title = Messages::tr("This file was written by a newer Placode.");
            problem.way_out = Messages::tr("Update Placode on this machine.");
            return;
        case Kind::kUnavailable:
            problem.title = Messages::tr("The store cannot be reached.");
            problem.way_out = file_way_out(
                problem.detail,
                Messages::tr("Is its disk or its server there? Then try again; else tell an "
                             "administrator."));
            return;
        case Kind::kRefused:
            problem.title = Messages::tr("This was refused.");
            problem.way_out = words.isEmpty() ? nothing_lost() : words;
            return;
        case Kind::kConflict:
            problem.title = Messages::tr("This is taken, or was done already.");
            problem.way_out = words.isEmpty() ? Messages::tr(
                                                    "Look at the page again, then choose "
                                                    "another name or number.")
                                              : words;
            return;
        case Kind::kNotFound:
            problem.title = Messages::tr("This is not there any more.");
            problem.way_out = words.isEmpty() ? Messages::tr("Open the page again.") : words;
            return;
        case Kind::kOlder:
        case Kind::kOther:
            break;
    }
    problem.title = Messages::tr("%1 did not work.").arg(doing);
    problem.way_out = file_way_out(problem.detail, nothing_lost());
}

QString launch_way_out(LaunchError::Kind kind) {
    switch (kind) {
        case LaunchError::Kind::kBusy:
            return Messages::tr("One is still running: close its window first.");
        case LaunchError::Kind::kMissing:
            return Messages::tr(
                "A part of Placode is missing on this computer: install Placode again, or tell an "
                "administrator.");
        case LaunchError::Kind::kFailed:
            break;
    }
    return Messages::tr("Restart the computer and try again, or tell an administrator.");
}

/// What has to be there for a device, by name.
QString device_way_out(const QString& device) {
    if (device.startsWith("spacemouse"))
        return Messages::tr(
            "Switch the SpaceMouse on. Its driver, spacenavd, has to be installed and running.");
    if (device.startsWith("openhaptics"))
        return Messages::tr(
            "Plug the arm in and switch it on. OpenHaptics and the Touch driver of 3D Systems have "
            "to be installed.");
    if (device.startsWith("haply"))
        return Messages::tr(
            "Plug the Inverse3 in and switch it on. The Haply Inverse service has to be running.");
    if (device.startsWith("avatar"))
        return Messages::tr(
            "Plug the Haptic Avatar in and switch it on. Your account has to belong to the group "
            "dialout.");
    if (device.startsWith("forcedimension"))
        return Messages::tr(
            "Plug the device in and switch it on. The libraries of the Force Dimension SDK have to "
            "be installed.");
    if (device.startsWith("gamepad"))
        return Messages::tr("Plug a gamepad in, or switch it on and pair it.");
    if (device.startsWith("pedals"))
        return Messages::tr("Plug the pedals in. Your account has to belong to the group input.");
    return Messages::tr("Choose another device, or connect it and try again.");
}

/// Of the simulator's complaints those that a person can mend; empty for the others.
QString simulator_way_out(const QString& said) {
    if (says(said, {"no display to open a window", "cannot draw off-screen"}))
        return Messages::tr(
            "It found no screen to open its window on: start Placode from the "
            "desktop of this computer.");
    if (says(said, {"OpenGL 3.3", "graphics driver"}))
        return Messages::tr(
            "The graphics of this computer are too old or have no driver: install "
            "the graphics driver.");
    if (says(said, {"no space left", "disk is full"}))
        return Messages::tr("The disk is full: make room, then try again.");
    if (says(said, {"bad_alloc", "not enough memory", "out of memory"}))
        return Messages::tr("There is not enough memory: close other programs, then try again.");
    if (says(said, {"font "}))
        return Messages::tr("A font is missing: install the package fonts-dejavu-core.");
    return {};
}

/// What sound and graphics libraries print whether or not anything fails: it explains nothing.
QString without_chatter(const QString& said) {
    static const QRegularExpression kChatter(
        "^\\s*(ALSA lib |AL lib: |\\[ALSOFT\\]|JackShm|jack server|Cannot connect to server|"
        "Expression '.*' failed in|libEGL |libGL |MESA|Xlib: |Fontconfig |dbus\\[|"
        "PulseAudio: |pw\\.|\\[[EW]\\]\\[[0-9:.]+\\] )");
    QStringList kept;
    for (const QString& line : said.split('\n'))
        if (!kChatter.match(line).hasMatch() && (kept.isEmpty() || kept.last() != line))
            kept << line;
    return kept.join('\n').trimmed();
}

bool is_device_trouble(const ProgramEnd& end) {
    if (end.device.isEmpty() || end.exit_code != 2) return false;
    return says(end.said, {"device \"", "--list-devices", "unknown device"}) ||
           end.said.contains(end.device.section(':', 0, 0) + ":");
}

}  // namespace

Problem problem_of(const std::exception_ptr& error, const QString& doing) {
    Problem problem;
    problem.title = Messages::tr("%1 did not work.").arg(doing);
    problem.way_out = nothing_lost();
    const auto take = [&](const std::exception& e) {
        problem.detail = QString::fromUtf8(e.what());
    };
    try {
        std::rethrow_exception(error);
    } catch (const Refusal& e) {
        problem = {QString::fromUtf8(e.what()), {}, {}, false};
    } catch (const db::StoreError& e) {
        take(e);
        describe_store(e, doing, problem);
    } catch (const curriculum::DefinitionError& e) {
        take(e);
        problem.title = Messages::tr("A definition file cannot be used.");
        problem.way_out = Messages::tr("Correct the file at the place named, then try again.");
        problem.open_details = true;
    } catch (const reports::PeopleFileError& e) {
        take(e);
        problem.title = Messages::tr("The list of people cannot be used; nobody was added.");
        problem.way_out = Messages::tr("Correct the line named below, then choose the file again.");
        problem.open_details = true;
    } catch (const haptics::DeviceError& e) {
        take(e);
        problem = device_problem({}, problem.detail);
        problem.open_details = says(problem.detail, {"expected", "unknown key"});
    } catch (const LaunchError& e) {
        take(e);
        problem.title = Messages::tr("The simulator could not be started.");
        problem.way_out = launch_way_out(e.kind());
    } catch (const reports::ReportError& e) {
        take(e);
        problem.way_out = file_way_out(
            problem.detail, Messages::tr("Choose another folder or file name, then try again."));
    } catch (const std::filesystem::filesystem_error& e) {
        take(e);
        problem.way_out = file_way_out(problem.detail, problem.way_out);
    } catch (const std::bad_alloc& e) {
        take(e);
        problem.way_out =
            Messages::tr("There is not enough memory: close other programs, then try again.");
    } catch (const std::invalid_argument& e) {
        take(e);  // Statistics: too few values, a constant column.
        problem.way_out = Messages::tr("The data that are there do not allow it.");
        problem.open_details = true;
    } catch (const std::exception& e) {
        take(e);
        problem.way_out = file_way_out(problem.detail, problem.way_out);
    }
    return problem;
}

Problem device_problem(const QString& device, const QString& said) {
    return {device.isEmpty()
                ? Messages::tr("The device cannot be used.")
                : Messages::tr("%1 cannot be used here.").arg(device_name(device.toStdString())),
            device_way_out(device), without_chatter(said), false};
}

Problem simulator_problem(const ProgramEnd& end) {
    if (is_device_trouble(end)) {
        Problem problem = device_problem(end.device, end.said);
        problem.title = Messages::tr("The attempt could not be started.") + " " + problem.title;
        return problem;
    }
    Problem problem;
    problem.detail = without_chatter(end.said);
    if (end.crashed || end.exit_code != 0)
        problem.detail +=
            (problem.detail.isEmpty() ? "" : "\n") +
            QString(end.crashed ? "placode-sim: ended by signal %1" : "placode-sim: exit status %1")
                .arg(end.exit_code);
    problem.way_out = simulator_way_out(end.said);
    const bool known = !problem.way_out.isEmpty();
    if (end.device.isEmpty()) {
        problem.title = Messages::tr("The replay ended with a problem.");
        if (!known) problem.way_out = Messages::tr("The recording and its score are untouched.");
    } else if (!end.began) {
        problem.title = Messages::tr("The attempt could not be started.");
        if (!known) problem.way_out = Messages::tr("Choose another device or try again.");
    } else {
        problem.title = Messages::tr("The simulator ended unexpectedly.");
        const QString kept =
            Messages::tr("What was recorded is kept and can be saved as interrupted.");
        problem.way_out = known ? problem.way_out + " " + kept : kept;
    }
    return problem;
}

Problem recording_problem(const db::StoreError& error) {
    return {error.said() == nullptr ? Messages::tr("The recording is damaged and cannot be scored.")
                                    : reports::said_words(*error.said()),
            {},
            QString::fromUtf8(error.what()),
            false};
}

Problem damaged_part(const QString& damage) {
    return {Messages::tr("A part of the recording is damaged; what is whole can be saved."),
            {},
            damage,
            false};
}

Problem health_problem(const QString& line) {
    Problem problem;
    problem.detail = line;
    static const QRegularExpression kAttempt("the recording of attempt (\\d+) is damaged");
    static const QRegularExpression kAudit("audit: entry (\\d+)");
    static const QRegularExpression kSeal("^seals: (.*?)( was .*| more objects)$");
    static const QRegularExpression kForeign("^schema: it holds (.*), which Placode did not make");
    if (const auto attempt = kAttempt.match(line); attempt.hasMatch()) {
        problem.title =
            Messages::tr("The recording of attempt %1 is damaged.").arg(attempt.captured(1));
        problem.way_out =
            Messages::tr("Its score stays; it cannot be watched. A backup may hold it whole.");
    } else if (line.contains("which no other one trusts")) {
        problem.title =
            Messages::tr("A computer that nobody has vouched for wrote into the store.");
        problem.way_out = Messages::tr(
            "If it is one of yours, an administrator vouches for it with `placodectl station "
            "trust`. If not, ask who had access.");
    } else if (const auto entry = kAudit.match(line); entry.hasMatch()) {
        problem.title = Messages::tr("The audit list was changed from outside, near entry %1.")
                            .arg(entry.captured(1));
        problem.way_out = Messages::tr(
            "Ask who had access to the file or the server, and compare "
            "with a backup.");
    } else if (line.contains("this computer wrote entry")) {
        problem.title = Messages::tr("The end of the audit list is missing.");
        problem.way_out = Messages::tr(
            "It was cut off, or an older copy was put in the store's place by hand. Compare with a "
            "backup.");
    } else if (const auto sealed = kSeal.match(line); sealed.hasMatch()) {
        problem.title = Messages::tr("Data was changed from outside: %1.").arg(sealed.captured(1));
        problem.way_out = Messages::tr(
            "Ask who had access to the file or the server, and compare "
            "with a backup.");
    } else if (const auto foreign = kForeign.match(line); foreign.hasMatch()) {
        problem.title = Messages::tr("The store holds what Placode did not put there: %1.")
                            .arg(foreign.captured(1));
        problem.way_out = Messages::tr(
            "Ask who put it there and have it taken out: until then the store is neither backed up "
            "nor updated.");
    } else {
        problem.title = Messages::tr("The file of the store is damaged.");
        problem.way_out =
            Messages::tr("Make a copy of it now, then restore the last backup that is sound.");
    }
    return problem;
}

}  // namespace placode::ui
