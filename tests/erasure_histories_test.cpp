// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Erasure leaves no log-in and no name, whatever was done with a person before: random histories of
// calls of every method of the store, by everybody, then everybody but one administrator is erased
// and every cell is read.

#include <gmock/gmock.h>

#include <QSqlQuery>
#include <QSqlRecord>
#include <algorithm>
#include <functional>
#include <set>

#include "sim/core/random.h"
#include "tests/bars.h"
#include "tests/rights_of_methods.h"
#include "tests/rights_of_studies.h"
#include "tests/rights_of_training.h"

using namespace placode;
using namespace placode::test;

namespace THIS_TEST {

/// A store that was lived in.
struct Life {
    std::function<std::unique_ptr<db::Store>()> open;
    std::function<RawConnection()> raw;
    TemporaryFolder folder;
    RightsWorld world;
    int calls = 0;

    /// One call of any method by somebody, about somebody; what is refused is a part of life.
    void something(sim::SplitMix64& random) {
        static const std::vector<Method> methods = all_methods();
        const auto store = open();
        const std::string actor = RightsWorld::kActors[random.next() % 4].first;
        const Subject whose = kSubjects[random.next() % kSubjects.size()];
        Call call{*store,
                  world,
                  world.subject(actor, whose),
                  world.of.at(actor).person,
                  folder.file("file" + std::to_string(++calls)),
                  folder.file("one.placode")};
        const size_t which = random.next() % methods.size();
        const bool sure = random.next() % 3 != 0;
        // Who writes a name into the trail after the person is gone has it from elsewhere.
        const bool gone = !store->accounts().find(call.subject.person).has_value();
        if (gone && std::string_view(methods[which].name) == "audit.write") return;
        try {
            if (!sure) store->act_for(call.me);
            methods[which].call(call);
        } catch (const std::exception&) {
        }
    }

    /// Table and column of cells that hold one of the words.
    [[nodiscard]] std::set<std::string> cells_with(const std::vector<std::string>& words) const {
        std::set<std::string> found;
        RawConnection connection = raw();
        for (const QString& table : connection.handle().tables()) {
            QSqlQuery rows("SELECT * FROM " + table, connection.handle());
            while (rows.next())
                for (int c = 0; c < rows.record().count(); ++c) {
                    const std::string cell = rows.value(c).toByteArray().toStdString();
                    for (const std::string& word : words)
                        if (cell.find(word) != std::string::npos)
                            found.insert((table + "." + rows.record().fieldName(c)).toStdString() +
                                         ": " + word);
                }
        }
        return found;
    }
};

/// Names and log-ins that mean nothing else. `accounts.create` makes "new", who stays.
std::vector<std::string> words_of(const RightsWorld& world, const std::string& who) {
    std::vector<std::string> words{"Name of " + who};
    // "trainee" and "educator" are names of roles, too.
    if (std::none_of(RightsWorld::kActors.begin(), RightsWorld::kActors.end(),
                     [&](const auto& each) { return who == each.first; }) &&
        world.of.contains(who))
        words.push_back(who);
    return words;
}

/// Erases everybody but one administrator. @return the words that must be nowhere now.
std::vector<std::string> erase_all(Life& life, sim::SplitMix64& random) {
    const auto store = life.open();
    std::vector<std::string> words;
    for (const auto& [login, mine] : life.world.of) {
        if (login == "spare") continue;
        if (store->accounts().find(mine.person))
            store->accounts().erase(mine.person, random.next() % 2 == 0);
        for (const std::string& word : words_of(life.world, login)) words.push_back(word);
    }
    return words;
}

void live_and_erase(Life& life, uint64_t history, Bar& bar) {
    SCOPED_TRACE("history " + std::to_string(history));
    sim::SplitMix64 random(history);
    life.world.fill(*life.open(), life.folder);
    for (int i = 0; i < 150; ++i) life.something(random);
    const std::vector<std::string> words = erase_all(life, random);
    ASSERT_GT(words.size(), 6u);
    const std::set<std::string> left = life.cells_with(words);
    EXPECT_THAT(left, testing::IsEmpty());
    bar.tried(left.empty());
}

class ErasureHistories : public EngineTest {};
INSTANTIATE_TEST_SUITE_P(Engines, ErasureHistories, testing::Values("Sqlite", "Postgresql"),
                         engine_name);

TEST_P(ErasureHistories, LeaveNoNameBehind) {
    Bar bar(is_sqlite() ? "erasures that left a name (SQLite)"
                        : "erasures that left a name (PostgreSQL)");
    // On a server a database of its own for each takes long.
    for (int history = 1; history <= times(is_sqlite() ? 3 : 1, 50); ++history) {
        Life life;
        const std::string path = life.folder.file("placode.db");
        if (is_sqlite()) {
            life.open = [&] { return db::open_store("sqlite:" + path, options); };
            life.raw = [&] { return RawConnection("QSQLITE", path); };
        } else {
            if (history > 1) database = World::get().server().new_store(options);
            life.open = [this] { return open(); };
            life.raw = [this] { return raw(); };
        }
        live_and_erase(life, static_cast<uint64_t>(history), bar);
    }
}

}  // namespace THIS_TEST
