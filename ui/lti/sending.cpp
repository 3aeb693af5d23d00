// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lti/sending.h"

#include <algorithm>
#include <chrono>
#include <thread>

namespace placode::lti {

WebReply ask_patiently(const WebCall& call, const Patience& patience) {
    double wait_s = patience.wait_s;
    for (int left = patience.tries;; --left, wait_s *= 2) {
        WebReply reply = ask(call);
        const bool busy = reply.status == 0 || reply.status == 429 || reply.status >= 500;
        if (!busy || left <= 1) return reply;
        const double asked = std::clamp<double>(reply.retry_after_s, 0, 30);
        std::this_thread::sleep_for(std::chrono::duration<double>(std::max(wait_s, asked)));
    }
}

std::string problem_of(const WebReply& reply) {
    return reply.status == 0 ? reply.problem
                             : "the server answered " + std::to_string(reply.status);
}

}  // namespace placode::lti
