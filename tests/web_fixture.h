// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A portal on a free port of this computer, and a browser that keeps cookies and runs no script.

#include <httplib.h>
#undef _res  // A macro of resolv.h, which httplib includes, and a parameter in Eigen.

#include <QCryptographicHash>
#include <QGuiApplication>
#include <QSqlRecord>
#include <atomic>
#include <map>
#include <thread>

#include "tests/rights_world.h"
#include "ui/web/web_server.h"

namespace placode::test {

// Pictures are drawn with fonts.
inline const bool draws = [] {
    ::setenv("QT_QPA_PLATFORM", "offscreen", 1);
    World::make = [](int& argc, char** argv) -> std::unique_ptr<QCoreApplication> {
        return std::make_unique<QGuiApplication>(argc, argv);
    };
    return true;
}();

class PortalAtWork {
 public:
    explicit PortalAtWork(web::PortalOptions options, const web::ServerLimits& limits = {})
        : server_(std::move(options), limits), port_(server_.bind({"127.0.0.1", 0, ""})) {
        thread_ = std::thread([this] { server_.serve(); });
        while (!server_.ready()) std::this_thread::yield();
    }
    ~PortalAtWork() {
        server_.stop();
        thread_.join();
    }
    PortalAtWork(const PortalAtWork&) = delete;
    PortalAtWork& operator=(const PortalAtWork&) = delete;
    [[nodiscard]] int port() const { return port_; }

 private:
    web::WebServer server_;
    int port_;
    std::thread thread_;
};

/// What came back; status 0: nothing did.
struct Seen {
    int status = 0;
    std::string body;
    httplib::Headers headers;
    [[nodiscard]] std::string header(const std::string& name) const {
        const auto found = headers.find(name);
        return found == headers.end() ? std::string() : found->second;
    }
    [[nodiscard]] bool shows(const std::string& words) const {
        return body.find(words) != std::string::npos;
    }
};

class Browser {
 public:
    explicit Browser(int port) : client_("127.0.0.1", port) { client_.set_read_timeout(60); }

    Seen get(const std::string& path) { return keep(client_.Get(path, headers())); }
    Seen post(const std::string& path, const httplib::Params& form) {
        return keep(client_.Post(path, headers(), form));
    }
    Seen send(const std::string& method, const std::string& path) {
        httplib::Request request;
        request.method = method;
        request.path = path;
        request.headers = headers();
        request.body = "x=1";
        return keep(client_.send(request));
    }
    Seen sign_in(const std::string& login, const std::string& password = kPassword) {
        const std::string token = token_of(get("/sign-in").body);
        return post("/sign-in", {{"form_token", token}, {"login", login}, {"password", password}});
    }
    /// Of the first form of a page.
    static std::string token_of(const std::string& body) {
        const std::string before = "name=\"form_token\" value=\"";
        const size_t at = body.find(before);
        if (at == std::string::npos) return {};
        return body.substr(at + before.size(),
                           body.find('"', at + before.size()) - at - before.size());
    }
    std::map<std::string, std::string> cookies;
    std::string languages;  ///< Accept-Language; empty: the browser says nothing.

 private:
    [[nodiscard]] httplib::Headers headers() const {
        std::string line;
        for (const auto& [name, value] : cookies)
            line += (line.empty() ? "" : "; ") + name + "=" + value;
        httplib::Headers all;
        if (!line.empty()) all.emplace("Cookie", line);
        if (!languages.empty()) all.emplace("Accept-Language", languages);
        return all;
    }
    Seen keep(const httplib::Result& result) {
        if (!result) return {};
        for (const auto& [name, line] : result->headers) {
            if (name != "Set-Cookie") continue;
            const size_t equals = line.find('=');
            const std::string value = line.substr(equals + 1, line.find(';') - equals - 1);
            if (value.empty())
                cookies.erase(line.substr(0, equals));
            else
                cookies[line.substr(0, equals)] = value;
        }
        return {result->status, result->body, result->headers};
    }

    httplib::Client client_;
};

/// A store with the people of RightsWorld and a portal over it.
class WebTest : public EngineTest {
 protected:
    void ready() override {
        const auto store = open();
        people.fill(*store, folder);
        portal = start();
    }
    [[nodiscard]] std::unique_ptr<PortalAtWork> start(const web::ServerLimits& limits = {},
                                                      bool behind_tls = false) {
        web::PortalOptions portal_options;
        // As it is set up: with a station's log-in, to which the server believes nothing.
        portal_options.store_url =
            is_sqlite() ? url() : World::get().server().station_url(database);
        portal_options.store.station = !is_sqlite();
        portal_options.store.cheap_passwords = true;
        portal_options.behind_tls = behind_tls;
        portal_options.now_s = [this] { return now_s.load(); };
        portal_options.log = [](const std::string& line) { std::cerr << line << '\n'; };
        arrange(portal_options);
        return std::make_unique<PortalAtWork>(std::move(portal_options), limits);
    }
    /// What a test wants otherwise.
    virtual void arrange(web::PortalOptions&) {}
    void TearDown() override {
        portal.reset();
        EngineTest::TearDown();
    }
    [[nodiscard]] Browser browser() const { return Browser(portal->port()); }
    [[nodiscard]] Browser signed_in(const std::string& login) const {
        Browser one = browser();
        EXPECT_EQ(one.sign_in(login).status, 303) << login;
        return one;
    }

    /// Of every table that is there, whatever is in it.
    [[nodiscard]] std::string checksum_of_the_store() const {
        RawConnection connection = raw();
        QSqlQuery tables(connection.handle());
        tables.exec(is_sqlite() ? "SELECT name FROM sqlite_schema WHERE type = 'table' ORDER BY 1"
                                : "SELECT table_name FROM information_schema.tables WHERE "
                                  "table_schema = current_schema() ORDER BY 1");
        std::vector<QString> names;
        while (tables.next()) names.push_back(tables.value(0).toString());
        EXPECT_GT(names.size(), 10U);
        QCryptographicHash hash(QCryptographicHash::Sha256);
        for (const QString& name : names) {
            QSqlQuery rows(connection.handle());
            EXPECT_TRUE(rows.exec("SELECT * FROM " + name + " ORDER BY 1")) << name.toStdString();
            while (rows.next())
                for (int i = 0; i < rows.record().count(); ++i)
                    hash.addData(name.toUtf8() + '\n' + rows.value(i).toByteArray() + '\n');
        }
        return hash.result().toHex().toStdString();
    }

    RightsWorld people;
    std::unique_ptr<PortalAtWork> portal;
    std::atomic<int64_t> now_s{1000};
};

}  // namespace placode::test
