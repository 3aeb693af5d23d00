// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lti/settings.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "ui/lti/web_client.h"

namespace placode::lti {
namespace {

using OrderedJson = nlohmann::ordered_json;

/// A place in the file, for what is said of it.
struct Place {
    const OrderedJson& json;
    std::string file, pointer;

    [[noreturn]] void refuse(const std::string& why) const {
        throw SettingsError(file + ": " + (pointer.empty() ? "/" : pointer) + ": " + why);
    }
    [[nodiscard]] Place at(const std::string& key) const {
        const auto found = json.find(key);
        if (found == json.end()) refuse("\"" + key + "\" is missing");
        return {*found, file, pointer + "/" + key};
    }
    [[nodiscard]] bool has(const std::string& key) const { return json.contains(key); }
    /// An object with these members and no others.
    void only(const std::vector<std::string>& known) const {
        if (!json.is_object()) refuse("is no object");
        for (const auto& [key, value] : json.items())
            if (std::find(known.begin(), known.end(), key) == known.end())
                refuse("\"" + key + "\" is unknown");
    }
    [[nodiscard]] std::string text() const {
        const std::string value = json.is_string() ? json.get<std::string>() : std::string();
        if (value.empty() || value.size() > 500) refuse("expected a text of 1 to 500 letters");
        return value;
    }
    [[nodiscard]] std::string url() const {
        try {
            (void)parse_web_address(text());
        } catch (const std::invalid_argument& error) {
            refuse(error.what());
        }
        return text();
    }
    /// From where the settings lie.
    [[nodiscard]] std::string path() const {
        return (std::filesystem::path(file).parent_path() / text()).string();
    }
    [[nodiscard]] std::vector<Place> list() const {
        if (!json.is_array()) refuse("expected a list");
        std::vector<Place> all;
        for (size_t i = 0; i < json.size(); ++i)
            all.push_back({json[i], file, pointer + "/" + std::to_string(i)});
        return all;
    }
};

Link read_link(const Place& place) {
    place.only({"sub", "account", "login"});
    Link link{place.at("sub").text(), 0, place.at("login").text()};
    const Place account = place.at("account");
    if (account.json.is_number_integer()) link.account = account.json.get<int64_t>();
    if (link.account <= 0) account.refuse("expected the number of an account");
    return link;
}

LineItem read_line_item(const Place& place) {
    place.only({"task", "url", "take"});
    LineItem item{place.at("task").text(), place.at("url").url(), Take::kBest};
    const std::string take = place.has("take") ? place.at("take").text() : "best";
    if (take != "best" && take != "latest") place.at("take").refuse("expected best or latest");
    if (take == "latest") item.take = Take::kLatest;
    return item;
}

void read_links(const Place& place, Platform& platform) {
    std::set<std::string> subjects;
    std::set<int64_t> accounts;
    for (const Place& each : place.list()) {
        platform.links.push_back(read_link(each));
        if (!subjects.insert(platform.links.back().subject).second)
            each.refuse("this sub is there twice");
        // Two people who share an account would get each other's grades.
        if (!accounts.insert(platform.links.back().account).second)
            each.refuse("this account is there twice");
    }
}

Platform read_platform(const Place& place) {
    place.only({"issuer", "client_id", "deployment_ids", "authorization_url", "token_url",
                "token_audience", "jwks_url", "jwks_file", "links", "line_items"});
    Platform platform;
    platform.issuer = place.at("issuer").text();
    platform.client_id = place.at("client_id").text();
    for (const Place& each : place.at("deployment_ids").list())
        platform.deployment_ids.push_back(each.text());
    if (platform.deployment_ids.empty()) place.at("deployment_ids").refuse("expected at least one");
    platform.authorization_url = place.at("authorization_url").url();
    platform.token_url = place.at("token_url").url();
    platform.token_audience =
        place.has("token_audience") ? place.at("token_audience").text() : platform.token_url;
    if (place.has("jwks_url") == place.has("jwks_file"))
        place.refuse("expected either jwks_url or jwks_file");
    if (place.has("jwks_url")) platform.keys_url = place.at("jwks_url").url();
    if (place.has("jwks_file")) platform.keys_file = place.at("jwks_file").path();
    if (place.has("links")) read_links(place.at("links"), platform);
    if (place.has("line_items"))
        for (const Place& each : place.at("line_items").list())
            platform.line_items.push_back(read_line_item(each));
    return platform;
}

Settings settings_of(const OrderedJson& json, const std::string& file) {
    const Place root{json, file, ""};
    root.only({"version", "tool_url", "private_key_file", "platforms"});
    if (root.at("version").json != 1) root.at("version").refuse("expected 1");
    Settings settings;
    settings.file = file;
    settings.tool_url = root.at("tool_url").url();
    while (settings.tool_url.ends_with('/')) settings.tool_url.pop_back();
    if (parse_web_address(settings.tool_url).target != "/")
        root.at("tool_url").refuse("expected a host of its own, without a path");
    settings.private_key_file = root.at("private_key_file").path();
    std::set<std::pair<std::string, std::string>> known;
    for (const Place& each : root.at("platforms").list()) {
        settings.platforms.push_back(read_platform(each));
        const Platform& last = settings.platforms.back();
        if (!known.emplace(last.issuer, last.client_id).second)
            each.refuse("this issuer and client_id are there twice");
    }
    return settings;
}

OrderedJson json_of(const std::string& file) {
    const std::string text = read_settings_text(file);
    try {
        return OrderedJson::parse(text);
    } catch (const OrderedJson::parse_error& error) {
        throw SettingsError(file + ": is no JSON: byte " + std::to_string(error.byte));
    } catch (const OrderedJson::out_of_range&) {
        throw SettingsError(file + ": holds a number beyond 1.7e308");
    }
}

/// The place of a platform in the file.
size_t index_of(const Settings& settings, const std::string& issuer, const std::string& client_id) {
    const Platform* found = settings.platform(issuer, client_id);
    if (found == nullptr)
        throw SettingsError(settings.file + ": holds no platform \"" + issuer +
                            "\" with the client_id \"" + client_id +
                            "\", or several without one to choose by");
    return static_cast<size_t>(found - settings.platforms.data());
}

/// Where the link of `subject` stands in the file, else the size of the list.
size_t index_of(const Platform& platform, const std::string& subject) {
    const Link* found = platform.link_of(subject);
    return found == nullptr ? platform.links.size()
                            : static_cast<size_t>(found - platform.links.data());
}

void keep(const std::string& file, const OrderedJson& json) {
    (void)settings_of(json, file);
    replace_text(file, json.dump(2) + "\n");
}

}  // namespace

const Link* Platform::link_of(const std::string& subject) const {
    for (const Link& each : links)
        if (each.subject == subject) return &each;
    return nullptr;
}

const Platform* Settings::platform(const std::string& issuer, const std::string& client_id) const {
    const Platform* found = nullptr;
    for (const Platform& each : platforms) {
        if (each.issuer != issuer || (!client_id.empty() && each.client_id != client_id)) continue;
        if (found != nullptr) return nullptr;
        found = &each;
    }
    return found;
}

Settings read_settings(const std::string& file) { return settings_of(json_of(file), file); }

void add_link(const std::string& file, const std::string& issuer, const std::string& client_id,
              const Link& link) {
    OrderedJson json = json_of(file);
    const Settings settings = settings_of(json, file);
    const size_t which = index_of(settings, issuer, client_id);
    OrderedJson& links = json["platforms"][which]["links"];
    if (links.is_null()) links = OrderedJson::array();
    links[index_of(settings.platforms[which], link.subject)] = {
        {"sub", link.subject}, {"account", link.account}, {"login", link.login}};
    keep(file, json);
}

std::optional<Link> remove_link(const std::string& file, const std::string& issuer,
                                const std::string& client_id, const std::string& subject) {
    OrderedJson json = json_of(file);
    const Settings settings = settings_of(json, file);
    const size_t which = index_of(settings, issuer, client_id);
    const size_t at = index_of(settings.platforms[which], subject);
    if (at == settings.platforms[which].links.size()) return std::nullopt;
    json["platforms"][which]["links"].erase(at);
    keep(file, json);
    return settings.platforms[which].links[at];
}

}  // namespace placode::lti
