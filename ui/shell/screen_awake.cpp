// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/screen_awake.h"

#include <QDBusConnection>
#include <QDBusMessage>
#include <QDBusPendingCallWatcher>
#include <QFile>
#include <optional>
#include <utility>

namespace placode::ui {

namespace {

/// Without one, asking for it would start one.
bool has_session_bus() {
    return qEnvironmentVariableIsSet("DBUS_SESSION_BUS_ADDRESS") ||
           QFile::exists(qEnvironmentVariable("XDG_RUNTIME_DIR") + "/bus");
}

}  // namespace

struct ScreenAwake::Wish {
    bool over = false;
    std::optional<uint> cookie;  ///< By which it is taken back, once the desktop has answered.
};

ScreenAwake::Call ScreenAwake::desktop() {
    return [](const QString& method, const QVariantList& arguments, const Answered& answered) {
        if (!has_session_bus()) return;
        QDBusMessage message = QDBusMessage::createMethodCall(
            "org.freedesktop.ScreenSaver", "/org/freedesktop/ScreenSaver",
            "org.freedesktop.ScreenSaver", method);
        message.setArguments(arguments);
        const QDBusPendingCall call = QDBusConnection::sessionBus().asyncCall(message);
        if (!answered) return;
        auto* watcher = new QDBusPendingCallWatcher(call);
        QObject::connect(watcher, &QDBusPendingCallWatcher::finished, watcher, [=] {
            const QDBusMessage reply = watcher->reply();
            watcher->deleteLater();
            if (reply.type() == QDBusMessage::ReplyMessage && !reply.arguments().isEmpty())
                answered(reply.arguments().first());
        });
    };
}

ScreenAwake::ScreenAwake(Call call) : call_(std::move(call)) {}

ScreenAwake::~ScreenAwake() { release(); }

void ScreenAwake::keep(const QString& reason) {
    if (wish_) return;
    wish_ = std::make_shared<Wish>();
    call_("Inhibit", {"Placode", reason}, [wish = wish_, call = call_](const QVariant& cookie) {
        wish->cookie = cookie.toUInt();
        // It was over before the desktop answered.
        if (wish->over) call("UnInhibit", {*wish->cookie}, nullptr);
    });
}

void ScreenAwake::release() {
    if (!wish_) return;
    wish_->over = true;
    if (wish_->cookie) call_("UnInhibit", {*wish_->cookie}, nullptr);
    wish_.reset();
}

}  // namespace placode::ui
