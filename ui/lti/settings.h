// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One file says with which learning platforms this centre works, by which keys, and who is who:
// the portal lets people in by it, and placodectl sends their grades.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ui/lti/secret_file.h"

namespace placode::lti {

/// Somebody on a platform and their account here. Both id and log-in name have to fit: an id alone
/// could be mistyped, and a name may belong to somebody else one day.
struct Link {
    std::string subject;  ///< `sub`
    int64_t account = 0;
    std::string login;
};

enum class Take : uint8_t { kBest, kLatest };

/// A column of a platform's gradebook that the scores of a task go to.
struct LineItem {
    std::string task, address;
    Take take = Take::kBest;
};

struct Platform {
    std::string issuer, client_id;
    std::vector<std::string> deployment_ids;
    std::string authorization_url, token_url;
    std::string token_audience;       ///< Of the tool's own tokens; token_url where none is given.
    std::string keys_url, keys_file;  ///< One of them.
    std::vector<Link> links;
    std::vector<LineItem> line_items;

    [[nodiscard]] const Link* link_of(const std::string& subject) const;
};

struct Settings {
    std::string file;      ///< Where they stood.
    std::string tool_url;  ///< Of the portal as browsers see it, without '/' at its end.
    std::string private_key_file;
    std::vector<Platform> platforms;

    /// @param client_id empty: whichever; null where there is none or there are several.
    [[nodiscard]] const Platform* platform(const std::string& issuer,
                                           const std::string& client_id) const;
    [[nodiscard]] std::string launch_url() const { return tool_url + "/lti/launch"; }
};

/// Everything is checked: what is unknown, missing, twice, no https or open to others is refused.
/// Throws SettingsError naming the file, the place in it, what was found and what is expected.
[[nodiscard]] Settings read_settings(const std::string& file);

/// Writes the file anew with the link, in the place of one with the same `sub`. Throws
/// SettingsError; the file is then as it was.
void add_link(const std::string& file, const std::string& issuer, const std::string& client_id,
              const Link& link);
/// The link that went; nullopt where there was none.
[[nodiscard]] std::optional<Link> remove_link(const std::string& file, const std::string& issuer,
                                              const std::string& client_id,
                                              const std::string& subject);

}  // namespace placode::lti
