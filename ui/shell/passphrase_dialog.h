// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Asks for the passphrase of the centre's key, over the page that needs it, and says for what.

#include <QString>
#include <functional>
#include <string_view>

class QWidget;

namespace placode::ui {

class AppContext;

struct PassphraseQuestion {
    QString purpose;      ///< A sentence: what the key is about to do.
    QString verb;         ///< On the button that does it.
    bool is_new = false;  ///< Chosen now, and so typed twice.
};

/// Asks until `use` has taken the passphrase, as often as it takes: what `use` throws is said in
/// the dialog, which stays. False: the user gave up, and nothing was done. Main thread.
[[nodiscard]] bool ask_passphrase(AppContext& context, QWidget* parent,
                                  const PassphraseQuestion& question,
                                  const std::function<void(std::string_view)>& use);

/// The same for the centre's key of the open store: a new passphrase where there is no key yet or
/// an earlier version kept it in clear, else the one that it has.
[[nodiscard]] bool ask_centre_passphrase(AppContext& context, QWidget* parent,
                                         const std::function<void(std::string_view)>& use);

}  // namespace placode::ui
