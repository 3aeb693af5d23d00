// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Sending with patience: a server that is busy or away is asked again.

#include "ui/lti/web_client.h"

namespace placode::lti {

struct Patience {
    int tries = 3;
    double wait_s = 2;  ///< Before the second try; twice as long before each further one.
};

/// As ask(), again where nothing came back or the server says that it is busy (429, 5xx). A server
/// that names a time is given it, up to 30 s.
[[nodiscard]] WebReply ask_patiently(const WebCall& call, const Patience& patience);

/// "the server answered 403", "it cannot be reached", never what was sent.
[[nodiscard]] std::string problem_of(const WebReply& reply);

}  // namespace placode::lti
