// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Files about people: a list to make accounts from, and everything that is kept about one person.
// The same for shell and command line. Rights are asked before, by whoever calls.

#include <stdexcept>
#include <string>
#include <vector>

#include "db/store.h"

namespace placode::reports {

/// A list of people that cannot be used: file, line, what was found, what is expected.
class PeopleFileError : public std::runtime_error {
 public:
    using std::runtime_error::runtime_error;
};

/// One line of the list.
struct PersonLine {
    db::NewUser user;  ///< Without a password: one is made by make_accounts().
    int64_t group_id = 0;
    int line = 0;  ///< In the file, from 1.
};

/// Roles by name ("trainee;educator"), the sum of their bits. Throws PeopleFileError.
[[nodiscard]] db::Roles roles_of_text(const std::string& text);

/// Reads `login,name[,roles][,group][,password]`. Everything is checked before anything is changed:
/// each line by the rules for an account, logins against each other and the store. Throws
/// PeopleFileError.
[[nodiscard]] std::vector<PersonLine> read_people(db::Store& store, const std::string& csv,
                                                  const std::string& origin);

/// Passwords for those without one; the CSV `login,password` of these ("" when there are none).
[[nodiscard]] std::string make_passwords(std::vector<PersonLine>& people);

/// Keeps them in a new file for its owner alone, on the disk when this returns. Throws
/// db::StoreError, kRefused where something is there: it may be the passwords of an earlier list.
void save_passwords(const std::string& path, const std::string& csv);

/// Makes all accounts, or none, and returns how many; somebody else chose their passwords. Throws
/// PeopleFileError naming the line. @pre everybody has a password.
size_t make_accounts(db::Store& store, const std::vector<PersonLine>& people,
                     const std::string& origin);

struct OwnData {
    int attempts = 0, recordings = 0;
};
/// Everything about a person as FOLDER/my_data.json, with the recordings beside it when wanted;
/// audited. Throws ReportError, StoreError.
OwnData write_own_data(db::Store& store, int64_t user_id, const std::string& folder,
                       bool with_recordings);

}  // namespace placode::reports
