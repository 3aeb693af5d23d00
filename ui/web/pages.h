// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The pages, one file for each matter. A page reads a store that was opened for whoever asks and
// for reading only; what that person may not see, the store refuses.

#include <map>
#include <mutex>
#include <stdexcept>
#include <string>
#include <vector>

#include "curriculum/task.h"
#include "db/access.h"
#include "db/store.h"
#include "ui/web/answers.h"
#include "ui/web/html.h"

namespace placode::web {

inline constexpr int kRowsOfPage = 25;

/// There is no such page, or what it names is not there; in the reader's words.
class NotThere : public std::runtime_error {
 public:
    using std::runtime_error::runtime_error;
};

/// Titles and own pass marks of tasks, each read once. Any thread.
class Tasks {
 public:
    struct Known {
        std::string title;  ///< In the reader's language.
        double pass_points = 0;
        bool shipped = false;  ///< False: an attempt names it, and this program has no such task.
    };
    [[nodiscard]] Known of(const std::string& task_id);
    /// The standard that was set for it, else the task's own mark.
    [[nodiscard]] double pass_points(db::Store& store, const std::string& task_id);

 private:
    struct Shipped {
        curriculum::LocalText title;
        double pass_points = 0;
    };
    std::mutex mutex_;
    std::map<std::string, Shipped> shipped_;
};

class ReviewMaker;

/// Somebody who is signed in asks for a page.
struct Visit {
    db::Store& store;
    Tasks& tasks;
    ReviewMaker& reviews;
    db::UserRecord user;
    std::string now_utc;
    std::vector<std::string> parts;            ///< What stands for `*` in Route::path.
    std::map<std::string, std::string> query;  ///< Decoded.

    /// Empty where it is not given.
    [[nodiscard]] std::string asked(const std::string& key) const;
    /// A whole number from 0, else 0.
    [[nodiscard]] int64_t number(const std::string& key) const;
    /// Throws NotThere for what is no id.
    [[nodiscard]] int64_t id(size_t part = 0) const;
    [[nodiscard]] bool may(db::Action action) const;  ///< What is offered; the store decides.
};

struct PageText {
    Text title;
    Html body;
    int ask_again_s = 0;  ///< The browser asks for it again after so long; 0: it does not.
    bool script = false;  ///< It may run the script of this host.
};

struct Route {
    std::string path;  ///< "/people/*/tasks/*"
    PageText (*page)(const Visit&);
    Answer (*data)(const Visit&) = nullptr;  ///< What is no page; then `page` is null.
};
/// Every page behind the sign-in.
[[nodiscard]] const std::vector<Route>& routes();

// own_page.cpp, person_pages.cpp
[[nodiscard]] PageText own_page(const Visit& visit);
[[nodiscard]] PageText person_page(const Visit& visit);
[[nodiscard]] PageText curve_page(const Visit& visit);
// attempts_pages.cpp, attempt_page.cpp
[[nodiscard]] PageText attempts_page(const Visit& visit);
[[nodiscard]] PageText persons_attempts_page(const Visit& visit);
[[nodiscard]] PageText attempt_page(const Visit& visit);
// review_page.cpp
[[nodiscard]] PageText review_page(const Visit& visit);
[[nodiscard]] Answer review_track(const Visit& visit);
[[nodiscard]] Answer review_part(const Visit& visit);
// cohort_pages.cpp
[[nodiscard]] PageText cohort_page(const Visit& visit);
[[nodiscard]] PageText help_page(const Visit& visit);
[[nodiscard]] PageText refreshers_page(const Visit& visit);
[[nodiscard]] PageText scores_page(const Visit& visit);
// standards_pages.cpp
[[nodiscard]] PageText standards_page(const Visit& visit);
[[nodiscard]] PageText norms_page(const Visit& visit);
[[nodiscard]] PageText norm_pack_page(const Visit& visit);
// study_pages.cpp
[[nodiscard]] PageText studies_page(const Visit& visit);
[[nodiscard]] PageText study_page(const Visit& visit);
[[nodiscard]] PageText entries_page(const Visit& visit);
[[nodiscard]] PageText deviations_page(const Visit& visit);
// people_page.cpp
[[nodiscard]] PageText people_page(const Visit& visit);

}  // namespace placode::web
