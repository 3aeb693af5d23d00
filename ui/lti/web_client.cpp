// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lti/web_client.h"

#include <httplib.h>

#include <QByteArray>
#include <algorithm>
#include <charconv>
#include <csignal>
#include <memory>
#include <stdexcept>

namespace placode::lti {
namespace {

constexpr size_t kLargestReply = 256 * 1024;

[[noreturn]] void refuse(const std::string& text, const std::string& why) {
    throw std::invalid_argument("\"" + text + "\" " + why);
}

int number_of(const std::string& words, int otherwise) {
    int value = 0;
    const char* end = words.data() + words.size();
    const auto [rest, error] = std::from_chars(words.data(), end, value);
    return error == std::errc{} && rest == end ? value : otherwise;
}

void split_port(const std::string& text, std::string authority, WebAddress& address) {
    std::string port;
    const size_t bracket = authority.find(']');
    const size_t colon = authority.find(':', bracket == std::string::npos ? 0 : bracket);
    if (colon != std::string::npos) {
        port = authority.substr(colon + 1);
        authority.resize(colon);
        address.port = number_of(port, 0);
        if (address.port < 1 || address.port > 65535) refuse(text, "has no such port");
    }
    if (authority.size() > 2 && authority.front() == '[' && authority.back() == ']')
        authority = authority.substr(1, authority.size() - 2);
    else if (authority.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                         "0123456789.-") != std::string::npos)
        refuse(text, "names no host");
    if (authority.empty()) refuse(text, "names no host");
    address.host = authority;
}

std::unique_ptr<httplib::Client> client_of(const WebAddress& address) {
    const std::string host =
        address.host.find(':') == std::string::npos ? address.host : "[" + address.host + "]";
    auto client = std::make_unique<httplib::Client>((address.tls ? "https://" : "http://") + host +
                                                    ":" + std::to_string(address.port));
    client->set_connection_timeout(5);
    client->set_read_timeout(10);
    client->set_write_timeout(10);
    client->set_follow_location(false);
    client->enable_server_certificate_verification(true);
    return client;
}

std::string problem_of(httplib::Error error) {
    switch (error) {
        case httplib::Error::SSLConnection:
        case httplib::Error::SSLLoadingCerts:
        case httplib::Error::SSLServerVerification:
            return "its certificate is not trusted on this computer, or it speaks no TLS";
        case httplib::Error::Canceled:
            return "its answer is longer than 256 kB";
        case httplib::Error::Connection:
        case httplib::Error::ConnectionTimeout:
            return "it cannot be reached";
        default:
            return "the connection broke (" + httplib::to_string(error) + ")";
    }
}

}  // namespace

WebAddress parse_web_address(const std::string& text) {
    WebAddress address;
    if (std::any_of(text.begin(), text.end(), [](char c) {
            return static_cast<unsigned char>(c) <= 0x20 || static_cast<unsigned char>(c) >= 0x7f;
        }))
        refuse(text, "holds a space or a letter that no address has");
    const bool https = text.starts_with("https://");
    if (!https && !text.starts_with("http://")) refuse(text, "does not begin with https://");
    if (text.find('#') != std::string::npos) refuse(text, "has a part behind #");
    address.tls = https;
    address.port = https ? 443 : 80;
    const size_t begin = https ? 8 : 7;
    const size_t end = std::min(text.find_first_of("/?", begin), text.size());
    const std::string authority = text.substr(begin, end - begin);
    if (authority.find('@') != std::string::npos) refuse("...", "names a user");
    split_port(text, authority, address);
    address.target = text.substr(end);
    if (address.target.empty() || address.target[0] != '/') address.target.insert(0, "/");
    const bool here =
        address.host == "127.0.0.1" || address.host == "localhost" || address.host == "::1";
    if (!https && !here) refuse(text, "is open on the network; expected https://");
    return address;
}

WebReply ask(const WebCall& call) {
    const WebAddress address = parse_web_address(call.address);
    // A peer that closes while something is written to it must not end the program.
    [[maybe_unused]] static const auto before = std::signal(SIGPIPE, SIG_IGN);
    const auto client = client_of(address);
    httplib::Request request;
    request.method = call.method;
    request.path = address.target;
    request.body = call.body;
    for (const auto& [name, value] : call.headers) request.headers.emplace(name, value);
    if (!call.type.empty()) request.headers.emplace("Content-Type", call.type);
    WebReply reply;
    request.content_receiver = [&reply](const char* data, size_t length, uint64_t, uint64_t) {
        if (reply.body.size() + length > kLargestReply) return false;
        reply.body.append(data, length);
        return true;
    };
    const httplib::Result result = client->send(request);
    if (!result) {
        reply.problem = problem_of(result.error());
        return reply;
    }
    reply.status = result->status;
    reply.retry_after_s = number_of(result->get_header_value("Retry-After"), 0);
    return reply;
}

std::string form_text(const std::vector<std::pair<std::string, std::string>>& parts) {
    const auto encoded = [](const std::string& text) {
        return QByteArray::fromStdString(text).toPercentEncoding().toStdString();
    };
    std::string all;
    for (const auto& [key, value] : parts)
        all += (all.empty() ? "" : "&") + encoded(key) + "=" + encoded(value);
    return all;
}

}  // namespace placode::lti
